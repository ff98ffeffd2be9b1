#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# layers_test.sh [ROOT]: fails when a file of core/ or cases/ includes a folder that its own may not include, and names
# the arrow. Without ROOT it also checks on small trees of its own that each kind of complaint is made.
set -euo pipefail
script=$(realpath "$0")
checks_itself=$(($# == 0))
root=${1:-$(dirname "$script")/../..}

# What a folder may include besides itself, as docs/extending.md has it.
below_program='slope grains configuration process dem record sample coupling claims sample_library experiment input run'
declare -A below=(
  [slope]='' [grains]='' [configuration]='' [process]=''
  [dem]='grains process'
  [record]='grains'
  [sample]='dem grains'
  [coupling]='slope sample'
  [claims]='configuration'
  [sample_library]='sample record process'
  [experiment]='coupling sample record'
  [input]='configuration experiment coupling sample slope'
  [run]='experiment record process'
  [program]="$below_program"
  [cases]="program $below_program"
)
# Exceptions from the table, "folder included-file", each with its reason. `*` stands for any file of that folder.
declare -A reason=(
  ['coupling grains/measures.hpp']='the rate of an inertial number is a formula of the grains'
  ['coupling grains/require.hpp']='a check of a number, no physics'
  ['slope grains/require.hpp']='a check of a number, no physics'
  ['experiment grains/*']='rows, profiles and inertial numbers of a run are formulas of the grains'
)

wrong=0 files=0
declare -A used=()
complain() { echo "$1"; wrong=$((wrong + 1)); }

# excepted FOLDER INCLUDED: whether this arrow is an exception.
excepted() {
  local arrow
  for arrow in "$1 $2" "$1 ${2%%/*}/*"; do
    [[ -z ${reason[$arrow]+known} ]] || { used[$arrow]=yes; return 0; }
  done
  return 1
}

# check_file FILE: complains of the includes of one file.
check_file() {
  local file=$1 folder=${1#core/} line included target
  folder=${folder%%/*}
  [[ -n ${below[$folder]+known} ]] || { complain "$file: folder '$folder' has no place in the architecture"; return; }
  while IFS=: read -r line included; do
    target=${included%%/*}
    if [[ $included == *..* ]]; then
      complain "$file:$line: \"$included\" leaves its folder by '..'; name it from core/"
    elif [[ $included == */* && -n ${below[$target]+known} && $target != "$folder" &&
            " ${below[$folder]} " != *" $target "* ]] && ! excepted "$folder" "$included"; then
      complain "$file:$line: $folder -> $target (\"$included\"); $folder may include: ${below[$folder]:-nothing}"
    fi
  done < <(sed -n 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"]\([^>"]*\)[>"].*/\1/;t found;b;:found;=;p' "$file" |
             paste -d : - -)
}

# expect_complaint FOLDER INCLUDE PATTERN: in a tree of one file with that include, this test fails with that complaint;
# without PATTERN it passes.
expect_complaint() {
  local room said code=0
  room=$(mktemp -d)
  mkdir -p "$room/core/$1" "$room/cases"
  printf '#include <string>\n#include "%s"\n' "$2" >"$room/core/$1/one.cpp"
  said=$("$script" "$room") || code=$?
  rm -r "$room"
  if [[ -z ${3-} ]]; then
    ((code == 0)) || complain "$1 may include $2, but this test says: $said"
  elif ((code == 0)) || [[ $said != *"$3"* ]]; then
    complain "$1 must not include $2, but this test ends with $code and says: $said"
  fi
}

cd "$root"
while IFS= read -r file; do
  files=$((files + 1))
  check_file "$file"
done < <(find core cases -name '*.?pp' | LC_ALL=C sort)
echo "$files files read, $wrong includes against the architecture"

if ((checks_itself)); then
  for arrow in "${!reason[@]}"; do
    [[ -n ${used[$arrow]+yes} ]] || complain "no file needs the exception '$arrow' any more; take it off the list"
  done
  expect_complaint grains slope/statics.hpp 'core/grains/one.cpp:2: grains -> slope ("slope/statics.hpp")'
  expect_complaint coupling dem/engine.hpp 'coupling -> dem ("dem/engine.hpp"); coupling may include: slope sample'
  expect_complaint coupling grains/packing.hpp 'coupling -> grains'
  expect_complaint run configuration/error.hpp 'run -> configuration'
  expect_complaint record program/case.hpp 'record -> program'
  expect_complaint hall slope/statics.hpp "folder 'hall' has no place in the architecture"
  expect_complaint sample ../grains/packing.hpp "leaves its folder by '..'"
  expect_complaint sample grains/packing.hpp
  expect_complaint coupling grains/require.hpp
  expect_complaint program run/checkpoint.hpp
fi
((files > 0 && wrong == 0))
