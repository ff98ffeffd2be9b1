# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash
# The runs ("points") of a case: lists them, predicts their time, and runs them side by side. Sourced by ./reproduce.

# points_of PROGRAM FIGURES OPTIONS...: prints lines `name<TAB>predicted seconds`, longest first, for the runs that
# belong to one of FIGURES (one figure per line). A name like fig03 or fig03_more selects the runs of figure 3 of the
# paper. Any other name selects all runs.
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

# wall_time JOBS: prints the wall time in seconds for the runs on stdin, in their order, JOBS at a time.
wall_time() {
  awk -F '\t' -v jobs="$1" '
    { least = 1; for (i = 2; i <= jobs; ++i) if (busy[i] < busy[least]) least = i; busy[least] += $2 }
    END { for (i in busy) if (busy[i] > wall) wall = busy[i]; printf "%.0f\n", wall }'
}

# duration SECONDS: prints "45 s", "3 min" or "2.5 h"; "below 1 s" for less than half a second.
duration() {
  awk -v s="$1" 'BEGIN { if (s < 0.5) printf "below 1 s"; else if (s < 100) printf "%.0f s", s; else if (s < 6000) printf "%.0f min", s / 60;
                         else printf "%.1f h", s / 3600 }'
}

# run_point COMMAND... POINT: runs one point and writes its exit code to $scratch/POINT for run_points. Called by xargs.
run_point() {
  local code=0 point=${!#}
  # stderr goes through a pipe: a program then writes whole lines from time to time and does not rewrite one line.
  { "${@:1:$#-1}" --point "$point" </dev/null 2>&1 1>&3 | (trap '' INT TERM; exec sed -u "s/^/$clear_line/" >&2); } 3>&1 || code=$?
  echo "$code" >"$scratch/$point"
}
export -f run_point

# refuse_other_results NAME FOLDER PROGRAM OPTIONS...: ends with 2 if FOLDER has results of these runs that were made with
# other settings. One message for all runs: each of them would refuse its own.
refuse_other_results() {
  local name=$1 folder=$2 standing message
  shift 2
  [[ -e $folder/.flowslide/case && " $* " != *' --afresh '* ]] || return 0
  standing=$("$@" --status --json 2>/dev/null) || return 0   # the first run says what is wrong
  message=$(jq -r --arg folder "$folder" '
    [.points[] | select(.state == "outdated")] as $others
    | if ($others | length) == 0 then empty else
      "\($others | length) of \(.points | length) runs in \($folder) were made with other settings, and are not " +
      "overwritten (\($others[0].name): \($others[0].place))" end' <<<"$standing")
  [[ -z $message ]] || die "reproduce: $name: $message; choose another folder with --output DIR, or run these again with \
-- --afresh, which deletes their results"
}

# progress_line NAME POINTS PREDICTED STARTED: prints the number of runs done and the predicted time left.
progress_line() {
  local left=$(($3 - SECONDS + $4)) done_points
  done_points=$(find "$scratch" -type f | wc -l)
  printf '%s: %d of %d runs done, %s' "$1" "$done_points" "$(wc -l <<<"$2")" \
    "$( ((left > 0)) && echo "about $(duration "$left") left" || echo "longer than predicted; samples may be prepared")"
}

# run_points NAME POINTS JOBS COMMAND...: runs COMMAND --point POINT for each point, JOBS at a time. If runs fail, exits
# with the code of the first of them in the list. The first Ctrl-C or TERM interrupts all runs, which may write
# checkpoints; the second kills them. Both exit with 130.
run_points() {
  local name=$1 points=$2 jobs=$3 group started=$SECONDS predicted point code
  shift 3
  [[ -n $points ]] || die "reproduce: $name lists no run for these figures" 2
  predicted=$(wall_time "$jobs" <<<"$points")
  scratch=$(mktemp -d) clear_line=''
  [[ ! -t 2 ]] || clear_line=$'\r\033[K'
  export scratch clear_line
  trap 'rm -rf "$scratch"' EXIT
  say "$name: $(wc -l <<<"$points") runs, $jobs at a time, predicted $(duration "$predicted")"

  set -m   # the runs get a process group of their own, so one signal reaches all of them
  cut -f 1 <<<"$points" | tr '\n' '\0' |
    xargs -0 -P "$jobs" -n 1 bash -c 'set -o pipefail; run_point "$@"' - "$@" &
  group=$(jobs -p %%)
  set +m
  # shellcheck disable=SC2064  # $group must expand now
  trap "stop_points $group" INT TERM HUP

  while kill -0 -- "-$group" 2>/dev/null; do
    [[ ! -t 2 ]] || printf '%s%s' "$clear_line" "$(progress_line "$name" "$points" "$predicted" "$started")" >&2
    sleep 1
  done
  trap - INT TERM HUP
  printf '%s' "$clear_line" >&2
  wait || true

  while IFS=$'\t' read -r point _; do
    code=$(cat "$scratch/$point" 2>/dev/null) || code=''
    [[ -n $code ]] || code=1   # killed, or no space for its code
    ((code == 0)) || die "reproduce: run $point of $name ended with exit code $code; no figure is plotted" "$code"
  done <<<"$points"
  rm -r "$scratch"
  say "$name: all runs done ($(duration $((SECONDS - started))))"
}

stop_points() {
  say ''
  say 'reproduce: stopping the runs; press Ctrl-C again to end them at once'
  trap 'kill -KILL -- "-'"$1"'" 2>/dev/null; exit 130' INT TERM
  kill -INT -- "-$1" 2>/dev/null
  while kill -0 -- "-$1" 2>/dev/null; do sleep 0.2; done
  exit 130
}
