# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 13: runout at several hydraulic conductivities k: sliding velocity by (A) RD and (B) RI, thin each sample,
# thick their median as far as all of them slide; (C) excess pore pressure, medians of means over 1/25 of the distance;
# (D) largest velocity over k with the range of the samples, and between which k RI begins to feel it (grey).
conductivities = "0 5e-6 1e-5 2e-5 4e-5 1e-4"
labels = "0 5×10^{−6} 10^{−5} 2×10^{−5} 4×10^{−5} 10^{−4}"
tables = "sweep.dat critical.dat"
do for [k in conductivities] {
  tables = tables." RD_".k."_over_displacement.dat RI_".k."_over_displacement.dat"
  tables = tables." RD_".k."_coarse.dat RI_".k."_coarse.dat"
}
command = "./reproduce fig13"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig13.gp")]
load here."style.gp"
load here."slides.gp"

array colour[6] = [black, purple, blue, sky, orange, vermillion]
median(scheme, i) = data(scheme."_".word(conductivities, i)."_over_displacement.dat")
first(scheme, i) = shell_quoted(data(scheme."_".word(conductivities, i)))
replicates(scheme, i) = system("ls ".first(scheme, i).".dat ".first(scheme, i)."_r*.dat 2>/dev/null")
coarse(scheme, i) = data(scheme."_".word(conductivities, i)."_coarse.dat")
v = over_x(velocity, displacement); p = over_x(pore_pressure, displacement)

# sweep.dat: k, then median, lowest and highest of v_max, runout and "has stopped", by RD and by RI; critical.dat: k and
# its bounds.
sweep = data("sweep.dat")
rd_velocity = 2; ri_velocity = 11
stats data("critical.dat") using 2 nooutput
lower = STATS_min
stats data("critical.dat") using 3 nooutput
upper = STATS_max
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
    plot for [i = 1:6] for [file in replicates(scheme, i)] file using (column(displacement)):(column(velocity)) \
           with lines linewidth 0.4 linecolor rgb colour[i] notitle, \
         for [i = 1:6] median(scheme, i) using 1:(column(v)) with lines linewidth 1.8 linecolor rgb colour[i] notitle
  }

  set title panel("C", "pore pressure (RD solid, RI dashed)")
  set ylabel "excess pore pressure {/:Italic p_w} (kPa)"
  set yrange [0:30]
  set key at graph 1.06, 1.02 right top Left reverse title "{/:Italic k} (m/s)" enhanced
  plot for [i = 1:6] coarse("RI", i) using 1:(kilo * column(p)) \
         with lines linewidth 0.9 dashtype 2 linecolor rgb colour[i] notitle, \
       for [i = 1:6] coarse("RD", i) using 1:(kilo * column(p)) \
         with lines linewidth 1.1 linecolor rgb colour[i] notitle, \
       for [i = 1:6] keyentry with lines linewidth 1.8 linecolor rgb colour[i] title word(labels, i)

  set title panel("D", "largest velocity")
  set xlabel "hydraulic conductivity {/:Italic k} (10^{−5} m/s)"
  set ylabel "{/:Italic v}_{max} (m/s)" offset 1
  set xrange [-0.5:10.5]; set yrange [0:3.5]
  set key at graph 1.0, 1.0 right top notitle
  set object 1 rectangle from first tens * lower, graph 0 to first tens * upper, graph 1 \
    fillcolor rgb grey fillstyle solid 0.25 noborder behind
  set arrow 1 from first tens * papers, graph 0 to first tens * papers, graph 1 nohead dashtype 2 linecolor rgb black
  set label 1 "paper's critical {/:Italic k}" at first tens * papers, graph 0.06 offset 0.5, 0
  plot for [s = 1:2] column_of = (s == 1 ? rd_velocity : ri_velocity) \
         sweep using (tens * $1):(column(column_of)):(column(column_of + 1)):(column(column_of + 2)) \
         with yerrorlines linewidth 1.2 pointtype 7 pointsize 0.6 linecolor rgb (s == 1 ? vermillion : blue) \
         title word("RD RI", s)
  unset object 1; unset arrow 1; unset label 1
  unset multiplot
  set output
}
