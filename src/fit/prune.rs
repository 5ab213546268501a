//! Which Gaussians keep their correctives: those whose correctives vary most over the training poses (the paper's section 3.2), or those
//! that pictures would lose most without.

use super::block::Kept;
use super::learner::Learner;
use super::shown;
use super::solve::Ground;
use crate::avatar::{Avatar, Rows};
use rayon::prelude::*;

/// How many keep them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Budget {
    /// N_P of each of rotation, scale and colour.
    Rows(usize),
    /// As many of each as it takes to keep this share of its variance, 0 to 1.
    Variance(f64),
    /// So many rows of all three together, those that pictures of the training frames would lose most without ([`shown`]).
    Shown(usize),
}

/// Sums over poses that arrive one after another (Welford's): means and covariance of N numbers.
struct Stream {
    count: f64,
    mean: Vec<f64>,
    products: Vec<f64>,
}

impl Stream {
    fn new(n: usize) -> Self {
        Self { count: 0.0, mean: vec![0.0; n], products: vec![0.0; n * n] }
    }

    fn add(&mut self, x: &[f32]) {
        self.count += 1.0;
        let n = self.mean.len();
        let before: Vec<f64> = x.iter().zip(&self.mean).map(|(&x, m)| f64::from(x) - m).collect();
        self.mean.iter_mut().zip(&before).for_each(|(m, d)| *m += d / self.count);
        for ((row, &x), mean) in self.products.chunks_exact_mut(n.max(1)).zip(x).zip(&self.mean) {
            let after = f64::from(x) - mean;
            row.iter_mut().zip(&before).for_each(|(sum, before)| *sum += after * before);
        }
    }

    fn covariance(&self) -> Vec<f64> {
        self.products.iter().map(|p| p / self.count.max(1.0)).collect()
    }
}

/// The variance of each row's corrective, summed over its components. Features stream by, pose after pose; a row's variance is bᵀ Σ b of
/// their covariance, so that no corrective of any pose is ever stored.
pub fn variances<const C: usize>(rows: &Rows<C>, starts: &[u32], basis: usize, covariance: &[Vec<f64>]) -> Vec<f64> {
    let row = |(at, &k): (usize, &u32)| {
        let sigma = &covariance[starts.partition_point(|&start| start <= k) - 1];
        let component = |b: &[f64]| (0..basis * basis).map(|i| b[i / basis] * sigma[i] * b[i % basis]).sum::<f64>();
        let numbers: Vec<f64> = rows.basis.row(at, C * basis).iter().collect();
        numbers.chunks_exact(basis).map(component).sum()
    };
    rows.gaussian.par_iter().enumerate().map(row).collect()
}

/// Rows by what leaving them out costs, dearest first; of equal ones the first.
fn order(costs: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..costs.len()).collect();
    order.sort_by(|&a, &b| costs[b].total_cmp(&costs[a]).then(a.cmp(&b)));
    order
}

/// How many of the rows of highest variance hold a share of all of it.
fn enough(variances: &[f64], share: f64) -> usize {
    let enough = share * variances.iter().sum::<f64>();
    let sums = order(variances).into_iter().scan(0.0, |sum, k| Some(std::mem::replace(sum, *sum + variances[k])));
    sums.take_while(|&before| before < enough).count()
}

/// The Gaussians of the `count` rows that cost most, rising.
fn keep(gaussians: &[u32], costs: &[f64], count: usize) -> Vec<u32> {
    let mut kept: Vec<u32> = order(costs).into_iter().take(count).map(|k| gaussians[k]).collect();
    kept.sort_unstable();
    kept
}

/// How many rows of each of three attributes are among the `count` that cost most of all.
fn divide(costs: &[Vec<f64>; 3], count: usize) -> [usize; 3] {
    let all: Vec<f64> = costs.concat();
    let ends = [costs[0].len(), costs[0].len() + costs[1].len(), all.len()];
    let mut counts = [0; 3];
    for row in order(&all).into_iter().take(count) {
        counts[ends.partition_point(|&end| end <= row)] += 1;
    }
    counts
}

/// What of an avatar's rows a budget keeps, by its networks' features over the training poses.
pub fn select(ground: &Ground, learner: &Learner, avatar: &Avatar, budget: Budget) -> Kept {
    let (n, width) = (ground.basis, 2 * ground.basis);
    let covariance = |part: usize| {
        let features = learner.features(part, &ground.seen);
        let mut stream = Stream::new(n);
        ground.training.iter().for_each(|&f| stream.add(&features[f * width..][..n]));
        stream.covariance()
    };
    let covariance: Vec<Vec<f64>> = (0..avatar.parts.len()).into_par_iter().map(covariance).collect();
    let starts = &avatar.parts.start;
    let rows = [&avatar.rotation_rows.gaussian, &avatar.scale_rows.gaussian, &avatar.color_rows.gaussian];
    let variances = [
        variances(&avatar.rotation_rows, starts, n, &covariance),
        variances(&avatar.scale_rows, starts, n, &covariance),
        variances(&avatar.color_rows, starts, n, &covariance),
    ];
    let (costs, counts) = match budget {
        Budget::Rows(count) => (variances, [count; 3]),
        Budget::Variance(share) => {
            let counts = std::array::from_fn(|a| enough(&variances[a], share));
            (variances, counts)
        }
        // There is nothing to choose.
        Budget::Shown(count) if count == 0 || count >= rows.iter().map(|rows| rows.len()).sum() => (variances, [count; 3]),
        Budget::Shown(count) => {
            let costs = shown::costs(ground, avatar, rows, variances);
            let counts = divide(&costs, count);
            (costs, counts)
        }
    };
    Kept(Some(std::array::from_fn(|a| keep(rows[a], &costs[a], counts[a]))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use half::f16;

    #[test]
    fn budgets_keep_the_rows_that_vary_most() {
        let (gaussians, variances) = ([2, 5, 7, 11], [1.0, 6.0, 0.5, 2.5]);
        assert_eq!(keep(&gaussians, &variances, 2), [5, 11]);
        assert_eq!(keep(&gaussians, &variances, 9), gaussians);
        assert_eq!([0.0, 0.85, 0.86, 1.0].map(|share| enough(&variances, share)), [0, 2, 3, 4]);
    }

    #[test]
    fn a_budget_of_all_attributes_goes_where_it_is_worth_most() {
        let costs = [vec![0.2, 5.0], vec![], vec![3.0, 0.1, 4.0]];
        assert_eq!(divide(&costs, 3), [1, 0, 2]);
        assert_eq!(divide(&costs, 4), [2, 0, 2]);
        assert_eq!(divide(&costs, 9), [2, 0, 3]);
    }

    #[test]
    fn a_rows_variance_is_that_of_its_correctives() {
        let features = [[1.0, 0.0], [-1.0, 2.0], [3.0, 1.0f32]];
        let mut stream = Stream::new(2);
        features.iter().for_each(|e| stream.add(e));
        let rows = Rows::<3> { gaussian: vec![4], basis: [1.0, -2.0, 0.0, 0.5, 0.0, 0.0].map(f16::from_f64).into_iter().collect() };
        let correctives: Vec<[f64; 2]> = features.iter().map(|e| [f64::from(e[0] - 2.0 * e[1]), f64::from(0.5 * e[1])]).collect();
        let expected: f64 = (0..2)
            .map(|c| {
                let mean = correctives.iter().map(|d| d[c]).sum::<f64>() / 3.0;
                correctives.iter().map(|d| (d[c] - mean).powi(2)).sum::<f64>() / 3.0
            })
            .sum();
        let got = variances(&rows, &[0, 3, 9], 2, &[vec![0.0; 4], stream.covariance()])[0];
        assert!((got - expected).abs() < 1e-9, "{got}, expected {expected}");
    }
}
