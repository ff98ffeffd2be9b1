# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 8: triggering at 1e3 kPa/min, RD against RI: (A) stress path, (B) shear stress, (C) velocity, (D) inertial
# number.
# Lines: one sample with both schemes. Bands: all replicates. Marks: the peak of tau.
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
peaks = data("peaks.dat"); peak_names = names_in("peaks.dat")
of_slide(i, value) = text_in(peak_names, "slide")."." eq word(slides, i)[1:strlen(word(slides, i)) - 3] ? value : NaN

do for [format in "png pdf"] {
  eval terminal(format, 14, 12.4)
  set output picture.".".format
  set multiplot layout 2, 2
  set key left top Left reverse

  set title panel("A", "stress path")
  set xlabel "normal stress {/:Italic σ} (kPa)"
  set ylabel "shear stress {/:Italic τ} (kPa)" offset 1
  set xrange [0:30]; set yrange [0:6]
  plot for [i = 1:2] one(i) using (kilo * column("normal_stress")):(kilo * column("shear_stress")) \
         with lines linewidth 1.2 linecolor rgb colour[i] title label[i], \
       for [i = 1:2] peaks using (kilo * column("normal_stress")):(of_slide(i, kilo * column("shear_stress"))) \
         with points pointtype 3 linecolor rgb colour[i] notitle
  unset key

  set title panel("B", "shear stress")
  set xlabel "time {/:Italic t} (s)"
  set xrange [0:*] noextend
  eval frame(slides, "set xrange [0:1]")
  plot for [i = 1:2] band(i) using (column("time")):(kilo * column("shear_stress_lowest")): \
         (kilo * column("shear_stress_highest")) with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] one(i) using (column("time")):(kilo * column("shear_stress")) \
         with lines linewidth 1 linecolor rgb colour[i] notitle, \
       one(1) using (column("time")):(kilo * column("driving_stress")) \
         with lines linewidth 1 dashtype 2 linecolor rgb grey notitle, \
       for [i = 1:2] peaks using (column("time")):(of_slide(i, kilo * column("shear_stress"))) \
         with points pointtype 3 linecolor rgb colour[i] notitle

  set title panel("C", "sliding velocity")
  set ylabel "sliding velocity {/:Italic v} (m/s)" offset 1
  set yrange [0:*]
  eval frame(bands, "set yrange [0:1]")
  plot for [i = 1:2] band(i) using (column("time")):(column("velocity_lowest")):(column("velocity_highest")) \
         with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] band(i) using (column("time")):(column("velocity_median")) \
         with lines linewidth 1.2 linecolor rgb colour[i] notitle

  set title panel("D", "inertial number")
  set ylabel "inertial number {/:Italic I}" offset 0.5
  set logscale y; set format y "10^{%T}"; set yrange [1e-6:10]
  plot for [i = 1:2] band(i) using (column("time")):(column("inertial_number_lowest")): \
         (column("inertial_number_highest")) with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] one(i) using (column("time")):(column("inertial_number")) \
         with lines linewidth 1 linecolor rgb colour[i] notitle, \
       one(2) using (column("time")):(column("global_inertial_number")) \
         with lines linewidth 1 dashtype 2 linecolor rgb colour[2] notitle
  unset logscale y; set format y "% h"
  unset multiplot
  set output
}
