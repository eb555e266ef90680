#!/usr/bin/env bash
# Builds the engine of the page: the layers below the front ends and apps/page as one WebAssembly file, build/wasm/quadmatch.wasm.
# They do without exceptions and threads there. Needs scripts/install.sh core browser. Does nothing where the file is newer than
# all it is made of.
set -euo pipefail
cd "$(dirname "$0")/.."
out=build/wasm
engine=$out/quadmatch.wasm
# Of the command line what turns options, matches and merges into words: the page says the same.
words=(text dirt match_arguments match_report merge_report transfer_report)
mapfile -t sources < <(git ls-files 'src/*.cpp' 'apps/page/*.cpp' ':!src/picture'; printf 'apps/quadmatch/%s.cpp\n' "${words[@]}")
if [ -e $engine ] && [ -z "$(find src include apps/page apps/quadmatch CMakeLists.txt "$0" -type f -newer $engine -print -quit)" ]; then
  echo "$engine: $(stat -c %s $engine) bytes"
  exit 0
fi

mkdir -p $out/include
# Header-only libraries, without the rest of the host's headers.
for library in fmt nlohmann xxhash.h xxh3.h boost eigen3/Eigen; do
  [ -e $out/include/${library#*/} ] || ln -s /usr/include/$library $out/include/${library#*/}
done
version=$(sed -n 's/^project(quadmatch VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
cmake -DINPUT=src/report/no_viewer.html -DVIEWER=false -DOUTPUT=$out/page.cpp -P cmake/embed.cmake
cp src/report/page.hpp $out/include

# Every browser of the last years knows these extensions of WebAssembly.
target="--target=wasm32-wasi -O3 -flto -msimd128 -mbulk-memory -mnontrapping-fptoint -msign-ext"
compile() {
  ${CMAKE_CXX_COMPILER_LAUNCHER:-} clang++-19 $3 -std=c++20 -fno-exceptions -fno-rtti -Wall -Wextra -Werror \
    -DFMT_HEADER_ONLY -DFMT_EXCEPTIONS=0 -DJSON_NOEXCEPTION -D_LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION \
    -DQUADMATCH_VERSION="\"$4\"" -isystem "$1/include" -Iinclude -I"$(dirname "$2")" -c "$2" -o "$1/$(echo "$2" | tr / _).o"
}
export -f compile
rm -f $out/*.o
printf '%s\n' "${sources[@]}" $out/page.cpp | xargs -P "$(nproc)" -I{} bash -c 'compile "$@"' - $out {} "$target" "$version"
# Only what apps/page/exports.cpp names is kept; of an hour's recursion there is none, so 1 MB of stack is plenty.
clang++-19 $target -mexec-model=reactor -Wl,--strip-all -Wl,-z,stack-size=1048576 $out/*.o -o $engine
echo "$engine: $(stat -c %s $engine) bytes"
