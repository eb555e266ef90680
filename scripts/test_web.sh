#!/usr/bin/env bash
# Opens reports of the release build, and the page, in Debian's chromium, and holds what is seen and saved against the program.
# Needs scripts/install.sh browser web, scripts/build_web.sh once, and a release build.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/build_page.sh
cd web
node --test browser/*.test.mjs
