//! Smoothing over time that keeps what was corrected corrected.

use std::{iter::Sum, ops::Div};

/// The largest value of each window, and then the mean over it: nowhere much less than before.
/// `half`: frames before and after the middle of a window; `size`: how large a value is.
pub fn smooth<T>(values: &[T], half: usize, size: impl Fn(T) -> f64) -> Vec<T>
where
    T: Copy + Default + Sum + Div<f64, Output = T>,
{
    let window = |at: usize| at.saturating_sub(half)..(at + half + 1).min(values.len());
    let largest: Vec<T> = (0..values.len())
        .map(|at| {
            let window = values[window(at)].iter().copied();
            window
                .max_by(|a, b| size(*a).total_cmp(&size(*b)))
                .unwrap_or_default()
        })
        .collect();
    (0..values.len())
        .map(|at| {
            let window = &largest[window(at)];
            window.iter().copied().sum::<T>() / window.len() as f64
        })
        .collect()
}
