"""Writes a tiny capture in THuman4's layout, and where its joints and vertices are.

Independent of Effigy: the body model has the arrays and the equations of SMPL-X (joints by a regressor from the shaped
vertices, `transl` added after the root has turned about its joint), computed with NumPy in float64; OpenCV projects the
joints through lenses that distort, and Pillow writes the pictures: a soft dot of red, green and blue at a joint each.
Run it in this folder:

    python3 make.py

NumPy 1.20, Pillow 9 and OpenCV 4 or later. The files are committed; the random numbers are the same in every run.
"""

import json
import pathlib

import cv2
import numpy as np
from PIL import Image

SIZE = (96, 80)
FRAMES = 3
VERTICES = 60
JOINTS = 55
# What red, green and blue show: head, left and right wrist.
SHOWN = [15, 20, 21]
PARENT = [0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19, 15, 15, 15, 20, 25, 26, 20, 28, 29,
          20, 31, 32, 20, 34, 35, 20, 37, 38, 21, 40, 41, 21, 43, 44, 21, 46, 47, 21, 49, 50, 21, 52, 53]


def turn(axis):
    return cv2.Rodrigues(np.asarray(axis, dtype=float))[0]


def main():
    random = np.random.default_rng(20261126)
    template = random.uniform([-0.7, -1.2, -0.2], [0.7, 0.5, 0.2], size=(VERTICES, 3))
    # Ten directions of shape, then ten of expression, as the smaller model file has them.
    directions = np.round(0.01 * random.normal(size=(VERTICES, 3, 20)), 4)
    regressor = np.zeros((JOINTS, VERTICES))
    weights = np.zeros((VERTICES, JOINTS))
    for joint in range(JOINTS):
        regressor[joint, random.choice(VERTICES, 2, replace=False)] = [0.75, 0.25]
    for vertex in range(VERTICES):
        weights[vertex, random.choice(JOINTS, 3, replace=False)] = [0.5, 0.375, 0.125]
    faces = np.stack([np.arange(VERTICES), np.roll(np.arange(VERTICES), 1), np.roll(np.arange(VERTICES), 2)], 1)
    tree = np.array([PARENT, range(JOINTS)], dtype=np.int64)
    tree[0, 0] = 4294967295
    np.savez_compressed("template.npz", v_template=template, f=faces.astype(np.uint32), weights=weights,
                        kintree_table=tree, J_regressor=regressor, shapedirs=directions, gender=np.array("neutral"),
                        joint2num=np.array({"Pelvis": 0}, dtype=object))

    poses = {name: 0.3 * random.normal(size=(FRAMES, width)).astype(np.float32) for name, width in
             [("global_orient", 3), ("body_pose", 63), ("jaw_pose", 3), ("leye_pose", 3), ("reye_pose", 3),
              ("left_hand_pose", 45), ("right_hand_pose", 45), ("expression", 10), ("transl", 3)]}
    betas = random.normal(size=(1, 10)).astype(np.float32)
    np.savez("smpl_params.npz", betas=betas, **poses)

    shaped = template + directions[:, :, :10] @ betas[0].astype(float)
    rest = regressor @ shaped
    frames = []
    for frame in range(FRAMES):
        whole = np.concatenate([poses[name][frame].astype(float) for name in
                                ["global_orient", "body_pose", "jaw_pose", "leye_pose", "reye_pose", "left_hand_pose",
                                 "right_hand_pose"]]).reshape(JOINTS, 3)
        matrices = []
        for joint in range(JOINTS):
            own = np.eye(4)
            own[:3, :3] = turn(whole[joint])
            own[:3, 3] = rest[joint] - (0 if joint == 0 else rest[PARENT[joint]])
            matrices.append(own if joint == 0 else matrices[PARENT[joint]] @ own)
        matrices = np.array(matrices)
        joints = matrices[:, :3, 3]
        moved = matrices.copy()
        moved[:, :3, 3] -= np.einsum("jab,jb->ja", matrices[:, :3, :3], rest)
        blended = np.einsum("vj,jab->vab", weights, moved)
        posed = np.einsum("vab,vb->va", blended[:, :3, :3], shaped) + blended[:, :3, 3]
        transl = poses["transl"][frame].astype(float)
        frames.append({"joints": joints + transl, "vertices": posed + transl})

    calibration = {}
    for index, distortion in enumerate([[0.0] * 5, [-0.25, 0.08, 0.004, -0.003, 0.01]]):
        rotation = turn([0.1, 0.0, 0.2 + index]) @ np.diag([1.0, -1.0, -1.0])
        translation = np.array([0.1, -0.2, 3.2])
        matrix = np.array([[88.0 + index, 0, 46.5], [0, 88.0 + index, 41.0], [0, 0, 1]])
        name = f"cam{index:02}"
        calibration[name] = {"K": matrix.ravel().tolist(), "R": rotation.ravel().tolist(), "T": translation.tolist(),
                             "distCoeff": distortion, "imgSize": list(SIZE)}
        for kind in ["images", "masks"]:
            pathlib.Path(kind, name).mkdir(parents=True, exist_ok=True)
        for number, frame in enumerate(frames):
            places, _ = cv2.projectPoints(frame["joints"], cv2.Rodrigues(rotation)[0], translation, matrix,
                                          np.array(distortion))
            x, y = np.meshgrid(range(SIZE[0]), range(SIZE[1]))
            away = [np.hypot(x - px, y - py) for px, py in places[:, 0]]
            picture = np.stack([255 * np.exp(-0.5 * (r / 2.2) ** 2) for r in np.array(away)[SHOWN]], -1)
            Image.fromarray(np.rint(picture).astype(np.uint8)).save(f"images/{name}/{number:08}.png")
            mask = 255 * (np.min(away, 0) < 5).astype(np.uint8)
            Image.fromarray(mask).save(f"masks/{name}/{number:08}.jpg", quality=95)
    with open("calibration.json", "w") as file:
        json.dump(calibration, file)
    shown = [{name: np.round(points, 6).tolist() for name, points in frame.items()} for frame in frames]
    with open("shown.json", "w") as file:
        json.dump(shown, file)


main()
