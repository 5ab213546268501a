//! The codes of single numbers.

use std::f32::consts::FRAC_1_SQRT_2;

/// Code of a logarithm of 0, and codes a unit.
const LOG_SCALE_ZERO: f32 = 160.0;
const LOG_SCALE_UNIT: f32 = 16.0;
/// Codes of a unit of the colour's coefficient.
const COLOR_UNIT: f32 = 0.15 * 255.0;
/// The largest 9-bit part of a rotation, which is √½.
const PART: f32 = 511.0;

pub fn log_scale(code: u8) -> f32 {
    (f32::from(code) - LOG_SCALE_ZERO) / LOG_SCALE_UNIT
}

pub fn log_scale_code(log_scale: f32) -> u8 {
    byte(log_scale * LOG_SCALE_UNIT + LOG_SCALE_ZERO)
}

pub fn color(code: u8) -> f32 {
    (f32::from(code) - 127.5) / COLOR_UNIT
}

pub fn color_code(coefficient: f32) -> u8 {
    byte(coefficient * COLOR_UNIT + 127.5)
}

pub fn harmonic(code: u8) -> f32 {
    (f32::from(code) - 128.0) / 128.0
}

pub fn harmonic_code(coefficient: f32) -> u8 {
    byte(coefficient * 128.0 + 128.0)
}

fn byte(value: f32) -> u8 {
    value.round().clamp(0.0, 255.0) as u8
}

/// A fixed-point number of 24 bits, `fraction` of them after the point.
pub fn fixed(code: [u8; 3], fraction: u8) -> f32 {
    let [low, middle, high] = code;
    let signed = i32::from_le_bytes([0, low, middle, high]) >> 8;
    (f64::from(signed) / 2f64.powi(fraction.into())) as f32
}

pub fn fixed_code(value: f32, fraction: u8) -> [u8; 3] {
    let scaled = f64::from(value) * 2f64.powi(fraction.into());
    let limit = f64::from(1 << 23);
    let [low, middle, high, _] = (scaled.round().clamp(-limit, limit - 1.0) as i32).to_le_bytes();
    [low, middle, high]
}

/// The quaternion w x y z of versions 1 and 2.
pub fn rotation_of_bytes(code: [u8; 3]) -> [f32; 4] {
    let [x, y, z] = code.map(|byte| f32::from(byte) / 127.5 - 1.0);
    [(1.0 - x * x - y * y - z * z).max(0.0).sqrt(), x, y, z]
}

/// The quaternion w x y z since version 3.
pub fn rotation(code: u32) -> [f32; 4] {
    let largest = (code >> 30) as usize;
    let mut rest = code;
    let mut q = [0.0; 4];
    let mut squares = 0.0;
    // The last of the others is in the lowest bits.
    for (_, part) in q
        .iter_mut()
        .enumerate()
        .rev()
        .filter(|(k, _)| *k != largest)
    {
        let size = FRAC_1_SQRT_2 * (rest & 511) as f32 / PART;
        *part = if rest >> 9 & 1 == 1 { -size } else { size };
        squares += size * size;
        rest >>= 10;
    }
    q[largest] = (1.0f32 - squares).max(0.0).sqrt();
    let [x, y, z, w] = q;
    [w, x, y, z]
}

pub fn rotation_code(rotation: [f32; 4]) -> u32 {
    let length = rotation.iter().map(|v| v * v).sum::<f32>().sqrt();
    let [w, x, y, z] = rotation.map(|v| v / length);
    let q = [x, y, z, w];
    let largest = (1..4).fold(
        0,
        |best, k| if q[k].abs() > q[best].abs() { k } else { best },
    );
    let mut code = largest as u32;
    for (k, part) in q.into_iter().enumerate() {
        if k != largest {
            let size = (part.abs() / FRAC_1_SQRT_2 * PART).round().min(PART) as u32;
            // q and −q are the same rotation; the largest is positive.
            let negative = (part < 0.0) != (q[largest] < 0.0);
            code = code << 10 | u32::from(negative) << 9 | size;
        }
    }
    code
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_come_back() {
        for code in 0..=255u8 {
            assert_eq!(log_scale_code(log_scale(code)), code);
            assert_eq!(color_code(color(code)), code);
            assert_eq!(harmonic_code(harmonic(code)), code);
        }
        for value in [0.0, 1.5, -1.5, 511.75, -512.0] {
            assert_eq!(fixed(fixed_code(value, 14), 14), value);
        }
        assert_eq!(fixed(fixed_code(1e6, 14), 14), 511.999_94);
    }

    #[test]
    fn rotations_come_back_within_their_step() {
        for q in [
            [1.0, 0.0, 0.0, 0.0],
            [-0.5, 0.5, 0.5, -0.5],
            [0.1, -0.9, 0.3, 0.2],
            [0.02, 0.01, 0.03, -2.0],
        ] {
            let length = q.iter().map(|v| v * v).sum::<f32>().sqrt();
            let back = rotation(rotation_code(q));
            let dot: f32 = q.iter().zip(back).map(|(a, b)| a / length * b).sum();
            assert!(dot.abs() > 1.0 - 3e-6, "{q:?} {back:?}");
        }
    }
}
