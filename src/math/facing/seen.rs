//! The directions from which Gaussians show.

use super::views::FacingView;
use crate::splatter::{Blended, Projection, placed, shapes};
use effigy_core::avatar::Avatar;
use effigy_core::reference::project::skinning;
use glam::Vec3;
use rayon::prelude::*;

/// Views that are drawn side by side: more would take more memory.
const BATCH: usize = 4;

/// For each Gaussian the directions to the cameras, in the canonical pose, of the views in which it
/// is at least `shown` of a pixel. `progress` is called with the number of views done.
pub fn directions(
    avatar: &Avatar,
    views: &[FacingView],
    shown: f64,
    progress: &mut dyn FnMut(usize),
) -> Vec<Vec<Vec3>> {
    let shapes = shapes(avatar);
    let mut directions = vec![Vec::new(); avatar.gaussians.len()];
    for (batch, views) in views.chunks(BATCH).enumerate() {
        let seen = |FacingView { posed, camera }: &FacingView| {
            let projection = Projection::new(camera, avatar.filter);
            let placed = placed(avatar, posed, camera);
            let splats: Vec<_> = shapes
                .iter()
                .zip(&placed)
                .map(|(shape, placed)| projection.splat(shape, placed))
                .collect();
            let mut found = Vec::new();
            Blended::new(&splats, camera.size, |k, _, largest| {
                if f64::from(largest) >= shown {
                    found.push(k);
                }
            });
            let eye = camera.eye();
            let direction = |k: usize| {
                let gaussians = &avatar.gaussians;
                let g = skinning(&posed.joints, gaussians.joint[k], gaussians.joint_weight[k]);
                let back = g.matrix3.transpose() * (eye - placed[k].mean.as_dvec3());
                (k, back.normalize_or_zero().as_vec3())
            };
            found.into_iter().map(direction).collect::<Vec<_>>()
        };
        let seen: Vec<Vec<(usize, Vec3)>> = views.par_iter().map(seen).collect();
        for (k, direction) in seen.into_iter().flatten() {
            directions[k].push(direction);
        }
        progress(batch * BATCH + views.len());
    }
    directions
}
