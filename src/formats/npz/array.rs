//! An array of numbers.

use super::{element::Kind, header::Header};
use crate::fault::tensor;
use effigy_core::io::file::FormatError;
use half::f16;

/// An array of an archive.
#[derive(Clone, Debug)]
pub struct Array {
    name: String,
    header: Header,
    /// The whole `.npy` file.
    bytes: Vec<u8>,
}

impl Array {
    /// Reads a `.npy` file. `name`: for errors.
    ///
    /// # Errors
    /// When it is none, or has fewer or more numbers than its shape says.
    pub fn from_npy(name: &str, bytes: Vec<u8>) -> Result<Self, FormatError> {
        let header =
            Header::parse(&bytes).map_err(|fault| tensor(name, fault.found, fault.expected))?;
        let length = header
            .count()
            .and_then(|count| count.checked_mul(header.element.size));
        let found = bytes.len() - header.start;
        if length != Some(found) {
            return Err(tensor(
                name,
                format!("{found} bytes of numbers"),
                format!("as many as the shape {:?} needs", header.shape),
            ));
        }
        Ok(Self {
            name: name.into(),
            header,
            bytes,
        })
    }

    /// Its name in the archive.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Bytes of its file.
    pub fn bytes(&self) -> usize {
        self.bytes.len()
    }

    /// Its dimensions.
    pub fn shape(&self) -> &[usize] {
        &self.header.shape
    }

    /// Fails unless it has these dimensions.
    ///
    /// # Errors
    /// When it has others.
    pub fn expect_shape(&self, shape: &[usize]) -> Result<(), FormatError> {
        if self.shape() == shape {
            return Ok(());
        }
        Err(tensor(
            &self.name,
            format!("the shape {:?}", self.shape()),
            format!("{shape:?}"),
        ))
    }

    /// A dimension.
    ///
    /// # Errors
    /// When it has fewer.
    pub fn dimension(&self, at: usize) -> Result<usize, FormatError> {
        self.shape().get(at).copied().ok_or_else(|| {
            let found = format!("the shape {:?}", self.shape());
            tensor(&self.name, found, format!("at least {} dimensions", at + 1))
        })
    }

    /// The bytes of each number, in C order.
    fn elements(&self) -> impl Iterator<Item = &[u8]> {
        let size = self.header.element.size;
        let numbers = &self.bytes[self.header.start..];
        let order = Indices::new(&self.header);
        order.map(move |at| &numbers[at * size..][..size])
    }

    /// The numbers as floats; integers are converted.
    ///
    /// # Errors
    /// When one is not finite.
    pub fn floats(&self) -> Result<Vec<f32>, FormatError> {
        let element = self.header.element;
        let numbers: Vec<f32> = self
            .elements()
            .map(|bytes| element.float(bytes) as f32)
            .collect();
        match numbers.iter().position(|number| !number.is_finite()) {
            Some(at) => Err(tensor(
                &self.name,
                format!("{} at {at}", numbers[at]),
                "finite numbers",
            )),
            None => Ok(numbers),
        }
    }

    /// The numbers as they are, NaN and infinity among them; integers are converted.
    pub fn numbers(&self) -> Vec<f64> {
        let element = self.header.element;
        self.elements().map(|bytes| element.float(bytes)).collect()
    }

    /// The numbers rounded to f16.
    ///
    /// # Errors
    /// When one is not finite, or larger than f16 holds.
    pub fn halves(&self) -> Result<Vec<f16>, FormatError> {
        let element = self.header.element;
        let numbers: Vec<f16> = self
            .elements()
            .map(|bytes| f16::from_f64(element.float(bytes)))
            .collect();
        match numbers.iter().position(|number| !number.is_finite()) {
            Some(at) => Err(tensor(
                &self.name,
                format!("{} at {at}", numbers[at]),
                "finite numbers, at most 65504",
            )),
            None => Ok(numbers),
        }
    }

    /// The numbers as integers below `end`.
    ///
    /// # Errors
    /// When they are floats, negative or no smaller than that.
    pub fn integers(&self, end: usize) -> Result<Vec<u32>, FormatError> {
        let element = self.header.element;
        let fault = |found: String| tensor(&self.name, found, format!("integers below {end}"));
        if element.kind == Kind::Float {
            return Err(fault("floats".into()));
        }
        let mut numbers = Vec::with_capacity(self.bytes.len() / element.size);
        for (at, bytes) in self.elements().enumerate() {
            let number = element.integer(bytes);
            let small = u32::try_from(number).ok().filter(|&n| (n as usize) < end);
            numbers.push(small.ok_or_else(|| fault(format!("{number} at {at}")))?);
        }
        Ok(numbers)
    }
}

/// Where in an array's memory its numbers are, in C order.
struct Indices {
    /// Of each dimension from the last: its size, and how far apart neighbours are.
    axes: Vec<ArrayAxis>,
    left: usize,
    at: usize,
}

struct ArrayAxis {
    size: usize,
    stride: usize,
    index: usize,
}

impl Indices {
    fn new(header: &Header) -> Self {
        let left = header.count().unwrap_or_default();
        if !header.fortran {
            // The memory is in C order.
            let axis = ArrayAxis {
                size: left,
                stride: 1,
                index: 0,
            };
            return Self {
                axes: vec![axis],
                left,
                at: 0,
            };
        }
        let mut stride = 1;
        let mut axes: Vec<ArrayAxis> = Vec::new();
        for &size in &header.shape {
            axes.push(ArrayAxis {
                size,
                stride,
                index: 0,
            });
            stride *= size;
        }
        axes.reverse();
        Self { axes, left, at: 0 }
    }
}

impl Iterator for Indices {
    type Item = usize;

    fn next(&mut self) -> Option<usize> {
        self.left = self.left.checked_sub(1)?;
        let at = self.at;
        for axis in &mut self.axes {
            axis.index += 1;
            self.at += axis.stride;
            if axis.index < axis.size {
                break;
            }
            self.at -= axis.stride * axis.size;
            axis.index = 0;
        }
        Some(at)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.left, Some(self.left))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn npy(descr: &str, fortran: bool, shape: &str, numbers: &[u8]) -> Vec<u8> {
        let order = if fortran { "True" } else { "False" };
        let text = format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}");
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend((text.len() as u16).to_le_bytes());
        bytes.extend(text.bytes());
        bytes.extend(numbers);
        bytes
    }

    fn array(descr: &str, fortran: bool, shape: &str, numbers: &[u8]) -> Array {
        Array::from_npy("a", npy(descr, fortran, shape, numbers)).expect("an array")
    }

    #[test]
    fn numbers_of_every_width_and_byte_order_are_read() {
        let halves = [0x3c00u16, 0xc000].map(u16::to_le_bytes).concat();
        assert_eq!(
            array("<f2", false, "(2,)", &halves).floats(),
            Ok(vec![1.0, -2.0])
        );
        let doubles = [0.5f64, 3.0].map(f64::to_be_bytes).concat();
        assert_eq!(
            array(">f8", false, "(2,)", &doubles).floats(),
            Ok(vec![0.5, 3.0])
        );
        let long = (-3i64).to_le_bytes();
        assert_eq!(array("<i8", false, "(1,)", &long).floats(), Ok(vec![-3.0]));
        let short = 513u16.to_le_bytes();
        assert_eq!(
            array("<u2", false, "()", &short).integers(514),
            Ok(vec![513])
        );
        let negative = array("<i8", false, "(1,)", &long).integers(9);
        assert!(negative.is_err_and(|error| error.to_string().contains("-3 at 0")));
    }

    #[test]
    fn an_array_in_fortran_order_is_turned() {
        let numbers: Vec<u8> = (0..12).collect();
        let turned = array("|u1", true, "(2, 3, 2)", &numbers).integers(12);
        assert_eq!(turned, Ok(vec![0, 6, 2, 8, 4, 10, 1, 7, 3, 9, 5, 11]));
    }

    #[test]
    fn wrong_lengths_and_numbers_are_faults() {
        let short = Array::from_npy("a", npy("<f4", false, "(2,)", &[0; 7]));
        assert!(short.is_err_and(|error| error.to_string().contains("7 bytes")));
        let nan = array("<f4", false, "(1,)", &f32::NAN.to_le_bytes());
        assert!(nan.floats().is_err() && nan.halves().is_err());
        let large = array("<f4", false, "(1,)", &1e6f32.to_le_bytes());
        assert!(
            large
                .halves()
                .is_err_and(|error| error.to_string().contains("inf at 0"))
        );
    }
}
