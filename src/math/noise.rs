//! Smooth steps and smooth noise in space.

use effigy_core::random::hash;
use glam::{DVec3, IVec3};

/// 0 below `low`, 1 above `high`, smooth between. Falls from 1 to 0 where `low > high`.
pub fn smoothstep(low: f64, high: f64, x: f64) -> f64 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Smooth noise about 0, from -1 to 1, that varies over lengths of about 1.
pub fn noise(seed: u64, p: DVec3) -> f64 {
    let corner = p.floor();
    let t = p - corner;
    let t = t * t * (3.0 - 2.0 * t);
    let cell = corner.as_ivec3();
    let corner = |dx: i32, dy: i32, dz: i32| {
        let c = cell + IVec3::new(dx, dy, dz);
        let key = (c.x as u64 & 0x1F_FFFF)
            | (c.y as u64 & 0x1F_FFFF) << 21
            | (c.z as u64 & 0x1F_FFFF) << 42;
        (hash(seed ^ hash(key)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
    let plane = |z: i32| {
        mix(
            mix(corner(0, 0, z), corner(1, 0, z), t.x),
            mix(corner(0, 1, z), corner(1, 1, z), t.x),
            t.y,
        )
    };
    mix(plane(0), plane(1), t.z)
}

/// Noise of three octaves, from -1 to 1; the largest varies over lengths of about 1.
pub fn fractal_noise(seed: u64, p: DVec3) -> f64 {
    (noise(seed, p) + 0.5 * noise(seed + 1, 2.03 * p) + 0.25 * noise(seed + 2, 4.1 * p)) / 1.75
}
