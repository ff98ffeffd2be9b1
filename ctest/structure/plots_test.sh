#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# plots_test.sh: the scripts of the figures name columns, never numbers; and what they share finds columns, rows and labels
# in a folder whose name a shell would run, ends with 2 for a table or column that is missing, and draws tables without rows.
set -euo pipefail
export LC_ALL=C.UTF-8   # gnuplot warns of signs that a plain locale lacks
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
failures=0
complain() { echo "$1"; failures=$((failures + 1)); }

for script in "$source_dir"/plots/*.gp; do
  if grep -nE '\$[0-9]|column\([0-9]|strcol\([0-9]|using [0-9]+[: ]|using .*[):][0-9]+(:| with| every| \\)' "$script"; then
    complain "$(basename "$script") names a column by its number"
  fi
done

folder="$room/it's \$(touch hacked) \"a b\""
mkdir "$folder"
cd "$room"
# table FILE ROWS...: as write_table writes it.
table() {
  printf 'time stress\n# case: test\n# column 1: time | t | s | time |\n# column 2: stress | tau | Pa | shear stress |\n' \
    >"$folder/$1"
  (($# == 1)) || printf '%s\n' "${@:2}" >>"$folder/$1"
}
table RD.dat '0 2' '1 5' '2 8'
table RD_r2.dat '0 3'
printf 'slide time\n# column 1: slide\nRD 0.25\nRI 0.5\n' >"$folder/peaks.dat"
printf 'RD\t{/:Italic A} = 3 kPa\n' >"$folder/legend.txt"
# draw TABLES COMMANDS: runs gnuplot; sets `code` to its exit code and `said` to its output.
draw() {
  cat >"$room/test.gp" <<GNUPLOT
tables = "$1"; command = "make them"
script = ARG0; folder = ARG1; picture = ARG2
here = "$source_dir/plots/"
load here."style.gp"
$2
GNUPLOT
  code=0
  said=$(gnuplot -c "$room/test.gp" "$folder" "$folder/picture" 2>&1) || code=$?
}
expect() { [[ $code == "$1" && $said == *"$2"* ]] || complain "expected $1 with '$2', got $code with '$said'"; }

# drawn NAME USING: commands that print the values that gnuplot reads from a table.
drawn() { echo "set xrange [0:9]; set yrange [0:9]; set table \$drawn; plot data(\"$1\") using $2; unset table; print \$drawn"; }

draw 'RD.dat' 'print replicates("RD"), rows("RD.dat")'
expect 0 '2 3'
draw 'RD.dat' "$(drawn RD.dat '(column("time")):(column("stress"))')"
expect 0 $' 0  2  i\n 1  5  i\n 2  8  i'
draw 'RD.dat' "name = \"stress\"; $(drawn RD.dat '(column(name)):(column(name))')"
expect 0 $' 2  2  i\n 5  5  i\n 8  8  i'
draw 'peaks.dat' "$(drawn peaks.dat '(strcol("slide") eq "RI" ? column("time") : NaN):(1)')"
expect 0 $' 0.5  1  i'
# Distances of a slope that stands are in mm, and their tics are few.
draw 'RD.dat' 'print in_milli(0.0001), in_milli(2.0), in_milli(NaN), " ", milli_unit(0.0001, "m/s"), " ", milli_unit(2.0, "m")'
expect 0 '1000.0 1 1   mm/s   m'
draw 'RD.dat' 'print few_tics(0.0996), few_tics(0.12), few_tics(10.0), few_tics(6.1)'
expect 0 '0.02 0.02 2 2'
draw 'peaks.dat' 'print first_of("peaks.dat", "time"), first_where("peaks.dat", "time", "slide", "RI")'
expect 0 '0.25 0.5'
draw 'peaks.dat' 'print first_where("peaks.dat", "time", "slide", "other"), " ", values_of("peaks.dat", "slide")'
expect 0 'NaN   RD RI'
draw 'RD.dat' 'print mean_of("RD.dat", "stress"), " ", label_of("RD"), " ", label_of("RI")'
expect 0 '5.0   {/:Italic A} = 3 kPa   RI'
table bounds.dat '4e-05 nan'
draw 'bounds.dat' 'print first_of("bounds.dat", "time") * 1e5, " ", first_of("bounds.dat", "stress")'
expect 0 '4.0   NaN'
draw 'RD.dat RD_r2.dat' 'print "<", values_of("RD.dat RD_r2.dat", "time"), ">"'
expect 0 '< 0 1 2 >'
draw 'RD.dat RD_r2.dat' 'print least_of("RD.dat RD_r2.dat", "time stress"), largest_of("RD.dat RD_r2.dat", "stress"), least_of("RD.dat", "mass")'
expect 0 '0.0 8.0 NaN'
draw 'RD.dat' 'print stated("", "a note")'
expect 0 '{/:Italic N} not recorded (tables of an older version); a note'
printf '# scale: quick\n' >>"$folder/RD.dat"
draw 'RD.dat' 'print stated("RD", "")'
expect 0 'quick scale, {/:Italic N} not recorded (tables of an older version)'
sed -i '/^# scale/d' "$folder/RD.dat"
printf 'run curve scale grains\n# column 1: run\nRD RD quick 1100\nRD_r2 RD quick 1100\nRI RI quick 400\nfree free quick 0\n' \
  >"$folder/runs.dat"
draw 'RD.dat' 'print "<", stated("RD", ""), ">"'
expect 0 '< quick scale, {/:Italic N} = 1100 grains, 2 samples >'
draw 'RD.dat' 'print stated("", "a note")'
expect 0 'quick scale, {/:Italic N} = 400 to 1100 grains, 1 to 2 samples; a note'
draw 'RD.dat' 'print stated("free", "")'
expect 0 'quick scale, no grains, 1 sample'
printf 'size_a = "2 mm", not "3 mm"\n' >"$folder/changes.txt"
draw 'RD.dat' 'print stated("RD", "")'
expect 0 $'changed: size\\_a = "2 mm", not "3 mm"\nquick scale'
rm "$folder/changes.txt" "$folder/runs.dat"
draw 'RI.dat' 'print "drawn"'
expect 2 'no table'
printf '# case: test\n# column 1: time | t | s | time |\n0\n' >"$folder/old.dat"
draw 'RD.dat old.dat' 'print "drawn"'
expect 2 'the first line of old.dat does not name its columns'
draw 'RD.dat' "$(drawn RD.dat '(column("time")):(column("velocity"))')"
expect 0 'no column with header "velocity"'   # of which ./reproduce makes an error
draw 'RD.dat' "names = names_in(\"RD.dat\"); $(drawn RD.dat '(column("time")):(column(optional(names, "velocity")))')"
expect 0 'NaN'
[[ $said != *warning* ]] || complain "an optional column is complained of: $said"
draw 'RD.dat' 'names = names_in("RD.dat"); print optional(names, "stress"), "<", optional(names, "str"), ">"'
expect 0 'stress <  >'
: >"$folder/RD_r2.dat"
draw 'RD.dat' 'print replicates("RD")'
expect 0 '1'

table empty.dat
draw 'empty.dat' 'set terminal png; set output picture
set xrange [0:*]; set yrange [0:*]; eval frame("empty.dat", "set xrange [0:1]; set yrange [0:1]")
plot data("empty.dat") using (column("time")):(column("stress")) with lines; print first_of("empty.dat", "stress")'
expect 0 'NaN'
[[ -s $folder/picture ]] || complain 'a table without rows is not drawn'
[[ $said != *warning* ]] || complain "a table without rows is complained of: $said"

mkdir "$folder/so_far"
cp "$folder/RD.dat" "$folder/so_far"
folder="$folder/so_far"
draw 'RD.dat RI.dat' 'set xrange [0:9]; set yrange [0:9]; set terminal png; set output picture
plot for [name in "RD.dat RI.dat"] data(name) using (column("time")):(column("stress")), \
  data("RD.dat") using (column("time")):(column("velocity")); print "drawn"'
expect 0 'drawn'
[[ -s $folder/picture ]] || complain 'what there is so far is not drawn'

[[ -z $(find "$room" -name hacked) ]] || complain 'a name was run by a shell'
echo "$failures failures"
((failures == 0))
