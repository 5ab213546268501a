//! What a frame is, whatever draws it: where the camera stands, what the pose makes of the skeleton, how far the avatar reaches.

pub(crate) mod block;
pub mod camera;
pub mod check;
pub mod counters;
pub mod detail;
pub mod extent;
pub(crate) mod keeper;
pub mod keys;
pub mod options;
pub mod parts;
pub mod picture;
pub mod place;
pub mod plan;
pub mod preset;
pub(crate) mod refuse;
pub mod report;
pub(crate) mod scene;
pub mod skip;
pub mod touched;

use crate::avatar::{Avatar, Pose};
pub use block::fixed_scale;
pub use camera::Camera;
pub use check::Unusable;
pub use counters::{Counters, Reasons};
pub use detail::Detail;
pub use extent::{Extent, upright};
use glam::DAffine3;
pub use keys::KeyBits;
pub use options::{ColorFormat, Method, RendererOptions, Variant};
pub use parts::{Needs, PartSet};
pub use picture::Picture;
pub use place::Place;
pub use plan::{Body, Needed, Plan};
pub use report::FrameReport;
pub use skip::Skip;
pub use touched::Touched;

/// Added to both diagonal entries of a projected covariance, px² (model.md, step 8).
pub const LOW_PASS: f64 = 0.3;
/// Contributions below this opacity are skipped (model.md, step 10).
pub const ALPHA_MIN: f64 = 1.0 / 255.0;
/// No single Gaussian covers more of a pixel than this (model.md, step 10).
pub const ALPHA_MAX: f64 = 0.99;
/// The perspective's derivative is taken at most this fraction of the half field of view outside the picture, where it would
/// otherwise grow without bound.
pub const DERIVATIVE_MARGIN: f64 = 0.3;

/// Activations and features stay within ±this, the largest number that f16 holds, so that no weight whatever makes infinity or NaN of them.
pub const FEATURE_MAX: f64 = 65504.0;
/// Standard deviations are at most e to the power of this, 8 km.
pub const LOG_SCALE_MAX: f64 = 9.0;
/// A corrected quaternion shorter than this share of the neutral one has no direction of its own: the neutral rotation stays.
pub const ROTATION_MIN: f64 = 1e-3;
/// A Gaussian of a larger variance on screen is not drawn, px²: f32 could not tell its shape.
pub const VARIANCE_MAX: f64 = 1e18;

/// A pose worked out for one avatar: all that the stages need of it.
#[derive(Clone, Debug)]
pub struct Posed {
    /// G_j: canonical space to world, one a joint.
    pub joints: Vec<DAffine3>,
    /// θ_p ⊕ θ_e as the networks see it, projected unless told otherwise.
    pub input: Vec<f64>,
    /// Length of θ_e, the last of `input`, which parts outside the head see as zeros.
    pub expression: usize,
}

impl Posed {
    pub fn new(avatar: &Avatar, pose: &Pose) -> Self {
        Self::of(avatar, pose, true)
    }

    /// The same, where `project` is false with networks that see the pose as it is, however far from those that they know.
    pub fn of(avatar: &Avatar, pose: &Pose, project: bool) -> Self {
        let inputs = &avatar.inputs;
        let input = if project { inputs.of(pose) } else { inputs.unprojected(pose) };
        Self { joints: avatar.skeleton.matrices(pose), input, expression: inputs.expression }
    }

    /// The same somewhere else: `place` goes from this world to the one that it stands in.
    pub fn placed(mut self, place: DAffine3) -> Self {
        self.joints.iter_mut().for_each(|joint| *joint = place * *joint);
        self
    }
}

/// How many standard deviations from its centre a Gaussian of this opacity still reaches 1/255: √(2 ln(255 o)). None where it never does.
pub fn reach(opacity: u8) -> Option<f64> {
    (opacity > 1).then(|| (2.0 * f64::from(opacity).ln()).sqrt())
}
