# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash
# The points of a case: which there are, how long they take, and running them side by side. Sourced by ./reproduce.

# points_of PROGRAM FIGURES OPTIONS...: lines `name<TAB>predicted seconds`, longest first, of the points that belong to
# one of FIGURES (one a line). A name like fig03 or fig03_more picks the points of the paper's figure 3, any other name all
# points.
points_of() {
  local program=$1 figures=$2 listing
  shift 2
  [[ -x $program ]] || die "flowslide: $program was not built; ./reproduce --build builds it" 1
  listing=$("$program" "$@" --list --json) || return
  # The listing is {"points": [{"name": "...", "figures": ["3", ...], "predicted_seconds": 1.5, ...}, ...]}.
  jq -r --arg wanted "$figures" '
    ($wanted | split("\n") | map(select(. != ""))) as $names
    | [$names[] | capture("^fig0*(?<number>[0-9]+)(_|$)").number] as $numbers
    | .points[]
    | select(($numbers | length) < ($names | length) or any(.figures[]; IN($numbers[])))
    | "\(.name)\t\(.predicted_seconds)"' <<<"$listing" | sort -t "$(printf '\t')" -k 2,2gr
}

# wall_time JOBS: seconds that the points on stdin take when JOBS run side by side, in their order.
wall_time() {
  awk -F '\t' -v jobs="$1" '
    { least = 1; for (i = 2; i <= jobs; ++i) if (busy[i] < busy[least]) least = i; busy[least] += $2 }
    END { for (i in busy) if (busy[i] > wall) wall = busy[i]; printf "%.0f\n", wall }'
}

# duration SECONDS: "45 s", "3 min", "2.5 h".
duration() {
  awk -v s="$1" 'BEGIN { if (s < 100) printf "%.0f s", s; else if (s < 6000) printf "%.0f min", s / 60;
                         else printf "%.1f h", s / 3600 }'
}

# Runs one point; called by xargs. Its exit code goes to $scratch/POINT, where run_points finds it.
run_point() {
  local code=0
  # Through a pipe, so that programs side by side write whole lines now and then instead of one line that each rewrites.
  { "${@:2}" --point "$1" </dev/null 2>&1 1>&3 | (trap '' INT TERM; exec sed -u "s/^/$clear_line/" >&2); } 3>&1 || code=$?
  echo "$code" >"$scratch/$1"
}
export -f run_point

# progress_line NAME POINTS PREDICTED STARTED: how many points are done, and the time left by the prediction.
progress_line() {
  local left=$(($3 - SECONDS + $4)) done_points
  done_points=$(find "$scratch" -type f | wc -l)
  printf '%s: %d of %d points done, %s' "$1" "$done_points" "$(wc -l <<<"$2")" \
    "$( ((left > 0)) && echo "about $(duration "$left") left" || echo "longer than predicted: samples are being prepared")"
}

# run_points NAME POINTS JOBS COMMAND...: runs COMMAND --point POINT for each, JOBS side by side. Exits with the code of
# the first that failed. Ctrl-C or TERM ends them all (130): first as they wish, the second time at once.
run_points() {
  local name=$1 points=$2 jobs=$3 group started=$SECONDS predicted point code
  shift 3
  [[ -n $points ]] || die "reproduce: $name lists no point for these figures" 3
  predicted=$(wall_time "$jobs" <<<"$points")
  scratch=$(mktemp -d) clear_line=''
  [[ ! -t 2 ]] || clear_line=$'\r\033[K'
  export scratch clear_line
  trap 'rm -rf "$scratch"' EXIT
  say "$name: $(wc -l <<<"$points") points, $jobs at a time, predicted $(duration "$predicted")"

  set -m   # a process group of its own, which a signal reaches as a whole
  cut -f 1 <<<"$points" | tr '\n' '\0' |
    xargs -0 -P "$jobs" -I '{}' bash -c 'set -o pipefail; run_point "$@"' - '{}' "$@" &
  group=$(jobs -p %%)
  set +m
  # shellcheck disable=SC2064  # group is known now
  trap "stop_points $group" INT TERM

  while kill -0 -- "-$group" 2>/dev/null; do
    [[ ! -t 2 ]] || printf '%s%s' "$clear_line" "$(progress_line "$name" "$points" "$predicted" "$started")" >&2
    sleep 1
  done
  trap - INT TERM
  printf '%s' "$clear_line" >&2
  wait || true

  while IFS=$'\t' read -r point _; do
    code=$(cat "$scratch/$point" 2>/dev/null || echo 3)
    ((code == 0)) || die "reproduce: point $point of $name ended with exit code $code; no figure is drawn" "$code"
  done <<<"$points"
  rm -r "$scratch"
  say "$name: all points done in $(duration $((SECONDS - started)))"
}

stop_points() {
  say ''
  say 'reproduce: stopping the points that run; once more ends them at once'
  trap 'kill -KILL -- "-'"$1"'" 2>/dev/null; exit 130' INT TERM
  kill -INT -- "-$1" 2>/dev/null
  while kill -0 -- "-$1" 2>/dev/null; do sleep 0.2; done
  exit 130
}
