//! Arrays with names, of an archive or of a pickle's dictionary.

use crate::{
    npz::Npz,
    pickle::{Numbers, Value},
};
use effigy_core::io::file::FormatError;

/// Arrays with names.
pub enum Fields<'p> {
    Archive(Npz),
    Dictionary(Value<'p>),
}

/// Rows of numbers.
#[derive(Clone, Debug)]
pub struct Table {
    pub width: usize,
    /// Shape: rows, width.
    pub numbers: Vec<f32>,
}

impl Table {
    pub fn rows(&self) -> usize {
        self.numbers.len() / self.width
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
            Self::Archive(npz) => npz.has(name),
            Self::Dictionary(value) => value.get(name).is_some(),
        }
    }

    /// What there is, for messages.
    pub fn describe(&self) -> String {
        match self {
            Self::Archive(npz) => {
                let names: Vec<&str> = npz.names().collect();
                format!("arrays {}", names.join(", "))
            }
            Self::Dictionary(value) => value.describe(),
        }
    }

    fn numbers(&mut self, name: &str) -> Result<Option<Numbers>, FormatError> {
        if !self.has(name) {
            return Ok(None);
        }
        match self {
            Self::Archive(npz) => {
                let array = npz.take(name)?;
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

    /// An array as rows of its last dimension, of at most some numbers; None where there is no such
    /// array, or it is empty.
    pub fn rows(&mut self, name: &str, max: usize) -> Result<Option<Table>, FormatError> {
        let Some(array) = self.numbers(name)? else {
            return Ok(None);
        };
        let width = array.shape.last().copied().unwrap_or_default();
        if array.numbers.is_empty() {
            return Ok(None);
        }
        if width > max {
            return Err(FormatError::metadata(
                name,
                format!("the shape {:?}", array.shape),
                format!("rows of at most {max} numbers"),
            ));
        }
        Ok(Some(Table {
            width,
            numbers: array.numbers,
        }))
    }

    /// An array as rows that have one of some widths, its last dimensions; None where there is no
    /// such array.
    pub fn table(&mut self, name: &str, widths: &[usize]) -> Result<Option<Table>, FormatError> {
        let Some(array) = self.numbers(name)? else {
            return Ok(None);
        };
        let mut width = 1usize;
        let mut trailing = array.shape.iter().rev().map(|&size| {
            width = width.saturating_mul(size);
            width
        });
        match trailing.find(|width| widths.contains(width)) {
            Some(width) if !array.numbers.is_empty() => Ok(Some(Table {
                width,
                numbers: array.numbers,
            })),
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
