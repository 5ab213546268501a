//! Arrays with names, of an archive or of a pickle's dictionary.

use crate::{
    npz::{self, Array, Npz},
    pickle::{Numbers, Value},
};
use effigy_core::io::file::{FormatError, excerpt};

/// Bytes that any archive may unpack to: what a small one of a motion would be takes much more
/// memory as a capture.
pub const SMALL: u64 = 8 << 20;
/// Arrays of an archive that an error names.
const NAMED: usize = 12;

/// Arrays with names.
pub enum Fields<'p> {
    Archive {
        arrays: Npz,
        /// The file.
        bytes: &'p [u8],
    },
    Dictionary(Value<'p>),
}

/// The arrays of an archive and their shapes, for messages.
pub fn describe_archive(bytes: &[u8]) -> String {
    let names = npz::names(bytes).unwrap_or_default();
    let mut members = npz::members(bytes, SMALL, |_| true).unwrap_or_default();
    let shown = names.iter().take(NAMED).map(|name| {
        let member = members.remove(name);
        let array = member.and_then(|member| Array::from_npy(name, member).ok());
        match array {
            Some(array) => format!("{} {:?}", excerpt(name), array.shape()),
            None => excerpt(name),
        }
    });
    let shown: Vec<String> = shown.collect();
    format!("{} arrays: {}", names.len(), shown.join(", "))
}

/// Rows of numbers.
#[derive(Clone, Debug)]
pub struct Table {
    pub width: usize,
    /// Shape: people, rows, width.
    pub numbers: Vec<f32>,
    /// More than one: each has as many rows.
    pub people: usize,
}

impl Table {
    /// Rows of the last dimensions of an array, `last` of them with `width` numbers in all. Of those
    /// before, the last but ones of 1 counts frames.
    fn new(array: Numbers, last: usize, width: usize) -> Self {
        let before = &array.shape[..array.shape.len() - last];
        let mut sizes = before.iter().filter(|size| **size != 1);
        sizes.next_back();
        Self {
            width,
            people: sizes.product(),
            numbers: array.numbers,
        }
    }

    pub fn rows(&self) -> usize {
        self.numbers.len() / self.width
    }

    /// The rows of one of its people; the whole of a table that has one.
    pub fn of_person(&self, person: usize) -> Self {
        let each = self.numbers.len() / self.people;
        let start = if self.people == 1 { 0 } else { person * each };
        Self {
            width: self.width,
            numbers: self.numbers[start..][..each].to_vec(),
            people: 1,
        }
    }

    /// The first columns of every row.
    pub fn first(&self, columns: usize) -> Self {
        let rows = self.numbers.chunks_exact(self.width);
        Self {
            width: columns,
            numbers: rows.flat_map(|row| &row[..columns]).copied().collect(),
            people: self.people,
        }
    }

    /// A row; of a table of a single row, that one.
    pub fn row(&self, at: usize) -> &[f32] {
        let at = if self.rows() == 1 { 0 } else { at };
        &self.numbers[at * self.width..][..self.width]
    }
}

impl Fields<'_> {
    pub fn has(&self, name: &str) -> bool {
        match self {
            Self::Archive { arrays, .. } => arrays.has(name),
            Self::Dictionary(value) => value.get(name).is_some(),
        }
    }

    /// What there is, for messages.
    pub fn describe(&self) -> String {
        match self {
            Self::Archive { bytes, .. } => describe_archive(bytes),
            Self::Dictionary(value) => value.describe(),
        }
    }

    fn numbers(&mut self, name: &str) -> Result<Option<Numbers>, FormatError> {
        if !self.has(name) {
            return Ok(None);
        }
        match self {
            Self::Archive { arrays, .. } => {
                let array = arrays.take(name)?;
                Ok(Some(Numbers {
                    shape: array.shape().to_vec(),
                    numbers: array.floats()?,
                }))
            }
            Self::Dictionary(value) => match value.get(name) {
                Some(value) => numbers_of(value, name).map(Some),
                None => Ok(None),
            },
        }
    }

    /// A single number; None where there is no such array.
    pub fn number(&mut self, name: &str) -> Result<Option<f64>, FormatError> {
        let numbers = self.numbers(name)?;
        Ok(numbers.and_then(|array| array.numbers.first().copied().map(f64::from)))
    }

    /// An array as one column; None where there is no such array.
    pub fn column(&mut self, name: &str) -> Result<Option<Vec<f32>>, FormatError> {
        Ok(self.numbers(name)?.map(|array| array.numbers))
    }

    /// The first array of some names as rows of its last dimension, of at most some numbers; None
    /// where there is no such array, or it is empty.
    pub fn rows(&mut self, names: &[&str], max: usize) -> Result<Option<Table>, FormatError> {
        let Some(name) = self.find(names) else {
            return Ok(None);
        };
        let Some(array) = self.numbers(name)? else {
            return Ok(None);
        };
        let width = array.shape.last().copied().unwrap_or_default();
        if array.numbers.is_empty() {
            return Ok(None);
        }
        if !(1..=max).contains(&width) {
            return Err(FormatError::metadata(
                name,
                format!("the shape {:?}", array.shape),
                format!("rows of at most {max} numbers"),
            ));
        }
        Ok(Some(Table::new(array, 1, width)))
    }

    /// The first of some names that there is an array of.
    pub fn find<'n>(&self, names: &[&'n str]) -> Option<&'n str> {
        names.iter().copied().find(|name| self.has(name))
    }

    /// The first array of some names as rows that have one of some widths, its last dimensions; None
    /// where there is no such array.
    pub fn table(
        &mut self,
        names: &[&str],
        widths: &[usize],
    ) -> Result<Option<Table>, FormatError> {
        let Some(name) = self.find(names) else {
            return Ok(None);
        };
        let Some(array) = self.numbers(name)? else {
            return Ok(None);
        };
        let mut width = 1usize;
        let mut trailing = array.shape.iter().rev().map(|&size| {
            width = width.saturating_mul(size);
            width
        });
        match trailing.position(|width| widths.contains(&width)) {
            Some(last) if !array.numbers.is_empty() => Ok(Some(Table::new(array, last + 1, width))),
            _ => Err(FormatError::metadata(
                name,
                format!("the shape {:?}", array.shape),
                format!("rows of one of {widths:?} numbers"),
            )),
        }
    }
}

/// An array, or a list of arrays of one shape in one.
fn numbers_of(value: Value, name: &str) -> Result<Numbers, FormatError> {
    let first = value.items().and_then(|mut items| items.next());
    let shape = first.and_then(|first| first.shape());
    let (Some(items), Some(shape)) = (value.items(), shape) else {
        return value.numbers(name);
    };
    let mut all = Numbers {
        shape: [&[items.len()], shape].concat(),
        numbers: vec![],
    };
    for item in items {
        let part = item.numbers(name)?;
        // An array that stands in a list again and again is not worth more than the file.
        if all.numbers.len() + part.numbers.len() > value.most_numbers() {
            return Err(FormatError::metadata(
                name,
                "more numbers than its file holds",
                "each array once",
            ));
        }
        if part.shape != shape {
            return Err(FormatError::metadata(
                name,
                format!("the shape {:?}", part.shape),
                format!("{shape:?}, as the others have"),
            ));
        }
        all.numbers.extend(part.numbers);
    }
    Ok(all)
}
