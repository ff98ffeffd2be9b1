#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# tables_test.sh CASES: numpy and pandas read every table of a real run as README.md says: the names of the columns and
# all values are those that awk finds. CASES is the folder with the built cases.
set -euo pipefail
cases=$(cd "$1" && pwd)
# Debian's packages belong to /usr/bin/python3; another python3 may stand before it.
python=''
for candidate in python3 /usr/bin/python3; do
  [[ -n $python ]] || ! "$candidate" -c 'import numpy, pandas' 2>/dev/null || python=$candidate
done
[[ -n $python ]] || { echo 'skipped: python3-numpy or python3-pandas is not installed (packages-full.txt)'; exit 77; }
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
export FLOWSLIDE_CACHE=$room/cache OMP_NUM_THREADS=1

# Slopes with replicates, bands, profiles and tables with a column of text; then grains with the picture of a sample.
run() {
  local code=0
  "$@" >"$room/log" 2>&1 </dev/null || code=$?
  ((code == 0 || code == 4)) || { cat "$room/log"; echo "ended with $code: $*"; exit 1; }
}
run "$cases/fig08_trigger/fig08_trigger" --engine critical_state --replicates 2 --output "$room/out/fig08"
run "$cases/fig13_k/fig13_k" --engine critical_state --replicates 1 --output "$room/out/fig13"
small=(--set 'packing.lattice=[5, 5, 6]' --set sample.e0_790.tolerance=0.5 --set sample.e0_790.most_trials=1
       --set point.e0_790.final_strain=0.02 --set point.e0_790.picture_strain=0.01 --point e0_790)
run "$cases/fig03_undrained/fig03_undrained" "${small[@]}" --output "$room/out/fig03"
run "$cases/fig03_undrained/fig03_undrained" "${small[@]}" --output "$room/out/fig03" --check
for table in fig08/peaks.dat fig08/RD_ramp_profiles_band.dat fig13/sweep.dat fig03/curves.dat fig03/fig02_during.dat; do
  [[ -s $room/out/$table ]] || { echo "$table was not written"; exit 1; }
done

# What awk finds: the words of the first line, and those of each row.
while IFS= read -r -d '' table; do
  LC_ALL=C awk 'NR == 1 || (!/^#/ && NF) { for (i = 1; i <= NF; ++i) printf "%s%s", $i, i < NF ? "\t" : "\n" }' \
    "$table" >"$table.words"
done < <(find "$room/out" -name '*.dat' ! -path '*/.flowslide/*' -print0)

"$python" - "$room/out" <<'PYTHON'
import csv, pathlib, sys, warnings
import numpy, pandas

warnings.simplefilter("ignore")  # of tables without rows
tables = texts = 0
complaints = []

def same(value, word, rounding):
    try:
        wanted = float(word)
    except ValueError:
        return value == word
    return value == wanted or abs(value - wanted) <= rounding * abs(wanted) or (value != value and wanted != wanted)

for path in sorted(pathlib.Path(sys.argv[1]).rglob("*.dat")):
    with open(str(path) + ".words", newline="") as file:
        names, *rows = csv.reader(file, delimiter="\t", quoting=csv.QUOTE_NONE)
    by_numpy = numpy.atleast_1d(numpy.genfromtxt(path, names=True, dtype=None, encoding="utf-8"))
    by_pandas = pandas.read_csv(path, sep=r"\s+", comment="#")
    to_the_bit = pandas.read_csv(path, sep=r"\s+", comment="#", float_precision="round_trip")
    for reader, found in ("numpy", by_numpy.dtype.names), ("pandas", list(by_pandas.columns)):
        if list(found or ()) != names and (rows or reader == "pandas"):
            complaints.append(f"{path}: {reader} finds the columns {found}, not {names}")
    # By default pandas drops digits: of 0.0001 and larger, the smallest that are written without an exponent, 12 stay.
    for reader, table, rounding in ("numpy", by_numpy, 0), ("pandas", by_pandas, 1e-12), ("pandas", to_the_bit, 0):
        if len(table) != len(rows):
            complaints.append(f"{path}: {reader} finds {len(table)} rows, not {len(rows)}")
            continue
        for i, name in enumerate(names):
            for row, value in zip(rows, table[name] if rows else ()):
                if not same(value, row[i], rounding):
                    complaints.append(f"{path}: {reader} reads {value!r} in column {name}, not {row[i]}")
                    break
    tables += 1
    texts += any(kind == object for kind in by_pandas.dtypes) and len(rows) > 0

print("\n".join(complaints[:20]))
print(f"{tables} tables, {texts} of them with text, {len(complaints)} complaints")
sys.exit(0 if tables > 40 and texts >= 2 and not complaints else 1)
PYTHON
