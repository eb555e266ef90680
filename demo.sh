#!/usr/bin/env bash
# On a fresh Debian 12: installs what is missing, builds, matches two shipped bears, and checks the match. usage: ./demo.sh [--web]
#   --web  builds the page instead, on which a browser matches what is dropped on it, and serves it to this machine alone
set -euo pipefail
cd "$(dirname "$0")"

case "${1:-}" in
  "") ;;
  --web)
    scripts/install.sh core viewer browser
    scripts/build_page.sh
    cd web
    echo "open this address in a browser; Ctrl-C ends it"
    exec npx vite preview --config vite.page.config.ts --host 127.0.0.1
    ;;
  *) sed -n '2,3s/^# *//p' "$0" >&2; exit 2 ;;
esac

scripts/install.sh core
{ scripts/install.sh viewer && scripts/build_web.sh; } || echo "without the viewer, quadmatch makes no reports; all else works" >&2
cmake --preset release -DQUADMATCH_DEVELOPER=OFF > /dev/null
cmake --build --preset release

mkdir -p build/demo
echo
build/release/quadmatch match examples/bear.obj examples/bear_no_ears_posed.obj -o build/demo/bears.json
build/release/quadmatch verify examples/bear.obj examples/bear_no_ears_posed.obj build/demo/bears.json
echo "the match file is build/demo/bears.json"
