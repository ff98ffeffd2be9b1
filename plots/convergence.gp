# SPDX-License-Identifier: GPL-2.0-or-later
# The panels of Figures 6 and 7; fig06.gp and fig07.gp load this file. Columns: two inertial numbers. Rows: stress path,
# stress-strain response and velocity. Colours: dt_G. `ways` lists the rules that pass strain, each followed by its dash
# type. The first rule is shown with every dt_G, the others with the largest and the smallest. `way_label` has their
# labels.
steps = "1e-3 1e-4 1e-5 1e-6"
level(c) = c == 1 ? "low" : "high"
way(w) = word(ways, 2*w - 1)
dash(w) = int(word(ways, 2*w))
ways_drawn = words(ways)/2
# The curves of a panel: for each the number of its rule and the number of its dt_G.
curves = "1 1 1 2 1 3 1 4"
do for [w = 2:ways_drawn] { curves = curves.sprintf(" %d 1 %d 4", w, w) }
curves_drawn = words(curves)/2
w_of(k) = int(word(curves, 2*k - 1))
i_of(k) = int(word(curves, 2*k))
slide_name(c, w, i) = way(w)."_".level(c)."_".word(steps, i)
file(c, k) = slide_name(c, w_of(k), i_of(k)).".dat"
slides = ""
do for [c = 1:2] { do for [k = 1:curves_drawn] { slides = slides." ".file(c, k) } }
alone_tables = "DEM_low.dat DEM_high.dat"; spread_tables = "DEM_low_over_shear_strain.dat DEM_high_over_shear_strain.dat"
tables = alone_tables." ".spread_tables." legend.txt".slides
load here."style.gp"

array colour[4] = [orange, green, blue, purple]
number(c) = c == 1 ? "10^{−4}" : "10^{−2}"
slide(c, k) = data(file(c, k))
alone(c) = data(word(alone_tables, c))
spread(c) = data(word(spread_tables, c))
array letters[6] = ["A", "B", "C", "D", "E", "F"]
title(row, c, what) = panel(letters[2*row + c - 2], what.", {/:Italic I} = ".number(c))

do for [format in "png pdf"] {
  eval terminal(format, 14, 17.5)
  set output picture.".".format
  set multiplot layout 3, 2

  set xrange [0:32]; set yrange [0:9]
  set xlabel "normal stress {/:Italic σ} (kPa)"
  set ylabel "shear stress {/:Italic τ} (kPa)" offset 1
  do for [c = 1:2] {
    set title title(1, c, "stress path")
    if (c == 1) { set key left top Left reverse } else { unset key }
    plot for [k = 1:curves_drawn] slide(c, k) \
           using (kilo * column("normal_stress")):(kilo * column("shear_stress")) \
           with lines linewidth 1.2 dashtype dash(w_of(k)) linecolor rgb colour[i_of(k)] notitle, \
         alone(c) using (kilo * column("normal_stress")):(kilo * column("shear_stress")) \
           with lines linewidth 1.2 dashtype 2 linecolor rgb black title "pure DEM", \
         for [i = 1:4] keyentry with lines linewidth 1.2 linecolor rgb colour[i] \
           title "{/:Italic Δt_G} = ".label_of(slide_name(1, 1, i))." s"
  }

  set xlabel "shear strain {/:Italic γ} (%)"
  do for [c = 1:2] {
    set title title(2, c, "stress-strain response")
    set xrange [0:(c == 1 ? 2 : 5)]
    if (c == 1) { set key right top noreverse Right } else { unset key }
    plot spread(c) using (percent * column("shear_strain")):(kilo * column("shear_stress_lowest")): \
           (kilo * column("shear_stress_highest")) \
           with filledcurves linecolor rgb grey title "pure DEM, all samples", \
         for [k = 1:curves_drawn] slide(c, k) \
           using (percent * column("shear_strain")):(kilo * column("shear_stress")) \
           with lines linewidth 1.2 dashtype dash(w_of(k)) linecolor rgb colour[i_of(k)] notitle, \
         alone(c) using (percent * column("shear_strain")):(kilo * column("shear_stress")) \
           with lines linewidth 1.2 dashtype 2 linecolor rgb black notitle, \
         for [w = 1:ways_drawn] keyentry with lines linewidth 1.2 dashtype dash(w) linecolor rgb black title way_label[w]
  }
  unset key

  set xlabel "time {/:Italic t} (s)"
  set ylabel "sliding velocity {/:Italic v} (m/s)" offset 1
  set xrange [0:0.1]; set yrange [0:0.25]; set ytics 0.05
  do for [c = 1:2] {
    set title title(3, c, "sliding velocity")
    plot for [k = 1:curves_drawn] slide(c, k) using (column("time")):(column("velocity")) \
           with lines linewidth 1.2 dashtype dash(w_of(k)) linecolor rgb colour[i_of(k)] notitle
  }
  set ytics autofreq
  unset multiplot
  set output
}
