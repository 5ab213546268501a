#!/usr/bin/env bash
# Makes what people install: for Linux a tarball and a .deb, for Android the signed app, for web servers the page as a
# folder in a tarball; SHA256SUMS over all of them. Each holds the licences of everything that is in it.
# usage: tools/release.sh [--only linux|android|web] [--try] [OUT_DIR]      [default: all three, into target/release-files]
#   --try: installs the .deb and unpacks the tarball in a bare Debian where nothing else is, and draws an image with each
#          (needs root; mmdebstrap is installed where it is missing)
# Android signs with KEYSTORE and KEYSTORE_PASS (tools/apk.sh).
set -euo pipefail
cd "$(dirname "$0")/.."
. tools/needs.sh
only=all try='' out=target/release-files
while [ $# -gt 0 ]; do
  case $1 in
    --only) shift; only=${1:?--only needs linux, android or web} ;;
    --try) try=1 ;;
    -*) usage >&2; exit 2 ;;
    *) out=$1 ;;
  esac
  shift
done
need_rust
need 'command -v python3' python3
version=$(sed -n '/^\[workspace.package\]/,/^\[/s/^version = "\(.*\)"/\1/p' Cargo.toml)
mkdir -p "$out"; out=$(cd "$out" && pwd)
wanted() { [ $only = all ] || [ $only = "$1" ]; }

if wanted linux; then
  need 'command -v dpkg-deb' dpkg
  need 'command -v objdump' binutils
  cargo build --release --locked -p effigy-cli
  work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
  name=effigy-$version-linux-x86_64
  tree=$work/$name
  mkdir -p "$tree"
  strip -o "$tree/effigy" "${CARGO_TARGET_DIR:-target}/release/effigy"
  cp -r README.md CHANGELOG.md LICENSE-MIT LICENSE-APACHE docs "$tree/"
  python3 tools/release/licences.py x86_64-unknown-linux-gnu effigy-cli > "$tree/THIRD-PARTY-LICENSES.txt"
  cp src/demo/README.md "$tree/DEMO-CREDITS.md"
  tar --sort=name --owner=0 --group=0 --mtime=@0 -C "$work" -czf "$out/$name.tar.gz" "$name"

  package=$work/package share=$work/package/usr/share/doc/effigy
  mkdir -p "$package/DEBIAN" "$package/usr/bin" "$share"
  cp "$tree/effigy" "$package/usr/bin/"
  cp -r "$tree/README.md" "$tree/DEMO-CREDITS.md" "$tree/docs" "$share/"
  cat "$tree/LICENSE-MIT" "$tree/LICENSE-APACHE" > "$share/copyright"
  gzip -9n < "$tree/CHANGELOG.md" > "$share/changelog.gz"
  gzip -9n < "$tree/THIRD-PARTY-LICENSES.txt" > "$share/third-party-licenses.gz"
  # The newest version of a symbol of the C library that the program asks for.
  glibc=$(objdump -T "$tree/effigy" | sed -n 's/.*(\?GLIBC_\([0-9.]*\).*/\1/p' | sort -V | tail -n 1)
  sed "s/@VERSION@/$version/; s/@GLIBC@/$glibc/" tools/release/control > "$package/DEBIAN/control"
  dpkg-deb --root-owner-group --build "$package" "$out/effigy_${version}_amd64.deb" >/dev/null
fi

if wanted web; then
  tools/web.sh target/web
  cp LICENSE-MIT LICENSE-APACHE target/web/
  python3 tools/release/licences.py wasm32-unknown-unknown effigy-web,effigy-web-import > target/web/THIRD-PARTY-LICENSES.txt
  cp src/demo/README.md target/web/DEMO-CREDITS.md
  tar --sort=name --owner=0 --group=0 --mtime=@0 --transform "s,^web,effigy-$version-web," -C target -czf "$out/effigy-$version-web.tar.gz" web
fi

if wanted android; then
  tools/apk.sh --release "$out/effigy-$version.apk"
  python3 tools/release/licences.py aarch64-linux-android effigy-app > "$out/effigy-$version.apk.licenses.txt"
fi

(cd "$out" && find . -maxdepth 1 -type f ! -name SHA256SUMS -printf '%f\n' | sort | xargs sha256sum > SHA256SUMS)
cat "$out/SHA256SUMS"

if [ -n "$try" ] && wanted linux; then
  need 'command -v mmdebstrap' mmdebstrap
  bare=$(mktemp -d); trap 'rm -rf "$work" "$bare"' EXIT
  mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Codename: bookworm' | sed -n 1p)
  as_root mmdebstrap --quiet --variant=minbase bookworm "$bare/root" "$mirror"
  inside() { as_root chroot "$bare/root" env -i PATH=/usr/bin:/bin:/usr/sbin:/sbin HOME=/root DEBIAN_FRONTEND=noninteractive "$@"; }
  cp "$out/effigy_${version}_amd64.deb" "$out/effigy-$version-linux-x86_64.tar.gz" "$bare/root/tmp/"
  # What mmdebstrap leaves has no lists of packages.
  inside sh -ec "apt-get update -qq && apt-get install -qq -y /tmp/effigy_${version}_amd64.deb >/dev/null
    cd /tmp && effigy --version && effigy render --size 512x512 --out /tmp/installed.png
    tar xf effigy-$version-linux-x86_64.tar.gz && effigy-$version-linux-x86_64/effigy render --size 512x512 --out /tmp/unpacked.png
    cmp /tmp/installed.png /tmp/unpacked.png && dpkg --purge effigy >/dev/null && test ! -e /usr/bin/effigy"
  cp "$bare/root/tmp/installed.png" "$out/../release-try.png"
  echo "tried in a bare Debian: both draw, and the package leaves nothing behind; the image is $(dirname "$out")/release-try.png"
fi
