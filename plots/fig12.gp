# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 12: pulses of three amplitudes, RD (solid) and RI (dashed) with the bands of their replicates: (A) velocity,
# (B) excess pore pressure.
amplitudes = "3 4 5"
tables = ""
do for [a in amplitudes] {
  do for [s in "RD RI"] { tables = tables." ".s."_".a."kPa_over_displacement.dat ".s."_".a."kPa_windows.dat" }
}
command = "./reproduce fig12"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig12.gp")]
load here."style.gp"
load here."slides.gp"

array colour[3] = [sky, purple, vermillion]
table(scheme, i) = data(scheme."_".word(amplitudes, i)."kPa_over_displacement.dat")
wide(scheme, i) = data(scheme."_".word(amplitudes, i)."kPa_windows.dat")
v = over_x(velocity, displacement); p = over_x(pore_pressure, displacement)

do for [format in "png pdf"] {
  eval terminal(format, 14, 6.6)
  set output picture.".".format
  set multiplot layout 1, 2
  set xlabel "sliding distance {/:Italic x} (m)"
  set xrange [0:*] noextend

  set title panel("A", "sliding velocity")
  set ylabel "sliding velocity {/:Italic v} (m/s)" offset 1
  set yrange [0:*]
  set key left top Left reverse
  plot for [s in "RI RD"] for [i = 1:3] table(s, i) using 1:(column(v + 1)):(column(v + 2)) \
         with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:3] table("RI", i) using 1:(column(v)) \
         with lines linewidth 1.2 dashtype 2 linecolor rgb colour[i] notitle, \
       for [i = 1:3] table("RD", i) using 1:(column(v)) with lines linewidth 1.4 linecolor rgb colour[i] \
         title "{/:Italic A} = ".word(amplitudes, i)." kPa", \
       keyentry with lines linewidth 1.2 linecolor rgb black title "RD", \
       keyentry with lines linewidth 1.2 dashtype 2 linecolor rgb black title "RI"

  set title panel("B", "excess pore pressure")
  set ylabel "excess pore pressure {/:Italic p_w} (kPa)"
  set yrange [0:30]
  unset key
  plot for [s in "RI RD"] for [i = 1:3] wide(s, i) using 1:(kilo * column(p + 1)):(kilo * column(p + 2)) \
         with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:3] wide("RI", i) using 1:(kilo * column(p)) \
         with lines linewidth 1.2 dashtype 2 linecolor rgb colour[i] notitle, \
       for [i = 1:3] wide("RD", i) using 1:(kilo * column(p)) with lines linewidth 1.4 linecolor rgb colour[i] notitle
  unset multiplot
  set output
}
