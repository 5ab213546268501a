//! Matrices for bases and weights, stored as f16 or as bytes with a step a row. Readers see
//! numbers, whatever the storage.

use half::f16;
use std::borrow::Cow;

/// Largest code of a byte. −128 has no positive counterpart and is not used.
pub const CODE_MAX: i8 = 127;
/// Largest step of a row of bytes: 127 steps still fit f16.
pub const STEP_MAX: f64 = 512.0;

/// Rows of numbers of one length, one after the other.
#[derive(Clone, Debug, PartialEq)]
pub enum Matrix {
    /// Each number in f16.
    Halves(Vec<f16>),
    /// A number is its code, −127 to 127, times its row's step.
    Bytes {
        /// Codes of all rows.
        codes: Vec<i8>,
        /// One step a row.
        steps: Vec<f16>,
    },
}

/// A row of a [`Matrix`], or a piece of one.
#[derive(Clone, Copy, Debug)]
pub enum Row<'a> {
    /// Each number in f16.
    Halves(&'a [f16]),
    /// A number is its code times the step.
    Bytes {
        /// The row's codes.
        codes: &'a [i8],
        /// The row's step.
        step: f16,
    },
    /// Each number in f64: what is being learned, which no file holds yet.
    Doubles(&'a [f64]),
}

impl Matrix {
    /// Number of entries.
    pub fn len(&self) -> usize {
        match self {
            Self::Halves(numbers) => numbers.len(),
            Self::Bytes { codes, .. } => codes.len(),
        }
    }

    /// Whether it has no entries.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether its rows are bytes with a step.
    pub fn is_bytes(&self) -> bool {
        matches!(self, Self::Bytes { .. })
    }

    /// Bytes of memory, steps included.
    pub fn size(&self) -> usize {
        match self {
            Self::Halves(numbers) => 2 * numbers.len(),
            Self::Bytes { codes, steps } => codes.len() + 2 * steps.len(),
        }
    }

    /// Row number `at` of a matrix whose rows have `length` numbers. Empty rows need no step.
    pub fn row(&self, at: usize, length: usize) -> Row<'_> {
        match self {
            Self::Halves(numbers) => Row::Halves(&numbers[at * length..][..length]),
            Self::Bytes { codes, steps } => {
                let step = if length == 0 { f16::ZERO } else { steps[at] };
                Row::Bytes {
                    codes: &codes[at * length..][..length],
                    step,
                }
            }
        }
    }

    /// All rows, of `length` numbers each.
    pub fn rows(&self, length: usize) -> impl ExactSizeIterator<Item = Row<'_>> {
        (0..self.len() / length.max(1)).map(move |at| self.row(at, length))
    }

    /// The rows of these indices, in their order.
    pub fn pick(&self, rows: &[usize], length: usize) -> Self {
        match self {
            Self::Halves(numbers) => rows
                .iter()
                .flat_map(|&at| &numbers[at * length..][..length])
                .copied()
                .collect(),
            Self::Bytes { codes, steps } => Self::Bytes {
                codes: rows
                    .iter()
                    .flat_map(|&at| &codes[at * length..][..length])
                    .copied()
                    .collect(),
                steps: rows.iter().map(|&at| steps[at]).collect(),
            },
        }
    }

    /// The numbers as f16; bytes are multiplied by their steps and rounded.
    pub fn halves(&self) -> Cow<'_, [f16]> {
        match self {
            Self::Halves(numbers) => Cow::Borrowed(numbers),
            Self::Bytes { codes, steps } => {
                let length = codes.len().checked_div(steps.len()).unwrap_or_default();
                let mut halves = Vec::with_capacity(codes.len());
                for (row, step) in codes.chunks_exact(length.max(1)).zip(steps) {
                    let step = step.to_f64();
                    halves.extend(
                        row.iter()
                            .map(|&code| f16::from_f64(f64::from(code) * step)),
                    );
                }
                Cow::Owned(halves)
            }
        }
    }

    /// The numbers for editing; bytes are converted to f16 first.
    pub fn halves_mut(&mut self) -> &mut Vec<f16> {
        loop {
            match self {
                Self::Halves(numbers) => return numbers,
                Self::Bytes { .. } => *self = Self::Halves(self.halves().into_owned()),
            }
        }
    }

    /// Sets columns to zero in all rows from `first` on, of `length` numbers each.
    pub fn zero_columns(&mut self, first: usize, columns: std::ops::Range<usize>, length: usize) {
        match self {
            Self::Halves(numbers) => {
                for row in numbers.chunks_exact_mut(length).skip(first) {
                    row[columns.clone()].fill(f16::ZERO);
                }
            }
            Self::Bytes { codes, .. } => {
                for row in codes.chunks_exact_mut(length).skip(first) {
                    row[columns.clone()].fill(0);
                }
            }
        }
    }

    /// The nearest bytes, for rows of `length` numbers; bytes stay as they are.
    pub fn bytes(&self, length: usize) -> Self {
        if self.is_bytes() {
            return self.clone();
        }
        let steps: Vec<f16> = self.rows(length).map(|row| step(row.iter())).collect();
        let codes = self
            .rows(length)
            .zip(&steps)
            .flat_map(|(row, step)| row.iter().map(|v| code(v, step.to_f64())));
        Self::Bytes {
            codes: codes.collect(),
            steps: steps.clone(),
        }
    }
}

impl Default for Matrix {
    fn default() -> Self {
        Self::Halves(vec![])
    }
}

impl From<Vec<f16>> for Matrix {
    fn from(numbers: Vec<f16>) -> Self {
        Self::Halves(numbers)
    }
}

impl FromIterator<f16> for Matrix {
    fn from_iter<I: IntoIterator<Item = f16>>(numbers: I) -> Self {
        Self::Halves(numbers.into_iter().collect())
    }
}

impl<'a> Row<'a> {
    /// A contiguous piece of the row.
    pub fn piece(self, start: usize, length: usize) -> Self {
        match self {
            Self::Halves(numbers) => Self::Halves(&numbers[start..][..length]),
            Self::Bytes { codes, step } => Self::Bytes {
                codes: &codes[start..][..length],
                step,
            },
            Self::Doubles(numbers) => Self::Doubles(&numbers[start..][..length]),
        }
    }

    /// Its numbers.
    pub fn iter(self) -> impl Iterator<Item = f64> + Clone + 'a {
        let (halves, bytes, step, doubles) = match self {
            Self::Halves(numbers) => (numbers, [].as_slice(), 0.0, [].as_slice()),
            Self::Bytes { codes, step } => ([].as_slice(), codes, step.to_f64(), [].as_slice()),
            Self::Doubles(numbers) => ([].as_slice(), [].as_slice(), 0.0, numbers),
        };
        halves
            .iter()
            .map(|v| v.to_f64())
            .chain(bytes.iter().map(move |&code| f64::from(code) * step))
            .chain(doubles.iter().copied())
    }

    /// Dot product with as many numbers.
    pub fn dot(self, x: &[f64]) -> f64 {
        match self {
            Self::Halves(numbers) => numbers.iter().zip(x).map(|(v, x)| v.to_f64() * x).sum(),
            Self::Bytes { codes, step } => {
                step.to_f64()
                    * codes
                        .iter()
                        .zip(x)
                        .map(|(&code, x)| f64::from(code) * x)
                        .sum::<f64>()
            }
            Self::Doubles(numbers) => numbers.iter().zip(x).map(|(v, x)| v * x).sum(),
        }
    }
}

/// The smallest f16 step with which 127 steps reach the largest magnitude of `values`.
fn step(values: impl Iterator<Item = f64>) -> f16 {
    let exact = values.fold(0.0, |max: f64, v| max.max(v.abs())) / f64::from(CODE_MAX);
    let near = f16::from_f64(exact.min(STEP_MAX));
    if near.to_f64() < exact.min(STEP_MAX) {
        f16::from_bits(near.to_bits() + 1)
    } else {
        near
    }
}

/// The code of a number: how many steps it is, rounded and clamped.
pub fn code(value: f64, step: f64) -> i8 {
    let max = f64::from(CODE_MAX);
    if step > 0.0 {
        (value / step).round().clamp(-max, max) as i8
    } else {
        0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::constants::F16_MAX;

    fn halves(values: &[f64]) -> Matrix {
        values.iter().map(|&v| f16::from_f64(v)).collect()
    }

    #[test]
    fn bytes_are_within_half_a_step() {
        let values = [
            0.5, -0.1, 0.25, 0.0, 6e-8, -6e-8, 0.0, 0.0, F16_MAX, -F16_MAX, 1.0, 0.0, 0.0, 0.0,
            0.0, 0.0,
        ];
        let exact = halves(&values);
        let bytes = exact.bytes(4);
        let Matrix::Bytes { codes, steps } = &bytes else {
            panic!("{bytes:?} are no bytes")
        };
        assert_eq!(
            (codes[0], codes[8], codes[9], codes[12], steps.len()),
            (127, 127, -127, 0, 4)
        );
        for (at, (a, b)) in exact.rows(4).zip(bytes.rows(4)).enumerate() {
            // Above 512 · 127 is cut, and the smallest step is f16's.
            let tolerance = (0.5 * steps[at].to_f64()).max(0.5 * 2f64.powi(-24))
                + if at == 2 {
                    F16_MAX - 127.0 * STEP_MAX
                } else {
                    0.0
                };
            assert!(
                a.iter()
                    .zip(b.iter())
                    .all(|(a, b)| (a - b).abs() <= tolerance),
                "{a:?} became {b:?}"
            );
        }
        assert_eq!(bytes.bytes(4), bytes);
        assert_eq!((exact.size(), bytes.size(), bytes.len()), (32, 24, 16));
    }

    #[test]
    fn rows_of_both_kinds_give_equal_numbers() {
        let bytes = halves(&[0.5, -0.25, 1.0, 0.125, 2.0, -3.0]).bytes(3);
        let multiplied = Matrix::Halves(bytes.halves().into_owned());
        for at in 0..2 {
            let a = bytes.row(at, 3);
            let b = multiplied.row(at, 3);
            let x = [1.0, 0.5, -2.0];
            assert!(
                (a.dot(&x) - b.dot(&x)).abs() < 5e-3
                    && (a.dot(&x) - a.iter().zip(x).map(|(v, x)| v * x).sum::<f64>()).abs() < 1e-12
            );
            assert_eq!(
                a.piece(1, 2).iter().collect::<Vec<_>>(),
                a.iter().skip(1).collect::<Vec<_>>()
            );
        }
        assert_eq!(
            bytes.pick(&[1], 3).row(0, 3).iter().collect::<Vec<_>>(),
            bytes.row(1, 3).iter().collect::<Vec<_>>()
        );
        let mut changed = bytes.clone();
        changed.halves_mut()[0] = f16::ONE;
        assert!(!changed.is_bytes() && changed.row(0, 3).iter().next() == Some(1.0));
    }
}
