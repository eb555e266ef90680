#!/usr/bin/env bash
# On a fresh Debian 12: installs what is missing, builds, matches two shipped bears, and checks the match.
set -euo pipefail
cd "$(dirname "$0")"

scripts/install.sh core
{ scripts/install.sh viewer && scripts/build_web.sh; } || echo "without the viewer, quadmatch makes no reports; all else works" >&2
cmake --preset release -DQUADMATCH_DEVELOPER=OFF > /dev/null
cmake --build --preset release

mkdir -p build/demo
echo
build/release/quadmatch match examples/bear.obj examples/bear_no_ears_posed.obj -o build/demo/bears.json
build/release/quadmatch verify examples/bear.obj examples/bear_no_ears_posed.obj build/demo/bears.json
echo "the match file is build/demo/bears.json"
