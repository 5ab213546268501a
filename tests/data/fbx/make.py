"""Writes a small animated FBX in text, and where its joints are.

Independent of Effigy and of the library that reads FBX: the text follows FBX 7.4 as Autodesk's tools write it, and the
transforms that its documentation gives (translation, pre-rotation, rotation in an order, scale) are computed with NumPy
in float64. Run it in this folder:

    python3 make.py

NumPy 1.20 or later. The files are committed; the random numbers are the same in every run.
"""

import json

import numpy as np

SECOND = 46186158000
RATE = 25
FRAMES = 5
# An empty node of another scale above a chain of bones, and a bone that nothing moves.
NAMES = ["Armature", "Hips", "Spine", "Arm", "Still"]
PARENT = [None, 0, 1, 2, 1]
ORDER = [0, 0, 4, 2, 0]  # eEulerXYZ, eEulerYZX is 2, eEulerZXY is 4
AXES = {0: "XYZ", 2: "YZX", 4: "ZXY"}


def turn(axis, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return {"X": np.array([[1, 0, 0], [0, c, -s], [0, s, c]]), "Y": np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]),
            "Z": np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])}[axis]


def euler(degrees, order):
    """The first letter turns first."""
    whole = np.eye(3)
    for axis in AXES[order]:
        whole = turn(axis, degrees["XYZ".index(axis)]) @ whole
    return whole


def main():
    random = np.random.default_rng(20261128)
    count = len(NAMES)
    translation = 10 * random.normal(size=(count, 3))
    rotation = 40 * random.normal(size=(count, 3))
    pre = 30 * random.normal(size=(count, 3))
    scale = [2.0, 1.0, 1.0, 1.0, 1.0]
    # Keys of every frame: straight between them.
    moved = {1: 10 * random.normal(size=(FRAMES, 3))}
    turned = {node: 40 * random.normal(size=(FRAMES, 3)) for node in (1, 2, 3)}

    objects, connections, identity = [], [], 1000
    for node, name in enumerate(NAMES):
        kind = "Null" if node == 0 else "LimbNode"
        vector = lambda name, kind, v: f'P: "{name}", "{kind}", "", "A",{v[0]:.9f},{v[1]:.9f},{v[2]:.9f}'
        objects.append(f'''NodeAttribute: {200 + node}, "NodeAttribute::{name}", "{kind}" {{
    TypeFlags: "{'Null' if node == 0 else 'Skeleton'}"
  }}
  Model: {100 + node}, "Model::{name}", "{kind}" {{
    Version: 232
    Properties70: {{
      P: "RotationActive", "bool", "", "",1
      P: "RotationOrder", "enum", "", "",{ORDER[node]}
      P: "InheritType", "enum", "", "",1
      {vector("PreRotation", "Vector3D", pre[node])}
      {vector("Lcl Translation", "Lcl Translation", translation[node])}
      {vector("Lcl Rotation", "Lcl Rotation", rotation[node])}
      {vector("Lcl Scaling", "Lcl Scaling", [scale[node]] * 3)}
    }}
  }}''')
        connections.append(f'C: "OO",{200 + node},{100 + node}')
        connections.append(f'C: "OO",{100 + node},{0 if PARENT[node] is None else 100 + PARENT[node]}')
    for stack, label in ((10, "Walk"), (12, "Rest")):
        objects.append(f'''AnimationStack: {stack}, "AnimStack::{label}", "" {{
    Properties70: {{
      P: "LocalStart", "KTime", "Time", "",0
      P: "LocalStop", "KTime", "Time", "",{(FRAMES - 1) * SECOND // RATE}
    }}
  }}
  AnimationLayer: {stack + 1}, "AnimLayer::Base", "" {{
  }}''')
        connections.append(f'C: "OO",{stack + 1},{stack}')
    times = ",".join(str(frame * SECOND // RATE) for frame in range(FRAMES))
    for letter, property, values in (("T", "Lcl Translation", moved), ("R", "Lcl Rotation", turned)):
        for node, keys in values.items():
            identity += 10
            objects.append(f'''AnimationCurveNode: {identity}, "AnimCurveNode::{letter}", "" {{
    Properties70: {{
      P: "d|X", "Number", "", "A",{keys[0][0]:.9f}
      P: "d|Y", "Number", "", "A",{keys[0][1]:.9f}
      P: "d|Z", "Number", "", "A",{keys[0][2]:.9f}
    }}
  }}''')
            connections.append(f'C: "OO",{identity},11')
            connections.append(f'C: "OP",{identity},{100 + node}, "{property}"')
            for axis in range(3):
                numbers = ",".join(f"{key:.9f}" for key in keys[:, axis])
                objects.append(f'''AnimationCurve: {identity + 1 + axis}, "AnimCurve::", "" {{
    Default: 0
    KeyVer: 4008
    KeyTime: *{FRAMES} {{
      a: {times}
    }}
    KeyValueFloat: *{FRAMES} {{
      a: {numbers}
    }}
    KeyAttrFlags: *1 {{
      a: 4
    }}
    KeyAttrDataFloat: *4 {{
      a: 0,0,0,0
    }}
    KeyAttrRefCount: *1 {{
      a: {FRAMES}
    }}
  }}''')
                connections.append(f'C: "OP",{identity + 1 + axis},{identity}, "d|{"XYZ"[axis]}"')
    # Where bones were when a skin was made: the armature and the hips as they stand, the spine upright.

    def world(t, r, made=False):
        found = []
        for node, parent in enumerate(PARENT):
            own = np.eye(4)
            own[:3, :3] = euler(pre[node], 0) @ euler(r[node], ORDER[node]) * scale[node]
            if made and node == 2:
                own[:3, :3] = np.eye(3)
            own[:3, 3] = t[node]
            found.append(own if parent is None else found[parent] @ own)
        return found

    made = world(translation, rotation, True)
    poses = "\n".join(f'''    PoseNode:  {{
      Node: {100 + node}
      Matrix: *16 {{
        a: {",".join(f"{number:.12f}" for number in made[node].T.ravel())}
      }}
    }}''' for node in range(count))
    objects.append(f'''Pose: 50, "Pose::Bind", "BindPose" {{
    Type: "BindPose"
    Version: 100
    NbPoseNodes: {count}
{poses}
  }}''')
    text = f'''; FBX 7.4.0 project file
FBXHeaderExtension:  {{
  FBXHeaderVersion: 1003
  FBXVersion: 7400
}}
GlobalSettings:  {{
  Version: 1000
  Properties70:  {{
    P: "UpAxis", "int", "Integer", "",2
    P: "UpAxisSign", "int", "Integer", "",1
    P: "FrontAxis", "int", "Integer", "",1
    P: "FrontAxisSign", "int", "Integer", "",-1
    P: "CoordAxis", "int", "Integer", "",0
    P: "CoordAxisSign", "int", "Integer", "",1
    P: "UnitScaleFactor", "double", "Number", "",1
    P: "TimeMode", "enum", "", "",10
  }}
}}
Objects:  {{
  {chr(10).join("  " + entry for entry in objects).strip()}
}}
Connections:  {{
  {(chr(10) + "  ").join(connections)}
}}
'''
    with open("walk.fbx", "w") as file:
        file.write(text)

    def describe(matrices):
        straight = [m[:3, :3] / np.cbrt(np.linalg.det(m[:3, :3])) for m in matrices[1:]]
        return {"rotation": [m.tolist() for m in straight], "translation": [m[:3, 3].tolist() for m in matrices[1:]]}

    frames = []
    for at in range(FRAMES):
        t, r = translation.copy(), rotation.copy()
        for node, keys in moved.items():
            t[node] = keys[at]
        for node, keys in turned.items():
            r[node] = keys[at]
        frames.append(describe(world(t, r)))
    shown = {"frames": frames, "nodes": describe(world(translation, rotation)), "bind": describe(made)}
    with open("shown.json", "w") as file:
        json.dump(json.loads(json.dumps(shown), parse_float=lambda text: round(float(text), 7)), file)


main()
