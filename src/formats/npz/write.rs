//! Writing of `.npz` archives, as `numpy.savez_compressed` does.

use half::f16;
use std::io::{Cursor, Write};
use zip::{CompressionMethod, ZipWriter, result::ZipError, write::SimpleFileOptions};

/// An archive under way, in memory.
pub struct NpzWriter {
    zip: ZipWriter<Cursor<Vec<u8>>>,
}

/// Numbers that an array can hold.
pub trait Number: Copy {
    /// The type as NumPy writes it.
    const DESCR: &'static str;
    /// Appends the number's bytes, lowest first.
    fn write(self, bytes: &mut Vec<u8>);
}

macro_rules! number {
    ($type:ty, $descr:literal) => {
        impl Number for $type {
            const DESCR: &'static str = $descr;
            fn write(self, bytes: &mut Vec<u8>) {
                bytes.extend(self.to_le_bytes());
            }
        }
    };
}

number!(u8, "|u1");
number!(u16, "<u2");
number!(u32, "<u4");
number!(f16, "<f2");
number!(f32, "<f4");
number!(f64, "<f8");

impl NpzWriter {
    /// An archive without arrays.
    pub fn new() -> Self {
        Self {
            zip: ZipWriter::new(Cursor::default()),
        }
    }

    /// Adds an array in C order.
    ///
    /// # Panics
    /// When there are fewer or more numbers than the shape says.
    pub fn add<T: Number>(
        &mut self,
        name: &str,
        shape: &[usize],
        numbers: &[T],
    ) -> Result<(), ZipError> {
        assert_eq!(shape.iter().product::<usize>(), numbers.len(), "{name}");
        let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
        self.zip.start_file(format!("{name}.npy"), options)?;
        let mut bytes = header(T::DESCR, shape);
        bytes.reserve(size_of_val(numbers));
        for &number in numbers {
            number.write(&mut bytes);
        }
        Ok(self.zip.write_all(&bytes)?)
    }

    /// The archive's bytes.
    pub fn finish(self) -> Result<Vec<u8>, ZipError> {
        Ok(self.zip.finish()?.into_inner())
    }
}

impl Default for NpzWriter {
    fn default() -> Self {
        Self::new()
    }
}

/// A header of version 1, padded so that the numbers start at a multiple of 64 bytes.
fn header(descr: &str, shape: &[usize]) -> Vec<u8> {
    let sizes: String = shape.iter().map(|size| format!("{size},")).collect();
    let mut text = format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': ({sizes}), }}");
    let length = (10 + text.len() + 1).next_multiple_of(64) - 10;
    text.extend(std::iter::repeat_n(' ', length - text.len() - 1));
    text.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((text.len() as u16).to_le_bytes());
    bytes.extend(text.bytes());
    bytes
}
