//! The best features of a part, and the best bases for features that a network gives: from
//! covariances alone.
//!
//! Let Δ be the anchors' features less their means (m numbers a row), C the columns' linear map,
//! Σ = mean ΔΔᵀ, Q = CᵀC. The columns x = C Δ have principal components v with C Σ Cᵀ v = λ v; g = Cᵀ v
//! solves Q Σ g = λ g. With Σ = L Lᵀ that is the symmetric problem LᵀQL h = λ h, g = Q L h / √λ,
//! and gᵀΔ is how far x lies along v.
//!
//! For given features e of mean 0 and covariance E, the best basis is C T, T = mean(Δ eᵀ) E⁻¹.

use crate::distil::basis::{HalfLoss, Solution, center};
use crate::distil::columns::ColumnSet;
use crate::distil::teacher::AnchorFeatures;
use effigy_math::matrix::{Eigen, MatrixView, cholesky, eigen, inverse, multiply, multiply_f64};
use half::f16;

/// Keeps Σ positive, as a share of its mean variance.
const FLOOR: f64 = 1e-7;
/// Pulls bases towards 0, as a share of the features' mean variance.
const RIDGE: f64 = 1e-5;

/// A part's columns with what follows from the rows of inputs.
pub struct PartProblem<'a> {
    /// The columns.
    pub columns: ColumnSet,
    /// Δ, shape rows, m.
    deviations: Vec<f32>,
    /// Q, shape m, m.
    quadratic: Vec<f64>,
    rows: usize,
    training: &'a [usize],
}

impl<'a> PartProblem<'a> {
    /// Of columns whose means are those of `training` rows.
    pub fn new(
        columns: ColumnSet,
        features: &AnchorFeatures,
        means: &[Vec<f32>],
        training: &'a [usize],
    ) -> Self {
        Self {
            deviations: columns.deviations(features, means),
            quadratic: columns.quadratic(),
            rows: features.rows,
            columns,
            training,
        }
    }

    fn width(&self) -> usize {
        self.columns.width()
    }

    /// The rows of a matrix that are learned from.
    fn training_rows(&self, from: &[f32], width: usize) -> Vec<f32> {
        let row = |&row: &usize| from[row * width..][..width].iter().copied();
        self.training.iter().flat_map(row).collect()
    }

    /// Σ, shape m, m.
    fn covariance(&self) -> Vec<f64> {
        let width = self.width();
        let own = self.training_rows(&self.deviations, width);
        let own = MatrixView::new(&own, self.training.len(), width);
        let mut sum = vec![0.0f32; width * width];
        multiply(own.transposed(), own, 0.0, &mut sum);
        let count = self.training.len().max(1) as f64;
        sum.iter().map(|&sum| f64::from(sum) / count).collect()
    }

    /// Squared deviations of all columns from their means, mean over the training rows.
    pub fn spread(&self) -> f64 {
        let pairs = self.quadratic.iter().zip(self.covariance());
        pairs.map(|(q, sigma)| q * sigma).sum::<f64>().max(0.0)
    }

    /// ‖x‖² of each row, about the means.
    fn energies(&self) -> Vec<f32> {
        let width = self.width();
        let quadratic: Vec<f32> = self.quadratic.iter().map(|&q| q as f32).collect();
        let mut image = vec![0.0f32; self.rows * width];
        multiply(
            MatrixView::new(&self.deviations, self.rows, width),
            MatrixView::new(&quadratic, width, width),
            0.0,
            &mut image,
        );
        (0..self.rows)
            .map(|row| {
                let range = row * width..(row + 1) * width;
                let pairs = image[range.clone()].iter().zip(&self.deviations[range]);
                pairs.map(|(a, b)| a * b).sum::<f32>().max(0.0)
            })
            .collect()
    }

    /// The first target: the `basis` leading principal components of the columns over the training
    /// rows, with mean square 1.
    pub fn principal_components(&self, basis: usize) -> HalfLoss {
        let width = self.width();
        let mut loss = HalfLoss {
            quadratic: vec![0.0; basis * basis],
            linear: vec![0.0; self.rows * basis],
            energy: self.energies(),
        };
        if width == 0 {
            return loss;
        }
        let mut sigma = self.covariance();
        let trace: f64 = (0..width).map(|k| sigma[k * width + k]).sum();
        let floor = FLOOR * trace / width as f64 + 1e-20;
        for k in 0..width {
            sigma[k * width + k] += floor;
        }
        let l = cholesky(&sigma, width, floor);
        let l = MatrixView::new(&l, width, width);
        let mut ql = vec![0.0; width * width];
        multiply_f64(
            MatrixView::new(&self.quadratic, width, width),
            l,
            0.0,
            &mut ql,
        );
        let mut symmetric = vec![0.0; width * width];
        multiply_f64(
            l.transposed(),
            MatrixView::new(&ql, width, width),
            0.0,
            &mut symmetric,
        );
        let Eigen { values, vectors } = eigen(&symmetric, width);
        let largest = values.first().copied().unwrap_or_default();
        for (k, (&value, h)) in values.iter().zip(&vectors).take(basis).enumerate() {
            if value <= 1e-12 * largest {
                continue;
            }
            // The basis is √λ v, and the linear term √λ times how far x lies along v.
            loss.quadratic[k * basis + k] = value as f32;
            let g: Vec<f32> = (0..width)
                .map(|i| {
                    let row = &ql[i * width..][..width];
                    row.iter().zip(h).map(|(q, h)| q * h).sum::<f64>() as f32
                })
                .collect();
            let rows = self.deviations.chunks_exact(width);
            for (row, deviation) in rows.enumerate() {
                loss.linear[row * basis + k] =
                    deviation.iter().zip(&g).map(|(a, b)| a * b).sum::<f32>();
            }
        }
        loss
    }

    /// The best basis and neutral values for features: `basis` of each row of `features`, which is
    /// `feature_width` wide, from `first` on. `weights`: the factor that each column was given.
    pub fn solve(
        &self,
        features: &[f32],
        feature_width: usize,
        first: usize,
        basis: usize,
        weights: &[f32],
    ) -> Solution {
        let (width, rows, count) = (self.width(), self.rows, self.training.len());
        let own = features.chunks_exact(feature_width.max(1));
        let mut e: Vec<f32> = own
            .flat_map(|row| row[first..first + basis].iter().copied())
            .collect();
        let mean_feature = center(&mut e, basis, self.training);
        let learned = self.training_rows(&e, basis);
        let learned = MatrixView::new(&learned, count, basis);
        let mut covariance = vec![0.0f32; basis * basis];
        multiply(learned.transposed(), learned, 0.0, &mut covariance);
        let mut covariance: Vec<f64> = covariance
            .iter()
            .map(|&sum| f64::from(sum) / count.max(1) as f64)
            .collect();
        let trace: f64 = (0..basis).map(|k| covariance[k * basis + k]).sum();
        for k in 0..basis {
            covariance[k * basis + k] += RIDGE * trace / basis as f64 + 1e-12;
        }
        let inverse: Vec<f32> = inverse(&covariance, basis, 1e-12)
            .iter()
            .map(|&v| (v / count.max(1) as f64) as f32)
            .collect();
        let deviations = self.training_rows(&self.deviations, width);
        let mut cross = vec![0.0f32; width * basis];
        multiply(
            MatrixView::new(&deviations, count, width).transposed(),
            learned,
            0.0,
            &mut cross,
        );
        let mut t = vec![0.0f32; width * basis];
        multiply(
            MatrixView::new(&cross, width, basis),
            MatrixView::new(&inverse, basis, basis),
            0.0,
            &mut t,
        );
        let rounded = self.round(&t, basis, &mean_feature, weights);
        let mut linear = vec![0.0f32; rows * basis];
        for row in linear.chunks_exact_mut(basis) {
            row.copy_from_slice(&rounded.side);
        }
        multiply(
            MatrixView::new(&self.deviations, rows, width),
            MatrixView::new(&rounded.map, width, basis),
            1.0,
            &mut linear,
        );
        let mut energy = self.energies();
        for (row, energy) in energy.iter_mut().enumerate() {
            let deviation = &self.deviations[row * width..][..width];
            let along: f32 = deviation
                .iter()
                .zip(&rounded.shift)
                .map(|(a, b)| a * b)
                .sum();
            *energy = (*energy + 2.0 * along + rounded.constant).max(0.0);
        }
        Solution {
            neutral: rounded.neutral,
            basis: rounded.basis,
            loss: HalfLoss {
                quadratic: rounded.quadratic,
                linear,
                energy,
            },
        }
    }

    /// Rounds bases and neutral values as in the file, and sums what the loss with them needs. `t`
    /// has shape m, basis.
    fn round(&self, t: &[f32], basis: usize, mean_feature: &[f32], weights: &[f32]) -> Rounded {
        let columns = &self.columns;
        let own_basis = columns.basis();
        let width = self.width();
        let mut sums = Rounded {
            neutral: Vec::with_capacity(columns.len()),
            basis: Vec::with_capacity(columns.len() * basis),
            quadratic: vec![0.0; basis * basis],
            map: vec![0.0; width * basis],
            shift: vec![0.0; width],
            side: vec![0.0; basis],
            constant: 0.0,
        };
        let mut blended = vec![0.0f32; own_basis * basis];
        let mut stored = Vec::new();
        let mut product = vec![0.0f32; own_basis * basis];
        let mut along = vec![0.0f32; own_basis];
        for item in &columns.items {
            blended.fill(0.0);
            for share in &item.shares {
                let own = &t[share.index * own_basis * basis..][..own_basis * basis];
                for (sum, own) in blended.iter_mut().zip(own) {
                    *sum += share.weight * own;
                }
            }
            let count = item.columns.len();
            let matrix = &columns.matrix[item.columns.start * own_basis..][..count * own_basis];
            let matrix = MatrixView::new(matrix, count, own_basis);
            stored.clear();
            stored.resize(count * basis, 0.0f32);
            multiply(
                matrix,
                MatrixView::new(&blended, own_basis, basis),
                0.0,
                &mut stored,
            );
            along.fill(0.0);
            for (at, column) in item.columns.clone().enumerate() {
                let weight = weights[column];
                let row = &mut stored[at * basis..][..basis];
                let mut constant = columns.mean[column];
                for (entry, mean) in row.iter_mut().zip(mean_feature) {
                    let half = f16::from_f32(*entry / weight);
                    sums.basis.push(half);
                    *entry = half.to_f32() * weight;
                    constant -= *entry * mean;
                }
                let neutral = f16::from_f32(constant / weight);
                sums.neutral.push(neutral);
                // Of the mean about the stored neutral value.
                let left = columns.mean[column] - neutral.to_f32() * weight;
                sums.constant += left * left;
                for (side, entry) in sums.side.iter_mut().zip(row) {
                    *side += left * *entry;
                }
                for (along, own) in along.iter_mut().zip(columns.column(column)) {
                    *along += left * own;
                }
            }
            let view = MatrixView::new(&stored, count, basis);
            multiply(view.transposed(), view, 1.0, &mut sums.quadratic);
            multiply(matrix.transposed(), view, 0.0, &mut product);
            for share in &item.shares {
                let start = share.index * own_basis;
                let out = &mut sums.map[start * basis..][..own_basis * basis];
                for (out, own) in out.iter_mut().zip(&product) {
                    *out += share.weight * own;
                }
                for (out, own) in sums.shift[start..].iter_mut().zip(&along) {
                    *out += share.weight * own;
                }
            }
        }
        sums
    }
}

/// Bases as in the file, B' with the columns' factors, and sums over all columns. d is the columns'
/// mean less the stored neutral value.
struct Rounded {
    /// Without the factor.
    neutral: Vec<f16>,
    /// Without the factor, shape columns, basis.
    basis: Vec<f16>,
    /// B'ᵀ B'.
    quadratic: Vec<f32>,
    /// Cᵀ B', shape m, basis.
    map: Vec<f32>,
    /// Cᵀ d, length m.
    shift: Vec<f32>,
    /// B'ᵀ d.
    side: Vec<f32>,
    /// dᵀ d.
    constant: f32,
}
