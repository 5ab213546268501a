//! Rows by a budget: those whose correctives vary most over the poses (the paper's section 3.2), or
//! those that images in them would lose most without.

use crate::prune::contribution::image_costs;
use crate::prune::subject::RowSubject;
use effigy_core::avatar::{Avatar, Rows};
use rayon::prelude::*;

/// How many rows to retain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RowBudget {
    /// N_P rows of each of rotation, scale and colour.
    Rows(usize),
    /// For each attribute, the fewest rows that hold this share of its variance, 0 to 1.
    Variance(f64),
    /// So many rows of all three attributes together: those that images would lose most
    /// without.
    Contribution(usize),
}

/// The variance of each row's corrective, summed over its components: bᵀ Σ b of the covariance of
/// its part's features, so that no corrective of any pose is ever stored. `starts`: where each
/// part's Gaussians begin. `covariances`: one a part.
fn row_variances<const C: usize>(
    rows: &Rows<C>,
    starts: &[u32],
    basis: usize,
    covariances: &[Vec<f64>],
) -> Vec<f64> {
    let variance = |row: usize| {
        let gaussian = rows.gaussian[row];
        let part = starts.partition_point(|&start| start <= gaussian) - 1;
        let covariance = &covariances[part];
        let of_component = |b: &[f64]| {
            (0..basis * basis)
                .map(|i| b[i / basis] * covariance[i] * b[i % basis])
                .sum::<f64>()
        };
        let numbers: Vec<f64> = rows.basis.row(row, C * basis).iter().collect();
        numbers.chunks_exact(basis).map(of_component).sum()
    };
    (0..rows.gaussian.len())
        .into_par_iter()
        .map(variance)
        .collect()
}

/// Indices by falling cost; of equal costs the first comes first.
fn by_falling_cost(costs: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..costs.len()).collect();
    order.sort_by(|&a, &b| costs[b].total_cmp(&costs[a]).then(a.cmp(&b)));
    order
}

/// The fewest rows that hold a share of the summed variance.
fn rows_for_variance(variances: &[f64], share: f64) -> usize {
    let enough = share * variances.iter().sum::<f64>();
    let mut held = 0.0;
    let mut count = 0;
    for row in by_falling_cost(variances) {
        if held >= enough {
            break;
        }
        held += variances[row];
        count += 1;
    }
    count
}

/// The Gaussians of the `count` rows that cost most, in rising order.
fn costliest(gaussians: &[u32], costs: &[f64], count: usize) -> Vec<u32> {
    let mut retained: Vec<u32> = by_falling_cost(costs)
        .into_iter()
        .take(count)
        .map(|row| gaussians[row])
        .collect();
    retained.sort_unstable();
    retained
}

/// How many rows of each attribute are among the `count` rows that cost most of all.
fn divide_budget(costs: &[Vec<f64>; 3], count: usize) -> [usize; 3] {
    let all: Vec<f64> = costs.concat();
    let ends = [costs[0].len(), costs[0].len() + costs[1].len(), all.len()];
    let mut counts = [0; 3];
    for row in by_falling_cost(&all).into_iter().take(count) {
        counts[ends.partition_point(|&end| end <= row)] += 1;
    }
    counts
}

/// The Gaussians whose rows of rotation, scale and colour a budget retains, each in rising order.
pub fn select_rows(subject: &RowSubject, avatar: &Avatar, budget: RowBudget) -> [Vec<u32>; 3] {
    let basis = avatar.basis_len();
    let covariances = &subject.covariances;
    let starts = &avatar.parts.start;
    let gaussians = [
        &avatar.rotation_rows.gaussian,
        &avatar.scale_rows.gaussian,
        &avatar.color_rows.gaussian,
    ];
    let variances = [
        row_variances(&avatar.rotation_rows, starts, basis, covariances),
        row_variances(&avatar.scale_rows, starts, basis, covariances),
        row_variances(&avatar.color_rows, starts, basis, covariances),
    ];
    let row_count: usize = gaussians.iter().map(|list| list.len()).sum();
    let mut costs = variances;
    let counts = match budget {
        RowBudget::Rows(count) => [count; 3],
        RowBudget::Variance(share) => [0, 1, 2].map(|a| rows_for_variance(&costs[a], share)),
        // All or none: there is nothing to choose, and no image to draw.
        RowBudget::Contribution(count) if count == 0 || count >= row_count => [count; 3],
        RowBudget::Contribution(count) => {
            costs = image_costs(subject, avatar, gaussians, costs);
            divide_budget(&costs, count)
        }
    };
    std::array::from_fn(|a| costliest(gaussians[a], &costs[a], counts[a]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_math::covariance::RunningCovariance;
    use half::f16;

    #[test]
    fn budgets_retain_the_rows_that_vary_most() {
        let gaussians = [2, 5, 7, 11];
        let variances = [1.0, 6.0, 0.5, 2.5];
        assert_eq!(costliest(&gaussians, &variances, 2), [5, 11]);
        assert_eq!(costliest(&gaussians, &variances, 9), gaussians);
        assert_eq!(
            [0.0, 0.85, 0.86, 1.0].map(|share| rows_for_variance(&variances, share)),
            [0, 2, 3, 4]
        );
    }

    #[test]
    fn a_common_budget_goes_where_rows_cost_most() {
        let costs = [vec![0.2, 5.0], vec![], vec![3.0, 0.1, 4.0]];
        assert_eq!(divide_budget(&costs, 3), [1, 0, 2]);
        assert_eq!(divide_budget(&costs, 4), [2, 0, 2]);
        assert_eq!(divide_budget(&costs, 9), [2, 0, 3]);
    }

    #[test]
    fn row_variance_is_that_of_its_correctives() {
        let features = [[1.0, 0.0], [-1.0, 2.0], [3.0, 1.0f32]];
        let mut running = RunningCovariance::new(2);
        for e in &features {
            running.add(e);
        }
        let rows = Rows::<3> {
            gaussian: vec![4],
            basis: [1.0, -2.0, 0.0, 0.5, 0.0, 0.0]
                .map(f16::from_f64)
                .into_iter()
                .collect(),
        };
        let correctives: Vec<[f64; 2]> = features
            .iter()
            .map(|e| [f64::from(e[0] - 2.0 * e[1]), f64::from(0.5 * e[1])])
            .collect();
        let component_variance = |c: usize| {
            let mean = correctives.iter().map(|d| d[c]).sum::<f64>() / 3.0;
            let squares = correctives.iter().map(|d| (d[c] - mean).powi(2));
            squares.sum::<f64>() / 3.0
        };
        let expected = component_variance(0) + component_variance(1);
        let covariances = [vec![0.0; 4], running.covariance()];
        let got = row_variances(&rows, &[0, 3, 9], 2, &covariances)[0];
        assert!((got - expected).abs() < 1e-9, "{got}, expected {expected}");
    }
}
