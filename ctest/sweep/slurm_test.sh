#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# slurm_test.sh PROGRAM: ./reproduce --slurm on a Slurm of one node, brought up for this test alone.
set -euo pipefail
for command in slurmctld slurmd sbatch munged; do
  command -v "$command" >/dev/null || { echo "skipped: $command is not installed (packages-full.txt)"; exit 77; }
done
((EUID == 0)) || { echo 'skipped: slurmd needs root'; exit 77; }
# shellcheck source=ctest/sweep/room.sh
source "$(dirname "$0")/room.sh"
chmod 755 "$room"
daemons=()
cleanup() {
  [[ -z ${SLURM_CONF-} ]] || scancel --user=root >/dev/null 2>&1 || true
  for ((i = ${#daemons[@]} - 1; i >= 0; --i)); do
    kill "${daemons[i]}" 2>/dev/null && wait "${daemons[i]}" 2>/dev/null
  done
  rm -rf "$room"
}
trap cleanup EXIT

# Ports from a pair that is free now.
port=$((20000 + RANDOM % 10000))
while (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || (exec 3<>"/dev/tcp/127.0.0.1/$((port + 1))") 2>/dev/null; do
  port=$((port + 2))
done
host=$(hostname -s)
mkdir "$room/state" "$room/spool"
head -c 128 /dev/urandom >"$room/key"
chmod 600 "$room/key"
cat >"$room/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(localhost)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$room/munge.sock
CredType=cred/munge
SlurmUser=root
StateSaveLocation=$room/state
SlurmdSpoolDir=$room/spool
SlurmctldPidFile=$room/slurmctld.pid
SlurmdPidFile=$room/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,batch_sched_delay=0
MinJobAge=300
KillWait=2
MailProg=/bin/true
AccountingStorageType=accounting_storage/none
NodeName=$host NodeAddr=localhost CPUs=$(env -u OMP_NUM_THREADS nproc)
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$room/slurm.conf
# start NAME COMMAND...: a daemon in the foreground of its own background job, its output in NAME.log.
start() { "${@:2}" >"$room/$1.log" 2>&1 & daemons+=($!); }
start munged munged --force --foreground --key-file="$room/key" --socket="$room/munge.sock" --seed-file="$room/seed" \
  --pid-file="$room/munged.pid" --log-file="$room/munged.out"
for _ in {1..50}; do [[ -S $room/munge.sock ]] && break; sleep 0.1; done
start slurmctld slurmctld -D
start slurmd slurmd -D -N "$host"
for _ in {1..100}; do [[ $(sinfo -h -o %T 2>/dev/null) == idle ]] && break; sleep 0.2; done
[[ $(sinfo -h -o %T 2>/dev/null) == idle ]] ||
  { tail -n 5 "$room"/{munged,slurmctld,slurmd}.log; echo 'skipped: Slurm does not come up here (see above)'; exit 77; }

# finished: waits until no job is left.
finished() { for _ in {1..300}; do [[ -z $(squeue -h -o %i) ]] && return; sleep 0.2; done; squeue; return 1; }

folder=$tree/results/fig08_trigger/quick-elastic
"$tree/reproduce" fig08 fig09 --engine elastic --slurm || complain "reproduce --slurm ended with $?"
finished || complain 'jobs are left after a minute'
expect_collected "$1" "$folder"
grep -q 'figure: .*fig09.png' "$folder.slurm/collect.log" || { complain 'nothing was collected:'; cat "$folder.slurm/"*; }
[[ $(find "$folder.slurm" -name '*_*.log' | wc -l) == $(find "$folder" -name '*.h5' | wc -l) ]] ||
  complain 'points and tasks differ in number'

# A task that receives the stop signal ends with 75 and is queued again; the next start continues it.
cat >"$room/point" <<'POINT'
#!/usr/bin/env bash
[[ ! -e checkpoint ]] || { echo "$* resumed" >>points; exit 0; }
trap 'touch checkpoint; exit 75' USR1
touch started
while :; do sleep 0.1; done
POINT
chmod +x "$room/point"
job=$(sbatch --parsable --array=1 --chdir="$room" --output="$room/task.log" "$tree/scripts/slurm_array.sh" only -- "$room/point" -x)
for _ in {1..100}; do [[ -e $room/started ]] && break; sleep 0.1; done
scancel --batch --signal=TERM "${job}_1"
# Slurm holds a requeued job back for two minutes, until it is over on its node; a test need not wait so long.
for _ in {1..100}; do [[ $(squeue -h -j "$job" -o %T) == PENDING ]] && break; sleep 0.2; done
sleep 3
scontrol update JobId="${job}_1" StartTime=now
for _ in {1..150}; do [[ -e $room/points ]] && break; sleep 0.2; done
[[ $(cat "$room/points" 2>/dev/null) == '-x --point only resumed' ]] ||
  { complain 'a stopped point did not continue:'; cat "$room/task.log"; scontrol show job "$job"; }
echo "$failures failures"
((failures == 0))
