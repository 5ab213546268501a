"""Writes a small model in the form of the paper's viewer, poses beside it, and what it shows.

Independent of Effigy: arrays, names and equations come from docs/formats.md and docs/model.md, and
everything is computed with NumPy in float64. Run it in this folder:

    python3 make.py

NumPy 1.20 or later. The files are committed; the random numbers are the same in every run.
"""

import json
import sys

import numpy as np

sys.path.append("..")
from smpl_x import PARENTS, quaternion_matrix, rotation  # noqa: E402

GAUSSIANS, PARTS, NODES, JOINTS, BASIS, ROWS = 160, 4, 14, 55, 16, 24
HEAD_PARTS = 1
HARMONIC = 0.28209479177387814


def halves(numbers):
    return np.asarray(numbers).astype(np.float16)


def make_model(random):
    """The file's arrays."""
    model = {}
    # A wavy sheet with nodes on it: 0.5 m wide, a metre above the ground.
    at = lambda count: random.uniform(-0.25, 0.25, (count, 2))
    sheet = lambda uv: np.stack(
        [uv[:, 0], 1.0 + uv[:, 1], 0.04 * np.sin(9.0 * uv[:, 0])], axis=1)
    position = halves(sheet(at(GAUSSIANS)))
    nodes = sheet(at(NODES))
    model["_xyz"] = position
    model["_rotation"] = halves(random.normal(size=(GAUSSIANS, 4)))
    model["_scaling"] = halves(random.uniform(-5.5, -4.0, (GAUSSIANS, 3)))
    model["_sh0"] = halves(random.uniform(-1.2, 1.2, (GAUSSIANS, 1, 3)))
    model["opacity"] = random.integers(100, 256, GAUSSIANS).astype(np.uint8)
    joints = np.array([[0.01 * j * (-1) ** j, 0.8 + 0.012 * j, 0.004 * j] for j in range(JOINTS)])
    model["t_joints"] = halves(joints)
    model["weights_idx"] = random.integers(0, JOINTS, (GAUSSIANS, 4)).astype(np.uint8)
    shares = random.dirichlet([1.0, 1.0, 1.0, 1.0], GAUSSIANS)
    whole = np.floor(255 * shares).astype(int)
    whole[:, 0] += 255 - whole.sum(axis=1)
    model["weights_val"] = whole.astype(np.uint8)
    model["num_xyz_ft_head"] = np.uint32(HEAD_PARTS)
    widths = [73, 16, 16, 16, 2 * BASIS]
    for k in range(4):
        scale = 1.0 / np.sqrt(widths[k])
        weight = scale * random.normal(size=(widths[k + 1], PARTS, widths[k]))
        model[f"layers.{2 * k}.weight"] = halves(weight)
        model[f"layers.{2 * k}.bias"] = halves(0.1 * random.normal(size=(widths[k + 1], PARTS)))
    # Parts in no order, as the nearest of some points gives them.
    model["gs_feat_knn"] = random.integers(0, PARTS, GAUSSIANS).astype(np.uint16)
    for name, basis, size, scale in [
        ("rot_idxs", "rotation_basis", 4, 0.1),
        ("scale_idxs", "scaling_basis", 3, 0.05),
        ("color_idxs", "color_basis", 3, 0.1),
    ]:
        model[name] = random.permutation(GAUSSIANS)[:ROWS].astype(np.uint32)
        model[basis] = halves(scale * random.normal(size=(ROWS, size, BASIS)))
    model["ctrl_pt_offsets"] = halves(0.002 * random.normal(size=(NODES, 3)))
    model["ctrl_pt_basis"] = halves(0.003 * random.normal(size=(NODES, 3, BASIS)))
    model["ctrl_feat_knn"] = random.integers(0, PARTS, NODES).astype(np.uint16)
    distance = np.linalg.norm(position.astype(float)[:, None] - nodes[None], axis=2)
    near = np.argsort(distance, axis=1)[:, :3]
    inverse = 1.0 / np.maximum(np.take_along_axis(distance, near, axis=1), 1e-6)
    model["gs_ctrl_knn"] = near.astype(np.uint16)
    model["gs_ctrl_knn_weights"] = halves(inverse / inverse.sum(axis=1, keepdims=True))
    return model


def make_poses(random):
    poses = []
    for frame in range(3):
        turn = rotation(random.normal(size=3))
        poses.append({
            "frame_id": 7 + frame,
            "pose": (0.4 * random.normal(size=3 * JOINTS)).tolist(),
            "Th": random.normal(size=3).tolist(),
            "Rh": turn.tolist(),
            "expression": (0.5 * random.normal(size=10)).tolist() if frame > 0 else None,
        })
    return poses


def world_joints(joints, axes):
    matrices = []
    for j, parent in enumerate(PARENTS):
        local = np.eye(4)
        local[:3, :3] = rotation(axes[j])
        local[:3, 3] = joints[j] - (joints[parent] if parent >= 0 else 0.0)
        matrices.append(local if parent < 0 else matrices[parent] @ local)
    return matrices


def evaluate(model, frame):
    """Centres, covariances (xx xy xz yy yz zz) and colours of the posed Gaussians, in metres."""
    m = {name: np.asarray(array).astype(float) for name, array in model.items()}
    axes = np.array(frame["pose"]).reshape(JOINTS, 3)
    expression = np.array(frame["expression"] or [0.0] * 10)
    features = []
    for part in range(PARTS):
        x = np.concatenate([axes[1:22].ravel(), expression if part < HEAD_PARTS else 0 * expression])
        for k in range(4):
            x = m[f"layers.{2 * k}.weight"][:, part] @ x + m[f"layers.{2 * k}.bias"][:, part]
            if k < 3:
                x = np.maximum(0.01 * x, x)
        features.append(x)
    features = np.array(features)
    part = np.asarray(model["gs_feat_knn"]).astype(int)
    rotations, scales, colors = m["_rotation"], m["_scaling"], m["_sh0"][:, 0]
    for rows, basis, target in [
        ("rot_idxs", "rotation_basis", rotations),
        ("scale_idxs", "scaling_basis", scales),
        ("color_idxs", "color_basis", colors),
    ]:
        for row, gaussian in enumerate(np.asarray(model[rows]).astype(int)):
            target[gaussian] += m[basis][row] @ features[part[gaussian], :BASIS]
    node_part = np.asarray(model["ctrl_feat_knn"]).astype(int)
    moved = m["ctrl_pt_offsets"] + np.einsum(
        "sck,sk->sc", m["ctrl_pt_basis"], features[node_part, BASIS:])
    near = np.asarray(model["gs_ctrl_knn"]).astype(int)
    position = m["_xyz"] + np.einsum("nk,nkc->nc", m["gs_ctrl_knn_weights"], moved[near])
    canonical = np.zeros((JOINTS, 3))
    canonical[1, 2], canonical[2, 2] = np.radians(25.0), -np.radians(25.0)
    posed = world_joints(m["t_joints"], axes)
    rest = world_joints(m["t_joints"], canonical)
    turn = np.eye(4)
    turn[:3, :3], turn[:3, 3] = np.array(frame["Rh"]), frame["Th"]
    skin = [turn @ a @ np.linalg.inv(b) for a, b in zip(posed, rest)]
    centres, covariances = [], []
    for n in range(GAUSSIANS):
        weights = m["weights_val"][n] / 255.0
        matrix = sum(w * skin[int(j)] for w, j in zip(weights, model["weights_idx"][n]))
        centres.append((matrix @ np.append(position[n], 1.0))[:3])
        axes_of = matrix[:3, :3] @ quaternion_matrix(rotations[n]) @ np.diag(np.exp(scales[n]))
        covariances.append((axes_of @ axes_of.T)[np.triu_indices(3)])
    return np.array(centres), np.array(covariances), 0.5 + HARMONIC * colors


def main():
    random = np.random.default_rng(20261125)
    model = make_model(random)
    poses = make_poses(random)
    np.savez_compressed("small.npz", **model)
    # The same numbers in other widths, in the other order of memory.
    wide = {}
    for name, array in model.items():
        array = np.asarray(array)
        if array.dtype == np.float16:
            array = array.astype(np.float32 if array.ndim < 3 else np.float64)
        elif array.dtype == np.uint16:
            array = array.astype(np.int64)
        wide[name] = np.asfortranarray(array) if array.ndim > 1 else array
    padded = wide["layers.0.weight"]
    input_of_80 = np.zeros(padded.shape[:2] + (80,))
    input_of_80[:, :, :63] = padded[:, :, :63]
    input_of_80[:, :, 64:74] = padded[:, :, 63:]
    wide["layers.0.weight"] = np.asfortranarray(input_of_80)
    np.savez_compressed("wide.npz", **wide)
    with open("small_poses.json", "w") as file:
        json.dump(poses, file)
    shown = []
    for frame in poses:
        centres, covariances, colors = evaluate(model, frame)
        shown.append({
            "part": np.asarray(model["gs_feat_knn"]).tolist(),
            "centre": np.round(centres, 7).tolist(),
            "covariance": [[float(f"{v:.6e}") for v in row] for row in covariances],
            "color": np.round(colors, 6).tolist(),
        })
    with open("small_shown.json", "w") as file:
        json.dump(shown, file)


main()
