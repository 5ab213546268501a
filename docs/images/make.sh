#!/usr/bin/env bash
# Makes body.jpg, the image at the top of the README, from body.avatar (`effigy bake body`) and the demo clip. Needs ImageMagick.
# usage: docs/images/make.sh EFFIGY BODY.avatar
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd); work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
"$1" render "$2" --size 560x900 --time 0.3 --yaw 15 --out "$work/1.png"
"$1" render "$2" --size 560x900 --time 3.1 --yaw 40 --out "$work/2.png"
"$1" render "$2" --size 560x900 --time 0.3 --yaw -5 --distance 0.95 --raise 0.62 --out "$work/3.png"
convert "$work/1.png" -gravity center -crop 420x740+0-30 +repage "$work/1c.png"
convert "$work/2.png" -gravity center -crop 420x740+0-20 +repage "$work/2c.png"
convert "$work/3.png" -gravity center -crop 480x740+0-60 +repage "$work/3c.png"
convert "$work"/[123]c.png +append -strip -quality 88 "$here/body.jpg"
