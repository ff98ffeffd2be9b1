# SPDX-License-Identifier: GPL-2.0-or-later
# What every figure shares. A script sets `tables` (the files it reads, separated by spaces) and `command` (what makes
# them) and its arguments (`script`, `folder`, `picture`: loading a file forgets ARG0 and on), then loads this file. It
# is called as `gnuplot -c plots/figNN.gp DATADIR OUTPUT` and writes OUTPUT.png and OUTPUT.pdf; it draws what the tables
# hold and computes nothing but units.

if (picture eq "") {
  print sprintf("usage: gnuplot -c %s DATADIR OUTPUT   (writes OUTPUT.png and OUTPUT.pdf)", script)
  exit status 2
}
# A folder so_far (see --so-far) need not have all tables: curves that are not there yet are left out.
so_far = folder eq "so_far" || strlen(folder) > 6 && folder[strlen(folder) - 6:*] eq "/so_far"
data(name) = so_far && !readable(folder."/".name) ? "/dev/null" : folder."/".name
# A script that sets `beside`, its third argument, can draw the results of another run of the same points, dashed.
if (!exists("beside")) beside = ""
others = beside eq "" ? 0 : 1
other(name) = (others ? beside : folder)."/".name
if_others = others ? 1 : NaN   # a factor: gnuplot runs through an empty range once
shell_quoted(s) = "'".escaped(s)."'"
escaped(s) = strstrt(s, "'") == 0 ? s : s[1:strstrt(s, "'") - 1]."'\\''".escaped(s[strstrt(s, "'") + 1:*])
readable(file) = int(system("test -s ".shell_quoted(file)." && echo 1 || echo 0"))
do for [table in tables] {
  if (!so_far && !readable(data(table)) || (others && !readable(other(table)))) {
    print sprintf("%s: no table %s. Make it with: %s", script, readable(data(table)) ? other(table) : data(table), command)
    exit status 2
  }
}

# Labels of the curves: DATADIR/legend.dat, lines of `point<TAB>label`. A point that it does not name keeps its own name.
label_of(point) = system("awk -F'\t' -v p=".shell_quoted(point).\
  " '$1 == p {l = $2} END {printf \"%s\", l == \"\" ? p : l}' ".shell_quoted(data("legend.dat")))

other_label = others ? "dashed: ".system("basename -- ".shell_quoted(beside)) : ""

# Columns of a shear run's table, SI units.
column_strain = 2
column_shear = 3
column_normal = 4
column_inertial = 6
kilo = 1e-3       # Pa to kPa
percent = 100.0   # strain to %

set encoding utf8
set minussign
# width and height in cm; the PNG has 80 pixels a cm (203 dpi), the PDF the same proportions.
terminal(format, width, height) = format eq "png" \
  ? sprintf("set terminal pngcairo enhanced size %d,%d font 'DejaVu Sans,8' fontscale 2.0 linewidth 2 background 'white'", \
            80 * width, 80 * height) \
  : sprintf("set terminal pdfcairo enhanced size %gcm,%gcm font 'DejaVu Sans,8' fontscale 0.7 linewidth 1", width, height)

# Okabe and Ito's palette: told apart with any colour vision, and by lightness in print.
blue = 0x0072B2; vermillion = 0xD55E00; green = 0x009E73; purple = 0xCC79A7; orange = 0xE69F00; sky = 0x56B4E9
black = 0x000000; grey = 0x808080

set border 3 linewidth 0.8 linecolor rgb black
set tics nomirror out scale 0.6
set key samplen 1.6 spacing 1.15 width -1 noopaque
panel(letter, title) = sprintf("{/:Bold %s}  %s", letter, title)
set title offset 0, -0.4
