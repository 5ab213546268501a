//! Numbers over the frames in; first as the part's principal components, what its network should say of each frame; later, what the
//! network does say, the basis that makes the best of it.
//!
//! Networks and bases are refined in turn: given the bases, the networks learn the loss as it is ([`super::network::Target`]); given the
//! networks, the bases and neutral values are a linear least-squares problem with one solution.

use super::block::center;
use super::matrix::{View, gram, inverse, leading, product};
use half::f16;

/// Pulls basis rows towards 0: share of the features' mean variance.
const RIDGE: f64 = 1e-4;

/// One half of a part's loss: of its attributes, or of its nodes.
pub struct Half {
    /// M, shape basis, basis.
    pub form: Vec<f32>,
    /// c, shape F, basis.
    pub pull: Vec<f32>,
    /// Length F.
    pub energy: Vec<f32>,
}

/// A basis, ready to be stored.
pub struct Solution {
    /// A neutral value a column, rounded to f16, without the weight.
    pub neutral: Vec<f16>,
    /// Shape columns, basis.
    pub basis: Vec<f16>,
    pub half: Half,
}

/// The first target: the training frames' leading components. `x` has F rows, of which those of `training` are learnt from.
pub fn components(mut x: Vec<f32>, columns: usize, frames: usize, training: &[usize], basis: usize) -> Half {
    center(&mut x, columns, training);
    let energy: Vec<f32> =
        if columns == 0 { vec![0.0; frames] } else { x.chunks_exact(columns).map(|row| row.iter().map(|x| x * x).sum()).collect() };
    let mut half = Half { form: vec![0.0; basis * basis], pull: vec![0.0; frames * basis], energy };
    let count = training.len();
    let all = gram(&x, frames);
    let own: Vec<f64> = training.iter().flat_map(|&i| training.iter().map(move |&j| i * frames + j)).map(|at| all[at]).collect();
    let (values, vectors) = leading(&own, count, basis.min(count));
    for (k, (value, vector)) in values.iter().zip(&vectors).enumerate().filter(|(_, (value, _))| **value > 1e-12) {
        // Features have mean square 1 over the training frames; the basis is Xᵀ u / √count.
        half.form[k * basis + k] = (value / count as f64) as f32;
        for f in 0..frames {
            let sum: f64 = training.iter().zip(vector).map(|(&t, u)| all[f * frames + t] * u).sum();
            half.pull[f * basis + k] = (sum / (count as f64).sqrt()) as f32;
        }
    }
    half
}

/// The least-squares basis for given features, shape F, stride `width`, of which `basis` from `first` on count. Columns of `limit` (begin,
/// end, weight, least) shrink by `least`, times the weight, in root mean square: the L1 constraint on correctives.
pub struct Problem<'a> {
    pub x: Vec<f32>,
    pub columns: usize,
    pub frames: usize,
    pub training: &'a [usize],
    pub features: &'a [f32],
    pub width: usize,
    pub first: usize,
    pub basis: usize,
    /// For each run of columns its end, its weight and the constraint on its correctives.
    pub runs: &'a [(usize, f32, f32)],
}

impl Problem<'_> {
    pub fn solve(mut self) -> Solution {
        let (n, count) = (self.basis, self.training.len().max(1) as f64);
        let mean = center(&mut self.x, self.columns, self.training);
        let mut e: Vec<f32> = (0..self.frames).flat_map(|f| self.features[f * self.width + self.first..][..n].iter().copied()).collect();
        let middle = center(&mut e, n, self.training);
        let pick = |from: &[f32], width: usize| {
            self.training.iter().flat_map(|&f| from[f * width..][..width].iter().copied()).collect::<Vec<f32>>()
        };
        let (e_own, x_own) = (pick(&e, n), pick(&self.x, self.columns));
        let rows = self.training.len();
        let mut covariance = vec![0.0f32; n * n];
        product(View::new(&e_own, rows, n).transposed(), View::new(&e_own, rows, n), 0.0, &mut covariance);
        let mut form: Vec<f64> = covariance.iter().map(|&c| f64::from(c) / count).collect();
        let ridge = RIDGE * (0..n).map(|k| form[k * n + k]).sum::<f64>() / n as f64 + 1e-12;
        (0..n).for_each(|k| form[k * n + k] += ridge);
        let mut with = vec![0.0f32; n * self.columns];
        product(View::new(&e_own, rows, n).transposed(), View::new(&x_own, rows, self.columns), 0.0, &mut with);
        let back: Vec<f32> = inverse(&form, n, 1e-12).iter().map(|&v| (v / count) as f32).collect();
        let mut basis = vec![0.0f32; n * self.columns];
        product(View::new(&back, n, n), View::new(&with, n, self.columns), 0.0, &mut basis);
        self.constrain(&mut basis, &form);
        self.store(&mut basis, &mean, &middle)
    }

    /// Takes a corrective's root mean square down by the constraint, and no lower than 0. For features that are spread normally this is
    /// the L1 norm's own step.
    fn constrain(&self, basis: &mut [f32], form: &[f64]) {
        let n = self.basis;
        for column in 0..self.columns {
            let (weight, least) = self.run(column);
            if least <= 0.0 {
                continue;
            }
            let b = |k: usize| f64::from(basis[k * self.columns + column]);
            let size = (0..n * n).map(|at| b(at / n) * form[at] * b(at % n)).sum::<f64>().max(0.0).sqrt();
            let keep = (1.0 - f64::from(least * weight) / size.max(1e-30)).max(0.0) as f32;
            (0..n).for_each(|k| basis[k * self.columns + column] *= keep);
        }
    }

    fn run(&self, column: usize) -> (f32, f32) {
        self.runs.iter().find(|(end, ..)| column < *end).map_or((1.0, 0.0), |&(_, weight, least)| (weight, least))
    }

    /// Rounds to what the file holds, and works out the loss with that.
    fn store(self, basis: &mut [f32], mean: &[f32], middle: &[f32]) -> Solution {
        let (n, columns) = (self.basis, self.columns);
        let mut solution = Solution {
            neutral: Vec::with_capacity(columns),
            basis: vec![f16::ZERO; n * columns],
            half: Half { form: vec![0.0; n * n], pull: vec![0.0; self.frames * n], energy: vec![0.0; self.frames] },
        };
        let mut shift = vec![0.0; columns];
        for column in 0..columns {
            let weight = self.run(column).0.max(1e-30);
            let mut constant = mean[column];
            for k in 0..n {
                let entry = &mut basis[k * columns + column];
                let stored = f16::from_f32(*entry / weight);
                solution.basis[column * n + k] = stored;
                *entry = stored.to_f32() * weight;
                constant -= *entry * middle[k];
            }
            let neutral = f16::from_f32(constant / weight);
            solution.neutral.push(neutral);
            // The rows are about their mean, and are to be about the neutral value.
            shift[column] = mean[column] - neutral.to_f32() * weight;
        }
        let mut x = self.x;
        if columns > 0 {
            x.chunks_exact_mut(columns).for_each(|row| row.iter_mut().zip(&shift).for_each(|(x, s)| *x += s));
            solution.half.energy = x.chunks_exact(columns).map(|row| row.iter().map(|x| x * x).sum()).collect();
        }
        let b = View::new(basis, n, columns);
        product(b, b.transposed(), 0.0, &mut solution.half.form);
        product(View::new(&x, self.frames, columns), b.transposed(), 0.0, &mut solution.half.pull);
        solution
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six frames, of which five are learnt from; three columns made of two features.
    fn numbers() -> (Vec<f32>, Vec<f32>) {
        let e = [[1.0, 0.5], [-1.0, 0.2], [0.3, -1.0], [0.6, 0.9], [-0.9, -0.6], [0.2, 0.7f32]];
        let x = e.iter().flat_map(|[a, b]| [2.0 + a, 3.0 * b - a, 0.5]).collect();
        (x, e.concat())
    }

    #[test]
    fn the_basis_rebuilds_what_features_made_and_held_frames_follow() {
        let (x, features) = numbers();
        let problem =
            Problem { x, columns: 3, frames: 6, training: &[0, 1, 2, 3, 4], features: &features, width: 2, first: 0, basis: 2, runs: &[] };
        let solution = problem.solve();
        let near = |got: f16, expected: f32| assert!((got.to_f32() - expected).abs() < 2e-3, "{got}, expected {expected}");
        [2.0, 0.0, 0.5].into_iter().zip(&solution.neutral).for_each(|(expected, &got)| near(got, expected));
        [1.0, 0.0, -1.0, 3.0, 0.0, 0.0].into_iter().zip(&solution.basis).for_each(|(expected, &got)| near(got, expected));
        let target = super::super::network::Target { form: solution.half.form, pull: solution.half.pull, energy: solution.half.energy };
        (0..6).for_each(|f| assert!(target.loss(f, &features[2 * f..][..2]).abs() < 1e-3, "frame {f}"));
    }

    #[test]
    fn a_constraint_shrinks_correctives_and_takes_small_ones_away() {
        let (x, features) = numbers();
        let solve = |least: f32| {
            let runs = [(3, 1.0, least)];
            let problem = Problem {
                x: x.clone(),
                columns: 3,
                frames: 6,
                training: &[0, 1, 2, 3, 4],
                features: &features,
                width: 2,
                first: 0,
                basis: 2,
                runs: &runs,
            };
            problem.solve().basis.iter().map(|b| b.to_f32()).collect::<Vec<_>>()
        };
        let (free, some, much) = (solve(0.0), solve(0.2), solve(1.0));
        assert!(some[0] > 0.5 && some[0] < 0.9 * free[0], "{some:?} of {free:?}");
        assert!(much[0] == 0.0 && much[3] > 1.0, "{much:?} of {free:?}");
    }

    #[test]
    fn components_leave_nothing_of_two_features() {
        let (x, _) = numbers();
        let half = components(x, 3, 6, &[0, 1, 2, 3, 4], 2);
        for f in 0..6 {
            let left = (0..2).fold(half.energy[f], |left, k| left - half.pull[f * 2 + k].powi(2) / half.form[3 * k]);
            assert!(left.abs() < 1e-3, "frame {f}: {left} of {}", half.energy[f]);
        }
    }
}
