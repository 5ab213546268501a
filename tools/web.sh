#!/usr/bin/env bash
# Makes the page: the library for browsers, its JavaScript, the demo, and what shows them. Any static host serves the result.
# usage: tools/web.sh [--serve] [OUT_DIR]      [default: target/web]      --serve: at http://localhost:8000 (PORT) afterwards
# It takes Rust's target wasm32-unknown-unknown where that is installed, and makes it where it isn't (tools/cross/targets.sh).
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
serve=
[ "${1:-}" != --serve ] || { serve=1; shift; }
out=${1:-target/web} target=wasm32-unknown-unknown
need_rust
need 'command -v gzip' gzip

bind() { # IN OUT: the JavaScript around the library
  local version; version=$(sed -n '/^name = "wasm-bindgen"$/{n;s/version = "\(.*\)"/\1/p}' Cargo.lock)
  if [ "$(wasm-bindgen --version 2>/dev/null)" = "wasm-bindgen $version" ]; then
    wasm-bindgen --target web --no-typescript --remove-name-section --remove-producers-section --out-name effigy_core --out-dir "$2" "$1"
    return
  fi
  sed -i "s/^\(wasm-bindgen-cli-support = \"=\).*\"/\1$version\"/" tools/web/bind/Cargo.toml
  CARGO_TARGET_DIR=target/web-bind cargo run --quiet --release --manifest-path tools/web/bind/Cargo.toml -- "$1" "$2" effigy_core
}

build=target/web-build
mkdir -p "$out"
if [ ! -d "$(rustc --print sysroot)/lib/rustlib/$target" ]; then
  echo "Rust has no $target here: making it"
  tools/cross/targets.sh target/cross-web $target || { echo "it can't be made here: 'rustup target add $target' installs it" >&2; exit 1; }
  # What was built with another standard library, of a target made anew for instance, does not fit.
  build=target/cross-web/build
fi
(
  [ $build = target/web-build ] || . target/cross-web/env.sh
  CARGO_TARGET_DIR=$build cargo rustc --profile web --lib --no-default-features --target $target --crate-type cdylib
)
bind "$build/$target/web/effigy.wasm" "$out"
cp src/web/page/* android/assets/demo.avatar android/assets/demo.motion "$out/"
# The names and the contents of all that a page needs, so that what is kept for use offline is what belongs together.
kept=(index.html page.css demo.avatar demo.motion effigy_core_bg.wasm)
for script in "$out"/*.js; do [ "${script##*/}" = sw.js ] || kept+=("${script##*/}"); done
stamp=$(cd "$out" && cat "${kept[@]}" | sha256sum | cut -c1-12)
sed -i "s/@STAMP@/$stamp/; s/@FILES@/$(printf '"%s", ' "${kept[@]}" | sed 's/, $//')/" "$out/sw.js"
size=$(cat "$out"/effigy_core_bg.wasm "$out"/*.js | gzip -9 | wc -c)
echo "$out: wasm and JavaScript are $size bytes gzipped"
[ "$size" -le 700000 ] || { echo "that is more than 700,000" >&2; exit 1; }
[ -z "$serve" ] || exec python3 -m http.server --directory "$out" "${PORT:-8000}"
