# SPDX-License-Identifier: GPL-2.0-or-later
# The sample of Fig. 2 at the end of preparation: (A) void ratios of slices across the three axes; band: two standard
# deviations of a random packing; (B) radial distribution function; (C) distribution of the number of contacts.
tables = "fig02_slices_x.dat fig02_slices_y.dat fig02_slices_z.dat fig02_distances.dat fig02_contacts.dat"
command = "./reproduce fig02_sample"
script = ARG0; folder = ARG1; picture = ARG2
here = script[1:strlen(script) - strlen("sample.gp")]
load here."style.gp"

array axis[3] = ["x", "y", "z"]
array colour[3] = [sky, orange, black]
array mark[3] = [6, 4, 7]
slices(i) = data(word(tables, i))
corner = stated("e0_790", "first sample; band: two standard deviations of a random packing")

do for [format in "png pdf"] {
  eval terminal(format, 18, 7)
  set output picture.".".format
  set multiplot layout 1, 3 margins 0.085, 0.985, 0.18, 0.84 spacing 0.09 title corner @in_corner

  set title panel("A", "void ratio in slices")
  set xlabel "place across the cell"
  set ylabel "void ratio {/:Italic e}" offset 1
  set xrange [0:1]
  set key top center Left reverse
  plot slices(3) using (column("place")):(column("lowest_random")):(column("highest_random")) \
         with filledcurves fillstyle solid linecolor rgb 0xE4E4E4 notitle, \
       for [i = 1:3] slices(i) using (column("place")):(column("void_ratio")) \
         with linespoints linewidth 1.2 pointtype mark[i] pointsize 0.5 linecolor rgb colour[i] title "across {/:Italic ".axis[i]."}"

  set title panel("B", "pairs of grains")
  set xlabel "distance {/:Italic r} / {/:Italic D}"
  set ylabel "radial distribution {/:Italic g}"
  set xrange [0:3]
  unset key
  plot data("fig02_distances.dat") using (column("distance")):(column("density")) \
         with lines linewidth 1.2 linecolor rgb black

  set title panel("C", "contacts")
  set xlabel "contacts of a grain"
  set ylabel "share of the grains"
  set xrange [-0.8:*]
  set boxwidth 0.8
  set style fill solid 0.6
  plot data("fig02_contacts.dat") using (column("contacts")):(column("share")) with boxes linecolor rgb blue
  unset multiplot
  set output
}
