#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# api_test.sh BUILD_FOLDER: doxygen writes the reference of the library without a warning, as the target `docs` does.
set -euo pipefail
command -v doxygen >/dev/null || { echo 'skipped: doxygen is not installed (packages-full.txt)'; exit 77; }
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
sed "s|^OUTPUT_DIRECTORY .*|OUTPUT_DIRECTORY = $room|" "$1/docs/Doxyfile" >"$room/Doxyfile"
doxygen "$room/Doxyfile" || { echo 'doxygen has warnings (above)'; exit 1; }
for page in index classflowslide_1_1DemSample; do
  [[ -s $room/html/$page.html ]] || { echo "the reference has no $page.html"; exit 1; }
done
echo "$(find "$room/html" -name '*.html' | wc -l) pages"
