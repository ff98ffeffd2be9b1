# SPDX-License-Identifier: GPL-2.0-or-later
# Figure 2: the sample (A) at the end of preparation, (B) during shear; the glued layers are dark.
# Tables: circles from back to front, then the edges of the cell with their two ends. Columns: position (across, up, m),
# radius (m; 0 for an edge), shade (0 dark to 1 bright), part (see below).
tables = "fig02_before.dat fig02_during.dat"
command = "./reproduce fig02"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("fig02.gp")]
load here."style.gp"

array title[2] = ["end of preparation", "during shear"]
# Parts. One block of a table holds all parts, because gnuplot 5.4 expects column names in each block (index) of a file.
free = 0; edge_in_front = 3; edge_behind = 4   # 1 and 2 are glued grains
is_grain(part) = part < edge_in_front
across_of(part) = column("part") == part ? column("across") : NaN
# Free grains are light, glued grains dark; both are brighter towards their highlight.
grey_level(shade, part) = int(part == free ? 105 + 140 * shade : 15 + 80 * shade)
rgb(shade, part) = 0x010101 * grey_level(shade, part)

# Both pictures have the same frame, and so the same scale. It contains all circles and edges.
left = 1e9; right = -1e9; bottom = 1e9; top = -1e9
do for [table in tables] {
  stats data(table) using (column("across") - column("radius")) name "L" nooutput
  stats data(table) using (column("across") + column("radius")) name "R" nooutput
  stats data(table) using (column("up") - column("radius")) name "B" nooutput
  stats data(table) using (column("up") + column("radius")) name "T" nooutput
  left = left < L_min ? left : L_min; right = right > R_max ? right : R_max
  bottom = bottom < B_min ? bottom : B_min; top = top > T_max ? top : T_max
}
edge = 0.01 * (right - left)

corner = stated("e0_790", "first sample")
width = 14; height = 7.4   # cm
eval terminal("png", width, height)
set output picture.".png"
set multiplot layout 1, 2 margins 0.01, 0.99, 0.01, 0.87 spacing 0.02 title corner @in_corner
set size ratio -1
unset border; unset tics; unset key
set xrange [left - edge:right + edge]; set yrange [bottom - edge:top + edge]
set style fill solid noborder
do for [i = 1:2] {
  set title panel(word("A B", i), title[i])
  sample = data(word(tables, i))
  plot sample using (across_of(edge_behind)):(column("up")) with lines linewidth 0.6 linecolor rgb grey notitle, \
       sample using (is_grain(column("part")) ? column("across") : NaN):(column("up")):(column("radius")): \
         (rgb(column("shade"), column("part"))) with circles fillcolor rgb variable notitle, \
       sample using (across_of(edge_in_front)):(column("up")) with lines linewidth 0.6 linecolor rgb black notitle
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
