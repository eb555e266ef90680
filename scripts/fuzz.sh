#!/usr/bin/env bash
# Runs every fuzz target for some seconds on the committed corpus: fuzz.sh SECONDS [SEED]
# The same seed tries the same inputs, so that a pass can be repeated; seek new ground with others (0: any).
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:?usage: fuzz.sh SECONDS [SEED]}
seed=${2:-1}
cmake --preset fuzz > build/fuzz.log
cmake --build --preset fuzz
for name in obj ply off usda match; do
  found=build/fuzz/found/$name
  mkdir -p "$found"
  build/fuzz/fuzz/fuzz_$name -seed="$seed" -max_total_time="$seconds" -max_len=4096 -timeout=10 -rss_limit_mb=4096 -print_final_stats=1 \
    -artifact_prefix="$found/" "$found" fuzz/corpus/$name > build/fuzz/$name.log 2>&1 ||
    { tail -n 40 build/fuzz/$name.log >&2; exit 1; }
  echo "$name: $(sed -n 's/^stat::number_of_executed_units: *//p' build/fuzz/$name.log) inputs, no finding"
done
