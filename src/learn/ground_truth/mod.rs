//! The look of each Gaussian of a dressed body in a pose. Nothing here is a formula of the pose:
//! the body's mesh is skinned, flesh and cloth settle on it ([`cloth`]), light is ray traced
//! against it ([`light`]), together in [`settled`], and the Gaussians' attributes are read off the
//! surface.
//!
//! * Position: the settled surface against the skinned one, taken back into the canonical pose
//!   (model.md, step 4).
//! * Rotation and scale: the surface's deformation gradient between the two, taken back too, split
//!   into a rotation and a stretch.
//! * Colour: the light that arrives, by the posed surface's normal, as the material reflects it.

pub mod cloth;
pub mod light;
pub mod mesh;
pub mod settled;

use crate::bake::Dressed;
use crate::bake::surface::Material;
use crate::dataset::FrameAttributes;
use crate::math::color::encode_srgb;
use effigy_core::avatar::{Gaussians, Pose};
use effigy_core::reference::project::skinning;
use glam::{DMat3, DQuat, DVec3};
use half::f16;
use light::irradiance;
use mesh::Mesh;
use rayon::prelude::*;
use settled::{PosedMesh, SettledBody, turned_normal};

/// A larger stretch, either way, is a fold turned over, not a shape: natural logarithm.
const MAX_STRETCH: f64 = 1.0;

/// A Gaussian's place on the mesh, and the part of its look that no pose changes.
struct Anchor {
    vertex: [u32; 3],
    barycentric: [f64; 3],
    /// The rest pose's normal, of the surface with its relief.
    normal: DVec3,
    /// Height above the mesh, metres.
    lift: f64,
    /// Linear RGB.
    albedo: DVec3,
    material: Material,
}

/// A dressed body, ready to be posed.
pub struct GroundTruth {
    body: SettledBody,
    gaussians: Gaussians,
    /// One a Gaussian.
    anchors: Vec<Anchor>,
    /// The vertices whose light an anchor needs.
    lit: Vec<u32>,
}

/// One Gaussian's attributes.
struct GaussianAttributes {
    /// w x y z.
    rotation: [f64; 4],
    log_scale: DVec3,
    /// Display-referred.
    color: DVec3,
    /// Canonical space, metres.
    offset: DVec3,
}

impl GroundTruth {
    /// `rays`: rays traced per vertex for its light.
    pub fn new(dressed: &Dressed, rays: usize) -> Self {
        let mesh = Mesh::new(&dressed.sheets, &dressed.outfit);
        let anchors: Vec<Anchor> = dressed
            .dots
            .par_iter()
            .map(|dot| {
                let sheet = mesh.sheets[dot.sheet];
                debug_assert_eq!(mesh.material[sheet.first_vertex], dot.site.material);
                let mut site = dot.site.clone();
                site.footprint = dot.radius;
                let lift = dressed.outfit.relief(&site, site.position);
                let normal = dressed.outfit.relief_normal(&site);
                site.position += lift * site.normal;
                Anchor {
                    vertex: mesh.triangles[sheet.first_triangle + dot.triangle],
                    barycentric: dot.barycentric,
                    normal,
                    lift,
                    albedo: dressed.outfit.mean_albedo(&site, dot.radius),
                    material: site.material,
                }
            })
            .collect();
        let mut lit: Vec<u32> = anchors.iter().flat_map(|anchor| anchor.vertex).collect();
        lit.sort_unstable();
        lit.dedup();
        Self {
            body: SettledBody::new(&dressed.body, mesh, rays),
            gaussians: dressed.avatar.gaussians.clone(),
            anchors,
            lit,
        }
    }

    /// The attributes of every Gaussian in a pose. Position and rotation of the hips change
    /// nothing: the light goes with them.
    pub fn frame(&self, pose: &Pose) -> FrameAttributes {
        let posed = self.body.pose(pose, &self.lit);
        let all: Vec<GaussianAttributes> = (0..self.anchors.len())
            .into_par_iter()
            .map(|k| self.gaussian(k, &posed))
            .collect();
        let half = |v: DVec3| v.to_array().map(f16::from_f64);
        FrameAttributes {
            rotation: all.iter().map(|g| g.rotation.map(f16::from_f64)).collect(),
            log_scale: all.iter().map(|g| half(g.log_scale)).collect(),
            color: all.iter().map(|g| half(g.color)).collect(),
            offset: all.iter().map(|g| half(g.offset)).collect(),
        }
    }

    fn gaussian(&self, k: usize, posed: &PosedMesh) -> GaussianAttributes {
        let anchor = &self.anchors[k];
        let neutral = &self.gaussians;
        // A vector of the mesh's vertices at the anchor.
        let at_anchor = |of_vertex: &dyn Fn(usize) -> DVec3| {
            (0..3)
                .map(|c| of_vertex(anchor.vertex[c] as usize) * anchor.barycentric[c])
                .sum::<DVec3>()
        };
        let matrix_at_anchor = |matrices: &[DMat3]| {
            let column = |c: usize| at_anchor(&|v| matrices[v].col(c));
            DMat3::from_cols(column(0), column(1), column(2))
        };
        let to_posed = skinning(&posed.joints, neutral.joint[k], neutral.joint_weight[k]).matrix3;
        let to_canonical = if to_posed.determinant().abs() > 1e-3 {
            to_posed.inverse()
        } else {
            DMat3::IDENTITY
        };
        let moved = at_anchor(&|v| posed.settled[v] - posed.skinned.positions[v])
            + anchor.lift * at_anchor(&|v| posed.settled_normals[v] - posed.skinned_normals[v]);
        let gradient = matrix_at_anchor(&posed.gradients);
        let shape = deform(
            to_canonical * gradient * to_posed,
            neutral.rotation[k],
            neutral.log_scale[k],
        );
        let from_rest = gradient * matrix_at_anchor(&posed.skinned.turns);
        GaussianAttributes {
            rotation: shape.rotation,
            log_scale: shape.log_scale,
            color: self.color(anchor, from_rest, posed),
            offset: to_canonical * moved,
        }
    }

    /// Display-referred. `deformation`: how the surface is turned and stretched from the rest pose.
    fn color(&self, anchor: &Anchor, deformation: DMat3, posed: &PosedMesh) -> DVec3 {
        let rest = anchor.material.light_normal().unwrap_or(anchor.normal);
        let normal = turned_normal(deformation, rest);
        let light = |c: usize| {
            irradiance(&posed.light[anchor.vertex[c] as usize], normal) * anchor.barycentric[c]
        };
        let light: DVec3 = (0..3).map(light).sum();
        encode_srgb(anchor.albedo * anchor.material.scatter(light))
    }
}

/// Rotation and log scale of a Gaussian.
struct DeformedShape {
    /// w x y z.
    rotation: [f64; 4],
    log_scale: DVec3,
}

/// A Gaussian's shape after a deformation of canonical space: the deformation's rotation turns it,
/// and each of its axes is as long as the deformation makes it. The shear that this leaves out is
/// not in the model.
fn deform(deformation: DMat3, rotation: [f16; 4], log_scale: [f16; 3]) -> DeformedShape {
    let [w, x, y, z] = rotation.map(f16::to_f64);
    let before = DQuat::from_xyzw(x, y, z, w).normalize();
    let log_scale = DVec3::from(log_scale.map(f16::to_f64));
    let Some(turn) = nearest_rotation(deformation) else {
        return DeformedShape {
            rotation: [before.w, before.x, before.y, before.z],
            log_scale,
        };
    };
    let axes = deformation * DMat3::from_quat(before);
    let stretch = DVec3::from([axes.x_axis, axes.y_axis, axes.z_axis].map(|axis| {
        let log = axis.length().max(1e-6).ln();
        log.clamp(-MAX_STRETCH, MAX_STRETCH)
    }));
    let mut after = (DQuat::from_mat3(&turn) * before).normalize();
    if after.dot(before) < 0.0 {
        after = -after;
    }
    DeformedShape {
        rotation: [after.w, after.x, after.y, after.z],
        log_scale: log_scale + stretch,
    }
}

/// The rotation nearest to a matrix, by Higham's iteration. `None` if the matrix turns space inside
/// out or flat.
fn nearest_rotation(m: DMat3) -> Option<DMat3> {
    const ROUNDS: usize = 12;
    if !m.is_finite() || m.determinant() < 0.02 {
        return None;
    }
    let mut u = m;
    for _ in 0..ROUNDS {
        u = (u + u.inverse().transpose()) * 0.5;
    }
    u.is_finite().then_some(u)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deformation_splits_into_turn_and_stretch() {
        let turn = DMat3::from_rotation_z(0.3);
        let stretch = DMat3::from_diagonal(DVec3::new(1.2, 0.9, 1.0));
        let identity = [1.0, 0.0, 0.0, 0.0].map(f16::from_f64);
        let DeformedShape {
            rotation,
            log_scale,
        } = deform(turn * stretch, identity, [f16::from_f64(-5.0); 3]);
        assert!(
            (rotation[0] - 0.15f64.cos()).abs() < 1e-9
                && (rotation[3] - 0.15f64.sin()).abs() < 1e-9,
            "{rotation:?}"
        );
        let expected = DVec3::new(-5.0 + 1.2f64.ln(), -5.0 + 0.9f64.ln(), -5.0);
        assert!(
            log_scale.distance(expected) < 1e-9,
            "{log_scale}, expected {expected}"
        );
    }

    #[test]
    fn mirrored_space_has_no_nearest_rotation() {
        let mirror = DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0));
        assert_eq!(nearest_rotation(mirror), None);
    }
}
