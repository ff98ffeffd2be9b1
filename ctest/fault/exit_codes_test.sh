#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# exit_codes_test.sh PROGRAM MPIRUN...: each rank of PROGRAM returns the code of the one that failed.
set -euo pipefail
program=$1
shift
launch=("$@")
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
export RESTARTABLE_CASE=$room FLOWSLIDE_CACHE=$room/cache
cat >"$room/case.toml" <<'CASE'
engine = "elastic"
seed = 1
replicates = 1
slope = { saturated_density = "2000 kg/m^3", dry_density = "1500 kg/m^3", thickness = "2 m", water_table = "0.2 m", liquefiable_thickness = "0.2 m", angle = "5 deg", hydraulic_conductivity = "0 m/s" }
material = { density = "2650 kg/m^3", youngs_modulus = "2 GPa", poisson_ratio = 0.25, restitution = 0.8, sliding_friction = 0.5, rolling_friction = 0.1, rolling_stiffness = 2.25, rolling_viscous_damping = 0.13 }
packing = { lattice = [5, 5, 6], smallest_diameter = "5 mm", largest_diameter = "7.5 mm" }
loading = { history = "pulse", amplitude = "3 kPa", duration = "2 s" }
stop = { end_time = "0.1 s" }
rows = { most_rows = 100, row_interval = "0.1 s" }
elastic = { shear_modulus = "15 MPa", oedometric_modulus = "40 MPa", viscosity = "0 Pa s", void_ratio = 0.79 }
scheme.RD = { passing = "carry_remainder", rate = "global" }
point.RD = { figures = ["12"], sample = "loose", scheme = "RD" }

[preparation]
engine = "native"
time_step = "1e-5 s"
loose_void_ratio = 1.2
compaction_rate = "2 1/s"
servo_rates = ["0.2 1/s", "0.1 1/s", "0.05 1/s"]
servo_interval = 30
mixing = "0 m/s"
drag_reference = "rest"
drag_stages = [1, 2, 3, 4]
restitution = 0.8
allow_uneven = true
stress_tolerance = 5e-3
kinetic_tolerance = 1e-8
[sample.loose]
void_ratio = 0.79
tolerance = 0.2
most_trials = 1
preparation_friction = 0.5
drag = "0.06 kg/s"
isotropic = false
[coupling]
time_step = "1e-4 s"
n_accum = 10
local_time_step = "1e-5 s"
most_steps = 100000
consolidation = "exponential"
residual = "fades"
shear_modulus = "40 MPa"
oedometric_modulus = "100 MPa"
allow_unstable = false
[scale.quick]
[scale.paper]
CASE
: >"$room/claims.toml"

# rank FILE PROGRAM OPTIONS...: one rank, which writes its code to FILE.<rank>. mpirun ends the other ranks when one has
# ended with a code: each waits until both are written.
cat >"$room/rank" <<'RANK'
file=$1
shift
code=0
"$@" || code=$?
echo "$code" >"$file.$OMPI_COMM_WORLD_RANK"
for _ in {1..200}; do [[ -e $file.0 && -e $file.1 ]] && break; sleep 0.05; done
exit "$code"
RANK

failures=0
# expect CODE PATTERN OPTIONS...: the code of both ranks and of mpirun, and what is said.
expect() {
  local wanted=$1 pattern=$2 code=0 codes
  shift 2
  "${launch[@]}" bash "$room/rank" "$room/code" "$program" "$@" >"$room/said" 2>&1 || code=$?
  codes="$code $(cat "$room/code.0" "$room/code.1" | paste -sd ' ')"
  rm -f "$room"/code.*
  if [[ $codes != "$wanted $wanted $wanted" ]] || ! grep -q -e "$pattern" "$room/said"; then
    printf '%s: codes of mpirun and its ranks %s, expected %s with "%s":\n' "$*" "$codes" "$wanted" "$pattern"
    cat "$room/said"
    failures=$((failures + 1))
  fi
}

expect 0 RD --list
expect 0 '' --output "$room/out" --point RD
expect 2 'the key "sloope.angle"\|sloope' --output "$room/out" --set sloope.angle='4 deg'
: >"$room/file"
expect 2 "$room/file" --output "$room/file" --point RD   # found by the first rank alone
expect 3 'the slide is not finite' --output "$room/wild" --point RD --allow-unstable --set 'coupling.time_step=0.1 s' \
  --set 'stop.end_time=1e6 s' --set rows.row_strain=1e6
expect 75 'out of the time given' --output "$room/late" --point RD --max-walltime '1 us'

echo "$failures failures"
((failures == 0))
