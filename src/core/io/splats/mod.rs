//! Splats: the Gaussians of a static scene as plain columns. Every reader of a splat format gives
//! them, one conversion ([`Splats::to_avatar`]) makes an [`Avatar`](crate::avatar::Avatar) of them,
//! and every writer takes them.

mod avatar;
mod axes;
mod cells;
mod check;
mod columns;
mod far;
mod found;
mod harmonics;
mod join;
#[cfg(not(target_arch = "wasm32"))]
mod posed;
mod up;

pub use crate::avatar::harmonics::functions_of;
pub use axes::principal_axes;
pub use check::check_count;
pub use columns::{from_columns, to_columns};
pub use far::{far_middle, moved};
pub use found::Found;
#[cfg(not(target_arch = "wasm32"))]
pub use posed::{Uniform, from_gaussians};
pub use up::Up;

use crate::avatar::Filter;

/// N Gaussians of a static scene, in the file's own axes and order. What no reader has checked,
/// [`Self::check`] does.
#[derive(Clone, Debug, PartialEq)]
pub struct Splats {
    /// Means, metres; shape N, 3.
    pub position: Vec<[f32; 3]>,
    /// Quaternions w x y z of any length but 0; shape N, 4.
    pub rotation: Vec<[f32; 4]>,
    /// Natural logarithms of the standard deviations along the rotated axes, in metres; shape N, 3.
    /// −∞ is a deviation of 0.
    pub log_scale: Vec<[f32; 3]>,
    /// Logits of the opacities, ln(α / (1 − α)); length N. −∞ is transparent, +∞ opaque.
    pub opacity: Vec<f32>,
    /// Coefficients of the spherical harmonic of degree 0; shape N, 3. RGB is 0.5 +
    /// [`CONSTANT`](crate::avatar::ShCoefficients::CONSTANT) times them.
    pub color: Vec<[f32; 3]>,
    /// Highest degree of the spherical harmonics, 0 to 3.
    pub degree: usize,
    /// RGB of each spherical harmonic from degree 1 up, in 3DGS's order and with its signs; shape
    /// N, (degree + 1)² − 1, 3.
    pub harmonics: Vec<[f32; 3]>,
    /// The axis that points up.
    pub up: Up,
    /// The low-pass that they were trained with.
    pub filter: Filter,
}

impl Splats {
    /// Number of Gaussians.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// Whether there is no Gaussian.
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }
}
