#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# exit_codes_test.sh PROGRAM MPIRUN...: each rank of PROGRAM returns the code of the one that failed.
set -euo pipefail
program=$1
shift
launch=("$@")
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
export RESTARTABLE_CASE=$room FLOWSLIDE_CACHE=$room/cache
cat "$(dirname "$0")/../support/slide_case.toml" - >"$room/case.toml" <<'CASE'
[scale.quick]
replicates = 1
stop.end_time = "0.1 s"
[scale.paper]
CASE
: >"$room/claims.toml"

# rank FILE PROGRAM OPTIONS...: one rank, which writes its code to FILE.<rank>. mpirun ends the other ranks when one has
# ended with a code: each waits until both are written.
cat >"$room/rank" <<'RANK'
file=$1
shift
code=0
"$@" || code=$?
echo "$code" >"$file.$OMPI_COMM_WORLD_RANK"
for _ in {1..200}; do [[ -e $file.0 && -e $file.1 ]] && break; sleep 0.05; done
exit "$code"
RANK

failures=0
# expect CODE PATTERN OPTIONS...: checks the exit codes of both ranks and of mpirun, and the message.
expect() {
  local wanted=$1 pattern=$2 code=0 codes
  shift 2
  "${launch[@]}" bash "$room/rank" "$room/code" "$program" "$@" >"$room/said" 2>&1 || code=$?
  codes="$code $(cat "$room/code.0" "$room/code.1" | paste -sd ' ')"
  rm -f "$room"/code.*
  if [[ $codes != "$wanted $wanted $wanted" ]] || ! grep -q -e "$pattern" "$room/said"; then
    printf '%s: codes of mpirun and its ranks %s, expected %s with "%s":\n' "$*" "$codes" "$wanted" "$pattern"
    cat "$room/said"
    failures=$((failures + 1))
  fi
}

expect 0 RD --list
expect 0 '' --output "$room/out" --point RD
expect 2 'the key "sloope.angle"\|sloope' --output "$room/out" --set sloope.angle='4 deg'
: >"$room/file"
expect 2 "$room/file" --output "$room/file" --point RD   # found by the first rank alone
expect 3 'the slide is not finite' --output "$room/wild" --point RD --allow-unstable --set 'coupling.time_step=0.1 s' \
  --set 'stop.end_time=1e6 s' --set rows.row_strain=1e6
expect 75 'out of the time given' --output "$room/late" --point RD --max-walltime '1 us'

echo "$failures failures"
((failures == 0))
