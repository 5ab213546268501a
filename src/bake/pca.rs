//! Rows of numbers in; their mean, principal components and deviations out.

use crate::avatar::Subspace;

/// The first `count` components of rows of length `width`, fewer where there are fewer that vary.
pub fn pca(rows: &[Vec<f64>], width: usize, count: usize) -> Subspace {
    let number = rows.len().max(1) as f64;
    let mean: Vec<f64> = (0..width).map(|k| rows.iter().map(|row| row[k]).sum::<f64>() / number).collect();
    let mut covariance = vec![vec![0.0; width]; width];
    for (i, j) in (0..width).flat_map(|i| (i..width).map(move |j| (i, j))) {
        let sum: f64 = rows.iter().map(|row| (row[i] - mean[i]) * (row[j] - mean[j])).sum();
        covariance[i][j] = sum / number;
        covariance[j][i] = covariance[i][j];
    }
    let (values, vectors) = eigen(covariance);
    let mut order: Vec<usize> = (0..width).collect();
    order.sort_by(|&a, &b| values[b].total_cmp(&values[a]).then(a.cmp(&b)));
    order.retain(|&k| values[k] > 1e-10);
    order.truncate(count);
    Subspace {
        mean: mean.iter().map(|&m| m as f32).collect(),
        component: order.iter().flat_map(|&k| (0..width).map(move |i| (k, i))).map(|(k, i)| vectors[i][k] as f32).collect(),
        sigma: order.iter().map(|&k| values[k].sqrt() as f32).collect(),
    }
}

/// Eigenvalues of a symmetric matrix and its eigenvectors as columns: cyclic Jacobi rotations, enough for tens of rows.
pub fn eigen(mut a: Vec<Vec<f64>>) -> (Vec<f64>, Vec<Vec<f64>>) {
    let n = a.len();
    let mut v: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    for _ in 0..60 {
        let off: f64 = (0..n).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| a[i][j] * a[i][j]).sum();
        if off < 1e-24 {
            break;
        }
        for (p, q) in (0..n).flat_map(|p| (p + 1..n).map(move |q| (p, q))) {
            if a[p][q].abs() < 1e-300 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
            let cos = 1.0 / (t * t + 1.0).sqrt();
            let sin = t * cos;
            let turn = |x: &mut f64, y: &mut f64| (*x, *y) = (cos * *x - sin * *y, sin * *x + cos * *y);
            for row in a.iter_mut().chain(v.iter_mut()) {
                let (left, right) = row.split_at_mut(q);
                turn(&mut left[p], &mut right[0]);
            }
            let (upper, lower) = a.split_at_mut(q);
            upper[p].iter_mut().zip(lower[0].iter_mut()).for_each(|(x, y)| turn(x, y));
        }
    }
    ((0..n).map(|i| a[i][i]).collect(), v)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_on_a_line_have_one_component_along_it() {
        let rows: Vec<Vec<f64>> = [-1.0, 0.0, 4.0].iter().map(|t| vec![1.0 + 0.6 * t, 2.0 + 0.8 * t]).collect();
        let space = pca(&rows, 2, 2);
        assert_eq!(space.sigma.len(), 1, "{space:?}");
        assert!((space.component[0].abs() - 0.6).abs() < 1e-6 && (space.component[1].abs() - 0.8).abs() < 1e-6, "{space:?}");
        assert!((f64::from(space.sigma[0]) - (14.0f64 / 3.0).sqrt()).abs() < 1e-5, "{space:?}");
    }
}
