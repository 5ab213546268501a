//! The header of a `.npy` file: a Python dictionary with the type, order and shape of the numbers
//! (NEP 1, "A simple file format for NumPy arrays").

use super::element::Element;
use effigy_core::io::file::excerpt;
use std::borrow::Cow;

/// Dimensions of an array, at most: NumPy's own limit.
const MAX_DIMENSIONS: usize = 32;

/// What a header says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Header {
    pub element: Element,
    /// Whether the first index varies fastest.
    pub fortran: bool,
    pub shape: Vec<usize>,
    /// Where in the file the numbers start, bytes.
    pub start: usize,
}

/// What was found instead of a header, and what was expected.
pub struct Fault {
    pub found: String,
    pub expected: &'static str,
}

/// A header as it stands in the file.
pub struct Text<'a> {
    pub content: Cow<'a, str>,
    /// Where in the file it ends, bytes.
    pub end: usize,
}

/// The header of a `.npy` file.
pub fn text(bytes: &[u8]) -> Result<Text<'_>, Fault> {
    let fault = |found: &str, expected| Fault {
        found: found.to_owned(),
        expected,
    };
    let Some((magic, rest)) = bytes.split_at_checked(8) else {
        return Err(fault("fewer than 8 bytes", "a NumPy array"));
    };
    if &magic[..6] != b"\x93NUMPY" {
        return Err(fault("no \\x93NUMPY at the start", "a NumPy array"));
    }
    // Version 1 has two bytes of length, later ones four.
    let field = if magic[6] == 1 { 2 } else { 4 };
    let length = rest.get(..field).map(|bytes| {
        bytes
            .iter()
            .rev()
            .fold(0, |sum, &b| sum << 8 | usize::from(b))
    });
    let text = length.and_then(|length| rest.get(field..field.checked_add(length)?));
    let Some(text) = text else {
        return Err(fault("an end inside the header", "a whole header"));
    };
    Ok(Text {
        content: String::from_utf8_lossy(text),
        end: magic.len() + field + text.len(),
    })
}

impl Header {
    pub fn parse(bytes: &[u8]) -> Result<Self, Fault> {
        let Text {
            content: text,
            end: start,
        } = text(bytes)?;
        let value = |key: &str| {
            let (_, after) = text.split_once(&format!("'{key}':"))?;
            Some(after.trim_start())
        };
        let in_words = || excerpt(&text);
        let (Some(descr), Some(order), Some(shape)) =
            (value("descr"), value("fortran_order"), value("shape"))
        else {
            return Err(Fault {
                found: in_words(),
                expected: "descr, fortran_order and shape",
            });
        };
        Ok(Self {
            element: element(descr).ok_or_else(|| Fault {
                found: in_words(),
                expected: "floats of 2, 4 or 8 bytes or integers of 1, 2, 4 or 8",
            })?,
            fortran: order.starts_with("True"),
            shape: dimensions(shape).ok_or_else(|| Fault {
                found: in_words(),
                expected: "a shape of at most 32 dimensions",
            })?,
            start,
        })
    }

    /// Numbers in all; None where that overflows.
    pub fn count(&self) -> Option<usize> {
        self.shape
            .iter()
            .try_fold(1usize, |count, &size| count.checked_mul(size))
    }
}

/// Reads a type in quotes.
fn element(text: &str) -> Option<Element> {
    Element::parse(text.strip_prefix('\'')?.split_once('\'')?.0)
}

/// Reads a tuple such as `(200000, 3)`, `(5,)` or `()`.
fn dimensions(text: &str) -> Option<Vec<usize>> {
    let inside = text.strip_prefix('(')?.split_once(')')?.0;
    let words = inside.split(',').map(str::trim);
    let sizes: Option<Vec<usize>> = words
        .filter(|word| !word.is_empty())
        // Python 2 wrote long integers so.
        .map(|word| word.trim_end_matches('L').parse().ok())
        .collect();
    sizes.filter(|sizes| sizes.len() <= MAX_DIMENSIONS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::npz::element::Kind;

    fn npy(text: &str) -> Vec<u8> {
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend((text.len() as u16).to_le_bytes());
        bytes.extend(text.bytes());
        bytes
    }

    #[test]
    fn headers_are_read_as_numpy_writes_them() {
        let text = "{'descr': '<f2', 'fortran_order': False, 'shape': (200, 3), }     \n";
        let header = Header::parse(&npy(text)).ok();
        let expected = Header {
            element: Element {
                kind: Kind::Float,
                size: 2,
                big_endian: false,
            },
            fortran: false,
            shape: vec![200, 3],
            start: 10 + text.len(),
        };
        assert_eq!(header, Some(expected));
        let scalar = npy("{'descr': '|u1', 'fortran_order': True, 'shape': ()}");
        let scalar = Header::parse(&scalar).ok().expect("a scalar");
        assert_eq!((scalar.count(), scalar.fortran), (Some(1), true));
    }

    #[test]
    fn hostile_headers_are_faults() {
        let shape = |shape: &str| {
            let text = format!("{{'descr': '<f4', 'fortran_order': False, 'shape': {shape}}}");
            Header::parse(&npy(&text))
        };
        let huge = format!("({0}, {0}, {0})", usize::MAX);
        assert_eq!(shape(&huge).ok().and_then(|header| header.count()), None);
        assert!(shape("(-1,)").is_err() && shape("(1").is_err());
        assert!(shape(&format!("({})", "1,".repeat(33))).is_err());
        for descr in ["|O", "<U7", "<f3", "<c8", "[('a', '<f4')]"] {
            let text = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': (1,)}}");
            assert!(Header::parse(&npy(&text)).is_err(), "{descr}");
        }
        let mut long = b"\x93NUMPY\x02\x00".to_vec();
        long.extend(u32::MAX.to_le_bytes());
        assert!(Header::parse(&long).is_err());
    }
}
