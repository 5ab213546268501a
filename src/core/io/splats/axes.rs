//! Principal axes of ellipsoids, and splats whose space is moved or stretched.

use super::Splats;
use crate::each;
use glam::{DAffine3, DMat3, DQuat, DVec3};

/// Sweeps after which the axes are orthogonal to the last bit; three or four are enough.
const SWEEPS: usize = 16;
/// How far, relative to the longest, the columns of a matrix may be from equal length and right
/// angles for it to count as a rotation and one scale.
const UNEVEN: f64 = 1e-5;

impl Splats {
    /// The scene under a map of space, whose `up` stays. Harmonics turn with the map's rotation.
    /// None for a map that mirrors or flattens.
    pub fn transformed(self, map: &DAffine3) -> Option<Self> {
        let matrix = map.matrix3;
        let lengths = DVec3::new(
            matrix.x_axis.length(),
            matrix.y_axis.length(),
            matrix.z_axis.length(),
        );
        let volume = lengths.element_product();
        let determinant = matrix.determinant();
        if !(map.is_finite() && volume > 0.0 && determinant > UNEVEN * volume) {
            return None;
        }
        let (_, rotation, _) = map.to_scale_rotation_translation();
        let scale = determinant.cbrt();
        let even = DMat3::from_quat(rotation) * scale;
        if matrix.abs_diff_eq(even, UNEVEN * lengths.max_element()) {
            return Some(self.turned(rotation, scale, map.translation));
        }
        let turned = self.clone().turned(rotation, 1.0, DVec3::ZERO);
        let axes = each::map(self.len(), |k| {
            let [w, x, y, z] = self.rotation[k].map(f64::from);
            let deviation = DVec3::from(self.log_scale[k].map(|s| f64::from(s).exp()));
            let own = DMat3::from_quat(DQuat::from_xyzw(x, y, z, w).normalize());
            let (q, deviation) = principal_axes(matrix * own * DMat3::from_diagonal(deviation));
            PrincipalAxes {
                rotation: [q.w, q.x, q.y, q.z].map(|v| v as f32),
                log_scale: deviation.to_array().map(|s| s.ln() as f32),
            }
        });
        let position = each::map(self.len(), |k| {
            let at = DVec3::from(self.position[k].map(f64::from));
            map.transform_point3(at).as_vec3().to_array()
        });
        Some(Self {
            position,
            rotation: axes.iter().map(|axes| axes.rotation).collect(),
            log_scale: axes.iter().map(|axes| axes.log_scale).collect(),
            ..turned
        })
    }
}

/// Directions and lengths of a Gaussian's axes.
struct PrincipalAxes {
    rotation: [f32; 4],
    log_scale: [f32; 3],
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

    #[test]
    fn a_stretched_scene_has_stretched_covariances() {
        let splats = Splats {
            position: vec![[1.0, 2.0, 3.0]],
            rotation: vec![[0.3, 0.5, -0.5, 0.9]],
            log_scale: vec![[-3.0, -4.0, -5.0]],
            opacity: vec![1.0],
            color: vec![[0.1, 0.2, 0.3]],
            degree: 0,
            harmonics: vec![],
            up: crate::io::splats::Up::Y,
            filter: crate::avatar::Filter::DEFAULT,
        };
        let of = |splats: &Splats| {
            let [w, x, y, z] = splats.rotation[0].map(f64::from);
            let deviation = splats.log_scale[0].map(|s| f64::from(s).exp());
            covariance(
                DQuat::from_xyzw(x, y, z, w).normalize(),
                DVec3::from(deviation),
            )
        };
        let turn = DQuat::from_euler(glam::EulerRot::XYZ, 0.3, -1.1, 2.0);
        for scale in [DVec3::splat(2.0), DVec3::new(1.0, 2.0, 0.5)] {
            let map = DAffine3::from_scale_rotation_translation(scale, turn, DVec3::X);
            let after = splats.clone().transformed(&map).unwrap();
            let expected = map.matrix3 * of(&splats) * map.matrix3.transpose();
            assert!(of(&after).abs_diff_eq(expected, 1e-7), "{scale}");
            let at = map.transform_point3(DVec3::new(1.0, 2.0, 3.0)).as_vec3();
            assert!(at.distance(after.position[0].into()) < 1e-5);
        }
        let mirror = DAffine3::from_scale(DVec3::new(-1.0, 1.0, 1.0));
        assert_eq!(splats.transformed(&mirror), None);
    }
}
