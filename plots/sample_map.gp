# SPDX-License-Identifier: GPL-2.0-or-later
# Void ratio and strength of samples by their recipe. (A) Void ratio away from the planes over the friction of stages
# 1 to 3, with one line per drag (without drag: per restitution). (B) Peak shear stress of the same samples in
# undrained shear over that void ratio; line: tau_0 + 3 kPa, the stress that the pulse of Figs. 11 to 14 reaches. (C)
# The same over the coordination number.
tables = "curves.dat"
command = "scripts/sample_map"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("sample_map.gp")]
load here."style.gp"
peak = optional(names_in("curves.dat"), "peak_shear_stress")   # a sample that only dilates has no peak
by_drag = words(values_of("curves.dat", "preparation_drag")) > 1
second = by_drag ? "preparation_drag" : "preparation_restitution"
lines = values_of("curves.dat", second)
lines_are = by_drag ? "drag {/:Italic c} (kg/s)" : "restitution"
set datafile missing NaN
of(line, x) = column(second) == line ? x : NaN
map = data("curves.dat")
pulse = 5.65  # kPa
corner = stated("", "one point a recipe")

do for [format in "png pdf"] {
  eval terminal(format, 21, 7.8)
  set output picture.".".format
  set multiplot layout 1, 3 margins 0.065, 0.985, 0.165, 0.83 spacing 0.085 title corner @in_corner

  set title panel("A", "void ratio of the inner part")
  set xlabel "friction of the preparation {/:Italic μ}_1"
  set ylabel "void ratio {/:Italic e}"
  set xtics 0.2
  set format y "%.2f"
  set key bottom right reverse Left title lines_are
  plot for [i = 1:words(lines)] map using (of(word(lines, i), column("preparation_friction"))): \
         (column("initial_probe_void_ratio")) \
         with linespoints pointtype 7 pointsize 0.5 linewidth 1.2 linecolor rgb ordered((i - 1) % 6 + 1, words(lines) > 6 ? 6 : words(lines)) title word(lines, i)

  unset key
  set xtics 0.04
  set format x "%.2f"
  set format y "%g"
  set ylabel "peak of {/:Italic τ} (kPa)"
  set yrange [0:20]
  set arrow 1 from graph 0, first pulse to graph 1, first pulse nohead dashtype 2 linecolor rgb grey
  set label 1 "pulse of 3 kPa" at graph 0.02, first pulse left offset 0, -0.7
  set title panel("B", "strength over void ratio")
  set xlabel "void ratio {/:Italic e}"
  plot for [i = 1:words(lines)] map using (of(word(lines, i), column("initial_probe_void_ratio"))):(kilo * column(peak)) \
         with points pointtype 7 pointsize 0.6 linecolor rgb ordered((i - 1) % 6 + 1, words(lines) > 6 ? 6 : words(lines))
  set title panel("C", "strength over contacts")
  set xlabel "coordination number without rattlers"
  set xtics 0.4
  set format x "%.1f"
  set label 1 "pulse of 3 kPa" at graph 0.98, first pulse right offset 0, -0.7
  plot for [i = 1:words(lines)] map using (of(word(lines, i), column("mechanical_coordination_number"))): \
         (kilo * column(peak)) with points pointtype 7 pointsize 0.6 linecolor rgb ordered((i - 1) % 6 + 1, words(lines) > 6 ? 6 : words(lines))
  unset label 1; unset arrow 1
  set yrange [*:*]
  set format x "%g"
  unset multiplot
  set output
}
