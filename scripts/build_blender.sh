#!/usr/bin/env bash
# Packs the Blender add-on, with the Python package inside, into build/blender/quadmatch-VERSION-PYTHON-PLATFORM.zip.
# The package is that of build/python/*.whl (scripts/build_python.sh).
set -euo pipefail
cd "$(dirname "$0")/.."

wheel=$(ls build/python/quadmatch-*.whl 2> /dev/null) || { echo "build_blender: no wheel in build/python; run scripts/build_python.sh first" >&2; exit 1; }
version=$(sed -n 's/.*project(quadmatch VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
grep -q "\"version\": (${version//./, })," blender/quadmatch_addon/__init__.py ||
  { echo "build_blender: bl_info in blender/quadmatch_addon/__init__.py does not say version $version" >&2; exit 1; }

rm -rf build/blender/*.zip
mkdir -p build/blender
/usr/bin/python3 - "$wheel" "build/blender/quadmatch-$version-$(basename "$wheel" .whl | cut -d- -f3,5).zip" << 'EOF'
import pathlib
import sys
import zipfile

wheel, output = sys.argv[1:]
ADDON = "quadmatch_addon"
EPOCH = (2020, 1, 1, 0, 0, 0)  # the same input gives the same zip


def files():
    folder = pathlib.Path("blender", ADDON)
    for path in sorted(folder.glob("*.py")):
        yield f"{ADDON}/{path.name}", path.read_bytes()
    yield f"{ADDON}/LICENSE", pathlib.Path("LICENSE").read_bytes()
    with zipfile.ZipFile(wheel) as package:
        for name in sorted(package.namelist()):
            if name.startswith("quadmatch/"):
                yield f"{ADDON}/vendor/{name}", package.read(name)


with zipfile.ZipFile(output, "w") as archive:
    for name, data in files():
        archive.writestr(zipfile.ZipInfo(name, EPOCH), data, zipfile.ZIP_DEFLATED)
print(output)
EOF
