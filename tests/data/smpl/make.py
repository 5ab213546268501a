"""Writes small files as AMASS, AvatarReX, AIST++, WHAM, ROMP, 4D-Humans, VIBE, HuMoR and SLAHMR write them, and what they
hold.

Independent of Effigy: names, shapes and types are those that src/formats/smpl/mod.rs lists, numbers are random, and the
rotations of joints in the world are computed with NumPy in float64. Run it in this folder:

    python3 make.py

NumPy 1.20 or later and joblib 1.2 or later. The files are committed; the random numbers are the same in every run. What
PyTorch writes is made by make_torch.py.
"""

import collections
import json
import pickle
import sys

import joblib
import numpy as np

sys.path.append("..")
from smpl_x import PARENTS, rotation  # noqa: E402

FRAMES = 4
BODY = list(range(22))
HANDS = list(range(25, 55))


def world(joints, matrices):
    """Rotations in the world of joints of SMPL-X, from those relative to their parents."""
    found = {}
    for joint, matrix in zip(joints, matrices):
        parent = PARENTS[joint]
        found[joint] = matrix if parent < 0 else found[parent] @ matrix
    return [found[joint].tolist() for joint in joints]


def shown(joints, axes, translation, matrices=False):
    """`axes`: shape T, J, 3, or T, J, 3, 3 of matrices."""
    frames = []
    for t, row in enumerate(axes):
        local = row if matrices else [rotation(axis) for axis in row]
        frames.append({"rotation": world(joints, local), "translation": [float(x) for x in translation[t]]})
    return frames


def main():
    random = np.random.default_rng(20261125)
    turns = lambda *shape: 0.4 * random.normal(size=shape + (3,))
    expected = {}

    # AMASS, first generation: f64, compressed, a string beside the arrays.
    poses, trans = turns(FRAMES, 52), random.normal(size=(FRAMES, 3))
    np.savez_compressed(
        "amass_h.npz", poses=poses.reshape(FRAMES, 156), trans=trans, betas=random.normal(size=16),
        dmpls=random.normal(size=(FRAMES, 8)), gender=np.array("female"), mocap_framerate=np.array(120.0))
    expected["amass_h.npz"] = shown(BODY + HANDS, poses, trans)

    # Second generation: SMPL-X.
    poses, trans = turns(FRAMES, 55), random.normal(size=(FRAMES, 3))
    np.savez(
        "amass_x.npz", poses=poses.reshape(FRAMES, 165), trans=trans, betas=random.normal(size=16),
        gender=np.array("neutral"), surface_model_type=np.array("smplx"), mocap_frame_rate=np.array(60.0),
        mocap_time_length=np.array(FRAMES / 60), root_orient=poses[:, 0], pose_body=poses[:, 1:22].reshape(FRAMES, 63),
        markers_obs=np.array([1, "x"], dtype=object))
    expected["amass_x.npz"] = shown(list(range(55)), poses, trans)

    # AvatarReX.
    poses, trans = turns(FRAMES, 55), random.normal(size=(FRAMES, 3))
    poses[:, 23:25] = 0.0
    f32 = lambda array: np.asarray(array, dtype=np.float32)
    flat = lambda array: f32(array.reshape(FRAMES, -1))
    np.savez(
        "smpl_params.npz", betas=f32(random.normal(size=(1, 10))), global_orient=f32(poses[:, 0]), transl=f32(trans),
        body_pose=np.asfortranarray(flat(poses[:, 1:22])), jaw_pose=f32(poses[:, 22]),
        expression=f32(np.arange(40).reshape(4, 10) / 8), left_hand_pose=flat(poses[:, 25:40]),
        right_hand_pose=flat(poses[:, 40:]))
    joints = BODY + [22] + HANDS
    expected["smpl_params.npz"] = shown(joints, poses[:, joints], trans)

    # AIST++: a plain pickle, scaled.
    poses, trans = turns(FRAMES, 24), random.normal(size=(FRAMES, 3))
    for protocol in (2, 5):
        with open(f"aist_{protocol}.pkl", "wb") as file:
            pickle.dump({"smpl_poses": poses.reshape(FRAMES, 72), "smpl_scaling": np.array([90.0]),
                         "smpl_trans": 90.0 * trans, "smpl_loss": 0.5}, file, protocol=protocol)
        expected[f"aist_{protocol}.pkl"] = shown(BODY, poses[:, :22], trans)

    # WHAM: two people; the longer one lacks a frame.
    people = collections.defaultdict(dict)
    for person, ids in ((0, [3, 4]), (7, [0, 1, 2, 4])):
        count = len(ids)
        poses, trans = f32(turns(count, 24)), f32(random.normal(size=(count, 3)))
        people[person] = {
            "pose": f32(turns(count, 24)).reshape(count, 72), "trans": f32(random.normal(size=(count, 3))),
            "pose_world": poses.reshape(count, 72), "trans_world": trans, "betas": f32(random.normal(size=(count, 10))),
            "verts": f32(random.normal(size=(count, 40, 3))), "frame_ids": np.array(ids)}
    joblib.dump(people, "wham_output.pkl")
    expected["wham_output.pkl"] = shown(BODY, poses[:, :22], trans)

    # ROMP: a video with people who are followed, and a picture.
    poses, trans = f32(turns(FRAMES, 24)), f32(random.normal(size=(FRAMES, 3)))
    frame = lambda t: {"smpl_thetas": poses[t:t + 1].reshape(1, 72), "cam_trans": trans[t:t + 1],
                       "smpl_betas": f32(np.zeros((1, 10)))}
    results = {f"{t:08}.jpg": frame(t) for t in range(FRAMES)}
    followed = {5: {"frame_id": list(range(FRAMES)), "smpl_thetas": [poses[t].reshape(72) for t in range(FRAMES)],
                    "cam_trans": [trans[t] for t in range(FRAMES)]}}
    np.savez("romp_video.npz", results=results, sequence_results=followed)
    np.savez("romp_frames.npz", results=results, sequence_results={})
    np.savez("romp_picture.npz", results=frame(1))
    expected["romp_video.npz"] = expected["romp_frames.npz"] = shown(BODY, poses[:, :22], trans)
    expected["romp_picture.npz"] = shown(BODY, poses[1:2, :22], trans[1:2])

    # 4D-Humans: a dictionary of frames; two people.
    frames, seen = {}, []
    for t in range(FRAMES):
        of = [np.array([rotation(a) for a in turns(24)], dtype=np.float32) for _ in range(2)]
        smpl = [{"global_orient": m[:1], "body_pose": m[1:], "betas": f32(np.zeros(10))} for m in of]
        identities = [4, 2] if t < 2 else [2]
        seen.append(of[identities.index(2)])
        frames[f"outputs/{t:06}.jpg"] = {
            "time": t, "shot": 0, "tid": identities, "bbox": [np.zeros(4)] * len(identities),
            "smpl": smpl[:len(identities)], "camera": [f32([0, 0, 40])] * len(identities), "conf": [np.float32(0.9)],
            "size": [[720, 1280]], "mask": [{"size": [720, 1280], "counts": b"abc"}], "3d_joints": [None]}
    joblib.dump(frames, "demo_gymnasts.pkl")
    expected["demo_gymnasts.pkl"] = shown(BODY, np.array(seen)[:, :22].astype(float), np.zeros((FRAMES, 3)), True)

    # VIBE: people without a place. HuMoR: one person. SLAHMR: two people in each array.
    poses = f32(turns(FRAMES, 24))
    joblib.dump({3: {"pred_cam": f32(np.ones((FRAMES, 3))), "orig_cam": f32(np.ones((FRAMES, 4))), "verts": None,
                     "pose": poses.reshape(FRAMES, 72), "betas": f32(np.zeros((FRAMES, 10))),
                     "frame_ids": np.arange(7, 7 + FRAMES)}}, "vibe_output.pkl")
    expected["vibe_output.pkl"] = shown(BODY, poses[:, :22], np.zeros((FRAMES, 3)))
    poses, trans = f32(turns(2, FRAMES, 22)), f32(random.normal(size=(2, FRAMES, 3)))
    root, body = poses[:, :, 0], poses[:, :, 1:].reshape(2, FRAMES, 63)
    np.savez("stage3_results.npz", betas=f32(np.zeros(16)), trans=trans[1], root_orient=root[1], pose_body=body[1])
    np.savez("world_results.npz", betas=f32(np.zeros((2, 16))), trans=trans, root_orient=root, pose_body=body)
    expected["stage3_results.npz"] = shown(BODY, poses[1], trans[1])
    expected["world_results.npz"] = shown(BODY, poses[0], trans[0])

    with open("shown.json", "w") as file:
        rounded = json.loads(json.dumps(expected), parse_float=lambda text: round(float(text), 6))
        json.dump(rounded, file)


main()
