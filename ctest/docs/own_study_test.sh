#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# own_study_test.sh CASES: runs every command of docs/own-study.md, in its order, in a copy of the scripts beside the
# built programs; checks its figures, and that each of its TOML texts is accepted. CASES is the folder with the built
# cases.
set -euo pipefail
cases=$(cd "$1" && pwd)
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
page=$source_dir/docs/own-study.md
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
tree="$room/a clone"
mkdir -p "$tree/build/release" "$tree/cases" "$room/bin"
cp -r "$source_dir"/{reproduce,scripts,plots,examples,packages.txt} "$tree"
ln -s "$cases" "$tree/build/release/cases"
# The set-up does nothing: the programs exist.
printf '#!/bin/sh\nexit 0\n' >"$room/bin/cmake"
printf '#!/bin/sh\necho installed\n' >"$room/bin/dpkg-query"
chmod +x "$room/bin/"*
export PATH="$room/bin:$PATH" FLOWSLIDE_CACHE="$room/cache" OMP_NUM_THREADS=1
cd "$tree"

failures=0 commands=0 texts=0
complain() { echo "$1"; failures=$((failures + 1)); }
# blocks LANGUAGE: the fenced blocks of this language, each ended by a line "---".
blocks() {
  awk -v start='```'"$1" '
    $0 == start { inside = 1; next }
    /^```/ { if (inside) print "---"; inside = 0 }
    inside' "$page"
}

# expect CODE PATTERN COMMAND: its exit code and a pattern in its output, which goes to log.
expect() {
  local code=0
  bash -c "$3" >"$room/log" 2>&1 </dev/null || code=$?
  [[ $code == "$1" ]] && { [[ -z $2 ]] || grep -qe "$2" "$room/log"; } && return
  complain "'$3' ended with $code, expected $1 with '$2':"
  tail -n 5 "$room/log"
}
# check_files: the files that the last command named exist, and its pictures are more than an empty frame.
check_files() {
  local kind file size
  while read -r kind file; do
    size=$(stat -c %s "$file" 2>/dev/null || echo 0)
    [[ $file != *.png ]] || ((size > 60000)) || complain "$file has $size bytes: it is empty"
    ((size > 0)) || complain "$kind $file does not exist"
  done < <(sed -nE 's/^(figure|results|table): +/\1 /p' "$room/log")
}

while IFS= read -r command; do
  [[ $command != --- ]] || continue
  commands=$((commands + 1))
  expect 0 '' "$command"
  check_files
  [[ $command != *' --config '* || $command == *--list* || $command == *--dry-run* ]] ||
    grep -q '^figure: .*study.png' "$room/log" || complain "'$command' names no figure"
done < <(blocks sh)
[[ -s mine.png && -s peak.png ]] || complain 'the plots of the page were not drawn'
for run in RD_3deg RD_4p5deg; do
  [[ -s results/study/quick-mine/$run.h5 ]] || complain "the study of --init has no $run.h5"
done

# Each text is a study, or a change of a figure.
while IFS= read -r line; do
  if [[ $line != --- ]]; then printf '%s\n' "$line" >>text.toml; continue; fi
  texts=$((texts + 1))
  expect 0 '# run ' "build/release/cases/study/study --config text.toml --dry-run"
  rm text.toml
done < <(blocks toml)

# An own file is never overwritten, and wrong input is told.
printf 'mine\n' >kept.toml
expect 2 "'kept.toml' exists" './reproduce study --init kept.toml'
[[ $(<kept.toml) == mine ]] || complain '--init has overwritten a file'
expect 2 'study needs your file: ./reproduce study --config FILE' './reproduce study'
expect 2 "there is no file 'none.toml'" './reproduce study --config none.toml'
mkdir folder
expect 2 "'folder' is a folder; give a TOML file" './reproduce study --config folder'
expect 2 'folder: is a folder, but a TOML file is needed' 'build/release/cases/study/study --config folder'
expect 2 'belongs to study' './reproduce fig13 --init new.toml'
printf '[sweep]\nangel = ["3 deg"]\n' >wrong.toml
expect 2 'did you mean "angle"? allowed: sample, or a key with one value of \[slope\] (angle, ' \
  './reproduce study --config wrong.toml'

# A figure of the paper with other values says so above the figure.
printf 'engine = "critical_state"\nloading.amplitude = "2 kPa"\nstop.end_time = "0.3 s"\n' >other.toml
expect 0 'figure: .*results/fig12_pulse/quick-other/fig12.png' './reproduce fig12 --config other.toml'
grep -q 'loading.amplitude = "2 kPa", not "3 kPa"' results/fig12_pulse/quick-other/changes.txt ||
  complain 'the figure does not tell what was changed'

echo "$commands commands, $texts texts, $failures failures"
((commands >= 10 && texts >= 10 && failures == 0))
