# SPDX-License-Identifier: GPL-2.0-or-later
# shellcheck shell=bash
# Submits the runs of a case as a Slurm job array, followed by a job that collects the results. Sourced by ./reproduce.

# submit_points NAME POINTS RANKS FOLDER COMMAND... -- COLLECT...: submits slurm_array.sh, which runs COMMAND for each
# point. After all of them, a second job runs COLLECT. Account, partition, time limit and so on are set by the variables
# of sbatch, such as SBATCH_TIMELIMIT.
submit_points() {
  local name=$1 points=$2 ranks=$3 folder=$4 names job collecting logs command=()
  shift 4
  command -v sbatch >/dev/null || die 'reproduce: --slurm: sbatch is missing; run this on a node that submits jobs'
  while [[ $1 != -- ]]; do command+=("$1"); shift; done
  shift
  mapfile -t names < <(cut -f 1 <<<"$points")
  logs=$folder.slurm
  mkdir -p "$logs"
  job=$(sbatch --parsable --job-name="$name" --array="1-${#names[@]}" --ntasks="$ranks" --output="$logs/%A_%a.log" \
    "$root/scripts/slurm_array.sh" "${names[@]}" -- "${command[@]}") || die 'reproduce: sbatch refused the runs' 1
  job=${job%%;*}   # in a federation, sbatch prints "job;cluster"
  collecting=$(sbatch --parsable --job-name="$name-collect" --ntasks=1 --output="$logs/collect.log" \
    --dependency="afterany:$job" --wrap "$(printf '%q ' "$@")") || die 'reproduce: sbatch refused the collection' 1
  say "$name: job $job executes ${#names[@]} runs, job ${collecting%%;*} collects their results; output in $logs"
}
