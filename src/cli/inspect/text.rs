//! Text that summaries of avatars and of motion share.

use effigy_core::io::file::{TensorInfo, format::ByteArrangement};
use serde::Serialize;
use std::fmt;

/// The range and the median of some numbers; zeros if there are none.
#[derive(Debug, PartialEq, Serialize)]
pub struct Distribution {
    pub min: f64,
    pub median: f64,
    pub max: f64,
}

impl Distribution {
    pub fn new(numbers: impl IntoIterator<Item = f64>) -> Self {
        let mut sorted: Vec<f64> = numbers.into_iter().collect();
        sorted.sort_by(f64::total_cmp);
        let at = |k: usize| sorted.get(k).copied().unwrap_or(0.0);
        Self {
            min: at(0),
            median: at(sorted.len() / 2),
            max: at(sorted.len().saturating_sub(1)),
        }
    }
}

/// A text of a file, or that it is missing.
pub fn stated(text: &str) -> &str {
    if text.is_empty() { "not stated" } else { text }
}

/// A count with commas between thousands: 200,000.
pub fn thousands(n: usize) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A line of two columns.
pub fn line(f: &mut fmt::Formatter, heading: &str, text: impl fmt::Display) -> fmt::Result {
    writeln!(f, "{heading:<11} {text}")
}

/// The tensors of a file, a line each, and the sum of their bytes.
pub fn table(f: &mut fmt::Formatter, tensors: &[TensorInfo]) -> fmt::Result {
    writeln!(
        f,
        "\n{:<26} {:<5} {:<18} {:>12} {:>12}",
        "tensor", "type", "shape", "bytes", "in the file"
    )?;
    for tensor in tensors {
        let shape = tensor
            .shape
            .iter()
            .map(usize::to_string)
            .collect::<Vec<_>>()
            .join(" × ");
        let bytes = thousands(tensor.bytes);
        let stored = thousands(tensor.stored);
        let encoding = match tensor.deflated {
            None => "",
            Some(ByteArrangement::Planes) => ", deflated",
            Some(ByteArrangement::Deltas) => ", differences deflated",
        };
        writeln!(
            f,
            "{:<26} {:<5} {shape:<18} {bytes:>12} {stored:>12}  {}{encoding}",
            tensor.name, tensor.dtype, tensor.what
        )?;
    }
    let bytes: usize = tensors.iter().map(|tensor| tensor.bytes).sum();
    let stored: usize = tensors.iter().map(|tensor| tensor.stored).sum();
    writeln!(
        f,
        "{:<51} {:>12} {:>12}",
        "sum",
        thousands(bytes),
        thousands(stored)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_have_commas() {
        assert_eq!(
            [0, 12, 123, 1234, 123_456, 1_234_567].map(thousands),
            ["0", "12", "123", "1,234", "123,456", "1,234,567"]
        );
    }

    #[test]
    fn a_distribution_sorts_its_numbers() {
        assert_eq!(
            Distribution::new([3.0, -1.0, 2.0]),
            Distribution {
                min: -1.0,
                median: 2.0,
                max: 3.0
            }
        );
    }
}
