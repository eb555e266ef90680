#!/usr/bin/env bash
# Draws docs/images/blender_panel.png: Blender in a virtual screen, with the add-on's panel after a Match of two bears.
# Needs scripts/install.sh blender viewer, and scripts/build_blender.sh. Not a part of the tests.
set -euo pipefail
cd "$(dirname "$0")/.."

export PATH=/usr/bin:/bin  # Debian's Blender looks for Python's modules beside the first python3 on PATH
folder=$PWD/build/blender/draw
rm -rf "$folder"
mkdir -p "$folder/scripts" "$folder/config"
mkfifo "$folder/display"
Xvfb -displayfd 3 -screen 0 1000x840x24 +extension GLX -nolisten tcp 3> "$folder/display" 2> "$folder/xvfb.log" &
screen=$!
trap 'kill $screen' EXIT
read -r number < "$folder/display"

DISPLAY=:$number LIBGL_ALWAYS_SOFTWARE=1 BLENDER_USER_SCRIPTS=$folder/scripts BLENDER_USER_CONFIG=$folder/config \
  timeout 300 blender --factory-startup --enable-event-simulate --python-exit-code 3 --window-geometry 0 0 1000 840 \
  --python blender/tests/draw_panel.py -- "$(ls build/blender/quadmatch-*.zip)" docs/images/blender_panel.png > "$folder/log" 2>&1 ||
  { cat "$folder/log" >&2; exit 1; }
grep -a '^drawn' "$folder/log" || { cat "$folder/log" >&2; exit 1; }
