# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 8: triggering at 1e3 kPa/min, RD against RI: (A) stress path, (B) shear stress, (C) velocity, (D) inertial
# number.
# Lines are one sample by both schemes; bands are all replicates.
tables = "RD_ramp.dat RI_ramp.dat RD_ramp_over_time.dat RI_ramp_over_time.dat"
command = "./reproduce fig08"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig08.gp")]
load here."style.gp"
load here."slides.gp"

schemes = "RD RI"
array colour[2] = [vermillion, blue]
array label[2] = ["rate-dependent (RD)", "rate-independent (RI)"]
one(i) = data(word(schemes, i)."_ramp.dat")
band(i) = data(word(schemes, i)."_ramp_over_time.dat")

# The marks of the paper: the peak of tau, and where sigma is lowest.
array peak_time[2]; array peak_shear[2]; array peak_normal[2]
do for [i = 1:2] {
  stats one(i) using (column(shear_strain) < 0.05 ? column(shear_stress) : NaN) nooutput
  largest = STATS_max
  stats one(i) using (column(shear_stress) == largest ? column(time) : NaN) nooutput
  peak_time[i] = STATS_min; peak_shear[i] = largest
  stats one(i) using (column(shear_stress) == largest ? column(normal_stress) : NaN) nooutput
  peak_normal[i] = STATS_min
}

do for [format in "png pdf"] {
  eval terminal(format, 14, 12.4)
  set output picture.".".format
  set multiplot layout 2, 2
  set key left top Left reverse

  set title panel("A", "stress path")
  set xlabel "normal stress {/:Italic σ} (kPa)"
  set ylabel "shear stress {/:Italic τ} (kPa)" offset 1
  set xrange [0:30]; set yrange [0:6]
  plot for [i = 1:2] one(i) using (kilo * column(normal_stress)):(kilo * column(shear_stress)) \
         with lines linewidth 1.2 linecolor rgb colour[i] title label[i], \
       for [i = 1:2] "+" using (kilo * peak_normal[i]):(kilo * peak_shear[i]) every 1000 \
         with points pointtype 3 linecolor rgb colour[i] notitle
  unset key

  set title panel("B", "shear stress")
  set xlabel "time {/:Italic t} (s)"
  set xrange [0:*] noextend
  plot for [i = 1:2] band(i) using 1:(kilo * column(over_time(shear_stress) + 1)): \
         (kilo * column(over_time(shear_stress) + 2)) with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] one(i) using (column(time)):(kilo * column(shear_stress)) \
         with lines linewidth 1 linecolor rgb colour[i] notitle, \
       one(1) using (column(time)):(kilo * column(driving_stress)) \
         with lines linewidth 1 dashtype 2 linecolor rgb grey notitle, \
       for [i = 1:2] "+" using (peak_time[i]):(kilo * peak_shear[i]) every 1000 \
         with points pointtype 3 linecolor rgb colour[i] notitle
  
  set title panel("C", "sliding velocity")
  set ylabel "sliding velocity {/:Italic v} (m/s)" offset 1
  set yrange [0:*]
  plot for [i = 1:2] band(i) using 1:(column(over_time(velocity) + 1)):(column(over_time(velocity) + 2)) \
         with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] band(i) using 1:(column(over_time(velocity))) \
         with lines linewidth 1.2 linecolor rgb colour[i] notitle

  set title panel("D", "inertial number")
  set ylabel "inertial number {/:Italic I}" offset 0.5
  set logscale y; set format y "10^{%T}"; set yrange [1e-6:10]
  plot for [i = 1:2] band(i) using 1:(column(over_time(inertial_number) + 1)): \
         (column(over_time(inertial_number) + 2)) with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] one(i) using (column(time)):(column(inertial_number)) \
         with lines linewidth 1 linecolor rgb colour[i] notitle, \
       one(2) using (column(time)):(column(global_inertial_number)) \
         with lines linewidth 1 dashtype 2 linecolor rgb colour[2] notitle
  unset logscale y; set format y "% h"
  unset multiplot
  set output
}
