"""Writes small files as GVHMR and TRAM write them with PyTorch, and what they hold.

Run it in this folder after make.py, whose rotations it takes:

    python3 make_torch.py

PyTorch 1.6 or later. The files are committed.
"""

import json
import sys

sys.argv = ["make"]
import numpy as np
import torch

exec(open("make.py").read().rsplit("\nmain()", 1)[0].replace("import joblib\n", ""))


def main():
    random = np.random.default_rng(20261126)
    turns = lambda *shape: 0.4 * random.normal(size=shape + (3,))
    tensor = lambda array: torch.from_numpy(np.asarray(array, dtype=np.float32))
    expected = json.load(open("shown.json"))

    poses, trans = turns(FRAMES, 22), random.normal(size=(FRAMES, 3))
    # Views of one storage, one of them turned.
    both = tensor(np.concatenate([poses.reshape(FRAMES, 66), trans], axis=1))
    shape = tensor(random.normal(size=(1, 10))).expand(FRAMES, 10)
    params = {"body_pose": both[:, 3:66], "betas": shape, "global_orient": both[:, :3], "transl": both.T[66:].T}
    saved = {"smpl_params_global": params, "smpl_params_incam": {"body_pose": both[:, 3:66]},
             "K_fullimg": torch.eye(3).repeat(FRAMES, 1, 1), "net_outputs": {"x": torch.zeros(2).bfloat16()}}
    torch.save(saved, "hmr4d_results.pt")
    torch.save(saved, "hmr4d_results_legacy.pt", _use_new_zipfile_serialization=False)
    expected["hmr4d_results.pt"] = expected["hmr4d_results_legacy.pt"] = shown(BODY, poses, trans)

    matrices = np.array([[rotation(axis) for axis in row] for row in turns(FRAMES, 24)])
    trans = random.normal(size=(FRAMES, 1, 3))
    np.save("hps_track_0.npy", {"pred_rotmat": tensor(matrices), "pred_trans": tensor(trans),
                                "pred_shape": tensor(np.zeros((FRAMES, 10))), "frame": torch.arange(FRAMES) + 5})
    expected["hps_track_0.npy"] = shown(BODY, matrices[:, :22], trans[:, 0], True)

    with open("shown.json", "w") as file:
        json.dump(json.loads(json.dumps(expected), parse_float=lambda text: round(float(text), 6)), file)


main()
