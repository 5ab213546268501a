"""Writes the same splats in every format that Effigy reads, by programs that know nothing of Effigy.

    python3 -m venv /tmp/splats && /tmp/splats/bin/pip install numpy plyfile pillow spz
    npm install --prefix /tmp/splats @playcanvas/splat-transform spz-js @mkkellogg/gaussian-splats-3d
    SPLATS=/tmp/splats /tmp/splats/bin/python make.py

Run it in this folder; Node 20 or later. The committed files are from numpy 2.4.6, plyfile 1.1.5,
pillow 13.0.0, spz 0.0.1, splat-transform 2.7.1, spz-js 1.2.5 and gaussian-splats-3d 0.4.7. The
random numbers are the same in every run; splat-transform's palettes are not.

| file | written by |
|---|---|
| truth.ply | plyfile: 64 Gaussians of degree 3, y down |
| small.compressed.ply, small.sog, small-4.spz, small.glb | splat-transform |
| many.compressed.ply | splat-transform, of five copies of the truth a metre apart along x, degree 0 |
| small-0.spz to small-2.spz | spz (PyPI): degrees 0 to 2 |
| small-js.spz | spz-js |
| small-v1.spz | NumPy, after the format's own source: no program writes version 1 any more |
| small-0.ksplat, small-1.ksplat, small-2.ksplat | gaussian-splats-3d: compressions 0 to 2, degree 2 |
| small.splat | NumPy, after antimatter15's converter |
| small-v1.sog | NumPy and Pillow, after PlayCanvas's description of version 1, degree 1 |
| packed.glb | Python's json around small-js.spz, after KHR_gaussian_splatting_compression_spz_2 |
| small.gltf | the same numbers as small.glb, two nodes that turn and move, integer attributes |
"""

import base64
import gzip
import io
import json
import os
import struct
import subprocess
import sys
import tempfile
import zipfile
from importlib.util import find_spec

import numpy as np
from PIL import Image
from plyfile import PlyData, PlyElement

# The package's own __init__ imports itself (0.0.1); its library is beside that.
sys.path.insert(0, find_spec("spz").submodule_search_locations[0])
import spz  # noqa: E402

COUNT = 64
HARMONIC = 0.28209479177387814
SPLATS = os.environ["SPLATS"]


def make_truth(random):
    """Columns of a 3DGS .ply."""
    # On a grid of 20 cm and a little off it: each is found again by its place.
    grid = np.stack(np.unravel_index(np.arange(COUNT), (4, 4, 4)), axis=1) - 1.5
    position = 0.2 * grid + random.uniform(-0.05, 0.05, (COUNT, 3))
    rotation = random.normal(size=(COUNT, 4))
    columns = {}
    for k, name in enumerate("xyz"):
        columns[name] = position[:, k]
    for name in ("nx", "ny", "nz"):
        columns[name] = np.zeros(COUNT)
    for k in range(3):
        columns[f"f_dc_{k}"] = random.uniform(-1.5, 1.5, COUNT)
    for k in range(45):
        columns[f"f_rest_{k}"] = random.uniform(-0.5, 0.5, COUNT)
    columns["opacity"] = random.uniform(-4.0, 4.0, COUNT)
    for k in range(3):
        columns[f"scale_{k}"] = random.uniform(-6.0, -2.5, COUNT)
    for k in range(4):
        columns[f"rot_{k}"] = rotation[:, k] / np.linalg.norm(rotation, axis=1)
    return {name: column.astype(np.float32) for name, column in columns.items()}


def write_ply(path, columns):
    rows = np.rec.fromarrays(list(columns.values()), names=list(columns))
    PlyData([PlyElement.describe(np.asarray(rows), "vertex")]).write(path)


def stack(columns, *names):
    return np.ascontiguousarray(np.stack([columns[name] for name in names], axis=1))


def of(columns, prefix, count):
    return stack(columns, *[f"{prefix}_{k}" for k in range(count)])


def harmonics(columns, degree):
    """Coefficients of a degree, all functions of red first in the file: shape N, functions, 3."""
    functions = (degree + 1) ** 2 - 1
    whole = of(columns, "f_rest", 45).reshape(COUNT, 3, 15)
    return np.ascontiguousarray(whole[:, :, :functions].transpose(0, 2, 1))


def run(*words):
    subprocess.run([str(word) for word in words], check=True, stdout=subprocess.DEVNULL)


def transform(*words):
    run(f"{SPLATS}/node_modules/.bin/splat-transform", "-q", "-w", *words)


def write_spz(columns):
    """All axes as they stand in the .ply: no program is asked to turn anything."""
    for degree in range(3):
        sh = harmonics(columns, degree).reshape(COUNT, -1)
        cloud = spz.GaussianSplat(
            positions=stack(columns, "x", "y", "z"), scales=of(columns, "scale", 3),
            # x y z w, other than its documentation has it.
            rotations=np.ascontiguousarray(of(columns, "rot", 4)[:, [1, 2, 3, 0]]),
            alphas=columns["opacity"],
            colors=of(columns, "f_dc", 3), sh_degree=degree,
            spherical_harmonics=sh if degree > 0 else None)
        cloud.save(f"small-{degree}.spz")
    codes = lambda x: np.clip(np.round(x), 0, 255).astype(np.uint8)
    xyzw = of(columns, "rot", 4)[:, [1, 2, 3, 0]]
    xyzw = xyzw * np.where(xyzw[:, 3:] < 0, -1, 1)
    content = struct.pack("<4sIIBBBB", b"NGSP", 1, COUNT, 0, 12, 0, 0)
    content += stack(columns, "x", "y", "z").astype(np.float16).tobytes()
    content += codes(255 / (1 + np.exp(-columns["opacity"].astype(float)))).tobytes()
    content += codes(of(columns, "f_dc", 3) * 0.15 * 255 + 127.5).tobytes()
    content += codes((of(columns, "scale", 3) + 10) * 16).tobytes()
    content += codes(xyzw[:, :3] * 127.5 + 127.5).tobytes()
    with open("small-v1.spz", "wb") as file:
        file.write(gzip.compress(content, mtime=0))


def write_splat(columns):
    rows = bytearray()
    opacity = 1 / (1 + np.exp(-columns["opacity"].astype(float)))
    for k in range(COUNT):
        rows += stack(columns, "x", "y", "z")[k].tobytes()
        rows += np.exp(of(columns, "scale", 3)[k]).tobytes()
        color = np.append(0.5 + HARMONIC * of(columns, "f_dc", 3)[k], opacity[k])
        rows += (color * 255).clip(0, 255).astype(np.uint8).tobytes()
        rows += (of(columns, "rot", 4)[k] * 128 + 128).clip(0, 255).astype(np.uint8).tobytes()
    with open("small.splat", "wb") as file:
        file.write(rows)


def write_sog_1(columns):
    side = 12
    images = {}

    def image(name, *channels):
        pixels = np.zeros((side * side, 4), np.uint8)
        pixels[:, 3] = 255
        for k, channel in enumerate(channels):
            pixels[:COUNT, k] = channel
        save(name, pixels.reshape(side, side, 4))

    def save(name, pixels):
        file = io.BytesIO()
        Image.fromarray(pixels, "RGBA").save(file, "WEBP", lossless=True, exact=True)
        images[name] = file.getvalue()

    def part(values):
        low, high = values.min(axis=0), values.max(axis=0)
        return low, high, (values - low) / (high - low)

    position = stack(columns, "x", "y", "z").astype(float)
    low, high, parts = part(np.sign(position) * np.log1p(np.abs(position)))
    means = np.round(65535 * parts).astype(int)
    image("means_l.webp", *(means & 255).T)
    image("means_u.webp", *(means >> 8).T)
    meta = {"means": {"shape": [COUNT, 3], "dtype": "float32", "mins": low.tolist(),
                      "maxs": high.tolist(), "files": ["means_l.webp", "means_u.webp"]}}
    low, high, parts = part(of(columns, "scale", 3).astype(float))
    image("scales.webp", *np.round(255 * parts).astype(int).T)
    meta["scales"] = {"shape": [COUNT, 3], "dtype": "float32", "mins": low.tolist(),
                      "maxs": high.tolist(), "files": ["scales.webp"]}
    rotation = of(columns, "rot", 4).astype(float)
    largest = np.abs(rotation).argmax(axis=1)
    rotation *= np.sign(np.take_along_axis(rotation, largest[:, None], axis=1))
    small = np.array([np.delete(q, k) for q, k in zip(rotation, largest)])
    image("quats.webp", *np.round((small * np.sqrt(2) * 0.5 + 0.5) * 255).astype(int).T, 252 + largest)
    meta["quats"] = {"shape": [COUNT, 4], "dtype": "uint8", "encoding": "quaternion_packed",
                     "files": ["quats.webp"]}
    color = np.concatenate([of(columns, "f_dc", 3), columns["opacity"][:, None]], axis=1)
    low, high, parts = part(color.astype(float))
    image("sh0.webp", *np.round(255 * parts).astype(int).T)
    meta["sh0"] = {"shape": [COUNT, 1, 4], "dtype": "float32", "mins": low.tolist(),
                   "maxs": high.tolist(), "files": ["sh0.webp"]}
    # Every splat has a palette entry of its own, in another order.
    sh = harmonics(columns, 1).astype(float)
    low, high = sh.min(), sh.max()
    labels = (7 * np.arange(COUNT) + 3) % 66
    palette = np.full((2, 64, 3, 4), 255, np.uint8)
    for k, label in enumerate(labels):
        palette[label // 64, label % 64, :, :3] = np.round(255 * (sh[k] - low) / (high - low))
    save("shN_centroids.webp", palette.reshape(2, 192, 4))
    image("shN_labels.webp", labels & 255, labels >> 8)
    meta["shN"] = {"shape": [COUNT, 9], "dtype": "float32", "mins": low, "maxs": high,
                   "quantization": 8, "files": ["shN_centroids.webp", "shN_labels.webp"]}
    with zipfile.ZipFile("small-v1.sog", "w") as archive:
        archive.writestr("meta.json", json.dumps(meta))
        for name, content in images.items():
            archive.writestr(name, content)


def write_glb(path, document, binary):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)))
        file.write(struct.pack("<I4s", len(text), b"JSON") + text)
        file.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)


def splatting(**more):
    return {"KHR_gaussian_splatting": {"kernel": "ellipse", "colorSpace": "srgb_rec709_display", **more}}


def write_gltf(columns):
    with open("small-js.spz", "rb") as file:
        packed = file.read()
    name = "KHR_gaussian_splatting_compression_spz_2"
    write_glb("packed.glb", {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_gaussian_splatting", name],
        "extensionsRequired": ["KHR_gaussian_splatting", name],
        "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"mode": 0, "attributes": {},
                                    "extensions": splatting(extensions={name: {"bufferView": 0}})}]}],
        "bufferViews": [{"buffer": 0, "byteLength": len(packed)}],
        "buffers": [{"byteLength": len(packed)}]}, packed)
    # Degree 0, integers where the extension allows them, under nodes that turn, stretch and move.
    binary, views, accessors, attributes = b"", [], [], {}
    rotation = of(columns, "rot", 4)[:, [1, 2, 3, 0]]
    opacity = 1 / (1 + np.exp(-columns["opacity"].astype(float)))
    own = "KHR_gaussian_splatting:"
    for attribute, values, kind, shape in [
        ("POSITION", stack(columns, "x", "y", "z"), 5126, "VEC3"),
        (own + "ROTATION", np.round(rotation * 32767).astype(np.int16), 5122, "VEC4"),
        (own + "SCALE", np.exp(of(columns, "scale", 3)), 5126, "VEC3"),
        (own + "OPACITY", np.round(opacity * 65535).astype(np.uint16)[:, None], 5123, "SCALAR"),
        (own + "SH_DEGREE_0_COEF_0", of(columns, "f_dc", 3), 5126, "VEC3"),
    ]:
        # Rows start at multiples of 4.
        row = np.ascontiguousarray(values.reshape(COUNT, -1)).view(np.uint8).reshape(COUNT, -1)
        row = np.pad(row, ((0, 0), (0, -row.shape[1] % 4)))
        attributes[attribute] = len(views)
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": row.size,
                      "byteStride": row.shape[1]})
        accessors.append({"bufferView": len(accessors), "componentType": kind, "count": COUNT,
                          "type": shape, "normalized": kind != 5126})
        binary += row.tobytes()
    half = np.sqrt(0.5)
    document = {
        "asset": {"version": "2.0"}, "extensionsUsed": ["KHR_gaussian_splatting"],
        "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"children": [1], "translation": [1, 2, 3], "rotation": [0, half, 0, half]},
                  {"mesh": 0, "scale": [2, 2, 2]}],
        "meshes": [{"primitives": [{"mode": 0, "attributes": attributes, "extensions": splatting()}]}],
        "accessors": accessors, "bufferViews": views,
        "buffers": [{"byteLength": len(binary), "uri":
                     "data:application/octet-stream;base64," + base64.b64encode(binary).decode()}]}
    with open("small.gltf", "w") as file:
        json.dump(document, file)


def main():
    columns = make_truth(np.random.default_rng(20261126))
    write_ply("truth.ply", columns)
    transform("truth.ply", "small.compressed.ply")
    # Its compression of harmonics wants a GPU unless told otherwise.
    transform("-g", "cpu", "truth.ply", "small.sog")
    transform("truth.ply", "--spz-version", 4, "small-4.spz")
    transform("truth.ply", "small.glb")
    flat = {name: column for name, column in columns.items() if not name.startswith("f_rest")}
    copies = [dict(flat, x=flat["x"] + np.float32(k)) for k in range(5)]
    many = {name: np.concatenate([copy[name] for copy in copies]) for name in flat}
    with tempfile.TemporaryDirectory() as folder:
        write_ply(f"{folder}/many.ply", many)
        transform(f"{folder}/many.ply", "many.compressed.ply")
    write_spz(columns)
    write_splat(columns)
    write_sog_1(columns)
    run("node", "make.mjs", SPLATS)
    write_gltf(columns)


main()
