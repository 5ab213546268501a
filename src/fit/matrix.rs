//! Products of matrices, the leading eigenvectors of large symmetric ones and the solution of small ones. Matrices are row-major slices.
//!
//! Products use what vector instructions the machine has: the same bits each time on one kind of machine, not on all.

use crate::bake::math::Random;
use crate::bake::pca::eigen;

/// A matrix in a slice: its numbers, rows and columns, and whether it stands for its transpose.
#[derive(Clone, Copy)]
pub struct View<'a, T> {
    numbers: &'a [T],
    rows: usize,
    columns: usize,
    strides: (isize, isize),
}

impl<'a, T> View<'a, T> {
    /// # Panics
    /// When the slice has another length.
    pub fn new(numbers: &'a [T], rows: usize, columns: usize) -> Self {
        assert_eq!(numbers.len(), rows * columns, "a matrix of {rows} × {columns}");
        Self { numbers, rows, columns, strides: (columns as isize, 1) }
    }

    pub fn transposed(self) -> Self {
        Self { rows: self.columns, columns: self.rows, strides: (self.strides.1, self.strides.0), ..self }
    }

    /// Some of the columns of a matrix that isn't transposed.
    ///
    /// # Panics
    /// When it has fewer, or is transposed.
    pub fn columns(self, range: std::ops::Range<usize>) -> Self {
        assert!(range.end <= self.columns && self.strides.1 == 1);
        if self.rows == 0 || range.is_empty() {
            return Self { numbers: &[], rows: self.rows, columns: 0, strides: self.strides };
        }
        Self { numbers: &self.numbers[range.start..], columns: range.len(), ..self }
    }
}

macro_rules! product {
    ($name:ident, $type:ty, $gemm:path) => {
        /// `out = keep · out + a · b`.
        ///
        /// # Panics
        /// When the sizes don't fit.
        pub fn $name(a: View<$type>, b: View<$type>, keep: $type, out: &mut [$type]) {
            let (m, k, n) = (a.rows, a.columns, b.columns);
            assert!(b.rows == k && out.len() == m * n, "{m} × {k} times {} × {n} into {} numbers", b.rows, out.len());
            let reach = |v: &View<$type>| match (v.rows, v.columns) {
                (0, _) | (_, 0) => 0,
                (r, c) => (r as isize - 1) * v.strides.0 + (c as isize - 1) * v.strides.1 + 1,
            };
            assert!(reach(&a) as usize <= a.numbers.len() && reach(&b) as usize <= b.numbers.len());
            // SAFETY: both views reach no further than their slices, and `out` has m × n numbers in rows of n.
            unsafe {
                let (a_at, b_at) = (a.numbers.as_ptr(), b.numbers.as_ptr());
                $gemm(m, k, n, 1.0, a_at, a.strides.0, a.strides.1, b_at, b.strides.0, b.strides.1, keep, out.as_mut_ptr(), n as isize, 1);
            }
        }
    };
}

product!(product, f32, matrixmultiply::sgemm);
product!(product_f64, f64, matrixmultiply::dgemm);

/// X Xᵀ of a matrix with few rows and many columns; sums of many numbers are kept in f64.
pub fn gram(x: &[f32], rows: usize) -> Vec<f64> {
    const BLOCK: usize = 2048;
    let columns = x.len() / rows.max(1);
    let mut sum = vec![0.0f64; rows * rows];
    let mut part = vec![0.0f32; rows * rows];
    for start in (0..columns).step_by(BLOCK) {
        let block = View::new(x, rows, columns).columns(start..(start + BLOCK).min(columns));
        product(block, block.transposed(), 0.0, &mut part);
        sum.iter_mut().zip(&part).for_each(|(sum, &part)| *sum += f64::from(part));
    }
    sum
}

/// The `count` largest eigenvalues of a symmetric matrix of order `n`, falling, and their eigenvectors, shape `count`, n: iteration of a
/// subspace, from a fixed start. Fewer where n is smaller.
pub fn leading(matrix: &[f64], n: usize, count: usize) -> (Vec<f64>, Vec<Vec<f64>>) {
    const ROUNDS: usize = 40;
    let width = (count + 8).min(n);
    let mut random = Random::new(0x5EED, n as u64);
    // A column a vector.
    let mut basis: Vec<f64> = (0..n * width).map(|_| random.normal()).collect();
    let mut image = vec![0.0; n * width];
    for _ in 0..ROUNDS {
        orthonormalise(&mut basis, n, width);
        product_f64(View::new(matrix, n, n), View::new(&basis, n, width), 0.0, &mut image);
        std::mem::swap(&mut basis, &mut image);
    }
    orthonormalise(&mut basis, n, width);
    product_f64(View::new(matrix, n, n), View::new(&basis, n, width), 0.0, &mut image);
    let mut small = vec![0.0; width * width];
    product_f64(View::new(&basis, n, width).transposed(), View::new(&image, n, width), 0.0, &mut small);
    let small = (0..width).map(|i| (0..width).map(|j| 0.5 * (small[i * width + j] + small[j * width + i])).collect()).collect();
    let (values, turn) = eigen(small);
    let mut order: Vec<usize> = (0..width).collect();
    order.sort_by(|&a, &b| values[b].total_cmp(&values[a]).then(a.cmp(&b)));
    order.truncate(count);
    let vector = |&k: &usize| (0..n).map(|i| (0..width).map(|j| basis[i * width + j] * turn[j][k]).sum()).collect();
    (order.iter().map(|&k| values[k].max(0.0)).collect(), order.iter().map(vector).collect())
}

/// Gram and Schmidt's, twice over; a column that depends on those before it becomes zero.
fn orthonormalise(columns: &mut [f64], n: usize, width: usize) {
    for c in 0..width {
        let length = |columns: &[f64]| (0..n).map(|i| columns[i * width + c].powi(2)).sum::<f64>().sqrt();
        let before = length(columns);
        for _ in 0..2 {
            for d in 0..c {
                let dot: f64 = (0..n).map(|i| columns[i * width + c] * columns[i * width + d]).sum();
                (0..n).for_each(|i| columns[i * width + c] -= dot * columns[i * width + d]);
            }
        }
        let after = length(columns);
        let scale = if after > 1e-12 * before && after > 0.0 { 1.0 / after } else { 0.0 };
        (0..n).for_each(|i| columns[i * width + c] *= scale);
    }
}

/// The inverse of a symmetric positive matrix of order n, by Cholesky; pivots below `floor` count as `floor`.
pub fn inverse(matrix: &[f64], n: usize, floor: f64) -> Vec<f64> {
    let mut l = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = matrix[i * n + j] - (0..j).map(|k| l[i * n + k] * l[j * n + k]).sum::<f64>();
            l[i * n + j] = if i == j { sum.max(floor).sqrt() } else { sum / l[j * n + j] };
        }
    }
    let mut out = vec![0.0; n * n];
    for column in 0..n {
        let mut y = vec![0.0; n];
        for i in 0..n {
            let sum: f64 = (0..i).map(|k| l[i * n + k] * y[k]).sum();
            y[i] = (f64::from(u8::from(i == column)) - sum) / l[i * n + i];
        }
        for i in (0..n).rev() {
            let sum: f64 = (i + 1..n).map(|k| l[k * n + i] * out[k * n + column]).sum();
            out[i * n + column] = (y[i] - sum) / l[i * n + i];
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leading_eigenvectors_rebuild_a_matrix_of_low_rank() {
        let (n, rank) = (40, 5);
        let mut random = Random::new(1, 2);
        let x: Vec<f32> = {
            let a: Vec<f64> = (0..n * rank).map(|_| random.normal()).collect();
            let b: Vec<f64> = (0..rank * 300).map(|_| random.normal()).collect();
            let mut x = vec![0.0; n * 300];
            product_f64(View::new(&a, n, rank), View::new(&b, rank, 300), 0.0, &mut x);
            x.iter().map(|&v| v as f32).collect()
        };
        let gram = gram(&x, n);
        let (values, vectors) = leading(&gram, n, rank);
        for i in 0..n {
            for j in 0..n {
                let got: f64 = (0..rank).map(|k| values[k] * vectors[k][i] * vectors[k][j]).sum();
                assert!((got - gram[i * n + j]).abs() < 1e-3 * gram[0].abs(), "{i} {j}: {got}, expected {}", gram[i * n + j]);
            }
        }
        assert!(leading(&gram, n, rank + 3).0[rank] < 1e-5 * values[0], "a sixth component of a matrix of rank five");
    }

    #[test]
    fn a_matrix_times_its_inverse_is_the_identity() {
        let a = [4.0, 1.0, 0.5, 1.0, 3.0, -0.2, 0.5, -0.2, 2.0];
        let b = inverse(&a, 3, 0.0);
        for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
            let got: f64 = (0..3).map(|k| a[i * 3 + k] * b[k * 3 + j]).sum();
            assert!((got - f64::from(u8::from(i == j))).abs() < 1e-12, "{i} {j}: {got}");
        }
    }
}
