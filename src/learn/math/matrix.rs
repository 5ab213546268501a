//! Products of matrices, the leading eigenvectors of large symmetric ones and the inverses of small
//! ones. Matrices are row-major slices.
//!
//! Products use what vector instructions the machine has: the result has the same bits each time on
//! one kind of machine, but not on all machines.

use crate::math::pca::{Eigendecomposition, eigen};
use effigy_core::random::Random;

/// A matrix in a slice, or its transpose.
#[derive(Clone, Copy)]
pub struct MatrixView<'a, T> {
    numbers: &'a [T],
    rows: usize,
    columns: usize,
    row_stride: isize,
    column_stride: isize,
}

impl<'a, T> MatrixView<'a, T> {
    /// A matrix of `rows` × `columns` numbers, row by row.
    ///
    /// # Panics
    /// When the slice has another length.
    pub fn new(numbers: &'a [T], rows: usize, columns: usize) -> Self {
        assert_eq!(
            numbers.len(),
            rows * columns,
            "a matrix of {rows} × {columns}"
        );
        Self {
            numbers,
            rows,
            columns,
            row_stride: columns as isize,
            column_stride: 1,
        }
    }

    /// Rows and columns swapped; nothing is copied.
    pub fn transposed(self) -> Self {
        Self {
            numbers: self.numbers,
            rows: self.columns,
            columns: self.rows,
            row_stride: self.column_stride,
            column_stride: self.row_stride,
        }
    }

    /// A range of the columns of a matrix that isn't transposed.
    ///
    /// # Panics
    /// When it has fewer, or is transposed.
    pub fn columns(self, range: std::ops::Range<usize>) -> Self {
        assert!(range.end <= self.columns && self.column_stride == 1);
        if self.rows == 0 || range.is_empty() {
            return Self {
                numbers: &[],
                columns: 0,
                ..self
            };
        }
        Self {
            numbers: &self.numbers[range.start..],
            columns: range.len(),
            ..self
        }
    }

    /// How many numbers of the slice the view reaches, from its start.
    fn span(&self) -> usize {
        if self.rows == 0 || self.columns == 0 {
            return 0;
        }
        let last = (self.rows as isize - 1) * self.row_stride
            + (self.columns as isize - 1) * self.column_stride;
        last as usize + 1
    }
}

macro_rules! multiply {
    ($name:ident, $type:ty, $gemm:path) => {
        /// `out = keep · out + a · b`.
        ///
        /// # Panics
        /// When the sizes don't fit.
        pub fn $name(a: MatrixView<$type>, b: MatrixView<$type>, keep: $type, out: &mut [$type]) {
            assert!(
                b.rows == a.columns && out.len() == a.rows * b.columns,
                "{} × {} times {} × {} into {} numbers",
                a.rows,
                a.columns,
                b.rows,
                b.columns,
                out.len()
            );
            assert!(a.span() <= a.numbers.len() && b.span() <= b.numbers.len());
            // SAFETY: both views stay within their slices, and `out` has a.rows × b.columns numbers
            // in rows of b.columns.
            unsafe {
                $gemm(
                    a.rows,
                    a.columns,
                    b.columns,
                    1.0,
                    a.numbers.as_ptr(),
                    a.row_stride,
                    a.column_stride,
                    b.numbers.as_ptr(),
                    b.row_stride,
                    b.column_stride,
                    keep,
                    out.as_mut_ptr(),
                    b.columns as isize,
                    1,
                );
            }
        }
    };
}

multiply!(multiply, f32, matrixmultiply::sgemm);
multiply!(multiply_f64, f64, matrixmultiply::dgemm);

/// X Xᵀ of a matrix with few rows and many columns. Long sums are taken in f64.
pub fn gram(x: &[f32], rows: usize) -> Vec<f64> {
    const BLOCK: usize = 2048;
    let columns = x.len() / rows.max(1);
    let mut sum = vec![0.0f64; rows * rows];
    let mut part = vec![0.0f32; rows * rows];
    for start in (0..columns).step_by(BLOCK) {
        let block = MatrixView::new(x, rows, columns).columns(start..(start + BLOCK).min(columns));
        multiply(block, block.transposed(), 0.0, &mut part);
        for (sum, &part) in sum.iter_mut().zip(&part) {
            *sum += f64::from(part);
        }
    }
    sum
}

/// Eigenvalues, falling, and the eigenvector of each.
pub struct LeadingEigenvectors {
    /// Not below 0.
    pub values: Vec<f64>,
    /// Unit vectors.
    pub vectors: Vec<Vec<f64>>,
}

/// The `count` largest eigenvalues of a symmetric matrix of order `n` with their eigenvectors, by
/// subspace iteration from a fixed start. Fewer where n is smaller.
pub fn leading_eigenvectors(matrix: &[f64], n: usize, count: usize) -> LeadingEigenvectors {
    const ROUNDS: usize = 40;
    /// More vectors than asked for make the iteration converge sooner.
    const SPARE: usize = 8;
    let width = (count + SPARE).min(n);
    let matrix = MatrixView::new(matrix, n, n);
    let mut random = Random::new(0x5EED, n as u64);
    // One vector a column.
    let mut basis: Vec<f64> = (0..n * width).map(|_| random.normal()).collect();
    let mut image = vec![0.0; n * width];
    for _ in 0..ROUNDS {
        orthonormalise(&mut basis, n, width);
        multiply_f64(matrix, MatrixView::new(&basis, n, width), 0.0, &mut image);
        std::mem::swap(&mut basis, &mut image);
    }
    orthonormalise(&mut basis, n, width);
    let vectors = MatrixView::new(&basis, n, width);
    multiply_f64(matrix, vectors, 0.0, &mut image);
    // The matrix within the subspace (Rayleigh and Ritz), made symmetric against rounding.
    let mut small = vec![0.0; width * width];
    multiply_f64(
        vectors.transposed(),
        MatrixView::new(&image, n, width),
        0.0,
        &mut small,
    );
    let small = (0..width)
        .map(|i| {
            (0..width)
                .map(|j| 0.5 * (small[i * width + j] + small[j * width + i]))
                .collect()
        })
        .collect();
    let Eigendecomposition {
        values,
        vectors: within,
    } = eigen(small);
    let mut order: Vec<usize> = (0..width).collect();
    order.sort_by(|&a, &b| values[b].total_cmp(&values[a]).then(a.cmp(&b)));
    order.truncate(count);
    let vector = |&k: &usize| {
        (0..n)
            .map(|i| {
                (0..width)
                    .map(|j| basis[i * width + j] * within[j][k])
                    .sum()
            })
            .collect()
    };
    LeadingEigenvectors {
        values: order.iter().map(|&k| values[k].max(0.0)).collect(),
        vectors: order.iter().map(vector).collect(),
    }
}

/// Makes the columns orthonormal by two rounds of Gram and Schmidt's process. A column that depends
/// on those before it becomes zero.
fn orthonormalise(columns: &mut [f64], n: usize, width: usize) {
    for c in 0..width {
        let length = |columns: &[f64]| {
            (0..n)
                .map(|i| columns[i * width + c].powi(2))
                .sum::<f64>()
                .sqrt()
        };
        let before = length(columns);
        for _ in 0..2 {
            for d in 0..c {
                let dot: f64 = (0..n)
                    .map(|i| columns[i * width + c] * columns[i * width + d])
                    .sum();
                for i in 0..n {
                    columns[i * width + c] -= dot * columns[i * width + d];
                }
            }
        }
        let after = length(columns);
        let scale = if after > 1e-12 * before && after > 0.0 {
            1.0 / after
        } else {
            0.0
        };
        for i in 0..n {
            columns[i * width + c] *= scale;
        }
    }
}

/// L of order n, 0 above its diagonal, with L Lᵀ = a symmetric positive matrix. Pivots below
/// `floor` count as `floor`.
pub fn cholesky(matrix: &[f64], n: usize, floor: f64) -> Vec<f64> {
    let mut l = vec![0.0; n * n];
    for i in 0..n {
        for j in 0..=i {
            let (before, own) = l.split_at(i * n);
            let row = if i == j { own } else { &before[j * n..] };
            let dot: f64 = own[..j].iter().zip(row).map(|(a, b)| a * b).sum();
            let rest = matrix[i * n + j] - dot;
            l[i * n + j] = if i == j {
                rest.max(floor).sqrt()
            } else {
                rest / l[j * n + j]
            };
        }
    }
    l
}

/// The inverse of a symmetric positive matrix of order n, by Cholesky's decomposition. Pivots below
/// `floor` count as `floor`.
pub fn inverse(matrix: &[f64], n: usize, floor: f64) -> Vec<f64> {
    let l = cholesky(matrix, n, floor);
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
    fn leading_eigenvectors_rebuild_a_low_rank_matrix() {
        let n = 40;
        let rank = 5;
        let mut random = Random::new(1, 2);
        let x: Vec<f32> = {
            let a: Vec<f64> = (0..n * rank).map(|_| random.normal()).collect();
            let b: Vec<f64> = (0..rank * 300).map(|_| random.normal()).collect();
            let mut x = vec![0.0; n * 300];
            multiply_f64(
                MatrixView::new(&a, n, rank),
                MatrixView::new(&b, rank, 300),
                0.0,
                &mut x,
            );
            x.iter().map(|&v| v as f32).collect()
        };
        let gram = gram(&x, n);
        let LeadingEigenvectors { values, vectors } = leading_eigenvectors(&gram, n, rank);
        for i in 0..n {
            for j in 0..n {
                let got: f64 = (0..rank)
                    .map(|k| values[k] * vectors[k][i] * vectors[k][j])
                    .sum();
                assert!(
                    (got - gram[i * n + j]).abs() < 1e-3 * gram[0].abs(),
                    "{i} {j}: {got}, expected {}",
                    gram[i * n + j]
                );
            }
        }
        assert!(
            leading_eigenvectors(&gram, n, rank + 3).values[rank] < 1e-5 * values[0],
            "a sixth component of a matrix of rank five"
        );
    }

    #[test]
    fn a_matrix_times_its_inverse_is_the_identity() {
        let a = [4.0, 1.0, 0.5, 1.0, 3.0, -0.2, 0.5, -0.2, 2.0];
        let b = inverse(&a, 3, 0.0);
        for i in 0..3 {
            for j in 0..3 {
                let got: f64 = (0..3).map(|k| a[i * 3 + k] * b[k * 3 + j]).sum();
                assert!(
                    (got - f64::from(u8::from(i == j))).abs() < 1e-12,
                    "{i} {j}: {got}"
                );
            }
        }
    }
}
