#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# links_test.sh: every link of README.md, docs and the READMEs of the cases points to a file and a heading that are there.
# So does every path in code, such as `core/slope/sliding.hpp`, and every label of a test (`-L paper`). Every page of docs is
# linked from README.md, and README.md is below 10 kB. Links to the web are not tried.
set -euo pipefail
cd "$(dirname "$0")/../.."

wrong=0 links=0
complain() { echo "$1"; wrong=$((wrong + 1)); }

# anchors PAGE: prints the anchors of its headings, as GitHub makes them.
anchors() {
  awk '/^```/ { fenced = !fenced } !fenced && /^#+ / { sub(/^#+ +/, ""); print tolower($0) }' "$1" |
    sed -E -e 's/\[([^]]*)\]\([^)]*\)/\1/g' -e 's/[^a-z0-9 _-]//g' -e 's/ /-/g'
}

# links_of PAGE: prints the targets of its links outside of code.
links_of() {
  awk '/^```/ { fenced = !fenced; next } !fenced { gsub(/`[^`]*`/, ""); print }' "$1" | tr '\n' ' ' |
    grep -oP '\]\(\K[^)\s]+(?=\))' || true
}

# paths_of PAGE: prints the paths that its code spans name; of a command its first word.
paths_of() {
  awk '/^```/ { fenced = !fenced; next } !fenced { print }' "$1" | tr '\n' ' ' | grep -oP '`[^`]+`' |
    grep -oP '^`\K(core|cases|ctest|docs|examples|plots|scripts)/[A-Za-z0-9_./-]+(?=[` ])' | sort -u || true
}

pages=(README.md CONTRIBUTING.md docs/*.md cases/*/README.md ctest/README.md)
for page in "${pages[@]}"; do
  [[ -e $page ]] || { complain "$page is missing"; continue; }
  while IFS= read -r link; do
    links=$((links + 1))
    [[ ! $link =~ ^(https?|mailto): ]] || continue
    file=${link%%#*} anchor=''
    [[ $link != *'#'* ]] || anchor=${link#*#}
    target=$page
    [[ -z $file ]] || target=$(dirname "$page")/$file
    if [[ ! -e $target ]]; then
      complain "$page: $link: there is no $target"
    elif [[ -n $anchor ]] && ! anchors "$target" | grep -qxF "$anchor"; then
      complain "$page: $link: there is no such heading in $target"
    fi
  done < <(links_of "$page")
  while IFS= read -r path; do
    links=$((links + 1))
    [[ -e $path || -e $(dirname "$page")/$path ]] || complain "$page: \`$path\`: there is no such file"
  done < <(paths_of "$page")
  while IFS= read -r label; do
    grep -qE "^\| ([a-z-]+, )*$label(, [a-z-]+)* \|" ctest/README.md || complain "$page: ctest/README.md has no label $label"
  done < <(grep -oP '(ctest|check).*? -L \K[a-z-]+' "$page" | sort -u)
done
for page in docs/*.md; do
  links_of README.md | grep -qxF "$page" || complain "README.md does not link to $page"
done
size=$(wc -c <README.md)
((size <= 10240)) || complain "README.md has $size bytes; 10240 are allowed"
echo "$links links in ${#pages[@]} pages, README.md has $size bytes"
((links >= 100 && wrong == 0))
