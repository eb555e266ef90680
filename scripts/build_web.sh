#!/usr/bin/env bash
# Builds the viewer of reports from web/ into src/report/page.html, which the program embeds: build_web.sh [--check]
#   --check  change nothing; fail where the committed page is not what web/ makes, or a test of web/ fails
# Needs node and the network's npm packages once; making the program and making reports need neither.
set -euo pipefail
cd "$(dirname "$0")/../web"
[ node_modules/.package-lock.json -nt package-lock.json ] || npm ci --silent
npx tsc --noEmit
npx vitest run
npx vite build --logLevel warn
built=../build/web/report.html
committed=../src/report/page.html
if [ "${1:-}" = --check ]; then
  cmp "$built" "$committed" || { echo "build_web.sh: src/report/page.html is not what web/ makes; run scripts/build_web.sh and commit it" >&2; exit 1; }
else
  cp "$built" "$committed"
fi
echo "$committed: $(stat -c %s "$built") bytes"
