#!/usr/bin/env python3
"""compare.py FOLDER: looks at the pictures that the app presented while its scripts were played (FOLDER/SCRIPT/NAME.ppm)."""
import pathlib
import sys

PAPER = (216, 221, 227)  # the viewer's first background, d8dde3


def read(path):
    kind, size, depth, data = path.read_bytes().split(b"\n", 3)
    assert (kind, depth) == (b"P6", b"255"), path
    return tuple(map(int, size.split())), data


def difference(one, other):
    assert one[0] == other[0], f"{one[0]} px against {other[0]} px"
    return max(abs(a - b) for a, b in zip(one[1], other[1]))


def covered(picture):
    data = picture[1]
    return sum(1 for at in range(0, len(data), 3) if max(abs(data[at + i] - PAPER[i]) for i in range(3)) > 4)


def check(holds, text):
    print(f"  {text}")
    if not holds:
        sys.exit(f"FAILED: {text}")


def main(folder):
    folder = pathlib.Path(folder)
    still = {name: read(folder / "picture" / f"{name}.ppm") for name in ("none", "quarter", "half", "threequarters")}
    area = covered(still["none"])
    check(area > 10000, f"the avatar covers {area} px of an upright screen of {still['none'][0]}")
    off = difference(still["none"], still["half"])
    check(off <= 1, f"on a display that stands on its head the picture is the same: {off} of 255 off")
    off = difference(still["quarter"], still["threequarters"])
    check(off <= 1, f"lying on one side and on the other it is the same: {off} of 255 off")
    check(still["quarter"][0] == (960, 540) and covered(still["quarter"]) > 5000, "lying, it is as wide as the window")

    touch = {name: read(folder / "touch" / f"{name}.ppm") for name in ("before", "orbit", "reset", "pinch", "press")}
    check(difference(touch["before"], touch["orbit"]) > 50, "a finger turns the avatar")
    check(difference(touch["before"], touch["reset"]) <= 1, "two taps bring the first view back")
    grown = covered(touch["pinch"]) / covered(touch["reset"])
    check(grown > 1.3, f"two fingers that part make it larger: {grown:.2f} times the pixels")
    check(difference(touch["pinch"], touch["press"]) > 50, "a long press brings the panel")


if __name__ == "__main__":
    main(sys.argv[1])
