#!/usr/bin/env bash
# Formats Rust with rustfmt, and the page (JavaScript, TypeScript, CSS, HTML) with prettier.
# usage: tools/format.sh [--check]      --check: change nothing, and fail if a file is not formatted
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
prettier=prettier@3.6.2
need_rust
need 'command -v npx' npm
check=() mode=--write
[ "${1:-}" != --check ] || { check=(--check); mode=--check; }
cargo fmt --all -- ${check[@]+"${check[@]}"}
npx --yes "$prettier" --print-width 100 --log-level warn "$mode" 'src/web/page/*' 'tests/web/*'
