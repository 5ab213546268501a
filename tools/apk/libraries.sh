#!/usr/bin/env bash
# Builds the app's library for each target: DEST/ABI/libmain.so, and in target/apk/system/ABI the system libraries that it was linked against.
# usage: tools/apk/libraries.sh debug|release DEST TARGET...     ANDROID_NDK_HOME: as in tools/apk.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
case $1 in release) profile=android ;; debug) profile=android-debug ;; *) sed -n '3s/^# //p' "$0" >&2; exit 2 ;; esac
mkdir -p "$2"; dest=$(cd "$2" && pwd); shift 2
api=28
build=${CARGO_TARGET_DIR:-target}/android
. tools/needs.sh
[ -n "${ANDROID_NDK_HOME:-}" ] || { echo "ANDROID_NDK_HOME names no NDK: install one (r27 or newer) and set it" >&2; exit 1; }
for target; do need_target "$target"; done
bin=$(echo "$ANDROID_NDK_HOME"/toolchains/llvm/prebuilt/*/bin)
for target; do
  case $target in aarch64-*) abi=arm64-v8a ;; x86_64-*) abi=x86_64 ;; *) echo "no ABI for $target" >&2; exit 2 ;; esac
  name=${target//-/_}
  # NDKs before r28 link for pages of 4 KiB unless told.
  flags=-Clink-arg=-Wl,-z,max-page-size=16384
  # The app says in its log which commit it is.
  EFFIGY_COMMIT=$(git rev-parse --short=12 HEAD 2>/dev/null || echo unknown); export EFFIGY_COMMIT
  # Identical code is folded and relocations are packed to make the file smaller. Not on x86-64: the host harness can't
  # read packed relocations.
  case $target in aarch64-*) flags="$flags -Clink-arg=-Wl,--icf=all -Clink-arg=-Wl,--pack-dyn-relocs=android" ;; esac
  export "CARGO_TARGET_${name^^}_LINKER=$bin/$target$api-clang" "CARGO_TARGET_${name^^}_RUSTFLAGS=$flags"
  export "CC_$name=$bin/$target$api-clang" "AR_$name=$bin/llvm-ar"
  CARGO_TARGET_DIR=$build cargo rustc --quiet --profile $profile -p effigy-app --lib --crate-type cdylib --target "$target"
  mkdir -p "$dest/$abi" "target/apk/system/$abi"
  cp "$build/$target/$profile/libeffigy_app.so" "$dest/$abi/libmain.so"
  cp "$bin/../sysroot/usr/lib/$target/$api/"lib*.so "target/apk/system/$abi/"
done
