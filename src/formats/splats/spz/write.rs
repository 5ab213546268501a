//! Writing of version 3, which every reader since 2025 has.

use super::{
    super::logit,
    codes,
    container::{ANTIALIASED, MAGIC},
};
use effigy_core::io::splats::{Splats, Up, functions_of};
use flate2::{Compression, write::GzEncoder};
use std::io::{self, Write};

/// Bits of a position after the point, at most: steps of 0.06 mm.
const FRACTION: u8 = 14;

/// The bytes of a file. Positions keep 14 bits after the point, fewer where that leaves too few
/// before it; harmonics are clamped to −1 to 1 and colours to what 8 bits hold. Of
/// the low-pass a flag says whether it is compensated.
///
/// # Errors
/// Only if compressing does.
pub fn write(splats: Splats) -> io::Result<Vec<u8>> {
    let splats = splats.with_up(Up::Y);
    let count = splats.len();
    let furthest = splats
        .position
        .as_flattened()
        .iter()
        .fold(0f32, |far, v| far.max(v.abs()));
    let fits = |bits: &u8| f64::from(furthest) * 2f64.powi((*bits).into()) < f64::from(1 << 23);
    let fraction = (0..=FRACTION).rev().find(fits).unwrap_or_default();
    let mut bytes = Vec::with_capacity(16 + (20 + 3 * functions_of(splats.degree)) * count);
    bytes.extend(MAGIC);
    bytes.extend(3u32.to_le_bytes());
    bytes.extend((count as u32).to_le_bytes());
    let flags = if splats.filter.compensated {
        ANTIALIASED
    } else {
        0
    };
    bytes.extend([splats.degree as u8, fraction, flags, 0]);
    let positions = splats.position.as_flattened().iter();
    bytes.extend(positions.flat_map(|&v| codes::fixed_code(v, fraction)));
    bytes.extend(splats.opacity.iter().map(|&v| logit::to_byte(v)));
    bytes.extend(
        splats
            .color
            .as_flattened()
            .iter()
            .map(|&v| codes::color_code(v)),
    );
    let scales = splats.log_scale.as_flattened().iter();
    bytes.extend(scales.map(|&v| codes::log_scale_code(v)));
    let rotations = splats.rotation.iter();
    bytes.extend(rotations.flat_map(|&q| codes::rotation_code(q).to_le_bytes()));
    let harmonics = splats.harmonics.as_flattened().iter();
    bytes.extend(harmonics.map(|&v| codes::harmonic_code(v)));
    let mut gzip = GzEncoder::new(Vec::new(), Compression::best());
    gzip.write_all(&bytes)?;
    gzip.finish()
}
