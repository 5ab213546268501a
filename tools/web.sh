#!/usr/bin/env bash
# Makes the page: the library for browsers, its JavaScript, the demo, and what shows them. Any static host serves the result.
# usage: tools/web.sh [--serve] [--quick] [OUT_DIR]      [default: target/web]
#   --serve: at http://localhost:8000 (PORT) afterwards
#   --quick: without link-time optimisation: larger, and made in a fifth of the time; for tests
# Needs Rust's target wasm32-unknown-unknown, which it asks rustup for where it is missing.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
serve='' profile=web
while [ $# -gt 0 ]; do
  case $1 in
    --serve) serve=1; need 'command -v python3' python3 ;;
    --quick) profile=web-quick ;;
    -*) usage >&2; exit 2 ;;
    *) break ;;
  esac
  shift
done
out=${1:-target/web} target=wasm32-unknown-unknown
need_rust
need_target $target
need 'command -v gzip' gzip

bind() { # IN OUT: the JavaScript around the library
  local version; version=$(sed -n '/^name = "wasm-bindgen"$/{n;s/version = "\(.*\)"/\1/p}' Cargo.lock)
  if [ "$(wasm-bindgen --version 2>/dev/null)" = "wasm-bindgen $version" ]; then
    wasm-bindgen --target web --no-typescript --remove-name-section --remove-producers-section --out-name effigy_core --out-dir "$2" "$1"
    return
  fi
  sed -i "s/^\(wasm-bindgen-cli-support = \"=\).*\"/\1$version\"/" tools/web/bind/Cargo.toml
  # With the host's own compiler, whichever one makes the library.
  env -u RUSTC CARGO_TARGET_DIR="$build/bind" cargo run --quiet --release --manifest-path tools/web/bind/Cargo.toml -- "$1" "$2" effigy_core
}

build=${CARGO_TARGET_DIR:-target}/web-build
mkdir -p "$out" "$build"; build=$(cd "$build" && pwd)
CARGO_TARGET_DIR=$build cargo rustc --profile $profile -p effigy-web --lib --target $target --crate-type cdylib
bind "$build/$target/$profile/effigy_web.wasm" "$out"
cp src/web/page/* src/demo/demo.avatar src/demo/demo.motion "$out/"
# The names and the contents of all that a page needs, so that what is kept for use offline is what belongs together.
kept=(index.html page.css demo.avatar demo.motion effigy_core_bg.wasm)
for script in "$out"/*.js; do [ "${script##*/}" = sw.js ] || kept+=("${script##*/}"); done
stamp=$(cd "$out" && cat "${kept[@]}" | sha256sum | cut -c1-12)
sed -i "s/@STAMP@/$stamp/; s/\"@FILES@\"/$(printf '"%s", ' "${kept[@]}" | sed 's/, $//')/" "$out/sw.js"
size=$(cat "$out"/effigy_core_bg.wasm "$out"/*.js | gzip -9 | wc -c)
echo "$out: wasm and JavaScript are $size bytes gzipped"
[ $profile != web ] || [ "$size" -le 700000 ] || { echo "that is more than 700,000" >&2; exit 1; }
[ -z "$serve" ] || exec python3 -m http.server --directory "$out" "${PORT:-8000}"
