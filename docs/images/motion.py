"""Draws captures' skeletons above the body that they move: motion.jpg.

    python3 motion.py EFFIGY BODY.avatar CAPTURE.bvh@SECONDS[@z]...

EFFIGY is the program; @z: z points up in the file. Needs NumPy and Pillow. The skeleton is drawn
from the file by a reader of its own, which knows nothing of Effigy. The committed picture has the five files of
tests/data/motion at 0.65 s (nameless with @z), 01_01 at 5.7 s and 01_03 at 12 s.
"""

import math
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image, ImageDraw

WIDTH, HEIGHT = 200, 280
YAW = 20.0


def turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.array({
        "X": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "Y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "Z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }[axis])


def skeleton(path, seconds):
    """Places of joints at a moment, and the parent of each."""
    with open(path, encoding="utf-8") as file:
        words = file.read().split()
    at = words.index("MOTION")
    joints, blocks, k = [], [], 0
    while k < at:
        word = words[k]
        if word in ("ROOT", "JOINT", "End"):
            joints.append({"parent": blocks[-1] if blocks else None, "channels": []})
        elif word == "{":
            blocks.append(len(joints) - 1)
        elif word == "}":
            blocks.pop()
        elif word == "OFFSET":
            joints[blocks[-1]]["offset"] = np.array([float(v) for v in words[k + 1:k + 4]])
        elif word == "CHANNELS":
            count = int(words[k + 1])
            joints[blocks[-1]]["channels"] = words[k + 2:k + 2 + count]
        k += 1
    step = float(words[at + 5])
    numbers = [float(word) for word in words[at + 6:]]
    width = sum(len(joint["channels"]) for joint in joints)
    frame = min(round(seconds / step), len(numbers) // width - 1)
    row = iter(numbers[frame * width:][:width])
    world, places = [], []
    for joint in joints:
        rotation, place = np.eye(3), joint["offset"].copy()
        for channel in joint["channels"]:
            value = next(row)
            if channel.endswith("position"):
                place["XYZ".index(channel[0])] = value
            else:
                rotation = rotation @ turn(channel[0], value)
        parent = joint["parent"]
        if parent is not None:
            rotation, place = world[parent] @ rotation, places[parent] + world[parent] @ place
        world.append(rotation)
        places.append(place)
    return np.array(places), [joint["parent"] for joint in joints]


def main():
    program, body, *captures = sys.argv[1:]
    picture = Image.new("RGB", (WIDTH * len(captures), 2 * HEIGHT), "white")
    draw = ImageDraw.Draw(picture)
    for column, capture in enumerate(captures):
        path, seconds, *up = capture.split("@")
        places, parents = skeleton(path, float(seconds))
        if up == ["z"]:
            places = np.stack([places[:, 0], places[:, 2], -places[:, 1]], 1)
        # What faces away is seen from behind, like the body.
        yaw = YAW + 180 if up == ["z"] else YAW
        places = places @ turn("Y", -yaw).T
        low, high = places.min(0), places.max(0)
        scale = 0.78 * HEIGHT / (high - low)[1]
        middle = np.array([WIDTH * (column + 0.5), HEIGHT / 2 + 6])
        dots = middle + scale * (places - (low + high) / 2)[:, :2] * [1, -1]
        for dot, parent in zip(dots, parents):
            if parent is not None:
                draw.line([*dot, *dots[parent]], fill=(60, 70, 90), width=3)
        name = path.rsplit("/", 1)[-1].removesuffix(".bvh")
        draw.text((WIDTH * column + 8, 4), name, fill="black")
        with tempfile.NamedTemporaryFile(suffix=".png") as file:
            subprocess.run([program, "render", body, "--motion", path, "--time", seconds, "--yaw", str(yaw),
                            "--size", f"{2 * WIDTH}x{2 * HEIGHT}", "--out", file.name], check=True)
            drawn = Image.open(file.name).convert("RGB").resize((WIDTH, HEIGHT), Image.LANCZOS)
        picture.paste(drawn, (WIDTH * column, HEIGHT))
    picture.save("motion.jpg", quality=85)


main()
