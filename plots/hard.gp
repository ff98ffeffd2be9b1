# SPDX-License-Identifier: GPL-2.0-or-later
# Time steps beyond the limit of stability, without any check of the time step. (A) Peak of the shear stress over that
# of a refined run, one mark per sample. (B) The same over dt_L as a fraction of the limit given by the contact
# stiffness.
tables = "time_step_details.dat"
command = "./reproduce hard"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("hard.gp")]
load here."style.gp"

scan = data("time_step_details.dat"); scan_names = names_in("time_step_details.dat")
# Number of grains and of samples; tables of older versions lack the first.
grains = optional(scan_names, "grains") eq "" ? "{/:Italic N} not recorded" : \
  sprintf("{/:Italic N} = %d grains", first_of("time_step_details.dat", "grains"))
corner = changed.asked("scale", "", tables).grains. \
  sprintf(", %d samples; one mark for each sample and time step", words(values_of(tables, "sample")))

do for [format in "png pdf"] {
  eval terminal(format, 14, 7)
  set output picture.".".format
  set multiplot layout 1, 2 margins 0.09, 0.98, 0.18, 0.84 spacing 0.12 title corner @in_corner
  unset key
  set ylabel "peak of {/:Italic τ} / that of a refined run" offset 1
  set yrange [0:1.15]; set format xy "%.1f"
  set title panel("A", "line: refused beyond")
  set xlabel "{/:Italic Δt_L} / Rayleigh time"
  set xrange [0:2.05]
  set arrow 1 from 0.65, graph 0 to 0.65, graph 1 nohead linecolor rgb grey
  plot scan using (column("rayleigh_share")):(column("peak_ratio")) \
         with points pointtype 7 pointsize 0.5 linecolor rgb blue
  set title panel("B", "line: stopped beyond")
  set xlabel "{/:Italic Δt_L} / limit (logarithmic beyond 2)"
  set nonlinear x via bent(x, 2.0) inverse straight(x, 2.0)
  set xrange [0:at_least(1.1 * largest_of("time_step_details.dat", "edge_share"), 2.05)]
  set xtics (0, 0.5, 1, 1.5, 2, 5, 10, 20, 50)
  set arrow 1 from 1, graph 0 to 1, graph 1 nohead linecolor rgb grey
  plot scan using (column("edge_share")):(column("peak_ratio")) \
         with points pointtype 7 pointsize 0.5 linecolor rgb vermillion
  set format xy "% h"; unset nonlinear x; set xtics autofreq
  unset multiplot
  set output
}
