#!/usr/bin/env bash
# Tests the installed Python package (scripts/build_python.sh): its types, its stubs, what it does, the examples in docs/python.md.
set -euo pipefail
cd "$(dirname "$0")/.."

python=$PWD/build/python/env/bin/python
MYPYPATH=python "$python" -m mypy --no-error-summary --cache-dir build/python/mypy -p quadmatch
"$python" -m mypy.stubtest --mypy-config-file pyproject.toml --allowlist python/tests/stubs_allowed.txt quadmatch._core > build/python/stubtest.log ||
  { cat build/python/stubtest.log >&2; exit 1; }
# From a folder of its own, so that the package is the installed one.
cd build/python
"$python" -m pytest -q -p no:cacheprovider -c ../../pyproject.toml --rootdir ../.. ../../python/tests "$@"
