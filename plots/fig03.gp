# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 3: constant-volume simple shear of four packings: (A) stress path, (B) stress-strain, (C) inertial number.
points = "e0_0.790 e0_0.771 e0_0.765 e0_0.751"
tables = "e0_0.790.dat e0_0.771.dat e0_0.765.dat e0_0.751.dat legend.dat"
command = "./reproduce fig03"
script = ARG0; folder = ARG1; picture = ARG2
load script[1:strlen(script) - strlen("fig03.gp")]."style.gp"

array colour[4] = [vermillion, orange, sky, blue]   # loose to dense
table(i) = data(word(points, i).".dat")
threshold = 1e-3   # above it a flow is no longer quasi-static

do for [format in "png pdf"] {
  eval terminal(format, 18, 6.4)
  set output picture.".".format
  set multiplot

  set origin 0, 0; set size 0.335, 1
  set title panel("A", "stress path")
  set xlabel "normal stress {/:Italic σ} (kPa)"
  set ylabel "shear stress {/:Italic τ} (kPa)" offset 1
  set xrange [0:30]; set yrange [0:*]
  set key top left Left reverse
  plot for [i = 1:4] table(i) using (kilo * column(column_normal)):(kilo * column(column_shear)) \
    with lines linewidth 1.2 linecolor rgb colour[i] title label_of(word(points, i))

  set origin 0.335, 0
  set title panel("B", "stress-strain response")
  set xlabel "shear strain {/:Italic γ} (%)"
  set xrange [0:*]
  unset key
  plot for [i = 1:4] table(i) using (percent * column(column_strain)):(kilo * column(column_shear)) \
    with lines linewidth 1.2 linecolor rgb colour[i] notitle
  largest_strain = GPVAL_X_MAX

  set origin 0.67, 0; set size 0.33, 1
  set title panel("C", "inertial number")
  set ylabel "inertial number {/:Italic I}" offset 0.5
  set logscale y; set format y "10^{%T}"; set yrange [*:*]
  set arrow 1 from graph 0, first threshold to graph 1, first threshold nohead linewidth 1 dashtype 2 linecolor rgb black
  set label 1 "quasi-static below 10^{−3}" at graph 0.98, first threshold offset 0, -0.7 right
  plot for [i = 1:4] table(i) using (percent * column(column_strain)):(column(column_inertial)) \
    with lines linewidth 1.2 linecolor rgb colour[i] notitle
  unset arrow 1; unset label 1; unset logscale y; set format y "% h"

  # The inset of B: what the low-strength samples regain at large strain.
  set origin 0.435, 0.50; set size 0.235, 0.44
  unset title; unset xlabel; unset ylabel
  set border 15
  set xrange [20:largest_strain]; set yrange [0:1]; set ytics 0.5; set xtics 10
  set object 1 rectangle from graph -0.2, -0.25 to graph 1.03, 1.08 behind fillcolor rgb "white" fillstyle solid noborder
  plot for [i = 1:4] table(i) using (percent * column(column_strain)):(kilo * column(column_shear)) \
    with lines linewidth 1.2 linecolor rgb colour[i] notitle
  unset object 1; set border 3; set xtics auto; set ytics auto

  unset multiplot
  set output
}
