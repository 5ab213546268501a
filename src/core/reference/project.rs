//! Stage `project` (docs/model.md, steps 2 and 4 to 8): every Gaussian in the posed world, then as
//! an ellipse in the image, or the reason why it is culled.

use super::basis::{corrective, plus};
use super::mlp;
use super::nodes::displacement;
use crate::avatar::{Avatar, LowPass};
use crate::constants;
use crate::layout::compact::Neutral;
use crate::scene::{Camera, Posed, detail, radius_in_sigmas};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
use rayon::prelude::*;

/// A Gaussian in the posed world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gaussian {
    /// G x, metres.
    pub mean: DVec3,
    /// G₃ₓ₃ R(q) diag(s), metres: the columns are the axes, one standard deviation long as long as
    /// G doesn't shear.
    pub axes: DMat3,
    /// Display-referred RGB, 0 to 1.
    pub color: DVec3,
    /// 255 is opaque.
    pub opacity: u8,
}

impl Gaussian {
    /// World-space covariance, m².
    pub fn covariance(&self) -> DMat3 {
        self.axes * self.axes.transpose()
    }
}

/// A Gaussian projected into the image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Splat {
    /// px from the image's top left corner.
    pub center: DVec2,
    /// Distance along the camera's axis, metres.
    pub depth: f64,
    /// Σ' = [[a, b], [b, c]] as [a, b, c], px², the low-pass included.
    pub covariance: [f64; 3],
    /// a c − b², px⁴, computed without cancellation: accurate for needles too.
    pub determinant: f64,
    /// Half the sides of the box around the ellipse at which the Gaussian's alpha is 1/255, px.
    pub radius: DVec2,
    /// 0 to 1.
    pub opacity: f64,
    /// Display-referred RGB, 0 to 1.
    pub color: DVec3,
}

/// Why a Gaussian is culled. Reasons are checked in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Culled {
    /// Its centre is nearer than the camera's near plane, or behind the camera.
    Behind,
    /// It is nowhere as opaque as 1/255. Checked again after [`Culled::Guard`], with the filter's
    /// compensation.
    Faint,
    /// A number of it is NaN or infinite, or its variance is above [`constants::VARIANCE_MAX`].
    Invalid,
    /// Its centre is further from the image than [`Camera::guard`].
    Guard,
    /// The box around its ellipse misses the image.
    Outside,
}

/// The avatar in the posed world, before any camera; length N_g.
///
/// `features` has shape N_G, E, `nodes` length N_s.
pub fn gaussians(
    avatar: &Avatar,
    posed: &Posed,
    features: &[f64],
    nodes: &[DVec3],
) -> Vec<Gaussian> {
    gaussians_from(avatar, posed, features, nodes, |k| {
        Neutral::exact(avatar, k)
    })
}

/// The avatar in the posed world, with `stored` in place of what its Gaussians say themselves.
pub fn gaussians_from(
    avatar: &Avatar,
    posed: &Posed,
    features: &[f64],
    nodes: &[DVec3],
    stored: impl Fn(usize) -> Neutral + Sync,
) -> Vec<Gaussian> {
    let neutral = &avatar.gaussians;
    (0..neutral.len())
        .into_par_iter()
        .map(|k| {
            let e = mlp::of_gaussian(avatar, features, k);

            // δr, δs, δc = B · e (docs/model.md, step 2, the paper's first equation); x = x₀ + δx
            // (step 4).
            let own = stored(k);
            let x = avatar.position(k) + displacement(own.node_weights, neutral.node[k], nodes);
            // Step 5.
            let q = rotation(own.rotation, corrective(&avatar.rotation_rows, k, e));
            let log_scale = DVec3::from(plus(
                neutral.log_scale[k].map(f64::from),
                corrective(&avatar.scale_rows, k, e),
            ));
            let s = log_scale.min(DVec3::splat(constants::LOG_SCALE_MAX)).exp();
            let c =
                plus(own.color, corrective(&avatar.color_rows, k, e)).map(|c| c.clamp(0.0, 1.0));
            // Steps 6 and 7.
            let g = skinning(&posed.joints, neutral.joint[k], neutral.joint_weight[k]);
            Gaussian {
                mean: g.transform_point3(x),
                axes: g.matrix3 * DMat3::from_quat(q) * DMat3::from_diagonal(s),
                color: DVec3::from(c),
                opacity: neutral.opacity[k],
            }
        })
        .collect()
}

/// normalize(q₀ + δr), both as w x y z; q₀'s direction where the sum nearly vanishes.
pub fn rotation(neutral: [f64; 4], corrective: [f64; 4]) -> DQuat {
    let quaternion = |[w, x, y, z]: [f64; 4]| DQuat::from_xyzw(x, y, z, w);
    let q = quaternion(plus(neutral, corrective));
    let q0 = quaternion(neutral);
    if q.length() >= constants::ROTATION_MIN * q0.length() {
        q.normalize()
    } else {
        q0.normalize()
    }
}

/// G = Σ w_j G_j over a Gaussian's four joints: linear blend skinning, not orthogonalised.
pub fn skinning(joints: &[DAffine3], joint: [u8; 4], weight: [u8; 4]) -> DAffine3 {
    let mut g = DAffine3::from_mat3_translation(DMat3::ZERO, DVec3::ZERO);
    for (j, w) in joint.into_iter().zip(weight.map(|w| f64::from(w) / 255.0)) {
        g.matrix3 += w * joints[usize::from(j)].matrix3;
        g.translation += w * joints[usize::from(j)].translation;
    }
    g
}

/// Projects every Gaussian, each of which represents 2^`level` ([`detail`]); one entry a Gaussian,
/// in order.
pub fn splats(
    gaussians: &[Gaussian],
    camera: &Camera,
    low_pass: impl Into<LowPass>,
    level: u32,
) -> Vec<Result<Splat, Culled>> {
    let low_pass = low_pass.into();
    gaussians
        .par_iter()
        .map(|gaussian| project(gaussian, camera, low_pass, level))
        .collect()
}

/// EWA projection of one Gaussian, with the low-pass, and culling (docs/model.md, step 8). The
/// Gaussian represents 2^`level` ([`detail`]).
pub fn project(
    gaussian: &Gaussian,
    camera: &Camera,
    low_pass: impl Into<LowPass>,
    level: u32,
) -> Result<Splat, Culled> {
    let limits = camera.derivative_limits();
    project_within(gaussian, camera, limits, low_pass.into(), level)
}

/// [`project`] with the derivative's limits of another camera ([`Camera::derivative_limits`]): the
/// frame's, where `camera` sees a slot of an atlas.
pub fn project_within(
    gaussian: &Gaussian,
    camera: &Camera,
    limits: [DVec2; 2],
    low_pass: LowPass,
    level: u32,
) -> Result<Splat, Culled> {
    let t = camera.view.transform_point3(gaussian.mean);
    if t.z < camera.near {
        return Err(Culled::Behind);
    }
    let opacity = f64::from(detail::opacity(gaussian.opacity, level));
    // One that is invisible alone does not become visible by standing for others.
    radius_in_sigmas(f64::from(gaussian.opacity))
        .and(radius_in_sigmas(opacity))
        .ok_or(Culled::Faint)?;
    let center = camera.project(t);
    let axes = camera.view.matrix3 * gaussian.axes;
    let footprint = Footprint::new(axes, t, camera, limits, low_pass);
    let [a, b, c] = footprint.covariance;
    let valid_shape = footprint.determinant > 0.0 && a.max(c) <= constants::VARIANCE_MAX;
    if !(t.is_finite()
        && center.is_finite()
        && a.is_finite()
        && b.is_finite()
        && c.is_finite()
        && gaussian.color.is_finite()
        && valid_shape)
    {
        return Err(Culled::Invalid);
    }
    let size = DVec2::from(camera.size.map(f64::from));
    if (center + camera.guard()).min_element() < 0.0
        || (size + camera.guard() - center).min_element() < 0.0
    {
        return Err(Culled::Guard);
    }
    // What a level enlarges covariances by leaves the ratio of their determinants as it is.
    let opacity = opacity * low_pass.opacity_factor(footprint.unfiltered, footprint.determinant);
    let sigmas = radius_in_sigmas(opacity).ok_or(Culled::Faint)?;
    let spread = detail::covariance_scale(level);
    let covariance = footprint.covariance.map(|v| spread * v);
    let radius = sigmas * DVec2::new(covariance[0].sqrt(), covariance[2].sqrt());
    if (center + radius).min_element() < 0.0 || (size + radius - center).min_element() < 0.0 {
        return Err(Culled::Outside);
    }
    Ok(Splat {
        center,
        depth: t.z,
        covariance,
        determinant: spread * spread * footprint.determinant,
        radius,
        opacity: opacity / 255.0,
        color: gaussian.color,
    })
}

/// A covariance in the image.
struct Footprint {
    /// Σ' = (J M)(J M)ᵀ + low-pass as [a, b, c], px².
    covariance: [f64; 3],
    /// Its determinant, px⁴.
    determinant: f64,
    /// The determinant without the low-pass, px⁴.
    unfiltered: f64,
}

impl Footprint {
    /// `m` is the axes and `t` the mean, both in camera coordinates.
    ///
    /// J is the derivative of [`Camera::project`] at `t`, with x/z and y/z kept within
    /// `limits`.
    fn new(m: DMat3, t: DVec3, camera: &Camera, [min, max]: [DVec2; 2], low_pass: LowPass) -> Self {
        let low_pass = low_pass.variance;
        let slope = (t.truncate() / t.z).clamp(min, max);
        let f = camera.focal / t.z;
        let row_x = m.transpose() * DVec3::new(f.x, 0.0, -f.x * slope.x);
        let row_y = m.transpose() * DVec3::new(0.0, f.y, -f.y * slope.y);
        let covariance = [
            row_x.dot(row_x) + low_pass,
            row_x.dot(row_y),
            row_y.dot(row_y) + low_pass,
        ];
        // Lagrange's identity: without the low-pass the determinant is |row_x × row_y|².
        let unfiltered = row_x.cross(row_y).length_squared();
        Self {
            covariance,
            determinant: unfiltered + low_pass * (covariance[0] + covariance[2] - low_pass),
            unfiltered,
        }
    }
}
