#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# layers_test.sh [ROOT]: fails when a file of core/ or cases/ includes what lies above it or beside it.
set -euo pipefail
cd "${1:-$(dirname "$0")/../..}"

# What a folder may include besides itself. `coupling` knows Slope and Sample, no engine (README, "Architecture").
rooms='configuration process claims sample_library experiment input run program'   # they were one folder, and still include each other
declare -A below=(
  [slope]=''
  [grains]=''
  [dem]='grains'
  [sample]='dem grains'
  [record]='sample dem grains'
  [coupling]='slope sample grains'
  [configuration]="$rooms coupling record sample dem grains slope"
  [process]="$rooms coupling record sample dem grains slope"
  [claims]="$rooms coupling record sample dem grains slope"
  [sample_library]="$rooms coupling record sample dem grains slope"
  [experiment]="$rooms coupling record sample dem grains slope"
  [input]="$rooms coupling record sample dem grains slope"
  [run]="$rooms coupling record sample dem grains slope"
  [program]="$rooms coupling record sample dem grains slope"
  [cases]="$rooms coupling record sample dem grains slope"
)

wrong=0 files=0
complain() { echo "$1"; wrong=$((wrong + 1)); }

while IFS= read -r file; do
  files=$((files + 1))
  folder=${file#core/}
  folder=${folder%%/*}
  [[ -n ${below[$folder]+known} ]] || { complain "$file: folder '$folder' has no place in the architecture"; continue; }
  while IFS=: read -r line included; do
    target=${included%%/*}
    if [[ $included == *..* ]]; then
      complain "$file:$line: \"$included\" leaves its folder by '..'; name it from core/"
    elif [[ $included == */* && -n ${below[$target]+known} && $target != "$folder" && " ${below[$folder]} " != *" $target "* ]]; then
      complain "$file:$line: $folder must not include $target (\"$included\"); it may include: ${below[$folder]:-nothing of the project}"
    fi
  done < <(sed -n 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"]\([^>"]*\)[>"].*/\1/;t found;b;:found;=;p' "$file" | paste -d : - -)
done < <(find core cases -name '*.?pp' | LC_ALL=C sort)

echo "$files files read, $wrong includes against the architecture"
((files > 0 && wrong == 0))
