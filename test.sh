#!/usr/bin/env bash
# On a fresh Debian 12: installs what is missing and runs all tests. usage: ./test.sh [--core]
#   --core  only what needs small packages: no fuzzing, linting, WebAssembly, browser, Blender or documentation
set -euo pipefail
cd "$(dirname "$0")"

core=no
case "${1:-}" in
  "") ;;
  --core) core=yes ;;
  *) sed -n '2,3s/^# //p' "$0" >&2; exit 2 ;;
esac

stage() { printf '\n== %s (%ds)\n' "$1" "$SECONDS"; }
build() { cmake --preset "$1" > build/"$1".log || { cat build/"$1".log; exit 1; }; cmake --build --preset "$1"; }

mkdir -p build
stage "install what is missing"
scripts/install.sh core viewer tests bench python
[ $core = yes ] || scripts/install.sh quality browser web cluster docs blender

if [ $core = no ]; then
  stage "format and habits"
  scripts/check_style.sh
fi

stage "the viewer of reports"
scripts/build_web.sh --test

stage "the layers below the front ends, without exceptions"
build no-exceptions
if [ $core = no ]; then
  stage "the same as WebAssembly, the engine of the page: without threads either"
  scripts/build_wasm.sh
fi

stage "release build"
cmake --preset release -DQUADMATCH_DEVELOPER=ON > /dev/null
cmake --build --preset release
stage "sanitized build"
build sanitize

if [ $core = no ]; then
  stage "lint"
  scripts/lint.sh
  stage "fuzz the readers, briefly"
  scripts/fuzz.sh 20
  stage "documentation"
  mkdocs build --strict --quiet --site-dir build/site
fi

if [ $core = no ]; then
  stage "reports and the page in a browser"
  scripts/test_web.sh
fi

stage "the Python package: a wheel, in a fresh environment"
CMAKE_ARGS="-DQUADMATCH_DEVELOPER=ON" scripts/build_python.sh
stage "tests of the Python package"
scripts/test_python.sh

stage "many pairs, killed and resumed"
scripts/test_batch.py
if [ $core = no ]; then
  stage "many pairs through Slurm"
  scripts/test_cluster.sh
fi
if [ $core = no ]; then
  stage "the Blender add-on, installed from its zip"
  scripts/build_blender.sh
  scripts/test_blender.sh
fi

stage "packages: installed, used, removed"
scripts/install.sh package
scripts/test_package.sh

stage "tests, sanitized"
ctest --preset sanitize -j 2 --timeout 1200
stage "tests"
ctest --preset release -j 2 --timeout 600
