# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 10: profiles over the height of the sample by RD, before and after liquefaction, median and range of the
# replicates: (A) velocity, (B) shear stress, (C) normal stress.
tables = "RD_ramp_profiles_band.dat legend.dat"
command = "./reproduce fig10"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig10.gp")]
load here."style.gp"

table = data("RD_ramp_profiles_band.dat")
profiles = 5
array colour[profiles] = [black, blue, sky, orange, vermillion]
array mark[profiles] = [7, 6, 4, 8, 10]
# Behind the height, per profile: velocity, shear stress, normal stress, each as median, lowest, highest.
quantity(i, q) = 2 + 9 * (i - 1) + 3 * (q - 1)

do for [format in "png pdf"] {
  eval terminal(format, 18, 6.6)
  set output picture.".".format
  set multiplot layout 1, 3
  set ylabel "relative height {/:Italic z}/{/:Italic H}" offset 1
  set yrange [0:1]

  array title[3] = ["velocity", "shear stress", "normal stress"]
  array axis[3] = ["〈{/:Italic v_x}〉/〈{/:Italic v_x}〉_{top}", "〈{/:Italic τ}〉/{/:Italic τ}", "〈{/:Italic σ}〉/{/:Italic σ}"]
  do for [q = 1:3] {
    set title panel(word("A B C", q), title[q])
    set xlabel axis[q]
    if (q == 1) { set xrange [0:1]; set key left top Left reverse } else { set xrange [0:2]; unset key }
    if (q == 1) { set arrow 1 from 0, 0 to 1, 1 nohead linewidth 0.8 dashtype 3 linecolor rgb grey } else { set arrow 1 from 1, 0 to 1, 1 nohead linewidth 0.8 dashtype 3 linecolor rgb grey }
    plot for [i = 1:profiles] table using (column(quantity(i, q))):1:(column(quantity(i, q) + 1)):(column(quantity(i, q) + 2)) \
           with xerrorlines linewidth 0.9 pointtype mark[i] pointsize 0.5 linecolor rgb colour[i] \
           title label_of(sprintf("profile_%d", i))
    unset arrow 1
  }
  unset multiplot
  set output
}
