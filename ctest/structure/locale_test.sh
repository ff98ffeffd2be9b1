#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# locale_test.sh [ROOT]: fails when a source reads or writes numbers by what obeys the locale of a host program, which may
# have a decimal comma: std::from_chars and fmt do not. std::to_string obeys it for a double, and a stream for any number.
set -euo pipefail
cd "${1:-$(dirname "$0")/../..}"
export LC_ALL=C.UTF-8

forbidden='\b(sto(d|f|ld)|strto(d|f|ld)|atof|to_string|setprecision|[io]?stringstream)\b|\b[fs]?n?(printf|scanf)\([^)]*%[-+ #0-9.*]*[aefgAEFG]'
wrong=0 files=0
while IFS= read -r file; do
  files=$((files + 1))
  # Comments may speak of them; fmt::to_string is none of them. The report reads lines and words by streams, no numbers.
  found=$(sed -e 's,//.*,,' -e 's/fmt::to_string//g' "$file" | grep -nE "$forbidden" || true)
  [[ $file != report/* ]] || found=$(grep -v 'istringstream' <<<"$found" || true)
  [[ -z $found ]] || { sed "s|^|$file:|" <<<"$found"; wrong=$((wrong + 1)); }
done < <(find core cases report -name '*.?pp' | sort)

# Scripts hand numbers to awk, printf and sort: each that is run sets a locale with a decimal point.
for file in reproduce check $(find scripts -type f -exec grep -l '^#!/usr/bin/env bash' {} + | sort); do
  files=$((files + 1))
  grep -qE 'export LC_ALL=C\.UTF-8|scripts?/setup\.sh|/setup\.sh' "$file" ||
    { echo "$file: sets no locale; source scripts/setup.sh or export LC_ALL=C.UTF-8"; wrong=$((wrong + 1)); }
done
grep -q '^export LC_ALL=C.UTF-8$' scripts/setup.sh || { echo 'scripts/setup.sh: sets no locale'; wrong=$((wrong + 1)); }

echo "$files files read, $wrong that obey the locale"
((files > 0 && wrong == 0))
