# SPDX-License-Identifier: GPL-2.0-or-later
# Time steps beyond the limit of stability, without any check of the time step. (A) Peak of the shear stress over that
# of a refined run, one mark per sample. (B) The same over dt_L as a fraction of the limit given by the contact
# stiffness.
tables = "time_step_details.dat"
command = "./reproduce hard"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("hard.gp")]
load here."style.gp"

scan = data("time_step_details.dat")

do for [format in "png pdf"] {
  eval terminal(format, 14, 6.2)
  set output picture.".".format
  set multiplot layout 1, 2
  unset key
  set ylabel "peak of {/Symbol t} over that of a refined run" offset 1
  set yrange [0:1.15]
  set title panel("A", "by the Rayleigh time (line: refused beyond)")
  set xlabel "{/:Italic dt_L} over the Rayleigh time"
  set xrange [0:2.05]
  set arrow 1 from 0.65, graph 0 to 0.65, graph 1 nohead linecolor rgb grey
  plot scan using (column("rayleigh_share")):(column("peak_ratio")) \
         with points pointtype 7 pointsize 0.5 linecolor rgb blue
  set title panel("B", "by the contacts (line: stopped beyond)")
  set xlabel "share of the edge of stability"
  set arrow 1 from 1, graph 0 to 1, graph 1 nohead linecolor rgb grey
  plot scan using (column("edge_share")):(column("peak_ratio")) \
         with points pointtype 7 pointsize 0.5 linecolor rgb vermillion
  unset multiplot
  set output
}
