# SPDX-License-Identifier: GPL-2.0-or-later
# What style.gp asks of tables. The first line of a table names its columns, with blanks between. `ask` is one of
#   unnamed  the name of the first table <name>.dat whose first line names no columns, or nothing
#   names    the names of the columns, with a blank before and behind each
#   blank    a table without values: the first line, and a row that is NaN in each column
#   rows     the number of rows of all tables
#   first    the value of column `name` in the first row, mean: its mean over all rows; nothing where there is none
#   range    the least and the largest value of all columns `name` (names with blanks between) in all tables; nothing
#            where there is none
#   values   the values of column `name` that differ, in the order of their first rows, with blanks between
#   scale    "<scale> scale, " from the heads of the tables; nothing where none names a scale
# of those rows only in which column `key`, if given, is `is`;
# and of legend.txt, lines of "point<TAB>label"
#   label    what stands behind the tab in the last line that begins with `wanted`; `wanted` if there is none
# and of runs.dat
#   conditions  scale, number of grains and number of samples of the curves `wanted` (names with blanks between; all if "")
function take_run(  curve, grains) {
  curve = $place["curve"]; grains = $place["grains"] + 0
  if (wanted != "" && index(" " wanted " ", " " curve " ") == 0) return
  scale = $place["scale"]
  ++samples[curve]
  if (grains == 0) return
  if (fewest == 0 || grains < fewest) fewest = grains
  if (grains > most) most = grains
}
# "3 samples", or "1 to 3 samples" where the curves differ.
function samples_text(  curve, least, largest) {
  for (curve in samples) {
    if (least == 0 || samples[curve] < least) least = samples[curve]
    if (samples[curve] > largest) largest = samples[curve]
  }
  return (least == largest ? largest + 0 : least " to " largest) (largest == 1 ? " sample" : " samples")
}
BEGIN { if (ask == "label") FS = "\t" }
ask == "label" { if ($1 == wanted) label = $2; next }
FNR == 1 {
  head = $0
  column = key_column = 0
  for (i = 1; i <= NF; ++i) {
    if ($i == name) column = i
    if ($i == key) key_column = i
    place[$i] = i
    column_name[i] = $i
    if ($i !~ /^[A-Za-z][A-Za-z0-9_]*$/ && FILENAME ~ /[.]dat$/ && unnamed == "") unnamed = FILENAME
  }
  next
}
ask == "scale" && /^# scale: / && scale == "" { scale = $3 }
ask == "conditions" && !/^#/ { take_run(); next }
/^#/ || NF == 0 || (key != "" && $key_column != is) { next }
{
  ++rows
  if (ask == "range")
    for (i = 1; i <= NF; ++i)
      if (index(" " name " ", " " column_name[i] " ") > 0 && $i + 0 == $i && $i !~ /nan/) {
        if (largest == "" || $i + 0 > largest) largest = $i + 0
        if (least == "" || $i + 0 < least) least = $i + 0
      }
  if (column > 0) {
    value = $column
    if (rows == 1) first = value
    sum += value
    if (!(value in seen)) { seen[value] = 1; differing = differing (differing == "" ? "" : " ") value }
  }
}
END {
  if (ask == "unnamed") {
    sub(/.*\//, "", unnamed)
    printf "%s", unnamed
  }
  if (ask == "names") printf " %s ", head
  if (ask == "blank") {
    if (head == "") head = "nothing"
    print head
    gsub(/[^ ]+/, "NaN", head)
    print head
  }
  if (ask == "rows") print rows + 0
  # Written with a point: real() of gnuplot 5.4 refuses "4e-05".
  if (ask == "first" && first != "") { if (first ~ /^[-+]?[.0-9]/) printf "%.16e\n", first; else print first }
  if (ask == "range" && largest != "") printf "%.16e %.16e\n", least, largest
  if (ask == "mean" && first != "") printf "%.16e\n", sum / rows
  if (ask == "values") print differing
  if (ask == "scale" && scale != "") printf "%s scale, ", scale
  if (ask == "conditions") {
    grains = most == 0 ? "no grains" : "{/:Italic N} = " (fewest == most ? most : fewest " to " most) " grains"
    printf "%s scale, %s, %s", scale == "" ? "unknown" : scale, grains, samples_text()
  }
  if (ask == "label") printf "%s", label == "" ? wanted : label
}
