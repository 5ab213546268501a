//! What the program says about itself in numbers: how far a picture is from the oracle's, and how visible that is.

pub mod android;
pub mod bench;
pub mod bytes;
pub mod capture;
pub mod error;
pub mod flip;
pub mod governor;
pub mod soak;
pub mod stress;
pub mod thermals;
pub mod trace;

use glam::{DAffine3, DVec3};

/// Where the avatars of a scene stand: in a row along x around the origin, a metre apart. `number` counts from 0 to below `count`.
pub fn in_a_row(number: usize, count: usize) -> DAffine3 {
    DAffine3::from_translation(DVec3::new(number as f64 - 0.5 * count.saturating_sub(1) as f64, 0.0, 0.0))
}

/// A box at least as high and wide as a person, so that pictures of one clip have the same scale whatever the pose.
pub fn upright([min, max]: [DVec3; 2]) -> [DVec3; 2] {
    let middle = (min + max) / 2.0;
    let half = ((max - min) / 2.0).max(DVec3::new(0.4, 0.92, 0.4));
    [middle - half, middle + half]
}
