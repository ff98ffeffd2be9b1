# SPDX-License-Identifier: GPL-2.0-or-later
# Settings and functions that all figures share. A script is called as `gnuplot -c plots/figNN.gp DATADIR OUTPUT` and
# writes OUTPUT.png and OUTPUT.pdf. It plots the tables and converts units; it computes nothing else. Before it loads
# this file it sets `tables` (the files that it reads, separated by spaces), `command` (the command that makes them)
# and its arguments `script`, `folder` and `picture` (`load` replaces ARG0 and the following).

if (picture eq "") {
  print sprintf("usage: gnuplot -c %s DATADIR OUTPUT   (writes OUTPUT.png and OUTPUT.pdf)", script)
  exit status 2
}
# The first line of a table names its columns: column("time"), or column(EXPRESSION) if EXPRESSION gives a name.
set datafile columnheaders
# A folder so_far (see --so-far) may lack tables; their curves are left out. path(NAME) is the table. data(NAME) is the
# data to plot: the table, or a row of NaN for a table without rows, about which gnuplot would complain.
so_far = folder eq "so_far" || strlen(folder) > 6 && folder[strlen(folder) - 6:*] eq "/so_far"
path(name) = so_far && !readable(folder."/".name) ? "/dev/null" : folder."/".name
data(name) = rows(name) > 0 ? path(name) : "< ".awk("blank", "", name)
# With `beside`, its third argument, a script also plots the results of the same points in another folder, dashed.
if (!exists("beside")) beside = ""
others = beside eq "" ? 0 : 1
other(name) = (others ? beside : folder)."/".name
if_others = others ? 1 : NaN   # a factor: gnuplot runs through an empty range once
shell_quoted(s) = "'".escaped(s)."'"
escaped(s) = strstrt(s, "'") == 0 ? s : s[1:strstrt(s, "'") - 1]."'\\''".escaped(s[strstrt(s, "'") + 1:*])
readable(file) = int(system("test -s ".shell_quoted(file)." && echo 1 || echo 0"))
do for [table in tables] {
  if (!so_far && !readable(path(table)) || (others && !readable(other(table)))) {
    print sprintf("%s: no table %s. Make it with: %s", script, readable(path(table)) ? other(table) : path(table), command)
    exit status 2
  }
}

# The answer of table.awk about some tables, whose names are separated by blanks.
paths(tables, i) = i > words(tables) ? "" : shell_quoted(path(word(tables, i)))." ".paths(tables, i + 1)
awk(what, options, tables) = \
  sprintf("LC_ALL=C awk -f %s -v ask=%s %s %s", shell_quoted(here."table.awk"), what, options, paths(tables, 1))
asked(what, options, tables) = system(awk(what, options, tables))
unnamed = asked("unnamed", "", tables)
if (unnamed ne "") {
  print sprintf("%s: the first line of %s does not name its columns, as in tables of older versions. Make it again with: %s", \
    script, unnamed, command)
  exit status 2
}
rows(tables) = int(asked("rows", "", tables))
number_in(text) = text eq "" ? NaN : real(text)
first_of(table, name) = number_in(asked("first", "-v name=".name, table))
first_where(table, name, key, value) = \
  number_in(asked("first", sprintf("-v name=%s -v key=%s -v is=%s", name, key, shell_quoted(value)), table))
values_of(table, name) = asked("values", "-v name=".name, table)   # the different ones, separated by blanks
least_of(tables, names) = number_in(word(asked("range", "-v name=".shell_quoted(names), tables), 1))
largest_of(tables, names) = number_in(word(asked("range", "-v name=".shell_quoted(names), tables), 2))
mean_of(table, name) = number_in(asked("mean", "-v name=".name, table))
# Columns that a table may lack, such as a profile at a strain that a run did not reach: with names = names_in(TABLE),
# column(optional(names, NAME)) plots nothing if NAME is missing. gnuplot does not complain about column("").
names_in(table) = asked("names", "", table)
optional(names, name) = strstrt(names, " ".name." ") > 0 ? name : ""
# The same for a column of text: strcol() would end the script if the column is missing.
text_in(names, name) = optional(names, name) eq "" ? "" : strcol(name)
# frame(TABLES, RANGES): evaluate it before a panel whose tables may have no rows, because gnuplot cannot choose the
# range of an empty panel. RANGES are commands such as "set yrange [0:1]".
frame(tables, ranges) = rows(tables) > 0 ? "" : ranges
# The tables of the replicates of a slide: replicate_file(SLIDE, 1) to replicate_file(SLIDE, replicates(SLIDE)).
replicate(slide, r) = slide.(r == 1 ? "" : sprintf("_r%d", r)).".dat"
replicate_file(slide, r) = data(replicate(slide, r))
replicates_from(slide, r) = readable(path(replicate(slide, r + 1))) ? replicates_from(slide, r + 1) : r
replicates(slide) = replicates_from(slide, 1)

# Labels of the curves, from the lines `point<TAB>label` of DATADIR/legend.txt. Without a line, the label is the name
# of the point.
label_of(point) = asked("label", "-v wanted=".shell_quoted(point), "legend.txt")

other_label = others ? "dashed: ".system("basename -- ".shell_quoted(beside)) : ""

# For set nonlinear: an axis that is linear up to `bend`; beyond, a factor e takes the space of 40 % of the linear part.
bent(value, bend) = value < bend ? value : bend * (1 + 0.4 * log(value / bend))
straight(place, bend) = place < bend ? place : bend * exp((place / bend - 1) / 0.4)
at_least(value, least) = value > least ? value : least   # `least`, too, for NaN

# A slope that stands moves by less than a centimetre: with in_milli(LARGEST), its values are in mm or mm/s.
in_milli(largest) = largest <= 0.01 ? 1e3 : 1   # 1 for NaN, too
milli_unit(largest, unit) = (in_milli(largest) == 1 ? "" : "m").unit
# few_tics(LENGTH): a distance of tics, 1, 2 or 5 times a power of ten, that gives 3 to 7 of them; they cannot overlap.
few_tics(length) = round_down(length / 3.0, 10**floor(log10(length / 3.0)))
round_down(step, power) = power * (step >= 5 * power ? 5 : step >= 2 * power ? 2 : 1)

kilo = 1e-3       # Pa to kPa
percent = 100.0   # strain to %

set encoding utf8
set minussign
# Width and height in cm. The PNG has 80 pixels per cm (203 dpi); the PDF has the same proportions.
terminal(format, width, height) = format eq "png" \
  ? sprintf("set terminal pngcairo enhanced size %d,%d font 'DejaVu Sans,8' fontscale 2.0 linewidth 2 background 'white'", \
            80 * width, 80 * height) \
  : sprintf("set terminal pdfcairo enhanced size %gcm,%gcm font 'DejaVu Sans,8' fontscale 0.7 linewidth 1", width, height)

# Palette of Okabe and Ito: distinguishable with any colour vision, and by lightness in print.
blue = 0x0072B2; vermillion = 0xD55E00; green = 0x009E73; purple = 0xCC79A7; orange = 0xE69F00; sky = 0x56B4E9
black = 0x000000; grey = 0x808080

set border 3 linewidth 0.8 linecolor rgb black
set tics nomirror out scale 0.6
set key samplen 2 spacing 1.15 width -1 noopaque
panel(letter, title) = sprintf("{/:Bold %s}  %s", letter, title)
set title offset 0, -0.4
set style fill transparent solid 0.22 noborder   # of bands

# Text of the upper left corner: `multiplot ... title corner @in_corner`.
# stated(CURVES, NOTE): scale, number of grains and number of samples of these curves (of all, if ""), from runs.dat, and
# NOTE, which says what a band is. If settings differ from those of the case, a line above says so.
if (readable(folder."/changes.txt")) {
  changed = system("paste -sd ';' ".shell_quoted(folder."/changes.txt")." | sed 's/;/; /g'")
  changed = strlen(changed) > 100 ? changed[1:100]." ... (changes.txt)" : changed
  changed = "changed: ".system("printf '%s' ".shell_quoted(changed)." | sed 's/[_^{}@&~\\\\]/\\\\&/g'")."\n"
} else {
  changed = ""
}
conditions(curves) = readable(path("runs.dat")) \
  ? asked("conditions", "-v wanted=".shell_quoted(curves), "runs.dat") \
  : asked("scale", "", tables)."{/:Italic N} not recorded (tables of an older version)"
stated(curves, note) = changed.conditions(curves).(note eq "" ? "" : "; ".note)
range_of_samples = "band: lowest to highest of the samples, line: median"
in_corner = "font ',6' left offset screen -0.494, character 0.3"   # gnuplot 5.4 counts from the middle

# Colours of curves that differ by a parameter, from dark to light: ordered(I, N) is the I-th of N, N <= 6. dark(COLOUR)
# is for a second curve on top of one of this colour.
array in_order[6] = [0x0D0887, 0x6A00A8, 0xB12A90, 0xE16462, 0xF89540, 0xD9AE00]
ordered(i, n) = in_order[n == 1 ? 1 : 1 + int((i - 1) * 5.0 / (n - 1) + 0.5)]
channel(colour, k) = int(colour / 256**k) % 256
dark(colour) = 65536 * int(0.6 * channel(colour, 2)) + 256 * int(0.6 * channel(colour, 1)) + int(0.6 * channel(colour, 0))
dashes = "dashtype (5, 2.5)"     # short enough to be seen in a key
