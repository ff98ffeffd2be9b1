#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# examples_test.sh BUILD VERSION CMAKE [MPIRUN...]: installs BUILD into an empty folder. The programs of examples/ must
# build with nothing else, and run: many_samples in one process, and with MPIRUN on two ranks with the same numbers. So
# must the program on the page docs/library.md.
set -euo pipefail
build=$1 version=$2 cmake=$3
launcher=("${@:4}")
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
export CMAKE_BUILD_PARALLEL_LEVEL=1   # beside other tests

fail() { echo "$1"; [[ ! -e $room/log ]] || tail -n 30 "$room/log"; exit 1; }

"$cmake" --install "$build" --prefix "$room/first" >/dev/null
mv "$room/first" "$room/prefix"   # a package must not remember where it was installed
include=$room/prefix/include
! grep -rnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' "$include" || fail 'installed headers include each other in quotes'
grep -rhoE '<flowslide/[^>]*>' "$include" | tr -d '<>' | sort -u >"$room/included"
(($(wc -l <"$room/included") > 20)) || fail 'the installed headers hardly include each other'
while IFS= read -r header; do [[ -e $include/$header ]] || fail "no header is installed as $header"; done <"$room/included"
! grep -rqF "$source_dir" "$room/prefix" --include='*.cmake' || fail 'the package names the source tree'

# configure FOLDER VERSION COMPONENTS OPTIONS...: a project that asks for that version and these components.
configure() {
  mkdir -p "$room/$1"
  printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(asks LANGUAGES CXX)' \
    "find_package(flowslide $2 REQUIRED COMPONENTS $3)" 'add_executable(asks all.cpp)' \
    'target_link_libraries(asks PRIVATE flowslide::coupling)' >"$room/$1/CMakeLists.txt"
  [[ -e $room/$1/all.cpp ]] || echo 'int main() {}' >"$room/$1/all.cpp"
  "$cmake" -S "$room/$1" -B "$room/$1/build" -G Ninja -DCMAKE_PREFIX_PATH="$room/prefix" "${@:4}" >"$room/log" 2>&1
}
! configure newer 99.0 '' || fail 'version 99.0 was found'
grep -q 'compatible with requested version "99.0"' "$room/log" || fail 'version 99.0: no reason is given'
! configure unknown "${version%.*}" 'sample kitchen' || fail 'a component of an unknown name was found'
grep -q 'built without kitchen' "$room/log" || fail 'an unknown component: no reason is given'
configure all "${version%.*}" '' || fail 'the package with all its components was not found'

# Samples and slopes need no library of the programs: all of their headers, beside none of these packages.
absent=()
for package in MPI LIGGGHTS HDF5 SerialHDF5 CLI11 tomlplusplus nlohmann_json; do
  absent+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
mkdir "$room/alone"
(cd "$include" && ls flowslide/{slope,grains,dem,dem/native,sample,coupling}/*.hpp) |
  sed 's/.*/#include <&>/' >"$room/alone/all.cpp"
echo 'int main() {}' >>"$room/alone/all.cpp"
configure alone "${version%.*}" 'sample coupling' "${absent[@]}" || fail 'sample and coupling were not found alone'
"$cmake" --build "$room/alone/build" >"$room/log" 2>&1 || fail 'their headers do not compile'
# Only flowslide/sample/... is on the include path.
echo '#include <sample/dem_sample.hpp>' >"$room/alone/all.cpp"
! "$cmake" --build "$room/alone/build" >"$room/log" 2>&1 || fail 'sample/dem_sample.hpp is found without flowslide/'
grep -q 'sample/dem_sample.hpp: No such file' "$room/log" || fail 'the include of sample/dem_sample.hpp failed otherwise'

# The program on the page ends with 1 unless the restored sample gives the same bits.
mkdir "$room/page"
awk '/^```cpp$/ { code = 1; next } /^```$/ { code = 0 } code' "$source_dir/docs/library.md" >"$room/page/all.cpp"
grep -q 'restore' "$room/page/all.cpp" || fail 'docs/library.md has no program'
configure page "${version%.*}" 'sample coupling' -DCMAKE_BUILD_TYPE=Release || fail 'the program of the page: not configured'
"$cmake" --build "$room/page/build" >"$room/log" 2>&1 || fail 'the program of docs/library.md does not build'
"$room/page/build/asks" >"$room/log" 2>&1 || fail 'the program of docs/library.md failed'

"$cmake" -S "$source_dir/examples" -B "$room/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$room/prefix" >"$room/log" 2>&1 || fail 'the examples were not configured'
"$cmake" --build "$room/build" >"$room/log" 2>&1 || fail 'the examples do not build'
! ldd "$room/build/shear_test" | grep -iE 'mpi|liggghts|hdf5' || fail 'a sample is linked to libraries of the programs'

# run NAME COMMAND...: runs it; it must say nothing but its numbers.
run() {
  "${@:2}" >"$room/$1" 2>"$room/log" || fail "$1 failed"
  [[ ! -s $room/log ]] || fail "$1 writes to standard error"
  cat "$room/$1"
}
run shear_test "$room/build/shear_test"
awk '!/^#/ { ++rows; if (!($3 > 0)) ++wrong } END { exit !(rows >= 20 && !wrong) }' "$room/shear_test" ||
  fail 'shear_test: expected 20 rows and a positive sigma in each'
run one_process "$room/build/many_samples"
if ((${#launcher[@]})); then
  run two_ranks "${launcher[@]}" "$room/build/many_samples"
  cmp "$room/one_process" "$room/two_ranks" || fail 'many_samples: two ranks give other numbers'
fi
