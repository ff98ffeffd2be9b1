# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 11: runout after a pulse of 3 kPa, RD against RI: (A) velocity, (B) excess pore pressure and, inset, stress path.
tables = "RD_3kPa_over_displacement.dat RI_3kPa_over_displacement.dat RD_3kPa.dat RI_3kPa.dat"
command = "./reproduce fig11"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig11.gp")]
load here."style.gp"
load here."slides.gp"

schemes = "RD RI"
array colour[2] = [vermillion, blue]
array label[2] = ["rate-dependent (RD)", "rate-independent (RI)"]
band(i) = data(word(schemes, i)."_3kPa_over_displacement.dat")
one(i) = data(word(schemes, i)."_3kPa.dat")
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
  plot for [i = 1:2] band(i) using 1:(column(v + 1)):(column(v + 2)) with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] band(i) using 1:(column(v)) with lines linewidth 1.4 linecolor rgb colour[i] title label[i]

  set title panel("B", "excess pore pressure")
  set ylabel "excess pore pressure {/:Italic p_w} (kPa)"
  set yrange [0:30]
  unset key
  plot for [i = 1:2] band(i) using 1:(kilo * column(p + 1)):(kilo * column(p + 2)) \
         with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] band(i) using 1:(kilo * column(p)) with lines linewidth 1.4 linecolor rgb colour[i] notitle

  # The inset: the first replicate up to liquefaction.
  set origin 0.655, 0.24; set size 0.30, 0.42
  set border 15; unset title; unset xrange; unset yrange
  set xlabel "{/:Italic σ} (kPa)" offset 0, 0.9; set ylabel "{/:Italic τ} (kPa)" offset 2.4
  set tics font ",6.5"; set xlabel font ",7"; set ylabel font ",7"
  set xrange [0:30]; set yrange [0:6]; set xtics 10 offset 0, 0.3; set ytics 2 offset 0.5
  plot for [i = 1:2] one(i) using (column(shear_strain) < 0.1 ? kilo * column(normal_stress) : NaN):\
    (kilo * column(shear_stress)) with lines linewidth 0.8 linecolor rgb colour[i] notitle
  set border 3; set tics font ",8"; set xlabel font ",8" offset 0, 0; set ylabel font ",8" offset 0
  set xtics autofreq offset 0, 0; set ytics autofreq offset 0
  set size 1, 1; set origin 0, 0
  unset multiplot
  set output
}
