#!/usr/bin/env bash
# Gathers the Vulkan drivers and the validation layer that the tests run on, without a GPU, on Debian 12:
#   mesa22       the lavapipe of Debian 12 itself
#   mesa25       Mesa 25's lavapipe from Debian's backports, unpacked beside the system's own
#   swiftshader  the SwiftShader in Debian's chromium: subgroups of 4
#   layers       the newer validation layer in Debian's chromium, which finds missing barriers between dispatches
# usage: tools/drivers.sh [DEST, default target/drivers]    makes DEST/NAME.json for each, and DEST/layers/
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
case ${1:-} in -*) usage >&2; exit 2 ;; esac
dest=${1:-target/drivers}
mkdir -p "$dest/layers"
dest=$(cd "$dest" && pwd)
complete=1
for icd in mesa22 mesa25 swiftshader; do
  library=''
  [ ! -s "$dest/$icd.json" ] || library=$(sed -n 's/.*"library_path": "\([^"]*\)".*/\1/p' "$dest/$icd.json")
  [ -n "$library" ] && [ -s "$library" ] || complete=''
done
[ -s "$dest/layers/VkLayer_khronos_validation.json" ] && command -v xvfb-run >/dev/null && command -v xdotool >/dev/null || complete=''
[ -z "$complete" ] || exit 0
command -v apt-get >/dev/null || { echo "tools/drivers.sh needs Debian's apt-get; elsewhere run \`cargo test\` on your own drivers" >&2; exit 1; }

install=(apt-get -o DPkg::Lock::Timeout=300 install -qq -y --no-install-recommends)
as_root apt-get -o DPkg::Lock::Timeout=300 update -qq
DEBIAN_FRONTEND=noninteractive as_root "${install[@]}" mesa-vulkan-drivers libvulkan1 chromium vulkan-validationlayers xvfb xdotool >/dev/null

tools/lavapipe.sh "$dest"
write_icd "$dest/mesa22.json" /usr/lib/x86_64-linux-gnu/libvulkan_lvp.so 1.3.230
write_icd "$dest/swiftshader.json" /usr/lib/chromium/libvk_swiftshader.so 1.3.0
cat > "$dest/layers/VkLayer_khronos_validation.json" <<'JSON'
{"file_format_version": "1.2.0", "layer": {"name": "VK_LAYER_KHRONOS_validation", "type": "GLOBAL",
 "library_path": "/usr/lib/chromium/libVkLayer_khronos_validation.so", "api_version": "1.4.328", "implementation_version": "1",
 "description": "Khronos validation layer", "instance_extensions": [{"name": "VK_EXT_debug_report", "spec_version": "9"},
 {"name": "VK_EXT_debug_utils", "spec_version": "2"}, {"name": "VK_EXT_validation_features", "spec_version": "6"}]}}
JSON
