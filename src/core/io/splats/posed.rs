//! Splats of a posed avatar.
//!
//! y is up, lengths are metres, colours have no spherical harmonics. A skinned Gaussian's axes are
//! in general not at right angles; the splat has the principal axes of the ellipsoid.

use super::{Splats, Up, axes::principal_axes};
use crate::{
    avatar::{Filter, ShCoefficients},
    reference::Gaussian,
};
use glam::{DQuat, DVec3};

/// Makes all Gaussians balls of one size and opacity, to measure renderers with Gaussians of known
/// size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uniform {
    /// Standard deviation, metres.
    pub deviation: f64,
    /// 0 to 1.
    pub opacity: f64,
}

/// Gaussians of the posed world, in their order, with the low-pass of 3DGS. `uniform` replaces their
/// shapes and opacities.
pub fn from_gaussians(gaussians: &[Gaussian], uniform: Option<Uniform>) -> Splats {
    let count = gaussians.len();
    let mut splats = Splats {
        position: Vec::with_capacity(count),
        rotation: Vec::with_capacity(count),
        log_scale: Vec::with_capacity(count),
        opacity: Vec::with_capacity(count),
        color: Vec::with_capacity(count),
        degree: 0,
        harmonics: vec![],
        up: Up::Y,
        filter: Filter::DEFAULT,
    };
    for gaussian in gaussians {
        let (rotation, deviation, opacity) = match uniform {
            Some(Uniform { deviation, opacity }) => {
                (DQuat::IDENTITY, DVec3::splat(deviation), opacity)
            }
            None => {
                let (rotation, deviation) = principal_axes(gaussian.axes);
                (rotation, deviation, f64::from(gaussian.opacity) / 255.0)
            }
        };
        splats.position.push(gaussian.mean.as_vec3().to_array());
        let DQuat { x, y, z, w } = rotation;
        splats.rotation.push([w, x, y, z].map(|v| v as f32));
        splats
            .log_scale
            .push(deviation.to_array().map(|s| s.ln() as f32));
        splats.opacity.push((opacity / (1.0 - opacity)).ln() as f32);
        let color = (gaussian.color - 0.5) / ShCoefficients::CONSTANT;
        splats.color.push(color.as_vec3().to_array());
    }
    splats
}
