//! Projection of Gaussians into small images, with its derivatives: docs/model.md, steps 5 to 8, in
//! f32. What a fit changes are the numbers of [`FittedShape`]; all else comes from a pose.

use effigy_core::avatar::{Filter, LowPass};
use effigy_core::constants::ALPHA_MIN;
use effigy_core::scene::Camera;
use glam::{Mat3, Quat, Vec2, Vec3};

/// Below this determinant of a projected covariance, px⁴, which discs seen edge-on have, f32 gives
/// no derivative of the filter's compensation: it counts as 0.
const MIN_DETERMINANT: f32 = 1e-8;

/// What fitting changes of a Gaussian, relative to where its merge put it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedShape {
    /// Displacement along its own axes, metres.
    pub offset: Vec3,
    /// Rotation vector in its own axes, radians.
    pub turn: Vec3,
    /// Natural logarithm of the standard deviations along its axes, metres.
    pub log_scale: Vec3,
    /// Logit of the opacity.
    pub logit: f32,
    /// Display-referred RGB without correctives.
    pub color: Vec3,
}

impl FittedShape {
    /// Numbers of a shape.
    pub const NUMBERS: usize = 13;

    /// All numbers, in the order of the fields.
    pub fn to_array(self) -> [f32; Self::NUMBERS] {
        let mut numbers = [0.0; Self::NUMBERS];
        numbers[..3].copy_from_slice(&self.offset.to_array());
        numbers[3..6].copy_from_slice(&self.turn.to_array());
        numbers[6..9].copy_from_slice(&self.log_scale.to_array());
        numbers[9] = self.logit;
        numbers[10..].copy_from_slice(&self.color.to_array());
        numbers
    }

    /// The shape of [`Self::to_array`].
    pub fn from_array(numbers: [f32; Self::NUMBERS]) -> Self {
        let vector = |at: usize| Vec3::new(numbers[at], numbers[at + 1], numbers[at + 2]);
        Self {
            offset: vector(0),
            turn: vector(3),
            log_scale: vector(6),
            logit: numbers[9],
            color: vector(10),
        }
    }

    /// The opacity, 0 to 1.
    pub fn opacity(&self) -> f32 {
        1.0 / (1.0 + (-self.logit).exp())
    }
}

/// A Gaussian in a pose, without its [`FittedShape`].
#[derive(Clone, Copy, Debug)]
pub struct PosedGaussian {
    /// The centre, metres.
    pub mean: Vec3,
    /// G₃ₓ₃ R: the axes, without the standard deviations.
    pub axes: Mat3,
    /// Added to the log scales.
    pub log_scale: Vec3,
    /// Added to the colour.
    pub color: Vec3,
}

/// A Gaussian in the image.
#[derive(Clone, Copy, Debug)]
pub struct ImageSplat {
    /// px from the image's top left corner.
    pub center: Vec2,
    /// Distance along the camera's axis, metres.
    pub depth: f32,
    /// Σ'⁻¹ as [a, b, c], 1/px², with the low-pass.
    pub inverse: [f32; 3],
    /// The largest squared distance, in standard deviations, at which it is visible.
    pub reach: f32,
    /// Half the sides of the box around the visible ellipse, px.
    pub radius: Vec2,
    /// Compensated, 0 to 1.
    pub opacity: f32,
    /// RGB, 0 to 1.
    pub color: Vec3,
}

/// The derivative of a loss by what a [`ImageSplat`] says.
#[derive(Clone, Copy, Debug, Default)]
pub struct ImageSplatGradient {
    /// By the centre, 1/px.
    pub center: Vec2,
    /// By Σ'⁻¹ as [a, b, c], where b stands for both off-diagonal entries, px².
    pub inverse: [f32; 3],
    /// By the compensated opacity.
    pub opacity: f32,
    /// By the colour.
    pub color: Vec3,
}

/// A camera, ready to project.
#[derive(Clone, Copy, Debug)]
pub struct Projection {
    /// World to camera.
    rotation: Mat3,
    translation: Vec3,
    focal: Vec2,
    center: Vec2,
    slope_min: Vec2,
    slope_max: Vec2,
    near: f32,
    size: Vec2,
    filter: Filter,
}

/// What the derivative needs of a projection's steps.
struct Steps {
    /// In camera coordinates.
    t: Vec3,
    /// The turned axes in camera coordinates.
    axes: Mat3,
    /// The axes in the image, each a unit of standard deviation long, px a metre.
    image: [Vec2; 3],
    /// Squared standard deviations.
    variance: [f32; 3],
    /// Σ without the low-pass, as [a, b, c].
    sharp: [f32; 3],
    sharp_determinant: f32,
    /// Σ' with the low-pass.
    smooth: [f32; 3],
    smooth_determinant: f32,
    /// Factor of the opacity.
    compensation: f32,
}

impl Projection {
    /// The projection of a camera.
    pub fn new(camera: &Camera, filter: Filter) -> Self {
        let size = Vec2::new(camera.size[0] as f32, camera.size[1] as f32);
        let [slope_min, slope_max] = camera.derivative_limits().map(|slope| slope.as_vec2());
        Self {
            rotation: camera.view.matrix3.as_mat3(),
            translation: camera.view.translation.as_vec3(),
            focal: camera.focal.as_vec2(),
            center: camera.center.as_vec2(),
            slope_min,
            slope_max,
            near: camera.near as f32,
            size,
            filter,
        }
    }

    /// None where the Gaussian is nearer than the near plane.
    fn steps(&self, shape: &FittedShape, placed: &PosedGaussian) -> Option<Steps> {
        let turned = placed.axes * Mat3::from_quat(Quat::from_scaled_axis(shape.turn));
        let t = self.rotation * (placed.mean + placed.axes * shape.offset) + self.translation;
        if t.z < self.near || t.z.is_nan() {
            return None;
        }
        let axes = self.rotation * turned;
        let slope = (t.truncate() / t.z).clamp(self.slope_min, self.slope_max);
        let f = self.focal / t.z;
        let image =
            [axes.x_axis, axes.y_axis, axes.z_axis].map(|a| f * (a.truncate() - slope * a.z));
        let variance = (2.0 * (shape.log_scale + placed.log_scale))
            .exp()
            .to_array();
        let mut sharp = [0.0; 3];
        for (u, v) in image.iter().zip(variance) {
            sharp[0] += v * u.x * u.x;
            sharp[1] += v * u.x * u.y;
            sharp[2] += v * u.y * u.y;
        }
        // Without cancellation: the sum over pairs of axes of the squared areas that they span.
        let sharp_determinant = [(0, 1), (0, 2), (1, 2)]
            .map(|(i, j)| variance[i] * variance[j] * image[i].perp_dot(image[j]).powi(2))
            .iter()
            .sum::<f32>();
        let k = self.filter.variance as f32;
        let smooth = [sharp[0] + k, sharp[1], sharp[2] + k];
        let smooth_determinant = sharp_determinant + k * (sharp[0] + sharp[2] + k);
        let compensation = LowPass::from(self.filter)
            .opacity_factor(sharp_determinant.into(), smooth_determinant.into())
            as f32;
        Some(Steps {
            t,
            axes,
            image,
            variance,
            sharp,
            sharp_determinant,
            smooth,
            smooth_determinant,
            compensation,
        })
    }

    /// A Gaussian in the image; None where nothing of it is.
    pub fn splat(&self, shape: &FittedShape, placed: &PosedGaussian) -> Option<ImageSplat> {
        self.splat_of(shape, placed, shape.opacity())
    }

    /// [`Self::splat`] with another opacity, 0 to 1.
    pub fn splat_of(
        &self,
        shape: &FittedShape,
        placed: &PosedGaussian,
        opacity: f32,
    ) -> Option<ImageSplat> {
        let steps = self.steps(shape, placed)?;
        let opacity = opacity * steps.compensation;
        let reach = 2.0 * (opacity / ALPHA_MIN as f32).ln();
        let [a, b, c] = steps.smooth;
        let center = self.focal * steps.t.truncate() / steps.t.z + self.center;
        let radius = (reach.max(0.0) * Vec2::new(a, c)).sqrt();
        let visible = reach > 0.0
            && radius.is_finite()
            && steps.smooth_determinant > 0.0
            && (center + radius).min_element() >= 0.0
            && (self.size + radius - center).min_element() >= 0.0;
        let d = steps.smooth_determinant;
        visible.then(|| ImageSplat {
            center,
            depth: steps.t.z,
            inverse: [c / d, -b / d, a / d],
            reach,
            radius,
            opacity,
            color: (shape.color + placed.color).clamp(Vec3::ZERO, Vec3::ONE),
        })
    }

    /// The derivative of a loss by a shape's numbers, from that by its splat's. The perspective's
    /// own change along an offset is left out: it is small where an avatar is.
    pub fn gradient(
        &self,
        shape: &FittedShape,
        placed: &PosedGaussian,
        by: &ImageSplatGradient,
    ) -> [f32; FittedShape::NUMBERS] {
        let Some(steps) = self.steps(shape, placed) else {
            return [0.0; FittedShape::NUMBERS];
        };
        let Steps {
            t,
            image,
            variance,
            smooth,
            sharp,
            ..
        } = steps;
        // dL/dΣ' = −Σ'⁻¹ (dL/dΣ'⁻¹) Σ'⁻¹, all symmetric.
        let d = steps.smooth_determinant;
        let [ia, ib, ic] = [smooth[2] / d, -smooth[1] / d, smooth[0] / d];
        let [ga, gb, gc] = [by.inverse[0], 0.5 * by.inverse[1], by.inverse[2]];
        let m = [
            ga * ia + gb * ib,
            ga * ib + gb * ic,
            gb * ia + gc * ib,
            gb * ib + gc * ic,
        ];
        let mut by_covariance = [
            -(ia * m[0] + ib * m[2]),
            -(ia * m[1] + ib * m[3]),
            -(ib * m[1] + ic * m[3]),
        ];
        let opacity = shape.opacity();
        if self.filter.compensated && steps.sharp_determinant > MIN_DETERMINANT {
            // d ln compensation / dΣ = ½ (Σ⁻¹ − Σ'⁻¹).
            let e = steps.sharp_determinant;
            let weight = 0.5 * by.opacity * opacity * steps.compensation;
            by_covariance[0] += weight * (sharp[2] / e - ia);
            by_covariance[1] += weight * (-sharp[1] / e - ib);
            by_covariance[2] += weight * (sharp[0] / e - ic);
        }
        let [da, db, dc] = by_covariance;
        let form = |u: Vec2, v: Vec2| u.x * (da * v.x + db * v.y) + u.y * (db * v.x + dc * v.y);
        let f = self.focal / t.z;
        let along = f * by.center;
        let by_t = along.extend(-along.dot(t.truncate()) / t.z);
        let turned_back = Mat3::from_quat(Quat::from_scaled_axis(shape.turn));
        let offset = turned_back * (steps.axes.transpose() * by_t);
        let [x, y, z] = image;
        let turn = 2.0
            * Vec3::new(
                (variance[1] - variance[2]) * form(y, z),
                (variance[2] - variance[0]) * form(z, x),
                (variance[0] - variance[1]) * form(x, y),
            );
        let log_scale = 2.0
            * Vec3::new(
                variance[0] * form(x, x),
                variance[1] * form(y, y),
                variance[2] * form(z, z),
            );
        let color = shape.color + placed.color;
        let inside = Vec3::select(
            color.cmpge(Vec3::ZERO) & color.cmple(Vec3::ONE),
            Vec3::ONE,
            Vec3::ZERO,
        );
        FittedShape {
            offset,
            turn,
            log_scale,
            logit: by.opacity * steps.compensation * opacity * (1.0 - opacity),
            color: by.color * inside,
        }
        .to_array()
    }
}
