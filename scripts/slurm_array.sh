#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The Slurm job script of all cases: task i of the array runs the i-th point. ./reproduce --slurm submits it.
# Usage: sbatch --array=1-N [SBATCH OPTIONS...] slurm_array.sh POINT... -- COMMAND...
#
# Slurm sends TERM before the time limit and at preemption. The run then writes a checkpoint and ends with exit code 75.
# The task is queued again and continues from the checkpoint.
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --signal=B:TERM@120
set -uo pipefail
export LC_ALL=C.UTF-8   # numbers with a decimal point

points=()
while (($#)) && [[ $1 != -- ]]; do points+=("$1"); shift; done
(($# > 1)) || { echo 'slurm_array.sh: no command after --; ./reproduce --slurm submits this script' >&2; exit 2; }
shift
point=${points[SLURM_ARRAY_TASK_ID - 1]}
# Each rank uses one thread. mpirun in COMMAND uses the cores of the task.
export OMP_NUM_THREADS=1

# A task that was queued again continues from its checkpoint, which --afresh would delete.
if ((${SLURM_RESTART_COUNT:-0} > 0)); then
  command=()
  for word; do [[ $word == --afresh ]] || command+=("$word"); done
  set -- "${command[@]}"
fi
"$@" --point "$point" &
running=$! told=no
# USR1 and TERM mean the same to a run. mpirun passes USR1 on; after TERM it kills its ranks within a second.
trap 'told=yes; kill -USR1 "$running"' TERM
while :; do   # a signal ends `wait` before the program ends, so wait again
  wait "$running"
  code=$?
  [[ $told == yes ]] || break
  told=no
done
echo "slurm_array.sh: run $point ended with exit code $code" >&2
((code != 75)) || scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
exit "$code"
