//! What the program says about itself in numbers: how far a picture is from the oracle's, and how visible that is.

pub mod bench;
pub mod bytes;
pub mod error;
pub mod flip;
pub mod stress;

use glam::DVec3;

/// A box at least as high and wide as a person, so that pictures of one clip have the same scale whatever the pose.
pub fn upright([min, max]: [DVec3; 2]) -> [DVec3; 2] {
    let middle = (min + max) / 2.0;
    let half = ((max - min) / 2.0).max(DVec3::new(0.4, 0.92, 0.4));
    [middle - half, middle + half]
}
