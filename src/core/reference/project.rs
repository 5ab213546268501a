//! Stage `project` (docs/model.md, steps 2 and 4 to 8): every Gaussian in the posed world, then as
//! an ellipse in the image, or the reason why it is culled.

use super::basis::{corrective, plus};
use super::mlp;
use super::nodes::displacement;
use crate::avatar::{Avatar, Facing, LowPass};
use crate::constants;
use crate::each;
use crate::layout::compact::NeutralGaussian;
use crate::scene::{Camera, Posed, detail, radius_in_sigmas};
use glam::{DAffine3, DMat2, DMat3, DQuat, DVec2, DVec3};

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
    /// G₃ₓ₃ a and the limit: from where it is drawn.
    pub facing: Facing,
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
    /// It faces away from the camera.
    Away,
    /// It is nowhere as opaque as 1/255. Checked again after [`Culled::Invalid`], with the filter's
    /// compensation and what [`Facing`] leaves.
    Faint,
    /// A number of it is NaN or infinite, or its variance is above [`constants::VARIANCE_MAX`].
    Invalid,
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
        NeutralGaussian::exact(avatar, k)
    })
}

/// The avatar in the posed world, with `stored` in place of what its Gaussians say themselves.
pub fn gaussians_from(
    avatar: &Avatar,
    posed: &Posed,
    features: &[f64],
    nodes: &[DVec3],
    stored: impl Fn(usize) -> NeutralGaussian + Sync,
) -> Vec<Gaussian> {
    let neutral = &avatar.gaussians;
    each::map(neutral.len(), |k| {
        let e = mlp::of_gaussian(avatar, features, k);

        // δr, δs, δc = B · e (docs/model.md, step 2, the paper's first equation); x = x₀ + δx
        // (step 4).
        let own = stored(k);
        let canonical = Canonical {
            position: avatar.position(k) + displacement(own.node_weights, neutral.node[k], nodes),
            neutral_rotation: own.rotation,
            rotation_corrective: corrective(&avatar.rotation_rows, k, e),
            log_scale: DVec3::from(plus(
                neutral.log_scale[k].map(f64::from),
                corrective(&avatar.scale_rows, k, e),
            )),
            color: DVec3::from(plus(own.color, corrective(&avatar.color_rows, k, e))),
        };
        let g = skinning(&posed.joints, neutral.joint[k], neutral.joint_weight[k]);
        let facing = neutral.facing.get(k).copied().map(Facing::decode);
        let posed = pose(&canonical, &g, neutral.opacity[k]);
        Gaussian {
            facing: facing.map_or(posed.facing, |own| own.moved(&g.matrix3)),
            ..posed
        }
    })
}

/// A Gaussian in canonical space, correctives included (docs/model.md, steps 2 to 5).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Canonical {
    /// x, metres.
    pub position: DVec3,
    /// q₀ as w x y z, of any length but zero.
    pub neutral_rotation: [f64; 4],
    /// δr.
    pub rotation_corrective: [f64; 4],
    /// ls₀ + δs, natural logarithm of metres.
    pub log_scale: DVec3,
    /// c₀ + δc, display-referred RGB, not clamped yet.
    pub color: DVec3,
}

/// A Gaussian in the posed world (docs/model.md, steps 5 to 7), drawn from everywhere. `g`: its
/// skinning transform.
pub fn pose(canonical: &Canonical, g: &DAffine3, opacity: u8) -> Gaussian {
    let q = rotation(canonical.neutral_rotation, canonical.rotation_corrective);
    let s = canonical
        .log_scale
        .min(DVec3::splat(constants::LOG_SCALE_MAX))
        .exp();
    Gaussian {
        mean: g.transform_point3(canonical.position),
        axes: g.matrix3 * DMat3::from_quat(q) * DMat3::from_diagonal(s),
        // Written so that NaN stays NaN.
        color: DVec3::from(canonical.color.to_array().map(|c| c.clamp(0.0, 1.0))),
        opacity,
        facing: Facing::EVERYWHERE,
    }
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
    each::map(gaussians.len(), |k| {
        project(&gaussians[k], camera, low_pass, level)
    })
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
    let opacity = f64::from(detail::opacity(gaussian.opacity, level));
    // One that is invisible alone does not become visible by standing for others.
    let drawn = radius_in_sigmas(f64::from(gaussian.opacity)).map_or(0.0, |_| opacity);
    projected(gaussian, drawn, camera, limits, low_pass, level)
}

/// [`project`] at level 0 of a Gaussian whose opacity is `opacity`, 0 to 255, whatever it says
/// itself.
pub fn project_opaque(
    gaussian: &Gaussian,
    opacity: f64,
    camera: &Camera,
    low_pass: impl Into<LowPass>,
) -> Result<Splat, Culled> {
    let limits = camera.derivative_limits();
    projected(gaussian, opacity, camera, limits, low_pass.into(), 0)
}

fn projected(
    gaussian: &Gaussian,
    opacity: f64,
    camera: &Camera,
    limits: [DVec2; 2],
    low_pass: LowPass,
    level: u32,
) -> Result<Splat, Culled> {
    let t = camera.view.transform_point3(gaussian.mean);
    if t.z < camera.near {
        return Err(Culled::Behind);
    }
    let fade = gaussian.facing.moved(&camera.view.matrix3).fade(-t);
    if fade <= 0.0 {
        return Err(Culled::Away);
    }
    radius_in_sigmas(opacity).ok_or(Culled::Faint)?;
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
    // What a level enlarges covariances by leaves the ratio of their determinants as it is.
    let kept = low_pass.opacity_factor(footprint.unfiltered, footprint.determinant);
    let opacity = opacity * kept * fade;
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
    fn new(m: DMat3, t: DVec3, camera: &Camera, limits: [DVec2; 2], low_pass: LowPass) -> Self {
        let low_pass = low_pass.variance;
        let FootprintRows {
            x: row_x, y: row_y, ..
        } = FootprintRows::new(m, t, camera, limits);
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

/// The rows of J M, whose products are a covariance in the image.
///
/// J is the derivative of [`Camera::project`], with x/z and y/z kept within limits.
struct FootprintRows {
    /// Mᵀ times the first row of J, px.
    x: DVec3,
    /// Mᵀ times the second, px.
    y: DVec3,
    /// The first row of J, px/m.
    derivative_x: DVec3,
    /// The second.
    derivative_y: DVec3,
    /// x/z and y/z, within the limits.
    slope: DVec2,
}

impl FootprintRows {
    /// `m` is the axes and `t` the mean, both in camera coordinates.
    fn new(m: DMat3, t: DVec3, camera: &Camera, [min, max]: [DVec2; 2]) -> Self {
        let slope = (t.truncate() / t.z).clamp(min, max);
        let f = camera.focal / t.z;
        let derivative_x = DVec3::new(f.x, 0.0, -f.x * slope.x);
        let derivative_y = DVec3::new(0.0, f.y, -f.y * slope.y);
        Self {
            x: m.transpose() * derivative_x,
            y: m.transpose() * derivative_y,
            derivative_x,
            derivative_y,
            slope,
        }
    }
}

/// Derivative of a loss with respect to a [`Splat`]; per px, px² and so on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SplatGradient {
    /// Of the centre.
    pub center: DVec2,
    /// Of Σ'⁻¹ = [[a, b], [b, c]] as [a, b, c], where b counts once.
    pub inverse: [f64; 3],
    /// Of the opacity.
    pub opacity: f64,
    /// Of the colour.
    pub color: DVec3,
}

/// Derivative of a loss with respect to a [`Gaussian`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GaussianGradient {
    /// Of the mean, per metre.
    pub mean: DVec3,
    /// Of the axes, per metre.
    pub axes: DMat3,
    /// Of the colour.
    pub color: DVec3,
    /// Of the opacity from 0 to 255, before any compensation.
    pub opacity: f64,
}

impl GaussianGradient {
    /// That of a Gaussian that is not drawn.
    pub const ZERO: Self = Self {
        mean: DVec3::ZERO,
        axes: DMat3::ZERO,
        color: DVec3::ZERO,
        opacity: 0.0,
    };
}

/// The derivative of [`project_opaque`], for a Gaussian that it does not cull. How far it fades, as
/// it faces away, counts as constant.
pub fn project_backward(
    gaussian: &Gaussian,
    opacity: f64,
    camera: &Camera,
    low_pass: impl Into<LowPass>,
    splat: &Splat,
    gradient: &SplatGradient,
) -> GaussianGradient {
    let low_pass = low_pass.into();
    let t = camera.view.transform_point3(gaussian.mean);
    let m = camera.view.matrix3 * gaussian.axes;
    let fade = gaussian.facing.moved(&camera.view.matrix3).fade(-t);
    let of_opacity = gradient.opacity * fade;
    let rows = FootprintRows::new(m, t, camera, camera.derivative_limits());
    let [a, b, c] = splat.covariance;
    let det = splat.determinant;
    // Σ⁻¹ to Σ: ∂Σ = −Σ⁻¹ ∂(Σ⁻¹) Σ⁻¹, where ∂(Σ⁻¹) is symmetric.
    let inverse = DMat2::from_cols(DVec2::new(c, -b), DVec2::new(-b, a)) * (1.0 / det);
    let [of_a, of_b, of_c] = gradient.inverse;
    let symmetric = DMat2::from_cols(DVec2::new(of_a, 0.5 * of_b), DVec2::new(0.5 * of_b, of_c));
    let of_covariance = -(inverse * symmetric * inverse);
    let mut of_a = of_covariance.x_axis.x;
    let mut of_b = 2.0 * of_covariance.x_axis.y;
    let mut of_c = of_covariance.y_axis.y;
    let [x, y] = [rows.x, rows.y];
    let unfiltered = x.cross(y).length_squared();
    // Compensation: with ρ = √(u / det), ∂ρ = ρ/2 (∂u / u − ∂det / det).
    let factor = low_pass.opacity_factor(unfiltered, det);
    let compensated = low_pass.compensation * (unfiltered / det).sqrt();
    let mut of_x = DVec3::ZERO;
    let mut of_y = DVec3::ZERO;
    if compensated > 0.0 {
        let of_log = 0.5 * of_opacity * opacity / 255.0 * compensated;
        let scale = 2.0 * of_log / unfiltered;
        of_x += scale * (y.length_squared() * x - x.dot(y) * y);
        of_y += scale * (x.length_squared() * y - x.dot(y) * x);
        of_a -= of_log * c / det;
        of_c -= of_log * a / det;
        of_b += 2.0 * of_log * b / det;
    }
    of_x += 2.0 * of_a * x + of_b * y;
    of_y += 2.0 * of_c * y + of_b * x;
    // Rows of the covariance's root to the axes and the derivative of the perspective.
    let of_m = outer(rows.derivative_x, of_x) + outer(rows.derivative_y, of_y);
    let of_derivative_x = m * of_x;
    let of_derivative_y = m * of_y;
    let mut of_t = DVec3::ZERO;
    for (axis, of_derivative) in [of_derivative_x, of_derivative_y].into_iter().enumerate() {
        let f = camera.focal[axis] / t.z;
        let slope = rows.slope[axis];
        let of_f = of_derivative[axis] - slope * of_derivative.z;
        of_t.z -= of_f * f / t.z;
        if slope == t[axis] / t.z {
            let of_slope = -f * of_derivative.z;
            of_t[axis] += of_slope / t.z;
            of_t.z -= of_slope * slope / t.z;
        }
        of_t[axis] += f * gradient.center[axis];
        of_t.z -= f * t[axis] / t.z * gradient.center[axis];
    }
    let to_world = camera.view.matrix3.transpose();
    GaussianGradient {
        mean: to_world * of_t,
        axes: to_world * of_m,
        color: gradient.color,
        opacity: of_opacity * factor / 255.0,
    }
}

/// Derivative of a loss with respect to a [`Canonical`] Gaussian and its skinning transform.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CanonicalGradient {
    /// Of x, per metre.
    pub position: DVec3,
    /// Of q₀ + δr, w x y z.
    pub rotation: [f64; 4],
    /// Of ls₀ + δs.
    pub log_scale: DVec3,
    /// Of c₀ + δc.
    pub color: DVec3,
    /// Of G.
    pub skinning: DAffine3,
}

/// The derivative of [`pose`]. Zero where a number is clamped.
pub fn pose_backward(
    canonical: &Canonical,
    g: &DAffine3,
    gradient: &GaussianGradient,
) -> CanonicalGradient {
    let sum = plus(canonical.neutral_rotation, canonical.rotation_corrective);
    let q = rotation(canonical.neutral_rotation, canonical.rotation_corrective);
    let r = DMat3::from_quat(q);
    let s = canonical
        .log_scale
        .min(DVec3::splat(constants::LOG_SCALE_MAX))
        .exp();
    let local = r * DMat3::from_diagonal(s);
    let of_local = g.matrix3.transpose() * gradient.axes;
    let of_scale = |axis: usize| {
        if canonical.log_scale[axis] < constants::LOG_SCALE_MAX {
            local.col(axis).dot(of_local.col(axis))
        } else {
            0.0
        }
    };
    let of_r = of_local * DMat3::from_diagonal(s);
    let of_q = rotation_backward(q, &of_r);
    // Of a vector divided by its length: what is along it has no effect.
    let length = sum.iter().map(|v| v * v).sum::<f64>().sqrt();
    let neutral_length = canonical
        .neutral_rotation
        .iter()
        .map(|v| v * v)
        .sum::<f64>()
        .sqrt();
    let unit = [q.w, q.x, q.y, q.z];
    let along: f64 = of_q.iter().zip(unit).map(|(g, q)| g * q).sum();
    let of_sum = if length >= constants::ROTATION_MIN * neutral_length {
        std::array::from_fn(|k| (of_q[k] - along * unit[k]) / length)
    } else {
        [0.0; 4]
    };
    let inside = |axis: usize| (0.0..=1.0).contains(&canonical.color[axis]);
    let of_color = |axis: usize| {
        if inside(axis) {
            gradient.color[axis]
        } else {
            0.0
        }
    };
    CanonicalGradient {
        position: g.matrix3.transpose() * gradient.mean,
        rotation: of_sum,
        log_scale: DVec3::new(of_scale(0), of_scale(1), of_scale(2)),
        color: DVec3::new(of_color(0), of_color(1), of_color(2)),
        skinning: DAffine3::from_mat3_translation(
            gradient.axes * local.transpose() + outer(gradient.mean, canonical.position),
            gradient.mean,
        ),
    }
}

/// u vᵀ.
fn outer(u: DVec3, v: DVec3) -> DMat3 {
    DMat3::from_cols(u * v.x, u * v.y, u * v.z)
}

/// The derivative of the matrix of a unit quaternion, as w x y z; `r`: of the matrix.
fn rotation_backward(q: DQuat, r: &DMat3) -> [f64; 4] {
    let DQuat { x, y, z, w } = q;
    let at = |row: usize, column: usize| r.col(column)[row];
    let skew_x = at(2, 1) - at(1, 2);
    let skew_y = at(0, 2) - at(2, 0);
    let skew_z = at(1, 0) - at(0, 1);
    let xy = at(1, 0) + at(0, 1);
    let xz = at(2, 0) + at(0, 2);
    let yz = at(2, 1) + at(1, 2);
    [
        2.0 * (x * skew_x + y * skew_y + z * skew_z),
        2.0 * (w * skew_x - 2.0 * x * (at(1, 1) + at(2, 2)) + y * xy + z * xz),
        2.0 * (w * skew_y + x * xy - 2.0 * y * (at(0, 0) + at(2, 2)) + z * yz),
        2.0 * (w * skew_z + x * xz + y * yz - 2.0 * z * (at(0, 0) + at(1, 1))),
    ]
}
