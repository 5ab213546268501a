#!/usr/bin/env bash
# Unpacks Mesa 25's lavapipe, a Vulkan driver for CPUs, from Debian 12's backports beside the system's own, Mesa 22, which is several
# times as slow. What it links to comes with Debian's mesa-vulkan-drivers.
# usage: tools/lavapipe.sh [DEST, default target/drivers]    makes DEST/mesa25.json, for VK_DRIVER_FILES
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
case ${1:-} in -*) usage >&2; exit 2 ;; esac
dest=${1:-target/drivers}
mkdir -p "$dest"
dest=$(cd "$dest" && pwd)
library=$dest/mesa25/usr/lib/x86_64-linux-gnu/libvulkan_lvp.so
if [ ! -s "$library" ]; then
  grep -qs '^VERSION_CODENAME=bookworm' /etc/os-release || { echo "tools/lavapipe.sh is for Debian 12" >&2; exit 1; }
  # The lists of the backports suite, kept apart from the system's own.
  mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Codename: bookworm' | sed -n 1p)
  [ -n "$mirror" ] || mirror=$(awk '/^URIs:/{print $2; exit}' /etc/apt/sources.list.d/*.sources)
  apt="$dest/apt"
  mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror bookworm-backports main" > "$apt/sources.list"
  options=(-o Dir::Etc::sourcelist="$apt/sources.list" -o Dir::Etc::sourceparts=/nonexistent -o Dir::State::lists="$apt/lists" -o Dir::Cache="$apt/cache" -o APT::Sandbox::User=root)
  apt-get "${options[@]}" update -qq
  (cd "$apt" && apt-get "${options[@]}" download -q mesa-vulkan-drivers/bookworm-backports >/dev/null)
  # Whole or not at all.
  rm -rf "$dest/mesa25"
  dpkg -x "$apt"/mesa-vulkan-drivers_*.deb "$apt/mesa25"
  mv "$apt/mesa25" "$dest/mesa25"
  rm -rf "$apt"
fi
write_icd "$dest/mesa25.json" "$library" 1.4.305
