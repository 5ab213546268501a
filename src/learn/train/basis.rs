//! The numbers of a part as a small basis times features. At first these are the part's principal
//! components, which are its network's first target. Later they are the network's own features,
//! with the basis that fits them best.
//!
//! Networks and bases are refined in turn. Given the bases, the networks learn the loss as it is
//! ([`QuadraticLoss`](super::network::QuadraticLoss)). Given the networks, bases and neutral values
//! are a linear least-squares problem with one solution.

use crate::math::matrix::{
    LeadingEigenvectors, MatrixView, gram, inverse, leading_eigenvectors, multiply,
};
use crate::train::block::center;
use half::f16;

/// Pulls basis rows towards 0, as a share of the features' mean variance.
const RIDGE: f64 = 1e-4;

/// The loss of one half of a part's features: those of its attributes, or those of its nodes. See
/// [`QuadraticLoss`](super::network::QuadraticLoss).
pub struct HalfLoss {
    /// M, shape basis, basis.
    pub quadratic: Vec<f32>,
    /// c, shape F, basis.
    pub linear: Vec<f32>,
    /// Length F.
    pub energy: Vec<f32>,
}

/// A basis, ready to be stored.
pub struct Solution {
    /// One neutral value a column, rounded to f16, without the weight.
    pub neutral: Vec<f16>,
    /// Shape columns, basis; without the weight.
    pub basis: Vec<f16>,
    /// The loss with the rounded numbers.
    pub loss: HalfLoss,
}

/// The first target: features that are the leading principal components of the training frames,
/// with mean square 1 over these. `x` has shape `frames`, `columns`; rows of frames that are not in
/// `training` are described by the same components.
pub fn principal_components(
    mut x: Vec<f32>,
    columns: usize,
    frames: usize,
    training: &[usize],
    basis: usize,
) -> HalfLoss {
    center(&mut x, columns, training);
    let mut loss = HalfLoss {
        quadratic: vec![0.0; basis * basis],
        linear: vec![0.0; frames * basis],
        energy: row_energies(&x, columns, frames),
    };
    let count = training.len();
    let all = gram(&x, frames);
    let own: Vec<f64> = training
        .iter()
        .flat_map(|&i| training.iter().map(move |&j| i * frames + j))
        .map(|at| all[at])
        .collect();
    let LeadingEigenvectors { values, vectors } =
        leading_eigenvectors(&own, count, basis.min(count));
    for (k, vector) in vectors.iter().enumerate() {
        if values[k] <= 1e-12 {
            continue;
        }
        // The basis is Xᵀ u / √count for the eigenvector u.
        loss.quadratic[k * basis + k] = (values[k] / count as f64) as f32;
        for f in 0..frames {
            let sum: f64 = training
                .iter()
                .zip(vector)
                .map(|(&t, u)| all[f * frames + t] * u)
                .sum();
            loss.linear[f * basis + k] = (sum / (count as f64).sqrt()) as f32;
        }
    }
    loss
}

/// The squared length of each row.
fn row_energies(x: &[f32], columns: usize, rows: usize) -> Vec<f32> {
    if columns == 0 {
        return vec![0.0; rows];
    }
    x.chunks_exact(columns)
        .map(|row| row.iter().map(|x| x * x).sum())
        .collect()
}

/// Neighbouring columns of one attribute.
#[derive(Clone, Copy, Debug)]
pub struct ColumnRun {
    /// The run ends before this column.
    pub end: usize,
    /// The factor of its numbers.
    pub weight: f32,
    /// The L1 constraint: the root mean square of a corrective shrinks by this, times the weight.
    pub constraint: f32,
}

/// The least-squares problem of a part's basis for given features.
pub struct BasisProblem<'a> {
    /// Shape frames, columns.
    pub x: Vec<f32>,
    /// Numbers a frame.
    pub columns: usize,
    /// F.
    pub frames: usize,
    /// The frames that the basis is fitted to.
    pub training: &'a [usize],
    /// Shape frames, `feature_width`.
    pub features: &'a [f32],
    /// Numbers a row of `features`.
    pub feature_width: usize,
    /// The first of the features that count; `basis` of them do.
    pub first_feature: usize,
    /// N_B.
    pub basis: usize,
    /// In rising order. Columns behind the last run have weight 1 and no constraint.
    pub runs: &'a [ColumnRun],
}

impl BasisProblem<'_> {
    /// The best basis and neutral values, rounded as in the file.
    pub fn solve(mut self) -> Solution {
        let n = self.basis;
        let rows = self.training.len();
        let count = rows.max(1) as f64;
        let mean = center(&mut self.x, self.columns, self.training);
        let mut features: Vec<f32> = (0..self.frames)
            .flat_map(|f| {
                let row = &self.features[f * self.feature_width + self.first_feature..][..n];
                row.iter().copied()
            })
            .collect();
        let feature_mean = center(&mut features, n, self.training);
        let own_features = self.training_rows(&features, n);
        let own_x = self.training_rows(&self.x, self.columns);
        let own_features = MatrixView::new(&own_features, rows, n);

        let mut covariance = vec![0.0f32; n * n];
        multiply(
            own_features.transposed(),
            own_features,
            0.0,
            &mut covariance,
        );
        let mut covariance: Vec<f64> = covariance.iter().map(|&c| f64::from(c) / count).collect();
        let ridge = RIDGE * (0..n).map(|k| covariance[k * n + k]).sum::<f64>() / n as f64 + 1e-12;
        for k in 0..n {
            covariance[k * n + k] += ridge;
        }

        let mut correlation = vec![0.0f32; n * self.columns];
        multiply(
            own_features.transposed(),
            MatrixView::new(&own_x, rows, self.columns),
            0.0,
            &mut correlation,
        );
        let inverse: Vec<f32> = inverse(&covariance, n, 1e-12)
            .iter()
            .map(|&v| (v / count) as f32)
            .collect();
        let mut basis = vec![0.0f32; n * self.columns];
        multiply(
            MatrixView::new(&inverse, n, n),
            MatrixView::new(&correlation, n, self.columns),
            0.0,
            &mut basis,
        );
        self.constrain(&mut basis, &covariance);
        self.round(&mut basis, &mean, &feature_mean)
    }

    fn training_rows(&self, from: &[f32], width: usize) -> Vec<f32> {
        let row = |&f: &usize| from[f * width..][..width].iter().copied();
        self.training.iter().flat_map(row).collect()
    }

    /// Shrinks each corrective's root mean square by the constraint, but not below 0. For normally
    /// distributed features this is the L1 norm's proximal step.
    fn constrain(&self, basis: &mut [f32], covariance: &[f64]) {
        let n = self.basis;
        for column in 0..self.columns {
            let run = self.run(column);
            if run.constraint <= 0.0 {
                continue;
            }
            let b = |k: usize| f64::from(basis[k * self.columns + column]);
            let size = (0..n * n)
                .map(|at| b(at / n) * covariance[at] * b(at % n))
                .sum::<f64>()
                .max(0.0)
                .sqrt();
            let loss = f64::from(run.constraint * run.weight);
            let keep = (1.0 - loss / size.max(1e-30)).max(0.0) as f32;
            for k in 0..n {
                basis[k * self.columns + column] *= keep;
            }
        }
    }

    /// The run that a column is in.
    fn run(&self, column: usize) -> ColumnRun {
        let outside = ColumnRun {
            end: self.columns,
            weight: 1.0,
            constraint: 0.0,
        };
        self.runs
            .iter()
            .find(|run| column < run.end)
            .copied()
            .unwrap_or(outside)
    }

    /// Rounds basis and neutral values as in the file, and computes the loss with them.
    fn round(self, basis: &mut [f32], mean: &[f32], feature_mean: &[f32]) -> Solution {
        let n = self.basis;
        let columns = self.columns;
        let mut neutrals = Vec::with_capacity(columns);
        let mut stored_basis = vec![f16::ZERO; n * columns];
        let mut shift = vec![0.0; columns];
        for column in 0..columns {
            let weight = self.run(column).weight.max(1e-30);
            let mut constant = mean[column];
            for k in 0..n {
                let entry = &mut basis[k * columns + column];
                let stored = f16::from_f32(*entry / weight);
                stored_basis[column * n + k] = stored;
                *entry = stored.to_f32() * weight;
                constant -= *entry * feature_mean[k];
            }
            let neutral = f16::from_f32(constant / weight);
            neutrals.push(neutral);
            shift[column] = mean[column] - neutral.to_f32() * weight;
        }
        // Rows are relative to their mean; the loss is relative to the neutral values.
        let mut x = self.x;
        if columns > 0 {
            for row in x.chunks_exact_mut(columns) {
                for (x, shift) in row.iter_mut().zip(&shift) {
                    *x += shift;
                }
            }
        }
        let mut loss = HalfLoss {
            quadratic: vec![0.0; n * n],
            linear: vec![0.0; self.frames * n],
            energy: row_energies(&x, columns, self.frames),
        };
        let b = MatrixView::new(basis, n, columns);
        multiply(b, b.transposed(), 0.0, &mut loss.quadratic);
        multiply(
            MatrixView::new(&x, self.frames, columns),
            b.transposed(),
            0.0,
            &mut loss.linear,
        );
        Solution {
            neutral: neutrals,
            basis: stored_basis,
            loss,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::train::network::QuadraticLoss;

    /// Three columns made of two features, in six frames of which five are for training.
    struct Sample {
        x: Vec<f32>,
        features: Vec<f32>,
    }

    fn sample() -> Sample {
        let features = [
            [1.0, 0.5],
            [-1.0, 0.2],
            [0.3, -1.0],
            [0.6, 0.9],
            [-0.9, -0.6],
            [0.2, 0.7f32],
        ];
        Sample {
            x: features
                .iter()
                .flat_map(|[a, b]| [2.0 + a, 3.0 * b - a, 0.5])
                .collect(),
            features: features.concat(),
        }
    }

    fn solve(sample: &Sample, runs: &[ColumnRun]) -> Solution {
        let problem = BasisProblem {
            x: sample.x.clone(),
            columns: 3,
            frames: 6,
            training: &[0, 1, 2, 3, 4],
            features: &sample.features,
            feature_width: 2,
            first_feature: 0,
            basis: 2,
            runs,
        };
        problem.solve()
    }

    fn assert_near(got: &[f16], expected: &[f32]) {
        for (got, expected) in got.iter().zip(expected) {
            assert!(
                (got.to_f32() - expected).abs() < 2e-3,
                "{got}, expected {expected}"
            );
        }
    }

    #[test]
    fn the_basis_rebuilds_training_and_held_out_frames() {
        let sample = sample();
        let solution = solve(&sample, &[]);
        assert_near(&solution.neutral, &[2.0, 0.0, 0.5]);
        assert_near(&solution.basis, &[1.0, 0.0, -1.0, 3.0, 0.0, 0.0]);
        let target = QuadraticLoss {
            quadratic: solution.loss.quadratic,
            linear: solution.loss.linear,
            energy: solution.loss.energy,
        };
        for f in 0..6 {
            let loss = target.loss(f, &sample.features[2 * f..][..2]);
            assert!(loss.abs() < 1e-3, "frame {f}: {loss}");
        }
    }

    #[test]
    fn the_constraint_shrinks_correctives_small_ones_to_zero() {
        let sample = sample();
        let basis = |constraint: f32| {
            let run = ColumnRun {
                end: 3,
                weight: 1.0,
                constraint,
            };
            let basis = solve(&sample, &[run]).basis;
            basis.iter().map(|b| b.to_f32()).collect::<Vec<_>>()
        };
        let free = basis(0.0);
        let weak = basis(0.2);
        let strong = basis(1.0);
        assert!(
            weak[0] > 0.5 && weak[0] < 0.9 * free[0],
            "{weak:?} of {free:?}"
        );
        assert!(
            strong[0] == 0.0 && strong[3] > 1.0,
            "{strong:?} of {free:?}"
        );
    }

    #[test]
    fn two_components_explain_two_features() {
        let loss = principal_components(sample().x, 3, 6, &[0, 1, 2, 3, 4], 2);
        for f in 0..6 {
            let explained = |k: usize| loss.linear[f * 2 + k].powi(2) / loss.quadratic[3 * k];
            let left = loss.energy[f] - explained(0) - explained(1);
            assert!(left.abs() < 1e-3, "frame {f}: {left} of {}", loss.energy[f]);
        }
    }
}
