//! The training checkpoint of mmlphuman, the method that the paper's model grew from:
//! `chkpntN.pth`, a dictionary that `torch.save` wrote. Names, shapes and the forward model are
//! those of its public training code.
//!
//! It is a larger model than an [`Avatar`](effigy_core::avatar::Avatar): each of some 300 *anchors*
//! on the body has a network five layers deep, and a Gaussian blends the features of its three
//! nearest. `effigy_learn::distil` fits an avatar to it.
//!
//! Shapes with N Gaussians, K anchors, S nodes, J joints, B and C basis functions of Gaussians and
//! of nodes; floats and integers of any width. Positions are those of the canonical pose:
//!
//! | entry | shape | what it is |
//! |---|---|---|
//! | `_xyz`, `xyz_offset` | N, 3 | `_xyz` + reach · tanh(`xyz_offset`) is the position, metres |
//! | `_rotation` | N, 4 | quaternion w x y z of any length |
//! | `_scaling` | N, 3 | natural logarithm of the standard deviations, metres |
//! | `_opacity` | N | before the sigmoid |
//! | `_sh0`, `_shN` | N, 1, 3; N, 3, 3 | spherical harmonics of degree 0 and 1 |
//! | `sh_degree` | | 1 where `_shN` counts |
//! | `_weights` | N, J | weights of the joints |
//! | `t_joints`, `joint_parents` | J, 3; J | joints in the rest pose, metres; their parents |
//! | `all_poses` | | of each training frame the axis-angle rotations, 3 J |
//! | `nbr_gsft`, `nbr_gsft_wght` | N, 3 | anchors of each Gaussian, and their weights |
//! | `nbr_vtft`, `nbr_vtft_wght` | S, 3 | anchors of each node, and their weights |
//! | `nbr_gs`, `nbr_gs_invdist` | N, 3 | nodes of each Gaussian, and 1 / distance |
//! | `xyz_vt`, `dxyz_vt` | S, 3 | nodes, and their static displacement, metres |
//! | `encoder_feat_params` | | `layers.L.weight` K, out, in; `layers.L.bias` K, out; L = 0, 2, … |
//! | `rotation_bs`, `scaling_bs`, `opacity_bs` | N, B, 4; N, B, 3; N, B | bases of the attributes |
//! | `sh0_bs`, `shN_bs` | N, B, 1, 3; N, B, 3, 3 | bases of the harmonics |
//! | `dxyz_bs` | S, C, 3 | bases of the nodes' displacements, metres |
//! | `is_gsparam_bs`, `is_dxyz_bs` | | whether the bases of Gaussians and of nodes count |
//!
//! `joint_parents` and `xyz_vt` may be missing: then the tree is SMPL-X's, and nodes are where the
//! weights say. The centres of the anchors and the neighbours of nodes (`nbr_vt`, `xyz_ft`), which
//! training alone needs, are not read.

mod blend;
mod fields;
mod networks;
mod read;

pub use blend::{Blend, Share};
pub use networks::{LayerWeights, NetworkSource};
pub use read::{AttributeBases, Checkpoint, CheckpointGaussians, CheckpointNodes};

use crate::{pickle, webavatar::ColorCode};
use effigy_core::avatar::Activation;

/// Bytes of a checkpoint's pickle within which its first entries are named.
const FIRST_ENTRIES: usize = 1 << 16;
/// Entries among the first that no other file has.
const SIGNS: [&[u8]; 2] = [b"xyz_offset", b"dxyz_vt"];

/// Whether bytes are a checkpoint: a file of PyTorch's whose first entries are a checkpoint's.
pub fn is_checkpoint(bytes: &[u8]) -> bool {
    let Some(pickle) = pickle::pickle_of(bytes) else {
        return false;
    };
    let start = &pickle[..pickle.len().min(FIRST_ENTRIES)];
    let names = |sign: &[u8]| start.windows(sign.len()).any(|word| word == sign);
    SIGNS.into_iter().all(names)
}

/// What the file leaves open: constants of the training code.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// The nonlinearity of the networks' hidden layers.
    pub activation: Activation,
    /// What `_sh0` counts in. Harmonics of degree 1 are taken in its unit.
    pub color: ColorCode,
    /// How far a Gaussian may be from where it was placed, metres.
    pub reach: f64,
    /// How far outwards both hips turn in the canonical pose, degrees.
    pub hips: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            activation: Activation::Relu,
            color: ColorCode::Harmonic,
            reach: 0.008,
            hips: 25.0,
        }
    }
}
