# SPDX-License-Identifier: GPL-2.0-or-later
# The panels of Figures 6 and 7; fig06.gp and fig07.gp load this file. Columns: two inertial numbers. Rows: stress path,
# stress-strain response and velocity; below, with several rules, the error over dt_G. Colours: dt_G. `ways` lists the
# rules that pass strain: the first is shown as lines with every dt_G, the second as dashes and the third as marks, both
# with the largest and the smallest dt_G. `way_label` has their labels.
steps = "1e-3 1e-4 1e-5 1e-6"
level(c) = c == 1 ? "low" : "high"
way(w) = word(ways, w)
ways_drawn = words(ways)
# The curves of a panel: for each the number of its rule and the number of its dt_G.
curves = "1 1 1 2 1 3 1 4"
do for [w = 2:ways_drawn] { curves = curves.sprintf(" %d 1 %d 4", w, w) }
curves_drawn = words(curves)/2
w_of(k) = int(word(curves, 2*k - 1))
i_of(k) = int(word(curves, 2*k))
slide_name(c, w, i) = way(w)."_".level(c)."_".word(steps, i)
file(c, k) = slide_name(c, w_of(k), i_of(k)).".dat"
slides = ""; names = "DEM_low DEM_high"
do for [c = 1:2] { do for [k = 1:curves_drawn] {
  slides = slides." ".file(c, k)
  names = names." ".slide_name(c, w_of(k), i_of(k))
} }
alone_tables = "DEM_low.dat DEM_high.dat"; spread_tables = "DEM_low_over_shear_strain.dat DEM_high_over_shear_strain.dat"
tables = alone_tables." ".spread_tables." legend.txt".slides
load here."style.gp"

number(c) = c == 1 ? "10^{−4}" : "10^{−2}"
slide(c, k) = data(file(c, k))
alone(c) = data(word(alone_tables, c))
spread(c) = data(word(spread_tables, c))
array letters[6] = ["A", "B", "C", "D", "E", "F"]
title(row, c, what) = panel(letters[2*row + c - 2], what.", {/:Italic I} = ".number(c))
corner = stated(names, "curves: first sample; band: lowest to highest of the samples of pure DEM")
# A style for each rule. Thin lines lie on thick ones, dark dashes and marks on both.
# Macros, because gnuplot runs through an empty range once.
dashed_curves = ways_drawn == 1 ? "" : ", for [k = 5:6] slide(c, k) using (x(c)):(y(c)) ".\
  "with lines linewidth 1.2 @dashes linecolor rgb colour(k) notitle"
marked_curves = ways_drawn < 3 ? "" : ", for [k = 7:8] slide(c, k) every marks_apart(c, k) using (x(c)):(y(c)) ".\
  "with points pointtype mark[i_of(k)] pointsize 0.5 linecolor rgb colour(k) notitle"
dashed_key = ways_drawn == 1 ? "" : ", keyentry with lines linewidth 1.2 @dashes linecolor rgb black ".\
  "title way_label[2]"
marked_keys = ways_drawn < 3 ? "" : ", for [i = 1:2] keyentry with points pointtype mark[3*i - 2] pointsize 0.5 ".\
  "linecolor rgb black title way_label[3].(i == 1 ? ', largest' : ', smallest').' {/:Italic Δt_G}'"
array mark[4] = [6, 0, 0, 2]   # by dt_G
colour(k) = w_of(k) == 1 ? ordered(i_of(k), 4) : dark(ordered(i_of(k), 4))
width(k) = 2.6 - 0.5 * i_of(k)
marks_apart(c, k) = rows(file(c, k)) < 40 ? 1 : int(rows(file(c, k)) / 20)
# Tables of older versions have no errors.
has_errors = ways_drawn > 1 && readable(path("errors.dat"))
rows_drawn = has_errors ? 4 : 3
panel_height = 5.1; key_height = 2.6; head_height = 0.9   # cm
height = head_height + rows_drawn * panel_height + (has_errors ? 0 : key_height)
of_height(cm) = cm / height
row_top(row) = 1 - of_height(head_height + (row - 1) * panel_height + 0.5)
row_bottom(row) = 1 - of_height(head_height + row * panel_height - 1.25)
place(row, c) = sprintf("set lmargin at screen %g; set rmargin at screen %g; \
set bmargin at screen %g; set tmargin at screen %g", \
  c == 1 ? 0.105 : 0.61, c == 1 ? 0.475 : 0.975, row_bottom(row), row_top(row))
in_errors(w) = strcol("passing") eq way(w) ? column("error") : NaN

do for [format in "png pdf"] {
  eval terminal(format, 14, height)
  set output picture.".".format
  set multiplot title corner @in_corner
  unset key

  do for [row = 1:3] { do for [c = 1:2] {
    eval place(row, c)
    if (row == 1) {
      set title title(1, c, "stress path")
      set xrange [0:32]; set yrange [0:9]
      set xlabel "normal stress {/:Italic σ} (kPa)"
      set ylabel "shear stress {/:Italic τ} (kPa)" offset 1
      x(c) = kilo * column("normal_stress")
      y(c) = kilo * column("shear_stress")
    }
    if (row == 2) {
      set title title(2, c, "stress-strain response")
      set xrange [0:(c == 1 ? 2 : 5)]; set yrange [0:9]
      set xlabel "shear strain {/:Italic γ} (%)"
      x(c) = percent * column("shear_strain")
    }
    if (row == 3) {
      set title title(3, c, "sliding velocity")
      set xrange [0:0.1]; set yrange [0:0.25]; set ytics 0.05
      set xlabel "time {/:Italic t} (s)"
      set ylabel "sliding velocity {/:Italic v} (m/s)" offset 1
      x(c) = column("time")
      y(c) = column("velocity")
    }
    plot spread(c) using (row == 2 ? percent * column("shear_strain") : NaN):(kilo * column("shear_stress_lowest")): \
           (kilo * column("shear_stress_highest")) with filledcurves linecolor rgb grey notitle, \
         alone(c) using (row < 3 ? x(c) : NaN):(kilo * column("shear_stress")) \
           with lines linewidth 4 linecolor rgb 0xB0B0B0 notitle, \
         for [k = 1:4] slide(c, k) using (x(c)):(y(c)) \
           with lines linewidth width(k) linecolor rgb colour(k) notitle @dashed_curves @marked_curves
  } }
  set ytics autofreq

  if (has_errors) {
    eval place(4, 1)
    set title panel("G", "error of {/:Italic τ}, {/:Italic I} = 10^{−2}")
    set xlabel "{/:Italic Δt_G} (s)"; set ylabel "error against pure DEM" offset 1
    set logscale xy; set format xy "10^{%T}"
    set xrange [5e-7:2e-3]; set yrange [1e-4:20]
    set key right top Right noreverse samplen 3
    plot data("errors.dat") using (column("time_step")):(column("spread")) \
           with lines linewidth 4 linecolor rgb 0xB0B0B0 notitle, \
         for [w = 1:ways_drawn] data("errors.dat") using (column("time_step")):(in_errors(w)) \
           with linespoints linewidth 1.2 dashtype w pointtype (w == 1 ? 7 : w == 2 ? 4 : 6) \
           pointsize 0.7 linecolor rgb (w == 1 ? blue : w == 2 ? vermillion : black) title way_label[w]
    unset key; unset logscale; set format xy "% h"
  }

  # The key: beside the errors, or below the panels.
  set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0; set tmargin at screen 1
  set title ""; unset xlabel; unset ylabel; unset border; unset tics
  set xrange [0:1]; set yrange [0:1]
  set key at screen (has_errors ? 0.53 : 0.04), (has_errors ? row_top(4) : of_height(key_height - 0.1)) left top Left reverse \
    samplen 3 width 2 maxrows (has_errors ? 20 : 5)
  plot 2 notitle, \
       for [i = 1:4] keyentry with lines linewidth width(i) linecolor rgb ordered(i, 4) \
         title "{/:Italic Δt_G} = ".label_of(slide_name(1, 1, i))." s", \
       keyentry with lines linewidth 4 linecolor rgb 0xB0B0B0 \
         title has_errors ? "pure DEM; G: spread of its samples" : "pure DEM", \
       keyentry with filledcurves linecolor rgb grey title "pure DEM, all samples", \
       keyentry with lines linewidth 1.8 linecolor rgb black title way_label[1] @dashed_key @marked_keys
  set border 3; set tics nomirror out scale 0.6; unset key; set xtics autofreq; set ytics autofreq
  unset multiplot
  set output
}
