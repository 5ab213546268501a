//! Numbers of an accessor.

use super::{
    buffers::Buffers,
    document::{Document, entry},
};
use crate::splats::bytes::{array, slice};
use effigy_core::io::file::{FormatError, excerpt};

/// Types of components, as glTF numbers them.
const BYTE: u32 = 5120;
const UNSIGNED_BYTE: u32 = 5121;
const SHORT: u32 = 5122;
const UNSIGNED_SHORT: u32 = 5123;
const FLOAT: u32 = 5126;

/// Reads rows of N numbers: normalised integers become −1 to 1 or 0 to 1. `what`: the attribute, in
/// errors. `count`: rows that there must be.
///
/// # Errors
/// When the accessor has another shape, an unknown type, or lies outside its view.
pub fn rows<const N: usize>(
    document: &Document,
    buffers: &Buffers,
    index: usize,
    count: u64,
    what: &str,
) -> Result<Vec<[f32; N]>, FormatError> {
    let accessor = entry(&document.accessors, index, "accessor")?;
    let wrong = |found: String, expected: String| {
        FormatError::container(format!("{found} of the attribute {what}"), expected)
    };
    let shape = ["SCALAR", "VEC2", "VEC3", "VEC4"][N - 1];
    if accessor.shape != shape || accessor.count != count {
        return Err(wrong(
            format!("{} {}", accessor.count, excerpt(&accessor.shape)),
            format!("{count} {shape}"),
        ));
    }
    let size = match accessor.component_type {
        BYTE | UNSIGNED_BYTE => 1,
        SHORT | UNSIGNED_SHORT => 2,
        FLOAT => 4,
        other => {
            return Err(wrong(
                format!("the component type {other}"),
                "5120 to 5123 or 5126".into(),
            ));
        }
    };
    let (Some(view), None) = (accessor.buffer_view, &accessor.sparse) else {
        return Err(wrong(
            "no plain numbers".into(),
            "a buffer view, and no sparse accessor".into(),
        ));
    };
    let viewed = buffers.view(view)?;
    let packed = size * N as u64;
    let stride = viewed.view.byte_stride.unwrap_or(packed);
    if !(packed..=252).contains(&stride) {
        return Err(wrong(
            format!("a stride of {stride}"),
            format!("{packed} to 252"),
        ));
    }
    // The last row may end before its stride does.
    let length = count
        .saturating_sub(1)
        .saturating_mul(stride)
        .saturating_add(packed);
    let bytes = slice(viewed.bytes, accessor.byte_offset, length, what)?;
    let number = |at: usize| {
        let (value, scale) = match accessor.component_type {
            BYTE => (f32::from(i8::from_le_bytes(array(bytes, at))), 127.0),
            UNSIGNED_BYTE => (f32::from(bytes[at]), 255.0),
            SHORT => (f32::from(i16::from_le_bytes(array(bytes, at))), 32_767.0),
            UNSIGNED_SHORT => (f32::from(u16::from_le_bytes(array(bytes, at))), 65_535.0),
            _ => return f32::from_le_bytes(array(bytes, at)),
        };
        if accessor.normalized {
            (value / scale).max(-1.0)
        } else {
            value
        }
    };
    let row = |k: usize| {
        let start = k * stride as usize;
        std::array::from_fn(|component| number(start + component * size as usize))
    };
    Ok((0..count as usize).map(row).collect())
}
