#!/usr/bin/env bash
# Makes the page and tests it in Chromium, on its software adapter. Images are left in target/web-tests.
# usage: tools/test_web.sh [PAGE_DIR]      [default: one that it makes]
# CHROMIUM: which browser; EFFIGY: a program that is built already
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
case ${1:-} in -*) usage >&2; exit 2 ;; esac
page=${1:-target/web} out=target/web-tests
export CHROMIUM=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}
[ -n "$CHROMIUM" ] || { need 'command -v chromium' chromium; CHROMIUM=$(command -v chromium); }
need 'command -v npm' npm
[ $# -gt 0 ] || tools/web.sh "$page"
mkdir -p "$out"
[ -d "$out/node_modules/playwright-core" ] || npm install --prefix "$out" --no-save --no-package-lock --no-audit --no-fund playwright-core@1.65.1 >/dev/null
effigy render --reference --size 512x512 --time 1.3 --out "$out/reference.png"
cp tests/web/*.mjs "$out/"
# Where the newest build has put the shaders.
wgsl=$(find "${CARGO_TARGET_DIR:-target}" -path '*/build/effigy-wgsl-*/out/mlp/mlp.wgsl' -printf '%T@ %p\n' | sort -n | tail -n 1 | cut -d ' ' -f 2-)
[ -n "$wgsl" ] || { echo "effigy-wgsl was not built below ${CARGO_TARGET_DIR:-target}" >&2; exit 1; }
export EFFIGY_WGSL=${wgsl%/mlp/mlp.wgsl}
timeout -k 10 1500 node "$out/page.mjs" "$page" "$out/reference.png" "$out"
[ -z "${ONLY:-}" ] || exit 0
# What the page measures is a report like any other.
# Into a file: a reader that ends at its match closes the pipe on a program that still writes, which fails now and then.
effigy compare "$out/bench.json" "$out/bench.json" > "$out/compare.txt"
grep -q frame_ms_median "$out/compare.txt"
