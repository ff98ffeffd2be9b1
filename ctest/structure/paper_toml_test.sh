#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# paper_toml_test.sh BUILD_FOLDER: each line of cases/paper.toml holds for at least one case at one scale, by --dry-run
# with the engines that read other tables. A line that never holds is a misspelling or dead, unless a scale of the file
# stands for it: the lines outside [scale] say what the paper has.
set -euo pipefail
build=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."
export FLOWSLIDE_CACHE=/nonexistent

used=$(for file in cases/*/case.toml; do
  case=$(basename "$(dirname "$file")")
  for scale in quick paper; do
    for engine in "" "--engine elastic" "--engine critical_state"; do
      # shellcheck disable=SC2086  # no word without an engine
      "$build/cases/$case/$case" --scale "$scale" $engine --dry-run 2>/dev/null || true
    done
  done
done | sed -n 's|.* # cases/paper.toml:\([0-9]*\)$|\1|p' | sort -un)
keys=$(awk '/^\[/ { table = substr($1, 2, length($1) - 2) "."; in_scale = table ~ /^scale/ }
            /^[a-z0-9_.]* = / { if (in_scale) { print NR; delete line[$1] } else line[table $1] = NR }
            END { for (key in line) print line[key] }' cases/paper.toml)
[[ $(wc -w <<<"$keys") -gt 50 ]] || { echo "FAILED: found $(wc -w <<<"$keys") keys in cases/paper.toml"; exit 1; }
unused=$(comm -23 <(sort <<<"$keys") <(sort <<<"$used"))
for line in $unused; do echo "cases/paper.toml:$line: no case has this value: $(sed -n "${line}p" cases/paper.toml)"; done
[[ -z $unused ]] || { echo FAILED; exit 1; }
echo PASSED
