# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 2: the sample (A) at the end of preparation, (B) during shear; the glued layers are dark.
# Tables: index 0 circles from back to front: radius (m), shade (0 dark to 1 bright), role (0 free, else glued); index 1
# and 2 the edges of the cell in front and behind; of all, where they stand: across, up (m).
tables = "fig02_before.dat fig02_during.dat"
command = "./reproduce fig02"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig02.gp")]
load here."style.gp"
eval columns("", tables, "across up radius shade role")

array title[2] = ["end of preparation", "during shear"]
# Free grains light, glued ones dark, both brighter towards their highlight.
grey_level(shade, role) = int(role == 0 ? 105 + 140 * shade : 15 + 80 * shade)
rgb(shade, role) = 0x010101 * grey_level(shade, role)

# One frame for both pictures, so that they have one scale: it holds all circles and edges.
left = 1e9; right = -1e9; bottom = 1e9; top = -1e9
do for [table in tables] {
  do for [block = 0:2] {
    reach(i) = block == 0 ? column(i) : 0
    stats data(table) index block using (column(across) - reach(radius)) name "L" nooutput
    stats data(table) index block using (column(across) + reach(radius)) name "R" nooutput
    stats data(table) index block using (column(up) - reach(radius)) name "B" nooutput
    stats data(table) index block using (column(up) + reach(radius)) name "T" nooutput
    left = left < L_min ? left : L_min; right = right > R_max ? right : R_max
    bottom = bottom < B_min ? bottom : B_min; top = top > T_max ? top : T_max
  }
}
edge = 0.01 * (right - left)

width = 14; height = 7   # cm
eval terminal("png", width, height)
set output picture.".png"
set multiplot layout 1, 2 margins 0.01, 0.99, 0.01, 0.92 spacing 0.02
set size ratio -1
unset border; unset tics; unset key
set xrange [left - edge:right + edge]; set yrange [bottom - edge:top + edge]
set style fill solid noborder
do for [i = 1:2] {
  set title panel(word("A B", i), title[i])
  grains = data(word(tables, i))
  plot grains index 2 using (column(across)):(column(up)) with lines linewidth 0.6 linecolor rgb grey notitle, \
       grains index 0 using (column(across)):(column(up)):(column(radius)):(rgb(column(shade), column(role))) \
         with circles fillcolor rgb variable notitle, \
       grains index 1 using (column(across)):(column(up)) with lines linewidth 0.6 linecolor rgb black notitle
}
unset multiplot
set output

# The PDF holds the same picture as an image: tens of thousands of circles would make it 15 MB.
eval terminal("pdf", width, height)
set output picture.".pdf"
set margins 0, 0, 0, 0
unset title
set xrange [*:*] noextend; set yrange [*:*] noextend
plot picture.".png" binary filetype=png with rgbimage notitle
set output
