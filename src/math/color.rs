//! Colours between display-referred sRGB and linear light.

use glam::DVec3;

/// Linear light to display-referred sRGB, clamped to 0 to 1.
pub fn encode_srgb(linear: DVec3) -> DVec3 {
    DVec3::from(linear.to_array().map(|v| {
        if v <= 0.0031308 {
            12.92 * v.max(0.0)
        } else {
            1.055 * v.min(1.0).powf(1.0 / 2.4) - 0.055
        }
    }))
}

/// Display-referred sRGB, as 0xRRGGBB, to linear light.
pub fn linear(hex: u32) -> DVec3 {
    let channel = |shift: u32| f64::from(hex >> shift & 255) / 255.0;
    DVec3::from([16, 8, 0].map(channel).map(|v| {
        if v <= 0.04045 {
            v / 12.92
        } else {
            ((v + 0.055) / 1.055f64).powf(2.4)
        }
    }))
}
