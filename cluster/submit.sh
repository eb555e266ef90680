#!/usr/bin/env bash
# Match the pairs of a job list on a Slurm cluster, and merge the results.
#
# usage: cluster/submit.sh JOBS.csv RESULTS SHARDS [sbatch options] [-- options of quadmatch batch]
#   JOBS.csv, RESULTS  on a file system that all nodes see
#   SHARDS             tasks of the array; give each a hundred pairs or more
#
# Example: cluster/submit.sh jobs.csv results 40 --cpus-per-task=8 --mem=16G -- --no-positions
#
# Waits until all is done, and exits as quadmatch batch-merge does: 0 all pairs are done, 1 some failed, 2 trouble. It may
# be stopped and started again, with the same SHARDS: what is done is not done again.
# QUADMATCH_PROGRAM names the program where it is not on the path.
set -euo pipefail

usage() { sed -n '2,12s/^# \{0,1\}//p' "$0" >&2; exit 2; }
[ $# -ge 3 ] || usage
jobs=$(realpath -- "$1") results=$(realpath -m -- "$2") shards=$3
shift 3
case "$shards" in '' | *[!0-9]* | 0*) echo "submit.sh: SHARDS is $shards, and must be a number from 1 on" >&2; exit 2 ;; esac
[ -r "$jobs" ] || { echo "submit.sh: $jobs cannot be read; check the name and the folder" >&2; exit 2; }

for_slurm=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do for_slurm+=("$1"); shift; done
[ $# -eq 0 ] || shift

mkdir -p "$results"
export QUADMATCH_JOBS=$jobs QUADMATCH_RESULTS=$results QUADMATCH_SHARDS=$shards
here=$(dirname "$(realpath "$0")")
status=0
sbatch --wait --export=ALL --array="1-$shards" --output="$results/shard-%a.log" --open-mode=append "${for_slurm[@]}" \
  "$here/array.sbatch" "$@" || status=$?
[ $status -eq 0 ] || echo "submit.sh: a task failed; see $results/shard-*.log, then run the same command again" >&2

folders=()
for shard in $(seq "$shards"); do
  [ ! -e "$results/shard-$shard/results.sqlite" ] || folders+=("$results/shard-$shard")
done
[ ${#folders[@]} -gt 0 ] || { echo "submit.sh: no task has results" >&2; exit 2; }
"${QUADMATCH_PROGRAM:-quadmatch}" batch-merge "${folders[@]}" -o "$results"
