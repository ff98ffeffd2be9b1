#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# results_test.sh CASES: runs the Python blocks of docs/results.md on a result that the case fig12_pulse has just written.
# scripts/table_checksums has a line for each of its tables, and another for a changed row, but not for a changed comment.
# CASES is the folder with the built cases.
set -euo pipefail
cases=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
root=$PWD page=$PWD/docs/results.md
# Debian's packages belong to /usr/bin/python3; another python3 may stand before it.
python=''
for candidate in python3 /usr/bin/python3; do
  [[ -n $python ]] || ! "$candidate" -c 'import h5py, h5netcdf, pandas, xarray' 2>/dev/null || python=$candidate
done
[[ -n $python ]] || { echo 'skipped: python3-h5py, -xarray, -h5netcdf or -pandas is not installed (packages-full.txt)'; exit 77; }
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
export FLOWSLIDE_CACHE=$room/cache OMP_NUM_THREADS=1
cd "$room"

code=0
"$cases/fig12_pulse/fig12_pulse" --engine critical_state --replicates 1 --output results/fig12_pulse/quick >log 2>&1 || code=$?
((code == 0 || code == 4)) || { cat log; exit 1; }
checksums=$root/scripts/table_checksums
"$checksums" results/fig12_pulse/quick >before
(($(wc -l <before) == $(find results/fig12_pulse/quick -maxdepth 1 -name '*.dat' | wc -l))) || { echo 'a table has no checksum'; exit 1; }
echo '# another revision' >>results/fig12_pulse/quick/RD_3kPa.dat
"$checksums" results/fig12_pulse/quick | diff -q before - || { echo 'a comment changes a checksum'; exit 1; }
cp results/fig12_pulse/quick/RD_3kPa.dat kept.dat
sed -i '$s/$/\n0 0/' results/fig12_pulse/quick/RD_3kPa.dat
! "$checksums" results/fig12_pulse/quick | diff -q before - >/dev/null || { echo 'a row does not change a checksum'; exit 1; }
mv kept.dat results/fig12_pulse/quick/RD_3kPa.dat

awk '/^```python$/ { inside = 1; ++count; next } /^```$/ { inside = 0 } inside { print >("block_" count ".py") }' "$page"
blocks=0
for block in block_*.py; do
  said=$("$python" "$block" 2>&1) || { echo "docs/results.md, block $block fails:"; echo "$said"; exit 1; }
  [[ -n $said ]] || { echo "docs/results.md, block $block prints nothing"; exit 1; }
  echo "$said"
  blocks=$((blocks + 1))
done
((blocks == 3)) || { echo "docs/results.md has $blocks blocks, not 3"; exit 1; }
