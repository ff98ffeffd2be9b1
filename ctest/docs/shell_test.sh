#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# shell_test.sh CASES: the man pages hold the help texts, and bash completes figures, options and runs. CASES is the folder
# with the built cases.
set -euo pipefail
FLOWSLIDE_CASES=$(cd "$1" && pwd)
export FLOWSLIDE_CASES
cd "$(dirname "$0")/../.."
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT

wrong=0
scripts/man_pages "$room"
for name in reproduce check fig12_pulse; do
  [[ -s $room/man1/$name.1 ]] || { echo "there is no man page of $name"; wrong=1; }
done
if command -v nroff >/dev/null; then
  said=$(nroff -man -Tutf8 -ww "$room/man1/fig12_pulse.1" 2>&1)
  [[ $said == *--max-walltime* ]] || { echo 'the man page of fig12_pulse lacks --max-walltime'; wrong=1; }
fi

# completes WORDS... WANTED: the last of WORDS, to be completed, has WANTED among its completions.
completes() {
  local wanted=${*: -1}
  COMP_WORDS=("${@:1:$#-1}")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  COMPREPLY=()
  _flowslide "$1" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
  [[ " ${COMPREPLY[*]} " == *" $wanted "* ]] || { echo "'${COMP_WORDS[*]}' does not complete to $wanted, but: ${COMPREPLY[*]}"; wrong=1; }
}
# shellcheck source=scripts/completion.bash
source scripts/completion.bash
completes ./reproduce fig1 fig12
completes ./reproduce fig12 --sc --scale
completes ./reproduce fig12 --scale p paper
completes ./check --f --full
completes "$FLOWSLIDE_CASES/fig12_pulse/fig12_pulse" --max --max-walltime
completes "$FLOWSLIDE_CASES/fig12_pulse/fig12_pulse" --point RI RI_3kPa
((wrong == 0))
