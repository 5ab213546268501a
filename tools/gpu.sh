#!/usr/bin/env bash
# Makes a bundle that gives a verdict on a GPU: the program, the GPU tests, avatars, a clip, cameras, the validation layer, and what
# a bare Debian or Ubuntu with nothing but a GPU and its driver lacks. On the machine with the GPU, offline, in at most 9 minutes:
#   tar xzf effigy-gpu.tar.gz && effigy-gpu/run.sh OUT_DIR
# OUT_DIR then has verdict.json, verdict.md and logs.tar.gz. docs/gpu.md says what is in them.
# usage: tools/gpu.sh [--rehearse DRIVER]... [OUT_DIR, default target/gpu]      makes OUT_DIR/effigy-gpu.tar.gz
#   --rehearse DRIVER  also runs the bundle here, on a CPU driver of tools/drivers.sh and with shortened settings, and keeps what
#                      comes out in OUT_DIR/rehearsal-DRIVER; the command fails if a step does
# EFFIGY=PROGRAM and EFFIGY_GPU_TESTS=PROGRAM use a program and GPU tests that are built already.
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
. tools/drivers_env.sh
rehearsals=() out=target/gpu
while [ $# -gt 0 ]; do
  case $1 in
    --rehearse) shift; rehearsals+=("${1:?--rehearse needs a driver}") ;;
    -*) usage >&2; exit 2 ;;
    *) out=$1 ;;
  esac
  shift
done
[ -n "${EFFIGY:-}" ] && [ -n "${EFFIGY_GPU_TESTS:-}" ] || need_rust
need 'command -v strip' binutils
tools/drivers.sh
tools/fetch_assets.sh >/dev/null || echo "without the body's source files the bundle has the demo alone" >&2
mkdir -p "$out"; out=$(cd "$out" && pwd)

build_effigy
effigy_lab --version >/dev/null
tests=${EFFIGY_GPU_TESTS:-}
if [ -z "$tests" ]; then
  echo "building the GPU tests"
  # Of the whole workspace, as tools/test.sh builds them: with fewer packages some dependencies would be built again.
  log=$(cargo test --workspace --features webgpu --no-run --test gpu 2>&1) || { echo "$log" >&2; exit 1; }
  tests=$(sed -n 's|^ *Executable .*tests/gpu/main.rs (\(.*\))$|\1|p' <<< "$log")
fi
[ -x "$tests" ] || { echo "the GPU tests were not built" >&2; exit 1; }

work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
tree=$work/effigy-gpu
mkdir -p "$tree"/{bin,lib,layers,data}
strip -o "$tree/bin/effigy" "$EFFIGY"
strip -o "$tree/bin/effigy-lab" "$EFFIGY_LAB"
strip -o "$tree/bin/gpu-tests" "$tests"
cp tools/gpu/run.sh "$tree/run.sh"

# The Vulkan loader, and what NVIDIA's driver wants beside it: X11's, and those two of GLVND without which its Vulkan has no
# vkCreateInstance (an H200 in a container, driver 580). Of these the machine's own are as good.
library() { # NAME: its path here
  # All of the list is read: what writes it would end with an error otherwise.
  ldconfig -p | awk -v name="$1" '$1 == name && /x86-64/ && !path { path = $NF } END { print path }'
}
for name in libvulkan.so.1 libX11.so.6 libXext.so.6 libxcb.so.1 libXau.so.6 libXdmcp.so.6 libbsd.so.0 libmd.so.0 libEGL.so.1 libGLdispatch.so.0; do
  path=$(library "$name")
  if [ -n "$path" ]; then
    cp -L "$path" "$tree/lib/$name"
  elif [ "$name" = libvulkan.so.1 ]; then
    echo "there is no Vulkan loader here to put into the bundle" >&2; exit 1
  else
    echo "the bundle has no $name: there is none here" >&2
  fi
done
# Their manifest names the layer's library by its place here.
manifest=target/drivers/layers/VkLayer_khronos_validation.json
layer=$(sed -n 's/.*"library_path": "\([^"]*\)".*/\1/p' "$manifest")
cp -L "$layer" "$tree/layers/libVkLayer_khronos_validation.so"
sed 's|"library_path": "[^"]*"|"library_path": "./libVkLayer_khronos_validation.so"|' "$manifest" \
  > "$tree/layers/VkLayer_khronos_validation.json"

if [ -s target/assets/base.obj ]; then
  "$EFFIGY" bake body --out "$tree/data/body.avatar" >/dev/null
  "$EFFIGY" bake motion target/assets/01_01.bvh --out "$tree/data/01_01.motion" >/dev/null
fi
use_driver mesa25:256
avatar=()
[ ! -s "$tree/data/body.avatar" ] || avatar=("$tree/data/body.avatar" --motion "$tree/data/01_01.motion")
"$EFFIGY" export-ply "${avatar[@]}" --time 1 --views 3 --out "$work/scene.ply" --cameras-out "$tree/data/cameras.json" >/dev/null

# The newest C library that something in the bundle asks for.
glibc=$(for file in "$tree"/bin/* "$tree"/lib/* "$tree"/layers/*.so; do objdump -T "$file"; done |
  sed -n 's/.*(\?GLIBC_\([0-9.]*\).*/\1/p' | sort -V | tail -n 1)
git describe --always --dirty=+ > "$tree/commit.txt"
tar --sort=name --owner=0 --group=0 --mtime=@0 -C "$work" -I 'gzip -9' -cf "$out/effigy-gpu.tar.gz" effigy-gpu
bytes=$(stat -c %s "$out/effigy-gpu.tar.gz")
echo "$out/effigy-gpu.tar.gz: $((bytes >> 20)) MiB, for x86-64 with glibc $glibc or newer"

for driver in "${rehearsals[@]}"; do
  (
    use_driver "$driver"
    # The bundle brings its own layer.
    unset VK_LAYER_PATH
    name=$out/rehearsal-${driver//:/-}
    rm -rf "$name" "$work/bare"; mkdir -p "$work/bare"
    tar xzf "$out/effigy-gpu.tar.gz" -C "$work/bare"
    echo "rehearsing on $driver"
    EFFIGY_GPU_SHORT=1 "$work/bare/effigy-gpu/run.sh" "$name"
  )
done
