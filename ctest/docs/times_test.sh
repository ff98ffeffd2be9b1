#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# times_test.sh CASES: fails when the table of predicted times in README.md is not what the cases predict, or another page
# predicts as well. CASES is the folder with the built cases.
set -euo pipefail
cases=$(cd "$1" && pwd)
cd "$(dirname "$0")/../.."

wrong=0
table=$(sed -n '/^<!-- output:predicted_times -->$/,/^<!-- \/output -->$/{/^<!--/!p}' README.md)
if ! difference=$(diff <(FLOWSLIDE_CASES=$cases scripts/predicted_times) - <<<"$table"); then
  echo "README.md: the predicted times (<) are not those of the table (>); scripts/update_readme writes it:"
  echo "$difference"
  wrong=1
fi
grep -nE '[0-9] h (of|on) one core|\b(s|min|minutes?|hours?) (of|on) one core|[0-9] (s|min|h) by `--list`|^\| time (on one core )?\|' README.md docs/*.md cases/*/README.md &&
  { echo 'these lines give a time of their own; name the table of README.md, or --list, instead'; wrong=1; }
((wrong == 0))
