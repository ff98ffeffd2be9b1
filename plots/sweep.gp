# SPDX-License-Identifier: GPL-2.0-or-later
# The panels of Figures 13 and 14, which load this file: sliding velocity and excess pore pressure of RD and RI over the
# distance, and the largest velocity over the parameter. They set slide(SCHEME, I), the number of `curves`, `names`,
# `coarse_bands`, `key_title`; of the last panel `axis` (the column), parameter(I), on_axis(0), last_x (range), largest_title
# and mark_critical; and the number of the curve that an inset of A shows in mm, `inset` (0: none); and largest_key, its place.
sweep_names = names_in("sweep.dat")
largest(s, of) = optional(sweep_names, s."_largest_velocity_".of)   # missing in tables of older versions, for short runs
median(scheme, i) = data(slide(scheme, i)."_over_displacement.dat")
coarse(scheme, i) = data(slide(scheme, i)."_coarse.dat")
sweep = data("sweep.dat")
corner = stated(names, "thick: median; thin: each sample; bars: lowest to highest of the samples". \
  (inset > 0 ? "; inset: ".label_of(slide("RD", inset))." alone" : ""))
least = least_of(coarse_bands, "pore_pressure_median")   # below 0: suction
lowest = least < 0 ? 5 * floor(kilo * least / 5) : 0
# No bar for one sample.
several(s, value) = column(largest(s, "lowest")) < column(largest(s, "highest")) ? value : NaN
of_curve(i, x) = abs(column(optional(sweep_names, axis)) - parameter(i)) < 1e-6 * abs(parameter(i)) + 1e-12 ? x : NaN
colour(s, i) = s eq "RD" ? ordered(i, curves) : dark(ordered(i, curves))
mark(s) = s eq "RD" ? 7 : 6
two_tics(which, last) = last > 0 ? sprintf("set %stics (0, '%.3g' %g); set %srange [0:%g]", which, last, last, which, 1.1 * last) : ""
milli = 1e3   # m to mm
inset_tables = ""
if (inset > 0) { do for [s in "RD RI"] { do for [r = 1:replicates(slide(s, inset))] {
  inset_tables = inset_tables." ".replicate(slide(s, inset), r)
} } }
place(left, right, bottom, top) = sprintf("set lmargin at screen %g; set rmargin at screen %g; \
set bmargin at screen %g; set tmargin at screen %g", left, right, bottom, top)

do for [format in "png pdf"] {
  eval terminal(format, 18, 8)
  set output picture.".".format
  set multiplot title corner @in_corner
  set xlabel "sliding distance {/:Italic x} (m)"
  set xrange [0:0.5 < *] noextend

  eval place(0.075, 0.365, 0.16, 0.86)
  set title panel("A", "sliding velocity")
  set ylabel "sliding velocity {/:Italic v} (m/s)" offset 1
  set yrange [0:0.5 < *]
  eval frame(bands, "set xrange [0:1]; set yrange [0:1]")
  set key at screen 0.775, screen 0.9 left top Left reverse title key_title left samplen 2.6
  plot for [i = 1:curves] for [r = 1:replicates(slide("RD", i))] replicate_file(slide("RD", i), r) \
         using (column("displacement")):(column("velocity")) \
         with lines linewidth 0.3 linecolor rgb ordered(i, curves) notitle, \
       for [i = 1:curves] for [r = 1:replicates(slide("RI", i))] replicate_file(slide("RI", i), r) \
         using (column("displacement")):(column("velocity")) with lines linewidth 0.4 @dashes \
         linecolor rgb dark(ordered(i, curves)) notitle, \
       for [i = 1:curves] median("RD", i) using (column("displacement")):(column("velocity_median")) \
         with lines linewidth 2 linecolor rgb ordered(i, curves) notitle, \
       for [i = 1:curves] median("RI", i) using (column("displacement")):(column("velocity_median")) \
         with lines linewidth 1.3 @dashes linecolor rgb dark(ordered(i, curves)) notitle, \
       for [i = 1:curves] keyentry with lines linewidth 2 linecolor rgb ordered(i, curves) \
         title label_of(slide("RD", i)), \
       keyentry with lines linewidth 2 linecolor rgb black title "RD", \
       keyentry with lines linewidth 1.3 @dashes linecolor rgb black title "RI"
  unset key

  if (inset > 0) {
    eval place(0.235, 0.355, 0.245, 0.42)
    set title ""
    set border 15; set tics font ",6" offset 0.3, 0.3
    set xlabel "{/:Italic x} (mm)" font ",6" offset 0, 1; set ylabel "{/:Italic v} (mm/s)" font ",6" offset 2.2
    eval two_tics("x", milli * at_least(largest_of(inset_tables, "displacement"), 0))
    eval two_tics("y", milli * at_least(largest_of(inset_tables, "velocity"), 0))
    eval frame(inset_tables, "set xrange [0:1]; set yrange [0:1]")
    plot for [s in "RD RI"] for [r = 1:replicates(slide(s, inset))] replicate_file(slide(s, inset), r) \
           using (milli * column("displacement")):(milli * column("velocity")) \
           with lines linewidth (s eq "RD" ? 1.2 : 0.8) linecolor rgb colour(s, inset) notitle
    set border 3; set tics font ",8" offset 0, 0; set xtics autofreq; set ytics autofreq
    set xrange [0:0.5 < *] noextend
    eval frame(bands, "set xrange [0:1]")
    set xlabel "sliding distance {/:Italic x} (m)" font ",8" offset 0, 0; set ylabel font ",8" offset 0, 0
  }

  eval place(0.44, 0.74, 0.16, 0.86)
  set title panel("B", "excess pore pressure")
  set ylabel "excess pore pressure {/:Italic p_w} (kPa)" offset 0
  set yrange [lowest:30]
  if (lowest < 0) {
    set arrow 2 from graph 0, first 0 to graph 1, first 0 nohead linewidth 0.6 dashtype 3 linecolor rgb grey
  }
  plot for [i = 1:curves] coarse("RD", i) using (column("displacement")):(kilo * column("pore_pressure_median")) \
         with lines linewidth 1.6 linecolor rgb ordered(i, curves) notitle, \
       for [i = 1:curves] coarse("RI", i) using (column("displacement")):(kilo * column("pore_pressure_median")) \
         with lines linewidth 1.1 @dashes linecolor rgb dark(ordered(i, curves)) notitle
  unset arrow 2

  eval place(0.835, 0.985, 0.16, 0.4)
  set title panel("C", "largest velocity")
  set xlabel largest_title
  set ylabel "{/:Italic v}_{max} (m/s)" offset 1
  set yrange [0:0.5 < *]; set offsets 0, 0, graph 0.1, 0
  eval largest_key
  set key samplen 0.5 notitle
  eval last_x
  eval frame("sweep.dat", "set yrange [0:1]")
  eval mark_critical
  plot for [s in "RD RI"] sweep using (on_axis(0)):(column(largest(s, "median"))) \
         with lines linewidth 0.8 linecolor rgb grey notitle, \
       for [i = 1:curves] for [s in "RD RI"] sweep using (of_curve(i, on_axis(0))): \
         (several(s, column(largest(s, "median")))): \
         (column(largest(s, "lowest"))):(column(largest(s, "highest"))) \
         with yerrorbars linewidth (s eq "RD" ? 2 : 0.8) pointtype -1 linecolor rgb colour(s, i) notitle, \
       for [i = 1:curves] for [s in "RD RI"] sweep using (of_curve(i, on_axis(0))):(column(largest(s, "median"))) \
         with points linewidth 1.4 pointtype mark(s) pointsize 0.8 linecolor rgb colour(s, i) notitle, \
       for [s in "RD RI"] keyentry with points linewidth 1.4 pointtype mark(s) pointsize 0.8 linecolor rgb black title s
  unset object 1; unset arrow 1; set offsets; set xtics autofreq; set format x "% h"
  unset multiplot
  set output
}
