#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# local_test.sh PROGRAM: ./reproduce on this machine, with the elastic sample, in a folder whose name a shell would run.
set -euo pipefail
# shellcheck source=ctest/sweep/room.sh
source "$(dirname "$0")/room.sh"
trap 'rm -rf "$room"' EXIT
folder="$room/it's \$(touch hacked) \`touch hacked\` \"; touch hacked; \""
# reproduce WORDS...: its output in log.
reproduce() { "$tree/reproduce" fig08 fig09 --engine elastic --output "$folder" "$@" >"$room/log" 2>&1; }
# expect_end CODE WORDS...
expect_end() {
  local code=0 wanted=$1
  shift
  reproduce "$@" || code=$?
  ((code == wanted)) || { complain "reproduce $* ended with $code, expected $wanted:"; cat "$room/log"; }
}

# First half of the points and a preliminary figure, then all points.
"$1" --engine elastic --point RD_ramp --point RI_ramp --output "$folder" 2>"$room/log" || { cat "$room/log"; exit 1; }
expect_end 0 --so-far
for file in so_far/fig08.png so_far/RD_ramp_over_time.dat; do [[ -s $folder/$file ]] || complain "$file is missing"; done
grep -q "so_far/fig08.png" "$room/log" || complain 'the preliminary figure is not named'
before=$(find "$folder" -maxdepth 1 -name 'R?_ramp.h5' -printf '%p %T@\n' | sort)
expect_end 0 --jobs 2
expect_collected "$1" "$folder"
[[ $(find "$folder" -maxdepth 1 -name 'R?_ramp.h5' -printf '%p %T@\n' | sort) == "$before" ]] ||
  complain 'points that were complete have been written again'

# Each point on two ranks. A stand-in for mpirun notes its arguments.
printf '#!/bin/sh\necho "$*" >>"%s/asked"\nshift 2\nexec "$@"\n' "$room" >"$room/bin/mpirun"
chmod +x "$room/bin/mpirun"
rm "$folder/RD_hold.h5"
expect_end 0 --ranks 2
grep -q '^-np 2 .*fig08_trigger .*--point RD_hold' "$room/asked" || complain 'mpirun was not asked for two ranks'

[[ -z $(find "$room" -name hacked) ]] || complain 'a name was run by a shell'
echo "$failures failures"
((failures == 0))
