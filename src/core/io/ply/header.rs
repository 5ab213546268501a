//! The text header of a `.ply` file: which properties a vertex has, and where they are.

use crate::io::{
    file::{FormatError, excerpt},
    splats::Up,
};
use std::borrow::Cow;

/// Maximum length of a header, bytes; 3DGS writes 1.5 KB.
const HEADER_MAX: usize = 64 << 10;
/// Start of a comment that names the axis that points up; [`crate::io::ply_export`] writes it.
pub const UP_COMMENT: &str = "effigy up";

/// Encoding of the numbers after the header.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// Text.
    Ascii,
    /// Binary, little-endian.
    Little,
    /// Binary, big-endian.
    Big,
}

/// Type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn parse(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes of a number.
    pub fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

/// A property of a vertex: one number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Property {
    pub name: String,
    pub kind: Scalar,
    /// Bytes from the start of the vertex; in text, the index among the vertex's properties.
    pub offset: usize,
}

/// An element as the header declares it.
#[derive(Debug, Default)]
struct ElementHeader {
    name: String,
    count: u64,
    properties: Vec<Property>,
    /// Name of its first property of varying length.
    list: Option<String>,
    /// Bytes of one entry.
    row: usize,
}

impl ElementHeader {
    /// The list that leaves its length unknown. In text, where each entry is a line, only the
    /// vertices must have no list.
    fn unsized_list(&self, text: bool) -> Option<&str> {
        self.list
            .as_deref()
            .filter(|_| self.name == "vertex" || !text)
    }

    /// Bytes, or lines of text. None if there are more than a u64 holds.
    fn length(&self, text: bool) -> Option<u64> {
        if text {
            Some(self.count)
        } else {
            self.count.checked_mul(self.row as u64)
        }
    }

    /// Where its entries are, and what they consist of; takes the properties.
    fn take_layout(&mut self, text: bool, before: u64) -> ElementLayout {
        let mut properties = std::mem::take(&mut self.properties);
        if text {
            for (index, property) in properties.iter_mut().enumerate() {
                property.offset = index;
            }
        }
        ElementLayout {
            count: self.count,
            properties,
            row: self.row,
            before,
        }
    }
}

/// Where a file has an element's entries, and what they consist of.
#[derive(Clone, Debug)]
pub struct ElementLayout {
    /// Number of entries.
    pub count: u64,
    pub properties: Vec<Property>,
    /// Bytes of an entry in binary files.
    pub row: usize,
    /// Length of what is between the header and the entries: bytes, or lines of text.
    pub before: u64,
}

/// The header of a file.
#[derive(Debug)]
pub struct PlyHeader {
    pub encoding: Encoding,
    /// Where the header ends, bytes.
    pub end: usize,
    /// The axis that points up, if a comment names it.
    pub up: Option<Up>,
    pub vertices: ElementLayout,
    /// Ranges of a compressed file's numbers: the element `chunk`.
    pub chunks: Option<ElementLayout>,
    /// Spherical harmonics of a compressed file: the element `sh`.
    pub harmonics: Option<ElementLayout>,
}

/// The lines of a header.
struct HeaderLines<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> HeaderLines<'a> {
    /// The next line, without its end. Bytes of comments that are no text are replaced.
    fn next_line(&mut self) -> Result<Cow<'a, str>, FormatError> {
        let rest = &self.bytes[self.at..self.bytes.len().min(HEADER_MAX)];
        let Some(length) = rest.iter().position(|&byte| byte == b'\n') else {
            let found = format!(
                "a header without `end_header` in its first {} bytes",
                self.at + rest.len()
            );
            return Err(FormatError::container(
                found,
                "a .ply file's header; the file is incomplete or something else",
            ));
        };
        self.at += length + 1;
        let line = rest[..length]
            .strip_suffix(b"\r")
            .unwrap_or(&rest[..length]);
        let text = String::from_utf8_lossy(line);
        let is_comment = text.starts_with("comment") || text.starts_with("obj_info");
        if matches!(text, Cow::Owned(_)) && !is_comment {
            return Err(wrong(&text, "text outside comments"));
        }
        Ok(text)
    }
}

/// Reads the header at the start of a file.
///
/// # Errors
/// When the file does not start with a `.ply` header, or the header does not tell where the
/// vertices are.
pub fn parse(bytes: &[u8]) -> Result<PlyHeader, FormatError> {
    let mut lines = HeaderLines { bytes, at: 0 };
    if !matches!(bytes, [b'p', b'l', b'y', b'\r' | b'\n', ..]) {
        return Err(FormatError::container(
            "a file that does not start with `ply`",
            "a .ply file",
        ));
    }
    lines.next_line()?;
    let mut encoding = None;
    let mut up = None;
    let mut elements = Vec::<ElementHeader>::new();
    loop {
        let line = &*lines.next_line()?;
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        match words.as_slice() {
            ["end_header"] => break,
            ["format", name, "1.0"] => encoding = Some(format(name)?),
            ["comment", ..] | ["obj_info", ..] | [] => up = up.or_else(|| parse_up(line)),
            ["element", name, count] => {
                let count = count
                    .parse()
                    .map_err(|_| wrong(line, "`element NAME COUNT`"))?;
                elements.push(ElementHeader {
                    name: (*name).into(),
                    count,
                    ..ElementHeader::default()
                });
            }
            ["property", kind @ .., name] => property(elements.last_mut(), kind, name, line)?,
            _ => return Err(wrong(line, "a line that .ply headers have")),
        }
    }
    let encoding = encoding.ok_or_else(|| {
        FormatError::container(
            "a header without a format",
            "`format binary_little_endian 1.0`",
        )
    })?;
    places(elements, encoding, lines.at, up)
}

/// An error about a line of the header.
fn wrong(line: &str, expected: &str) -> FormatError {
    FormatError::container(format!("`{}` in the header", excerpt(line)), expected)
}

/// The encoding of a name in the `format` line.
fn format(name: &str) -> Result<Encoding, FormatError> {
    match name {
        "ascii" => Ok(Encoding::Ascii),
        "binary_little_endian" => Ok(Encoding::Little),
        "binary_big_endian" => Ok(Encoding::Big),
        _ => Err(wrong(
            name,
            "ascii, binary_little_endian or binary_big_endian",
        )),
    }
}

/// The axis that a comment names.
fn parse_up(line: &str) -> Option<Up> {
    Up::from_name(
        line.trim()
            .strip_prefix("comment")?
            .trim()
            .strip_prefix(UP_COMMENT)?
            .trim(),
    )
}

/// Adds a property to the last element.
fn property(
    element: Option<&mut ElementHeader>,
    kind: &[&str],
    name: &str,
    line: &str,
) -> Result<(), FormatError> {
    let element = element.ok_or_else(|| wrong(line, "an element before its properties"))?;
    if let ["list", ..] = kind {
        element.list.get_or_insert_with(|| name.into());
        return Ok(());
    }
    let [kind] = kind else {
        return Err(wrong(line, "`property TYPE NAME`"));
    };
    let kind = Scalar::parse(kind).ok_or_else(|| wrong(line, "a number's type, such as float"))?;
    if element
        .properties
        .iter()
        .any(|property| property.name == name)
    {
        return Err(wrong(line, "properties that differ in name"));
    }
    element.properties.push(Property {
        name: name.into(),
        kind,
        offset: element.row,
    });
    element.row += kind.bytes();
    Ok(())
}

/// Finds the elements that are read. What follows the vertices is skipped unless it is harmonics.
fn places(
    elements: Vec<ElementHeader>,
    encoding: Encoding,
    end: usize,
    up: Option<Up>,
) -> Result<PlyHeader, FormatError> {
    let text = encoding == Encoding::Ascii;
    let mut before = 0u64;
    let [mut vertices, mut chunks, mut harmonics] = [None, None, None];
    for mut element in elements {
        if let Some(list) = element.unsized_list(text) {
            // Nothing behind a list of unknown length can be found.
            if vertices.is_some() {
                break;
            }
            let found = format!(
                "the list `{}` of the element `{}`",
                excerpt(list),
                excerpt(&element.name)
            );
            return Err(FormatError::container(
                found,
                "elements of plain numbers up to the vertices, as 3DGS writes them",
            ));
        }
        let after = element
            .length(text)
            .and_then(|length| length.checked_add(before));
        let place = match element.name.as_str() {
            "vertex" => Some(&mut vertices),
            "chunk" => Some(&mut chunks),
            "sh" => Some(&mut harmonics),
            _ => None,
        };
        if let Some(place) = place {
            place.get_or_insert_with(|| element.take_layout(text, before));
        }
        match after {
            Some(after) => before = after,
            None if vertices.is_some() => break,
            None => {
                return Err(FormatError::container(
                    format!("{} of `{}`", element.count, excerpt(&element.name)),
                    "a number that a file can hold",
                ));
            }
        }
    }
    Ok(PlyHeader {
        encoding,
        end,
        up,
        vertices: vertices.ok_or_else(|| {
            FormatError::container("a header without an element `vertex`", "a 3DGS .ply file")
        })?,
        chunks,
        harmonics,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header(text: &str) -> Result<PlyHeader, String> {
        parse(text.as_bytes()).map_err(|fault| fault.to_string())
    }

    #[test]
    fn properties_stand_where_the_header_puts_them() {
        let text = "ply\r\nformat binary_big_endian 1.0\r\ncomment effigy up -y\r\nelement thing 3\r\nproperty double a\r\n\
                    element vertex 2\r\nproperty uchar u\r\nproperty float x\r\nelement face 1\r\nproperty list uchar int i\r\nend_header\r\n";
        let header = header(text).unwrap();
        assert_eq!(
            (
                header.encoding,
                header.vertices.count,
                header.vertices.row,
                header.vertices.before
            ),
            (Encoding::Big, 2, 5, 24)
        );
        assert_eq!((header.end, header.up), (text.len(), Some(Up::MinusY)));
        assert_eq!(
            header.vertices.properties[1],
            Property {
                name: "x".into(),
                kind: Scalar::F32,
                offset: 1
            }
        );
    }

    #[test]
    fn each_fault_is_named() {
        let cases = [
            ("obj\n", "found a file that does not start with `ply`"),
            (
                "ply\nformat ascii 1.0\n",
                "found a header without `end_header` in its first 21 bytes",
            ),
            ("ply\nend_header\n", "found a header without a format"),
            (
                "ply\nformat ascii 1.0\nend_header\n",
                "found a header without an element `vertex`",
            ),
            (
                "ply\nformat ascii 2.0\n",
                "found `format ascii 2.0` in the header",
            ),
            (
                "ply\nformat middle 1.0\n",
                "found `middle` in the header, expected ascii",
            ),
            (
                "ply\nproperty float x\n",
                "found `property float x` in the header, expected an element",
            ),
            (
                "ply\nelement vertex -1\n",
                "found `element vertex -1` in the header",
            ),
            (
                "ply\nelement vertex 1\nproperty half x\n",
                "found `property half x` in the header, expected a number's type",
            ),
            (
                "ply\nelement vertex 1\nproperty float x\nproperty int x\n",
                "found `property int x` in the header, expected properties that",
            ),
            (
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar int x\nend_header\n",
                "found the list `x` of the element `vertex`",
            ),
            (
                "ply\nformat binary_little_endian 1.0\nelement a 18446744073709551615\nproperty int x\nelement vertex 1\nend_header\n",
                "found 18446744073709551615 of `a`",
            ),
        ];
        for (text, expected) in cases {
            let found = header(text).map(|_| ()).unwrap_err();
            assert!(found.starts_with(expected), "{text:?}: {found}");
        }
        let endless = format!("ply\n{}", "comment x\n".repeat(20_000));
        assert!(
            header(&endless)
                .unwrap_err()
                .starts_with("found a header without `end_header` in its first 655")
        );
    }
}
