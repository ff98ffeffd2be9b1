#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# scripts/compare_runs finds the peak, the difference before it and the means after it, and refuses other rows.
set -euo pipefail
export LC_ALL=C.UTF-8
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
die() { echo "compare_runs_test: $1" >&2; exit 1; }

# table SHIFT LATER: a test whose tau is larger by SHIFT before the peak and whose sigma is LATER beyond 2 % strain.
table() {
  printf '%s\n' 'time shear_strain shear_stress normal_stress' '# case: none'
  printf '%s\n' '0 0 0 1000' "1 0.005 $((200 + $1)) 900" '2 0.01 400 800' '3 0.015 300 700' '4 0.02 200 600'
  printf '%s\n' "5 0.025 10 $2" "6 0.03 10 $2" "7 0.035 10 $2" "8 0.04 10 $2"
}
table 0 50 >"$scratch/first.dat"
table 4 60 >"$scratch/second.dat"

found=$("$root/scripts/compare_runs" "$scratch/first.dat" "$scratch/second.dat")
for expected in 'first.dat: peak of tau 400 Pa at 1 % shear strain' \
                'up to the peak (3 rows): tau 0.01 of the peak, sigma 0 of the first sigma' \
                'tau differs by more than 1e-03 of the peak from 0.5 % shear strain on' \
                '5 to 6 s: tau 10, 10; sigma 50, 60'; do
  [[ $found == *"$expected"* ]] || die "'$expected' is not in: $found"
done

sed -i '/^1 /d' "$scratch/second.dat"
code=0
message=$("$root/scripts/compare_runs" "$scratch/first.dat" "$scratch/second.dat" 2>&1 >"$scratch/out") || code=$?
((code == 1)) || die "other rows: exit code $code in place of 1"
[[ $message == *'row 2 is at another time'* ]] || die "no word of the other rows: $message"
