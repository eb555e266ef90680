#!/usr/bin/env bash
# Compiles the layers below the front ends as they will run in a browser: WebAssembly, no exceptions, no threads.
set -euo pipefail
cd "$(dirname "$0")/.."
out=build/wasm
mkdir -p $out/include
# Header-only libraries, without the rest of the host's headers.
for library in fmt nlohmann xxhash.h xxh3.h boost eigen3/Eigen; do
  [ -e $out/include/${library#*/} ] || ln -s /usr/include/$library $out/include/${library#*/}
done
compile() {
  object=$1/$(echo "$2" | tr / _).o
  clang++-19 --target=wasm32-wasi -std=c++20 -O2 -fno-exceptions -fno-rtti -Wall -Wextra -Werror \
    -DFMT_HEADER_ONLY -DFMT_EXCEPTIONS=0 -DJSON_NOEXCEPTION -D_LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION -isystem $1/include -Iinclude -I"$(dirname "$2")" -c "$2" -o "$object"
}
export -f compile
cmake -DINPUT=src/report/no_viewer.html -DVIEWER=false -DOUTPUT=$out/page.cpp -P cmake/embed.cmake
cp src/report/page.hpp $out/include
{ git ls-files 'src/*.cpp'; echo $out/page.cpp; } | xargs -P "$(nproc)" -I{} bash -c 'compile "$0" {}' $out
clang++-19 --target=wasm32-wasi -mexec-model=reactor -Wl,--export-all -Wl,--no-entry $out/*.o -o $out/quadmatch.wasm
echo "$out/quadmatch.wasm: $(stat -c %s $out/quadmatch.wasm) bytes"
