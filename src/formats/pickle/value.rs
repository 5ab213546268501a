//! Looking at what a pickle holds.

use super::node::{Arena, ArrayNode, Node, Ref};
use crate::npz::Kind;
use effigy_core::io::file::{FormatError, excerpt};
use std::ops::Range;

/// A value of a pickle.
#[derive(Clone, Copy)]
pub struct Value<'p> {
    nodes: &'p Arena<'p>,
    at: Ref,
}

/// Numbers of an array, in C order.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers {
    /// Dimensions.
    pub shape: Vec<usize>,
    /// Shape: the product of the dimensions.
    pub numbers: Vec<f32>,
}

impl<'p> Value<'p> {
    pub(super) fn new(nodes: &'p Arena<'p>, at: Ref) -> Self {
        Self { nodes, at }
    }

    fn at(self, at: Ref) -> Self {
        Self { at, ..self }
    }

    fn array(self) -> Option<&'p ArrayNode> {
        match self.nodes.get(self.at) {
            Node::Array(array) => Some(array),
            _ => None,
        }
    }

    /// The value, or the one that an array of a single object holds: NumPy puts a dictionary into
    /// one to save it.
    pub fn inside(self) -> Self {
        let inner = self.array().filter(|array| array.element.is_none());
        let list = inner.and_then(|array| self.nodes.list(array.data));
        match list {
            Some(&[only]) => self.at(only),
            _ => self,
        }
    }

    /// The value of a key of a dictionary.
    pub fn get(self, key: &str) -> Option<Self> {
        let Node::Dict(entries) = self.nodes.get(self.at) else {
            return None;
        };
        // A key that comes again replaces the value.
        let entry = entries
            .iter()
            .rev()
            .find(|entry| self.nodes.text(entry.key) == Some(key))?;
        Some(self.at(entry.value))
    }

    /// The values of a dictionary in its order; None where it is none.
    pub fn values(self) -> Option<impl ExactSizeIterator<Item = Self>> {
        let Node::Dict(entries) = self.nodes.get(self.at) else {
            return None;
        };
        Some(entries.iter().map(move |entry| self.at(entry.value)))
    }

    /// The keys of a dictionary in its order; None where it is none.
    pub fn keys(self) -> Option<impl ExactSizeIterator<Item = Self>> {
        let Node::Dict(entries) = self.nodes.get(self.at) else {
            return None;
        };
        Some(entries.iter().map(move |entry| self.at(entry.key)))
    }

    /// The items of a list, a tuple or an array of objects; None where it is none of them.
    pub fn items(self) -> Option<impl ExactSizeIterator<Item = Self>> {
        let list = match self.array() {
            Some(array) if array.element.is_none() => self.nodes.list(array.data)?,
            _ => self.nodes.list(self.at)?,
        };
        Some(list.iter().map(move |&at| self.at(at)))
    }

    /// The text that it is.
    pub fn text(self) -> Option<&'p str> {
        self.nodes.text(self.at)
    }

    /// The number that it is, or that an array of one number has.
    pub fn number(self) -> Option<f64> {
        match self.nodes.get(self.at) {
            Node::Bool(yes) => Some(f64::from(u8::from(*yes))),
            Node::Int(number) => Some(*number as f64),
            Node::Float(number) => Some(*number),
            Node::Array(_) => match self.numbers("a number") {
                Ok(array) if array.numbers.len() == 1 => Some(array.numbers[0].into()),
                _ => None,
            },
            _ => None,
        }
    }

    /// The dimensions of an array of numbers.
    pub fn shape(self) -> Option<&'p [usize]> {
        let array = self.array().filter(|array| array.element.is_some());
        array.map(|array| &array.shape[..])
    }

    /// The numbers of an array or tensor, or of a list of numbers. `name`: for errors.
    ///
    /// # Errors
    /// When it is none, one is not finite, or its shape needs more numbers than it has.
    pub fn numbers(self, name: &str) -> Result<Numbers, FormatError> {
        self.read(name, None)
    }

    /// The numbers of some rows of an array or tensor: of a range of its first dimension. `name`:
    /// for errors.
    ///
    /// # Errors
    /// Those of [`Self::numbers`]; when there are fewer rows.
    pub fn rows(self, name: &str, rows: Range<usize>) -> Result<Numbers, FormatError> {
        self.read(name, Some(rows))
    }

    fn read(self, name: &str, rows: Option<Range<usize>>) -> Result<Numbers, FormatError> {
        let fault = |found: &str| FormatError::metadata(name, found, "an array of finite numbers");
        let Some(array) = self.array() else {
            let list = self.nodes.list(self.at);
            let list = list.ok_or_else(|| fault(&self.describe()))?;
            let numbers = list.iter().map(|&at| match *self.nodes.get(at) {
                Node::Int(number) => Some(number as f32),
                Node::Float(number) => Some(number as f32).filter(|number| number.is_finite()),
                _ => None,
            });
            let numbers: Option<Vec<f32>> = numbers.collect();
            let numbers = numbers.ok_or_else(|| fault("a list of something else"))?;
            return Ok(Numbers {
                shape: vec![numbers.len()],
                numbers,
            });
        };
        let element = array
            .element
            .ok_or_else(|| fault("an array of objects or text"))?;
        let bytes = self.nodes.bytes(array.data);
        let bytes = bytes.ok_or_else(|| fault("an array without its memory"))?;
        let held = bytes.len() / element.size;
        let shape = match (&rows, &array.shape[..]) {
            (None, shape) => shape.to_vec(),
            (Some(rows), [all, row @ ..]) if rows.start <= rows.end && rows.end <= *all => {
                [&[rows.len()], row].concat()
            }
            (Some(rows), shape) => {
                return Err(fault(&format!("the shape {shape:?}, not {rows:?}")));
            }
        };
        let count = shape
            .iter()
            .try_fold(1usize, |n, &size| n.checked_mul(size));
        // No more than the memory holds, even where a tensor shows parts of it more than once.
        let count = count
            .filter(|&count| count <= held)
            .ok_or_else(|| fault(&format!("the shape {:?} of {held} numbers", array.shape)))?;
        let first = rows.map_or(0, |rows| {
            rows.start
                .saturating_mul(array.stride.first().copied().unwrap_or_default())
        });
        let mut numbers = Vec::with_capacity(count);
        let mut index = vec![0; shape.len()];
        for _ in 0..count {
            let steps = index.iter().zip(&array.stride);
            let place = steps.fold(
                array.start.saturating_add(first),
                |sum, (&index, &stride)| sum.saturating_add(stride.saturating_mul(index)),
            );
            let start = place.checked_mul(element.size);
            let number = start.and_then(|start| bytes.get(start..)?.get(..element.size));
            let number = element.float(number.ok_or_else(|| fault("numbers beyond its memory"))?);
            if !(number as f32).is_finite() {
                return Err(fault(&format!("{number} at {}", numbers.len())));
            }
            numbers.push(number as f32);
            for (index, &size) in index.iter_mut().zip(&shape).rev() {
                *index += 1;
                if *index < size {
                    break;
                }
                *index = 0;
            }
        }
        Ok(Numbers { shape, numbers })
    }

    /// Bytes of memory that an array of floats shows, each as often as it is shown. None: it is no
    /// array of floats.
    pub fn float_bytes(self) -> Option<u64> {
        let array = self.array()?;
        let element = array.element?;
        let is_float = matches!(element.kind, Kind::Float | Kind::Brain);
        let count = array
            .shape
            .iter()
            .try_fold(element.size as u64, |n, &size| n.checked_mul(size as u64));
        count.filter(|_| is_float)
    }

    /// Bytes of the file.
    pub fn file_bytes(self) -> u64 {
        self.nodes.size() as u64
    }

    /// How many numbers the arrays of the file have at most, two bytes each.
    pub fn most_numbers(self) -> usize {
        self.nodes.size() / 2
    }

    /// What it is, for messages.
    pub fn describe(self) -> String {
        match self.nodes.get(self.at) {
            Node::None => "None".into(),
            Node::Bool(_) | Node::Int(_) | Node::Long | Node::Float(_) => "a number".into(),
            Node::Text(text) => format!("the text `{}`", excerpt(text)),
            Node::Bytes(_) | Node::Decoded(_) => "bytes".into(),
            Node::List(_) | Node::Tuple(_) => "a list".into(),
            Node::Dict(entries) => {
                let name = |at| match self.at(at).text() {
                    Some(text) => excerpt(text),
                    None => self.at(at).number().map_or("?".into(), |n| n.to_string()),
                };
                let shape = |at| self.at(at).shape().map(|shape| format!(" {shape:?}"));
                let names = entries.iter().take(12).map(|entry| {
                    let shape = shape(entry.value).unwrap_or_default();
                    format!("{}{shape}", name(entry.key))
                });
                let names: Vec<String> = names.collect();
                format!("a dictionary of {}", names.join(", "))
            }
            Node::Global(_) | Node::Element(_) | Node::Stand => "a type".into(),
            Node::Inert => "an object".into(),
            Node::Empty => "an array without its numbers".into(),
            Node::Array(array) => format!("an array of the shape {:?}", array.shape),
            Node::Storage(_) => "a storage".into(),
        }
    }
}
