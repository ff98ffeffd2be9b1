# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 14: runout on samples of four void ratios. (A) Sliding velocity with RD and (B) with RI; thin: each sample;
# thick: the median, up to the displacement that all samples reach. (C) Excess pore pressure: medians of means over 1/25
# of the distance. (D) Largest velocity over the void ratio, with the range of the samples.
void_ratios = "790 771 765 751"   # loose to dense
slide(scheme, i) = scheme."_e0_".word(void_ratios, i)
slides = ""; bands = ""; coarse_bands = ""
do for [i = 1:4] {
  do for [s in "RD RI"] {
    slides = slides." ".slide(s, i).".dat"
    bands = bands." ".slide(s, i)."_over_displacement.dat"
    coarse_bands = coarse_bands." ".slide(s, i)."_coarse.dat"
  }
}
tables = "sweep.dat legend.txt".slides.bands.coarse_bands
command = "./reproduce fig14"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig14.gp")]
load here."style.gp"
names = names_in("sweep.dat")
largest(s, of) = optional(names, s."_largest_velocity_".of)   # missing if the runs are too short
void_ratio = "RD_initial_void_ratio_median"

# gnuplot 5.4 crashes if all labels of a plot are undefined. A missing column therefore gets a value outside the frame.
or_outside(name) = name eq "" ? -1 : column(name)
paper_text(name) = name eq "" ? "" : sprintf("%.3f", column(name))

array colour[4] = [vermillion, orange, sky, blue]
median(scheme, i) = data(slide(scheme, i)."_over_displacement.dat")
coarse(scheme, i) = data(slide(scheme, i)."_coarse.dat")
sweep = data("sweep.dat")

do for [format in "png pdf"] {
  eval terminal(format, 14, 12.4)
  set output picture.".".format
  set multiplot layout 2, 2
  set xlabel "sliding distance {/:Italic x} (m)"
  set xrange [0:4.5]
  unset key
  set ylabel "sliding velocity {/:Italic v} (m/s)" offset 1
  set yrange [0:3.5]
  do for [s = 1:2] {
    scheme = word("RD RI", s)
    set title panel(word("A B", s), s == 1 ? "rate-dependent (RD)" : "rate-independent (RI)")
    plot for [i = 1:4] for [r = 1:replicates(slide(scheme, i))] replicate_file(slide(scheme, i), r) \
           using (column("displacement")):(column("velocity")) with lines linewidth 0.4 linecolor rgb colour[i] notitle, \
         for [i = 1:4] median(scheme, i) using (column("displacement")):(column("velocity_median")) \
           with lines linewidth 1.8 linecolor rgb colour[i] notitle
  }

  set title panel("C", "pore pressure (RD solid, RI dashed)")
  set ylabel "excess pore pressure {/:Italic p_w} (kPa)"
  set yrange [0:30]
  set key at graph 1.06, 1.02 right top Left reverse title "paper's {/:Italic e}_0" enhanced
  plot for [i = 1:4] coarse("RI", i) using (column("displacement")):(kilo * column("pore_pressure_median")) \
         with lines linewidth 0.9 dashtype 2 linecolor rgb colour[i] notitle, \
       for [i = 1:4] coarse("RD", i) using (column("displacement")):(kilo * column("pore_pressure_median")) \
         with lines linewidth 1.1 linecolor rgb colour[i] notitle, \
       for [i = 1:4] keyentry with lines linewidth 1.8 linecolor rgb colour[i] title label_of(slide("RD", i))

  set title panel("D", "largest velocity (the paper's {/:Italic e}_0 beside)")
  set xlabel "void ratio {/:Italic e}_0 of the samples"; set xtics 0.02
  set ylabel "{/:Italic v}_{max} (m/s)" offset 1
  set xrange [*:*]; set yrange [0:3.5]
  set offsets graph 0.2, graph 0.08, 0, 0
  set key at graph 0.02, 1.0 left top Left reverse notitle
  # Without values, or with one void ratio only (a closed-form sample), there is no range.
  one = first_of("sweep.dat", void_ratio); mean = mean_of("sweep.dat", void_ratio)
  if (largest("RD", "median") eq "" || one != one || abs(one - mean) < 1e-6) {
    set xrange [(one == one ? one - 0.05 : 0.7):(one == one ? one + 0.05 : 0.9)]
  }
  plot for [s in "RD RI"] sweep using (column(optional(names, void_ratio))):(column(largest(s, "median"))): \
         (column(largest(s, "lowest"))):(column(largest(s, "highest"))) \
         with yerrorlines linewidth 1.2 pointtype 7 pointsize 0.6 linecolor rgb (s eq "RD" ? vermillion : blue) \
         title s, \
       sweep using (or_outside(optional(names, void_ratio))):(or_outside(largest("RI", "median"))): \
         (paper_text(optional(names, "paper_void_ratio"))) with labels right offset -0.7, 0.5 notitle
  set offsets; set xtics autofreq
  unset multiplot
  set output
}
