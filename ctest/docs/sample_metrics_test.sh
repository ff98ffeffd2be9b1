#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# scripts/sample_metrics prints a row a curve with the values of its samples, and refuses a metric that no run has.
set -euo pipefail
export LC_ALL=C.UTF-8
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
die() { echo "sample_metrics_test: $1" >&2; exit 1; }

printf '%s\n' 'run metric value' '# column 1: run' 'RD_1e-3 peak 5495.4' 'RD_1e-3 share 0.00123' 'RD_1e-3_r2 peak 5321' \
  'RD_1e-3 peak.median 1' 'RI peak 1.2e6' '- growth 2' >"$scratch/metrics.dat"
printf '%s\n' 'run curve scale grains' '# column 1: run' 'RD_1e-3 RD_1e-3 paper 8800' 'RD_1e-3_r2 RD_1e-3 paper 8800' \
  'RI RI paper 8800' >"$scratch/runs.dat"

expect() {
  local found
  found=$("$root/scripts/sample_metrics" "$scratch" "${@:2}")
  [[ $found == "$1" ]] || die "${*:2}: found
$found
in place of
$1"
}
expect '| run | peak (kPa) | share (%) |
|---|---|---|
| RD_1e-3 | 5.5, 5.32 | 0.123, - |
| RI | 1200 | - |' peak:kPa share:%
expect '| run | peak |
|---|---|
| RI | 1200000 |' peak --curves 'RI*'

for wrong in growth none; do
  code=0
  message=$("$root/scripts/sample_metrics" "$scratch" "$wrong" 2>&1 >/dev/null) || code=$?
  [[ $code == 1 && $message == *"no run has the metric $wrong"* ]] || die "$wrong: exit code $code, '$message'"
done
code=0
message=$("$root/scripts/sample_metrics" no_such_case peak 2>&1 >/dev/null) || code=$?
[[ $code == 1 && $message == *'neither a folder nor a case'* ]] || die "a case that is not there: exit code $code, '$message'"
for wrong in 'XX*' 'R+|RI'; do
  code=0
  message=$("$root/scripts/sample_metrics" "$scratch" peak --curves "$wrong" 2>&1 >/dev/null) || code=$?
  [[ $code == 1 && $message == *'no curve fits --curves; there are RD_1e-3 RI'* ]] || die "--curves $wrong: exit code $code, '$message'"
done
