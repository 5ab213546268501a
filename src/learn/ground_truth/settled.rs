//! The body's mesh in a pose: skinned, settled and lit.

use crate::bake::BakedBody;
use crate::ground_truth::cloth::Settling;
use crate::ground_truth::light::{RadianceSh, TracedSky};
use crate::ground_truth::mesh::{SheetMesh, Skinned};
use effigy_core::avatar::{Pose, Skeleton};
use glam::{DAffine3, DMat3, DVec3};
use rayon::prelude::*;

/// A dressed body's mesh, ready to be posed.
pub struct SettledBody {
    skeleton: Skeleton,
    to_canonical: Vec<DAffine3>,
    /// In the rest pose.
    pub mesh: SheetMesh,
    settling: Settling,
    sky: TracedSky,
}

/// The mesh in one pose, before the hips turn or move it. Lists are indexed by vertex unless they
/// say otherwise.
pub struct PosedMesh {
    /// By linear blend skinning.
    pub skinned: Skinned,
    /// With flesh and cloth settled, and the face's expression, metres.
    pub settled: Vec<DVec3>,
    /// The deformation from the skinned to the settled shape, one a vertex.
    pub gradients: Vec<DMat3>,
    /// What arrives; dark where it was not computed.
    pub light: Vec<RadianceSh>,
}

impl SettledBody {
    /// `rays`: rays traced per vertex for its light.
    pub fn new(body: &BakedBody, mesh: SheetMesh, rays: usize) -> Self {
        Self {
            skeleton: body.skeleton.clone(),
            to_canonical: body.to_canonical(),
            settling: Settling::new(&mesh),
            mesh,
            sky: TracedSky::new(rays),
        }
    }

    /// The mesh in a pose, with the light at the vertices in `lit`. Position and rotation of the hips
    /// change nothing: the light goes with them.
    pub fn pose(&self, pose: &Pose, lit: &[u32]) -> PosedMesh {
        let mut pose = Pose {
            translation: DVec3::ZERO,
            ..pose.clone()
        };
        pose.rotation[0] = DVec3::ZERO;
        let joints = self.skeleton.matrices(&pose);
        let from_rest: Vec<DAffine3> = joints
            .iter()
            .zip(&self.to_canonical)
            .map(|(posed, canonical)| *posed * *canonical)
            .collect();
        let skinned = self.mesh.skinned(&from_rest);
        let mut settled = self.settling.settle(&self.mesh, &skinned.positions);
        let expression_offset = |v: usize| {
            let strength = |e: usize| pose.expression.get(e).copied().unwrap_or(0.0);
            (0..10)
                .map(|e| self.mesh.expression[v][e] * strength(e))
                .sum::<DVec3>()
        };
        settled
            .par_iter_mut()
            .enumerate()
            .for_each(|(v, p)| *p += skinned.turns[v] * expression_offset(v));
        let settled_normals = self.mesh.normals(&settled);
        PosedMesh {
            gradients: self.mesh.gradients(&skinned.positions, &settled),
            light: self.sky.light(&self.mesh, &settled, &settled_normals, lit),
            skinned,
            settled,
        }
    }
}

/// A unit normal after a deformation of the surface.
pub fn turned_normal(deformation: DMat3, normal: DVec3) -> DVec3 {
    // Normals transform by the cofactor matrix.
    let DMat3 {
        x_axis,
        y_axis,
        z_axis,
    } = deformation;
    let cofactors = DMat3::from_cols(
        y_axis.cross(z_axis),
        z_axis.cross(x_axis),
        x_axis.cross(y_axis),
    );
    (cofactors * normal).normalize_or(normal)
}
