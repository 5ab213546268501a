//! Numbers that are known between two bounds.

use std::ops::{Add, Div, Mul};

/// A number that is at least `low` and at most `high`. Neither is below 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Range {
    /// The lower bound.
    pub low: f64,
    /// The upper bound.
    pub high: f64,
}

impl Range {
    /// A number that is known.
    pub const fn exactly(number: f64) -> Self {
        Self {
            low: number,
            high: number,
        }
    }
}

impl Add for Range {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            low: self.low + other.low,
            high: self.high + other.high,
        }
    }
}

impl Mul for Range {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            low: self.low * other.low,
            high: self.high * other.high,
        }
    }
}

impl Mul<f64> for Range {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        self * Self::exactly(factor)
    }
}

impl Div for Range {
    type Output = Self;

    /// The least over the most, and the most over the least.
    fn div(self, other: Self) -> Self {
        Self {
            low: self.low / other.high,
            high: self.high / other.low,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_stay_bounds() {
        let a = Range {
            low: 2.0,
            high: 3.0,
        };
        let b = Range {
            low: 4.0,
            high: 8.0,
        };
        let expect = |range: Range, low, high| assert_eq!(range, Range { low, high });
        expect(a + b, 6.0, 11.0);
        expect(a * b, 8.0, 24.0);
        expect(a / b, 0.25, 0.75);
        expect(a * 2.0, 4.0, 6.0);
    }
}
