//! The type of an array's numbers, as NumPy spells it, and how one is read.

use half::{bf16, f16};

/// What kind of numbers an array holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Float,
    /// PyTorch's bfloat16: the upper half of an f32.
    Brain,
    Signed,
    Unsigned,
}

/// The type of an array's numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Element {
    pub kind: Kind,
    /// Bytes.
    pub size: usize,
    pub big_endian: bool,
}

impl Element {
    /// Reads a type such as `<f2`. None: a type that is not of plain numbers.
    pub fn parse(text: &str) -> Option<Self> {
        let mut letters = text.chars();
        let order = letters.next()?;
        let (big_endian, kind) = match order {
            '<' | '|' | '=' => (false, letters.next()?),
            '>' => (true, letters.next()?),
            kind => (false, kind),
        };
        let size: usize = letters.as_str().parse().ok()?;
        let kind = match kind {
            'f' if matches!(size, 2 | 4 | 8) => Kind::Float,
            'i' if matches!(size, 1 | 2 | 4 | 8) => Kind::Signed,
            'u' | 'b' if matches!(size, 1 | 2 | 4 | 8) => Kind::Unsigned,
            _ => return None,
        };
        Some(Self {
            kind,
            size,
            big_endian,
        })
    }

    /// A number as a float. `bytes`: as many as its size.
    pub fn float(self, bytes: &[u8]) -> f64 {
        let word = self.word(bytes);
        match (self.kind, self.size) {
            (Kind::Float, 2) => f16::from_bits(word as u16).to_f64(),
            (Kind::Float, 4) => f64::from(f32::from_bits(word as u32)),
            (Kind::Float, _) => f64::from_bits(word),
            (Kind::Brain, _) => bf16::from_bits(word as u16).to_f64(),
            _ => self.integer(bytes) as f64,
        }
    }

    /// A number that is an integer. `bytes`: as many as its size.
    pub fn integer(self, bytes: &[u8]) -> i128 {
        let word = self.word(bytes);
        let unused = 64 - 8 * self.size as u32;
        match self.kind {
            Kind::Signed => i128::from((word << unused) as i64 >> unused),
            _ => i128::from(word),
        }
    }

    /// The bits of a number.
    fn word(self, bytes: &[u8]) -> u64 {
        let add = |word, &byte: &u8| word << 8 | u64::from(byte);
        if self.big_endian {
            bytes.iter().fold(0, add)
        } else {
            bytes.iter().rev().fold(0, add)
        }
    }
}
