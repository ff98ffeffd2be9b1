# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 10: profiles over the height of the sample with RD, before and after liquefaction: (A) velocity, (B) shear
# stress, (C) normal stress, in ten sublayers. The stress of the two outer sublayers is too low, because they overlap
# the glued layers: open marks.
tables = "RD_ramp_profiles_band.dat legend.txt"
command = "./reproduce fig10"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig10.gp")]
load here."style.gp"

table = data("RD_ramp_profiles_band.dat")
profiles = 4
array colour[profiles] = [black, 0xD9AE00, 0xE16462, 0x6A00A8]
array mark[profiles] = [5, 7, 9, 13]
array open_mark[profiles] = [4, 6, 8, 12]
quantities = "velocity shear_stress normal_stress"
array shown[3] = ["velocity", "shear stress", "normal stress"]
array share[3] = ["⟨{/:Italic v_x}⟩ / ⟨{/:Italic v_x}⟩_{top}", \
  "⟨{/:Italic τ}⟩ / {/:Italic τ}", "⟨{/:Italic σ}⟩ / {/:Italic σ}"]
names = names_in("RD_ramp_profiles_band.dat")
# A run that ends before the strain of a profile has no such profile.
profile(q, i, of) = optional(names, sprintf("%s_%d_%s", word(quantities, q), i, of))
last_layer = rows("RD_ramp_profiles_band.dat") > 2 ? rows("RD_ramp_profiles_band.dat") - 1 : 2
corner = stated("RD_ramp", "bars: lowest to highest of the samples, marks: median; open: sublayers with glued grains")
# The labels of the profiles, in groups; tables of older versions do not name them.
state(i) = label_of(sprintf("profile_%d_is", i))
head(i) = state(i) eq sprintf("profile_%d_is", i) ? "" : state(i).": "
# Range of B and C: bars far from 1 are long, so the axis is logarithmic beyond -1 and 2.
columns(q) = columns_from(q, 1)
columns_from(q, i) = i > profiles ? "" : profile(q, i, "lowest")." ".profile(q, i, "highest")." ".columns_from(q, i + 1)
stretched(x) = x < 0 ? -bent(-x, 1.0) : bent(x, 2.0)
back(x) = x < 0 ? -straight(-x, 1.0) : straight(x, 2.0)
first(q) = 1.05 * -at_least(-least_of("RD_ramp_profiles_band.dat", columns(q)), 0)
last(q) = 1.05 * at_least(largest_of("RD_ramp_profiles_band.dat", columns(q)), 1)

do for [format in "png pdf"] {
  eval terminal(format, 18, 8.4)
  set output picture.".".format
  set multiplot layout 1, 3 margins 0.07, 0.985, 0.3, 0.86 spacing 0.08 title corner @in_corner
  set ylabel "relative height {/:Italic z} / {/:Italic H}" offset 1
  set yrange [0:1]

  do for [q = 1:3] {
    set title panel(word("A B C", q), shown[q])
    set xlabel share[q]
    if (q == 1) {
      set xrange [0:1]
    } else {
      set nonlinear x via stretched(x) inverse back(x)
      set xrange [first(q):last(q)]
      if (first(q) < -0.5) { set xtics (-10, -1, 0, 1, 2, 10) } else { set xtics (-1, 0, 0.5, 1, 1.5, 2, 5) }
    }
    set arrow 1 from first (q == 1 ? 0 : 1), 0 to first 1, 1 nohead linewidth 0.8 dashtype 3 linecolor rgb grey
    if (q == 1) {
      set key at screen 0.5, screen 0.005 center bottom vertical maxrows 2 Left reverse samplen 2 width 0
    } else {
      unset key
    }
    plot for [i = 1:profiles] table using (column(profile(q, i, "median"))):(column("relative_height")): \
           (column(profile(q, i, "lowest"))):(column(profile(q, i, "highest"))) \
           with xerrorbars linewidth 0.6 pointtype -1 linecolor rgb colour[i] notitle, \
         for [i = 1:profiles] table using (column(profile(q, i, "median"))):(column("relative_height")) \
           with lines linewidth 1.2 linecolor rgb colour[i] notitle, \
         for [i = 1:profiles] table every ::1::last_layer - 1 \
           using (column(profile(q, i, "median"))):(column("relative_height")) \
           with points pointtype mark[i] pointsize 0.6 linecolor rgb colour[i] notitle, \
         for [i = 1:profiles] table every last_layer using (column(profile(q, i, "median"))):(column("relative_height")) \
           with points pointtype (q == 1 ? mark[i] : open_mark[i]) pointsize 0.9 linecolor rgb colour[i] notitle, \
         for [i = 1:profiles] keyentry with linespoints linewidth 1.2 pointtype mark[i] pointsize 0.6 \
           linecolor rgb colour[i] title head(i).label_of(sprintf("profile_%d", i))
    unset arrow 1
  }
  unset nonlinear x; set xtics autofreq
  unset multiplot
  set output
}
