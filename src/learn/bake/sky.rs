//! The sky that bodies are lit by: directions, and the light that comes from each.

use effigy_math::noise::smoothstep;
use glam::DVec3;

/// Where the key light is, not of unit length.
pub const KEY: DVec3 = DVec3::new(-0.45, 0.62, 0.64);

/// Radiance from a direction, linear RGB: cool from above, a warm key light from the front and the
/// avatar's upper right, a cool rim light from behind, a little from the ground. `d` is a unit
/// vector towards the light.
pub fn radiance(d: DVec3) -> DVec3 {
    let rim = DVec3::new(0.8, 0.35, -0.5);
    let sky_light = DVec3::new(0.86, 0.93, 1.0) * (0.30 + 0.62 * smoothstep(-0.25, 0.95, d.y));
    let ground_light = DVec3::new(1.0, 0.93, 0.85) * 0.16 * smoothstep(0.1, -0.8, d.y);
    let key_light =
        DVec3::new(1.0, 0.93, 0.83) * 2.9 * smoothstep(0.55, 1.0, d.dot(KEY.normalize()));
    let rim_light =
        DVec3::new(0.85, 0.93, 1.0) * 0.5 * smoothstep(0.5, 1.0, d.dot(rim.normalize()));
    sky_light + ground_light + key_light + rim_light
}

/// The i-th of `count` directions spread evenly over the sphere: a Fibonacci spiral.
pub fn direction(i: usize, count: usize) -> DVec3 {
    let y = 1.0 - 2.0 * (i as f64 + 0.5) / count as f64;
    let turn = i as f64 * std::f64::consts::PI * (3.0 - 5f64.sqrt());
    let radius = (1.0 - y * y).sqrt();
    DVec3::new(radius * turn.cos(), y, radius * turn.sin())
}
