//! Splats of a posed avatar.
//!
//! y is up, lengths are metres, colours have no spherical harmonics. A skinned Gaussian's axes are
//! in general not at right angles; the splat has the principal axes of the ellipsoid.

use super::{Splats, Up};
use crate::{avatar::ShCoefficients, reference::Gaussian};
use glam::{DMat3, DQuat, DVec3};

/// Sweeps after which the axes are orthogonal to the last bit; three or four are enough.
const SWEEPS: usize = 16;

/// Makes all Gaussians balls of one size and opacity, to measure renderers with Gaussians of known
/// size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uniform {
    /// Standard deviation, metres.
    pub deviation: f64,
    /// 0 to 1.
    pub opacity: f64,
}

/// Gaussians of the posed world, in their order. `uniform` replaces their shapes and opacities.
pub fn posed(gaussians: &[Gaussian], uniform: Option<Uniform>) -> Splats {
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

/// Rotation and standard deviations, longest first, of the ellipsoid M Mᵀ. One-sided Jacobi:
/// rotating pairs of M's columns until they are orthogonal leaves the product unchanged and keeps a
/// needle's thin axes, which squaring M would lose.
pub fn principal_axes(m: DMat3) -> (DQuat, DVec3) {
    let mut axes = [m.x_axis, m.y_axis, m.z_axis];
    for _ in 0..SWEEPS {
        let mut rotated = false;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            let a = axes[p].length_squared();
            let b = axes[q].length_squared();
            let product = axes[p].dot(axes[q]);
            if product.abs() <= 1e-15 * (a * b).sqrt() {
                continue;
            }
            rotated = true;
            let half = (b - a) / (2.0 * product);
            let tangent = half.signum() / (half.abs() + (1.0 + half * half).sqrt());
            let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
            let rotated_p = cosine * (axes[p] - tangent * axes[q]);
            let rotated_q = cosine * (axes[q] + tangent * axes[p]);
            axes[p] = rotated_p;
            axes[q] = rotated_q;
        }
        if !rotated {
            break;
        }
    }
    axes.sort_by(|a, b| b.length_squared().total_cmp(&a.length_squared()));
    let first = axes[0].try_normalize().unwrap_or(DVec3::X);
    let second = axes[1]
        .reject_from_normalized(first)
        .try_normalize()
        .unwrap_or_else(|| first.any_orthonormal_vector());
    let rotation =
        DQuat::from_mat3(&DMat3::from_cols(first, second, first.cross(second))).normalize();
    (rotation, DVec3::from(axes.map(DVec3::length)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn covariance(rotation: DQuat, deviation: DVec3) -> DMat3 {
        let m = DMat3::from_quat(rotation) * DMat3::from_diagonal(deviation);
        m * m.transpose()
    }

    #[test]
    fn sheared_needles_and_sheets_keep_their_covariance() {
        let turn = DMat3::from_quat(DQuat::from_euler(glam::EulerRot::XYZ, 0.3, -1.1, 2.0));
        let shear = DMat3::from_cols(
            DVec3::new(0.9, 0.1, -0.2),
            DVec3::new(0.3, 1.1, 0.0),
            DVec3::new(-0.1, 0.2, 0.8),
        );
        for scale in [
            [1.0, 1.0, 1.0],
            [0.1, 1e-5, 1e-5],
            [0.1, 0.1, 1e-5],
            [1e-3, 2e-3, 3e-3],
            [0.1, 0.0, 0.0],
            [0.0; 3],
        ] {
            let m = shear * turn * DMat3::from_diagonal(DVec3::from(scale));
            let (rotation, deviation) = principal_axes(m);
            let got = covariance(rotation, deviation);
            let expected = m * m.transpose();
            let size = expected
                .to_cols_array()
                .into_iter()
                .map(f64::abs)
                .fold(1e-30, f64::max);
            let error = (got - expected)
                .to_cols_array()
                .into_iter()
                .map(f64::abs)
                .fold(0.0, f64::max);
            assert!(error <= 1e-13 * size, "{scale:?}: {error} of {size}");
        }
    }

    #[test]
    fn a_needles_thin_axes_come_back_to_ten_digits() {
        let turn = DMat3::from_quat(DQuat::from_rotation_y(0.7));
        let (_, deviation) =
            principal_axes(turn * DMat3::from_diagonal(DVec3::new(2e-9, 0.1, 1e-9)));
        assert!(
            (deviation / DVec3::new(0.1, 2e-9, 1e-9) - 1.0)
                .abs()
                .max_element()
                < 1e-10,
            "{deviation}"
        );
    }
}
