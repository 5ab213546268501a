//! How far poses pull a surface apart: sheets, points and poses go in, the shape that each point's
//! Gaussian needs comes out.
//!
//! Skinning moves points by their own weights, but stretches a Gaussian by its own matrix only
//! (model.md, step 7): where weights change along the surface, points part further than their
//! Gaussians grow, and light shows through. A Gaussian that is large enough for every pose from the
//! start closes those gaps without a corrective, whatever the pose is.

use crate::bake::body::blend;
use crate::bake::source::rig::PointInfluence;
use crate::bake::spacing::Dot;
use crate::bake::surface::Sheet;
use effigy_core::avatar::{Pose, Skeleton};
use glam::{DAffine3, DMat2, DMat3, DVec2, DVec3};
use rayon::prelude::*;

/// Stretches are worked out for at most so many poses.
const POSES: usize = 160;
/// How far Gaussians may part before light shows through: a surface at rest has an optical depth
/// of 6.5 in the median, and 1 % of the light passes at 4.6.
const SLACK: f64 = 1.15;
/// A Gaussian is at most so many times as long as it is without stretch: beyond, a pose turns a
/// fold inside out.
const MAX_LENGTH: f64 = 3.0;

/// The poses, as they move the sheets.
pub struct Stretch<'a> {
    sheets: &'a [Sheet],
    poses: Vec<PosedSheets>,
}

/// The sheets in a pose.
struct PosedSheets {
    /// Canonical to posed, one a joint.
    joints: Vec<DAffine3>,
    /// Posed vertices of each sheet, metres.
    vertices: Vec<Vec<DVec3>>,
}

/// An ellipse on the surface: how many times as long as without stretch a Gaussian must be, and
/// along which directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StretchEllipse {
    /// A unit vector in the plane of two tangents.
    pub first: DVec2,
    /// Along `first`, and along the direction that is a quarter turn from it; at least 1.
    pub length: DVec2,
}

impl<'a> Stretch<'a> {
    /// Poses the sheets. `to_canonical`: rest to canonical pose, one matrix a joint.
    pub fn new(
        sheets: &'a [Sheet],
        skeleton: &Skeleton,
        to_canonical: &[DAffine3],
        poses: &[Pose],
    ) -> Self {
        let stride = poses.len().div_ceil(POSES).max(1);
        let chosen: Vec<&Pose> = poses.iter().step_by(stride).collect();
        let posed = |pose: &&Pose| {
            let joints = skeleton.matrices(pose);
            let from_rest: Vec<DAffine3> = joints
                .iter()
                .zip(to_canonical)
                .map(|(posed, canonical)| *posed * *canonical)
                .collect();
            let vertices = sheets
                .iter()
                .map(|sheet| posed_vertices(sheet, &from_rest))
                .collect();
            PosedSheets { joints, vertices }
        };
        Self {
            sheets,
            poses: chosen.par_iter().map(posed).collect(),
        }
    }

    /// The shape that the Gaussian of a dot needs. `tangents`: two unit vectors along the surface
    /// in the canonical pose; `influences`: the Gaussian's skin weights.
    pub fn ellipse(
        &self,
        dot: &Dot,
        tangents: [DVec3; 2],
        influences: &[PointInfluence],
    ) -> StretchEllipse {
        let sheet = &self.sheets[dot.sheet];
        let triangle = sheet.triangles[dot.triangle];
        let rest = edges(triangle.map(|v| sheet.vertices[v as usize].position));
        let mut covariance = DMat2::IDENTITY;
        let Some(orthonormal) = orthonormal_combinations(rest) else {
            return StretchEllipse::from_covariance(covariance);
        };
        for pose in &self.poses {
            let own = blend(&pose.joints, influences).matrix3;
            let moved = edges(triangle.map(|v| pose.vertices[dot.sheet][v as usize]));
            // Where a unit circle on the surface at rest comes to lie: the columns' ellipse.
            let circle = orthonormal.map(|c| moved[0] * c.x + moved[1] * c.y);
            let own = tangents.map(|tangent| own * tangent);
            if let Some(needed) = seen_from(own, circle) {
                covariance = joined(covariance, needed * needed.transpose());
            }
        }
        StretchEllipse::from_covariance(covariance)
    }
}

fn posed_vertices(sheet: &Sheet, from_rest: &[DAffine3]) -> Vec<DVec3> {
    sheet
        .vertices
        .iter()
        .map(|vertex| blend(from_rest, &vertex.weights).transform_point3(vertex.position))
        .collect()
}

/// Two edges of a triangle.
fn edges([a, b, c]: [DVec3; 3]) -> [DVec3; 2] {
    [b - a, c - a]
}

/// Two combinations of edges that are unit vectors at right angles. None for a sliver.
fn orthonormal_combinations([a, b]: [DVec3; 2]) -> Option<[DVec2; 2]> {
    let length = a.length();
    let first = a / length;
    let along = b.dot(first);
    let height = (b - along * first).length();
    if !(length > 1e-6 && height > 1e-6) {
        return None;
    }
    Some([
        DVec2::new(1.0 / length, 0.0),
        DVec2::new(-along / (length * height), 1.0 / height),
    ])
}

/// The matrix that takes two vectors nearest to two others, by columns: least squares. None where
/// the vectors lie along one line.
fn seen_from([a, b]: [DVec3; 2], [c, d]: [DVec3; 2]) -> Option<DMat2> {
    let form = DMat2::from_cols(
        DVec2::new(a.dot(a), a.dot(b)),
        DVec2::new(a.dot(b), b.dot(b)),
    );
    let products = DMat2::from_cols(
        DVec2::new(a.dot(c), b.dot(c)),
        DVec2::new(a.dot(d), b.dot(d)),
    );
    let is_flat = form.determinant() <= 1e-4 * form.x_axis.x * form.y_axis.y;
    (!is_flat).then(|| form.inverse() * products)
}

/// A small ellipse around two, all three as covariances: along the common axes of the two the
/// longer of each.
fn joined(a: DMat2, b: DMat2) -> DMat2 {
    let root = a.x_axis.x.sqrt();
    // a = L Lᵀ.
    let lower = DMat2::from_cols(
        DVec2::new(root, a.x_axis.y / root),
        DVec2::new(0.0, (a.determinant() / a.x_axis.x).max(0.0).sqrt()),
    );
    let inverse = lower.inverse();
    let relative = inverse * b * inverse.transpose();
    let axes = Eigen2::new(relative);
    let lengths = axes.values.max(DVec2::ONE);
    let turned = lower * axes.vectors;
    turned * DMat2::from_diagonal(lengths) * turned.transpose()
}

/// Eigenvalues of a symmetric 2 × 2 matrix, the larger first, and its unit eigenvectors as columns.
struct Eigen2 {
    values: DVec2,
    vectors: DMat2,
}

impl Eigen2 {
    fn new(matrix: DMat2) -> Self {
        let middle = 0.5 * (matrix.x_axis.x + matrix.y_axis.y);
        let half_difference = 0.5 * (matrix.x_axis.x - matrix.y_axis.y);
        let radius = half_difference.hypot(matrix.x_axis.y);
        let angle = 0.5 * matrix.x_axis.y.atan2(half_difference);
        Self {
            values: DVec2::new(middle + radius, middle - radius),
            vectors: DMat2::from_angle(angle),
        }
    }
}

impl StretchEllipse {
    /// From a covariance that is at least the unit circle's.
    fn from_covariance(covariance: DMat2) -> Self {
        let axes = Eigen2::new(covariance);
        Self {
            first: axes.vectors.x_axis,
            length: (DVec2::new(axes.values.x.sqrt(), axes.values.y.sqrt()) / SLACK)
                .clamp(DVec2::ONE, DVec2::splat(MAX_LENGTH)),
        }
    }

    /// Axes of a Gaussian along it: the two tangents turned, and the normal as it is.
    pub fn axes(&self, tangents: [DVec3; 2], normal: DVec3) -> DMat3 {
        let first = tangents[0] * self.first.x + tangents[1] * self.first.y;
        DMat3::from_cols(first, normal.cross(first), normal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: DMat2, b: DMat2) {
        assert!(a.abs_diff_eq(b, 1e-12), "{a} is not {b}");
    }

    #[test]
    fn a_joined_ellipse_contains_both() {
        let a = DMat2::from_cols(DVec2::new(2.0, 0.5), DVec2::new(0.5, 1.0));
        let b = DMat2::from_cols(DVec2::new(1.0, -0.7), DVec2::new(-0.7, 3.0));
        let both = joined(a, b);
        for k in 0..64 {
            let direction = DVec2::from_angle(0.1 * f64::from(k));
            let variance = |m: DMat2| direction.dot(m * direction);
            let larger = variance(a).max(variance(b));
            assert!(variance(both) >= larger - 1e-12, "{direction}");
        }
        near(joined(a, a * 0.5), a);
        near(joined(a, a * 3.0), a * 3.0);
    }

    #[test]
    fn eigenvectors_make_the_matrix_again() {
        let matrix = DMat2::from_cols(DVec2::new(2.0, -0.5), DVec2::new(-0.5, 7.0));
        let Eigen2 { values, vectors } = Eigen2::new(matrix);
        near(
            vectors * DMat2::from_diagonal(values) * vectors.transpose(),
            matrix,
        );
        assert!(values.x > values.y);
    }

    #[test]
    fn a_surface_that_stretches_with_its_gaussians_needs_nothing() {
        let tangents = [DVec3::X, DVec3::Y];
        let stretched = DMat3::from_cols(DVec3::X * 2.0, DVec3::new(0.3, 1.0, 0.0), DVec3::Z);
        let own = tangents.map(|tangent| stretched * tangent);
        near(
            seen_from(own, own).expect("two directions"),
            DMat2::IDENTITY,
        );
        // The surface twice as long along one tangent as its Gaussian.
        let longer = seen_from(tangents, [DVec3::X * 2.0, DVec3::Y]).expect("two directions");
        let ellipse =
            StretchEllipse::from_covariance(joined(DMat2::IDENTITY, longer * longer.transpose()));
        assert!(
            ellipse
                .length
                .abs_diff_eq(DVec2::new(2.0 / SLACK, 1.0), 1e-12)
        );
        assert!(ellipse.first.x.abs() > 1.0 - 1e-12);
    }

    #[test]
    fn combinations_of_edges_are_orthonormal() {
        let edges = [DVec3::new(0.02, 0.01, 0.0), DVec3::new(0.01, 0.03, 0.02)];
        let combinations = orthonormal_combinations(edges).expect("not a sliver");
        let [a, b] = combinations.map(|c| edges[0] * c.x + edges[1] * c.y);
        assert!((a.length() - 1.0).abs() < 1e-12 && (b.length() - 1.0).abs() < 1e-12);
        assert!(a.dot(b).abs() < 1e-12);
        assert!(orthonormal_combinations([edges[0], edges[0] * 2.0]).is_none());
    }
}
