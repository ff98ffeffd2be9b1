#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# project_test.sh BUILD VERSION CMAKE: installs BUILD into an empty folder; project/ must build and run with nothing else.
set -euo pipefail
build=$1 version=$2 cmake=$3
here=$(cd "$(dirname "$0")" && pwd)
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT

fail() { echo "$1"; [[ ! -e $room/log ]] || tail -n 30 "$room/log"; exit 1; }

"$cmake" --install "$build" --prefix "$room/first" >/dev/null
mv "$room/first" "$room/prefix"   # a package must not remember where it was installed
include=$room/prefix/include
! grep -rnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' "$include" || fail 'installed headers include each other in quotes'
grep -rhoE '<flowslide/[^>]*>' "$include" | tr -d '<>' | sort -u >"$room/included"
(($(wc -l <"$room/included") > 20)) || fail 'the installed headers hardly include each other'
while IFS= read -r header; do [[ -e $include/$header ]] || fail "no header is installed as $header"; done <"$room/included"
! grep -rqF "$(dirname "$here")" "$room/prefix" --include='*.cmake' || fail 'the package names the source tree'

# configure VERSION COMPONENTS OPTIONS...: the project, with that version and these components of the library wanted.
configure() {
  rm -rf "$room/build"
  "$cmake" -S "$here/project" -B "$room/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$room/prefix" \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DWANTED_VERSION="$1" -DWANTED_COMPONENTS="$2" "${@:3}" >"$room/log" 2>&1
}
! configure 99.0 '' || fail 'version 99.0 was found'
grep -q 'compatible with requested version "99.0"' "$room/log" || fail 'version 99.0: no reason is given'
! configure "${version%.*}" 'sample;kitchen' || fail 'a component of an unknown name was found'
grep -q 'built without kitchen' "$room/log" || fail 'an unknown component: no reason is given'
configure "${version%.*}" '' || fail 'the package with all its components was not found'

# A sample needs no library of the programs.
absent=()
for package in MPI LIGGGHTS HDF5 SerialHDF5 CLI11 tomlplusplus nlohmann_json; do
  absent+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
configure "${version%.*}" 'sample;coupling' "${absent[@]}" || fail 'sample and coupling were not found alone'
"$cmake" --build "$room/build" >"$room/log" 2>&1 || fail 'the project does not build'
! ldd "$room/build/uses_flowslide" | grep -iE 'mpi|liggghts|hdf5' || fail 'the project is linked to libraries of the programs'
"$room/build/uses_flowslide"

# Only flowslide/sample/... is on the include path.
echo '#include <sample/dem_sample.hpp>' >"$room/bare.cpp"
compiler=$(jq -r '.[0].command' "$room/build/compile_commands.json" | sed 's/ -o .*//')
# shellcheck disable=SC2086  # several words
! $compiler -fsyntax-only "$room/bare.cpp" 2>"$room/log" || fail 'sample/dem_sample.hpp is found without flowslide/'
grep -q 'sample/dem_sample.hpp: No such file' "$room/log" || fail 'the include of sample/dem_sample.hpp failed otherwise'
