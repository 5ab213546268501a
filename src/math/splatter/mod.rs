//! A small splatter in f32 with derivatives, for what the CPU fits and counts: docs/model.md, steps 1
//! to 10.
//!
//! ```text
//! place: Gaussians in a pose, by the f64 reference ─→ splats: in the image ─→ blend: the image
//! ```

mod blend;
mod place;
mod splats;

pub use blend::{Blended, enlarged, loss_gradient};
pub use place::{placed, shapes};
pub use splats::{FittedShape, ImageSplat, ImageSplatGradient, PosedGaussian, Projection};
