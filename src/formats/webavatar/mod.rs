//! The model of the paper's own viewer: `NAME.npz`, as its exporter writes it, and the poses in
//! `NAME_poses.json` beside it. The viewer's code is not public in a stored form; names, shapes and
//! types are those that a port of it reads (docs/formats.md has the evidence).
//!
//! Shapes with N Gaussians, G parts, S nodes, J joints, B basis functions and P kept rows; halves
//! but where it says otherwise, and of any width when read:
//!
//! | array | shape | what it is |
//! |---|---|---|
//! | `_xyz` | N, 3 | position in the canonical pose, metres |
//! | `_rotation` | N, 4 | quaternion w x y z of any length |
//! | `_scaling` | N, 3 | natural logarithm of the standard deviations, metres |
//! | `_sh0` | N, 1, 3 | colour: see [`ColorCode`] |
//! | `opacity` | N | u8, of 255 |
//! | `weights_idx`, `weights_val` | N, 4 | u8, four joints and their weights of 255 |
//! | `t_joints` | J, 3 | joints in the rest pose, metres |
//! | `num_xyz_ft_head` | | u32, parts that see the expression: the first |
//! | `layers.K.weight`, `layers.K.bias` | out, G, in; out, G | a layer of the networks, K rising |
//! | `gs_feat_knn` | N | u16, the part of each Gaussian |
//! | `rot_idxs`, `scale_idxs`, `color_idxs` | P | u32, the Gaussians that keep a corrective |
//! | `rotation_basis`, `scaling_basis`, `color_basis` | P, 4 or 3, B | their basis rows |
//! | `ctrl_feat_knn` | S | u16, the part of each node |
//! | `ctrl_pt_offsets`, `ctrl_pt_basis` | S, 3; S, 3, B | displacement and basis rows, metres |
//! | `gs_ctrl_knn`, `gs_ctrl_knn_weights` | N, 3 | u16, three nodes and their weights |
//!
//! The file has no tree of joints, no canonical pose, no node positions and no training poses. Tree
//! and canonical pose are SMPL-X's and the exporter's; node positions are derived (`nodes`).

pub(crate) mod nodes;
mod poses;
mod read;
mod skeleton;
mod write;

pub use poses::{POSES_RATE, capture_poses, read_poses, write_poses};
pub use read::{ForeignAvatar, from_bytes};
pub use skeleton::is_own_skeleton;
pub use write::{LeftOut, to_bytes};

use effigy_core::avatar::{Activation, ShCoefficients};

/// The array that no model's file lacks: positions.
pub const POSITIONS: &str = "_xyz";

/// What `_sh0` and `color_basis` count in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ColorCode {
    /// Coefficients of the spherical harmonic of degree 0: RGB = 0.5 + 0.282 · `_sh0`, as 3DGS and
    /// the exporter's training code have it.
    #[default]
    Harmonic,
    /// RGB less 0.5, as the port of the viewer reads it.
    Offset,
}

impl ColorCode {
    /// RGB a unit of the file's numbers.
    pub(crate) fn unit(self) -> f64 {
        match self {
            Self::Harmonic => ShCoefficients::CONSTANT,
            Self::Offset => 1.0,
        }
    }
}

/// What the file leaves open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// The nonlinearity of the networks' hidden layers.
    pub activation: Activation,
    /// What colours count in.
    pub color: ColorCode,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            activation: Activation::LeakyRelu,
            color: ColorCode::default(),
        }
    }
}
