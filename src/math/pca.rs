//! Principal components of a few dozen numbers.

use crate::matrix::{Eigen, eigen};
use effigy_core::avatar::Subspace;

/// The first `count` principal components of rows of `width` numbers each, with their mean and
/// standard deviations. Fewer where fewer directions vary.
pub fn pca(rows: &[Vec<f64>], width: usize, count: usize) -> Subspace {
    let number = rows.len().max(1) as f64;
    let mean: Vec<f64> = (0..width)
        .map(|k| rows.iter().map(|row| row[k]).sum::<f64>() / number)
        .collect();
    let mut covariance = vec![0.0; width * width];
    for i in 0..width {
        for j in i..width {
            let sum: f64 = rows
                .iter()
                .map(|row| (row[i] - mean[i]) * (row[j] - mean[j]))
                .sum();
            covariance[i * width + j] = sum / number;
            covariance[j * width + i] = sum / number;
        }
    }
    let Eigen { values, vectors } = eigen(&covariance, width);
    let count = values.iter().take(count).filter(|&&v| v > 1e-10).count();
    Subspace {
        mean: mean.iter().map(|&m| m as f32).collect(),
        component: vectors[..count]
            .iter()
            .flatten()
            .map(|&c| c as f32)
            .collect(),
        sigma: values[..count].iter().map(|v| v.sqrt() as f32).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_on_a_line_have_one_component_along_it() {
        let rows: Vec<Vec<f64>> = [-1.0, 0.0, 4.0]
            .iter()
            .map(|t| vec![1.0 + 0.6 * t, 2.0 + 0.8 * t])
            .collect();
        let space = pca(&rows, 2, 2);
        assert_eq!(space.sigma.len(), 1, "{space:?}");
        assert!(
            (space.component[0].abs() - 0.6).abs() < 1e-6
                && (space.component[1].abs() - 0.8).abs() < 1e-6,
            "{space:?}"
        );
        assert!(
            (f64::from(space.sigma[0]) - (14.0f64 / 3.0).sqrt()).abs() < 1e-5,
            "{space:?}"
        );
    }
}
