#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# project_test.sh BUILD VERSION CMAKE: installs BUILD into an empty folder; project/ must build and run with nothing else.
set -euo pipefail
build=$1 version=$2 cmake=$3
here=$(cd "$(dirname "$0")" && pwd)
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT

"$cmake" --install "$build" --prefix "$room/first" >/dev/null
mv "$room/first" "$room/prefix"   # a package must not remember where it was installed
# configure VERSION: the project, with that version of the library wanted.
configure() {
  rm -rf "$room/build"
  "$cmake" -S "$here/project" -B "$room/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$room/prefix" \
    -DWANTED_VERSION="$1" >"$room/log" 2>&1
}
! configure 99.0 || { echo 'version 99.0 was found'; exit 1; }
grep -q 'compatible with requested version "99.0"' "$room/log" || { cat "$room/log"; exit 1; }
configure "${version%.*}" || { cat "$room/log"; exit 1; }
! grep -rqF "$(dirname "$here")" "$room/prefix" --include='*.cmake' || { echo 'the package names the source tree'; exit 1; }
"$cmake" --build "$room/build" >"$room/log" 2>&1 || { cat "$room/log"; exit 1; }
"$room/build/uses_flowslide"
