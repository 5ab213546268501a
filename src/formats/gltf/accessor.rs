//! Numbers of an accessor.

use super::{
    GltfFile,
    document::{Accessor, SparsePart, entry},
};
use effigy_core::io::file::FormatError;

/// Types of components, as glTF numbers them.
const BYTE: u32 = 5120;
const UNSIGNED_BYTE: u32 = 5121;
const SHORT: u32 = 5122;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
/// The type of components that are floats.
pub const FLOAT: u32 = 5126;
/// Most numbers of an accessor without a view, which no byte of the file accounts for.
const ZEROS: u64 = 1 << 20;

fn fault(at: u32, found: String, expected: &str) -> FormatError {
    FormatError::metadata(&format!("accessors[{at}]"), found, expected)
}

impl GltfFile<'_> {
    /// An accessor.
    ///
    /// # Errors
    /// When there are fewer.
    pub fn accessor(&self, at: u32) -> Result<&Accessor, FormatError> {
        let count = self.document.accessors.len();
        let accessor = self.document.accessors.get(at as usize);
        accessor.ok_or_else(|| {
            FormatError::metadata("accessors", format!("number {at} of {count}"), "fewer")
        })
    }

    /// The rows of an accessor whose shape has N components; which it has, and how many rows, is the
    /// caller's to check. Normalised integers become the numbers from -1 to 1 that they stand for.
    ///
    /// # Errors
    /// When its components are of an unknown type, or rows are beyond the end of their view.
    pub fn rows<const N: usize>(&self, at: u32) -> Result<Vec<[f32; N]>, FormatError> {
        let accessor = self.accessor(at)?;
        let number = |value: f32, one: f32| {
            if accessor.normalized {
                (value / one).max(-1.0)
            } else {
                value
            }
        };
        match accessor.component_type {
            BYTE => self.read_as(at, |own| number(i8::from_le_bytes(own).into(), 127.0)),
            UNSIGNED_BYTE => self.read_as(at, |own| number(u8::from_le_bytes(own).into(), 255.0)),
            SHORT => self.read_as(at, |own| number(i16::from_le_bytes(own).into(), 32_767.0)),
            UNSIGNED_SHORT => {
                self.read_as(at, |own| number(u16::from_le_bytes(own).into(), 65_535.0))
            }
            FLOAT => self.read_as(at, f32::from_le_bytes),
            other => Err(fault(
                at,
                format!("the component type {other}"),
                "5120 to 5123 or 5126",
            )),
        }
    }

    /// The rows of an accessor whose components have SIZE bytes.
    fn read_as<const SIZE: usize, const N: usize>(
        &self,
        at: u32,
        number: impl Fn([u8; SIZE]) -> f32,
    ) -> Result<Vec<[f32; N]>, FormatError> {
        let accessor = self.accessor(at)?;
        let row = |bytes: &[u8]| {
            let numbers = bytes.as_chunks().0;
            std::array::from_fn(|k| number(numbers[k]))
        };
        let mut rows: Vec<[f32; N]> = match (accessor.buffer_view, &accessor.sparse) {
            (Some(view), _) => self
                .bytes(view, accessor.byte_offset, N * SIZE, accessor.count)?
                .map(row)
                .collect(),
            // Zeros but where it says otherwise.
            (None, Some(_)) if accessor.count <= ZEROS / N as u64 => {
                vec![[0.0; N]; accessor.count as usize]
            }
            (None, _) => {
                let found = format!("{} rows without bytes", accessor.count);
                return Err(fault(at, found, "a view"));
            }
        };
        if let Some(sparse) = &accessor.sparse {
            let size = match sparse.indices.component_type {
                Some(UNSIGNED_BYTE) => 1,
                Some(UNSIGNED_SHORT) => 2,
                Some(UNSIGNED_INT) => 4,
                other => {
                    let found = format!("indices of the type {}", other.unwrap_or_default());
                    return Err(fault(at, found, "unsigned integers"));
                }
            };
            let part = |part: &SparsePart, size| {
                self.bytes(part.buffer_view, part.byte_offset, size, sparse.count)
            };
            let values = part(&sparse.values, N * SIZE)?;
            for (index, value) in part(&sparse.indices, size)?.zip(values) {
                let join = |sum, &byte: &u8| sum << 8 | usize::from(byte);
                let index = index.iter().rev().fold(0, join);
                let into = rows.get_mut(index);
                let missing = || fault(at, format!("a sparse row {index}"), "rows that it has");
                *into.ok_or_else(missing)? = row(value);
            }
        }
        Ok(rows)
    }

    /// `count` rows of `size` bytes of a view, none of which is beyond its end.
    fn bytes(
        &self,
        view: u32,
        offset: u64,
        size: usize,
        count: u64,
    ) -> Result<impl ExactSizeIterator<Item = &[u8]>, FormatError> {
        let bytes = self.view(view)?;
        let stride = entry(&self.document.buffer_views, view, "buffer view")?.byte_stride;
        let stride = stride.unwrap_or(size as u64);
        let inside = || {
            // The last row may end before its stride does.
            let last = count.checked_sub(1)?.checked_mul(stride)?;
            let length = usize::try_from(last.checked_add(size as u64)?).ok()?;
            let bytes = bytes.get(usize::try_from(offset).ok()?..)?.get(..length)?;
            let rows = bytes.chunks(usize::try_from(stride).ok()?);
            Some(rows.map(move |row| &row[..size]))
        };
        let rows = if stride < size as u64 { None } else { inside() };
        rows.ok_or_else(|| {
            FormatError::metadata(
                &format!("bufferViews[{view}]"),
                format!("{count} rows of {size} bytes with a stride of {stride} beyond its end"),
                "rows that the view holds",
            )
        })
    }
}
