#!/usr/bin/env bash
# Installs what is missing of Debian 12's packages: install.sh SET...  Sets: core tests python blender bench quality browser viewer web cluster package docs.
# Asks nothing, changes nothing where all is there already.
set -euo pipefail

declare -A sets=(
  [core]="g++ cmake ninja-build libcli11-dev libfmt-dev nlohmann-json3-dev libxxhash-dev libeigen3-dev libboost-dev libsqlite3-dev libcsv-dev libtbb-dev libembree-dev libpng-dev libwebp-dev"
  [tests]="doctest-dev libtinyobjloader-dev libbliss-dev libgmp-dev git python3"
  [python]="pybind11-dev python3-dev python3-venv python3-pip python3-setuptools python3-wheel python3-pybind11 python3-numpy python3-pytest python3-hypothesis python3-meshio mypy"
  [blender]="blender python3-numpy libegl1 libgl1-mesa-dri xvfb"
  [bench]="libbenchmark-dev libtinyobjloader-dev libbliss-dev libgmp-dev python3 python3-matplotlib"
  [quality]="clang-14 clang-format-14 clang-tidy-16 libclang-rt-14-dev"
  [browser]="clang-19 lld-19 libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 wasi-libc"
  [viewer]="nodejs npm"
  [web]="chromium ffmpeg"
  [cluster]="slurm-wlm munge python3 python3-dask python3-distributed"
  [package]="dpkg-dev file man-db pkg-config"
  [docs]="mkdocs-material python3-matplotlib"
)

missing=()
for set in "$@"; do
  for package in ${sets[$set]:?no such set: $set}; do
    # Other builds of node bring npm along, and Debian's would not go with them.
    [ "$package" = npm ] && command -v npm > /dev/null && continue
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
done
[ ${#missing[@]} -eq 0 ] && exit 0

echo "installing ${missing[*]}"
as_root=()
[ "$(id -u)" = 0 ] || as_root=(sudo)
log=$(mktemp)
trap 'rm -f "$log"' EXIT
export DEBIAN_FRONTEND=noninteractive
if ! { "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=600 update &&
       "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=600 install --no-install-recommends -y "${missing[@]}"; } \
    > "$log" 2>&1; then
  cat "$log" >&2
  echo "install.sh: apt-get could not install: ${missing[*]}" >&2
  exit 1
fi
