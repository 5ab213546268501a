"""Writes one walk in the conventions of several rigs, as BVH, and what it does.

Independent of Effigy: a body of 1.75 m walks two steps, one foot standing at a time; every rig has
its own rest pose, names, units, axes and channels, and shows the same positions. Run it in this
folder:

    python3 make.py

NumPy 1.20 or later. The files are committed; nothing in them is random.
"""

import json

import numpy as np

FRAMES, RATE = 44, 20.0
# Joint: parent, place in a T pose (metres; x to the person's left, y up, z forward).
BODY = {
    "hips": (None, (0, 0.95, 0)),
    "spine1": ("hips", (0, 1.06, -0.01)),
    "spine2": ("spine1", (0, 1.18, -0.01)),
    "chest": ("spine2", (0, 1.30, 0)),
    "neck": ("chest", (0, 1.47, 0)),
    "head": ("neck", (0, 1.56, 0.02)),
    "crown": ("head", (0, 1.75, 0.02)),
}
for side, x in (("left", 1.0), ("right", -1.0)):
    BODY[f"{side} clavicle"] = ("chest", (0.04 * x, 1.42, 0))
    BODY[f"{side} upper arm"] = (f"{side} clavicle", (0.18 * x, 1.43, 0))
    BODY[f"{side} forearm"] = (f"{side} upper arm", (0.46 * x, 1.43, 0))
    BODY[f"{side} hand"] = (f"{side} forearm", (0.71 * x, 1.43, 0))
    BODY[f"{side} fingers"] = (f"{side} hand", (0.80 * x, 1.43, 0))
    BODY[f"{side} thigh"] = ("hips", (0.09 * x, 0.90, 0))
    BODY[f"{side} shin"] = (f"{side} thigh", (0.09 * x, 0.49, 0.01))
    BODY[f"{side} foot"] = (f"{side} shin", (0.09 * x, 0.08, 0))
    BODY[f"{side} toe"] = (f"{side} foot", (0.09 * x, 0.02, 0.13))
    BODY[f"{side} tip"] = (f"{side} toe", (0.09 * x, 0.02, 0.20))
JOINTS = list(BODY)
PARENT = {joint: BODY[joint][0] for joint in JOINTS}
PLACE = {joint: np.array(BODY[joint][1], float) for joint in JOINTS}
ENDS = [joint for joint in JOINTS if joint not in PARENT.values()]
CHILDREN = {joint: [c for c in JOINTS if PARENT[c] == joint] for joint in JOINTS}


def turn(axis, degrees):
    """The matrix of a turn about x, y or z."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return {
        "x": np.array([[1, 0, 0], [0, c, -s], [0, s, c]]),
        "y": np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]),
        "z": np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]),
    }[axis]


def unit(v):
    return v / np.linalg.norm(v)


def frame(first, second):
    """Columns: a direction, another made perpendicular to it, and a third."""
    a = unit(first)
    b = unit(second - a * (a @ second))
    return np.stack([a, b, np.cross(a, b)], 1)


def offset(joint):
    return PLACE[joint] - PLACE[PARENT[joint]]


def smooth(t):
    t = min(max(t, 0.0), 1.0)
    return t * t * (3 - 2 * t)


def ankle(side, t):
    """Where an ankle is: it stands, makes a step of 0.4 m, and stands."""
    start = 0.2 if side == "left" else 1.2
    step = smooth((t - start) / 0.8)
    x = 0.09 if side == "left" else -0.09
    lift = 0.12 * np.sin(np.pi * min(max((t - start) / 0.8, 0.0), 1.0))
    return np.array([x, 0.08 + lift, 0.4 * step])


def pose(t):
    """World rotations of all joints, from the T pose, and the place of the hips."""
    walk = np.sin(np.pi * t)
    both = (ankle("left", t) + ankle("right", t)) / 2
    hips = np.array([0.02 * walk, 0.90 + 0.015 * np.cos(2 * np.pi * t), both[2]])
    world = {"hips": turn("y", 6 * walk) @ turn("x", 4)}
    local = {
        "spine1": turn("x", 2),
        "spine2": turn("y", -5 * walk),
        "chest": turn("y", -6 * walk) @ turn("x", 3),
        "neck": turn("x", -5),
        "head": turn("y", 12 * np.sin(2 * t)) @ turn("x", 4),
    }
    for side, x in (("left", 1.0), ("right", -1.0)):
        swing = 28 * walk * x
        # Lowered arms that swing; elbows bend towards the front.
        local[f"{side} clavicle"] = turn("z", -3 * x)
        local[f"{side} upper arm"] = turn("x", swing) @ turn("z", -72 * x)
        local[f"{side} forearm"] = turn("y", -(25 + 10 * walk * x) * x)
        local[f"{side} hand"] = turn("z", -8 * x)
    at = {"hips": hips}
    for joint in JOINTS[1:]:
        parent = PARENT[joint]
        if any(part in joint for part in ("thigh", "shin", "foot", "toe", "tip")):
            continue
        world[joint] = world[parent] @ local.get(joint, np.eye(3))
        at[joint] = at[parent] + world[parent] @ offset(joint)
    for side in ("left", "right"):
        thigh, shin, foot = (f"{side} {bone}" for bone in ("thigh", "shin", "foot"))
        hip = at["hips"] + world["hips"] @ offset(thigh)
        goal = ankle(side, t)
        a, b = (np.linalg.norm(offset(joint)) for joint in (shin, foot))
        way = goal - hip
        reach = np.linalg.norm(way)
        assert reach < a + b, (t, side, reach)
        cosine = (a * a + reach * reach - b * b) / (2 * a * reach)
        front = unit(np.array([0, 0, 1.0]) - unit(way) * unit(way)[2])
        knee = hip + a * (cosine * unit(way) + np.sqrt(1 - cosine**2) * front)
        # Knees bend about the axis to the person's left.
        across = np.cross(front, unit(way))
        for joint, along in ((thigh, knee - hip), (shin, goal - knee)):
            child = CHILDREN[joint][0]
            world[joint] = frame(along, across) @ frame(offset(child), np.array([1.0, 0, 0])).T
        at[thigh], at[shin], at[foot] = hip, knee, goal
        world[foot] = np.eye(3)
        for joint in (f"{side} toe", f"{side} tip"):
            world[joint] = np.eye(3)
            at[joint] = at[PARENT[joint]] + offset(joint)
    return world, at


def lowered(joint):
    """The rest of a rig whose arms hang."""
    for side, x in (("left", 1.0), ("right", -1.0)):
        if joint in [f"{side} {bone}" for bone in ("upper arm", "forearm", "hand", "fingers")]:
            return turn("z", -85 * x)
    return np.eye(3)


def along_x(joint, mirror=False):
    """The rest of a rig whose bones all lie along x: it takes each bone of the T pose there.

    Second axes are forward for trunk, arms and feet, and to the left for thighs and shins."""
    children = CHILDREN[joint]
    if joint == "hips":
        bone, second = np.array([0, 1.0, 0]), np.array([0, 0, 1.0])
    elif joint == "chest":
        bone, second = np.array([0, 1.0, 0]), np.array([1.0, 0, 0])
    elif not children:
        return along_x(PARENT[joint], mirror)
    else:
        bone = offset(children[0])
        second = np.array([0, 0, 1.0]) if abs(unit(bone)[2]) < 0.7 else np.array([0, 1.0, 0])
        if "thigh" in joint or "shin" in joint:
            second = np.array([1.0, 0, 0])
    x = np.array([-1.0, 0, 0]) if mirror and "right" in joint else np.array([1.0, 0, 0])
    return frame(x, np.array([0, 1.0, 0])) @ frame(bone, second).T


def angles(matrix, order):
    """Degrees about three axes whose turns multiply to a matrix, in the order of channels."""
    i, j, k = ("xyz".index(axis) for axis in order)
    sign = 1.0 if (j - i) % 3 == 1 else -1.0
    middle = np.arcsin(np.clip(sign * matrix[i, k], -1, 1))
    first = np.arctan2(-sign * matrix[j, k], matrix[k, k])
    last = np.arctan2(-sign * matrix[i, j], matrix[i, i])
    if np.cos(middle) < 1e-6:
        # Both outer turns are about one axis.
        first, last = np.arctan2(sign * matrix[k, j], matrix[j, j]), 0.0
    result = np.degrees([first, middle, last])
    product = turn(order[0], result[0]) @ turn(order[1], result[1]) @ turn(order[2], result[2])
    assert np.abs(product - matrix).max() < 1e-6
    return result


def write(path, names, rest, unit_of, order, to_file=np.eye(3), six=False, wild=False):
    """A file. names: a name for each joint; None: the end of a chain, or left out.

    rest: the rotation of each joint from the T pose to the rig's rest pose. unit_of: units a metre.
    to_file: our axes to the file's. six: positions for every joint. wild: tabs, a count that is too
    large, no newline at the end, and rotations before positions."""
    poses = [pose(frame / RATE) for frame in range(FRAMES)]
    lines = ["HIERARCHY"]
    order_of_rows = []

    def walk(joint, depth):
        pad = ("\t" if wild else "  ") * depth
        parent = PARENT[joint]
        is_end = names[joint] is None
        title = "End Site" if is_end else f"{'ROOT' if parent is None else 'JOINT'} {names[joint]}"
        own = np.zeros(3) if parent is None else to_file @ rest(parent) @ offset(joint) * unit_of
        inner = pad + ("\t" if wild else "  ")
        lines.append(f"{pad}{title} {{" if wild else f"{pad}{title}\n{pad}{{")
        lines.append(f"{inner}OFFSET {own[0]:.5f} {own[1]:.5f} {own[2]:.5f}")
        if not is_end:
            order_of_rows.append(joint)
            turns = [f"{axis.upper()}rotation" for axis in order]
            places = ["Xposition", "Yposition", "Zposition"]
            if parent is not None and not six:
                places = []
            channels = turns + places if wild else places + turns
            lines.append(f"{inner}CHANNELS {len(channels)} {' '.join(channels)}")
            for child in CHILDREN[joint]:
                walk(child, depth + 1)
        lines.append(f"{pad}}}")

    walk("hips", 0)
    announced = FRAMES + 1 if wild else FRAMES
    lines += ["MOTION", f"Frames:{chr(9) if wild else ' '}{announced}", f"Frame Time: {1 / RATE:.6f}"]
    for world, at in poses:
        # The rig's own axes of a joint: what is at rest in its rest pose.
        own = {joint: to_file @ world[joint] @ rest(joint).T @ to_file.T for joint in JOINTS}
        row = []
        for joint in order_of_rows:
            parent = PARENT[joint]
            above = np.eye(3) if parent is None else own[parent]
            turns = list(angles(above.T @ own[joint], order))
            if parent is None:
                place = to_file @ at[joint] * unit_of
            else:
                place = to_file @ rest(parent) @ offset(joint) * unit_of
            place = list(place) if parent is None or six else []
            row += turns + place if wild else place + turns
        lines.append((" \t" if wild else " ").join(f"{number:.4f}" for number in row))
    with open(path, "w", encoding="ascii", newline="\r\n" if wild else "\n") as file:
        file.write("\n".join(lines) + ("" if wild else "\n"))


def named(hips, spine, neck, head, bones, left, right, leave_out=()):
    """Names of a rig. bones: the words of clavicle to toe; left and right: patterns."""
    words = ["clavicle", "upper arm", "forearm", "hand", "thigh", "shin", "foot", "toe"]
    names = dict.fromkeys(JOINTS)
    names.update(zip(("hips", "spine1", "spine2", "chest", "neck", "head"), (hips, *spine, neck, head)))
    for side, pattern in (("left", left), ("right", right)):
        for word, bone in zip(words, bones):
            names[f"{side} {word}"] = pattern.format(bone)
    return names


def main():
    upright = lambda joint: np.eye(3)
    mixamo = named("mixamorig:Hips", ("mixamorig:Spine", "mixamorig:Spine1", "mixamorig:Spine2"),
                   "mixamorig:Neck", "mixamorig:Head",
                   ("Shoulder", "Arm", "ForeArm", "Hand", "UpLeg", "Leg", "Foot", "ToeBase"),
                   "mixamorig:Left{}", "mixamorig:Right{}")
    write("mixamo.bvh", mixamo, upright, 100.0, "zyx")
    poser = named("Hips", ("Chest", "Chest2", "Chest3"), "Neck", "Head",
                  ("Collar", "Shoulder", "Elbow", "Wrist", "Hip", "Knee", "Ankle", "Toe"),
                  "Left{}", "Right{}")
    write("poser_wild.bvh", poser, lowered, 0.45 / 0.0254, "zxy", wild=True)
    lafan = named("Hips", ("Spine", "Spine1", "Spine2"), "Neck", "Head",
                  ("Shoulder", "Arm", "ForeArm", "Hand", "UpLeg", "Leg", "Foot", "Toe"),
                  "Left{}", "Right{}")
    write("lafan.bvh", lafan, along_x, 100.0, "zyx")
    bandai = named("Hips", ("Spine", "Spine1", "Chest"), "Neck", "Head",
                   ("Shoulder", "UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot", "Toes"),
                   "{}_L", "{}_R")
    write("bandai.bvh", bandai, lambda joint: along_x(joint, mirror=True), 100.0, "zxy", six=True)
    bones = {joint: f"bone {number:02}" for number, joint in enumerate(JOINTS)}
    nameless = {joint: None if joint in ENDS else bones[joint] for joint in JOINTS}
    z_up = np.array([[-1.0, 0, 0], [0, 0, 1], [0, 1, 0]])
    write("nameless.bvh", nameless, upright, 1000.0, "xyz", to_file=z_up)
    shown = []
    for frame in range(FRAMES):
        _, at = pose(frame / RATE)
        shown.append({joint: [round(float(v), 6) for v in at[joint]] for joint in JOINTS})
    with open("shown.json", "w", encoding="ascii") as file:
        json.dump({"joints": JOINTS, "at": [[frame[j] for j in JOINTS] for frame in shown]}, file)
        file.write("\n")


main()
