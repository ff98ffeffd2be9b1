# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 11: runout after a pulse of 3 kPa, RD against RI: (A) velocity, (B) excess pore pressure, with the stress path
# of the first sample up to 10 % strain as an inset.
bands = "RD_3kPa_over_displacement.dat RI_3kPa_over_displacement.dat"
wide_bands = "RD_3kPa_windows.dat RI_3kPa_windows.dat"
slides = "RD_3kPa.dat RI_3kPa.dat"
tables = bands." ".wide_bands." ".slides
command = "./reproduce fig11"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig11.gp")]
load here."style.gp"

array colour[2] = [vermillion, blue]
array label[2] = ["rate-dependent (RD)", "rate-independent (RI)"]
band(i) = data(word(bands, i))
wide(i) = data(word(wide_bands, i))
one(i) = data(word(slides, i))
corner = stated("RD_3kPa RI_3kPa", range_of_samples."; inset: first sample")
least = least_of(wide_bands, "pore_pressure_lowest")   # below 0: suction
lowest = least < 0 ? 5 * floor(kilo * least / 5) : 0
farthest = largest_of(bands." ".wide_bands, "displacement"); far = in_milli(farthest)
fastest = largest_of(bands, "velocity_highest"); fast = in_milli(fastest)

do for [format in "png pdf"] {
  eval terminal(format, 15, 7.6)
  set output picture.".".format
  set multiplot layout 1, 2 margins (fast == 1 ? 0.08 : 0.105), 0.98, 0.165, 0.855 spacing 0.11 title corner @in_corner
  set xlabel sprintf("sliding distance {/:Italic x} (%s)", milli_unit(farthest, "m"))
  if (far != 1 && farthest > 0) { set xtics few_tics(far * farthest) }
  set xrange [0:*] noextend

  set title panel("A", "sliding velocity")
  set ylabel sprintf("sliding velocity {/:Italic v} (%s)", milli_unit(fastest, "m/s")) offset 1
  set yrange [0:*]
  set offsets 0, 0, graph 0.2, 0   # room for the key
  set key left top Left reverse
  eval frame(bands, "set xrange [0:1]; set yrange [0:1]")
  plot for [i = 1:2] band(i) using (far * column("displacement")):(fast * column("velocity_lowest")): \
         (fast * column("velocity_highest")) with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] band(i) using (far * column("displacement")):(fast * column("velocity_median")) \
         with lines linewidth 1.4 linecolor rgb colour[i] title label[i]

  set offsets
  set title panel("B", "excess pore pressure")
  set ylabel "excess pore pressure {/:Italic p_w} (kPa)" offset 0
  step = lowest < -10 ? 10 : 5
  # The upper half is that of the inset.
  set yrange [lowest:lowest + (30 - lowest) * 62.0 / 30]; set ytics step * ceil(lowest / (1.0 * step)), step, 30
  unset key
  plot for [i = 1:2] wide(i) using (far * column("displacement")):(kilo * column("pore_pressure_lowest")): \
         (kilo * column("pore_pressure_highest")) with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] wide(i) using (far * column("displacement")):(kilo * column("pore_pressure_median")) \
         with lines linewidth 1.4 linecolor rgb colour[i] notitle

  set lmargin at screen 0.68; set rmargin at screen 0.97
  set bmargin at screen 0.62; set tmargin at screen 0.84
  set title ""
  set border 15; set tics font ",6" offset 0.3, 0.3; set ytics 2; set xtics 10
  set xlabel "{/:Italic σ} (kPa)" font ",6" offset 0, 1.4; set ylabel "{/:Italic τ} (kPa)" font ",6" offset 2.2
  set xrange [0:30]; set yrange [0:6]
  plot for [i = 1:2] one(i) using (column("shear_strain") < 0.1 ? kilo * column("normal_stress") : NaN): \
    (kilo * column("shear_stress")) with lines linewidth 1.2 linecolor rgb colour[i] notitle
  set border 3; set tics font ",8" offset 0, 0; set xtics autofreq; set ytics autofreq
  set xlabel font ",8" offset 0, 0; set ylabel font ",8" offset 0, 0
  unset lmargin; unset rmargin; unset bmargin; unset tmargin
  unset multiplot
  set output
}
