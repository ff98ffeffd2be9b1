# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 12: pulses of three amplitudes, RD (solid) and RI (dashed) with the bands of their replicates: (A) velocity,
# (B) excess pore pressure.
amplitudes = "3 4 5"
slide(scheme, i) = scheme."_".word(amplitudes, i)."kPa"
bands = ""; wide_bands = ""
do for [i = 1:3] {
  do for [s in "RD RI"] {
    bands = bands." ".slide(s, i)."_over_displacement.dat"
    wide_bands = wide_bands." ".slide(s, i)."_windows.dat"
  }
}
tables = "legend.txt".bands.wide_bands
command = "./reproduce fig12"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig12.gp")]
load here."style.gp"

array colour[3] = [sky, purple, vermillion]
table(scheme, i) = data(slide(scheme, i)."_over_displacement.dat")
wide(scheme, i) = data(slide(scheme, i)."_windows.dat")

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
  eval frame(bands, "set xrange [0:1]; set yrange [0:1]")
  plot for [s in "RI RD"] for [i = 1:3] table(s, i) using (column("displacement")):(column("velocity_lowest")): \
         (column("velocity_highest")) with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:3] table("RI", i) using (column("displacement")):(column("velocity_median")) \
         with lines linewidth 1.2 dashtype 2 linecolor rgb colour[i] notitle, \
       for [i = 1:3] table("RD", i) using (column("displacement")):(column("velocity_median")) \
         with lines linewidth 1.4 linecolor rgb colour[i] title label_of(slide("RD", i)), \
       keyentry with lines linewidth 1.2 linecolor rgb black title "RD", \
       keyentry with lines linewidth 1.2 dashtype 2 linecolor rgb black title "RI"

  set title panel("B", "excess pore pressure")
  set ylabel "excess pore pressure {/:Italic p_w} (kPa)"
  set yrange [0:30]
  unset key
  plot for [s in "RI RD"] for [i = 1:3] wide(s, i) \
         using (column("displacement")):(kilo * column("pore_pressure_lowest")): \
         (kilo * column("pore_pressure_highest")) with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:3] wide("RI", i) using (column("displacement")):(kilo * column("pore_pressure_median")) \
         with lines linewidth 1.2 dashtype 2 linecolor rgb colour[i] notitle, \
       for [i = 1:3] wide("RD", i) using (column("displacement")):(kilo * column("pore_pressure_median")) \
         with lines linewidth 1.4 linecolor rgb colour[i] notitle
  unset multiplot
  set output
}
