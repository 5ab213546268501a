//! Gaussians in a pose, ready to be drawn with any [`FittedShape`]: docs/model.md, steps 1 to 7, by the
//! f64 reference's own functions.

use super::splats::{FittedShape, PosedGaussian};
use effigy_core::avatar::Avatar;
use effigy_core::reference::{
    basis::corrective,
    mlp,
    nodes::{self, displacement},
    project, sh,
};
use effigy_core::scene::{Camera, Posed};
use glam::{DMat3, DVec3, Vec3};
use rayon::prelude::*;

/// Opacities are kept this far from 0 and 1, where the logit is infinite.
const OPACITY_MARGIN: f64 = 0.25 / 255.0;

/// The shapes of an avatar's Gaussians as they are.
pub fn shapes(avatar: &Avatar) -> Vec<FittedShape> {
    let gaussians = &avatar.gaussians;
    let shape = |k: usize| {
        let opacity = f64::from(gaussians.opacity[k]) / 255.0;
        let opacity = opacity.clamp(OPACITY_MARGIN, 1.0 - OPACITY_MARGIN);
        FittedShape {
            offset: Vec3::ZERO,
            turn: Vec3::ZERO,
            log_scale: Vec3::from(gaussians.log_scale[k].map(f32::from)),
            logit: (opacity / (1.0 - opacity)).ln() as f32,
            color: Vec3::from(gaussians.color[k].map(f32::from)),
        }
    };
    (0..gaussians.len()).map(shape).collect()
}

/// An avatar's Gaussians in a pose. `camera`: the view that colours are of, where they depend on
/// it.
pub fn placed(avatar: &Avatar, posed: &Posed, camera: &Camera) -> Vec<PosedGaussian> {
    let features = mlp::features(avatar, &posed.input);
    let nodes = nodes::nodes(avatar, &features);
    let gaussians = &avatar.gaussians;
    let skinning =
        |k: usize| project::skinning(&posed.joints, gaussians.joint[k], gaussians.joint_weight[k]);
    let mean = |k: usize| {
        let displacement = displacement(avatar.node_weights(k), gaussians.node[k], &nodes);
        skinning(k).transform_point3(avatar.position(k) + displacement)
    };
    let lit = sh::colors(avatar, posed, camera, mean);
    let place = |k: usize| {
        let e = mlp::of_gaussian(avatar, &features, k);
        let rotation = project::rotation(
            gaussians.rotation[k].map(f64::from),
            corrective(&avatar.rotation_rows, k, e),
        );
        let neutral = DVec3::from(gaussians.color[k].map(f64::from));
        let color = DVec3::from(corrective(&avatar.color_rows, k, e))
            + lit.as_ref().map_or(DVec3::ZERO, |lit| lit[k] - neutral);
        PosedGaussian {
            mean: mean(k).as_vec3(),
            axes: (skinning(k).matrix3 * DMat3::from_quat(rotation)).as_mat3(),
            log_scale: DVec3::from(corrective(&avatar.scale_rows, k, e)).as_vec3(),
            color: color.as_vec3(),
        }
    };
    (0..gaussians.len()).into_par_iter().map(place).collect()
}
