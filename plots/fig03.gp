# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 3: constant-volume simple shear of four packings: (A) stress path, (B) stress-strain, (C) inertial number.
# The axes of A are linear up to 30 and 15 kPa and logarithmic beyond, because dense samples regain hundreds of kPa.
points = "e0_790 e0_771 e0_765 e0_751"   # loose to dense
tables = "e0_790.dat e0_771.dat e0_765.dat e0_751.dat legend.txt"
command = "./reproduce fig03"
script = ARG0; folder = ARG1; picture = ARG2; beside = ARG3
here = script[1:strlen(script) - strlen("fig03.gp")]
load here."style.gp"

table(i) = data(word(points, i).".dat")
other_table(i) = other(word(points, i).".dat")
# Replicates from the second on are thin. Without them the loop still runs once and plots the first again, unseen.
thin(i, r) = r > replicates(word(points, i)) ? table(i) : replicate_file(word(points, i), r)
threshold = 1e-3   # of the inertial number: a flow is quasi-static well below it
corner = stated(points, "thick: first sample, thin: the others")

bend_x = 30.0; bend_y = 15.0   # kPa, see bent()
all = ""
do for [i = 1:4] { do for [r = 1:replicates(word(points, i))] { all = all." ".replicate(word(points, i), r) } }
last_x = 1.1 * at_least(kilo * largest_of(all, "normal_stress"), bend_x)
last_y = 1.1 * at_least(kilo * largest_of(all, "shear_stress"), bend_y)
least = 1e-3   # kPa, of B; smaller stresses leave the frame
seen(stress) = at_least(stress, 0.1 * least)

do for [format in "png pdf"] {
  eval terminal(format, 18, 7)
  set output picture.".".format
  set multiplot layout 1, 3 margins 0.055, 0.985, 0.18, 0.84 spacing 0.085 title corner @in_corner

  set title panel("A", "stress path")
  set xlabel "normal stress {/:Italic σ} (kPa)"
  set ylabel "shear stress {/:Italic τ} (kPa)" offset 1
  set nonlinear x via bent(x, bend_x) inverse straight(x, bend_x)
  set nonlinear y via bent(y, bend_y) inverse straight(y, bend_y)
  set xrange [0:last_x]; set yrange [0:last_y]
  set xtics (0, 10, 20, 30, 100, 300, 1000, 3000); set ytics (0, 5, 10, 15, 50, 150, 500, 1500)
  set arrow 1 from bend_x, graph 0 to bend_x, graph 1 nohead linewidth 0.6 dashtype 3 linecolor rgb grey
  set arrow 2 from graph 0, first bend_y to graph 1, first bend_y nohead linewidth 0.6 dashtype 3 linecolor rgb grey
  set key at graph 0.02, 1.02 left top Left reverse title "{/:Italic e}_0 (paper's)" left
  plot for [i = 1:4] for [r = 2:replicates(word(points, i))] thin(i, r) \
    using (kilo * column("normal_stress")):(kilo * column("shear_stress")) \
    with lines linewidth 0.3 linecolor rgb ordered(i, 4) notitle, \
    for [i = 4:1:-1] table(i) using (kilo * column("normal_stress")):(kilo * column("shear_stress")) \
    with lines linewidth 1.3 linecolor rgb ordered(i, 4) notitle, \
    for [i = 1:4] keyentry with lines linewidth 1.3 linecolor rgb ordered(i, 4) title label_of(word(points, i)), \
    for [i = 1:4] other_table(i) using (kilo * column("normal_stress")):(if_others * kilo * column("shear_stress")) \
    with lines linewidth 0.8 dashtype 2 linecolor rgb ordered(i, 4) title i == 1 ? other_label : ""
  unset nonlinear x; unset nonlinear y; unset arrow 1; unset arrow 2
  set xtics autofreq; set ytics autofreq

  set title panel("B", "stress-strain response")
  set xlabel "shear strain {/:Italic γ} (%)"
  set xrange [0:*] noextend; set xtics 10
  set logscale y; set format y "10^{%T}"; set yrange [least:last_y]
  unset key
  eval frame(all, "set xrange [0:50]")
  plot for [i = 1:4] for [r = 2:replicates(word(points, i))] thin(i, r) \
    using (percent * column("shear_strain")):(seen(kilo * column("shear_stress"))) \
    with lines linewidth 0.3 linecolor rgb ordered(i, 4) notitle, \
    for [i = 1:4] table(i) using (percent * column("shear_strain")):(seen(kilo * column("shear_stress"))) \
    with lines linewidth 1.3 linecolor rgb ordered(i, 4) notitle, \
    for [i = 1:4] other_table(i) using (percent * column("shear_strain")): \
    (if_others * seen(kilo * column("shear_stress"))) \
    with lines linewidth 0.8 dashtype 2 linecolor rgb ordered(i, 4) notitle

  set title panel("C", "inertial number")
  set ylabel "inertial number {/:Italic I}" offset 0.5
  set yrange [1e-5:1]
  set arrow 1 from graph 0, first threshold to graph 1, first threshold nohead linewidth 0.8 dashtype 2 linecolor rgb black
  plot for [i = 1:4] table(i) using (percent * column("shear_strain")):(column("inertial_number")) \
    with lines linewidth 1.3 linecolor rgb ordered(i, 4) notitle
  unset arrow 1; unset logscale y; set format y "% h"; set xtics autofreq

  unset multiplot
  set output
}
