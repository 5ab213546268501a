//! Which basis rows stay: those whose correctives vary most over the training's poses, or change its
//! pictures most.

use crate::parameters::{BASIS, ParameterLayout, Parameters};
use crate::topology::{CorrectiveRows, Topology};
use effigy_core::avatar::ROW_COMPONENTS;
use rayon::prelude::*;

/// How the features of each part vary over poses: the covariance of the attributes' half; shape
/// N_G, N_B, N_B.
pub fn feature_covariance(features: &[Vec<f64>], parts: usize, width: usize) -> Vec<f64> {
    let count = features.len().max(1) as f64;
    (0..parts)
        .into_par_iter()
        .flat_map_iter(|part| {
            let own = |pose: &'_ Vec<f64>| pose[part * width..][..BASIS].to_vec();
            let rows: Vec<Vec<f64>> = features.iter().map(own).collect();
            let mean: Vec<f64> = (0..BASIS)
                .map(|k| rows.iter().map(|row| row[k]).sum::<f64>() / count)
                .collect();
            let mut covariance = vec![0.0; BASIS * BASIS];
            for row in &rows {
                for i in 0..BASIS {
                    for j in 0..BASIS {
                        covariance[i * BASIS + j] +=
                            (row[i] - mean[i]) * (row[j] - mean[j]) / count;
                    }
                }
            }
            covariance
        })
        .collect()
}

/// How much of a loss each number of each Gaussian's attributes makes: the mean over views of the
/// squared derivative, the diagonal of Fisher's information. Rotation, log scale and colour, ten
/// numbers a Gaussian.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    sums: Vec<[f64; 10]>,
    views: usize,
}

impl Sensitivity {
    /// Of so many Gaussians, before any view.
    pub fn new(gaussians: usize) -> Self {
        Self {
            sums: vec![[0.0; 10]; gaussians],
            views: 0,
        }
    }

    /// Adds a view's derivatives, of all Gaussians.
    pub fn add(&mut self, gradients: &[[f32; 10]]) {
        self.views += 1;
        for (sums, gradient) in self.sums.iter_mut().zip(gradients) {
            for (sum, &of) in sums.iter_mut().zip(gradient) {
                *sum += f64::from(of).powi(2);
            }
        }
    }

    fn of(&self, gaussian: u32, number: usize) -> f64 {
        self.sums[gaussian as usize][number] / self.views.max(1) as f64
    }
}

/// A row of an attribute's bases, and what it is worth.
struct Ranked {
    worth: f64,
    attribute: usize,
    gaussian: u32,
}

/// What prunes an avatar's rows.
#[derive(Clone, Copy)]
pub struct Pruning<'a> {
    /// What is learned.
    pub parameters: &'a Parameters<f32>,
    /// What stays as it is.
    pub topology: &'a Topology,
    /// Where numbers lie.
    pub layout: &'a ParameterLayout,
    /// The rows that there are.
    pub rows: &'a CorrectiveRows,
    /// [`feature_covariance`].
    pub covariance: &'a [f64],
}

impl Pruning<'_> {
    /// Keeps for each attribute `share` of the Gaussians' rows: those whose corrective B e varies
    /// most, Σ_c b_c C b_cᵀ with the covariance C of their part's features.
    pub fn by_variance(&self, share: f64) -> CorrectiveRows {
        let keep = (share * self.layout.gaussians as f64).round() as usize;
        CorrectiveRows {
            gaussian: std::array::from_fn(|attribute| {
                let ranked = self.ranked(attribute, &|_, _| 1.0);
                rising(best(ranked, keep).map(|row| row.gaussian))
            }),
        }
    }

    /// Keeps in all the number of rows of [`Self::by_variance`], of any attribute: those whose change over
    /// poses changes the loss of pictures most, Σ_c F_c b_c C b_cᵀ with the sensitivity F of the number.
    pub fn by_pictures(&self, share: f64, sensitivity: &Sensitivity) -> CorrectiveRows {
        let keep = ROW_COMPONENTS.len() * (share * self.layout.gaussians as f64).round() as usize;
        let mut all = Vec::new();
        let mut first = 0;
        for (attribute, components) in ROW_COMPONENTS.into_iter().enumerate() {
            let of = |gaussian, c| sensitivity.of(gaussian, first + c);
            all.extend(self.ranked(attribute, &of));
            first += components;
        }
        let kept: Vec<Ranked> = best(all, keep).collect();
        CorrectiveRows {
            gaussian: std::array::from_fn(|attribute| {
                let own = kept.iter().filter(|row| row.attribute == attribute);
                rising(own.map(|row| row.gaussian))
            }),
        }
    }

    /// The rows of an attribute with their worth. `weight`: of a Gaussian's component.
    fn ranked(
        &self,
        attribute: usize,
        weight: &(impl Fn(u32, usize) -> f64 + Sync),
    ) -> Vec<Ranked> {
        let worth = |(row, &gaussian): (usize, &u32)| {
            let part = usize::from(self.topology.gaussians[gaussian as usize].part);
            let c = &self.covariance[part * BASIS * BASIS..][..BASIS * BASIS];
            let basis = &self.parameters.bases[self.layout.row(attribute, row)];
            let components = basis.chunks_exact(BASIS).enumerate();
            Ranked {
                worth: components
                    .map(|(k, b)| weight(gaussian, k) * quadratic(b, c))
                    .sum(),
                attribute,
                gaussian,
            }
        };
        let own = &self.rows.gaussian[attribute];
        own.par_iter().enumerate().map(worth).collect()
    }
}

/// The rows that are worth most, in an order that is always the same.
fn best(mut all: Vec<Ranked>, count: usize) -> impl Iterator<Item = Ranked> {
    all.sort_by(|a, b| {
        let place = |row: &Ranked| (row.attribute, row.gaussian);
        b.worth
            .total_cmp(&a.worth)
            .then_with(|| place(a).cmp(&place(b)))
    });
    all.into_iter().take(count)
}

/// The Gaussians of rows, the lowest first.
fn rising(rows: impl Iterator<Item = u32>) -> Vec<u32> {
    let mut all: Vec<u32> = rows.collect();
    all.sort_unstable();
    all
}

/// b C bᵀ.
fn quadratic(b: &[f32], c: &[f64]) -> f64 {
    let of_row = |i: usize| -> f64 {
        (0..BASIS)
            .map(|j| c[i * BASIS + j] * f64::from(b[j]))
            .sum::<f64>()
            * f64::from(b[i])
    };
    (0..BASIS).map(of_row).sum()
}

/// The numbers of the rows that stay; everything else as it is.
pub fn keep_rows(
    numbers: &Parameters<f32>,
    layout: &ParameterLayout,
    rows: &CorrectiveRows,
    kept: &CorrectiveRows,
) -> Parameters<f32> {
    let mut bases = Vec::new();
    for (attribute, components) in ROW_COMPONENTS.into_iter().enumerate() {
        for &gaussian in &kept.gaussian[attribute] {
            match rows.row(attribute, gaussian as usize) {
                Some(row) => bases.extend(&numbers.bases[layout.row(attribute, row)]),
                None => bases.extend(std::iter::repeat_n(0.0, components * BASIS)),
            }
        }
    }
    Parameters {
        bases,
        ..numbers.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::topology::PlacedGaussian;
    use effigy_core::avatar::{Activation, Filter, facing};
    use glam::DVec3;

    #[test]
    fn covariance_is_that_of_the_attributes_half() {
        let pose = |a: f64| {
            let mut features = vec![0.0; 2 * 2 * BASIS];
            features[0] = a;
            features[1] = -2.0 * a;
            features[BASIS] = 100.0 * a;
            features
        };
        let covariance = feature_covariance(&[pose(1.0), pose(-1.0)], 2, 2 * BASIS);
        assert_eq!(covariance.len(), 2 * BASIS * BASIS);
        assert_eq!(covariance[..2], [1.0, -2.0]);
        assert_eq!(covariance[BASIS..BASIS + 2], [-2.0, 4.0]);
        assert!(covariance[BASIS * BASIS..].iter().all(|&v| v == 0.0));
    }

    #[test]
    fn rows_that_pictures_show_stay() {
        let count = 6;
        let placed = PlacedGaussian {
            position: DVec3::ZERO,
            node: [0; 3],
            node_weight: [1.0, 0.0, 0.0],
            part: 0,
            joint: [0; 4],
            joint_weight: [255, 0, 0, 0],
            facing: facing::EVERYWHERE,
        };
        let topology = Topology {
            gaussians: vec![placed; count],
            part_start: vec![0, count as u32],
            head_parts: 0,
            node_part: vec![0],
            followers: vec![vec![]],
            part_nodes: vec![vec![0]],
            widths: vec![3, 4, 2 * BASIS],
            expression_start: 3,
            activation: Activation::Relu,
            joints: 1,
            filter: Filter::DEFAULT,
        };
        let rows = CorrectiveRows::all(count);
        let layout = ParameterLayout::new(&topology, &rows);
        let mut parameters = Parameters::zeros(&layout);
        // Rotations vary more than colours.
        for (attribute, size) in [(0, 0.5), (2, 0.1)] {
            for row in 0..count {
                parameters.bases[layout.row(attribute, row)].fill(size);
            }
        }
        let mut covariance = vec![0.0; layout.parts * BASIS * BASIS];
        for part in covariance.chunks_exact_mut(BASIS * BASIS) {
            part[0] = 1.0;
        }
        let pruning = Pruning {
            parameters: &parameters,
            topology: &topology,
            layout: &layout,
            rows: &rows,
            covariance: &covariance,
        };
        let half = count.div_ceil(2);
        let even = pruning.by_variance(half as f64 / count as f64);
        assert_eq!(even.gaussian.each_ref().map(Vec::len), [half; 3]);
        // Colours are seen, and those of the last Gaussian most.
        let mut sensitivity = Sensitivity::new(count);
        let mut of = vec![[1e-6f32; 10]; count];
        for of in &mut of {
            of[8] = 1.0;
        }
        of[count - 1][8] = 10.0;
        sensitivity.add(&of);
        let seen = pruning.by_pictures(1.0 / count as f64, &sensitivity);
        assert_eq!(seen.gaussian[2].len(), 3);
        assert!(seen.gaussian[2].contains(&(count as u32 - 1)));
        assert!(seen.gaussian[0].is_empty() && seen.gaussian[1].is_empty());
    }

    #[test]
    fn what_varies_most_is_not_what_is_largest() {
        // The second feature never moves: large weights on it vary nothing.
        let mut c = vec![0.0; BASIS * BASIS];
        c[0] = 4.0;
        let mut still = vec![0.0f32; BASIS];
        still[1] = 10.0;
        let mut moving = vec![0.0f32; BASIS];
        moving[0] = 0.5;
        assert_eq!((quadratic(&still, &c), quadratic(&moving, &c)), (0.0, 1.0));
    }
}
