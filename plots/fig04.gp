# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 4: two loading rates, and two stress formulas on each: Bagi's (eq. 12, lines), Nicot's (eq. 13, marks).
points = "I_1e-4 I_2e-2"
tables = "I_1e-4.dat I_2e-2.dat legend.txt"
command = "./reproduce fig04"
script = ARG0; folder = ARG1; picture = ARG2; beside = ARG3
here = script[1:strlen(script) - strlen("fig04.gp")]
load here."style.gp"

array colour[2] = [blue, vermillion]
array mark[2] = [6, 4]
table(i) = data(word(points, i).".dat")
other_table(i) = other(word(points, i).".dat")
corner = stated(points, "curves: first sample")
# About thirty marks per curve, so that the line below stays visible.
array step[2]
do for [i = 1:2] {
  records = rows(word(points, i).".dat")
  step[i] = records < 30 ? 1 : int(records / 30)
}

do for [format in "png pdf"] {
  eval terminal(format, 14, 7)
  set output picture.".".format
  set multiplot layout 1, 2 margins 0.085, 0.975, 0.18, 0.84 spacing 0.11 title corner @in_corner

  set title panel("A", "stress path")
  set xlabel "normal stress {/:Italic σ} (kPa)"
  set ylabel "shear stress {/:Italic τ} (kPa)" offset 1
  set xrange [0:30 < *]; set yrange [0:*]
  set offsets 0, 0, graph 0.4, 0   # room for the key
  set key at graph 0.02, 1.02 left top Left reverse
  plot for [i = 1:2] table(i) using (kilo * column("bagi_normal_stress")):(kilo * column("bagi_shear_stress")) \
         with lines linewidth 1.4 linecolor rgb colour[i] title label_of(word(points, i)).", Bagi", \
       for [i = 1:2] other_table(i) using (kilo * column("bagi_normal_stress")): \
         (if_others * kilo * column("bagi_shear_stress")) with lines linewidth 0.8 dashtype 2 linecolor rgb colour[i] title i == 1 ? other_label : "", \
       for [i = 1:2] table(i) every step[i] using (kilo * column("nicot_normal_stress")): \
         (kilo * column("nicot_shear_stress")) with points pointtype mark[i] pointsize 0.6 linecolor rgb black title label_of(word(points, i)).", Nicot"

  set title panel("B", "stress-strain response")
  set xlabel "shear strain {/:Italic γ} (%)"
  set xrange [0:*] noextend
  set offsets 0, 0, graph 0.05, 0
  unset key
  plot for [i = 1:2] table(i) using (percent * column("shear_strain")):(kilo * column("bagi_shear_stress")) \
         with lines linewidth 1.4 linecolor rgb colour[i] notitle, \
       for [i = 1:2] other_table(i) using (percent * column("shear_strain")): \
         (if_others * kilo * column("bagi_shear_stress")) with lines linewidth 0.8 dashtype 2 linecolor rgb colour[i] notitle, \
       for [i = 1:2] table(i) every step[i] using (percent * column("shear_strain")): \
         (kilo * column("nicot_shear_stress")) with points pointtype mark[i] pointsize 0.6 linecolor rgb black notitle

  set offsets
  unset multiplot
  set output
}
