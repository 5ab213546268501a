//! What is left between two frames of one surface, summarised.

use serde::{Deserialize, Serialize};

/// Share of the pixels below the percentile that is reported: popping is rare, and means hide it.
const PERCENTILE: f64 = 0.999;

/// What changed between two frames in each pixel that shows the same surface in both.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ResidualMap {
    /// RGB of the earlier frame minus RGB of the later one, as displays show them; one entry a
    /// compared pixel.
    pub(super) differences: Vec<[f32; 3]>,
    /// Mean FLIP over these pixels, if it was computed.
    pub(super) flip: Option<f64>,
}

impl ResidualMap {
    /// The summary of what changed.
    pub fn summary(&self) -> Residual {
        Residual::new(self.differences.iter().copied(), self.flip)
    }

    /// The summary of what changed in these images and did not in others: the change of the
    /// difference between the two. FLIP has no such difference.
    ///
    /// # Panics
    /// If the others show other pixels.
    pub fn added_to(&self, others: &Self) -> Residual {
        assert_eq!(
            self.differences.len(),
            others.differences.len(),
            "residuals of the same pixels are compared"
        );
        let pairs = self.differences.iter().zip(&others.differences);
        let difference =
            |(own, other): (&[f32; 3], &[f32; 3])| std::array::from_fn(|k| own[k] - other[k]);
        Residual::new(pairs.map(difference), None)
    }
}

/// How much changed. A pixel's change is that of the channel that changed most, 0 to 1. Over no
/// pixels all of them are 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Residual {
    /// Mean over the compared pixels.
    pub mean: f64,
    /// 99.9th percentile.
    pub p999: f64,
    /// Largest.
    pub max: f64,
    /// Mean FLIP over the compared pixels, 0 to 1. Null if it was not computed.
    pub flip: Option<f64>,
}

impl Residual {
    fn new(differences: impl Iterator<Item = [f32; 3]>, flip: Option<f64>) -> Self {
        let change = |rgb: [f32; 3]| {
            let largest = |most: f64, channel: f32| {
                let change = f64::from(channel).abs();
                // A NaN is as wrong as a channel can be.
                most.max(if change.is_nan() { 1.0 } else { change })
            };
            rgb.into_iter().fold(0.0, largest)
        };
        let mut changes: Vec<f64> = differences.map(change).collect();
        changes.sort_by(f64::total_cmp);
        let Some(last) = changes.len().checked_sub(1) else {
            return Self::default();
        };
        Self {
            mean: changes.iter().sum::<f64>() / changes.len() as f64,
            p999: changes[(last as f64 * PERCENTILE).round() as usize],
            max: changes[last],
            flip,
        }
    }

    /// The mean of residuals by their weights, and the largest of all of them. FLIP is only known
    /// where all of them know theirs.
    pub fn pooled(residuals: impl Iterator<Item = WeighedResidual>) -> Self {
        let mut weights = 0.0;
        let mut sum = Self {
            flip: Some(0.0),
            ..Self::default()
        };
        for WeighedResidual { weight, residual } in residuals {
            weights += weight;
            sum.mean += weight * residual.mean;
            sum.p999 += weight * residual.p999;
            sum.max = sum.max.max(residual.max);
            sum.flip = sum
                .flip
                .zip(residual.flip)
                .map(|(sum, flip)| sum + weight * flip);
        }
        if weights == 0.0 {
            return Self {
                max: sum.max,
                ..Self::default()
            };
        }
        Self {
            mean: sum.mean / weights,
            p999: sum.p999 / weights,
            max: sum.max,
            flip: sum.flip.map(|flip| flip / weights),
        }
    }
}

/// A residual, and for how many pairs of frames it stands.
#[derive(Clone, Copy, Debug)]
pub struct WeighedResidual {
    /// Pairs of frames.
    pub weight: f64,
    /// Their residual.
    pub residual: Residual,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(differences: &[[f32; 3]], flip: Option<f64>) -> ResidualMap {
        ResidualMap {
            differences: differences.to_vec(),
            flip,
        }
    }

    #[test]
    fn a_pixels_change_is_that_of_its_worst_channel() {
        let own = map(&[[0.0, -0.5, 0.25], [0.0; 3], [0.25, 0.0, 0.0]], Some(0.1));
        assert_eq!(
            own.summary(),
            Residual {
                mean: 0.25,
                p999: 0.5,
                max: 0.5,
                flip: Some(0.1)
            }
        );
        assert_eq!(map(&[], None).summary(), Residual::default());
        assert_eq!(map(&[[f32::NAN, 0.0, 0.0]], None).summary().max, 1.0);
    }

    #[test]
    fn what_both_change_by_is_not_added() {
        let reference = map(&[[0.5, 0.0, 0.0], [0.25, 0.0, 0.0]], Some(0.1));
        let drawn = map(&[[0.5, 0.0, 0.0], [-0.25, 0.0, 0.0]], Some(0.1));
        let added = drawn.added_to(&reference);
        assert_eq!([added.mean, added.max], [0.25, 0.5]);
        assert_eq!(added.flip, None);
    }

    #[test]
    fn the_percentile_leaves_out_one_pixel_of_a_thousand() {
        let mut changes = vec![[0.125; 3]; 4000];
        changes[7] = [1.0; 3];
        let summary = map(&changes, None).summary();
        assert_eq!([summary.p999, summary.max], [0.125, 1.0]);
        changes[..8].fill([0.5; 3]);
        assert_eq!(map(&changes, None).summary().p999, 0.5);
    }

    #[test]
    fn pooled_residuals_count_by_their_weights() {
        let weighed = |weight, mean, max| WeighedResidual {
            weight,
            residual: Residual {
                mean,
                p999: mean,
                max,
                flip: Some(mean),
            },
        };
        let all = [weighed(3.0, 0.1, 0.2), weighed(1.0, 0.5, 0.9)];
        let pooled = Residual::pooled(all.into_iter());
        assert!((pooled.mean - 0.2).abs() < 1e-12 && pooled.flip == Some(pooled.mean));
        assert_eq!(pooled.max, 0.9);
        assert_eq!(Residual::pooled([].into_iter()), Residual::default());
    }
}
