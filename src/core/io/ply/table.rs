//! The numbers of an element of a `.ply` file.

use super::header::{ElementLayout, Encoding, PlyHeader, Property, Scalar};
use crate::io::{
    assumption::Assumption,
    file::{FormatError, excerpt},
};
use std::{borrow::Cow, cell::RefCell};

/// Properties that say nothing of splats, though 3DGS writes them.
const EMPTY: [&str; 3] = ["nx", "ny", "nz"];
/// Properties of text that are kept in f64: map coordinates have more digits than f32.
const EXACT: [&str; 3] = ["x", "y", "z"];
/// Properties that a sentence names, at most.
const NAMED: usize = 12;

/// A property of all entries.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    kind: Scalar,
    offset: usize,
    /// The type that the header says, which in text is not how numbers are kept.
    pub declared: Scalar,
}

/// The entries of an element, from which any property of any entry can be read.
pub struct ElementTable<'a> {
    bytes: Cow<'a, [u8]>,
    row: usize,
    encoding: Encoding,
    properties: Vec<Property>,
    declared: Vec<Scalar>,
    /// Whether each property was looked for.
    asked: RefCell<Vec<bool>>,
    count: usize,
}

impl<'a> ElementTable<'a> {
    /// Finds an element's entries after the header. Text is converted to f32, positions to f64,
    /// which takes at most three times the file's size.
    ///
    /// # Errors
    /// When the file holds fewer entries than the header says.
    pub fn new(
        bytes: &'a [u8],
        header: &PlyHeader,
        element: &ElementLayout,
    ) -> Result<Self, FormatError> {
        let encoding = header.encoding;
        let mut properties = element.properties.clone();
        let declared = properties.iter().map(|property| property.kind).collect();
        let asked = RefCell::new(vec![false; properties.len()]);
        let count = usize::try_from(element.count).unwrap_or(usize::MAX);
        let body = &bytes[header.end..];
        let before = usize::try_from(element.before).unwrap_or(usize::MAX);
        if encoding == Encoding::Ascii {
            let mut row = 0;
            for property in &mut properties {
                let exact = EXACT.contains(&&*property.name);
                property.kind = if exact { Scalar::F64 } else { Scalar::F32 };
                property.offset = row;
                row += property.kind.bytes();
            }
            let bytes = Cow::Owned(text(body, before, count, &properties, row)?);
            return Ok(Self {
                bytes,
                row,
                encoding: Encoding::Little,
                properties,
                declared,
                asked,
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
            declared,
            asked,
            count,
        })
    }

    /// Number of entries.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there is a property of a name.
    pub fn has(&self, name: &str) -> bool {
        self.properties.iter().any(|property| property.name == name)
    }

    /// Finds a property by its name.
    pub fn column(&self, name: &str) -> Option<Column> {
        let mut properties = self.properties.iter();
        let at = properties.position(|property| property.name == name)?;
        self.asked.borrow_mut()[at] = true;
        let Property { kind, offset, .. } = self.properties[at];
        Some(Column {
            kind,
            offset,
            declared: self.declared[at],
        })
    }

    /// The names of all properties, for errors.
    pub fn names(&self) -> String {
        listed(self.properties.iter().map(|property| &*property.name))
    }

    /// Says which properties nobody has looked for; None: all were, or the others say nothing.
    pub fn passed_over(&self) -> Option<Assumption> {
        let asked = self.asked.borrow();
        let others = self.properties.iter().zip(&*asked);
        let others =
            others.filter(|(property, asked)| !**asked && !EMPTY.contains(&&*property.name));
        let names: Vec<&str> = others.map(|(property, _)| &*property.name).collect();
        (!names.is_empty()).then(|| Assumption {
            what: "columns",
            taken: format!("{} left out", listed(names.into_iter())),
            because: "they are none of 3DGS's".into(),
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

/// Names in a sentence: those that count up are one entry, such as `f_rest_0 to f_rest_44`.
fn listed<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let counter = |name: &str| -> Option<(usize, u64)> {
        let stem = name.trim_end_matches(|c: char| c.is_ascii_digit()).len();
        Some((stem, name[stem..].parse().ok()?))
    };
    let follows = |a: &str, b: &str| match (counter(a), counter(b)) {
        (Some((stem, k)), Some((other, next))) => {
            a[..stem] == b[..other] && Some(next) == k.checked_add(1)
        }
        _ => false,
    };
    let mut runs: Vec<[&str; 2]> = vec![];
    for name in names {
        match runs.last_mut() {
            Some([_, last]) if follows(last, name) => *last = name,
            _ => runs.push([name; 2]),
        }
    }
    let entry = |[first, last]: &[&str; 2]| match first == last {
        true => excerpt(first),
        false => format!("{} to {}", excerpt(first), excerpt(last)),
    };
    let mut entries: Vec<String> = runs.iter().take(NAMED).map(entry).collect();
    if runs.len() > NAMED {
        entries.push(format!("{} more", runs.len() - NAMED));
    }
    entries.join(", ")
}

/// The file ends after some of its vertices.
fn cut_off(found: usize, count: usize) -> FormatError {
    FormatError::container(
        format!("{found} vertices"),
        format!("{count} as the header says; the file is incomplete"),
    )
}

/// The numbers of `count` lines after the first `before`, little-endian and of the properties'
/// types, f32 or f64. `row`: their bytes in a line.
fn text(
    body: &[u8],
    before: usize,
    count: usize,
    properties: &[Property],
    row: usize,
) -> Result<Vec<u8>, FormatError> {
    // A number and its separator take at least two bytes.
    let max_numbers = body.len() / 2 + 1;
    if properties.len().max(1).saturating_mul(count) > max_numbers {
        return Err(cut_off(max_numbers / properties.len().max(1), count));
    }
    let expected = || format!("{} numbers", properties.len());
    let mut numbers = Vec::with_capacity(row * count);
    let full = |line: &&[u8]| !line.trim_ascii().is_empty();
    let mut lines = body.split(|&byte| byte == b'\n').filter(full).skip(before);
    for vertex in 0..count {
        let line = lines.next().ok_or_else(|| cut_off(vertex, count))?;
        let line = std::str::from_utf8(line)
            .map_err(|_| FormatError::container("bytes that are no text", "numbers"))?;
        let mut words = line.split_ascii_whitespace();
        for property in properties {
            let word = words.next().unwrap_or_default();
            let wrong = || {
                FormatError::container(
                    format!("`{}` in the line of vertex {vertex}", excerpt(word)),
                    expected(),
                )
            };
            if property.kind == Scalar::F64 {
                let number: f64 = word.parse().ok().or_else(|| odd(word)).ok_or_else(wrong)?;
                numbers.extend(number.to_le_bytes());
            } else {
                let odd = || odd(word).map(|number| number as f32);
                let number: f32 = word.parse().ok().or_else(odd).ok_or_else(wrong)?;
                numbers.extend(number.to_le_bytes());
            }
        }
        if let Some(word) = words.next() {
            let found = format!(
                "`{}` at the end of the line of vertex {vertex}",
                excerpt(word)
            );
            return Err(FormatError::container(found, expected()));
        }
    }
    Ok(numbers)
}

/// NaN and infinity as C libraries of other systems write them: `-nan(ind)`, `1.#QNAN`, `1.#INF`.
fn odd(word: &str) -> Option<f64> {
    let is_odd = word.contains("nan") || word.contains("NaN") || word.contains(".#");
    is_odd.then_some(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_count_up_are_one_entry() {
        let names = [
            "x", "f_rest_0", "f_rest_1", "f_rest_2", "t", "rot_2", "rot_4",
        ];
        let sentence = "x, f_rest_0 to f_rest_2, t, rot_2, rot_4";
        assert_eq!(listed(names.into_iter()), sentence);
        let many: Vec<String> = (0..20).map(|k| format!("a{}", 2 * k)).collect();
        let said = listed(many.iter().map(String::as_str));
        assert!(said.ends_with("a22, 8 more"), "{said}");
    }
}
