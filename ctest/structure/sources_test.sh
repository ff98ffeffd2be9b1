#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# sources_test.sh [ROOT]: fails when a source names no licence in its first three lines, or has more than 400 lines, or a
# C++ source has lines of more than 120 bytes (.clang-format).
set -euo pipefail
export LC_ALL=C
cd "${1:-$(dirname "$0")/../..}"

wrong=0 files=0
while IFS= read -r file; do
  files=$((files + 1))
  head -n 3 "$file" | grep -q 'SPDX-License-Identifier: GPL-2.0-or-later' ||
    { echo "$file: no line 'SPDX-License-Identifier: GPL-2.0-or-later' in its first three"; wrong=$((wrong + 1)); }
  lines=$(wc -l <"$file")
  [[ $file != *.?pp ]] || awk 'length > 120 {print FILENAME ":" FNR ": " length " bytes; 120 are allowed"; n = 1} END {exit n}' "$file" ||
    wrong=$((wrong + 1))
  ((lines <= 400)) || { echo "$file: $lines lines; split it, 400 are allowed"; wrong=$((wrong + 1)); }
done < <({ find core cases report ctest cmake plots scripts -type f \( -name '*.?pp' -o -name '*.h' -o -name '*.cmake' -o -name '*.sh' \
             -o -name '*.gp' -o -name '*.css' -o -name '*.toml' -o -name 'CMakeLists.txt' -o -path 'scripts/*' \)
           printf '%s\n' CMakeLists.txt check reproduce .ci/run packages.txt packages-full.txt packages-peers.txt; } | LC_ALL=C sort -u)

echo "$files files read, $wrong complaints"
((files > 0 && wrong == 0))
