# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 3: constant-volume simple shear of four packings: (A) stress path, (B) stress-strain, (C) inertial number.
points = "e0_790 e0_771 e0_765 e0_751"   # loose to dense
tables = "e0_790.dat e0_771.dat e0_765.dat e0_751.dat legend.txt"
command = "./reproduce fig03"
script = ARG0; folder = ARG1; picture = ARG2; beside = ARG3
here = script[1:strlen(script) - strlen("fig03.gp")]
load here."style.gp"

array colour[4] = [vermillion, orange, sky, blue]
table(i) = data(word(points, i).".dat")
other_table(i) = other(word(points, i).".dat")
# Replicates from the second on are thin. Without them the loop still runs once and plots the first again, unseen.
thin(i, r) = r > replicates(word(points, i)) ? table(i) : replicate_file(word(points, i), r)
threshold = 1e-3   # of the inertial number: a flow is quasi-static well below it

do for [format in "png pdf"] {
  eval terminal(format, 18, 6.2)
  set output picture.".".format
  set multiplot
  set bmargin at screen 0.19
  set tmargin at screen 0.90

  set lmargin at screen 0.06; set rmargin at screen 0.30
  set title panel("A", "stress path")
  set xlabel "normal stress {/:Italic σ} (kPa)"
  set ylabel "shear stress {/:Italic τ} (kPa)" offset 1
  set xrange [0:30]; set yrange [0:*]   # the range of the paper: a sample that regains more strength leaves the frame
  set offsets 0, 0, graph 0.1, 0        # room for the key
  set key at graph 0, 1.02 left top Left reverse
  plot for [i = 1:4] table(i) using (kilo * column("normal_stress")):(kilo * column("shear_stress")) \
    with lines linewidth 1.2 linecolor rgb colour[i] title label_of(word(points, i)), \
    for [i = 1:4] for [r = 2:replicates(word(points, i))] thin(i, r) \
    using (kilo * column("normal_stress")):(kilo * column("shear_stress")) \
    with lines linewidth 0.3 linecolor rgb colour[i] notitle, \
    for [i = 1:4] other_table(i) using (kilo * column("normal_stress")):(if_others * kilo * column("shear_stress")) \
    with lines linewidth 0.8 dashtype 2 linecolor rgb colour[i] title i == 1 ? other_label : ""

  set lmargin at screen 0.39; set rmargin at screen 0.63
  set title panel("B", "stress-strain response")
  set xlabel "shear strain {/:Italic γ} (%)"
  set xrange [0:*] noextend; set xtics 10
  set offsets 0, 0, graph 0.75, 0       # room for the inset
  unset key
  plot for [i = 1:4] table(i) using (percent * column("shear_strain")):(kilo * column("shear_stress")) \
    with lines linewidth 1.2 linecolor rgb colour[i] notitle, \
    for [i = 1:4] for [r = 2:replicates(word(points, i))] thin(i, r) \
    using (percent * column("shear_strain")):(kilo * column("shear_stress")) \
    with lines linewidth 0.3 linecolor rgb colour[i] notitle, \
    for [i = 1:4] other_table(i) using (percent * column("shear_strain")):(if_others * kilo * column("shear_stress")) \
    with lines linewidth 0.8 dashtype 2 linecolor rgb colour[i] notitle

  set lmargin at screen 0.745; set rmargin at screen 0.985
  set offsets
  set title panel("C", "inertial number")
  set ylabel "inertial number {/:Italic I}" offset 0.5
  set logscale y; set format y "10^{%T}"; set yrange [5e-5:*]
  set arrow 1 from graph 0, first threshold to graph 1, first threshold nohead linewidth 1 dashtype 2 linecolor rgb black
  set label 1 "10^{−3}" at graph 1, first threshold offset -0.3, 0.5 right
  plot for [i = 1:4] table(i) using (percent * column("shear_strain")):(column("inertial_number")) \
    with lines linewidth 1.2 linecolor rgb colour[i] notitle
  unset arrow 1; unset label 1; unset logscale y; set format y "% h"

  # The inset of B: below 1 kPa, at large strain, where the weakest samples begin to regain strength.
  set lmargin at screen 0.455; set rmargin at screen 0.62
  set bmargin at screen 0.66; set tmargin at screen 0.89
  unset title; unset xlabel; unset ylabel
  set border 15
  set xrange [20:*] noextend; set yrange [0:1]; set ytics 0.5
  set tics font ",6.5" offset 0.4, 0.2
  plot for [i = 1:3] table(i) using (percent * column("shear_strain")):(kilo * column("shear_stress")) \
    with lines linewidth 1 linecolor rgb colour[i] notitle
  set border 3; set tics font ",8" offset 0, 0; set xtics autofreq; set ytics autofreq

  unset multiplot
  set output
}
