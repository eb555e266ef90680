#!/usr/bin/env bash
# Tests the built add-on zip (scripts/build_blender.sh) in headless Blender, away from the user's own settings.
# usage: test_blender.sh [PATTERN]   PATTERN: files of blender/tests, e.g. 'test_match.py'
set -euo pipefail
cd "$(dirname "$0")/.."

command -v blender > /dev/null || { echo "test_blender: there is no blender; run scripts/install.sh blender" >&2; exit 1; }
zip=$(ls build/blender/quadmatch-*.zip)
folder=$PWD/build/blender/tests
rm -rf "$folder"
export PATH=/usr/bin:/bin  # Debian's Blender looks for Python's modules beside the first python3 on PATH
export QUADMATCH_BUILD=${QUADMATCH_BUILD:-$PWD/build/release} QUADMATCH_TEST_FOLDER=$folder

# Each run of Blender has folders of its own for settings and add-ons, and shows what it said only if it failed.
in_blender() {
  local name=$1
  shift
  mkdir -p "$folder/$name/scripts" "$folder/$name/config"
  BLENDER_USER_SCRIPTS=$folder/$name/scripts BLENDER_USER_CONFIG=$folder/$name/config \
    blender -b --factory-startup --python-exit-code 3 --python "$@" > "$folder/$name.log" 2>&1 ||
    { grep -A 10000 '^=====' "$folder/$name.log" >&2 || cat "$folder/$name.log" >&2; exit 1; }
  grep -E '^(Ran |OK|.* exact, |.*skipped)' "$folder/$name.log"
}

in_blender fitting blender/tests/run.py -- "$zip" "$@"
[ $# = 0 ] || exit 0

# The same zip, its module named as if built for another Python.
/usr/bin/python3 - "$zip" "$folder/unfitting.zip" << 'EOF'
import re
import sys
import zipfile

with zipfile.ZipFile(sys.argv[1]) as given, zipfile.ZipFile(sys.argv[2], "w") as made:
    for name in given.namelist():
        made.writestr(re.sub(r"_core\.[^/]*\.so$", "_core.cpython-37m-x86_64-linux-gnu.so", name), given.read(name))
EOF
in_blender unfitting blender/tests/unfitting.py -- "$folder/unfitting.zip" "$QUADMATCH_BUILD/quadmatch"
