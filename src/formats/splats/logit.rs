//! Opacities as files have them: bytes or parts of 1, where splats have logits.

use effigy_core::avatar::ShCoefficients;

/// The logit of an opacity; infinite for 0 and 1.
pub fn of_part(opacity: f32) -> f32 {
    (opacity / (1.0 - opacity)).ln()
}

/// The logit of an opacity of 255.
pub fn of_byte(byte: u8) -> f32 {
    let byte = f32::from(byte);
    (byte / (255.0 - byte)).ln()
}

/// The opacity of a logit, 0 to 1.
pub fn to_part(logit: f32) -> f32 {
    (1.0 / (1.0 + (-f64::from(logit)).exp())) as f32
}

/// The nearest opacity of 255.
pub fn to_byte(logit: f32) -> u8 {
    (255.0 * to_part(logit)).round() as u8
}

/// The coefficient of degree 0 of a colour, 0 to 1.
pub fn color_of_part(part: f32) -> f32 {
    ((f64::from(part) - 0.5) / ShCoefficients::CONSTANT) as f32
}

/// The nearest colour of 255 of a coefficient of degree 0, clamped.
pub fn color_to_byte(coefficient: f32) -> u8 {
    let part = 0.5 + ShCoefficients::CONSTANT * f64::from(coefficient);
    (255.0 * part).round().clamp(0.0, 255.0) as u8
}
