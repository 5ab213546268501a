//! Rules for a tensor's numbers. Each takes bytes at any alignment and reports the first number
//! that breaks it.

use crate::avatar::{
    limits,
    matrix::{CODE_MAX, STEP_MAX},
};
use bytemuck::Pod;
use half::f16;
use safetensors::Dtype;

/// How far the dot products of a subspace's components may be from 1 and 0.
const ORTHONORMAL: f64 = 1e-3;

/// The first number that breaks a rule.
pub struct Bad {
    /// Index into the flat tensor.
    pub at: usize,
    /// The number, or a description.
    pub found: String,
    pub expected: String,
}

/// An element type of a tensor.
pub trait TensorElement: Pod + PartialEq + std::fmt::Display {
    const DTYPE: Dtype;
    fn to_f64(self) -> f64;
    /// Whether it is neither NaN nor infinite; by its bits, which is faster than by its value.
    fn is_finite(self) -> bool;
}

macro_rules! element {
    ($type:ty, $dtype:ident, $is_finite:expr) => {
        impl TensorElement for $type {
            const DTYPE: Dtype = Dtype::$dtype;
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            fn is_finite(self) -> bool {
                $is_finite(self)
            }
        }
    };
}

element!(u8, U8, |_| true);
element!(i8, I8, |_| true);
element!(u16, U16, |_| true);
element!(u32, U32, |_| true);
element!(f16, F16, f16::is_finite);
element!(f32, F32, f32::is_finite);

fn values<T: Pod>(bytes: &[u8]) -> impl ExactSizeIterator<Item = T> {
    bytes
        .chunks_exact(size_of::<T>())
        .map(bytemuck::pod_read_unaligned)
}

/// Checks that every number passes `good`.
fn each<T: TensorElement>(
    bytes: &[u8],
    good: impl Fn(T) -> bool,
    expected: impl Fn() -> String,
) -> Result<(), Bad> {
    // Without a way out of the loop it takes several numbers at once.
    if values(bytes).fold(true, |all, value| all & good(value)) {
        return Ok(());
    }
    match values(bytes).enumerate().find(|&(_, value)| !good(value)) {
        Some((at, value)) => Err(Bad {
            at,
            found: value.to_string(),
            expected: expected(),
        }),
        None => Ok(()),
    }
}

/// Accepts any numbers.
pub fn any<T: TensorElement>(_: &[u8]) -> Result<(), Bad> {
    Ok(())
}

/// Finite numbers.
pub fn finite<T: TensorElement>(bytes: &[u8]) -> Result<(), Bad> {
    each(bytes, T::is_finite, || "finite numbers".into())
}

/// Lengths of at most [`limits::LENGTH`].
pub fn length<T: TensorElement>(bytes: &[u8]) -> Result<(), Bad> {
    each(
        bytes,
        |value: T| value.to_f64().abs() <= limits::LENGTH,
        || format!("metres, at most {}", limits::LENGTH),
    )
}

/// Finite numbers, at least 0.
pub fn deviation<T: TensorElement>(bytes: &[u8]) -> Result<(), Bad> {
    let good = |value: T| value.to_f64() >= 0.0 && value.to_f64().is_finite();
    each(bytes, good, || "finite numbers from 0 up".into())
}

/// Indices of something there are `count` of.
pub fn below<T: TensorElement>(bytes: &[u8], count: usize) -> Result<(), Bad> {
    each(
        bytes,
        |value: T| value.to_f64() < count as f64,
        || format!("numbers below {count}"),
    )
}

/// Finite quaternions of any length but 0.
pub fn quaternion<T: TensorElement>(bytes: &[u8]) -> Result<(), Bad> {
    finite::<T>(bytes)?;
    let is_zero = |v: &T| *v == T::zeroed();
    match values::<[T; 4]>(bytes).position(|q| q.iter().all(is_zero)) {
        Some(row) => Err(Bad {
            at: 4 * row,
            found: "a quaternion of length 0".into(),
            expected: "any other length".into(),
        }),
        None => Ok(()),
    }
}

/// Rows of four weights that sum to 255.
pub fn weights<T: TensorElement>(bytes: &[u8]) -> Result<(), Bad> {
    let sum = |row: [T; 4]| row.iter().map(|&v| v.to_f64()).sum::<f64>();
    match values(bytes)
        .map(sum)
        .enumerate()
        .find(|&(_, sum)| sum != 255.0)
    {
        Some((row, sum)) => Err(Bad {
            at: 4 * row,
            found: format!("weights that sum to {sum}"),
            expected: "a sum of 255".into(),
        }),
        None => Ok(()),
    }
}

/// Rows of three weights that sum to at most 255.
pub fn weights_but_one<T: TensorElement>(bytes: &[u8]) -> Result<(), Bad> {
    let sum = |row: [T; 3]| row.iter().map(|&v| v.to_f64()).sum::<f64>();
    match values(bytes)
        .map(sum)
        .enumerate()
        .find(|&(_, sum)| sum > 255.0)
    {
        Some((row, sum)) => Err(Bad {
            at: 3 * row,
            found: format!("three weights that sum to {sum}"),
            expected: "a sum of 255 at most".into(),
        }),
        None => Ok(()),
    }
}

/// Codes of a [`Matrix`](crate::avatar::Matrix).
pub fn code<T: TensorElement>(bytes: &[u8]) -> Result<(), Bad> {
    each(
        bytes,
        |value: T| value.to_f64() >= -f64::from(CODE_MAX),
        || format!("codes from -{CODE_MAX} to {CODE_MAX}"),
    )
}

/// Steps of a [`Matrix`](crate::avatar::Matrix).
pub fn step<T: TensorElement>(bytes: &[u8]) -> Result<(), Bad> {
    each(
        bytes,
        |value: T| (0.0..=STEP_MAX).contains(&value.to_f64()),
        || format!("steps from 0 to {STEP_MAX}"),
    )
}

/// Numbers from 0 to `end` that never fall.
pub fn starts<T: TensorElement>(bytes: &[u8], end: usize) -> Result<(), Bad> {
    let last = values::<T>(bytes).len().saturating_sub(1);
    let mut before = 0.0;
    for (at, found) in values::<T>(bytes).enumerate() {
        let value = found.to_f64();
        let good = value >= before
            && value <= end as f64
            && (at > 0 || value == 0.0)
            && (at < last || value == end as f64);
        if !good {
            return Err(Bad {
                at,
                found: found.to_string(),
                expected: format!("numbers from 0 to {end} that never fall"),
            });
        }
        before = value;
    }
    Ok(())
}

/// Strictly rising indices of something there are `count` of.
pub fn rising<T: TensorElement>(bytes: &[u8], count: usize) -> Result<(), Bad> {
    below::<T>(bytes, count)?;
    let mut before = -1.0;
    for (at, value) in values::<T>(bytes).enumerate() {
        if before >= value.to_f64() {
            return Err(Bad {
                at,
                found: format!("{value} after a number no smaller"),
                expected: "rising numbers".into(),
            });
        }
        before = value.to_f64();
    }
    Ok(())
}

/// Rows of `len` numbers that are orthonormal.
pub fn orthonormal<T: TensorElement>(bytes: &[u8], len: usize) -> Result<(), Bad> {
    finite::<T>(bytes)?;
    let row = |k: usize| values::<T>(&bytes[k * len * size_of::<T>()..][..len * size_of::<T>()]);
    let count = if len == 0 {
        0
    } else {
        bytes.len() / (len * size_of::<T>())
    };
    for (a, b) in (0..count).flat_map(|a| (0..=a).map(move |b| (a, b))) {
        let dot: f64 = row(a)
            .zip(row(b))
            .map(|(x, y)| x.to_f64() * y.to_f64())
            .sum();
        let exact = if a == b { 1.0 } else { 0.0 };
        if (dot - exact).abs() > ORTHONORMAL {
            let found = format!("rows {b} and {a} with the dot product {dot}");
            return Err(Bad {
                at: a * len,
                found,
                expected: exact.to_string(),
            });
        }
    }
    Ok(())
}
