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
# Without a GPU, Debian 12's own driver for CPUs takes several times as long as the newest: that one is fetched, and used here alone.
if [ -z "${VK_DRIVER_FILES:-}${VK_ICD_FILENAMES:-}" ] && ! ls /dev/dri/renderD* /dev/nvidia[0-9]* /dev/dxg >/dev/null 2>&1 &&
  grep -qs '^VERSION_CODENAME=bookworm' /etc/os-release && [ "$(uname -m)" = x86_64 ]; then
  [ -s target/drivers/mesa25.json ] || echo "no GPU here: fetching Mesa 25's driver for CPUs into target/drivers" >&2
  if tools/lavapipe.sh >&2; then
    export VK_DRIVER_FILES=$PWD/target/drivers/mesa25.json
    export VK_ICD_FILENAMES=$VK_DRIVER_FILES
  else
    echo "it could not be fetched: Debian's own takes several times as long" >&2
  fi
fi
build_effigy
# The paths in the arguments are the caller's; the body's source files are where tools/fetch_assets.sh puts them.
export EFFIGY_ASSETS=${EFFIGY_ASSETS:-$PWD/target/assets}
cd "$from"
exec "$EFFIGY" "$@"
