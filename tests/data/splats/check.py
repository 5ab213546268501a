"""Reads what Effigy writes with programs that know nothing of it.

    SPLATS=/tmp/splats /tmp/splats/bin/python check.py EFFIGY FOLDER

SPLATS: see make.py; also needs `pip install pygltflib`. EFFIGY is the program, FOLDER one to write
to. Prints a line a reading and ends with 1 when a number is off. `the_written_files_are_read_by_other_programs`
in tests/system/splats.rs runs it where SPLATS is set.
"""

import json
import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from plyfile import PlyData
from pygltflib import GLTF2

sys.path.insert(0, find_spec("spz").submodule_search_locations[0])
import spz  # noqa: E402

HERE = Path(__file__).parent
SPLATS = os.environ["SPLATS"]
HARMONIC = 0.28209479177387814
# From y down to y up: half a turn about x. Signs of the harmonics of degree 1 to 3.
SIGNS = np.array([-1, -1, 1, -1, 1, 1, -1, 1, -1, 1, -1, -1, 1, -1, 1])


def sigmoid(x):
    return 1 / (1 + np.exp(-x.astype(float)))


def ply(path):
    """Columns: position, rotation w x y z, log scale, opacity, coefficients of degree 0, the rest."""
    vertices = PlyData.read(path)["vertex"]
    columns = lambda *names: np.stack([vertices[name] for name in names], axis=1).astype(float)
    of = lambda prefix, count: columns(*[f"{prefix}_{k}" for k in range(count)])
    names = [p.name for p in vertices.properties]
    count = sum(name.startswith("f_rest_") for name in names)
    rest = of("f_rest", count).reshape(len(vertices), 3, -1).transpose(0, 2, 1) if count else None
    return dict(position=columns("x", "y", "z"), rotation=of("rot", 4), scale=of("scale", 3),
                opacity=sigmoid(vertices["opacity"]), color=of("f_dc", 3), rest=rest)


def turned(splats):
    """Half a turn about x."""
    position = splats["position"] * [1, -1, -1]
    w, x, y, z = splats["rotation"].T
    rest = splats["rest"]
    return dict(splats, position=position, rotation=np.stack([-x, w, -z, y], axis=1),
                rest=None if rest is None else rest * SIGNS[:rest.shape[1], None])


def glb(path):
    file = GLTF2().load(path)
    attributes = json.loads(file.to_json())["meshes"][0]["primitives"][0]["attributes"]
    binary = file.binary_blob()

    def read(name):
        accessor = file.accessors[attributes[name]]
        view = file.bufferViews[accessor.bufferView]
        kind = {5126: np.float32, 5121: np.uint8}[accessor.componentType]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor.type]
        start = (view.byteOffset or 0) + (accessor.byteOffset or 0)
        values = np.frombuffer(binary, kind, accessor.count * width, start)
        return values.reshape(accessor.count, width).astype(float)

    own = "KHR_gaussian_splatting:"
    rest = [read(f"{own}SH_DEGREE_{l}_COEF_{k}") for l in (1, 2, 3) for k in range(2 * l + 1)]
    position = read("POSITION")
    accessor = file.accessors[attributes["POSITION"]]
    assert np.allclose(accessor.min, position.min(axis=0)) and np.allclose(accessor.max, position.max(axis=0))
    length = np.linalg.norm(read(own + "ROTATION"), axis=1)
    assert np.abs(length - 1).max() < 1e-6
    return dict(position=position, rotation=read(own + "ROTATION")[:, [3, 0, 1, 2]],
                scale=np.log(read(own + "SCALE")), opacity=read(own + "OPACITY")[:, 0],
                color=read(own + "SH_DEGREE_0_COEF_0"), rest=np.stack(rest, axis=1))


def spz_file(path):
    cloud = spz.load(str(path))
    sh = np.array(cloud.spherical_harmonics).reshape(cloud.num_points, -1, 3)
    return dict(position=np.array(cloud.positions).reshape(-1, 3), 
                # x y z w, other than its documentation has it.
                rotation=np.array(cloud.rotations)[:, [3, 0, 1, 2]],
                scale=np.array(cloud.scales).reshape(-1, 3), opacity=sigmoid(np.array(cloud.alphas)),
                color=np.array(cloud.colors).reshape(-1, 3), rest=sh)


def transformed(path):
    """A file as splat-transform reads it, in the file's own axes."""
    out = path.with_suffix(path.suffix + ".ply")
    subprocess.run([f"{SPLATS}/node_modules/.bin/splat-transform", "-q", "-w", str(path), str(out)],
                   check=True, stdout=subprocess.DEVNULL)
    return ply(out)


def check(name, truth, read, limits):
    """Compares element by element; splats may be in another order."""
    order = [np.argmin(np.abs(truth["position"] - p).sum(axis=1)) for p in read["position"]]
    found = {}
    if len(set(order)) == len(truth["position"]):
        unit = lambda q: q / np.linalg.norm(q, axis=1, keepdims=True)
        a, b = unit(truth["rotation"][order]), unit(read["rotation"])
        # An ellipsoid is the same after half a turn about one of its axes; programs differ in that.
        w, x, y, z = b.T
        halves = [np.stack(q, axis=1) for q in [(w, x, y, z), (-x, w, z, -y), (-y, -z, w, x), (-z, y, -x, w)]]
        chords = [np.linalg.norm(a - q * np.where((a * q).sum(axis=1) < 0, -1, 1)[:, None], axis=1) for q in halves]
        shown = lambda c: np.clip(0.5 + HARMONIC * c, 0, 1)
        found = dict(
            position=np.abs(truth["position"][order] - read["position"]).max(),
            rotation=(4 * np.arcsin(np.min(chords, axis=0) / 2)).max(),
            scale=np.abs(truth["scale"][order] - read["scale"]).max(),
            opacity=np.abs(truth["opacity"][order] - read["opacity"]).max(),
            color=np.abs(shown(truth["color"][order]) - shown(read["color"])).max())
        if "rest" in limits:
            found["rest"] = np.abs(truth["rest"][order] - read["rest"]).max()
    bad = [key for key, limit in limits.items() if not found.get(key, np.inf) <= limit]
    print(name, "OFF: " + ", ".join(bad) if bad else "ok",
          {key: float(f"{value:.3g}") for key, value in found.items()})
    return not bad


def main():
    effigy, folder = sys.argv[1], Path(sys.argv[2])
    for ending in ("ply", "spz", "splat", "glb"):
        subprocess.run([effigy, "convert", str(HERE / "truth.ply"), str(folder / f"a.{ending}")],
                       check=True, stdout=subprocess.DEVNULL)
    truth = ply(HERE / "truth.ply")
    up = turned(truth)
    exact = dict(position=0, rotation=1e-7, scale=0, opacity=0, color=0, rest=0)
    floats = dict(position=1e-6, rotation=1e-6, scale=2e-6, opacity=1e-6, color=1e-6, rest=1e-6)
    codes = dict(position=0.501 / 16384, rotation=4e-3, scale=0.501 / 16, opacity=0.501 / 255,
                 color=0.004, rest=0.501 / 128)
    bytes_ = dict(position=1e-6, rotation=0.04, scale=2e-6, opacity=0.501 / 255, color=0.501 / 255)
    results = [
        check("a.ply, plyfile", truth, ply(folder / "a.ply"), exact),
        check("a.ply, splat-transform", truth, transformed(folder / "a.ply"), dict(exact, rotation=1e-6, opacity=1e-6)),
        check("a.spz, spz", up, spz_file(folder / "a.spz"), codes),
        check("a.spz, splat-transform", truth, transformed(folder / "a.spz"), codes),
        check("a.splat, splat-transform", truth, transformed(folder / "a.splat"), bytes_),
        check("a.glb, pygltflib", up, glb(folder / "a.glb"), floats),
    ]
    sys.exit(not all(results))


main()
