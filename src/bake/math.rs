//! Small numbers work shared by the folder: seeded random numbers, smooth noise, steps, colour encoding.

use glam::{DVec3, IVec3};

/// A well-mixed 64-bit number from any other (the finaliser of SplitMix64).
pub fn hash(value: u64) -> u64 {
    let mut z = value.wrapping_add(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// Random numbers that depend on nothing but a seed and the place they are for: threads can't change them.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64, place: u64) -> Self {
        Self(hash(seed ^ hash(place)))
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        hash(self.0)
    }

    /// From 0, below 1.
    pub fn uniform(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// From `low`, below `high`.
    pub fn range(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }

    /// Of mean 0 and deviation 1.
    pub fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.uniform()).cos()
    }

    /// Uniform over the unit sphere.
    pub fn direction(&mut self) -> DVec3 {
        let (z, turn) = (self.range(-1.0, 1.0), self.range(0.0, std::f64::consts::TAU));
        let radius = (1.0 - z * z).max(0.0).sqrt();
        DVec3::new(radius * turn.cos(), radius * turn.sin(), z)
    }
}

/// 0 below `low`, 1 above `high`, smooth between; falling where `low > high`.
pub fn step(low: f64, high: f64, x: f64) -> f64 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Smooth noise about 0, from -1 to 1, that varies over lengths of about 1.
pub fn noise(seed: u64, p: DVec3) -> f64 {
    let (cell, t) = (p.floor(), p - p.floor());
    let t = t * t * (3.0 - 2.0 * t);
    let cell = cell.as_ivec3();
    let corner = |dx: i32, dy: i32, dz: i32| {
        let c = cell + IVec3::new(dx, dy, dz);
        let key = (c.x as u64 & 0x1F_FFFF) | (c.y as u64 & 0x1F_FFFF) << 21 | (c.z as u64 & 0x1F_FFFF) << 42;
        (hash(seed ^ hash(key)) >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let mix = |a: f64, b: f64, t: f64| a + (b - a) * t;
    let plane = |z: i32| mix(mix(corner(0, 0, z), corner(1, 0, z), t.x), mix(corner(0, 1, z), corner(1, 1, z), t.x), t.y);
    mix(plane(0), plane(1), t.z)
}

/// Noise of three octaves.
pub fn rough(seed: u64, p: DVec3) -> f64 {
    (noise(seed, p) + 0.5 * noise(seed + 1, 2.03 * p) + 0.25 * noise(seed + 2, 4.1 * p)) / 1.75
}

/// Linear light to display-referred sRGB.
pub fn encode_srgb(linear: DVec3) -> DVec3 {
    DVec3::from(linear.to_array().map(|v| if v <= 0.0031308 { 12.92 * v.max(0.0) } else { 1.055 * v.min(1.0).powf(1.0 / 2.4) - 0.055 }))
}

/// Display-referred sRGB, as 0xRRGGBB, to linear light.
pub fn srgb(hex: u32) -> DVec3 {
    let channel = |shift: u32| f64::from(hex >> shift & 255) / 255.0;
    DVec3::from([16, 8, 0].map(channel).map(|v| if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055f64).powf(2.4) }))
}

/// Two unit vectors that make a right-handed frame with a third, z.
pub fn frame(z: DVec3) -> [DVec3; 2] {
    z.any_orthonormal_pair().into()
}
