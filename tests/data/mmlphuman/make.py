"""Writes a small training checkpoint in the form of mmlphuman's, and what its model shows.

Independent of Effigy: entries, shapes and equations are those that src/formats/mmlphuman/mod.rs and
src/learn/distil/teacher.rs document, PyTorch writes the file, and what it shows is computed with
NumPy in float64. Run it in this folder:

    python3 make.py

NumPy 1.20 and PyTorch 2.0 or later. The files are committed; the random numbers are the same in
every run. `python3 make.py FILE GAUSSIANS ANCHORS NODES FRAMES` writes a checkpoint of that size and
of mmlphuman's widths instead, on a tube in place of a body, to see what importing one takes.
"""

import json
import sys
import types

import numpy as np
import torch

sys.path.append("..")
from smpl_x import PARENTS, quaternion_matrix, rotation  # noqa: E402

JOINTS = 55
HARMONIC, DEGREE_1, REACH = 0.28209479177387814, 0.4886025119029199, 0.008
SMALL = {"gaussians": 120, "anchors": 5, "nodes": 18, "frames": 80, "hidden": [24, 16, 10], "basis": 7, "node_basis": 5}


class MLP(torch.nn.Module):
    """The training code's class, by its module's name: pickled without weights."""

    def __init__(self, sizes):
        super().__init__()
        layers = []
        for at in range(len(sizes) - 1):
            layers.append(torch.nn.Linear(sizes[at], sizes[at + 1]))
            layers.append(torch.nn.ReLU())
        self.layers = torch.nn.Sequential(*layers[:-1])


def pretend_module():
    MLP.__module__ = "scene.mlp"
    sys.modules["scene"] = types.ModuleType("scene")
    sys.modules["scene.mlp"] = module = types.ModuleType("scene.mlp")
    module.MLP = MLP


def tensor(array):
    return torch.from_numpy(np.ascontiguousarray(array, dtype=np.float32))


def parameter(array):
    return torch.nn.Parameter(tensor(array))


def nearest(points, others, count):
    """Indices and distances of the nearest of others."""
    index = np.empty((len(points), count), dtype=np.int64)
    distance = np.empty((len(points), count))
    for start in range(0, len(points), 2000):
        block = points[start:start + 2000, None] - others[None]
        all_distances = np.sqrt((block**2).sum(axis=2))
        near = np.argpartition(all_distances, count - 1, axis=1)[:, :count]
        near = np.take_along_axis(near, np.argsort(np.take_along_axis(all_distances, near, 1), 1), 1)
        index[start:start + 2000] = near
        distance[start:start + 2000] = np.take_along_axis(all_distances, near, 1)
    return index, distance


def tube(random, count):
    """Points on an upright tube with a waist, 1.6 m tall."""
    height, angle = random.uniform(0.1, 1.7, count), random.uniform(0, 2 * np.pi, count)
    radius = 0.16 + 0.05 * np.cos(5 * height)
    return np.stack([radius * np.cos(angle), height, radius * np.sin(angle)], axis=1)


def make(random, size):
    """The checkpoint's dictionary."""
    count, anchors, nodes = size["gaussians"], size["anchors"], size["nodes"]
    basis, node_basis = size["basis"], size["node_basis"]
    position, centres, node = tube(random, count), tube(random, anchors), tube(random, nodes)
    joints = np.array([[0.012 * (j % 7) * (-1) ** j, 0.9 + 0.014 * j, 0.004 * (j % 5)] for j in range(JOINTS)])
    weights = np.zeros((count, JOINTS))
    near, distance = nearest(position, joints, 5)
    share = 1 / (0.03 + distance)**6
    np.put_along_axis(weights, near, share / share.sum(axis=1, keepdims=True), axis=1)
    wave = random.normal(size=(6, 3 * JOINTS)) * 0.12
    phase = np.linspace(0, 9, size["frames"])[:, None] * np.array([1.0, 1.7, 0.6, 2.3, 0.4, 3.1]) + np.arange(6)
    poses = (np.sin(phase) @ wave).astype(np.float32)
    gs, gs_distance = nearest(position, node, 3)
    gsft, gsft_distance = nearest(position, centres, 3)
    vtft, vtft_distance = nearest(node, centres, 3)
    share = lambda distance: 1 / distance / (1 / distance).sum(axis=1, keepdims=True)
    sizes = [63] + size["hidden"] + [basis + node_basis]
    params = {}
    for layer, (before, after) in enumerate(zip(sizes, sizes[1:])):
        # Anchors are alike, as neighbours on a body are.
        common = random.normal(size=(1, after, before))
        weight = (0.8 * common + 0.6 * random.normal(size=(anchors, after, before))) * np.sqrt(2.0 / before)
        params[f"layers.{2 * layer}.weight"] = parameter(weight)
        params[f"layers.{2 * layer}.bias"] = parameter(0.1 * random.normal(size=(anchors, after)))
    rows = lambda scale, *shape: parameter(scale * random.normal(size=shape))
    model = {
        "_xyz": tensor(position), "xyz_offset": rows(0.4, count, 3), "dxyz_vt": rows(0.002, nodes, 3),
        "_scaling": parameter(random.uniform(-4.6, -3.4, (count, 3))), "_rotation": rows(1.0, count, 4),
        "_opacity": rows(1.5, count), "_sh0": rows(0.6, count, 1, 3), "_shN": rows(0.05, count, 3, 3), "sh_degree": 1,
        "_weights": tensor(weights), "t_joints": tensor(joints),
        "all_poses": {str(3 * frame): torch.from_numpy(pose.copy()) for frame, pose in enumerate(poses)},
        "joint_parents": torch.tensor(PARENTS),
        "nbr_gs_invdist": tensor(1 / gs_distance), "nbr_gs": torch.from_numpy(gs),
        "nbr_vt": torch.from_numpy(nearest(node, node, 7)[0]),
        "nbr_gsft": torch.from_numpy(gsft), "nbr_vtft": torch.from_numpy(vtft),
        "nbr_gsft_wght": tensor(share(gsft_distance)), "nbr_vtft_wght": tensor(share(vtft_distance)),
        "xyz_vt": tensor(node), "xyz_ft": tensor(centres), "num_vt_basis": node_basis, "num_basis": basis,
        "encoder_feat_params": params, "encoder_feat_model_meta": MLP(sizes).to("meta"),
        "dxyz_bs": rows(0.02, nodes, node_basis, 3), "sh0_bs": rows(0.4, count, basis, 1, 3),
        "shN_bs": rows(0.01, count, basis, 3, 3), "scaling_bs": rows(0.15, count, basis, 3),
        "rotation_bs": rows(0.2, count, basis, 4), "opacity_bs": rows(0.3, count, basis),
        "is_dxyz_bs": True, "is_gsparam_bs": True, "iteration": 800000,
    }
    return model


def world_joints(joints, axes):
    matrices = []
    for j, parent in enumerate(PARENTS):
        local = np.eye(4)
        local[:3, :3] = rotation(axes[j])
        local[:3, 3] = joints[j] - (joints[parent] if parent >= 0 else 0.0)
        matrices.append(local if parent < 0 else matrices[parent] @ local)
    return np.array(matrices)


def show(model, pose, eye):
    """What every Gaussian is in a pose, seen from a point."""
    array = lambda name: model[name].detach().numpy().astype(np.float64)
    e, layer = np.tile(pose[3:66], (len(model["xyz_ft"]), 1)).astype(np.float64), 0
    params = {name: value.detach().numpy().astype(np.float64) for name, value in model["encoder_feat_params"].items()}
    while f"layers.{layer}.weight" in params:
        e = np.einsum("koi,ki->ko", params[f"layers.{layer}.weight"], e) + params[f"layers.{layer}.bias"]
        if f"layers.{layer + 2}.weight" in params:
            e = np.maximum(e, 0.0)
        layer += 2
    basis = model["num_basis"]
    blend = lambda part, near, weight: np.einsum("nrc,nr->nc", part[model[near].numpy()], array(weight))
    own = blend(e[:, :basis], "nbr_gsft", "nbr_gsft_wght")
    nodes = blend(e[:, basis:], "nbr_vtft", "nbr_vtft_wght")
    plus = lambda name, bases: array(name) + np.einsum("nb,nb...->n...", own, array(bases))
    moved = array("dxyz_vt") + np.einsum("nb,nbc->nc", nodes, array("dxyz_bs"))
    inverse = array("nbr_gs_invdist")
    moves = (inverse[:, :, None] * moved[model["nbr_gs"].numpy()]).sum(axis=1) / inverse.sum(axis=1)[:, None]
    position = array("_xyz") + moves + REACH * np.tanh(array("xyz_offset"))
    scale, quaternion = plus("_scaling", "scaling_bs"), plus("_rotation", "rotation_bs")
    opacity = 1 / (1 + np.exp(-plus("_opacity", "opacity_bs")))
    sh0, sh1 = plus("_sh0", "sh0_bs")[:, 0], plus("_shN", "shN_bs")
    big = np.zeros((JOINTS, 3))
    big[1, 2], big[2, 2] = np.deg2rad(25), np.deg2rad(-25)
    joints = array("t_joints")
    matrices = world_joints(joints, pose.reshape(-1, 3)) @ np.linalg.inv(world_joints(joints, big))
    g = np.einsum("nj,jik->nik", array("_weights"), matrices)
    centre = np.einsum("nik,nk->ni", g[:, :3, :3], position) + g[:, :3, 3]
    turn = np.array([quaternion_matrix(q) for q in quaternion])
    axes = g[:, :3, :3] @ turn * np.exp(scale)[:, None, :]
    covariance = axes @ axes.transpose(0, 2, 1)
    away = eye - centre
    away /= np.linalg.norm(away, axis=1, keepdims=True)
    d = np.einsum("nki,nk->ni", g[:, :3, :3], away)
    d /= np.linalg.norm(d, axis=1, keepdims=True)
    view = DEGREE_1 * (-d[:, 1:2] * sh1[:, 0] + d[:, 2:3] * sh1[:, 1] - d[:, 0:1] * sh1[:, 2])
    color = np.clip(0.5 + HARMONIC * sh0 + view, 0.0, 1.0)
    upper = covariance[:, [0, 0, 0, 1, 1, 2], [0, 1, 2, 1, 2, 2]]
    return {"position": position, "log_scale": scale, "rotation": quaternion, "opacity": opacity,
            "centre": centre, "covariance": upper, "color": color}


def main():
    pretend_module()
    random = np.random.default_rng(20261127)
    if len(sys.argv) == 6:
        count, anchors, nodes, frames = map(int, sys.argv[2:])
        size = {"gaussians": count, "anchors": anchors, "nodes": nodes, "frames": frames,
                "hidden": [512, 256, 256, 256], "basis": 15, "node_basis": 15}
        torch.save(make(random, size), sys.argv[1])
        return
    model = make(random, SMALL)
    torch.save(model, "chkpnt800000.pth")
    eye = np.array([0.7, 1.2, 2.4])
    # Every tenth Gaussian is enough to see.
    shown = []
    for frame in [3, 120, 237]:
        found = show(model, model["all_poses"][str(frame)].numpy().astype(np.float64), eye)
        found = {name: np.round(value[::10], 9).tolist() for name, value in found.items()}
        shown.append({"frame": frame // 3, **found})
    with open("shown.json", "w") as file:
        json.dump({"eye": eye.tolist(), "every": 10, "frames": shown}, file)


main()
