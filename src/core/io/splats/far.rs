//! Scenes that are far from the origin, as map coordinates put them.

use crate::{avatar::limits, io::assumption::Assumption};

/// Splats that are looked at, at most.
const SAMPLES: usize = 10_000;

/// The median of positions where it is further out than [`limits::LENGTH`], in whole metres, so that
/// somebody can move other files by it. None: it is nearer. `at`: the position of a splat.
pub fn far_middle(count: usize, at: impl Fn(usize) -> [f64; 3]) -> Option<[f64; 3]> {
    let step = count.div_ceil(SAMPLES).max(1);
    let sampled = || (0..count).step_by(step).map(&at);
    let median = |axis: usize| {
        let values = sampled().map(|position| position[axis]);
        let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
        let middle = values.len() / 2;
        values.sort_unstable_by(f64::total_cmp);
        values.get(middle).map_or(0.0, |value| value.round())
    };
    let middle = [0, 1, 2].map(median);
    let is_far = middle.iter().any(|value| value.abs() > limits::LENGTH);
    is_far.then_some(middle)
}

/// Says that a scene was moved to the origin.
pub fn moved(middle: [f64; 3]) -> Assumption {
    let [x, y, z] = middle;
    Assumption {
        what: "place",
        taken: format!("{x}, {y}, {z} is the new origin"),
        because: format!(
            "the scene is more than {} m from its own; move cameras and clips by as much",
            limits::LENGTH
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_far_moves() {
        let utm = |k: usize| [512_345.4 + k as f64 * 1e-3, 5_401_234.0, 312.0];
        assert_eq!(far_middle(101, utm), Some([512_345.0, 5_401_234.0, 312.0]));
        let near = |k: usize| {
            [
                9_000.0,
                if k.is_multiple_of(3) { 1e9 } else { 1.0 },
                f64::NAN,
            ]
        };
        assert_eq!(far_middle(50_000, near), None);
        assert_eq!(far_middle(0, near), None);
    }
}
