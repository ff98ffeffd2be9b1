#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# generated_test.sh CASES: the output blocks of all pages are what their scripts print (scripts/fill_outputs), and the
# table of figures in README.md counts the claims as scripts/claims does. CASES is the folder with the built cases.
set -euo pipefail
FLOWSLIDE_CASES=$(cd "$1" && pwd)
export FLOWSLIDE_CASES
cd "$(dirname "$0")/../.."

wrong=0 blocks=0
for page in README.md docs/*.md cases/*/README.md; do
  count=$(grep -c '^<!-- output:' "$page" || true)
  ((count)) || continue
  blocks=$((blocks + count))
  if ! renewed=$(scripts/fill_outputs "$page"); then
    echo "$page: scripts/fill_outputs fails"; wrong=1
  elif ! difference=$(diff "$page" - <<<"$renewed"); then
    echo "$page is not current; scripts/update_readme writes it:"
    head -n 20 <<<"$difference"
    wrong=1
  fi
done
((blocks >= 10)) || { echo "found $blocks output blocks"; wrong=1; }

# Lines "| [N](...) | ... | PAPER | QUICK |" of README.md.
rows=0
while read -r line; do
  figure=$(sed -E 's/^\| \[([0-9]+)\].*/\1/' <<<"$line")
  [[ $figure != 2 ]] || continue   # no claim is about Fig. 2
  rows=$((rows + 1))
  counted=$(scripts/claims figure "$figure")
  [[ $line == *"| $counted |" ]] || { echo "README.md: Fig. $figure has $counted (paper, quick): $line"; wrong=1; }
done < <(grep -E '^\| \[[0-9]+\]\(' README.md)
((rows == 11)) || { echo "README.md: $rows figures with claims, not 11"; wrong=1; }
echo "$blocks blocks, $rows figures"
((wrong == 0))
