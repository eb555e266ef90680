#!/usr/bin/env bash
# Builds the Python package's wheel into build/python/, offline, and installs it into a fresh environment there:
# build/python/env/bin/python -c 'import quadmatch'. CMAKE_ARGS is handed to CMake.
set -euo pipefail
cd "$(dirname "$0")/.."

python=/usr/bin/python3  # Debian's, which sees Debian's NumPy; another one on PATH may not
mkdir -p build/python
rm -rf build/python/env build/python/*.whl
"$python" -m pip wheel . --no-build-isolation --no-deps --no-index --wheel-dir build/python > build/python/wheel.log 2>&1 ||
  { tail -n 40 build/python/wheel.log >&2; exit 1; }
"$python" -m venv --system-site-packages build/python/env
build/python/env/bin/pip install --quiet --no-index --no-deps build/python/*.whl
