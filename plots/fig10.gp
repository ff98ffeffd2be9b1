# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 10: profiles over the height of the sample with RD, before and after liquefaction: (A) velocity, (B) shear
# stress, (C) normal stress. Median and range of the replicates.
tables = "RD_ramp_profiles_band.dat legend.txt"
command = "./reproduce fig10"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig10.gp")]
load here."style.gp"

table = data("RD_ramp_profiles_band.dat")
profiles = 4
array colour[profiles] = [black, sky, orange, vermillion]
array mark[profiles] = [7, 6, 4, 8]
quantities = "velocity shear_stress normal_stress"
array shown[3] = ["velocity", "shear stress", "normal stress"]
array share[3] = ["⟨{/:Italic v_x}⟩ / ⟨{/:Italic v_x}⟩_{top}", \
  "⟨{/:Italic τ}⟩ / {/:Italic τ}", "⟨{/:Italic σ}⟩ / {/:Italic σ}"]
names = names_in("RD_ramp_profiles_band.dat")
# A run that ends before the strain of a profile has no such profile.
profile(q, i, of) = optional(names, sprintf("%s_%d_%s", word(quantities, q), i, of))
inner(q) = q == 1 ? 0 : 1   # hides the stress of the outer sublayers, which overlap the glued layers
last_layer = rows("RD_ramp_profiles_band.dat") - 1
within(value) = value < -0.5 ? -0.5 : value > 2.5 ? 2.5 : value   # limits the distance by which a curve leaves the frame

do for [format in "png pdf"] {
  eval terminal(format, 18, 6.6)
  set output picture.".".format
  set multiplot layout 1, 3
  set bmargin at screen 0.21; set tmargin at screen 0.88
  set ylabel "relative height {/:Italic z} / {/:Italic H}" offset 1
  set yrange [0:1]
  set key bottom right Left reverse

  do for [q = 1:3] {
    set title panel(word("A B C", q), shown[q])
    set xlabel share[q]
    set xrange [0:(q == 1 ? 1 : 2)]
    set arrow 1 from first (q == 1 ? 0 : 1), 0 to first 1, 1 nohead linewidth 0.8 dashtype 3 linecolor rgb grey
    plot for [i = 1:profiles] table every ::inner(q)::last_layer - inner(q) \
           using (within(column(profile(q, i, "median")))):(column("relative_height")): \
           (within(column(profile(q, i, "lowest")))):(within(column(profile(q, i, "highest")))) \
           with xerrorbars linewidth 0.6 pointtype mark[i] pointsize 0.4 linecolor rgb colour[i] notitle, \
         for [i = 1:profiles] table every ::inner(q)::last_layer - inner(q) \
           using (within(column(profile(q, i, "median")))):(column("relative_height")) \
           with linespoints linewidth 1.2 pointtype mark[i] pointsize 0.5 linecolor rgb colour[i] \
           title label_of(sprintf("profile_%d", i))
    unset arrow 1
    unset key
  }
  unset multiplot
  set output
}
