#!/usr/bin/env bash
# Runs cluster/submit.sh on a real slurmctld and slurmd, started here on one node, with a configuration and a folder of
# their own, and ended here. Needs root, scripts/install.sh cluster and a release build.
# usage: scripts/test_cluster.sh [PAIRS]
set -euo pipefail
cd "$(dirname "$0")/.."
pairs=${1:-10000}
if [ "$(id -u)" != 0 ]; then
  echo "test_cluster.sh: skipped: slurmd must be started by root, and this is user $(id -un)"
  exit 0
fi
for program in slurmctld slurmd munged sbatch; do
  command -v $program > /dev/null || { echo "test_cluster.sh: there is no $program; run scripts/install.sh cluster" >&2; exit 1; }
done

# munged wants a folder that none but its user could change, so not one under a folder that all may write.
base=$(mktemp -d /run/quadmatch-cluster-XXXXXX)
work=$(mktemp -d)
chmod 755 "$base" "$work"
children=()
stop() {
  for id in "${children[@]}"; do kill "$id" 2> /dev/null || true; done
  for id in "${children[@]}"; do wait "$id" 2> /dev/null || true; done
  rm -rf "$base" "$work"
}
trap stop EXIT

free_port() { /usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'; }
start_munge() {
  install -d -o munge -g munge -m 755 "$base/munge"
  dd if=/dev/urandom of="$base/munge/key" bs=128 count=1 status=none
  chown munge:munge "$base/munge/key"
  chmod 400 "$base/munge/key"
  setpriv --reuid=munge --regid=munge --clear-groups /usr/sbin/munged --foreground --key-file="$base/munge/key" \
    --socket="$base/munge/socket" --pid-file="$base/munge/pid" --seed-file="$base/munge/seed" \
    --log-file="$base/munge/log" > "$base/munge.out" 2>&1 &
  children+=($!)
}
write_configuration() {
  install -d "$base/state" "$base/spool"
  cat > "$base/slurm.conf" <<CONF
ClusterName=quadmatch
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$base/munge/socket
CryptoType=crypto/munge
StateSaveLocation=$base/state
SlurmdSpoolDir=$base/spool
SlurmctldPidFile=$base/slurmctld.pid
SlurmdPidFile=$base/slurmd.pid
SlurmctldLogFile=$base/slurmctld.log
SlurmdLogFile=$base/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0,bf_interval=1
ReturnToService=2
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
NodeName=$(hostname) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=2000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
}
wait_for() {
  for _ in $(seq 300); do
    "$@" > /dev/null 2>&1 && return
    sleep 0.1
  done
  echo "test_cluster.sh: waited in vain for: $*" >&2
  tail -n 20 "$base"/*.out >&2
  exit 1
}

start_munge
wait_for test -S "$base/munge/socket"
write_configuration
export SLURM_CONF=$base/slurm.conf
slurmctld -D -c -f "$base/slurm.conf" > "$base/slurmctld.out" 2>&1 &
children+=($!)
slurmd -D -f "$base/slurm.conf" > "$base/slurmd.out" 2>&1 &
children+=($!)
is_idle() { sinfo -h -o %T | grep -qx idle; }
wait_for is_idle

export QUADMATCH_PROGRAM=$PWD/build/release/quadmatch
/usr/bin/python3 scripts/test_batch.py --only-make "$work" --pairs "$pairs"
status=0
$QUADMATCH_PROGRAM batch "$work/jobs.csv" -o "$work/whole" --quiet || status=$?
[ $status = 1 ]  # a few pairs of the list must fail

# Two shards, with options for Slurm and for batch.
cluster/submit.sh "$work/jobs.csv" "$work/slurm results" 2 --mem=500M -- --quiet || status=$?
cat "$work/slurm results"/shard-*.log
[ $status = 1 ]
cmp "$work/whole/results.jsonl" "$work/slurm results/results.jsonl"
for shard in 1 2; do
  grep -q '"job":'$shard, "$work/slurm results/shard-$shard/results.jsonl"
  [ "$(wc -l < "$work/slurm results/shard-$shard/results.jsonl")" = $((pairs / 2)) ]
done

# A task that is cancelled in the middle leaves what it did, and the same command goes on.
sbatch_done() { ! squeue -h | grep -q .; }
(
  export QUADMATCH_JOBS=$work/jobs.csv QUADMATCH_RESULTS=$work/again QUADMATCH_SHARDS=2
  mkdir "$QUADMATCH_RESULTS"
  sbatch --array=1-2 --mem=500M --output=/dev/null cluster/array.sbatch --quiet > "$work/submitted"
)
wait_for test -e "$work/again/shard-1/results.sqlite"
scancel --signal=KILL --full "$(grep -o '[0-9]*' "$work/submitted")" || true
wait_for sbatch_done
status=0
cluster/submit.sh "$work/jobs.csv" "$work/again" 2 --mem=500M -- --quiet || status=$?
[ $status = 1 ]
cmp "$work/whole/results.jsonl" "$work/again/results.jsonl"

status=0
cluster/submit.sh "$work/nowhere.csv" "$work/again" 2 2> "$work/said" || status=$?
[ $status = 2 ] && grep -q 'nowhere.csv cannot be read' "$work/said"
echo "$pairs pairs through Slurm, in two shards, merged: the same as in one go; the same after a kill"
