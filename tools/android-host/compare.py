#!/usr/bin/env python3
"""compare.py FOLDER RENDERED.png REFERENCE.png: checks the images that the app presented while its scripts were played
(FOLDER/SCRIPT/NAME.ppm), and compares them with what `effigy render` draws of the same frame on the device and with
the f64 reference."""
import math
import pathlib
import struct
import sys
import zlib

BACKGROUND = (216, 221, 227)  # the viewer's default background, d8dde3


def read(path):
    kind, size, depth, data = path.read_bytes().split(b"\n", 3)
    assert (kind, depth) == (b"P6", b"255"), path
    return tuple(map(int, size.split())), data


def read_png(path):
    """Width and height, and RGB bytes, of an 8-bit PNG without a palette."""
    raw, at, packed = path.read_bytes(), 8, b""
    while at < len(raw):
        (length,), kind = struct.unpack_from(">I", raw, at), raw[at + 4 : at + 8]
        if kind == b"IHDR":
            width, height, _, color = struct.unpack_from(">IIBB", raw, at + 8)
        if kind == b"IDAT":
            packed += raw[at + 8 : at + 8 + length]
        at += 12 + length
    step = {2: 3, 6: 4}[color]
    rows, row, above, pixels = zlib.decompress(packed), width * step, bytes(width * step), bytearray()
    for y in range(height):
        kind, line = rows[y * (row + 1)], bytearray(rows[y * (row + 1) + 1 : (y + 1) * (row + 1)])
        for x in range(row):
            left, up, corner = (line[x - step], above[x], above[x - step]) if x >= step else (0, above[x], 0)
            nearest = min((left, up, corner), key=lambda value: abs(left + up - corner - value))
            line[x] = line[x] + (0, left, up, (left + up) // 2, nearest)[kind] & 255
        above = bytes(line)
        pixels += b"".join(above[x : x + 3] for x in range(0, row, step))
    return (width, height), bytes(pixels)


def difference(one, other):
    assert one[0] == other[0], f"{one[0]} px against {other[0]} px"
    return max(abs(a - b) for a, b in zip(one[1], other[1]))


def covered(image):
    data = image[1]
    return sum(1 for at in range(0, len(data), 3) if max(abs(data[at + i] - BACKGROUND[i]) for i in range(3)) > 4)


def psnr(image, reference):
    """dB over the pixels in which the reference is not the background."""
    assert image[0] == reference[0], f"{image[0]} px against {reference[0]} px"
    inside = [at for at in range(0, len(reference[1]), 3) if tuple(reference[1][at : at + 3]) != BACKGROUND]
    squares = sum((image[1][at + i] - reference[1][at + i]) ** 2 for at in inside for i in range(3))
    return 10 * math.log10(255**2 * 3 * len(inside) / squares) if squares else math.inf


def check(holds, text):
    print(f"  {text}")
    if not holds:
        sys.exit(f"FAILED: {text}")


def main(folder, rendered, reference):
    folder = pathlib.Path(folder)
    still = {name: read(folder / "picture" / f"{name}.ppm") for name in ("none", "quarter", "half", "threequarters")}
    area = covered(still["none"])
    check(area > 10000, f"the avatar covers {area} px of an upright screen of {still['none'][0]}")
    off = difference(still["none"], read_png(pathlib.Path(rendered)))
    check(off <= 2, f"it is what `effigy render` draws: {off} of 255 off")
    db = psnr(still["none"], read_png(pathlib.Path(reference)))
    check(db >= 48, f"it is {db:.2f} dB from the f64 reference where the avatar is, of 48 that it must be")
    off = difference(still["half"], read_png(folder / "picture" / "data" / "effigy-0001.png"))
    check(off <= 1, f"it is what its screenshot shows: {off} of 255 off")
    off = difference(still["none"], still["half"])
    check(off <= 1, f"on a display that is mounted upside down the image is the same: {off} of 255 off")
    off = difference(still["quarter"], still["threequarters"])
    check(off <= 1, f"lying on one side and on the other it is the same: {off} of 255 off")
    check(still["quarter"][0] == (960, 540) and covered(still["quarter"]) > 5000, "lying, it is as wide as the window")

    touch = {name: read(folder / "touch" / f"{name}.ppm") for name in ("before", "orbit", "reset", "pinch", "press")}
    check(difference(touch["before"], touch["orbit"]) > 50, "a finger turns the avatar")
    check(difference(touch["before"], touch["reset"]) <= 1, "two taps bring the first view back")
    grown = covered(touch["pinch"]) / covered(touch["reset"])
    check(grown > 1.3, f"two fingers that part make it larger: {grown:.2f} times the pixels")
    check(difference(touch["pinch"], touch["press"]) > 50, "a long press brings the panel")

    notice = read(folder / "refuse" / "posted.ppm")
    ink = sum(1 for at in range(0, len(notice[1]), 3) if notice[1][at] > 120)
    check(notice[0] == (960, 540) and ink > 1000, f"a device that can't run it says so in {ink} px of ink")


if __name__ == "__main__":
    main(*sys.argv[1:])
