//! What the program says about itself in numbers: how far a picture is from the oracle's, and how visible that is.

pub mod android;
pub mod bench;
pub mod bytes;
pub mod capture;
pub mod error;
pub mod flip;
pub mod governor;
pub mod packing;
pub mod similarity;
pub mod soak;
pub mod stress;
pub mod thermals;
pub mod trace;

pub use crate::frame::upright;
use glam::{DAffine3, DVec3};

/// Where the avatars of a scene stand: in a row along x around the origin, a metre apart. `number` counts from 0 to below `count`.
pub fn in_a_row(number: usize, count: usize) -> DAffine3 {
    DAffine3::from_translation(DVec3::new(number as f64 - 0.5 * count.saturating_sub(1) as f64, 0.0, 0.0))
}
