"""Writes small animated files of glTF, and where their joints are.

Independent of Effigy: pygltflib writes the files, and the equations of glTF 2.0 are computed with NumPy in float64. Run
it in this folder:

    python3 make.py

NumPy 1.20 and pygltflib 1.16 or later. The files are committed; the random numbers are the same in every run.
"""

import copy
import json

import numpy as np
import pygltflib as g

RATE = 30
# A node of its own above all, turned and scaled as exporters from centimetres leave it, and one without a name.
NAMES = ["Armature", "hips", "spine", "twist", "arm", None, "unmoved"]
PARENT = [None, 0, 1, 2, 3, 1, 5]
SKIN = [1, 2, 4, 5, 6]


def matrix(quaternion):
    """The matrix of a quaternion x y z w."""
    x, y, z, w = quaternion / np.linalg.norm(quaternion)
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ])


def local(translation, rotation, scale):
    whole = np.eye(4)
    whole[:3, :3] = matrix(rotation) * scale
    whole[:3, 3] = translation
    return whole


def slerp(a, b, share):
    a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
    if a @ b < 0:
        b = -b
    angle = np.arccos(min(1.0, a @ b))
    if angle < 1e-9:
        return a
    return (np.sin((1 - share) * angle) * a + np.sin(share * angle) * b) / np.sin(angle)


def sample(times, values, interpolation, time, turns):
    after = int(np.searchsorted(times, time, side="right"))
    k = max(after - 1, 0)
    cubic = interpolation == "CUBICSPLINE"
    value = values[3 * k + 1] if cubic else values[k]
    if interpolation == "STEP" or k + 1 == len(times) or time <= times[0]:
        return value
    span = times[k + 1] - times[k]
    s = (time - times[k]) / span
    if not cubic:
        return slerp(values[k], values[k + 1], s) if turns else (1 - s) * values[k] + s * values[k + 1]
    p0, m0, m1, p1 = values[3 * k + 1], values[3 * k + 2], values[3 * k + 3], values[3 * k + 4]
    return ((2 * s**3 - 3 * s**2 + 1) * p0 + span * (s**3 - 2 * s**2 + s) * m0
            + (3 * s**2 - 2 * s**3) * p1 + span * (s**3 - s**2) * m1)


class Writer:
    def __init__(self):
        self.file = g.GLTF2(asset=g.Asset(version="2.0"))
        self.bytes = b""

    def view(self, array):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        raw = array.tobytes()
        self.file.bufferViews.append(g.BufferView(buffer=0, byteOffset=len(self.bytes), byteLength=len(raw)))
        self.bytes += raw
        return len(self.file.bufferViews) - 1

    def accessor(self, array, kind, component=g.FLOAT, normalized=False):
        count = len(array)
        accessor = g.Accessor(bufferView=self.view(array), componentType=component, count=count, type=kind,
                              normalized=normalized)
        if kind == "SCALAR":
            accessor.min, accessor.max = [float(array.min())], [float(array.max())]
        self.file.accessors.append(accessor)
        return len(self.file.accessors) - 1

    def sparse(self, array, kind):
        """Zeros but for one row in three."""
        places = np.arange(0, len(array), 3).astype(np.uint16)
        array = array.copy()
        array[[k for k in range(len(array)) if k % 3]] = 0.0
        sparse = g.Sparse(count=len(places),
                          indices=g.AccessorSparseIndices(bufferView=self.view(places), componentType=g.UNSIGNED_SHORT),
                          values=g.AccessorSparseValues(bufferView=self.view(array[places])))
        self.file.accessors.append(g.Accessor(componentType=g.FLOAT, count=len(array), type=kind, sparse=sparse))
        return len(self.file.accessors) - 1, array


def world(place):
    found = []
    for node, parent in enumerate(PARENT):
        own = local(*place[node])
        found.append(own if parent is None else found[parent] @ own)
    return found


def describe(matrices, joints):
    turn = lambda m: m[:3, :3] / np.cbrt(np.linalg.det(m[:3, :3]))
    return {"rotation": [turn(matrices[j]).tolist() for j in joints],
            "translation": [matrices[j][:3, 3].tolist() for j in joints]}


def main():
    random = np.random.default_rng(20261127)
    f32 = lambda array: np.asarray(array, dtype=np.float32)
    unit = lambda *shape: (lambda q: f32(q / np.linalg.norm(q, axis=-1, keepdims=True)))(random.normal(size=shape + (4,)))
    writer = Writer()
    file = writer.file
    nodes = []
    for node, name in enumerate(NAMES):
        scale = 0.01 if node == 0 else 1.5 if node == 3 else 1.0
        # Nodes are posed: where the skin was made, they are turned otherwise.
        nodes.append((f32(100 * random.normal(size=3) if node else [0.2, 0, 0]), unit(), scale))
    for node, (translation, rotation, scale) in enumerate(nodes):
        children = [child for child, parent in enumerate(PARENT) if parent == node]
        entry = g.Node(name=NAMES[node], children=children)
        if node == 2:
            entry.matrix = local(translation, rotation, scale).T.ravel().tolist()
        else:
            entry.translation, entry.rotation = translation.tolist(), rotation.tolist()
            entry.scale = [scale] * 3
        file.nodes.append(entry)
    file.scenes, file.scene = [g.Scene(nodes=[0])], 0

    made = copy.deepcopy(nodes)
    made[5] = (f32([10, 20, 30]), unit(), 1.0)
    made_world = world(made)
    inverse = f32([np.linalg.inv(made_world[j]).T for j in SKIN])
    file.skins = [g.Skin(joints=SKIN, inverseBindMatrices=writer.accessor(inverse, "MAT4"))]

    curves = {}

    def animate(animation, node, path, times, values, interpolation, output=None):
        kind = "VEC4" if path == "rotation" else "VEC3"
        if output is None:
            output = writer.accessor(values, kind)
        animation.samplers.append(g.AnimationSampler(input=times[0], output=output, interpolation=interpolation))
        target = g.AnimationChannelTarget(node=node, path=path)
        animation.channels.append(g.AnimationChannel(sampler=len(animation.samplers) - 1, target=target))
        curves[node, path] = (times[1], values, interpolation)

    animation = g.Animation(name="Dance")
    dense = f32(np.arange(7) / RATE)
    coarse = f32([0.05, 0.1, 0.15])
    dense, coarse = [(writer.accessor(times, "SCALAR"), times.astype(float)) for times in (dense, coarse)]
    animate(animation, 1, "translation", dense, f32(random.normal(size=(7, 3))), "LINEAR")
    animate(animation, 1, "rotation", dense, unit(7), "LINEAR")
    animate(animation, 2, "rotation", coarse, f32(random.normal(size=(9, 4))), "CUBICSPLINE")
    animate(animation, 4, "translation", coarse, f32(random.normal(size=(9, 3))), "CUBICSPLINE")
    animate(animation, 4, "rotation", coarse, unit(3), "STEP")
    shorts = np.round(unit(7) * 32767).astype(np.int16)
    output = writer.accessor(shorts, "VEC4", g.SHORT, True)
    animate(animation, 5, "rotation", dense, shorts / 32767, "LINEAR", output)
    output, values = writer.sparse(f32(random.normal(size=(7, 3))), "VEC3")
    animate(animation, 5, "translation", dense, values, "LINEAR", output)
    # Weights of shapes are passed over.
    channel = g.AnimationChannel(sampler=0, target=g.AnimationChannelTarget(node=6, path="weights"))
    animation.channels.append(channel)
    still = g.Animation(name="Still", channels=[g.AnimationChannel(sampler=0, target=g.AnimationChannelTarget(
        node=1, path="rotation"))], samplers=[g.AnimationSampler(input=dense[0], output=animation.samplers[1].output)])
    file.animations = [animation, still]
    file.buffers = [g.Buffer(byteLength=len(writer.bytes))]
    file.set_binary_blob(writer.bytes)
    file.save_binary("dance.glb")
    embedded = copy.deepcopy(file)
    embedded.convert_buffers(g.BufferFormat.DATAURI)
    embedded.save_json("dance.gltf")
    beside = json.load(open("dance.gltf"))
    beside["buffers"][0]["uri"] = "dance%20bytes.bin"
    json.dump(beside, open("dance_beside.gltf", "w"))
    open("dance bytes.bin", "wb").write(writer.bytes)

    # The same tree as a human of VRM.
    bones = {"hips": 1, "spine": 2, "leftUpperArm": 4, "leftThumbMetacarpal": 5}
    for name, extension in [
        ("vrm0.vrm", {"VRM": {"specVersion": "0.0", "humanoid": {"humanBones": [
            {"bone": {"leftThumbMetacarpal": "leftThumbProximal"}.get(bone, bone), "node": node, "useDefaultValues": True}
            for bone, node in bones.items()]}}}),
        ("vrm1.vrm", {"VRMC_vrm": {"specVersion": "1.0", "humanoid": {"humanBones": {
            bone: {"node": node} for bone, node in bones.items()}}}}),
        ("dance.vrma", {"VRMC_vrm_animation": {"specVersion": "1.0", "humanoid": {"humanBones": {
            bone: {"node": node} for bone, node in bones.items()}}}}),
    ]:
        human = copy.deepcopy(file)
        human.set_binary_blob(writer.bytes)
        human.extensions = extension
        if name.endswith("vrma"):
            human.skins = []
        human.save_binary(name)

    frames = []
    for frame in range(7):
        time = frame / RATE
        place = list(nodes)
        for (node, path), (times, values, interpolation) in curves.items():
            value = sample(times, values, interpolation, time, path == "rotation")
            translation, rotation, scale = place[node]
            place[node] = (value, rotation, scale) if path == "translation" else (translation, value, scale)
        frames.append(describe(world(place), SKIN))
    with open("shown.json", "w") as out:
        shown = {"frames": frames, "nodes": describe(world(nodes), SKIN), "bind": describe(made_world, SKIN)}
        json.dump(json.loads(json.dumps(shown), parse_float=lambda text: round(float(text), 7)), out)


main()
