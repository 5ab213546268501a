#!/usr/bin/env bash
# Formats Rust with rustfmt, and the page (JavaScript, TypeScript, CSS, HTML) with prettier.
# usage: tools/format.sh [--check]      --check: change nothing, and fail if a file is not formatted
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
check=() mode=--write
case ${1:-} in
  '') ;;
  --check) check=(--check) mode=--check ;;
  *) usage >&2; exit 2 ;;
esac
prettier=prettier@3.6.2
need_rust
need 'command -v npx' npm
cargo fmt --all -- ${check[@]+"${check[@]}"}
npx --yes "$prettier" --print-width 100 --log-level warn "$mode" 'src/web/page/*' 'tests/web/*'
