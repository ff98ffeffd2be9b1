#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# every_case_test.sh BUILD_FOLDER: each case with each engine that its --help offers, for all that can be done with its
# results: run, --check, --status, --so-far, ./reproduce --collect with the figures. Closed-form samples run the whole
# case; engines of grains run the cheapest point on a small sample.
set -euo pipefail
build=$(cd "$1" && pwd)
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
export FLOWSLIDE_CACHE=$room/cache OMP_NUM_THREADS=1

# A copy of the scripts beside the built programs. Its set-up does nothing.
tree="$room/a project"
mkdir -p "$tree/build/release" "$room/bin"
cp -r "$source_dir"/{reproduce,scripts,plots,packages.txt} "$tree"
ln -s "$build/cases" "$tree/build/release/cases"
printf '#!/bin/sh\nexit 0\n' >"$room/bin/cmake"
printf '#!/bin/sh\necho installed\n' >"$room/bin/dpkg-query"
chmod +x "$room/bin/"*
export PATH="$room/bin:$PATH"

# engines_of PROGRAM: prints the engines that its --help offers.
engines_of() { "$1" --help | tr -s '\n ' ' ' | sed 's/.*moves the grains: \([^;]*\);.*/\1/' | tr -d ' ' | tr ',' '\n'; }
is_closed_form() { [[ $1 == elastic || $1 == critical_state ]]; }

# settings_for PROGRAM ENGINE: the cheapest point on 150 grains, cut short; one replicate of all on a closed-form sample.
settings_for() {
  local program=$1 engine=$2 point sample test small=()
  ! is_closed_form "$engine" || { printf '%s\n' --replicates 1; return; }
  ! "$program" --dry-run | grep -q '^packing.lattice' || small=(--set 'packing.lattice=[5, 5, 6]')
  # Of each point: seconds, name, sample without its seed, and "alone" for a test of the sample without a slope.
  IFS='|' read -r _ point sample test < <("$program" --engine "$engine" "${small[@]}" --list --json |
    jq -r '.points[] | "\(.predicted_seconds)|\(.name)|\(.sample)|\(.description)"' |
    sed 's/_seed[0-9]*|/|/' | sort -t '|' -n -s)
  printf '%s\n' --point "$point"
  [[ -n $sample ]] || return 0
  printf '%s\n' "${small[@]}" --set "sample.$sample.tolerance=0.3"
  if [[ $test == *' to '*' %'* ]]; then printf '%s\n' --set "point.${point%_r[0-9]*}.final_strain=0.001 %"
  elif [[ $program == */study ]]; then printf '%s\n' --set 'stop.end_time=20 ms'   # it has no tables of points
  else printf '%s\n' --set "point.${point%_r[0-9]*}.stop.end_time=20 ms"; fi
}

# sweep CASE ENGINE: prints the faults.
sweep() {
  local name=$1 engine=$2 program="$build/cases/$1/$1" folder="$room/out put/$1/$2" log="$room/$1.$2.log" options=() code
  [[ $("$program" --engine "$engine" --dry-run 2>&1 || true) != *'this build has no engine'* ]] || return 0
  mapfile -t options < <(settings_for "$program" "$engine")
  options=(--engine "$engine" "${options[@]}")
  # expect CODES COMMAND...
  expect() {
    code=0
    "${@:2}" >"$log" 2>&1 </dev/null || code=$?
    [[ " $1 " == *" $code "* ]] || { echo "$name, $engine: ended with $code, not $1: ${*:2}"; tail -n 5 "$log"; }
  }
  expect '0 4' "$program" "${options[@]}" --output "$folder"
  is_closed_form "$engine" || expect '0 4' "$program" "${options[@]}" --output "$folder" --check   # --collect does it
  expect 0 "$program" "${options[@]}" --output "$folder" --status
  grep -q complete "$log" || echo "$name, $engine: --status knows no complete run"
  expect 0 "$program" "${options[@]}" --output "$folder" --so-far
  [[ -n $(find "$folder/so_far" -name '*.h5') ]] || echo "$name, $engine: --so-far copied nothing"
  is_closed_form "$engine" || return 0
  mapfile -t figures < <(awk -v name="$name" '$2 == name {print $1}' "$source_dir/plots/figures.txt")
  expect '0 4' "$tree/reproduce" "${figures[@]}" --collect --output "$folder" -- "${options[@]}"
  for figure in "${figures[@]}"; do
    [[ -s $folder/$figure.png && -s $folder/$figure.pdf ]] || echo "$name, $engine: $figure was not drawn"
  done
}

for program in "$build"/cases/*/*; do
  [[ -x $program && -f $program ]] || continue
  for engine in $(engines_of "$program"); do printf '%s %s\n' "$(basename "$program")" "$engine"; done
# Engine by engine: two runs of one case side by side would wait for each other's sample.
done | sort -s -k 2,2 >"$room/pairs"
export build room source_dir tree
export -f sweep settings_for is_closed_form
xargs -a "$room/pairs" -L 1 -P 2 bash -c 'set -euo pipefail; sweep "$@"' sweep >"$room/complaints" 2>&1 ||
  echo 'a pair ended with an error' >>"$room/complaints"
cat "$room/complaints"
echo "$(wc -l <"$room/pairs") pairs of case and engine"
[[ -s $room/pairs && ! -s $room/complaints ]]
