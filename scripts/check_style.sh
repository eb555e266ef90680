#!/usr/bin/env bash
# Formatting by clang-format, and nothing left behind that only its author understands.
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t sources < <(git ls-files '*.cpp' '*.hpp')
clang-format-14 --dry-run --Werror "${sources[@]}"

if git grep -nE '\b(TODO|FIXME|XXX|HACK)\b' -- '*.cpp' '*.hpp' '*.sh' '*.py' '*.md' '*.ts' '*.mjs' ':!scripts/check_style.sh'; then
  echo "check_style: finish these or open an issue" >&2
  exit 1
fi
# The layers below the front ends throw nothing and start no threads (docs/design/005-errors-and-exceptions.md).
if git grep -nE '\b(throw|try|catch)\b *[({]|<(thread|mutex|future|atomic)>' -- 'src/*.cpp' 'src/*.hpp' include; then
  echo "check_style: no exceptions and no threads below the front ends" >&2
  exit 1
fi
echo "${#sources[@]} files are formatted"
