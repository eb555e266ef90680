#!/usr/bin/env bash
# clang-tidy over the layers below the front ends, with the rules of .clang-tidy; every finding fails.
# Needs a configured release build.
set -euo pipefail
cd "$(dirname "$0")/.."
git ls-files 'src/*.cpp' | xargs -P "$(nproc)" -n 3 clang-tidy-16 -p build/release --quiet --warnings-as-errors='*' 2> build/lint.log ||
  { tail -n 40 build/lint.log >&2; exit 1; }
