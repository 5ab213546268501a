//! antimatter15's `.splat`: 32 bytes a splat and nothing else, in the axes of a 3DGS `.ply`.
//!
//! | bytes | |
//! |---|---|
//! | 0 to 11 | position, three f32 |
//! | 12 to 23 | standard deviations, three f32 |
//! | 24 to 27 | RGB and opacity, of 255 |
//! | 28 to 31 | quaternion w x y z, each 128 + 128 times it |

use super::{
    bytes::{array, f32_at},
    logit,
};
use effigy_core::{
    avatar::{Filter, limits},
    io::{
        file::FormatError,
        splats::{Splats, Up, check_count},
    },
};

/// Bytes of a splat.
pub const ROW: usize = 32;

/// Whether bytes may be splats: the format has no mark, so numbers must make sense. `length`: of
/// the whole file, of which `start` are the first bytes.
pub fn is_splat(start: &[u8], length: u64) -> bool {
    let rows = start.chunks_exact(ROW);
    let sound = |row: &[u8]| {
        let number = |k: usize| f64::from(f32_at(row, 4 * k));
        (0..3).all(|k| number(k).abs() <= limits::LENGTH)
            && (3..6).all(|k| (0.0..=limits::LENGTH).contains(&number(k)))
            && row[28..] != [0; 4]
    };
    // As numbers, letters make sense too.
    let is_whole = length > 0 && length.is_multiple_of(ROW as u64) && rows.len() > 0;
    is_whole && !start.is_ascii() && rows.clone().all(sound)
}

/// Reads the splats.
///
/// # Errors
/// When the length is not that of whole splats, or there are too many.
pub fn read(bytes: &[u8]) -> Result<Splats, FormatError> {
    let count = bytes.len() / ROW;
    if !bytes.len().is_multiple_of(ROW) {
        return Err(FormatError::container(
            format!("a file of {} bytes", bytes.len()),
            format!("{ROW} for each splat of a .splat; the file is incomplete"),
        ));
    }
    check_count(count as u64)?;
    let rows = || bytes.chunks_exact(ROW);
    let three = |row: &[u8], at: usize| [0, 4, 8].map(|k| f32_at(row, at + k));
    let quaternion = |row: &[u8]| {
        let q = array::<4>(row, 28).map(|byte| (f32::from(byte) - 128.0) / 128.0);
        // Other readers take the unit quaternion for none.
        if q == [0.0; 4] {
            [1.0, 0.0, 0.0, 0.0]
        } else {
            q
        }
    };
    Ok(Splats {
        position: rows().map(|row| three(row, 0)).collect(),
        rotation: rows().map(quaternion).collect(),
        log_scale: rows().map(|row| three(row, 12).map(f32::ln)).collect(),
        opacity: rows().map(|row| logit::of_byte(row[27])).collect(),
        color: rows()
            .map(|row| {
                array::<3>(row, 24).map(|byte| logit::color_of_part(f32::from(byte) / 255.0))
            })
            .collect(),
        degree: 0,
        harmonics: vec![],
        up: Up::TRAINED,
        filter: Filter::DEFAULT,
    })
}

/// Writes splats, with y down. Spherical harmonics are left out.
pub fn write(splats: Splats) -> Vec<u8> {
    let splats = splats.with_up(Up::TRAINED);
    let mut bytes = Vec::with_capacity(ROW * splats.len());
    for k in 0..splats.len() {
        let scale = splats.log_scale[k].map(f32::exp);
        let numbers = splats.position[k].into_iter().chain(scale);
        bytes.extend(numbers.flat_map(f32::to_le_bytes));
        bytes.extend(splats.color[k].map(logit::color_to_byte));
        bytes.push(logit::to_byte(splats.opacity[k]));
        let q = splats.rotation[k].map(f64::from);
        let length = q.iter().map(|v| v * v).sum::<f64>().sqrt();
        bytes.extend(q.map(|v| (128.0 + 128.0 * v / length).round().clamp(0.0, 255.0) as u8));
    }
    bytes
}
