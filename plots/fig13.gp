# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 13: runout at several hydraulic conductivities k. (A) Sliding velocity with RD and (B) with RI; thin: each
# sample; thick: the median, up to the displacement that all samples reach. (C) Excess pore pressure: medians of means
# over 1/25 of the distance. (D) Largest velocity over k, with the range of the samples; grey: the interval of k in
# which drainage begins to slow RI.
conductivities = "0 5e-6 1e-5 2e-5 4e-5 1e-4"
slide(scheme, i) = scheme."_".word(conductivities, i)
slides = ""; bands = ""; coarse_bands = ""
do for [i = 1:6] {
  do for [s in "RD RI"] {
    slides = slides." ".slide(s, i).".dat"
    bands = bands." ".slide(s, i)."_over_displacement.dat"
    coarse_bands = coarse_bands." ".slide(s, i)."_coarse.dat"
  }
}
tables = "sweep.dat critical.dat legend.txt".slides.bands.coarse_bands
command = "./reproduce fig13"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig13.gp")]
load here."style.gp"
names = names_in("sweep.dat")
largest(s, of) = optional(names, s."_largest_velocity_".of)   # missing if the runs are too short

array colour[6] = [black, purple, blue, sky, orange, vermillion]
median(scheme, i) = data(slide(scheme, i)."_over_displacement.dat")
coarse(scheme, i) = data(slide(scheme, i)."_coarse.dat")
sweep = data("sweep.dat")
lower = first_of("critical.dat", "lower"); upper = first_of("critical.dat", "upper")
papers = 4e-5                # m/s, the critical k of the paper
tens = 1e5                   # m/s to 1e-5 m/s

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
    plot for [i = 1:6] for [r = 1:replicates(slide(scheme, i))] replicate_file(slide(scheme, i), r) \
           using (column("displacement")):(column("velocity")) with lines linewidth 0.4 linecolor rgb colour[i] notitle, \
         for [i = 1:6] median(scheme, i) using (column("displacement")):(column("velocity_median")) \
           with lines linewidth 1.8 linecolor rgb colour[i] notitle
  }

  set title panel("C", "pore pressure (RD solid, RI dashed)")
  set ylabel "excess pore pressure {/:Italic p_w} (kPa)"
  set yrange [0:30]
  set key at graph 1.06, 1.02 right top Left reverse title "{/:Italic k} (m/s)" enhanced
  plot for [i = 1:6] coarse("RI", i) using (column("displacement")):(kilo * column("pore_pressure_median")) \
         with lines linewidth 0.9 dashtype 2 linecolor rgb colour[i] notitle, \
       for [i = 1:6] coarse("RD", i) using (column("displacement")):(kilo * column("pore_pressure_median")) \
         with lines linewidth 1.1 linecolor rgb colour[i] notitle, \
       for [i = 1:6] keyentry with lines linewidth 1.8 linecolor rgb colour[i] title label_of(slide("RD", i))

  set title panel("D", "largest velocity")
  set xlabel "hydraulic conductivity {/:Italic k} (10^{−5} m/s)"
  set ylabel "{/:Italic v}_{max} (m/s)" offset 1
  set xrange [-0.5:10.5]; set yrange [0:3.5]
  set key at graph 1.0, 1.0 right top notitle
  if (lower == lower) {   # false for NaN: there is no critical k
    set object 1 rectangle from first tens * lower, graph 0 to first tens * upper, graph 1 \
      fillcolor rgb grey fillstyle solid 0.25 noborder behind
  }
  set arrow 1 from first tens * papers, graph 0 to first tens * papers, graph 1 nohead dashtype 2 linecolor rgb black
  set label 1 "paper's critical {/:Italic k}" at first tens * papers, graph 0.06 offset 0.5, 0
  plot for [s in "RD RI"] sweep using (tens * column("hydraulic_conductivity")):(column(largest(s, "median"))): \
         (column(largest(s, "lowest"))):(column(largest(s, "highest"))) \
         with yerrorlines linewidth 1.2 pointtype 7 pointsize 0.6 linecolor rgb (s eq "RD" ? vermillion : blue) title s
  unset object 1; unset arrow 1; unset label 1
  unset multiplot
  set output
}
