//! How far a device's image may be from the reference's, pixel by pixel: derived from what its
//! formats and its arithmetic round, not measured.
//!
//! `rounding` says what a renderer's options and its device round. `features` carries that through
//! the networks, `splats` to each projected Gaussian. `pixel` blends them on intervals, and `image`
//! does so for a whole image and holds a device's to it.

mod features;
mod image;
mod pixel;
mod rounding;
mod splats;

pub use image::{BoundScene, BoundUse, ImageBound};
pub use rounding::Rounding;
