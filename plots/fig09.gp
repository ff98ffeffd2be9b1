# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 9: the liquefied state under a constant driving stress: (A) normal stress, (B) friction tau/sigma. Median and
# range of the replicates. Line in B: mu_ss, the mean beyond 50 % strain, with its standard error over the samples.
bands = "RD_hold_over_shear_strain.dat RI_hold_over_shear_strain.dat"
frictions = "RD_hold_friction_band.dat RI_hold_friction_band.dat"
tables = bands." ".frictions." steady_friction.dat"
command = "./reproduce fig09"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig09.gp")]
load here."style.gp"

schemes = "RD RI"
array colour[2] = [vermillion, blue]
array label[2] = ["rate-dependent (RD)", "rate-independent (RI)"]
band(i) = data(word(bands, i))
mu(i) = data(word(frictions, i))
steady_names = names_in("steady_friction.dat")
steady_from = 50   # %, where the paper sees a steady state
last = 150
corner = stated("RD_hold RI_hold", range_of_samples)
steady(i) = first_where("steady_friction.dat", "friction", "slide", word(schemes, i)."_hold")
steady_error(i) = first_where("steady_friction.dat", "standard_error", "slide", word(schemes, i)."_hold")
steady_label(i) = word(schemes, i).", {/:Italic μ}_{ss} = ".\
  (steady(i) == steady(i) ? sprintf("%.3f ± %.3f", steady(i), steady_error(i)) : "not reached")

do for [format in "png pdf"] {
  eval terminal(format, 14, 7)
  set output picture.".".format
  set multiplot layout 1, 2 margins 0.085, 0.975, 0.18, 0.84 spacing 0.115 title corner @in_corner
  set xlabel "shear strain {/:Italic γ} (%)"

  set title panel("A", "normal stress")
  set ylabel "normal stress {/:Italic σ} (kPa)" offset 1
  set xrange [0:*] noextend
  eval frame(bands, "set xrange [0:100]")
  set logscale y; set format y "10^{%T}"; set yrange [1e-4:1000]
  set key right top Left reverse noopaque
  plot for [i = 1:2] band(i) using (percent * column("shear_strain")):(kilo * column("normal_stress_lowest")): \
         (kilo * column("normal_stress_highest")) with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] band(i) using (percent * column("shear_strain")):(kilo * column("normal_stress_median")) \
         with lines linewidth 1.2 linecolor rgb colour[i] title label[i]
  unset logscale y; set format y "% h"

  set title panel("B", "friction")
  set ylabel "friction {/:Italic τ}/{/:Italic σ}"
  set xrange [0:*] noextend
  eval frame(frictions, "set xrange [0:100]")
  set yrange [0:0.8]
  set arrow 1 from first steady_from, graph 0 to first steady_from, graph 1 \
    nohead linewidth 0.8 dashtype 3 linecolor rgb grey
  set key right bottom Right noreverse opaque
  plot for [i = 1:2] mu(i) using (percent * column("shear_strain")):(column("friction_lowest")): \
         (column("friction_highest")) with filledcurves linecolor rgb colour[i] notitle, \
       for [i = 1:2] mu(i) using (percent * column("shear_strain")):(column("friction_median")) \
         with lines linewidth 0.8 linecolor rgb colour[i] notitle, \
       for [i = 1:2] data("steady_friction.dat") \
         using (text_in(steady_names, "slide") eq word(schemes, i)."_hold" ? steady_from : NaN):(column("friction")): \
         (last - steady_from):(0) with vectors nohead linewidth 2 linecolor rgb colour[i] \
         title steady_label(i)
  unset arrow 1
  unset multiplot
  set output
}
