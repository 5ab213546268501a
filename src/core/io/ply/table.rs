//! The numbers of an element of a `.ply` file.

use super::header::{Element, Encoding, PlyHeader, Property, Scalar};
use crate::io::file::{FormatError, excerpt};
use std::borrow::Cow;

/// A property of all entries.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    kind: Scalar,
    offset: usize,
}

/// The entries of an element, from which any property of any entry can be read.
pub struct Table<'a> {
    bytes: Cow<'a, [u8]>,
    row: usize,
    encoding: Encoding,
    properties: Vec<Property>,
    count: usize,
}

impl<'a> Table<'a> {
    /// Finds an element's entries after the header. Text is converted to f32, which takes at most
    /// twice the file's size.
    ///
    /// # Errors
    /// When the file holds fewer entries than the header says.
    pub fn new(
        bytes: &'a [u8],
        header: &PlyHeader,
        element: &Element,
    ) -> Result<Self, FormatError> {
        let encoding = header.encoding;
        let mut properties = element.properties.clone();
        let count = usize::try_from(element.count).unwrap_or(usize::MAX);
        let body = &bytes[header.end..];
        let before = usize::try_from(element.before).unwrap_or(usize::MAX);
        if encoding == Encoding::Ascii {
            let bytes = Cow::Owned(text(body, before, count, properties.len())?);
            for property in &mut properties {
                property.kind = Scalar::F32;
                property.offset *= 4;
            }
            let row = 4 * properties.len();
            return Ok(Self {
                bytes,
                row,
                encoding: Encoding::Little,
                properties,
                count,
            });
        }
        let rest = body.get(before..).unwrap_or_default();
        let rows = count
            .checked_mul(element.row)
            .and_then(|size| rest.get(..size))
            .ok_or_else(|| cut_off(rest.len() / element.row.max(1), count))?;
        Ok(Self {
            bytes: rows.into(),
            row: element.row,
            encoding,
            properties,
            count,
        })
    }

    /// Number of entries.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Finds a property by its name.
    pub fn column(&self, name: &str) -> Option<Column> {
        let found = self
            .properties
            .iter()
            .find(|property| property.name == name)?;
        Some(Column {
            kind: found.kind,
            offset: found.offset,
        })
    }

    /// How many properties have names of `prefix` and a number.
    pub fn numbered(&self, prefix: &str) -> usize {
        let number = |property: &&Property| {
            property
                .name
                .strip_prefix(prefix)
                .is_some_and(|rest| rest.parse::<u32>().is_ok())
        };
        self.properties.iter().filter(number).count()
    }

    /// Some properties of an entry.
    pub fn values<const N: usize>(&self, entry: usize, columns: [Column; N]) -> [f32; N] {
        columns.map(|column| self.value(entry, column) as f32)
    }

    /// Some properties of all entries.
    pub fn all<const N: usize>(&self, columns: [Column; N]) -> Vec<[f32; N]> {
        let entries = 0..self.count;
        entries.map(|entry| self.values(entry, columns)).collect()
    }

    /// A property of an entry.
    pub fn value(&self, vertex: usize, column: Column) -> f64 {
        let bytes = &self.bytes[vertex * self.row + column.offset..];
        let little = self.encoding == Encoding::Little;
        macro_rules! read {
            ($type:ty) => {{
                let mut number = [0; size_of::<$type>()];
                number.copy_from_slice(&bytes[..size_of::<$type>()]);
                f64::from(if little {
                    <$type>::from_le_bytes(number)
                } else {
                    <$type>::from_be_bytes(number)
                })
            }};
        }
        match column.kind {
            Scalar::I8 => read!(i8),
            Scalar::U8 => read!(u8),
            Scalar::I16 => read!(i16),
            Scalar::U16 => read!(u16),
            Scalar::I32 => read!(i32),
            Scalar::U32 => read!(u32),
            Scalar::F32 => read!(f32),
            Scalar::F64 => read!(f64),
        }
    }
}

/// The file ends after some of its vertices.
fn cut_off(found: usize, count: usize) -> FormatError {
    FormatError::container(
        format!("{found} vertices"),
        format!("{count} as the header says; the file is incomplete"),
    )
}

/// The numbers of `count` lines after the first `before`, as little-endian f32.
fn text(
    body: &[u8],
    before: usize,
    count: usize,
    properties: usize,
) -> Result<Vec<u8>, FormatError> {
    // A number and its separator take at least two bytes.
    let max_numbers = body.len() / 2 + 1;
    if properties.max(1).saturating_mul(count) > max_numbers {
        return Err(cut_off(max_numbers / properties.max(1), count));
    }
    let mut numbers = Vec::with_capacity(4 * properties * count);
    let full = |line: &&[u8]| !line.trim_ascii().is_empty();
    let mut lines = body.split(|&byte| byte == b'\n').filter(full).skip(before);
    for vertex in 0..count {
        let line = lines.next().ok_or_else(|| cut_off(vertex, count))?;
        let line = std::str::from_utf8(line)
            .map_err(|_| FormatError::container("bytes that are no text", "numbers"))?;
        let mut words = line.split_ascii_whitespace();
        for _ in 0..properties {
            let word = words.next().unwrap_or_default();
            let number: f32 = word.parse().map_err(|_| {
                FormatError::container(
                    format!("`{}` in the line of vertex {vertex}", excerpt(word)),
                    format!("{properties} numbers"),
                )
            })?;
            numbers.extend(number.to_le_bytes());
        }
        if let Some(word) = words.next() {
            let found = format!(
                "`{}` at the end of the line of vertex {vertex}",
                excerpt(word)
            );
            return Err(FormatError::container(
                found,
                format!("{properties} numbers"),
            ));
        }
    }
    Ok(numbers)
}
