# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash
# Copies what a sweep needs of the project to an empty folder: the scripts, and fig08_trigger as built. Sourced;
# sets `room` and `tree`.
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
room=$(mktemp -d)
tree="$room/a project"
mkdir -p "$tree/build/release/cases/fig08_trigger" "$room/bin" "$room/home"
cp -r "$source_dir"/{reproduce,scripts,plots,packages.txt} "$tree"
ln -s "$1" "$tree/build/release/cases/fig08_trigger/"
# The set-up does nothing: the program exists.
printf '#!/bin/sh\nexit 0\n' >"$room/bin/cmake"
printf '#!/bin/sh\necho installed\n' >"$room/bin/dpkg-query"
chmod +x "$room/bin/"*
export PATH="$room/bin:$PATH" HOME="$room/home" FLOWSLIDE_CACHE="$room/cache" OMP_NUM_THREADS=1
cd "$room" || exit

failures=0
complain() { echo "$1"; failures=$((failures + 1)); }
# expect_collected FOLDER: every point of the case, its tables and its figure are there.
expect_collected() {
  local point points
  points=$("$1" --engine elastic --list | sed '1d;s/\t.*//')
  [[ -n $points ]] || complain 'the case lists no point'
  for point in $points; do [[ -s $2/$point.h5 ]] || complain "$2/$point.h5 is missing"; done
  for file in claims.json RD_hold_over_time.dat fig08.png; do [[ -s $2/$file ]] || complain "$2/$file is missing"; done
}
