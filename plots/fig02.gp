# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 2: the sample (A) at the end of preparation, (B) during shear; the glued layers are dark.
# Tables: x (m), z (m), radius (m), shade (0 at the back to 1 in front), role (0 free, 1 glued), sorted from back to front.
tables = "fig02_before.dat fig02_during.dat"
command = "./reproduce fig02"
script = ARG0; folder = ARG1; picture = ARG2
load script[1:strlen(script) - strlen("fig02.gp")]."style.gp"

array title[2] = ["end of preparation", "during shear"]
grey_level(shade, role) = int((role > 0 ? 40 : 165) + (role > 0 ? 35 : 75) * shade)
rgb(shade, role) = (grey_level(shade, role) << 16) + (grey_level(shade, role) << 8) + grey_level(shade, role)

# One frame for both pictures, so that they have one scale.
left = 1e9; right = -1e9; bottom = 1e9; top = -1e9
do for [table in tables] {
  stats data(table) using ($1 - $3) name "L" nooutput
  stats data(table) using ($1 + $3) name "R" nooutput
  stats data(table) using ($2 - $3) name "B" nooutput
  stats data(table) using ($2 + $3) name "T" nooutput
  left = left < L_min ? left : L_min; right = right > R_max ? right : R_max
  bottom = bottom < B_min ? bottom : B_min; top = top > T_max ? top : T_max
}

do for [format in "png pdf"] {
  eval terminal(format, 14, 8)
  set output picture.".".format
  set multiplot layout 1, 2 margins 0.02, 0.98, 0.02, 0.92 spacing 0.03
  set size ratio -1
  unset border; unset tics; unset key
  set xrange [left:right]; set yrange [bottom:top]
  set style fill solid border rgb "#303030"
  do for [i = 1:2] {
    set title panel(word("A B", i), title[i])
    plot data(word(tables, i)) using 1:2:3:(rgb($4, $5)) with circles linewidth 0.4 linecolor rgb variable notitle
  }
  unset multiplot
  set output
}
