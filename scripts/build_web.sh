#!/usr/bin/env bash
# Builds the viewer of reports from web/ into build/web/report.html, which the program embeds when it is built: build_web.sh [--test]
#   --test  also run the tests of web/ that need no browser
# Needs node, and the network's npm packages once. Does nothing where the viewer is newer than all of web/.
set -euo pipefail
cd "$(dirname "$0")/../web"
built=../build/web/report.html
# Not "npm ci": it wants the packages of all platforms to be there, and a mirror may hold those of one.
[ node_modules/.package-lock.json -nt package-lock.json ] || npm install --no-save --silent
if [ "${1:-}" = --test ]; then
  npx tsc --noEmit
  npx vitest run
fi
if [ ! -e $built ] || [ -n "$(find . -path ./node_modules -prune -o -type f -newer $built -print -quit)" ]; then
  npx vite build --logLevel warn
fi
echo "build/web/report.html: $(stat -c %s $built) bytes"
