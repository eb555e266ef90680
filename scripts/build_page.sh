#!/usr/bin/env bash
# Builds the page that matches in the browser: a static folder, build/page, that any web server can serve.
# Needs scripts/install.sh core viewer browser. Does nothing where the folder is newer than all it is made of.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/build_wasm.sh
built=$PWD/build/page/index.html
cd web
[ node_modules/.package-lock.json -nt package-lock.json ] || npm install --no-save --silent
if [ ! -e "$built" ] || [ ../build/wasm/quadmatch.wasm -nt "$built" ] ||
   [ -n "$(find . ../examples -path ./node_modules -prune -o -type f -newer "$built" -print -quit)" ]; then
  npx vite build --config vite.page.config.ts --logLevel warn
fi
echo "build/page: $(du -sb ../build/page | cut -f1) bytes"
