#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# browser_test.sh REPORT CASE: opens the report in Chromium without network: every figure is there and drawn, nothing
# else is loaded, and the console stays empty. The same checks must find the faults of a damaged page.
set -euo pipefail
report=$1 program=$2
project=$(cd "$(dirname "$0")/../.." && pwd)
command -v chromium >/dev/null || { echo 'skipped: chromium is not installed (packages-full.txt)'; exit 77; }
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
export HOME=$room

# Results: a run of the elastic closed form, and the pictures of the gallery.
results=$room/results
folder=$results/fig08_trigger/quick
code=0
"$program" --engine elastic --point RD_ramp --output "$folder" 2>"$room/run.log" || { cat "$room/run.log"; exit 1; }
"$program" --engine elastic --point RD_ramp --output "$folder" --check >/dev/null || code=$?
((code == 0)) || { echo "--check of the elastic sample ended with $code, expected 0: no claim is evaluated"; exit 1; }
figures=0
while read -r name the_case _; do
  [[ $name != '#'* && -e $project/plots/gallery/quick/$name.png ]] || continue
  mkdir -p "$results/$the_case/quick"
  cp "$project/plots/gallery/quick/$name.png" "$results/$the_case/quick/"
  [[ $the_case != fig08_trigger ]] || figures=$((figures + 1))   # the others were not run, and are not shown
done <"$project/plots/figures.txt"
"$report" --project "$project" --results "$results" --output "$room/page.html"

# seen PAGE [WIDTH]: `pictures drawn, figures, verdicts, other files loaded, faults of width`, as the browser counts them in
# a frame of WIDTH px; its console in console. Faults of width: the page is wider than the frame, a figure is narrower than
# 600 px, or, in a narrow frame, a table is wider than its place.
seen() {
  local options=(--headless=new --disable-gpu --disable-dev-shm-usage --no-first-run --enable-logging=stderr --log-level=0
                 --host-resolver-rules='MAP * ~NOTFOUND' --user-data-dir="$room/profile" --virtual-time-budget=5000)
  ((EUID != 0)) || options+=(--no-sandbox)
  { cat "$1"; echo '<script>addEventListener("load", () => {
      document.querySelectorAll("details").forEach(d => { d.open = true; });
      const drawn = [...document.images].filter(i => i.complete && i.naturalWidth > 0);
      const loaded = [...document.querySelectorAll("[src], link[href]")]
        .filter(e => !(e.src || e.href).startsWith("data:")).length;
      const of = selector => document.querySelectorAll(selector).length;
      const wide = document.documentElement.scrollWidth > innerWidth + 1 ? 1 : 0;
      const faint = drawn.filter(i => i.getBoundingClientRect().width < 600).length;
      const cut = innerWidth > 600 ? 0 :
        [...document.querySelectorAll("table")].filter(t => t.scrollWidth > t.parentElement.clientWidth + 1).length;
      top.document.title =
        ["SEEN", drawn.length, of("figure"), of(".claims .mark"), loaded, wide + faint + cut].join(" "); });</script>'
  } >"$room/inner.html"
  { printf '<!DOCTYPE html><body><iframe style="width: %dpx; height: 900px" srcdoc="' "${2:-1280}"
    sed -e 's/&/\&amp;/g' -e 's/"/\&quot;/g' "$room/inner.html"
    printf '"></iframe>'; } >"$room/watched.html"
  timeout 60 chromium "${options[@]}" --dump-dom "file://$room/watched.html" >"$room/dom" 2>"$room/log" ||
    { tail "$room/log"; echo "chromium ended with an error"; exit 1; }
  grep 'CONSOLE' "$room/log" >"$room/console" || true
  sed -n 's/.*<title>SEEN \([^<]*\)<.*/\1/p' "$room/dom"
}

failures=0
expect() { [[ $2 == "$3" ]] || { echo "$1: '$2', expected '$3'"; failures=$((failures + 1)); }; }
claims=$(jq length "$folder/claims.json")
expect 'the page' "$(seen "$room/page.html")" "$figures $figures $claims 0 0"
expect 'the page, 390 px wide' "$(seen "$room/page.html" 390)" "$figures $figures $claims 0 0"
expect 'its console' "$(cat "$room/console")" ''
sed -e '0,/data:image\/png;base64,/s//data:image\/png;base64,AAAA/' -e 's|<main>|&<script>console.error("spoilt")</script>|' \
  -e 's|</main>|<img src="missing.png">&|' "$room/page.html" >"$room/spoilt.html"
expect 'a spoilt page' "$(seen "$room/spoilt.html")" "$((figures - 1)) $figures $claims 1 0"
grep -q 'spoilt' "$room/console" || { echo 'an error in the console went unseen'; failures=$((failures + 1)); }
echo "$figures figures, $claims verdicts, $failures failures"
((failures == 0 && figures > 0))
