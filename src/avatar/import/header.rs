//! The text at the start of a `.ply` file: bytes go in, where each property of a vertex stands comes out, or what is wrong.

use super::Up;
use crate::avatar::file::{Fault, clip};

/// The longest header that is read, bytes: 3DGS writes 1.5 KB.
const HEADER_MAX: usize = 64 << 10;
/// A comment that says which axis points up; [`crate::avatar::export`] writes it.
pub const UP_COMMENT: &str = "effigy up";

/// How the numbers after the header are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    Ascii,
    Little,
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

    pub fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

/// A number of a vertex.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Property {
    pub name: String,
    pub kind: Scalar,
    /// Bytes from the start of the vertex; its number among the vertex's properties in text.
    pub offset: usize,
}

/// An element as the header declares it.
#[derive(Debug, Default)]
struct Element {
    name: String,
    count: u64,
    properties: Vec<Property>,
    /// Name of a property of varying length.
    list: Option<String>,
    /// Bytes of one.
    row: usize,
}

/// What a header says of the vertices.
#[derive(Debug)]
pub struct Header {
    pub encoding: Encoding,
    pub count: u64,
    pub properties: Vec<Property>,
    /// Bytes of a vertex, where it is not text.
    pub row: usize,
    /// Where the header ends, bytes.
    pub end: usize,
    /// What stands between the header and the vertices: bytes, or lines of text.
    pub before: u64,
    /// The file's own word on which axis points up.
    pub up: Option<Up>,
}

/// The lines of a header.
struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Result<&'a str, Fault> {
        let rest = &self.bytes[self.at..self.bytes.len().min(HEADER_MAX)];
        let Some(length) = rest.iter().position(|&byte| byte == b'\n') else {
            let found = format!("a header without `end_header` in its first {} bytes", self.at + rest.len());
            return Err(Fault::container(found, "a .ply file's header; the file is incomplete or something else"));
        };
        self.at += length + 1;
        let line = rest[..length].strip_suffix(b"\r").unwrap_or(&rest[..length]);
        std::str::from_utf8(line).map_err(|_| Fault::container("a header with bytes that are no text", "a .ply file's header"))
    }
}

/// Reads the header at the start of a file.
///
/// # Errors
/// When it is no header of a `.ply` file, or one whose vertices can't be found or told apart.
pub fn parse(bytes: &[u8]) -> Result<Header, Fault> {
    let mut lines = Lines { bytes, at: 0 };
    if !matches!(bytes, [b'p', b'l', b'y', b'\r' | b'\n', ..]) {
        return Err(Fault::container("a file that does not start with `ply`", "a .ply file"));
    }
    lines.next()?;
    let (mut encoding, mut up, mut elements) = (None, None, Vec::<Element>::new());
    loop {
        let line = lines.next()?;
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        match words.as_slice() {
            ["end_header"] => break,
            ["format", name, "1.0"] => encoding = Some(format(name)?),
            ["comment", ..] | ["obj_info", ..] | [] => up = up.or_else(|| comment(line)),
            ["element", name, count] => {
                let count = count.parse().map_err(|_| wrong(line, "`element NAME COUNT`"))?;
                elements.push(Element { name: (*name).into(), count, ..Element::default() });
            }
            ["property", kind @ .., name] => property(elements.last_mut(), kind, name, line)?,
            _ => return Err(wrong(line, "a line that .ply headers have")),
        }
    }
    let encoding = encoding.ok_or_else(|| Fault::container("a header without a format", "`format binary_little_endian 1.0`"))?;
    vertices(elements, encoding, lines.at, up)
}

fn wrong(line: &str, expected: &str) -> Fault {
    Fault::container(format!("`{}` in the header", clip(line)), expected)
}

fn format(name: &str) -> Result<Encoding, Fault> {
    match name {
        "ascii" => Ok(Encoding::Ascii),
        "binary_little_endian" => Ok(Encoding::Little),
        "binary_big_endian" => Ok(Encoding::Big),
        _ => Err(wrong(name, "ascii, binary_little_endian or binary_big_endian")),
    }
}

fn comment(line: &str) -> Option<Up> {
    Up::parse(line.trim().strip_prefix("comment")?.trim().strip_prefix(UP_COMMENT)?.trim())
}

fn property(element: Option<&mut Element>, kind: &[&str], name: &str, line: &str) -> Result<(), Fault> {
    let element = element.ok_or_else(|| wrong(line, "an element before its properties"))?;
    if let ["list", ..] = kind {
        element.list.get_or_insert_with(|| name.into());
        return Ok(());
    }
    let [kind] = kind else { return Err(wrong(line, "`property TYPE NAME`")) };
    let kind = Scalar::parse(kind).ok_or_else(|| wrong(line, "a number's type, such as float"))?;
    if element.properties.iter().any(|property| property.name == name) {
        return Err(wrong(line, "properties that differ in name"));
    }
    element.properties.push(Property { name: name.into(), kind, offset: element.row });
    element.row += kind.bytes();
    Ok(())
}

/// Finds the vertices among the elements.
fn vertices(elements: Vec<Element>, encoding: Encoding, end: usize, up: Option<Up>) -> Result<Header, Fault> {
    let text = encoding == Encoding::Ascii;
    let mut before = 0u64;
    for element in elements {
        let list = element.list.as_deref().filter(|_| element.name == "vertex" || !text);
        if let Some(list) = list {
            let found = format!("the list `{}` of the element `{}`", clip(list), clip(&element.name));
            return Err(Fault::container(found, "elements of plain numbers up to the vertices, as 3DGS writes them"));
        }
        if element.name == "vertex" {
            let Element { count, mut properties, row, .. } = element;
            if text {
                properties.iter_mut().enumerate().for_each(|(at, property)| property.offset = at);
            }
            return Ok(Header { encoding, count, properties, row, end, before, up });
        }
        let size = if text { Some(element.count) } else { element.count.checked_mul(element.row as u64) };
        before = size
            .and_then(|size| size.checked_add(before))
            .ok_or_else(|| Fault::container(format!("{} of `{}`", element.count, clip(&element.name)), "a number that a file can hold"))?;
    }
    Err(Fault::container("a header without an element `vertex`", "a 3DGS .ply file"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header(text: &str) -> Result<Header, String> {
        parse(text.as_bytes()).map_err(|fault| fault.to_string())
    }

    #[test]
    fn properties_stand_where_the_header_puts_them() {
        let text = "ply\r\nformat binary_big_endian 1.0\r\ncomment effigy up -y\r\nelement thing 3\r\nproperty double a\r\n\
                    element vertex 2\r\nproperty uchar u\r\nproperty float x\r\nelement face 1\r\nproperty list uchar int i\r\nend_header\r\n";
        let header = header(text).unwrap();
        assert_eq!((header.encoding, header.count, header.row, header.before), (Encoding::Big, 2, 5, 24));
        assert_eq!((header.end, header.up), (text.len(), Some(Up::MinusY)));
        assert_eq!(header.properties[1], Property { name: "x".into(), kind: Scalar::F32, offset: 1 });
    }

    #[test]
    fn each_fault_is_named() {
        let cases = [
            ("obj\n", "found a file that does not start with `ply`"),
            ("ply\nformat ascii 1.0\n", "found a header without `end_header` in its first 21 bytes"),
            ("ply\nend_header\n", "found a header without a format"),
            ("ply\nformat ascii 1.0\nend_header\n", "found a header without an element `vertex`"),
            ("ply\nformat ascii 2.0\n", "found `format ascii 2.0` in the header"),
            ("ply\nformat middle 1.0\n", "found `middle` in the header, expected ascii"),
            ("ply\nproperty float x\n", "found `property float x` in the header, expected an element"),
            ("ply\nelement vertex -1\n", "found `element vertex -1` in the header"),
            ("ply\nelement vertex 1\nproperty half x\n", "found `property half x` in the header, expected a number's type"),
            ("ply\nelement vertex 1\nproperty float x\nproperty int x\n", "found `property int x` in the header, expected properties that"),
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
        assert!(header(&endless).unwrap_err().starts_with("found a header without `end_header` in its first 655"));
    }
}
