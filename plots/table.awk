# SPDX-License-Identifier: GPL-2.0-or-later
# What style.gp asks of tables: their heads name the columns, as "# column 2: displacement | x | m | ..." or, all in the
# first line, as "# slide<TAB>time". `ask` is one of
#   columns  gnuplot commands that set <prefix><name> to the number of each of the columns `wanted`, as the first table
#            with a head has it; `missing` is the number of those that it lacks, or 0: then gnuplot is to end
#   rows     the number of rows of all tables
#   first    the value of column `number` in the first row, mean: its mean over all rows; nothing where there is none
#   values   the values of column `number` that differ, in the order of their first rows, with blanks between
#   label    what stands behind the tab in the last line that begins with `wanted`; `wanted` if there is none
BEGIN { FS = "\t" }
FNR == 1 && heads > 0 && ask == "columns" { exit }
/^# column [0-9]+: / {
  split($0, words, /[ ]+/)
  found[words[4]] = words[3] + 0
  ++heads
  next
}
FNR == 1 && /^# [^\t]+\t/ {
  for (i = 1; i <= NF; ++i) found[i == 1 ? substr($1, 3) : $i] = i
  ++heads
  next
}
/^#/ || /^[ \t]*$/ { next }
ask == "label" { if ($1 == wanted) label = $2; next }
{
  ++rows
  if (number > 0) {
    split($0, values, /[ \t]+/)
    if (rows == 1) first = values[number]
    sum += values[number]
    if (!(values[number] in seen)) { seen[values[number]] = 1; differing = differing (differing == "" ? "" : " ") values[number] }
  }
}
END {
  if (ask == "columns") {
    count = split(wanted, names, " ")
    for (i = 1; i <= count; ++i) {
      if (!(names[i] in found) && !missing) {
        table = FILENAME
        sub(/.*\//, "", table)
        printf "print \"%s has no column %s\"; exit status 2", table, names[i]
        exit
      }
      printf "%s%s = %d; ", prefix, names[i], names[i] in found ? found[names[i]] : missing
    }
  }
  if (ask == "rows") print rows + 0
  # Written with a point: real() of gnuplot 5.4 refuses "4e-05".
  if (ask == "first" && rows > 0) { if (first ~ /^[-+]?[.0-9]/) printf "%.16e\n", first; else print first }
  if (ask == "mean" && rows > 0) printf "%.16e\n", sum / rows
  if (ask == "values") print differing
  if (ask == "label") printf "%s", label == "" ? wanted : label
}
