#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# pictures_test.sh: draws every figure from tables of the quick scale and counts pixels. No panel may be empty, no text or
# line may touch the border of the picture, and the upper left corner has a text with scale, N and samples. The same
# counts must find the faults of spoilt pictures.
# pictures_test.sh --update RESULTS: makes these tables again, from RESULTS/<case>/quick. They are an example to draw from,
# and no results: some are older than the code, with columns renamed.
set -euo pipefail
export LC_ALL=C.UTF-8
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
tables=$source_dir/ctest/structure/quick_tables.tar.xz
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT

# thin FILE: a table with every tenth row only if it is long, and five digits.
thin() {
  awk 'NR == FNR { if (!/^#/) ++rows; next } FNR == 1 || /^#/ { print; next }
       { ++row } rows < 120 || row < 3 || row % 10 == 0 {
         for (i = 1; i <= NF; ++i) if ($i ~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/) $i = sprintf("%.5g", $i)
         print }' "$1" "$1"
}
# unread CASE: patterns of tables that no figure reads.
unread() {
  case $1 in
    fig06_convergence) echo '*_r?.dat carry?0* [Rcrv]*_over_shear_strain.dat' ;;
    fig08_trigger) echo '*_r?.dat *_r?_profiles.dat *_profiles.dat R?_ramp_over_shear_strain.dat R?_hold_over_time.dat' ;;
    fig12_pulse) echo '*_r?.dat *_over_time.dat R?_[45]kPa.dat' ;;
    fig13_k | fig14_e0) echo '*_over_time.dat' ;;
    open_questions)
      echo 'flow_* probe_* pulse_* hold_*_over* hold_*_profiles.dat hold_*_r?.dat hold_glued.dat hold_homogeneous.dat' ;;
    speed_error)
      echo 'element.dat element_[A-Zdlmnr]* element_fast* trigger.dat trigger_[A-Zdehlmnprs]* trigger_fast*' \
        'pulse.dat pulse_[A-Zdehlmnrs]* pulse_fast*' ;;
    hard) echo '[a-su-z]*.dat time_step.dat' ;;
  esac
}
if [[ ${1-} == --update ]]; then
  for folder in "$2"/*/quick; do
    name=$(basename "$(dirname "$folder")")
    mkdir "$room/$name"
    for file in "$folder"/*.dat; do thin "$file" >"$room/$name/$(basename "$file")"; done
    cp "$folder"/legend.tx[t] "$room/$name" 2>/dev/null || true
    # shellcheck disable=SC2046  # patterns
    (cd "$room/$name" && rm -f -- $(unread "$name"))
  done
  tar --create --xz --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --file="$tables" -C "$room" .
  ls -l "$tables"
  exit 0
fi

failures=0
complain() { echo "$1"; failures=$((failures + 1)); }
mkdir "$room/full"
tar --extract --xz --file="$tables" -C "$room/full"
cp -r "$room/full" "$room/empty"
for table in "$room"/empty/*/*.dat; do
  [[ $table =~ /(runs|slides)\.dat$ ]] || sed -i '1p; 2,${/^#/!d}; 1d' "$table"
done
cp -r "$source_dir/plots" "$room/scripts"
# PNG alone, and at half the size, so that a quarter of the pixels is counted.
sed -i 's/"png pdf"/"png"/' "$room"/scripts/*.gp
sed -i -e 's/fontscale 2.0 linewidth 2 /fontscale 1.0 linewidth 1 /' -e 's/80 \* width, 80 \* height/40 * width, 40 * height/' \
  "$room/scripts/style.gp"
# Each script prints the place of a panel (pixels, from the bottom left) after it has drawn it. An inset is a panel, too.
for script in "$room"/scripts/*.gp; do
  awk '{ print } /^ *plot / { drawing = 1 }
       drawing && !/\\$/ { drawing = 0
         print "print sprintf(\"PANEL %d %d %d %d\", GPVAL_TERM_XMIN, GPVAL_TERM_XMAX, GPVAL_TERM_YMIN, GPVAL_TERM_YMAX)" }' \
    "$script" >"$script.new"
  mv "$script.new" "$script"
done

# ink PICTURE PANELS: counts pixels that are not white. Prints "border N", "corner N" and one line "panel N" for each line
# of PANELS. Border: the outermost pixel; corner: the upper left one; panel: without its frame.
ink() {
  printf 'set table "%s"; plot "%s" binary filetype=png with rgbimage\n' "$room/pixels" "$1" | gnuplot 2>/dev/null
  # A line of the second file is "x y red green blue ...", from the top row down; y counts from the bottom.
  awk '
    FILENAME == ARGV[1] { ++panels; left[panels] = $2; right[panels] = $3; bottom[panels] = $4; top[panels] = $5; next }
    /^# Curve [0-9]/ { points = $6 }
    /^#/ || NF < 5 { next }
    height == 0 { height = $2 + 1; width = points / height }
    $3 + $4 + $5 > 735 { next }   # nearly white
    $1 < 1 || $2 < 1 || $1 > width - 2 || $2 > height - 2 { ++border }
    $1 < 0.35 * width && $2 > height - 20 { ++corner }
    { for (i = 1; i <= panels; ++i)
        if ($1 > left[i] + 2 && $1 < right[i] - 2 && $2 > bottom[i] + 2 && $2 < top[i] - 2) ++inside[i] }
    END { print "border", border + 0; print "corner", corner + 0
          for (i = 1; i <= panels; ++i) print "panel", inside[i] + 0 }' "$2" "$room/pixels"
}
# drawn SCRIPT CASE TABLES: draws, and prints its ink. What gnuplot says goes to stderr.
drawn() {
  gnuplot -c "$1" "$room/$3/$2" "$room/picture" >"$room/said" 2>&1 || { cat "$room/said" >&2; return 1; }
  grep -v '^PANEL' "$room/said" >&2 || true
  grep '^PANEL' "$room/said" >"$room/panels"
  ink "$room/picture.png" "$room/panels"
}
# faults SCRIPT CASE: draws with the tables and without their rows, and prints what is wrong. What both pictures have,
# such as a key, does not count.
faults() {
  local full empty
  full=$(drawn "$1" "$2" full) || { echo "it ended with an error"; return; }
  empty=$(drawn "$1" "$2" empty 2>/dev/null) || empty=''   # Fig. 2 cannot be drawn without a grain
  paste -d ' ' <(printf '%s\n' "$full") <(printf '%s\n' "$empty") | awk '
    $1 == "border" && $2 > 0 { print $2 " pixels at the border: a text or a line leaves the picture" }
    $1 == "corner" && $2 < 60 { print "no text in the upper left corner" }
    $1 == "panel" { ++panels; if ($2 - $4 < 15) print "panel " panels " is empty" }
    END { if (panels == 0) print "no panel" }'
}

figures=0
while read -r figure name script _; do
  [[ $figure != '#'* && $script != - ]] || continue
  figures=$((figures + 1))
  found=$(faults "$room/scripts/$script" "$name" 2>"$room/errors")
  [[ -z $found && ! -s $room/errors ]] || complain "$figure: $found $(cat "$room/errors")"
done < <(cat "$source_dir/plots/figures.txt"; echo 'sample_map sample_map sample_map.gp')

# expect_fault PATTERN SED CASE: Fig. 9, drawn by a spoilt script from the tables of CASE, is refused.
expect_fault() {
  sed -e "$2" -e "s/fig09.gp/spoilt.gp/" "$room/scripts/fig09.gp" >"$room/scripts/spoilt.gp"
  [[ $(faults "$room/scripts/spoilt.gp" "$3" 2>&1) == *"$1"* ]] || complain "a spoilt figure is not refused: $1"
}
expect_fault 'no text in the upper left corner' 's/^corner = .*/corner = ""/' fig08_trigger
expect_fault 'pixels at the border' 's/^mu(i)/set label 9 "outside" at screen 0.97, 0.5; mu(i)/' fig08_trigger
for part in full empty; do cp -r "$room/$part/fig08_trigger" "$room/$part/spoilt"; done
cp "$room"/empty/fig08_trigger/{*_friction_band,steady_friction}.dat "$room/full/spoilt"
expect_fault 'panel 2 is empty' '' spoilt

echo "$figures figures, $failures failures"
((figures > 15 && failures == 0))
