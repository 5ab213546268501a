//! Constants of the model and its arithmetic, shared by the reference, the GPU and the files.

/// Added to both diagonal entries of a projected covariance, px², where the avatar has no filter of
/// its own (docs/model.md, step 8).
pub const LOW_PASS: f64 = 0.3;
/// Contributions below this opacity are skipped (docs/model.md, step 10).
pub const ALPHA_MIN: f64 = 1.0 / 255.0;
/// The saturation depth is where what lies behind shows by less than this at any pixel: no pixel is
/// off by 0.05 for it. Pixels are filled with the colour of what lies there, so that it may be well
/// above the cutoff (docs/experiments/058, 066).
pub fn saturation_light(cutoff: f64) -> f64 {
    (12.0 * ALPHA_MIN).max(2.0 * cutoff)
}
/// A Gaussian that faces away fades out over this difference of cosines, so that none appears at
/// once (docs/model.md, step 8).
pub const FACING_FADE: f64 = 0.125;
/// Steps that the limit of a Gaussian's cone has for a cosine of 1.
pub const FACING_STEPS: f64 = 120.0;
/// No single Gaussian covers more of a pixel than this (docs/model.md, step 10).
pub const ALPHA_MAX: f64 = 0.99;
/// Distance of the near plane where a person is looked at, metres.
pub const NEAR: f64 = 0.1;
/// Where the perspective's derivative is clamped: this fraction of the half field of view outside
/// the image. Further out it would grow without bound.
pub const DERIVATIVE_MARGIN: f64 = 0.3;

/// The largest finite number of f16.
pub const F16_MAX: f64 = 65504.0;
/// Inputs, activations and features of networks are clamped to ±this, so that no weights give
/// infinity or NaN.
pub const FEATURE_MAX: f64 = F16_MAX;
/// Slope of the leaky ReLU below 0.
pub const LEAKY_SLOPE: f64 = 0.01;
/// Standard deviations are at most e to the power of this, 8 km.
pub const LOG_SCALE_MAX: f64 = 9.0;
/// A corrected quaternion shorter than this fraction of the neutral one has no usable direction:
/// the neutral rotation is used.
pub const ROTATION_MIN: f64 = 1e-3;
/// Largest variance of a splat in the image, px². Larger splats are culled: f32 does not resolve
/// their shape.
pub const VARIANCE_MAX: f64 = 1e18;
/// The coarsest level of detail: one Gaussian in eight.
pub const DETAIL_COARSEST: u32 = 3;
/// Culling takes a Gaussian's longest axis as this many times longer than stored, for what
/// correctives and skinning add to it.
pub const LONGEST_MARGIN: f64 = 1.2;
