#!/bin/sh
# Gets weights of the perceptual losses (BSD-2), by package name, into a folder (default target/assets): of ST-LPIPS
# (AlexNet 9.9 MB, VGG 58.9 MB) from the PyPI wheel stlpips-pytorch 0.0.2, of LPIPS the heads (13 kB) from lpips 0.1.4.
# LPIPS's networks are torchvision's: put alexnet-owt-7be5be79.pth or vgg16-397923af.pth there yourself.
# Needs no root. Checks each file's SHA-256, torchvision's too; gets nothing that is there already.
set -eu

case ${1:-} in -*) sed -n '2,5s/^# //p' "$0" >&2; echo "usage: $0 [FOLDER]" >&2; exit 2 ;; esac
dest=${1:-target/assets}

# SHA-256, name in the folder, package, name in the package
files='b356b382f96010f77d085ee8343ecd9fd322d0a56e8de2b2d0549fafcad8b9ee alex_shift_tolerant.pth stlpips-pytorch stlpips_pytorch/weights/vST0.0/alex_shift_tolerant.pth
44597da68f49c1837c100ff52299050f274d102eb102e5837178c79be6f0e250 vgg_shift_tolerant.pth stlpips-pytorch stlpips_pytorch/weights/vST0.0/vgg_shift_tolerant.pth
f8b6c12cd4da97f60e48355796bd4600e583ce12c8a5b0a95634afd14ea553e8 shift_tolerant.LICENSE stlpips-pytorch stlpips_pytorch-0.0.2.dist-info/licenses/LICENSE
df73285e35b22355a2df87cdb6b70b343713b667eddbda73e1977e0c860835c0 lpips_alex.pth lpips lpips/weights/v0.1/alex.pth
a78928a0af1e5f0fcb1f3b9e8f8c3a2a5a3de244d830ad5c1feddc79b8432868 lpips_vgg.pth lpips lpips/weights/v0.1/vgg.pth
59d091d66b48f09a8a5107216f2007d9e775ffb4cc467a25733ec25f7c5c8fa1 lpips.LICENSE lpips lpips-0.1.4.dist-info/LICENSE'

fail() {
    echo "fetch_perceptual: $*" >&2
    exit 1
}

of_package() {
    echo "$files" | grep " $1 "
}

# Whether every file of a package is in the folder with the right sum.
complete() {
    of_package "$1" | while read -r sum name _; do
        [ -f "$dest/$name" ] || exit 1
        echo "$sum  $dest/$name" | sha256sum --check --status || exit 1
    done
}

# Gets the files of a package. $1: its name, $2: its version, $3: its wheel, or nothing, $4: the variable that names it,
# $5: its size
get() {
    if complete "$1"; then
        echo "perceptual: what $1 has is already in $dest"
        return
    fi
    command -v python3 >/dev/null 2>&1 || fail "python3 is missing: apt-get install python3 python3-pip"
    wheel=$3
    if [ -z "$wheel" ]; then
        python3 -m pip --version >/dev/null 2>&1 ||
            fail "python3 has no pip: apt-get install python3-pip; or, on a machine with pip, run" \
                "'pip download --no-deps $1==$2' and set $4 to the file"
        echo "perceptual: downloading $1 $2 ($5)"
        python3 -m pip download --quiet --disable-pip-version-check --no-deps --only-binary :all: \
            --python-version 3.12 --dest "$work" "$1==$2" ||
            fail "pip could not download $1 $2: see its message above"
        wheel=$(echo "$work/$(echo "$1" | tr - _)"-*.whl)
    fi
    [ -f "$wheel" ] || fail "no wheel at $wheel"
    of_package "$1" | (python3 -c '
import sys, zipfile
with zipfile.ZipFile(sys.argv[1]) as wheel:
    for line in sys.stdin:
        wheel.extract(line.split()[3], sys.argv[2])
' "$wheel" "$work/wheel") || fail "$wheel is not $1 $2"
    of_package "$1" | while read -r sum name _ inside; do
        found=$(sha256sum "$work/wheel/$inside" | cut -d' ' -f1)
        [ "$found" = "$sum" ] || fail "$inside has SHA-256 $found, expected $sum ($1 $2)"
        mkdir -p "$dest"
        cp "$work/wheel/$inside" "$dest/$name.part"
        mv "$dest/$name.part" "$dest/$name"
    done
}

command -v sha256sum >/dev/null 2>&1 || fail "sha256sum is missing: apt-get install coreutils"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
get stlpips-pytorch 0.0.2 "${STLPIPS_WHEEL:-}" STLPIPS_WHEEL '64 MB'
get lpips 0.1.4 "${LPIPS_WHEEL:-}" LPIPS_WHEEL '54 kB'
# Names of torchvision's files end with the first digits of their SHA-256.
for name in alexnet-owt-7be5be79.pth vgg16-397923af.pth; do
    [ -f "$dest/$name" ] || continue
    sum=${name##*-}
    found=$(sha256sum "$dest/$name" | cut -d' ' -f1)
    case $found in
    "${sum%.pth}"*) echo "perceptual: $dest/$name is torchvision's" ;;
    *) fail "$dest/$name has SHA-256 $found, which torchvision's does not" ;;
    esac
done
echo "perceptual: done"
