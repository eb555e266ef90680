#!/usr/bin/env bash
# Opens reports of the release build in Debian's chromium, and holds what is seen against the match files.
# Needs scripts/install.sh web, scripts/build_web.sh once, and a release build.
set -euo pipefail
cd "$(dirname "$0")/../web"
node --test browser/*.test.mjs
