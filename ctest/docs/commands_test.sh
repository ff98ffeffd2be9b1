#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# commands_test.sh CASES: tries every command that the pages, the comments of the cases' TOML files and the help texts
# name, without a run: a case's with --dry-run (so each key, point, file and value must be there), those of ./reproduce
# with --help behind (so each figure and option must be). CASES is the folder with the built cases.
set -euo pipefail
cases=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
export cases room

# commands_of PAGE: the lines of its fenced blocks and its code spans, one a line.
commands_of() {
  awk '
    /^```/ { fenced = !fenced; next }
    fenced { print; next }
    { text = text " " $0 }
    END { count = split(text, piece, "`"); for (i = 2; i <= count; i += 2) { gsub(/ +/, " ", piece[i]); print piece[i] } }
  ' "$1"
}

# Lines PAGE<TAB>CASE OF THE PAGE<TAB>COMMAND.
collect() {
  local page case
  for page in README.md CONTRIBUTING.md docs/*.md cases/*/README.md; do
    case=$(basename "$(dirname "$page")")
    [[ $page == cases/* ]] || case=fig03_undrained   # of which its options alone are
    commands_of "$page" | sed -e 's/  *#.*//' -e "s|^|$page\t$case\t|"
  done
  for page in cases/*/*.toml; do
    case=$(basename "$(dirname "$page")")
    sed -n 's/^#  *\([a-z0-9_]* --.*\)/\1/p' "$page" | sed "s|^|$page\t$case\t|"
  done
  ./reproduce --help | sed -n 's|^ *\(./reproduce .*\)|./reproduce --help\t-\t\1|p'
  for page in cases/*/case.toml; do
    case=$(basename "$(dirname "$page")")
    "$cases/$case/$case" --help | sed -n "s|^ *\($case .*[^ ]\)   .*|$case --help\t$case\t\1|p"
  done
}

# The run of your own of docs/configuration.md, in the scratch folder.
awk '/^```/ { inside = !inside; next } inside && /^\[sample.mine\]/ { mine = 1 } !inside { mine = 0 } mine' docs/configuration.md |
  sed 's|"[^"]*load.txt"|"'"$room"'/load.txt"|' >"$room/mine.toml"
printf '0 0\n1 500\n' >"$room/load.txt"
cp examples/slope_angle.toml "$room/study.toml"   # that of docs/own-study.md
printf '[loading]\namplitude = "2 kPa"\n' >"$room/other.toml"   # the same page, for a figure of the paper

# What stands for a value of the reader's own in a command.
with_values() { sed -E -e "/own-study/s|--config mine.toml|--config '$room/study.toml'|" -e "s|--config (mine\|other).toml|--config '$room/\1.toml'|" -e 's/ --beside [^ ]+//' -e 's/=E0\b/=0.78/' -e 's/=MU\b/=0.5/' -e 's/"C kg/"0.1 kg/' -e 's/--seed S\b/--seed 1/'; }

# try PAGE CASE COMMAND
try() {
  local page=$1 case=$2 words=() options=() program code=0
  eval "words=($3)"
  [[ ${words[0]} != mpirun ]] || words=("${words[@]:3}")
  if [[ ${words[0]} == ./reproduce && " ${words[*]} " == *' -- '* ]]; then
    case=$(awk -v figure="${words[1]}" '$1 == figure {print $2}' plots/figures.txt)
    while [[ ${words[0]} != -- ]]; do words=("${words[@]:1}"); done
    words=("${words[@]:1}")
  elif [[ ${words[0]} == ./reproduce ]]; then
    "${words[@]}" --help >"$room/log.$$" 2>&1 || { echo "$page: $3"; tail -n 1 "$room/log.$$"; return 1; }
    return 0
  elif [[ ${words[0]} != --* ]]; then
    case=$(basename "${words[0]}")
    words=("${words[@]:1}")
  fi
  while ((${#words[@]})); do
    case ${words[0]} in
      --output) words=("${words[@]:1}") ;;   # with its value: see below
      --help|--dry-run|--list|--json|--check|--prepare|--status|--so-far|--resume|--afresh) ;;
      *) options+=("${words[0]}") ;;
    esac
    words=("${words[@]:1}")
  done
  program=$cases/$case/$case
  [[ -x $program ]] || { echo "$page: $3"; echo "there is no case '$case'"; return 1; }
  "$program" "${options[@]}" --dry-run >"$room/log.$$" 2>&1 || code=$?
  ((code == 0)) || { echo "$page: $3"; tail -n 3 "$room/log.$$"; return 1; }
}
export -f try

# Commands begin with a case or ./reproduce; options alone, with --set, --config or --point, are for the page's case.
names=$(dirname cases/*/case.toml | xargs -n 1 basename | paste -sd '|')
collect | with_values | grep -P "\t(mpirun -np \d+ )?(\./reproduce|(build/release/cases/\w+/)?($names)|--(set|config|point|engine|scale))( |\$)" |
  grep -vP "\t--(set|config|point|engine|scale)\$|\t($names)\$|[()<>;|&\$*]|\.\.\.|FIGURE|CASE|NAME" | sort -t $'\t' -k 2 -u >"$room/commands"
tried=$(wc -l <"$room/commands")
# Three fields of a line are three arguments.
failed=0
tr '\n' '\t' <"$room/commands" | tr '\t' '\0' | xargs -0 -P 8 -n 3 bash -c 'try "$@"' - || failed=1
echo "$tried commands tried"
((tried >= 50 && failed == 0))
