#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# snakemake_test.sh PROGRAM: the graph of scripts/Snakefile, and a run of it on the elastic sample.
set -euo pipefail
command -v snakemake >/dev/null || { echo 'skipped: snakemake is not installed (packages-full.txt)'; exit 77; }
# shellcheck source=ctest/sweep/room.sh
source "$(dirname "$0")/room.sh"
trap 'rm -rf "$room"' EXIT
snake() { snakemake -s "$tree/scripts/Snakefile" --nocolor -j 2 "$@" >"$room/log" 2>&1; }
# expect_jobs RULE NUMBER: in the plan of a dry run.
expect_jobs() { grep -qE "^$1 +$2 " "$room/log" || { complain "a dry run plans no $2 jobs of '$1':"; cat "$room/log"; }; }

# On grains: one sample per seed, then its points, then the figures.
snake --dry-run --config figures=fig08 results="$room/native" || { cat "$room/log"; exit 1; }
expect_jobs sample 3
expect_jobs point 6
expect_jobs figures 1
! snake --dry-run --config figures=fig99 || complain 'fig99 is accepted'
grep -q 'fig99 is not there' "$room/log" || complain 'the message on fig99 says something else'

run=(--config engine=elastic figures="fig08 fig09" results="$room/results")
snake "${run[@]}" || { cat "$room/log"; exit 1; }
folder=$room/results/fig08_trigger/quick-elastic
expect_collected "$1" "$folder"
others() { find "$folder" -name '*.h5' ! -name RD_hold.h5 -printf '%p %T@\n' | sort; }
before=$(others)
snake "${run[@]}" || complain 'the second run fails'
grep -q 'Nothing to be done' "$room/log" || complain 'the second run does something'
rm "$folder/RD_hold.h5" "$folder.done/point.RD_hold" "$folder.done/collected"
snake "${run[@]}" || complain 'a missing point is not run'
expect_collected "$1" "$folder"
[[ $(others) == "$before" ]] || complain 'points that were complete have been written again'
echo "$failures failures"
((failures == 0))
