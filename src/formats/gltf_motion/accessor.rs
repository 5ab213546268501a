//! Numbers of a glTF file. The crate `gltf` is not used: its accessors subtract from counts of 0,
//! add offsets without looking for overflow and unwrap sparse values that may not be there, and it
//! refuses a whole file for a fault in a material.

use super::document::{Accessor, Document, Shape, View};
use crate::npz::{Element, Kind};
use effigy_core::io::file::FormatError;
use std::borrow::Cow;

/// The document and its bytes.
pub struct Source<'a> {
    pub document: Document<'a>,
    pub buffers: Vec<Cow<'a, [u8]>>,
}

/// Rows of bytes in a buffer.
struct Rows<'a> {
    bytes: &'a [u8],
    stride: usize,
}

impl Shape {
    fn components(self) -> usize {
        match self {
            Self::Scalar => 1,
            Self::Vec2 => 2,
            Self::Vec3 => 3,
            Self::Vec4 | Self::Mat2 => 4,
            Self::Mat3 => 9,
            Self::Mat4 => 16,
        }
    }
}

fn element(component: u32) -> Option<Element> {
    let (kind, size) = match component {
        5120 => (Kind::Signed, 1),
        5121 => (Kind::Unsigned, 1),
        5122 => (Kind::Signed, 2),
        5123 => (Kind::Unsigned, 2),
        5125 => (Kind::Unsigned, 4),
        5126 => (Kind::Float, 4),
        _ => return None,
    };
    Some(Element {
        kind,
        size,
        big_endian: false,
    })
}

/// What integers that stand for -1 to 1 or 0 to 1 are divided by.
fn divisor(element: Element) -> f64 {
    let bits = 8 * element.size as u32;
    match element.kind {
        Kind::Signed => f64::from((1u32 << (bits - 1)) - 1),
        _ => f64::from(u32::MAX >> (32 - bits)),
    }
}

impl Source<'_> {
    fn accessor(&self, at: u32) -> Result<&Accessor, FormatError> {
        let count = self.document.accessors.len();
        let accessor = self.document.accessors.get(at as usize);
        accessor.ok_or_else(|| {
            FormatError::metadata("accessors", format!("number {at} of {count}"), "fewer")
        })
    }

    /// How many rows an accessor says that it has.
    pub fn count(&self, at: u32) -> Result<u64, FormatError> {
        Ok(self.accessor(at)?.count)
    }

    /// `count` rows of `size` bytes of a view, none of which is beyond its buffer.
    fn rows(
        &self,
        view: u32,
        offset: u64,
        size: usize,
        count: u64,
    ) -> Result<Rows<'_>, FormatError> {
        let field = format!("bufferViews[{view}]");
        let of: Option<&View> = self.document.views.get(view as usize);
        let of = of.ok_or_else(|| FormatError::metadata(&field, "nothing", "a view"))?;
        let stride = of.stride.unwrap_or(size as u64);
        let buffer = self.buffers.get(of.buffer as usize);
        // Plain bytes may be there too, for readers without the extension.
        if of.extensions.meshopt.is_some() && buffer.is_none_or(|buffer| buffer.is_empty()) {
            return Err(FormatError::metadata(
                &field,
                "EXT_meshopt_compression",
                "bytes that are not compressed: `gltf-transform copy IN OUT` unpacks them",
            ));
        }
        let bytes = buffer.and_then(|buffer| {
            let start = usize::try_from(of.offset).ok()?;
            let length = usize::try_from(of.length).ok()?;
            let view = buffer.get(start..)?.get(..length)?;
            let last = count.checked_sub(1)?.checked_mul(stride)?;
            let length = usize::try_from(last.checked_add(size as u64)?).ok()?;
            view.get(usize::try_from(offset).ok()?..)?.get(..length)
        });
        let bytes = bytes.filter(|_| stride >= size as u64).ok_or_else(|| {
            FormatError::metadata(
                &field,
                format!("{count} rows of {size} bytes beyond its end"),
                "rows that its buffer holds",
            )
        })?;
        Ok(Rows {
            bytes,
            stride: stride as usize,
        })
    }

    /// The numbers of an accessor, integers as the numbers from -1 to 1 that they stand for.
    /// `shape`: which it has to have; `count`: how many rows.
    pub fn numbers(&self, at: u32, shape: Shape, count: u64) -> Result<Vec<f32>, FormatError> {
        let accessor = self.accessor(at)?;
        let fault = |found: String, expected: &str| {
            FormatError::metadata(&format!("accessors[{at}]"), found, expected)
        };
        if accessor.shape != shape || accessor.count != count || count == 0 {
            return Err(fault(
                format!("{} of {:?}", accessor.count, accessor.shape),
                &format!("{} of {shape:?}", count.max(1)),
            ));
        }
        let element = element(accessor.component);
        let element = element.filter(|element| {
            element.kind == Kind::Float || (accessor.normalized && element.size <= 2)
        });
        let element = element.ok_or_else(|| {
            fault(
                format!("components of the type {}", accessor.component),
                "floats, or normalised integers of 8 or 16 bits",
            )
        })?;
        let columns = shape.components();
        let size = columns * element.size;
        let one = |bytes: &[u8]| {
            let number = element.float(bytes);
            match element.kind {
                Kind::Float => number as f32,
                _ => (number / divisor(element)).max(-1.0) as f32,
            }
        };
        let mut numbers = vec![];
        if let Some(view) = accessor.view {
            let rows = self.rows(view, accessor.offset, size, count)?;
            numbers.reserve_exact(count as usize * columns);
            for row in 0..count as usize {
                let row = &rows.bytes[row * rows.stride..][..size];
                numbers.extend(row.chunks_exact(element.size).map(one));
            }
        } else if accessor.sparse.is_some() {
            // Zeros but where it says otherwise; as many as keys that were read.
            numbers.resize(count as usize * columns, 0.0);
        } else {
            return Err(fault("no bytes".into(), "a view"));
        }
        if let Some(sparse) = &accessor.sparse {
            let index = self::element(sparse.indices.component);
            let index = index.filter(|index| index.kind == Kind::Unsigned);
            let index = index.ok_or_else(|| {
                fault(
                    format!("indices of the type {}", sparse.indices.component),
                    "unsigned integers",
                )
            })?;
            let places = &sparse.indices;
            let places = self.rows(places.view, places.offset, index.size, sparse.count)?;
            let values = &sparse.values;
            let values = self.rows(values.view, values.offset, size, sparse.count)?;
            for k in 0..sparse.count as usize {
                let place = &places.bytes[k * places.stride..][..index.size];
                let place = index.integer(place) as usize;
                let row = &values.bytes[k * values.stride..][..size];
                let start = place.checked_mul(columns);
                let into = start.and_then(|start| numbers.get_mut(start..)?.get_mut(..columns));
                let into =
                    into.ok_or_else(|| fault(format!("a sparse row {place}"), "rows that it has"))?;
                for (into, bytes) in into.iter_mut().zip(row.chunks_exact(element.size)) {
                    *into = one(bytes);
                }
            }
        }
        match numbers.iter().find(|number| !number.is_finite()) {
            Some(number) => Err(fault(number.to_string(), "finite numbers")),
            None => Ok(numbers),
        }
    }
}
