#!/bin/sh
# Gets the weights of the perceptual loss ST-LPIPS (AlexNet 9.9 MB, VGG 58.9 MB; BSD-2), by package name, into a folder
# (default target/assets): the PyPI wheel stlpips-pytorch 0.0.2 has them.
# Needs no root. Checks each file's SHA-256; does nothing when all are there already.
set -eu

case ${1:-} in -*) sed -n '2,4s/^# //p' "$0" >&2; echo "usage: $0 [FOLDER]" >&2; exit 2 ;; esac
dest=${1:-target/assets}

# SHA-256, name in the folder, name in the package
files='b356b382f96010f77d085ee8343ecd9fd322d0a56e8de2b2d0549fafcad8b9ee  alex_shift_tolerant.pth  stlpips_pytorch/weights/vST0.0/alex_shift_tolerant.pth
44597da68f49c1837c100ff52299050f274d102eb102e5837178c79be6f0e250  vgg_shift_tolerant.pth  stlpips_pytorch/weights/vST0.0/vgg_shift_tolerant.pth
f8b6c12cd4da97f60e48355796bd4600e583ce12c8a5b0a95634afd14ea553e8  shift_tolerant.LICENSE  stlpips_pytorch-0.0.2.dist-info/licenses/LICENSE'

fail() {
    echo "fetch_perceptual: $*" >&2
    exit 1
}

# Whether every file is in the folder with the right sum.
complete() {
    echo "$files" | while read -r sum name _; do
        [ -f "$dest/$name" ] || exit 1
        echo "$sum  $dest/$name" | sha256sum --check --status || exit 1
    done
}

command -v sha256sum >/dev/null 2>&1 || fail "sha256sum is missing: apt-get install coreutils"
if complete; then
    echo "perceptual: already in $dest"
    exit 0
fi
command -v python3 >/dev/null 2>&1 || fail "python3 is missing: apt-get install python3 python3-pip"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
if [ -n "${STLPIPS_WHEEL:-}" ]; then
    wheel=$STLPIPS_WHEEL
else
    python3 -m pip --version >/dev/null 2>&1 ||
        fail "python3 has no pip: apt-get install python3-pip; or, on a machine with pip, run" \
            "'pip download --no-deps stlpips-pytorch==0.0.2' and set STLPIPS_WHEEL to the file"
    echo "perceptual: downloading stlpips-pytorch 0.0.2 (64 MB)"
    python3 -m pip download --quiet --disable-pip-version-check --no-deps --only-binary :all: \
        --python-version 3.12 --dest "$work" stlpips-pytorch==0.0.2 ||
        fail "pip could not download stlpips-pytorch 0.0.2: see its message above"
    wheel=$(echo "$work"/stlpips_pytorch-*.whl)
fi
[ -f "$wheel" ] || fail "no wheel at $wheel"
echo "$files" | (python3 -c '
import sys, zipfile
with zipfile.ZipFile(sys.argv[1]) as wheel:
    for line in sys.stdin:
        wheel.extract(line.split()[2], sys.argv[2])
' "$wheel" "$work/wheel") || fail "$wheel is not stlpips-pytorch 0.0.2"
echo "$files" | while read -r sum name inside; do
    found=$(sha256sum "$work/wheel/$inside" | cut -d' ' -f1)
    [ "$found" = "$sum" ] || fail "$inside has SHA-256 $found, expected $sum (stlpips-pytorch 0.0.2)"
    mkdir -p "$dest"
    cp "$work/wheel/$inside" "$dest/$name.part"
    mv "$dest/$name.part" "$dest/$name"
done
echo "perceptual: done"
