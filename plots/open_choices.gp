# SPDX-License-Identifier: GPL-2.0-or-later
# Which samples jam when they are sheared at constant volume, over shear rate and void ratio: (A) without and (B) with
# torsion resistance. The colour is the strain from which a sample jams.
tables = "map.dat"
command = "./reproduce open_choices"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("open_choices.gp")]
load here."style.gp"

array shown[2] = ["without torsion resistance", "with torsion resistance"]
corner = stated("", "a mark is a sample; filled: jams, open: stays liquefied")
rate(is, torsion) = column("jams") == is && column("torsion_resistance") == torsion ? column("shear_rate") : NaN
hex(i) = sprintf("#%06X", in_order[i])
lowest = least_of(tables, "void_ratio")
margin = 0.06 * at_least(largest_of(tables, "void_ratio") - lowest, 0.01)

do for [format in "png pdf"] {
  eval terminal(format, 15, 6.6)
  set output picture.".".format
  set multiplot layout 1, 2 margins 0.095, 0.88, 0.18, 0.84 spacing 0.11 title corner @in_corner
  set logscale x
  set xrange [0.04:5]
  set xtics ("0.06" 0.06, "0.3" 0.3, "1" 1, "3" 3)
  unset key
  set xlabel "shear rate (1/s)"
  set ylabel "void ratio {/:Italic e}_0 of the cell" offset 0.3
  set yrange [lowest - margin:largest_of(tables, "void_ratio") + margin]
  set format y "%.2f"
  set palette defined (0 hex(1), 1 hex(2), 2 hex(3), 3 hex(4), 4 hex(5), 5 hex(6))
  set cbrange [0:300]
  set cbtics 100
  set cblabel "strain of the jam (%)" offset 0.5
  set style fill solid noborder   # of the colour box
  do for [p = 1:2] {
    set title panel(word("A B", p), shown[p])
    if (p == 1) { unset colorbox } else { set colorbox }
    plot data(tables) using (rate(1, p - 1)):(column("void_ratio")):(percent * column("strain")) with points \
           pointtype 7 pointsize 1.1 linecolor palette notitle, \
         data(tables) using (rate(0, p - 1)):(column("void_ratio")) with points pointtype 6 pointsize 1.1 \
           linewidth 1.5 linecolor rgb blue notitle
  }
  unset multiplot
}
