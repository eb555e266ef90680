#!/usr/bin/env bash
# Installs, uses and removes what packages give: `cmake --install` into a folder, with a project that finds it by CMake and by
# pkg-config; then the Debian packages, in place. usage: scripts/test_package.sh [BUILD]   (a release build; needs root)
set -euo pipefail
cd "$(dirname "$0")/.."
build=$(realpath "${1:-build/release}")
work=$(mktemp -d)
as_root=()
[ "$(id -u)" = 0 ] || as_root=(sudo)

fail() { echo "test_package.sh: $*" >&2; exit 1; }
installed() { dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null | grep -qx installed; }
if installed quadmatch || installed libquadmatch-dev; then
  fail "quadmatch is installed here already; remove it first: apt-get purge quadmatch libquadmatch-dev"
fi
clean_up() {
  rm -rf "$work"
  "${as_root[@]}" dpkg --purge libquadmatch-dev quadmatch > /dev/null 2>&1 || true
}
trap clean_up EXIT

echo "-- cmake --install, and a project that finds it"
cmake --install "$build" --prefix "$work/prefix" > "$work/install.log"
cmake -S tests/package -B "$work/consumer" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$work/prefix" > "$work/cmake.log"
cmake --build "$work/consumer"
"$work/consumer/first_program" | grep "faces matched"
"$work/consumer/consumer" examples/fig_4_1.obj

echo "-- the same by pkg-config"
folder=$(dirname "$(find "$work/prefix" -name quadmatch.pc)")
# shellcheck disable=SC2046  # the flags are words
g++ -std=c++20 tests/package/consumer.cpp -o "$work/by_pkg_config" \
  $(PKG_CONFIG_PATH="$folder" pkg-config --static --cflags --libs quadmatch)
"$work/by_pkg_config" examples/fig_4_1.obj

echo "-- every public header is there"
for header in include/quadmatch/*.hpp include/quadmatch/{mesh,io,analysis,match,use,verify,report}/*.hpp; do
  name=${header#include/}
  [ -f "$work/prefix/include/$name" ] || fail "$name is not installed"
done

echo "-- the Debian packages"
(cd "$build" && cpack -G DEB -B "$work/deb" > "$work/cpack.log") || { cat "$work/cpack.log"; fail "cpack"; }
ls "$work"/deb/*.deb
before=$(find /usr /etc -xdev -path /usr/share/man -prune -o -iname '*quadmatch*' -print | sort)
"${as_root[@]}" dpkg -i "$work"/deb/*.deb > "$work/dpkg.log" 2>&1 || { cat "$work/dpkg.log"; fail "dpkg -i"; }
[ "$(command -v quadmatch)" = /usr/bin/quadmatch ] || hash -r
(cd "$work" && /usr/bin/quadmatch match "$OLDPWD/examples/fig_4_1.obj" "$OLDPWD/examples/fig_4_1.obj" -o match.json --quiet)
dpkg-deb -f "$work"/deb/quadmatch_*.deb Depends | grep -q libsqlite3 || fail "the package does not know what it needs"

echo "-- manual pages and completions"
# Images of containers leave manual pages out of packages; then the page of the package itself is looked at.
page=/usr/share/man/man1/quadmatch.1
if [ ! -f "$page" ]; then
  dpkg-deb -x "$work"/deb/quadmatch_*.deb "$work/unpacked"
  page=$work/unpacked$page
  echo "   (this system leaves out manual pages: $(grep -rl 'path-exclude.*man' /etc/dpkg/dpkg.cfg.d || true))"
fi
folder=$(dirname "$(dirname "$page")")
for verb in "" -match -batch -index -find; do
  MANWIDTH=100 man -M "$folder" "quadmatch$verb" > "$work/page.txt" 2> "$work/page.err" || fail "man quadmatch$verb"
  grep -q "^NAME" "$work/page.txt" || fail "man quadmatch$verb: no such section"
  man -M "$folder" --warnings=w "quadmatch$verb" 2>&1 > /dev/null | grep -v "cannot.*adjust\|can't break" && fail "man quadmatch$verb warns"
done
MANWIDTH=100 man -M "$folder" quadmatch-find | grep -q -- "--no-match" || fail "the page of find does not name --no-match"
# What bash answers to `quadmatch fi<TAB>` and `quadmatch find --no<TAB>`.
answers=$(bash -c '
  source /usr/share/bash-completion/completions/quadmatch
  ask() { COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _quadmatch 2> /dev/null; echo "${COMPREPLY[@]}"; }
  ask quadmatch fi; ask quadmatch find --no; ask quadmatch batch-m')
[ "$answers" = "$(printf 'find\n--no-match\nbatch-merge')" ] || fail "bash completes to: $answers"
for shell in zsh fish; do
  script=$(dpkg -L quadmatch | grep "/$shell/.*quadmatch")
  [ -s "$script" ] || fail "no completion for $shell"
  grep -q no-match "$script" || fail "$script does not name --no-match"
  ! command -v $shell > /dev/null || $shell -n "$script" || fail "$script is not understood by $shell"
done

echo "-- removed cleanly"
"${as_root[@]}" dpkg --purge libquadmatch-dev quadmatch > "$work/purge.log" 2>&1 || { cat "$work/purge.log"; fail "dpkg --purge"; }
after=$(find /usr /etc -xdev -path /usr/share/man -prune -o -iname '*quadmatch*' -print | sort)
[ "$before" = "$after" ] || fail "left behind: $(diff <(echo "$before") <(echo "$after"))"
[ -z "$(find /usr/share/man -name 'quadmatch*')" ] || fail "manual pages are left behind"
echo "test_package.sh: all is well"
