//! Stage `sh`: view-dependent colours that replace the neutral ones, for avatars with spherical
//! harmonics.

use super::basis::{corrective, plus};
use super::mlp;
use super::project::{Gaussian, skinning};
use crate::avatar::{Avatar, ShCoefficients, harmonics::functions};
use crate::each;
use crate::scene::{Camera, Posed};
use glam::DVec3;

/// RGB of every Gaussian as the camera sees it, at least 0, before correctives; length N_g. None
/// for an avatar without spherical harmonics.
///
/// The direction leads from the camera to the Gaussian's `mean` in the posed world. The transpose of the blended joint matrix rotates it back to canonical space: that
/// is the inverse where one joint moves the Gaussian, and close to it elsewhere.
pub fn colors(
    avatar: &Avatar,
    posed: &Posed,
    camera: &Camera,
    mean: impl Fn(usize) -> DVec3 + Sync,
) -> Option<Vec<DVec3>> {
    let sh = avatar.sh.as_ref()?;
    let eye = camera.eye();
    let color = |k: usize| {
        let g = skinning(
            &posed.joints,
            avatar.gaussians.joint[k],
            avatar.gaussians.joint_weight[k],
        );
        let direction = mean(k) - eye;
        sum(
            sh,
            k,
            DVec3::from(avatar.gaussians.color[k].map(f64::from)),
            (g.matrix3.transpose() * direction).normalize_or_zero(),
        )
    };
    Some(each::map(avatar.gaussians.len(), color))
}

fn sum(sh: &ShCoefficients, gaussian: usize, neutral: DVec3, direction: DVec3) -> DVec3 {
    let count = sh.functions();
    let row = &sh.coefficients[gaussian * count..][..count];
    let added: DVec3 = row
        .iter()
        .zip(&functions(direction)[1..])
        .map(|(c, f)| *f * DVec3::from(c.map(f64::from)))
        .sum();
    (neutral + added).max(DVec3::ZERO)
}

/// Sets the Gaussians' colours to those that the camera sees, correctives included. `features` has
/// shape N_G, E. Does nothing for an avatar without spherical harmonics.
pub fn apply_colors(
    avatar: &Avatar,
    posed: &Posed,
    camera: &Camera,
    features: &[f64],
    gaussians: &mut [Gaussian],
) {
    let Some(colors) = colors(avatar, posed, camera, |k| gaussians[k].mean) else {
        return;
    };
    let colors = each::map(colors.len(), |k| {
        let e = mlp::of_gaussian(avatar, features, k);
        let sum = plus(colors[k].to_array(), corrective(&avatar.color_rows, k, e));
        DVec3::from(sum).clamp(DVec3::ZERO, DVec3::ONE)
    });
    for (gaussian, color) in gaussians.iter_mut().zip(colors) {
        gaussian.color = color;
    }
}
