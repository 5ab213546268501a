#!/usr/bin/env bash
# Builds the app's library for each target: DEST/ABI/libmain.so, and in target/apk/system/ABI the system libraries that it was linked against.
# usage: tools/apk/libraries.sh debug|release DEST TARGET...     ANDROID_NDK_HOME: as in tools/apk.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
case $1 in release) profile=android ;; debug) profile=android-debug ;; *) sed -n '3s/^# //p' "$0" >&2; exit 2 ;; esac
mkdir -p "$2"; dest=$(cd "$2" && pwd); shift 2
api=28
. tools/needs.sh
if [ -n "${ANDROID_NDK_HOME:-}" ]; then
  for target; do
    [ -d "$(rustc --print sysroot)/lib/rustlib/$target" ] || { echo "Rust has no $target here: rustup target add $target" >&2; exit 1; }
  done
else
  # What a library needs is found out for both: making one of them later would take as long again.
  tools/cross/targets.sh target/cross aarch64-linux-android x86_64-linux-android
  . target/cross/env.sh
fi
bin=$(echo "$ANDROID_NDK_HOME"/toolchains/llvm/prebuilt/*/bin)
for target; do
  case $target in aarch64-*) abi=arm64-v8a ;; x86_64-*) abi=x86_64 ;; *) echo "no ABI for $target" >&2; exit 2 ;; esac
  name=${target//-/_}
  # NDKs before r28 link for pages of 4 KiB unless told.
  flags=-Clink-arg=-Wl,-z,max-page-size=16384
  # Functions that are alike are kept once, and addresses to adjust in a packed list, which what plays Android on a desktop can't read.
  case $target in aarch64-*) flags="$flags -Clink-arg=-Wl,--icf=all -Clink-arg=-Wl,--pack-dyn-relocs=android" ;; esac
  export "CARGO_TARGET_${name^^}_LINKER=$bin/$target$api-clang" "CARGO_TARGET_${name^^}_RUSTFLAGS=$flags"
  export "CC_$name=$bin/$target$api-clang" "AR_$name=$bin/llvm-ar"
  CARGO_TARGET_DIR=target/android cargo rustc --quiet --profile $profile --lib --crate-type cdylib --target "$target"
  mkdir -p "$dest/$abi" "target/apk/system/$abi"
  cp "target/android/$target/$profile/libeffigy.so" "$dest/$abi/libmain.so"
  cp "$bin/../sysroot/usr/lib/$target/$api/"lib*.so "target/apk/system/$abi/"
done
