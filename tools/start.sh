#!/usr/bin/env bash
# Installs what is missing, builds Effigy and runs it: `tools/start.sh` shows the demo, `tools/start.sh ARGS…` is `effigy ARGS…`.
set -euo pipefail
from=$PWD
cd "$(dirname "$0")/.."
. tools/needs.sh
need_rust
# Any driver will do; without one, Mesa's CPU driver.
need 'ldconfig -p | grep -q libvulkan.so.1' libvulkan1
need 'ls /usr/share/vulkan/icd.d/*.json /etc/vulkan/icd.d/*.json "${VK_DRIVER_FILES:-}" 2>/dev/null | grep -q .' mesa-vulkan-drivers
if [ -n "${DISPLAY:-}" ]; then need 'ldconfig -p | grep -q libxkbcommon-x11.so.0' libxkbcommon-x11-0; fi
build_effigy
# The paths in the arguments are the caller's; the body's source files are where tools/fetch_assets.sh puts them.
export EFFIGY_ASSETS=${EFFIGY_ASSETS:-$PWD/target/assets}
cd "$from"
exec "$EFFIGY" "$@"
