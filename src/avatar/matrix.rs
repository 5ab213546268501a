//! Rows of numbers, f16 each, or a byte each with a step a row: what bases and weights are stored in. Whoever reads them sees numbers.

use half::f16;
use std::borrow::Cow;

/// Largest code of a byte: a code more, −128, has no counterpart and is not used.
pub const CODE_MAX: i8 = 127;
/// Largest step of a row of bytes, so that f16 holds 127 of them.
pub const STEP_MAX: f64 = 512.0;

/// Rows of numbers of one length, one after the other.
#[derive(Clone, Debug, PartialEq)]
pub enum Matrix {
    Halves(Vec<f16>),
    /// A number is its code, −127 to 127, times its row's step.
    Bytes {
        codes: Vec<i8>,
        steps: Vec<f16>,
    },
}

/// A row of a [`Matrix`], or a piece of one.
#[derive(Clone, Copy, Debug)]
pub enum Row<'a> {
    Halves(&'a [f16]),
    Bytes { codes: &'a [i8], step: f16 },
}

impl Matrix {
    /// Numbers in all.
    pub fn len(&self) -> usize {
        match self {
            Self::Halves(numbers) => numbers.len(),
            Self::Bytes { codes, .. } => codes.len(),
        }
    }

    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

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

    /// A row of so many numbers; rows of none need no step.
    pub fn row(&self, at: usize, length: usize) -> Row<'_> {
        match self {
            Self::Halves(numbers) => Row::Halves(&numbers[at * length..][..length]),
            Self::Bytes { codes, steps } => {
                let step = if length == 0 { f16::ZERO } else { steps[at] };
                Row::Bytes { codes: &codes[at * length..][..length], step }
            }
        }
    }

    /// All rows, of so many numbers each.
    pub fn rows(&self, length: usize) -> impl ExactSizeIterator<Item = Row<'_>> {
        (0..self.len() / length.max(1)).map(move |at| self.row(at, length))
    }

    /// Some of the rows, in the order that they are named in.
    pub fn pick(&self, rows: &[usize], length: usize) -> Self {
        match self {
            Self::Halves(numbers) => rows.iter().flat_map(|&at| &numbers[at * length..][..length]).copied().collect(),
            Self::Bytes { codes, steps } => Self::Bytes {
                codes: rows.iter().flat_map(|&at| &codes[at * length..][..length]).copied().collect(),
                steps: rows.iter().map(|&at| steps[at]).collect(),
            },
        }
    }

    /// The numbers as f16: bytes are multiplied out and rounded.
    pub fn halves(&self) -> Cow<'_, [f16]> {
        match self {
            Self::Halves(numbers) => Cow::Borrowed(numbers),
            Self::Bytes { codes, steps } => {
                let row = |(codes, step): (&[i8], &f16)| codes.iter().map(|&code| f16::from_f64(f64::from(code) * step.to_f64())).collect();
                let length = codes.len().checked_div(steps.len()).unwrap_or_default().max(1);
                Cow::Owned(codes.chunks_exact(length).zip(steps).flat_map(|row_and_step| -> Vec<f16> { row(row_and_step) }).collect())
            }
        }
    }

    /// The numbers as f16, to be changed: bytes become f16 first.
    pub fn halves_mut(&mut self) -> &mut Vec<f16> {
        loop {
            match self {
                Self::Halves(numbers) => return numbers,
                Self::Bytes { .. } => *self = Self::Halves(self.halves().into_owned()),
            }
        }
    }

    /// Zeros in some columns of all rows, of so many numbers each, from `first` on.
    pub fn zero_columns(&mut self, first: usize, columns: std::ops::Range<usize>, length: usize) {
        match self {
            Self::Halves(numbers) => numbers.chunks_exact_mut(length).skip(first).for_each(|row| row[columns.clone()].fill(f16::ZERO)),
            Self::Bytes { codes, .. } => codes.chunks_exact_mut(length).skip(first).for_each(|row| row[columns.clone()].fill(0)),
        }
    }

    /// The nearest bytes, for rows of so many numbers; what are bytes stays as it is.
    pub fn bytes(&self, length: usize) -> Self {
        if self.is_bytes() {
            return self.clone();
        }
        let steps: Vec<f16> = self.rows(length).map(|row| step(row.iter())).collect();
        let codes = self.rows(length).zip(&steps).flat_map(|(row, step)| row.iter().map(|v| code(v, step.to_f64())));
        Self::Bytes { codes: codes.collect(), steps: steps.clone() }
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
    /// Some of its numbers, that follow each other.
    pub fn piece(self, start: usize, length: usize) -> Self {
        match self {
            Self::Halves(numbers) => Self::Halves(&numbers[start..][..length]),
            Self::Bytes { codes, step } => Self::Bytes { codes: &codes[start..][..length], step },
        }
    }

    /// Its numbers.
    pub fn iter(self) -> impl Iterator<Item = f64> + Clone + 'a {
        let (halves, bytes, step) = match self {
            Self::Halves(numbers) => (numbers, [].as_slice(), 0.0),
            Self::Bytes { codes, step } => ([].as_slice(), codes, step.to_f64()),
        };
        halves.iter().map(|v| v.to_f64()).chain(bytes.iter().map(move |&code| f64::from(code) * step))
    }

    /// The sum of its numbers' products with as many others.
    pub fn dot(self, x: &[f64]) -> f64 {
        match self {
            Self::Halves(numbers) => numbers.iter().zip(x).map(|(v, x)| v.to_f64() * x).sum(),
            Self::Bytes { codes, step } => step.to_f64() * codes.iter().zip(x).map(|(&code, x)| f64::from(code) * x).sum::<f64>(),
        }
    }
}

/// The smallest f16 of which 127 reach as far as the largest of some numbers.
fn step(values: impl Iterator<Item = f64>) -> f16 {
    let least = values.fold(0.0, |most: f64, v| most.max(v.abs())) / f64::from(CODE_MAX);
    let near = f16::from_f64(least.min(STEP_MAX));
    if near.to_f64() < least.min(STEP_MAX) { f16::from_bits(near.to_bits() + 1) } else { near }
}

/// A number in steps.
pub fn code(value: f64, step: f64) -> i8 {
    let most = f64::from(CODE_MAX);
    if step > 0.0 { (value / step).round().clamp(-most, most) as i8 } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn halves(values: &[f64]) -> Matrix {
        values.iter().map(|&v| f16::from_f64(v)).collect()
    }

    #[test]
    fn bytes_are_within_half_a_step() {
        let values = [0.5, -0.1, 0.25, 0.0, 6e-8, -6e-8, 0.0, 0.0, 65504.0, -65504.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let (exact, bytes) = (halves(&values), halves(&values).bytes(4));
        let Matrix::Bytes { codes, steps } = &bytes else { panic!("{bytes:?} are no bytes") };
        assert_eq!((codes[0], codes[8], codes[9], codes[12], steps.len()), (127, 127, -127, 0, 4));
        for (at, (a, b)) in exact.rows(4).zip(bytes.rows(4)).enumerate() {
            // Above 512 · 127 is cut, and the smallest step is f16's.
            let room = (0.5 * steps[at].to_f64()).max(0.5 * 2f64.powi(-24)) + if at == 2 { 65504.0 - 127.0 * STEP_MAX } else { 0.0 };
            assert!(a.iter().zip(b.iter()).all(|(a, b)| (a - b).abs() <= room), "{a:?} became {b:?}");
        }
        assert_eq!(bytes.bytes(4), bytes);
        assert_eq!((exact.size(), bytes.size(), bytes.len()), (32, 24, 16));
    }

    #[test]
    fn rows_of_both_kinds_are_read_alike() {
        let bytes = halves(&[0.5, -0.25, 1.0, 0.125, 2.0, -3.0]).bytes(3);
        let multiplied = Matrix::Halves(bytes.halves().into_owned());
        for at in 0..2 {
            let (a, b) = (bytes.row(at, 3), multiplied.row(at, 3));
            let x = [1.0, 0.5, -2.0];
            assert!((a.dot(&x) - b.dot(&x)).abs() < 5e-3 && (a.dot(&x) - a.iter().zip(x).map(|(v, x)| v * x).sum::<f64>()).abs() < 1e-12);
            assert_eq!(a.piece(1, 2).iter().collect::<Vec<_>>(), a.iter().skip(1).collect::<Vec<_>>());
        }
        assert_eq!(bytes.pick(&[1], 3).row(0, 3).iter().collect::<Vec<_>>(), bytes.row(1, 3).iter().collect::<Vec<_>>());
        let mut changed = bytes.clone();
        changed.halves_mut()[0] = f16::ONE;
        assert!(!changed.is_bytes() && changed.row(0, 3).iter().next() == Some(1.0));
    }
}
