//! Principal components of a few dozen numbers.

use effigy_core::avatar::Subspace;

/// The first `count` principal components of rows of `width` numbers each, with their mean and
/// standard deviations. Fewer where fewer directions vary.
pub fn pca(rows: &[Vec<f64>], width: usize, count: usize) -> Subspace {
    let number = rows.len().max(1) as f64;
    let mean: Vec<f64> = (0..width)
        .map(|k| rows.iter().map(|row| row[k]).sum::<f64>() / number)
        .collect();
    let mut covariance = vec![vec![0.0; width]; width];
    for i in 0..width {
        for j in i..width {
            let sum: f64 = rows
                .iter()
                .map(|row| (row[i] - mean[i]) * (row[j] - mean[j]))
                .sum();
            covariance[i][j] = sum / number;
            covariance[j][i] = covariance[i][j];
        }
    }
    let Eigendecomposition { values, vectors } = eigen(covariance);
    let mut order: Vec<usize> = (0..width).collect();
    order.sort_by(|&a, &b| values[b].total_cmp(&values[a]).then(a.cmp(&b)));
    order.retain(|&k| values[k] > 1e-10);
    order.truncate(count);
    let component = |&k: &usize| vectors.iter().map(move |row| row[k] as f32);
    Subspace {
        mean: mean.iter().map(|&m| m as f32).collect(),
        component: order.iter().flat_map(component).collect(),
        sigma: order.iter().map(|&k| values[k].sqrt() as f32).collect(),
    }
}

/// The eigendecomposition of a symmetric matrix.
pub struct Eigendecomposition {
    /// Unordered.
    pub values: Vec<f64>,
    /// `vectors[i][k]` is component i of the eigenvector of `values[k]`.
    pub vectors: Vec<Vec<f64>>,
}

/// Eigenvalues and eigenvectors of a symmetric matrix of up to some hundred rows, by cyclic Jacobi
/// rotations.
pub fn eigen(mut a: Vec<Vec<f64>>) -> Eigendecomposition {
    const SWEEPS: usize = 60;
    let n = a.len();
    let mut vectors: Vec<Vec<f64>> = (0..n)
        .map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect())
        .collect();
    for _ in 0..SWEEPS {
        let off_diagonal: f64 = (0..n)
            .flat_map(|i| (0..i).map(move |j| (i, j)))
            .map(|(i, j)| a[i][j] * a[i][j])
            .sum();
        if off_diagonal < 1e-24 {
            break;
        }
        for p in 0..n {
            for q in p + 1..n {
                rotate(&mut a, &mut vectors, p, q);
            }
        }
    }
    Eigendecomposition {
        values: (0..n).map(|i| a[i][i]).collect(),
        vectors,
    }
}

/// The Jacobi rotation that makes a[p][q] zero, p < q.
fn rotate(a: &mut [Vec<f64>], vectors: &mut [Vec<f64>], p: usize, q: usize) {
    if a[p][q].abs() < 1e-300 {
        return;
    }
    let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
    let cos = 1.0 / (t * t + 1.0).sqrt();
    let sin = t * cos;
    let turn = |x: &mut f64, y: &mut f64| {
        let before = *x;
        *x = cos * before - sin * *y;
        *y = sin * before + cos * *y;
    };
    for row in a.iter_mut().chain(vectors) {
        let (left, right) = row.split_at_mut(q);
        turn(&mut left[p], &mut right[0]);
    }
    let (upper, lower) = a.split_at_mut(q);
    for (x, y) in upper[p].iter_mut().zip(lower[0].iter_mut()) {
        turn(x, y);
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
