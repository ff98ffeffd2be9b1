# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 8: triggering at 1e3 kPa/min, RD against RI: (A) stress path, (B) shear stress, (C) velocity, (D) inertial
# number.
# Lines: one sample with both schemes; in C the median. Marks: the peak of tau (asterisk) and full liquefaction (circle).
slides = "RD_ramp.dat RI_ramp.dat"; bands = "RD_ramp_over_time.dat RI_ramp_over_time.dat"
tables = slides." ".bands." peaks.dat"
command = "./reproduce fig08"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig08.gp")]
load here."style.gp"

array colour[2] = [vermillion, blue]
array label[2] = ["rate-dependent (RD)", "rate-independent (RI)"]
one(i) = data(word(slides, i))
band(i) = data(word(bands, i))
corner = stated("RD_ramp RI_ramp", "lines: first sample (C: median); bands: lowest to highest of the samples")
marks = data("peaks.dat"); mark_names = names_in("peaks.dat")
# Value of a column for one scheme; NaN elsewhere and in tables of older versions, which lack some columns.
of_slide(i, name) = text_in(mark_names, "slide")."." eq word(slides, i)[1:strlen(word(slides, i)) - 3] ? \
  column(optional(mark_names, name)) : NaN
state(m) = m == 1 ? "" : "liquefied_"
array mark[2] = [3, 6]

do for [format in "png pdf"] {
  eval terminal(format, 14, 13)
  set output picture.".".format
  set multiplot layout 2, 2 margins 0.085, 0.975, 0.085, 0.915 spacing 0.115, 0.14 title corner @in_corner
  unset key

  set title panel("A", "stress path")
  set xlabel "normal stress {/:Italic σ} (kPa)"
  set ylabel "shear stress {/:Italic τ} (kPa)" offset 1
  set xrange [0:30 < *]; set yrange [0:8 < *]   # nothing is cut off
  plot for [i = 1:2] one(i) using (kilo * column("normal_stress")):(kilo * column("shear_stress")) \
         with lines linewidth 1.2 linecolor rgb colour[i] notitle, \
       for [m = 1:2] for [i = 1:2] marks using (kilo * of_slide(i, state(m)."normal_stress")): \
         (kilo * of_slide(i, state(m)."shear_stress")) \
         with points pointtype mark[m] pointsize 1.1 linewidth 1.2 linecolor rgb colour[i] notitle

  set title panel("B", "shear stress")
  set xlabel "time {/:Italic t} (s)"
  set xrange [0:*] noextend
  set label 1 "{/:Italic τ_d}" at first 0.2, first 7.3 right textcolor rgb 0x404040
  eval frame(slides, "set xrange [0:1]")
  plot for [i = 1:2] band(i) using (column("time")):(kilo * column("shear_stress_lowest")): \
         (kilo * column("shear_stress_highest")) with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] one(i) using (column("time")):(kilo * column("shear_stress")) \
         with lines linewidth 1 linecolor rgb colour[i] notitle, \
       one(1) using (column("time")):(kilo * column("driving_stress")) \
         with lines linewidth 1 dashtype 2 linecolor rgb 0x404040 notitle, \
       for [m = 1:2] for [i = 1:2] marks using (of_slide(i, state(m)."time")): \
         (kilo * of_slide(i, state(m)."shear_stress")) \
         with points pointtype mark[m] pointsize 1.1 linewidth 1.2 linecolor rgb colour[i] notitle
  unset label 1

  set title panel("C", "sliding velocity")
  set ylabel "sliding velocity {/:Italic v} (m/s)" offset 1
  set yrange [0:*]
  eval frame(bands, "set yrange [0:1]")
  set key left top Left reverse samplen 2.4
  plot for [i = 1:2] band(i) using (column("time")):(column("velocity_lowest")):(column("velocity_highest")) \
         with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] band(i) using (column("time")):(column("velocity_median")) \
         with lines linewidth 1.2 linecolor rgb colour[i] notitle, \
       for [m = 1:2] for [i = 1:2] marks using (of_slide(i, state(m)."time")):(of_slide(i, state(m)."velocity")) \
         with points pointtype mark[m] pointsize 1.1 linewidth 1.2 linecolor rgb colour[i] notitle, \
       for [i = 1:2] keyentry with lines linewidth 1.2 linecolor rgb colour[i] title label[i], \
       keyentry with points pointtype 3 linecolor rgb black title "peak of {/:Italic τ}", \
       keyentry with points pointtype 6 linecolor rgb black title "full liquefaction"

  set title panel("D", "inertial number")
  set ylabel "inertial number {/:Italic I}" offset 0.5
  set logscale y; set format y "10^{%T}"; set yrange [1e-6:10]
  set key right bottom Right noreverse samplen 3
  plot for [i = 1:2] band(i) using (column("time")):(column("inertial_number_lowest")): \
         (column("inertial_number_highest")) with filledcurves linecolor rgb colour[i] notitle, \
       one(2) using (column("time")):(column("global_inertial_number")) \
         with lines linewidth 1 @dashes linecolor rgb dark(colour[2]) title "RI, at the slope's rate", \
       for [i = 1:2] one(i) using (column("time")):(column("inertial_number")) \
         with lines linewidth 1 linecolor rgb colour[i] title word("RD RI", i).", applied", \
       for [m = 1:2] for [i = 1:2] marks using (of_slide(i, state(m)."time")): \
         (of_slide(i, state(m)."global_inertial_number")) \
         with points pointtype mark[m] pointsize 1.1 linewidth 1.2 linecolor rgb colour[i] notitle
  unset logscale y; set format y "% h"
  unset multiplot
  set output
}
