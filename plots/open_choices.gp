# SPDX-License-Identifier: GPL-2.0-or-later
# Which samples jam when they are sheared at constant volume, over shear rate and void ratio: (A) without and (B) with
# torsion resistance.
tables = "map.dat"
command = "./reproduce open_choices"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("open_choices.gp")]
load here."style.gp"

array shown[2] = ["without torsion resistance", "with torsion resistance"]
corner = stated("", "a mark a sample; the number is the strain from which it jams")
rate(is, torsion) = column("jams") == is && column("torsion_resistance") == torsion ? column("shear_rate") : NaN
strain(s) = sprintf("%.1f", s)

do for [format in "png pdf"] {
  eval terminal(format, 14, 6.6)
  set output picture.".".format
  set multiplot layout 1, 2 margins 0.085, 0.985, 0.18, 0.84 spacing 0.11 title corner @in_corner
  set logscale x
  set xrange [0.04:5]
  set xtics ("0.06" 0.06, "0.3" 0.3, "1" 1, "3" 3)
  set xlabel "shear rate (1/s)"
  set ylabel "void ratio {/:Italic e}_0 of the cell" offset 1
  set yrange [*:*]
  set offsets graph 0, graph 0, graph 0.08, graph 0.25   # room for the key below
  set format y "%.2f"
  set key bottom right Left reverse
  do for [p = 1:2] {
    set title panel(word("A B", p), shown[p])
    plot data(tables) using (rate(1, p - 1)):(column("void_ratio")) with points pointtype 7 pointsize 1 \
           linecolor rgb vermillion title "jams", \
         data(tables) using (rate(0, p - 1)):(column("void_ratio")) with points pointtype 6 pointsize 1 \
           linewidth 1.5 linecolor rgb blue title "stays liquefied", \
         data(tables) using (rate(1, p - 1)):(column("void_ratio")):(strain(column("strain"))) with labels \
           left offset 0.6, 0 font ",7" notitle
  }
  unset multiplot
}
