# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash
# Completion in bash: source scripts/completion.bash. Completes figures and options of ./reproduce, options of ./check, and
# options of a case, all from their --help. After --point it completes the runs of a case.

_flowslide() {
  local program=$1 word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} words=''
  case $before in
    --scale) words='quick paper' ;;
    --engine) words='native native-mixed liggghts liggghts-stock elastic critical_state' ;;
    --point) words=$("$program" --list 2>/dev/null | cut -f 1 | grep -v '^#') ;;
    --output|--beside|--config) mapfile -t COMPREPLY < <(compgen -f -- "$word"); return ;;
    *)
      words=$("$program" --help 2>/dev/null | grep -oE '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+')
      [[ ${program##*/} != reproduce ]] ||
        words+=" $("$program" --help 2>/dev/null | sed -n '/The figures are:/,/^$/s/^  \([a-z0-9_]*\) .*/\1/p')" ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}

complete -F _flowslide ./reproduce reproduce ./check
for _flowslide_case in "$(dirname "${BASH_SOURCE[0]}")"/../cases/*/case.toml; do
  _flowslide_case=$(basename "$(dirname "$_flowslide_case")")
  complete -F _flowslide "$_flowslide_case" "build/release/cases/$_flowslide_case/$_flowslide_case"
done
unset _flowslide_case
