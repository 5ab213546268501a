//! A dressed body and a pose in; what each Gaussian should look like out. Nothing here is a formula of the pose: the body's mesh is
//! skinned, flesh and cloth settle on it ([`cloth`]), light is ray traced against it ([`light`]), and the Gaussians' attributes are read
//! off the surface.
//!
//! * Position: the settled surface against the skinned one, taken back into the canonical pose (model.md, step 4).
//! * Rotation and scale: the surface's deformation gradient between the two, taken back likewise, split into a rotation and a stretch.
//! * Colour: what the material reflects of the light that arrives, by the posed surface's normal.

pub mod cloth;
pub mod light;
pub mod mesh;

use super::dataset::Frame;
use crate::avatar::{Gaussians, Pose, Skeleton};
use crate::bake::Dressed;
use crate::bake::math::encode_srgb;
use crate::bake::surface::Material;
use crate::reference::splats::skinning;
use cloth::Settling;
use glam::{DAffine3, DMat3, DQuat, DVec3};
use half::f16;
use light::{Around, Sky, irradiance};
use mesh::Mesh;
use rayon::prelude::*;

/// A stretch by more than this either way is a fold turned over, not a shape: natural logarithm.
const STRETCH: f64 = 1.0;

/// Where a Gaussian sits on the mesh, and what of its look no pose changes.
struct Anchor {
    vertex: [u32; 3],
    barycentric: [f64; 3],
    /// Of the surface with its relief, rest pose.
    normal: DVec3,
    /// Height above the mesh, metres.
    lift: f64,
    /// Linear.
    reflects: DVec3,
    material: Material,
}

/// A dressed body, ready to be posed.
pub struct Truth {
    skeleton: Skeleton,
    gaussians: Gaussians,
    to_canonical: Vec<DAffine3>,
    mesh: Mesh,
    settling: Settling,
    sky: Sky,
    anchors: Vec<Anchor>,
    /// Vertices that an anchor asks for their light.
    lit: Vec<u32>,
}

impl Truth {
    /// `rays` directions are asked at each vertex.
    pub fn new(dressed: &Dressed, rays: usize) -> Self {
        let mesh = Mesh::new(dressed);
        let anchors: Vec<Anchor> = dressed
            .dots
            .par_iter()
            .map(|dot| {
                let (vertices, triangles) = mesh.starts[dot.sheet];
                debug_assert_eq!(mesh.material[vertices], dot.site.material);
                let mut site = dot.site.clone();
                site.footprint = dot.radius;
                let lift = dressed.outfit.relief(&site, site.position);
                let normal = dressed.outfit.relief_normal(&site);
                site.position += lift * site.normal;
                Anchor {
                    vertex: mesh.triangles[triangles + dot.triangle],
                    barycentric: dot.barycentric,
                    normal,
                    lift,
                    reflects: dressed.outfit.reflects(&site, dot.radius),
                    material: site.material,
                }
            })
            .collect();
        let mut lit: Vec<u32> = anchors.iter().flat_map(|anchor| anchor.vertex).collect();
        lit.sort_unstable();
        lit.dedup();
        Self {
            skeleton: dressed.avatar.skeleton.clone(),
            gaussians: dressed.avatar.gaussians.clone(),
            to_canonical: dressed.body.to_canonical(),
            settling: Settling::new(&mesh),
            mesh,
            sky: Sky::new(rays),
            anchors,
            lit,
        }
    }

    /// The attributes of every Gaussian in a pose. How the hips stand and are turned changes nothing: light goes with them.
    pub fn frame(&self, pose: &Pose) -> Frame {
        let mut pose = Pose { translation: DVec3::ZERO, ..pose.clone() };
        pose.rotation[0] = DVec3::ZERO;
        let joints = self.skeleton.matrices(&pose);
        let from_rest: Vec<DAffine3> = joints.iter().zip(&self.to_canonical).map(|(posed, canonical)| *posed * *canonical).collect();
        let (skinned, turns) = self.mesh.skinned(&from_rest);
        let mut settled = self.settling.settle(&self.mesh, &skinned);
        let faces = |v: usize| (0..10).map(|e| self.mesh.expression[v][e] * pose.expression.get(e).copied().unwrap_or(0.0)).sum::<DVec3>();
        settled.par_iter_mut().enumerate().for_each(|(v, p)| *p += turns[v] * faces(v));
        let normals = [self.mesh.normals(&skinned), self.mesh.normals(&settled)];
        let posed = Posed {
            gradients: self.mesh.gradients(&skinned, &settled),
            light: self.sky.light(&self.mesh, &settled, &normals[1], &self.lit),
            joints,
            skinned,
            turns,
            settled,
            normals,
        };
        let rows: Vec<_> = (0..self.anchors.len()).into_par_iter().map(|k| self.gaussian(k, &posed)).collect();
        Frame {
            rotation: rows.iter().map(|row| row.0.map(f16::from_f64)).collect(),
            log_scale: rows.iter().map(|row| row.1.to_array().map(f16::from_f64)).collect(),
            color: rows.iter().map(|row| row.2.to_array().map(f16::from_f64)).collect(),
            offset: rows.iter().map(|row| row.3.to_array().map(f16::from_f64)).collect(),
        }
    }

    /// Rotation (w x y z), log scale, colour and offset.
    fn gaussian(&self, k: usize, posed: &Posed) -> ([f64; 4], DVec3, DVec3, DVec3) {
        let (anchor, neutral) = (&self.anchors[k], &self.gaussians);
        let mix = |of: &dyn Fn(usize) -> DVec3| (0..3).map(|c| of(anchor.vertex[c] as usize) * anchor.barycentric[c]).sum::<DVec3>();
        let g = skinning(&posed.joints, neutral.joint[k], neutral.joint_weight[k]).matrix3;
        let back = if g.determinant().abs() > 1e-3 { g.inverse() } else { DMat3::IDENTITY };
        let moved = mix(&|v| posed.settled[v] - posed.skinned[v]) + anchor.lift * mix(&|v| posed.normals[1][v] - posed.normals[0][v]);
        let gradient = [0, 1, 2].map(|c| mix(&|v| posed.gradients[v].col(c)));
        let gradient = DMat3::from_cols(gradient[0], gradient[1], gradient[2]);
        let (rotation, log_scale) = reshape(back * gradient * g, neutral.rotation[k], neutral.log_scale[k]);
        let turn = [0, 1, 2].map(|c| mix(&|v| posed.turns[v].col(c)));
        let whole = gradient * DMat3::from_cols(turn[0], turn[1], turn[2]);
        let color = self.color(anchor, whole, posed);
        (rotation, log_scale, color, back * moved)
    }

    /// `whole`: how the surface is turned and stretched from the rest pose.
    fn color(&self, anchor: &Anchor, whole: DMat3, posed: &Posed) -> DVec3 {
        let rest = anchor.material.facing().unwrap_or(anchor.normal);
        // Normals go by the cofactors.
        let normal =
            DMat3::from_cols(whole.y_axis.cross(whole.z_axis), whole.z_axis.cross(whole.x_axis), whole.x_axis.cross(whole.y_axis)) * rest;
        let normal = normal.normalize_or(rest);
        let light = |c: usize| irradiance(&posed.light[anchor.vertex[c] as usize], normal) * anchor.barycentric[c];
        encode_srgb(anchor.reflects * anchor.material.scattered((0..3).map(light).sum()))
    }
}

/// The mesh in one pose.
struct Posed {
    /// Canonical to posed, one a joint.
    joints: Vec<DAffine3>,
    skinned: Vec<DVec3>,
    /// Rest to posed, what skinning does around each vertex.
    turns: Vec<DMat3>,
    settled: Vec<DVec3>,
    /// Of the skinned and of the settled shape.
    normals: [Vec<DVec3>; 2],
    /// From the skinned to the settled shape.
    gradients: Vec<DMat3>,
    light: Vec<Around>,
}

/// A Gaussian's rotation and log scale after a deformation of canonical space: the deformation's rotation turns it, and each of its axes
/// is as long as the deformation makes it. The shear that this leaves out is not in the model.
fn reshape(deformation: DMat3, rotation: [f16; 4], log_scale: [f16; 3]) -> ([f64; 4], DVec3) {
    let q = rotation.map(f16::to_f64);
    let before = DQuat::from_xyzw(q[1], q[2], q[3], q[0]).normalize();
    let log_scale = DVec3::from(log_scale.map(f16::to_f64));
    let turn = polar(deformation);
    let Some(turn) = turn else { return ([before.w, before.x, before.y, before.z], log_scale) };
    let axes = deformation * DMat3::from_quat(before);
    let stretch = DVec3::from([axes.x_axis, axes.y_axis, axes.z_axis].map(|axis| axis.length().max(1e-6).ln().clamp(-STRETCH, STRETCH)));
    let mut after = (DQuat::from_mat3(&turn) * before).normalize();
    if after.dot(before) < 0.0 {
        after = -after;
    }
    ([after.w, after.x, after.y, after.z], log_scale + stretch)
}

/// The rotation nearest to a matrix, by Higham's iteration; None where the matrix turns space inside out or flat.
fn polar(m: DMat3) -> Option<DMat3> {
    if !m.is_finite() || m.determinant() < 0.02 {
        return None;
    }
    let mut u = m;
    for _ in 0..12 {
        u = (u + u.inverse().transpose()) * 0.5;
    }
    u.is_finite().then_some(u)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stretch_and_a_turn_are_told_apart() {
        let turn = DMat3::from_rotation_z(0.3);
        let q = [1.0, 0.0, 0.0, 0.0].map(f16::from_f64);
        let (rotation, log_scale) = reshape(turn * DMat3::from_diagonal(DVec3::new(1.2, 0.9, 1.0)), q, [f16::from_f64(-5.0); 3]);
        assert!((rotation[0] - 0.15f64.cos()).abs() < 1e-9 && (rotation[3] - 0.15f64.sin()).abs() < 1e-9, "{rotation:?}");
        let expected = DVec3::new(-5.0 + 1.2f64.ln(), -5.0 + 0.9f64.ln(), -5.0);
        assert!(log_scale.distance(expected) < 1e-9, "{log_scale}, expected {expected}");
        assert_eq!(polar(DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0))), None);
    }
}
