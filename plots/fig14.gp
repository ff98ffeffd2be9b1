# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 14: runout on samples of four void ratios: sliding velocity by (A) RD and (B) RI, thin each sample, thick their
# median as far as all of them slide; (C) excess pore pressure, medians of means over 1/25 of the distance; (D) largest
# velocity over the void ratio, with the range of the samples.
void_ratios = "790 771 765 751"   # loose to dense
tables = "sweep.dat"
do for [e in void_ratios] {
  tables = tables." RD_e0_".e."_over_displacement.dat RI_e0_".e."_over_displacement.dat"
  tables = tables." RD_e0_".e."_coarse.dat RI_e0_".e."_coarse.dat"
}
command = "./reproduce fig14"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig14.gp")]
load here."style.gp"
load here."slides.gp"

array colour[4] = [vermillion, orange, sky, blue]
median(scheme, i) = data(scheme."_e0_".word(void_ratios, i)."_over_displacement.dat")
first(scheme, i) = shell_quoted(data(scheme."_e0_".word(void_ratios, i)))
replicates(scheme, i) = system("ls ".first(scheme, i).".dat ".first(scheme, i)."_r*.dat 2>/dev/null")
coarse(scheme, i) = data(scheme."_e0_".word(void_ratios, i)."_coarse.dat")
v = over_x(velocity, displacement); p = over_x(pore_pressure, displacement)

# sweep.dat: the paper's void ratio in thousandths, then of the slides by RD and by RI the median, lowest and highest of
# void ratio, bulk void ratio, peak, v_max and runout.
sweep = data("sweep.dat")
sample_void_ratio = 2; rd_velocity = 11; ri_velocity = 26
thousandth = 1e-3

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
    plot for [i = 1:4] for [file in replicates(scheme, i)] file using (column(displacement)):(column(velocity)) \
           with lines linewidth 0.4 linecolor rgb colour[i] notitle, \
         for [i = 1:4] median(scheme, i) using 1:(column(v)) with lines linewidth 1.8 linecolor rgb colour[i] notitle
  }

  set title panel("C", "pore pressure (RD solid, RI dashed)")
  set ylabel "excess pore pressure {/:Italic p_w} (kPa)"
  set yrange [0:30]
  set key at graph 1.06, 1.02 right top Left reverse title "paper's {/:Italic e}_0" enhanced
  plot for [i = 1:4] coarse("RI", i) using 1:(kilo * column(p)) \
         with lines linewidth 0.9 dashtype 2 linecolor rgb colour[i] notitle, \
       for [i = 1:4] coarse("RD", i) using 1:(kilo * column(p)) \
         with lines linewidth 1.1 linecolor rgb colour[i] notitle, \
       for [i = 1:4] keyentry with lines linewidth 1.8 linecolor rgb colour[i] title "0.".word(void_ratios, i)

  set title panel("D", "largest velocity (the paper's {/:Italic e}_0 beside)")
  set xlabel "void ratio {/:Italic e}_0 of the samples"; set xtics 0.02
  set ylabel "{/:Italic v}_{max} (m/s)" offset 1
  set xrange [*:*]; set yrange [0:3.5]
  set offsets graph 0.2, graph 0.08, 0, 0
  set key at graph 0.02, 1.0 left top Left reverse notitle
  plot for [s = 1:2] column_of = (s == 1 ? rd_velocity : ri_velocity) \
         sweep using (column(sample_void_ratio)):(column(column_of)):(column(column_of + 1)):(column(column_of + 2)) \
         with yerrorlines linewidth 1.2 pointtype 7 pointsize 0.6 linecolor rgb (s == 1 ? vermillion : blue) \
         title word("RD RI", s), \
       sweep using (column(sample_void_ratio)):(column(ri_velocity)):(sprintf("%.3f", thousandth * $1)) \
         with labels right offset -0.7, 0.5 notitle
  set offsets; set xtics autofreq
  unset multiplot
  set output
}
