//! Each Gaussian as a splat of the reference, and how far a device's may be from it: the errors of
//! its mean, axes, opacity and colour, and from them an interval of α at any place of the image.
//!
//! For a deviation d the exponent is P = ½ dᵀΣ⁻¹d. An error of the centre changes it by vᵀe with
//! v = Σ⁻¹d. One of the axes m, with Σ = m mᵀ + low-pass, by vᵀδm y with y = mᵀv: P is both the
//! smallest of ½|y|² + |d − m y|² / (2 low-pass) over y and the largest of dᵀv − ½ vᵀΣv over v, so
//! that y and v of the reference bound the device's P from above and below. This stays small for
//! needles, where entries of Σ⁻¹ are large.

use super::{
    features::{Uncertain, UncertainSum, corrective, errors, length, values},
    rounding::{F16, F16_NORMAL, F32, Rounding},
};
use effigy_core::{
    avatar::{Avatar, LowPass, Rows},
    constants::{ALPHA_MAX, F16_MAX, FACING_FADE, LOG_SCALE_MAX, ROTATION_MIN, VARIANCE_MAX},
    frame::{Skip, pose_cache::PoseCache},
    layout::{CenterGrids, compact::NeutralGaussian},
    reference::{Gaussian, Splat, project},
    scene::{AvatarBounds, Camera, PartSet, Posed},
};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
use rayon::prelude::*;

/// Codes of a coordinate in the pose cache, and the share of them beyond each end of the range
/// (`project/pose_cache.glsl`).
const CACHE_CODES: f64 = 16_777_215.0;
const CACHE_TAIL: f64 = 1.0 / 64.0;
/// Steps of its size that the axes of a Gaussian in the pose cache have.
const CACHE_STEPS: f64 = 1023.0;
/// The size has 8 steps an octave in 8 bits, from 2⁻¹⁹ units on.
const CACHE_OCTAVE: f64 = 8.0;
const CACHE_FIRST: f64 = -19.0;
const CACHE_LAST: f64 = 255.0;
/// Roundings that a position goes through: of the joints' matrices, the weights, four joints' sum
/// and a product of four.
const POSITION_ROUNDINGS: f64 = 12.0;
/// Those of an axis on its way into the image: the same, the rotation's matrix, and the products
/// with the derivative of the perspective and with each other.
const AXIS_ROUNDINGS: f64 = 28.0;
/// Those of the covariance, its roots and its axes.
const SHAPE_ROUNDINGS: f64 = 8.0;
/// By how much f32 may move the number that is rounded to a splat's fixed-point centre, steps:
/// numbers of 20 bits have 4 left.
const FIXED_SLACK: f64 = 0.125;
/// Error of a key, 0 to 1, beyond its step: f32 resolves no more.
const KEY_ROUNDING: f64 = 8.0 * F32;
/// Roundings of an opacity's compensation: of a determinant, a quotient, a root and a product.
const COMPENSATION_ROUNDINGS: f64 = 16.0;
/// Largest angle by which the pose cache, which has 12 bits a coordinate of an octahedral map, turns
/// the axis of a cone, radians.
const CACHED_AXIS: f64 = 1e-3;
/// Roundings of the cosine between that axis and the direction to the camera.
const FACING_ROUNDINGS: f64 = 32.0;
/// By how much f32 may move an opacity that is rounded to 255ths, beyond its relative error.
const OPACITY_SLACK: f64 = 1e-4;
/// How much larger an exponent than the cutoff's is looked at: splats whose interval is wider are
/// looked for in the whole image.
const EXPONENT_MARGIN: f64 = 0.5;

/// What the splats of a frame follow from.
pub struct SplatInput<'a> {
    /// The avatar as the file has it.
    pub avatar: &'a Avatar,
    /// The avatar as the device stores it.
    pub stored: &'a Avatar,
    pub posed: &'a Posed,
    pub camera: &'a Camera,
    /// [`Camera::derivative_limits`] of the frame's camera.
    pub limits: [DVec2; 2],
    pub features: &'a Uncertain,
    pub nodes: &'a [[UncertainSum; 3]],
    /// The stored avatar in the posed world.
    pub gaussians: &'a [Gaussian],
    pub bounds: &'a AvatarBounds,
    /// Depths between which keys are linear, metres.
    pub depth_range: [f64; 2],
    /// Parts that are culled as wholes.
    pub culled_parts: PartSet,
    /// The whole avatar is culled.
    pub culled: bool,
    /// Skinned Gaussians come from the pose cache.
    pub cache: Option<PoseCache>,
    /// The low-pass that is drawn with.
    pub low_pass: LowPass,
    pub rounding: &'a Rounding,
}

/// An interval of α, and the reference's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alpha {
    pub exact: f64,
    pub low: f64,
    pub high: f64,
}

/// A splat with the errors that a device may make.
#[derive(Clone, Debug)]
pub struct UncertainSplat {
    /// Index of its Gaussian.
    pub gaussian: usize,
    /// A device may leave it out.
    pub may_vanish: bool,
    /// Pixels that culling by parts may cut off: it moves further than that allows for.
    pub strays: bool,
    /// Distance along the camera's axis, metres.
    pub depth: f64,
    /// Lowest and highest key, 0 to 1.
    pub key: [f64; 2],
    /// Middle of where a device may have its centre, px: on or between two points of its grid.
    pub center: DVec2,
    /// How far from there along each axis, px.
    pub shift: DVec2,
    pub color: DVec3,
    /// Largest error of a channel.
    pub color_error: f64,
    /// Half the sides of a box outside which no device draws it, px.
    pub reach: DVec2,
    /// The reference's own; None if the reference culls it.
    exact: Option<Splat>,
    opacity: f64,
    opacity_error: f64,
    /// Direction of the longer axis.
    direction: DVec2,
    longer: f64,
    shorter: f64,
    /// Errors of the direction by f16, radians, and by f32.
    turn: f64,
    turn_f32: f64,
    /// Columns of m, px, their errors, and the relative error of each as a whole.
    columns: [DVec2; 3],
    column_error: [DVec2; 3],
    scale_error: [f64; 3],
    /// Error of the deviation in px of distance from the pixel, along each axis of the image.
    evaluated_from: f64,
    /// Error of the deviation between shaders, standard deviations.
    varying: f64,
    /// The terms of [`Self::alpha`], computed once.
    shape: AlphaTerms,
    /// Exponent above which α is surely under the cutoff.
    far_exponent: f64,
    alpha_error: f64,
    cutoff: f64,
    /// Variance of the low-pass, px².
    low_pass: f64,
    /// Its place and shape are not bounded.
    anywhere: bool,
}

/// Terms of a splat's α that are the same at each pixel.
#[derive(Clone, Copy, Debug, Default)]
struct AlphaTerms {
    /// Shortest and longest of each axis, px.
    longer: [f64; 2],
    shorter: [f64; 2],
    /// The factor that an error of the axis' direction puts on a product of deviations.
    turned: f64,
    /// Half of its square, by how much the axes differ, and their product.
    turned_square: f64,
    apart: f64,
    area: f64,
    /// What the whole shift does by itself.
    shift: f64,
}

/// A Gaussian in the camera's space, with errors.
struct Posed3 {
    mean: DVec3,
    mean_error: DVec3,
    /// Columns are axes.
    axes: DMat3,
    axes_error: DMat3,
    scale_error: [f64; 3],
    color_error: f64,
    /// How far nodes move it, and its longest axis, metres in canonical space.
    displaced: f64,
    axis: f64,
}

/// Each entry as its absolute value.
fn magnitudes(m: DMat3) -> DMat3 {
    DMat3::from_cols(m.x_axis.abs(), m.y_axis.abs(), m.z_axis.abs())
}

fn row_lengths(m: DMat3) -> DVec3 {
    DVec3::new(m.row(0).length(), m.row(1).length(), m.row(2).length())
}

/// The splats that may be drawn.
pub fn splats(input: &SplatInput) -> Vec<UncertainSplat> {
    (0..input.gaussians.len())
        .into_par_iter()
        .filter_map(|gaussian| input.splat(gaussian))
        .collect()
}

impl SplatInput<'_> {
    /// A Gaussian in the space of a camera.
    fn posed(&self, k: usize, view: DAffine3) -> Posed3 {
        let stored = self.stored;
        let neutral = &stored.gaussians;
        let own = NeutralGaussian::stored(self.avatar, k);
        let [displaced, moved_error] = self.displacement(k, &own);
        let x0 = stored.position(k);
        let x = x0 + displaced;
        let corner = DVec3::from(neutral.bounds.min.map(f64::from));
        let x_error = 4.0 * F32 * (corner.abs() + (x0 - corner).abs()) + moved_error;
        let (linear_size, moved_size) = self.skinning_size(k, view);
        let mean_error = if self.rounding.exact_positions {
            DVec3::ZERO
        } else {
            linear_size * x_error + POSITION_ROUNDINGS * F32 * (linear_size * x.abs() + moved_size)
        };

        let (rotation, angle) = self.rotation(k, &own);
        let (log_scale, scale_error) = self.log_scale(k);
        let scale = log_scale.map(f64::exp);
        let axes = view.matrix3 * self.gaussians[k].axes;
        let rows = row_lengths(linear_size);
        let size = linear_size * magnitudes(rotation);
        let column_error =
            |axis: usize| scale[axis] * (AXIS_ROUNDINGS * F32 * size.col(axis) + angle * rows);
        let axes_error = DMat3::from_cols(column_error(0), column_error(1), column_error(2));
        let corrected = log_scale.into_iter().fold(f64::NEG_INFINITY, f64::max);
        Posed3 {
            mean: view.transform_point3(self.gaussians[k].mean),
            mean_error,
            axes,
            axes_error,
            scale_error,
            color_error: self.color_error(k, &own),
            displaced: displaced.length(),
            axis: corrected.exp(),
        }
    }

    /// How far nodes move a Gaussian, and the error of that, metres in canonical space.
    fn displacement(&self, k: usize, own: &NeutralGaussian) -> [DVec3; 2] {
        let mut displaced = DVec3::ZERO;
        let mut error = DVec3::ZERO;
        let nodes = self.stored.gaussians.node[k];
        for (weight, node) in own.node_weights.iter().zip(nodes) {
            let node = self.nodes[usize::from(node)];
            let value = DVec3::from(values(node));
            displaced += *weight * value;
            error += *weight * errors(node) + 8.0 * F32 * *weight * value.abs();
        }
        [displaced, error]
    }

    /// Magnitudes of the joints' linear parts and translations, as the Gaussian's weights blend
    /// them.
    fn skinning_size(&self, k: usize, view: DAffine3) -> (DMat3, DVec3) {
        let neutral = &self.stored.gaussians;
        let mut linear = DMat3::ZERO;
        let mut moved = DVec3::ZERO;
        for (joint, weight) in neutral.joint[k].into_iter().zip(neutral.joint_weight[k]) {
            let weight = f64::from(weight) / 255.0;
            let joint = view * self.posed.joints[usize::from(joint)];
            linear += weight * magnitudes(joint.matrix3);
            moved += weight * joint.translation.abs();
        }
        (linear, moved)
    }

    /// A Gaussian's corrective of an attribute.
    fn corrective<const C: usize>(&self, rows: &Rows<C>, k: usize) -> [UncertainSum; C] {
        let from = self.stored.parts.part_of(k) * self.stored.networks.output();
        let to = from + self.stored.basis_len();
        let Uncertain { value, error } = self.features;
        corrective(rows, k, &value[from..to], &error[from..to])
    }

    /// A Gaussian's rotation in canonical space, and the error of its angle, radians.
    fn rotation(&self, k: usize, own: &NeutralGaussian) -> (DMat3, f64) {
        let turn = self.corrective(&self.stored.rotation_rows, k);
        let q0 = DQuat::from_xyzw(
            own.rotation[1],
            own.rotation[2],
            own.rotation[3],
            own.rotation[0],
        );
        let delta = values(turn);
        let q = q0 + DQuat::from_xyzw(delta[1], delta[2], delta[3], delta[0]);
        let error = length(turn) + 4.0 * F32 * (1.0 + delta.iter().map(|d| d.abs()).sum::<f64>());
        // Which of the two rotations is used may itself be uncertain.
        let either = (q.length() - ROTATION_MIN).abs() <= error;
        let angle = if either || error >= 0.5 * q.length() {
            2.0
        } else if q.length() < ROTATION_MIN {
            16.0 * F32
        } else {
            2.0 * error / (q.length() - error) + 16.0 * F32
        };
        (
            DMat3::from_quat(project::rotation(own.rotation, delta)),
            angle,
        )
    }

    /// A Gaussian's log scales, and the relative error of each scale.
    fn log_scale(&self, k: usize) -> ([f64; 3], [f64; 3]) {
        let grown = self.corrective(&self.stored.scale_rows, k);
        let mut log_scale = [0.0; 3];
        let mut scale_error = [0.0; 3];
        for axis in 0..3 {
            let neutral = f64::from(self.stored.gaussians.log_scale[k][axis]);
            let sum = neutral + grown[axis].value;
            log_scale[axis] = sum.min(LOG_SCALE_MAX);
            let low = (sum - grown[axis].error).min(LOG_SCALE_MAX);
            let high = (sum + grown[axis].error).min(LOG_SCALE_MAX);
            let size = neutral.abs() + sum.abs() + LOG_SCALE_MAX;
            scale_error[axis] = (high - low).exp_m1() + 4.0 * F32 * size;
        }
        (log_scale, scale_error)
    }

    /// [`Posed3::color_error`].
    fn color_error(&self, k: usize, own: &NeutralGaussian) -> f64 {
        let tint = self.corrective(&self.stored.color_rows, k);
        (0..3)
            .map(|c| {
                let sum = own.color[c] + tint[c].value;
                let clamp = |by: f64| (sum + by).clamp(0.0, 1.0);
                let error = tint[c].error + 4.0 * F32 * (own.color[c].abs() + sum.abs());
                (clamp(error) - clamp(0.0)).max(clamp(0.0) - clamp(-error))
            })
            .fold(0.0, f64::max)
    }

    /// A Gaussian that comes from the pose cache. None if the cache can't hold it.
    fn cached(&self, k: usize, cache: &PoseCache) -> Option<Posed3> {
        let stored = self.posed(k, cache.view);
        let [min, max] = cache.bounds;
        let size = max - min;
        let relative = (stored.mean - min) / size.max(DVec3::splat(1e-38));
        // A code, and what f32 does to a number between 0 and 1 on its way there and back.
        let code = 1.0 / CACHE_CODES + 6.0 * F32;
        let step = relative.to_array().map(|at| {
            code * if at < 0.0 {
                (1.0 - at).powi(2) / CACHE_TAIL
            } else if at > 1.0 {
                at.powi(2) / CACHE_TAIL
            } else {
                1.0 / (1.0 - 2.0 * CACHE_TAIL)
            }
        });
        let position_error = stored.mean_error
            + size * DVec3::from(step)
            + 4.0 * F32 * (min.abs() + size + stored.mean.abs());

        let rows = row_lengths(stored.axes);
        let row_error = row_lengths(stored.axes_error)
            + rows * stored.scale_error.into_iter().fold(0.0, f64::max);
        let largest = (rows + row_error)
            .max_element()
            .max(cache.unit * CACHE_FIRST.exp2());
        let most = cache.unit * (CACHE_LAST / CACHE_OCTAVE + CACHE_FIRST).exp2();
        if largest.is_nan() || largest > most {
            return None;
        }
        let unit = largest * (1.0 / CACHE_OCTAVE).exp2() * (1.0 + 32.0 * F32) / CACHE_STEPS;
        // Gram–Schmidt of the rows, as the device does it.
        let transposed = stored.axes.transpose();
        let [a, b, c] = [transposed.x_axis, transposed.y_axis, transposed.z_axis];
        let unit_a = a.normalize_or_zero();
        let l10 = b.dot(unit_a);
        let across = b - l10 * unit_a;
        let unit_b = across.normalize_or_zero();
        let [l20, l21] = [c.dot(unit_a), c.dot(unit_b)];
        let l22 = (c - l20 * unit_a - l21 * unit_b).length();
        let l11 = across.length();
        let axes = DMat3::from_cols(
            DVec3::new(a.length(), l10, l20),
            DVec3::new(0.0, l11, l21),
            DVec3::new(0.0, 0.0, l22),
        );
        // The second direction is as uncertain as what is left of the second row.
        let lost = if l11 > 0.0 {
            (8.0 * F32 * b.length() / l11).min(2.0)
        } else {
            0.0
        };
        let step =
            |row: usize| 0.5 * unit * (1.0 + 8.0 * F32) + row_error[row] + 8.0 * F32 * rows[row];
        let swept = lost * c.length();
        let axes_error = DMat3::from_cols(
            DVec3::new(step(0), step(1), step(2)),
            DVec3::new(0.0, step(1), step(2) + swept),
            DVec3::new(0.0, 0.0, step(2) + swept),
        );
        let to_camera = self.camera.view * cache.view.inverse();
        let size = magnitudes(to_camera.matrix3);
        Some(Posed3 {
            mean: self.camera.view.transform_point3(self.gaussians[k].mean),
            mean_error: size * position_error
                + 8.0 * F32 * (size * stored.mean.abs() + to_camera.translation.abs()),
            axes: to_camera.matrix3 * axes,
            axes_error: size * axes_error + AXIS_ROUNDINGS * F32 * (size * magnitudes(axes)),
            scale_error: [0.0; 3],
            ..stored
        })
    }

    /// The splat of a Gaussian; None if no device draws it.
    fn splat(&self, k: usize) -> Option<UncertainSplat> {
        let camera = self.camera;
        let rounding = self.rounding;
        let gaussian = &self.gaussians[k];
        let opacity = f64::from(gaussian.opacity) / 255.0;
        if opacity <= rounding.cutoff {
            return None;
        }
        let posed = match &self.cache {
            Some(cache) => self.cached(k, cache),
            None => Some(self.posed(k, camera.view)),
        };
        let part = self.stored.parts.part_of(k);
        let mut splat = UncertainSplat {
            gaussian: k,
            may_vanish: false,
            strays: false,
            depth: camera.view.transform_point3(gaussian.mean).z,
            key: [0.0, 1.0],
            center: DVec2::ZERO,
            shift: DVec2::ZERO,
            color: gaussian.color,
            color_error: rounding.color_step() + posed.as_ref().map_or(1.0, |p| p.color_error),
            reach: DVec2::INFINITY,
            exact: project::project_within(gaussian, camera, self.limits, self.low_pass, 0).ok(),
            opacity,
            opacity_error: rounding.opacity(opacity),
            direction: DVec2::X,
            longer: 1.0,
            shorter: 1.0,
            turn: 0.0,
            turn_f32: 0.0,
            columns: [DVec2::ZERO; 3],
            column_error: [DVec2::ZERO; 3],
            scale_error: [0.0; 3],
            evaluated_from: 0.0,
            varying: 0.0,
            shape: AlphaTerms::default(),
            far_exponent: f64::INFINITY,
            alpha_error: rounding.alpha(),
            cutoff: rounding.cutoff,
            low_pass: self.low_pass.variance,
            anywhere: true,
        };
        let Some(posed) = posed else {
            return splat.depth.is_finite().then_some(splat);
        };
        splat.strays = !self.bounds.allows_for(part, posed.displaced, posed.axis);
        let is_culled = self.culled
            || (rounding.skip.contains(Skip::PARTS) && self.culled_parts.contains(part));
        splat.may_vanish |= splat.strays && is_culled;

        let t = posed.mean;
        let dz = posed.mean_error.z;
        if t.z + dz < camera.near {
            return None;
        }
        splat.may_vanish |= t.z - dz < camera.near;
        if !t.is_finite() {
            return None;
        }
        splat.key = [dz, -dz].map(|by| key_of(t.z + by, self.depth_range));
        // Nothing can be said of one whose depth may be nearly 0.
        if dz > 0.25 * t.z {
            return Some(splat);
        }
        self.place(&mut splat, &posed).then_some(splat)
    }

    /// Where in the image a splat is, with what errors. False if no device draws it.
    fn place(&self, splat: &mut UncertainSplat, posed: &Posed3) -> bool {
        let projection = ProjectedMean::new(self.camera, posed);
        self.project_axes(splat, posed, &projection);
        let Some(ellipse) = Ellipse::new(&splat.columns, splat.low_pass) else {
            return false;
        };
        if !splat.has_variance_in_range(&ellipse, projection.relative_z)
            || !splat.fade(
                self.rounding,
                self.low_pass.compensation,
                self.facing(splat.gaussian, posed),
            )
        {
            return false;
        }
        splat.set_axes(&ellipse);
        self.set_center(splat, &projection);
        splat.anywhere = false;
        splat.shape = splat.shape();
        let relative = splat.opacity_error + splat.alpha_error;
        // Far enough beyond the cutoff that rounding of the exponential does not matter.
        let margin = 1e-5;
        splat.far_exponent = (splat.opacity * (1.0 + relative) / splat.cutoff).ln() + margin;
        self.set_reach(splat, &ellipse, projection.center)
    }

    /// Least and largest share that is left of the opacity of what faces away. An error of the angle
    /// between axis and direction changes the cosine by no more.
    fn facing(&self, k: usize, posed: &Posed3) -> [f64; 2] {
        if self.stored.gaussians.facing.is_empty() || !self.rounding.skip.contains(Skip::FACING) {
            return [1.0; 2];
        }
        let own = self.gaussians[k].facing.moved(&self.camera.view.matrix3);
        let (linear_size, _) = self.skinning_size(k, self.camera.view);
        let axis_error =
            FACING_ROUNDINGS * F32 * row_lengths(linear_size).length() / own.axis.length();
        let cached = if self.cache.is_some() {
            CACHED_AXIS
        } else {
            0.0
        };
        let direction_error = posed.mean_error.length() / posed.mean.length();
        let off = axis_error + cached + direction_error + FACING_ROUNDINGS * F32;
        let cosine = own
            .axis
            .normalize_or_zero()
            .dot(-posed.mean.normalize_or_zero());
        if !off.is_finite() {
            return [0.0, 1.0];
        }
        [-off, off].map(|by| ((cosine + by - own.limit) / FACING_FADE).clamp(0.0, 1.0))
    }

    /// The axes of a splat, px, and their errors.
    fn project_axes(&self, splat: &mut UncertainSplat, posed: &Posed3, projection: &ProjectedMean) {
        let ProjectedMean {
            slope,
            slope_error,
            relative_z,
            ..
        } = *projection;
        let focal = self.camera.focal.abs() / posed.mean.z;
        let [min, max] = self.limits;
        let clamped = slope.clamp(min, max);
        let clamp_error = DVec2::select(
            slope.cmpge(min - slope_error) & slope.cmple(max + slope_error),
            slope_error,
            DVec2::ZERO,
        ) + 4.0 * F32 * clamped.abs();
        for k in 0..3 {
            let [axis, error] = [posed.axes.col(k), posed.axes_error.col(k)];
            let column = focal * (axis.truncate() - clamped * axis.z);
            splat.columns[k] = column;
            splat.column_error[k] = focal
                * (1.0 + relative_z)
                * (error.truncate() + clamped.abs() * error.z + clamp_error * axis.z.abs())
                + relative_z * column.abs();
        }
        splat.scale_error = posed.scale_error;
    }

    /// Where a device may have a splat's centre, and errors of its distance from a pixel.
    fn set_center(&self, splat: &mut UncertainSplat, projection: &ProjectedMean) {
        let rounding = self.rounding;
        let center = projection.center;
        let size = DVec2::from(self.camera.size.map(f64::from));
        // The centre is rounded to a grid: it is known exactly unless rounding may go either way.
        let grids = CenterGrids::of(self.camera.size);
        let slack = projection.center_error + FIXED_SLACK / grids.steps * grids.coarseness(center);
        let [low, high] = [grids.round(center - slack), grids.round(center + slack)];
        splat.center = 0.5 * (low + high);
        splat.shift = 0.5 * (high - low);
        let coarsest = grids
            .coarseness(center - slack)
            .max(grids.coarseness(center + slack));
        if coarsest != grids.coarseness(center) {
            // Which of two grids is uncertain too.
            splat.shift += coarsest / grids.steps;
        }
        let opaque = (2.0 * 255f64.ln()).sqrt();
        if rounding.quads() {
            // Corners in clip space and on the grid of the rasterizer.
            let far = size.max_element()
                + center.abs().max_element()
                + opaque * splat.longer.min(F16_MAX);
            splat.shift += rounding.snap + 6.0 * F32 * far;
            splat.evaluated_from = far;
            splat.varying = rounding.varying * opaque;
        } else {
            splat.evaluated_from = 4.0;
        }
    }

    /// [`UncertainSplat::reach`], if the interval of α is narrow enough to have one. False if no
    /// device draws the splat into the image.
    fn set_reach(&self, splat: &mut UncertainSplat, ellipse: &Ellipse, center: DVec2) -> bool {
        let exponent = (splat.opacity * (1.0 + splat.opacity_error) / splat.cutoff).ln();
        // How wide the interval is at the ellipse where α is the cutoff.
        let at = splat.exponents_at_most(exponent + EXPONENT_MARGIN);
        if at < EXPONENT_MARGIN {
            let radius = (2.0 * (exponent + EXPONENT_MARGIN)).sqrt() * 1.01;
            splat.reach =
                radius * DVec2::new(ellipse.a.sqrt(), ellipse.c.sqrt()) + splat.shift + 1.0;
            let size = DVec2::from(self.camera.size.map(f64::from));
            let outside = (-center - splat.reach).max(center - size - splat.reach);
            if outside.max_element() > 0.0 {
                return false;
            }
        }
        true
    }
}

/// The mean of a Gaussian in the image, with the errors of its projection.
struct ProjectedMean {
    /// px.
    center: DVec2,
    center_error: DVec2,
    /// x and y over the depth.
    slope: DVec2,
    slope_error: DVec2,
    /// Relative error of the depth.
    relative_z: f64,
}

impl ProjectedMean {
    fn new(camera: &Camera, posed: &Posed3) -> Self {
        let t = posed.mean;
        let e = posed.mean_error;
        let center = camera.project(t);
        let slope = t.truncate() / t.z;
        let slope_error = (e.truncate() + slope.abs() * e.z) / (t.z - e.z);
        Self {
            center,
            center_error: camera.focal.abs() * slope_error
                + 4.0 * F32 * ((center - camera.center).abs() + camera.center.abs()),
            slope,
            slope_error,
            relative_z: e.z / (t.z - e.z) + 6.0 * F32,
        }
    }
}

/// Σ = [[a, b], [b, c]] of a splat, px².
struct Ellipse {
    a: f64,
    b: f64,
    c: f64,
    determinant: f64,
}

impl Ellipse {
    /// From the projected axes. None if it is degenerate.
    fn new(columns: &[DVec2; 3], low_pass: f64) -> Option<Self> {
        let row = |axis: usize| DVec3::from(columns.map(|column| column[axis]));
        let [row_x, row_y] = [row(0), row(1)];
        let [a, b, c] = [
            row_x.dot(row_x) + low_pass,
            row_x.dot(row_y),
            row_y.dot(row_y) + low_pass,
        ];
        let determinant = row_x.cross(row_y).length_squared() + low_pass * (a + c - low_pass);
        let is_valid =
            determinant > 0.0 && a.is_finite() && c.is_finite() && determinant.is_finite();
        is_valid.then_some(Self {
            a,
            b,
            c,
            determinant,
        })
    }
}

/// Keys of depths, 0 (far) to 1, as `common/depth_key.glsl` has them.
fn key_of(depth: f64, range: [f64; 2]) -> f64 {
    const TAIL: f64 = 1.0 / 64.0;
    let at = (range[1] - depth) / (range[1] - range[0]);
    if at < 0.0 {
        TAIL / (1.0 - at)
    } else if at > 1.0 {
        1.0 - TAIL / at
    } else {
        TAIL + (1.0 - 2.0 * TAIL) * at
    }
}

impl UncertainSplat {
    /// Whether a device may draw it in front of one that the reference has in front of it. Keys are
    /// integers: within a step two may be equal, and then the indices decide.
    pub fn may_pass(&self, nearer: &Self, key_max: u32) -> bool {
        self.key[1] + 1.0 / f64::from(key_max) + KEY_ROUNDING >= nearer.key[0]
    }

    /// False if its variances are too large for any device to draw it. Notes whether some may leave
    /// it out.
    fn has_variance_in_range(&mut self, ellipse: &Ellipse, relative_z: f64) -> bool {
        let largest = ellipse.a.max(ellipse.c);
        let grows = 4.0 * (self.scale_error.into_iter().fold(0.0, f64::max) + relative_z)
            + 4.0 * self.column_error.iter().map(|e| e.length()).sum::<f64>() / largest.sqrt()
            + 16.0 * F32;
        if largest > VARIANCE_MAX * (1.0 + grows) {
            return false;
        }
        self.may_vanish |= largest * (1.0 + grows) > VARIANCE_MAX;
        true
    }

    /// The ellipse's axes, and errors of their direction.
    fn set_axes(&mut self, ellipse: &Ellipse) {
        let Ellipse {
            a,
            b,
            c,
            determinant,
        } = *ellipse;
        let half = 0.5 * (a - c);
        let root = half.hypot(b);
        let longer = 0.5 * (a + c) + root;
        let direction = if half >= 0.0 {
            DVec2::new(half + root, b)
        } else {
            DVec2::new(b, root - half)
        };
        self.direction = direction.try_normalize().unwrap_or(DVec2::X);
        self.longer = longer.sqrt();
        self.shorter = (determinant / longer).sqrt();
        let d = self.direction;
        // Each component of the axis is off by a step, or taken for 0 if it is subnormal.
        self.turn =
            2.0 * (d.x * d.y).abs() * F16 + (F16_NORMAL / self.longer).min(d.abs().min_element());
        self.turn_f32 = SHAPE_ROUNDINGS * F32 * (a + c) / (2.0 * root).max(f64::MIN_POSITIVE);
    }

    /// Multiplies the opacity by what the filter's compensation leaves, with what errors, and by what
    /// facing leaves. False if neither a device nor the reference draws the splat.
    fn fade(&mut self, rounding: &Rounding, share: f64, facing: [f64; 2]) -> bool {
        if share == 0.0 && facing == [1.0; 2] {
            return true;
        }
        let neutral = 255.0 * self.opacity;
        let [least, most] = self
            .compensation()
            .map(|factor| neutral * (1.0 - share + share * factor));
        let [low, high] = [least * facing[0], most * facing[1]];
        // A device rounds to 255ths: known exactly unless rounding may go either way.
        let low = (low - OPACITY_SLACK).round().max(0.0) / 255.0;
        let high = (high + OPACITY_SLACK).round() / 255.0;
        let exact = self.exact.as_ref().map_or(0.0, |splat| splat.opacity);
        self.may_vanish |= low <= self.cutoff * (1.0 + 1e-6);
        let high = high.max(exact);
        if high <= self.cutoff {
            return false;
        }
        let low = if exact > 0.0 { low.min(exact) } else { low };
        self.opacity = 0.5 * (low + high);
        self.opacity_error =
            0.5 * (high - low) / self.opacity + 2.0 * rounding.opacity(self.opacity);
        true
    }

    /// Least and largest factor of the opacity: with the parallelogram A of the projected axes,
    /// det Σ' = A², and T = |m|² it is A / √(A² + k T + k²), which grows with A and falls with T.
    fn compensation(&self) -> [f64; 2] {
        let area = |a: DVec2, b: DVec2| a.x * b.y + a.y * b.x;
        let columns = self.columns.map(DVec2::abs);
        let errors: [DVec2; 3] =
            std::array::from_fn(|k| self.column_error[k] + self.scale_error[k] * columns[k]);
        let [mut exact, mut error] = [0.0f64; 2];
        for [i, j] in [[0, 1], [0, 2], [1, 2]] {
            let product = self.columns[i].perp_dot(self.columns[j]);
            // The scales' own errors leave the angle between the axes as it is.
            let [own_i, own_j] = [i, j].map(|k| self.column_error[k]);
            let [scale_i, scale_j] = [i, j].map(|k| self.scale_error[k]);
            let off = product.abs() * (scale_i + scale_j + scale_i * scale_j)
                + area(own_i, columns[j] + errors[j])
                + area(columns[i] + errors[i], own_j)
                + 4.0 * F32 * area(columns[i], columns[j]);
            exact += product * product;
            error += off * off;
        }
        let [exact, error] = [exact, error].map(f64::sqrt);
        let k = self.low_pass;
        let factor = |sign: f64| {
            let area = (exact + sign * error).max(0.0);
            let squares: f64 = (0..3)
                .map(|axis| (columns[axis] - sign * errors[axis]).max(DVec2::ZERO))
                .map(DVec2::length_squared)
                .sum();
            let factor = area / (area * area + k * squares + k * k).sqrt();
            (factor * (1.0 + sign * COMPENSATION_ROUNDINGS * F32)).min(1.0)
        };
        [factor(-1.0), factor(1.0)]
    }

    /// An upper bound of how far exponents of at most `exponent` may be off.
    fn exponents_at_most(&self, exponent: f64) -> f64 {
        let n = (2.0 * exponent).sqrt();
        let v = n / self.shorter;
        let along = n * self.longer;
        let error: DVec2 = self.column_error.iter().sum();
        let scale = self.scale_error.into_iter().fold(0.0, f64::max);
        let own = 2.0 * exponent * F16 * 2.0
            + v * self.shift.length()
            + self.shift.length_squared() / (2.0 * self.shorter.powi(2))
            + n * v * error.length()
            + scale * n * n
            + (n * error.length() + scale * n * self.longer).powi(2) / (2.0 * self.low_pass)
            + self.turned(n, n, along.powi(2))
            + n * (2.0 * self.evaluation(DVec2::splat(along)) + self.varying);
        own * (1.0 + (2.0 * own).min(1.0))
    }

    fn shape(&self) -> AlphaTerms {
        let ratio = self.longer / self.shorter;
        let apart = ratio - 1.0 / ratio;
        let turn = (self.turn + self.turn_f32).min(1.0);
        let rounded = |axis: f64| {
            [-1.0, 1.0].map(|sign| axis.min(F16_MAX) * (1.0 + sign * (F16 + SHAPE_ROUNDINGS * F32)))
        };
        AlphaTerms {
            longer: rounded(self.longer),
            shorter: rounded(self.shorter),
            turned: self.turn * apart + 2.0 * SHAPE_ROUNDINGS * F32 * (ratio + 1.0 / ratio),
            turned_square: 0.5 * turn * turn,
            apart,
            area: self.longer * self.shorter,
            shift: self.shift.length_squared() / (2.0 * self.shorter.powi(2)),
        }
    }

    /// By how much the axis' direction may change the exponent; `along`, `across`: deviations;
    /// `squared`: distance from the centre, px².
    fn turned(&self, along: f64, across: f64, squared: f64) -> f64 {
        let shape = &self.shape;
        shape.turned * along * across + shape.turned_square * squared * shape.apart / shape.area
    }

    /// Error of a deviation by f32, standard deviations. `d`: from the centre, px.
    fn evaluation(&self, d: DVec2) -> f64 {
        let from = d.abs() + self.evaluated_from;
        8.0 * F32 * (from.x + from.y) / self.shorter
    }

    /// The reference's α at a place of the image, px; 0 where it draws nothing.
    fn exact_alpha(&self, at: DVec2) -> f64 {
        let Some(splat) = &self.exact else {
            return 0.0;
        };
        let d = at - splat.center;
        let [a, b, c] = splat.covariance;
        let squares = c * d.x * d.x - 2.0 * b * d.x * d.y + a * d.y * d.y;
        let alpha = (splat.opacity * (-0.5 * squares / splat.determinant).exp()).min(ALPHA_MAX);
        if alpha >= self.cutoff { alpha } else { 0.0 }
    }

    /// α at a place of the image, px. None where it is under the cutoff on any device.
    pub fn alpha(&self, at: DVec2) -> Option<Alpha> {
        if self.anywhere {
            return Some(Alpha {
                exact: self.exact_alpha(at),
                low: 0.0,
                high: (self.opacity * (1.0 + self.opacity_error)).min(ALPHA_MAX),
            });
        }
        let d = at - self.center;
        let side = self.direction.perp();
        let [along_px, across_px] = [d.dot(self.direction), d.dot(side)];
        let along = along_px.abs() / self.longer;
        let across = across_px.abs() / self.shorter;
        let v = self.direction * (along_px / self.longer.powi(2))
            + side * (across_px / self.shorter.powi(2));

        let evaluated = self.evaluation(d) + self.varying;
        let [long_low, long_high] = self.shape.longer;
        let [short_low, short_high] = self.shape.shorter;
        let far = (along * self.longer / long_low + evaluated).powi(2)
            + (across * self.shorter / short_low + evaluated).powi(2);
        let near = (along * self.longer / long_high - evaluated)
            .max(0.0)
            .powi(2)
            + (across * self.shorter / short_high - evaluated)
                .max(0.0)
                .powi(2);

        let mut first = v.abs().dot(self.shift);
        let mut offset = DVec2::ZERO;
        let mut dual = 0.0;
        for k in 0..3 {
            let y = self.columns[k].dot(v).abs();
            let by = v.abs().dot(self.column_error[k]);
            first += y * by + self.scale_error[k] * y * y;
            offset += y * (self.column_error[k] + self.scale_error[k] * self.columns[k].abs());
            dual += 0.5 * (by + self.scale_error[k] * y).powi(2);
        }
        first += self.turned(along, across, d.length_squared());
        let more = first + offset.length_squared() / (2.0 * self.low_pass) + self.shape.shift;
        let less = first + dual;
        // Errors of errors: a second error acts on what the first has left.
        let compounded = |by: f64| by * (1.0 + (2.0 * by).min(1.0));
        let nearest = (0.5 * near - compounded(less)).max(0.0);
        if nearest > self.far_exponent {
            return None;
        }
        let farthest = 0.5 * far + compounded(more);
        let relative = self.opacity_error + self.alpha_error;
        let high = (self.opacity * (-nearest).exp() * (1.0 + relative)).min(ALPHA_MAX);
        if high < self.cutoff * (1.0 - 1e-6) {
            return None;
        }
        let exact = self.exact_alpha(at);
        let mut low = (self.opacity * (-farthest).exp() * (1.0 - relative)).min(ALPHA_MAX);
        if self.may_vanish || low < self.cutoff * (1.0 + 1e-6) {
            low = 0.0;
        }
        Some(Alpha {
            exact,
            low: low.min(exact),
            high: high.max(exact),
        })
    }
}
