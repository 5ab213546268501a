#!/usr/bin/env bash
# Makes what building for Android or browsers takes on a Debian 12 machine that has neither rustup's targets for them nor an NDK:
#   - a Rust compiler with its source (Debian's rustc-web, unpacked, not installed), and from that source the targets' standard library;
#   - for Android a folder laid out as an NDK, with LLVM's linker behind the names of its compilers, and system libraries that export
#     what android-symbols.txt lists and nothing else.
# It links but compiles no C: every dependency has to be Rust. tools/apk.sh calls it where ANDROID_NDK_HOME is not set, tools/web.sh where
# Rust has no wasm32-unknown-unknown.
# usage: tools/cross/targets.sh DEST TARGET...     TARGET: aarch64-linux-android, x86_64-linux-android, wasm32-unknown-unknown
# Then: . DEST/env.sh
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"; dest=$(cd "$1" && pwd); shift
[ $# -gt 0 ] || set -- aarch64-linux-android
api=28
command -v apt-get >/dev/null || { echo "no apt-get here: add $* with rustup, and for Android set ANDROID_NDK_HOME to an NDK" >&2; exit 1; }

as_root() { if [ "$(id -u)" = 0 ]; then "$@"; else sudo "$@"; fi; }
say() { echo "  [$SECONDS s] $1"; }
target_lib() { echo "$dest/ndk/toolchains/llvm/prebuilt/linux-x86_64/sysroot/usr/lib/$1/$api"; }
emulation() { case $1 in aarch64-*) echo aarch64linux ;; x86_64-*) echo elf_x86_64 ;; *) echo "no linker for $1" >&2; return 1 ;; esac; }

# The system's libraries, with the names that the list allows.
system_libraries() {
  local target library
  for target; do
    for library in $(sed -n 's/^\(lib[a-z]*\.so\):.*/\1/p' "$here/android-symbols.txt" | sort -u); do
      sed -n "s/^$library: *//p" "$here/android-symbols.txt" | tr ' ' '\n' | sed '/^$/d;s/$/ = 0;/' > "$dest/exports.ld"
      "$dest/bin/ld.lld" -m "$(emulation "$target")" -shared -soname "$library" -o "$(target_lib "$target")/$library" "$dest/exports.ld"
    done
  done
  rm -f "$dest/exports.ld"
}

phones=(); for target; do case $target in *-android) phones+=("$target") ;; esac; done
key="$(cat "$0" "$here"/link.sh "$here"/unwind/Cargo.toml "$here"/unwind/src/lib.rs | sha256sum | cut -c1-16) $dest $*"
if [ "$(cat "$dest/made" 2>/dev/null)" = "$key" ]; then
  [ "$dest/made" -nt "$here/android-symbols.txt" ] || { system_libraries ${phones[@]+"${phones[@]}"}; touch "$dest/made"; }
  exit 0
fi
rm -rf "$dest"; mkdir -p "$dest/bin" "$dest/packages"

say "packages"
as_root apt-get -o DPkg::Lock::Timeout=300 update -qq
needs() { apt-cache show --no-all-versions "$1" | sed -n 's/^Depends: //p' | tr ',|' '\n\n' | awk '{print $1}' | grep -E "$2" | sed -n 1p; }
std=$(needs libstd-rust-web-dev '^libstd-rust-web-[0-9.]+$')
llvm=$(needs "$std" '^libllvm[0-9]+$'); version=${llvm#libllvm}
(cd "$dest/packages" && for try in 1 2 3; do
  apt-get download -qq rustc-web libstd-rust-web-dev "$std" rust-web-src "$llvm" "lld-$version" libedit2 libz3-4 libxml2 libbsd0 libmd0 libicu72 \
    >/dev/null 2>apt.log && break
  [ $try != 3 ] || { cat apt.log >&2; exit 1; }
done)
for package in "$dest"/packages/*.deb; do dpkg -x "$package" "$dest"; done
rm -rf "$dest/packages"

wrap() { # NAME PROGRAM: a script that finds its own libraries
  printf '#!/bin/sh\nexport LD_LIBRARY_PATH="%s/usr/lib/x86_64-linux-gnu${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" PATH="%s/usr/bin:$PATH"\nexec "%s" "$@"\n' \
    "$dest" "$dest" "$2" > "$dest/bin/$1"; chmod +x "$dest/bin/$1"
}
wrap rustc "$dest/usr/bin/rustc"
wrap rustdoc "$dest/usr/bin/rustdoc"
wrap ld.lld "$dest/usr/lib/llvm-$version/bin/ld.lld"
ln -sfn "../lib/llvm-$version/bin/lld" "$dest/usr/bin/rust-lld"
# The crate that aborts has to be built so that it aborts, as Rust's own build does.
printf '#!/bin/sh\ncase " $* " in *" --crate-name panic_abort "*) set -- "$@" -C panic=abort ;; esac\nexec "%s/bin/rustc" "$@"\n' "$dest" > "$dest/bin/rustc-std"
chmod +x "$dest/bin/rustc-std"

say "the standard library for $*"
mkdir -p "$dest/std/src"; echo '#![no_std]' > "$dest/std/src/lib.rs"
printf '[package]\nname = "empty"\nversion = "0.0.0"\nedition = "2024"\n[profile.release]\ndebug = 0\n[workspace]\n' > "$dest/std/Cargo.toml"
targets=(); for target; do targets+=(--target "$target"); done
(cd "$dest/std" && RUSTC="$dest/bin/rustc-std" RUSTC_WRAPPER='' RUSTC_BOOTSTRAP=1 RUSTFLAGS=-Cembed-bitcode=yes CARGO_TARGET_DIR="$dest/std/target" \
  cargo build --quiet --release -Zbuild-std=std,panic_abort,panic_unwind,proc_macro "${targets[@]}")

for target; do
  lib="$dest/usr/lib/rustlib/$target/lib"; mkdir -p "$lib"
  find "$dest/std/target/$target/release/deps" \( -name '*.rlib' -o -name '*.rmeta' \) ! -name 'libempty-*' -exec cp {} "$lib" \;
done
for target in ${phones[@]+"${phones[@]}"}; do
  tools="$dest/ndk/toolchains/llvm/prebuilt/linux-x86_64"; system=$(target_lib "$target"); mkdir -p "$tools/bin" "$system"
  rm -rf "$dest/unwind"; cp -r "$here/unwind" "$dest/unwind"
  (cd "$dest/unwind" && RUSTC="$dest/bin/rustc" CARGO_TARGET_DIR="$dest/unwind/target" cargo build --quiet --release --target "$target")
  cp "$dest/unwind/target/$target/release/libunwind.a" "$system/"
  sed -e "s|@DEST@|$dest|;s|@EMULATION@|$(emulation "$target")|;s|@SYSTEM@|$system|" "$here/link.sh" > "$tools/bin/$target$api-clang"
  chmod +x "$tools/bin/$target$api-clang"
done
system_libraries ${phones[@]+"${phones[@]}"}
rm -rf "$dest/std" "$dest/unwind" "$dest"/usr/share "$dest"/usr/src "$dest"/usr/lib/rustlib/src
printf 'export RUSTC="%s/bin/rustc" RUSTDOC="%s/bin/rustdoc"\n' "$dest" "$dest" > "$dest/env.sh"
[ ${#phones[@]} = 0 ] || printf 'export ANDROID_NDK_HOME="%s/ndk"\n' "$dest" >> "$dest/env.sh"
echo "$key" > "$dest/made"
say "done, $(du -sh "$dest" | cut -f1)"
