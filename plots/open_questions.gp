# SPDX-License-Identifier: GPL-2.0-or-later
# What the paper left open: glued layers compared with homogeneous shear across periodic faces. (A) Velocity profile,
# (B) largest velocity over the size of the sample, (C) mu(I) of steady shear with its fit, and mu(I) of glass beads.
tables = "hold_glued_profiles_band.dat hold_homogeneous_profiles_band.dat sizes_glued.dat sizes_homogeneous.dat ".\
  "mu_of_I_loose.dat mu_of_I_middle.dat mu_of_I_dense.dat mu_of_I_laws.dat"
command = "./reproduce open_questions"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("open_questions.gp")]
load here."style.gp"

array sample[2] = ["glued", "homogeneous"]
array shown[2] = ["glued layers", "homogeneous"]
array colour[2] = [vermillion, blue]
array mark[2] = [8, 7]
profile(s) = data("hold_".sample[s]."_profiles_band.dat")
profiles = "hold_glued_profiles_band.dat hold_homogeneous_profiles_band.dat"
sizes = "sizes_glued.dat sizes_homogeneous.dat"
array names[2] = [names_in(word(profiles, 1)), names_in(word(profiles, 2))]
velocity(s, of) = optional(names[s], "velocity_3_".of)   # at 30 % strain
states(kind) = data("mu_of_I_".kind.".dat")
named(kind) = sprintf("{/:Italic e} = %.2f", mean_of("mu_of_I_".kind.".dat", "void_ratio"))
corner = stated("hold_glued hold_homogeneous pulse_glued pulse_homogeneous", \
  "bars: lowest to highest of the samples, marks: median; B: other {/:Italic N}, too")
several(least, largest) = column(least) < column(largest)   # no bar for one sample
array kind_mark[3] = [7, 4, 8]; array kind_colour[3] = [blue, orange, purple]

do for [format in "png pdf"] {
  eval terminal(format, 18, 7)
  set output picture.".".format
  set multiplot layout 1, 3 margins 0.065, 0.985, 0.18, 0.84 spacing 0.1 title corner @in_corner

  set title panel("A", "velocity at 30 % shear strain")
  set xlabel "⟨{/:Italic v_x}⟩ / {/:Italic v_{x,}}_{top}"
  set ylabel "relative height {/:Italic z} / {/:Italic H}" offset 1
  set xrange [0:1]; set yrange [0:1]; set format xy "%.1f"
  set key bottom right Left reverse
  set arrow 1 from first 0, 0 to first 1, 1 nohead linewidth 0.8 dashtype 3 linecolor rgb grey
  plot for [s = 1:2] profile(s) using (column(velocity(s, "median"))):(column("relative_height")): \
         (column(velocity(s, "lowest"))):(column(velocity(s, "highest"))) \
         with xerrorbars linewidth 0.6 pointtype mark[s] pointsize 0.4 linecolor rgb colour[s] notitle, \
       for [s = 1:2] profile(s) using (column(velocity(s, "median"))):(column("relative_height")) \
         with linespoints linewidth 1.2 pointtype mark[s] pointsize 0.6 linecolor rgb colour[s] title shown[s]
  unset arrow 1

  set title panel("B", "size of the sample")
  set xlabel "number of grains {/:Italic N}"
  set ylabel "largest velocity {/:Italic v}_{max} (m/s)" offset 0.3
  set logscale x
  set xrange [100:100000]; set yrange [0:*]
  set format x "10^{%T}"; set xtics 10
  set key bottom right Left reverse
  eval frame(sizes, "set yrange [0:1]")
  plot for [s = 1:2] data(word(sizes, s)) using (column("grains")):(several("largest_velocity_lowest", \
         "largest_velocity_highest") ? column("largest_velocity_median") : NaN):(column("largest_velocity_lowest")): \
         (column("largest_velocity_highest")) with yerrorbars linewidth 1.2 pointtype -1 linecolor rgb colour[s] notitle, \
       for [s = 1:2] data(word(sizes, s)) using (column("grains")):(column("largest_velocity_median")) \
         with points linewidth 1.2 pointtype mark[s] pointsize 0.7 linecolor rgb colour[s] title shown[s]

  set title panel("C", "friction of steady shear")
  set xlabel "inertial number {/:Italic I}"
  set ylabel "friction {/:Italic μ} = {/:Italic τ} / {/:Italic σ}" offset 0.3
  set xrange [1e-4:3]; set yrange [0.3:0.7]
  set xtics 1e-4, 10; set format y "%.1f"; set ytics 0.1
  set key top left Left reverse
  laws = data("mu_of_I_laws.dat")
  plot laws using (column("inertial_number")):(column("glass_beads")) \
         with lines linewidth 1.2 @dashes linecolor rgb grey title "glass beads", \
       laws using (column("inertial_number")):(column("fitted")) \
         with lines linewidth 1.2 linecolor rgb black title "fitted", \
       for [k = 1:3] states(word("loose middle dense", k)) using (column("inertial_number")):(column("friction")) \
         with points linewidth 1.2 pointtype kind_mark[k] pointsize 0.7 linecolor rgb kind_colour[k] \
         title named(word("loose middle dense", k))
  unset multiplot
  unset logscale x
  set format xy "% h"
  set xtics autofreq; set ytics autofreq
  set output
}
