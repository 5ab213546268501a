#!/usr/bin/env bash
# Makes the page: the libraries for browsers, their JavaScript, the demo, and what shows them. Any static host serves the
# result. The library that reads other programs' files is loaded only by those who open one, and has a limit of its own.
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

bind() { # IN OUT NAME: the JavaScript around a library
  local version; version=$(sed -n '/^name = "wasm-bindgen"$/{n;s/version = "\(.*\)"/\1/p}' Cargo.lock)
  if [ "$(wasm-bindgen --version 2>/dev/null)" = "wasm-bindgen $version" ]; then
    wasm-bindgen --target web --no-typescript --remove-name-section --remove-producers-section --out-name "$3" --out-dir "$2" "$1"
    return
  fi
  sed -i "s/^\(wasm-bindgen-cli-support = \"=\).*\"/\1$version\"/" tools/web/bind/Cargo.toml
  # With the host's own compiler, whichever one makes the library.
  env -u RUSTC CARGO_TARGET_DIR="$build/bind" cargo run --quiet --release --manifest-path tools/web/bind/Cargo.toml -- "$1" "$2" "$3"
}

build=${CARGO_TARGET_DIR:-target}/web-build
mkdir -p "$out" "$build"; build=$(cd "$build" && pwd)
for package in effigy-web effigy-web-import; do
  CARGO_TARGET_DIR=$build cargo rustc --profile $profile -p $package --lib --target $target --crate-type cdylib
done
bind "$build/$target/$profile/effigy_web.wasm" "$out" effigy_core
bind "$build/$target/$profile/effigy_web_import.wasm" "$out" effigy_import
cp src/web/page/* src/demo/demo.avatar src/demo/demo.motion "$out/"
# The names and the contents of all that a page needs, so that what is kept for use offline is what belongs together.
kept=(index.html page.css demo.avatar demo.motion effigy_core_bg.wasm)
later=(import_worker.js effigy_import.js effigy_import_bg.wasm)
is_later() { case " ${later[*]} " in *" $1 "*) ;; *) return 1 ;; esac; }
first=("$out/effigy_core_bg.wasm")
for script in "$out"/*.js; do
  name=${script##*/}
  is_later "$name" && continue
  first+=("$script")
  [ "$name" = sw.js ] || kept+=("$name")
done
stamp=$(cd "$out" && cat "${kept[@]}" "${later[@]}" | sha256sum | cut -c1-12)
list() { printf '"%s", ' "$@" | sed 's/, $//'; }
sed -i "s/@STAMP@/$stamp/; s/\"@FILES@\"/$(list "${kept[@]}")/; s/\"@LATER@\"/$(list "${later[@]}")/" "$out/sw.js"
at_most() { # WHAT BYTES FILE...
  local what=$1 most=$2 size; shift 2
  size=$(cat "$@" | gzip -9 | wc -c)
  echo "$out: $what: $size bytes gzipped"
  [ $profile != web ] || [ "$size" -le "$most" ] || { echo "that is more than $most" >&2; exit 1; }
}
at_most "wasm and JavaScript" 430000 "${first[@]}"
at_most "what reads other programs' files" 650000 "${later[@]/#/$out/}"
[ -z "$serve" ] || exec python3 -m http.server --directory "$out" "${PORT:-8000}"
