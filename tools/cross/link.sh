#!/usr/bin/env bash
# What stands where an NDK has its compiler: takes the arguments with which Rust links, and hands LLVM's linker those that it knows.
set -eu
arguments=()
while [ $# -gt 0 ]; do
  case $1 in
    *.c | *.cc | *.cpp | *.S | -c | -E | -S) echo "this linker compiles nothing ($1): set ANDROID_NDK_HOME to a real NDK" >&2; exit 2 ;;
    -Wl,*) IFS=, read -r -a inner <<< "${1#-Wl,}"; arguments+=("${inner[@]}") ;;
    -Xlinker) shift; arguments+=("$1") ;;
    -nodefaultlibs | -nostartfiles | -nostdlib | -m64 | -fPIC | -pie | -no-pie | -pthread | -rdynamic | -static-libgcc | -fuse-ld=* | --target=*) ;;
    *) arguments+=("$1") ;;
  esac
  shift
done
# Pages of 16 KiB, which newer phones have; no symbol may be left open.
exec "@DEST@/bin/ld.lld" -m @EMULATION@ -L "@SYSTEM@" -z max-page-size=16384 -z relro -z now -z noexecstack --eh-frame-hdr --build-id=sha1 \
  --as-needed --no-undefined "${arguments[@]}"
