//! Where measurements look at an avatar from: all around it, from slightly above.

use std::f64::consts::TAU;

/// Vertical field of view, radians.
pub const FOV: f64 = 35f64.to_radians();
/// Angle of the cameras above the horizon, radians.
pub const PITCH: f64 = 0.09;

/// Yaw of a view, radians, at a share of a turn: the first view is not quite from the front.
pub fn yaw(turn: f64) -> f64 {
    TAU * (0.05 + turn)
}

/// Yaw of a view of several that are spread evenly around the avatar, radians.
pub fn yaw_of_view(view: usize, views: usize) -> f64 {
    yaw(view as f64 / views as f64)
}
