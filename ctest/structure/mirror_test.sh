#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# mirror_test.sh [ROOT]: fails when a core/x/y.cpp has no ctest/x/y_test.cpp.
set -euo pipefail
cd "${1:-$(dirname "$0")/../..}"

# Sources without a test of their own, each with the reason.
declare -A reason=(
  [core/record/hdf5_error.cpp]='part of record/hdf5.hpp, as are the next two: tested as one in hdf5_test.cpp'
  [core/record/hdf5_file.cpp]='see hdf5_error.cpp'
  [core/record/hdf5_text.cpp]='see hdf5_error.cpp'
  [core/dem/native/isa/passes_isa.cpp]='compiled per instruction set; passes_test.cpp tests each'
)

missing=0 files=0
while IFS= read -r source; do
  files=$((files + 1))
  test=ctest/${source#core/}
  test=${test%.cpp}_test.cpp
  if [[ -n ${reason[$source]+excepted} ]]; then
    [[ ! -e $test ]] || { echo "$source: excepted, but $test exists; take it off the list"; missing=$((missing + 1)); }
  elif [[ ! -e $test ]]; then
    echo "$source: $test is missing"
    missing=$((missing + 1))
  fi
done < <(find core -name '*.cpp' | LC_ALL=C sort)
for source in "${!reason[@]}"; do
  [[ -e $source ]] || { echo "exception for $source, which is not there"; missing=$((missing + 1)); }
done

echo "$files sources, $missing without a test"
((files > 0 && missing == 0))
