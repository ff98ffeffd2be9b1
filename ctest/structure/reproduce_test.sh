#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Runs ./reproduce in a copy of the scripts, under a path with blanks, with a case that only pretends to compute.
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
tree="$room/a path with blanks"
program="$tree/build/release/cases/fig03_undrained/fig03_undrained"
mkdir -p "$(dirname "$program")" "$room/bin"
cp -r "$source_dir"/{reproduce,scripts,plots,packages.txt} "$tree"
grep -E '^#|fig03_undrained' "$source_dir/plots/figures.txt" >"$tree/plots/figures.txt"   # the one case that it has

# Stand-ins replace the set-up: cmake and gnuplot succeed (gnuplot notes its arguments and prints GNUPLOT_SAYS), and all
# packages are there.
for command in cmake gnuplot; do
  printf '#!/bin/sh\necho "%s $*" >>"%s/calls"\n' "$command" "$room" >"$room/bin/$command"
done
echo 'printf %s "${GNUPLOT_SAYS-}" >&2' >>"$room/bin/gnuplot"
printf '#!/bin/sh\necho installed\n' >"$room/bin/dpkg-query"
# The case: two points of figure 3, one of figure 4. FAIL_POINT and CHECK_CODE choose how it ends.
cat >"$program" <<'CASE'
#!/usr/bin/env bash
point='' action=run
while (($#)); do
  case $1 in
    --point) point+="$2 "; shift ;;
    --output) folder=$2; shift ;;
    --list|--check|--status) action=${1#--} ;;
  esac
  shift
done
case $action in
  list) echo '{"points": [{"name": "a", "figures": ["3"], "predicted_seconds": 1.5},
    {"name": "b", "figures": ["2", "3"], "predicted_seconds": 2e1},
    {"predicted_seconds": 7, "figures": ["4"], "name": "c"}]}' ;;
  status) cat "$folder/.flowslide/status" ;;
  check) echo "claims of ${point}checked"; exit "${CHECK_CODE:-0}" ;;
  run)
    mkdir -p "$folder"
    if [[ -n ${SLOW-} ]]; then
      trap 'echo "$point" >>"$folder/interrupted"; exit 130' INT
      echo "$point" >>"$folder/started"
      while :; do sleep 0.1; done
    fi
    [[ " $point" != " ${FAIL_POINT-} " ]] || { echo "point $point: the sample does not hold its stress" >&2; exit 3; }
    echo "$point" >>"$folder/run"
    : >"$folder/${point% }.h5" ;;
esac
CASE
chmod +x "$room"/bin/* "$program"
export PATH="$room/bin:$PATH"

failures=0
# expect CODE PATTERN ARGUMENTS...: exit code and a pattern in the output of ./reproduce ARGUMENTS.
expect() {
  local code=0 wanted=$1 pattern=$2 output
  shift 2
  output=$("$tree/reproduce" "$@" 2>&1) || code=$?
  if [[ $code != "$wanted" ]] || ! grep -q -e "$pattern" <<<"$output"; then
    printf 'reproduce %s: exit code %s, expected %s with "%s":\n%s\n' "$*" "$code" "$wanted" "$pattern" "$output"
    failures=$((failures + 1))
  fi
}
# expect_file FILE CONTENT: the sorted lines of a file of the results.
expect_file() {
  local content
  content=$(sort "$tree/results/fig03_undrained/$1" 2>/dev/null | paste -sd ' ' | tr -s ' ')
  [[ $content == "$2" ]] || { echo "$1 holds '$content', expected '$2'"; failures=$((failures + 1)); }
}

cd /
expect 2 "unknown figure 'fig99'; there are: fig02 fig02_sample fig03 fig04" fig99
expect 2 "unknown option '--fast'" --fast
expect 2 "scale is 'huge'; allowed: quick, paper" --scale huge
expect 2 "jobs is '0'; allowed" --jobs 0
expect 2 "needs a value" fig03 --output
expect 0 'fig03 *22 s' --list --jobs 1
[[ ! -e $room/calls ]] || { echo "--list called: $(cat "$room/calls")"; failures=$((failures + 1)); }
mkdir -p "$tree/results/fig03_undrained/other" "$tree/results/fig03_undrained/empty"
echo '{"points": 2, "recorded": 2, "predicted_seconds": 10.0, "processor_seconds": 15.0}' >"$tree/results/fig03_undrained/other/cost.json"
echo '{"points": 1, "recorded": 0, "predicted_seconds": 0.0, "processor_seconds": 0.0}' >"$tree/results/fig03_undrained/empty/cost.json"
expect 0 'as fast as the results here' --list --jobs 1
expect 0 'fig03 *33 s' --list --jobs 1   # 1.5 times 21.5 s, which is rounded to 22
rm -r "$tree/results"
mv "$program" "$program.away"
expect 1 'fig03_undrained was not built; ./reproduce --build builds it' --list
[[ ! -e $room/calls ]] || { echo "--list called: $(cat "$room/calls")"; failures=$((failures + 1)); }
mv "$program.away" "$program"
expect 0 'build into build/release' --build
grep -q 'cmake --build' "$room/calls" || { echo '--build did not build'; failures=$((failures + 1)); }
expect 0 'fig03 *20 s' --list --jobs 2
expect 0 'fig02_sample *20 s' fig02_sample --list --jobs 1
# In a locale with a decimal comma, too. The file is what localedef makes of decimal_point "," and nothing else.
mkdir -p "$room/locales/comma"
printf '\024\021\003\040\006\000\000\000\040\000\000\000\042\000\000\000\044\000\000\000\050\000\000\000\054\000\000\000\060\000\000\000,\000.\000\003\003\000\000,\000\000\000.\000\000\000UTF-8\000' \
  >"$room/locales/comma/LC_NUMERIC"
LOCPATH="$room/locales" LC_ALL='' LC_NUMERIC=comma expect 0 'fig03 *22 s' --list --jobs 1
expect 0 'claims of b a checked' fig03
expect_file quick/run 'a b '
expect 0 'claims of b c a checked' --scale=paper
expect_file paper/run 'a b c '
expect 0 "figure:  $tree/results/fig03_undrained/quick-seed7/fig04.pdf" fig04 --seed 7
expect_file quick-seed7/run 'c '
expect 0 "results: $room/here/c.h5" fig04 --output "$room/here"
GNUPLOT_SAYS='warning: no column with header "velocity"' expect 2 'fig04: a table lacks a column' fig04
GNUPLOT_SAYS='warning: something else' expect 0 'warning: something else' fig04
CHECK_CODE=4 expect 4 'figure: .*fig03.png' fig03 --output "$room/claims"
FAIL_POINT=b expect 3 'does not hold its stress' fig03 --output "$room/failed"
grep -q 'failed/fig03' "$room/calls" && { echo 'a figure was drawn from a failed run'; failures=$((failures + 1)); }

# Results of another configuration: one message for all runs, before the first of them.
other="$room/other"
mkdir -p "$other/.flowslide"
echo fig03_undrained >"$other/.flowslide/case"
echo '{"points": [{"name": "a", "state": "complete", "place": ""},
  {"name": "b", "state": "outdated", "place": "slope.angle = 4 there, 5 now"}]}' >"$other/.flowslide/status"
expect 2 '1 of 2 runs in .*/other were made with other settings.*(b: slope.angle = 4 there, 5 now); choose another' \
  fig03 --output "$other"
[[ ! -e $other/run ]] || { echo 'a run was begun beside results of another configuration'; failures=$((failures + 1)); }
expect 0 'all runs done (below 1 s)\|all runs done ([1-9] s)' fig03 --output "$other" -- --afresh

# An interrupt reaches every point, and reproduce ends with 130 only after them.
SLOW=yes env --default-signal=INT "$tree/reproduce" fig03 --jobs 2 --scale paper --seed 1 >"$room/log" 2>&1 &
waiting=$!
started="$tree/results/fig03_undrained/paper-seed1/started"
for _ in {1..100}; do [[ $(wc -l 2>/dev/null <"$started") == 2 ]] && break; sleep 0.1; done
kill -INT "$waiting"
code=0
wait "$waiting" || code=$?
[[ $code == 130 ]] || { echo "interrupted reproduce ended with $code:"; cat "$room/log"; failures=$((failures + 1)); }
expect_file paper-seed1/interrupted 'a b '

echo "$failures failures"
((failures == 0))
