//! Products of matrices, eigenvectors and inverses of symmetric ones. Matrices are row-major slices.
//!
//! Products use what vector instructions the machine has: the result has the same bits each time on
//! one kind of machine, but not on all machines.

use nalgebra::{Cholesky, DMatrix, Dyn, SymmetricEigen};

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

/// Eigenvalues and eigenvectors of a symmetric matrix.
pub struct Eigen {
    /// Falling.
    pub values: Vec<f64>,
    /// The unit eigenvector of each value.
    pub vectors: Vec<Vec<f64>>,
}

/// The eigendecomposition of a symmetric matrix of order `n`. Of a matrix that isn't finite all of it
/// is NaN.
pub fn eigen(matrix: &[f64], n: usize) -> Eigen {
    // It doesn't take an empty matrix, and would iterate for ever upon NaN.
    if n == 0 || matrix.iter().any(|number| !number.is_finite()) {
        return Eigen {
            values: vec![f64::NAN; n],
            vectors: vec![vec![f64::NAN; n]; n],
        };
    }
    let found = SymmetricEigen::new(DMatrix::from_row_slice(n, n, matrix));
    let mut order: Vec<usize> = (0..n).collect();
    let values = &found.eigenvalues;
    order.sort_by(|&a, &b| values[b].total_cmp(&values[a]).then(a.cmp(&b)));
    let vector = |&k: &usize| found.eigenvectors.column(k).iter().copied().collect();
    Eigen {
        values: order.iter().map(|&k| values[k]).collect(),
        vectors: order.iter().map(vector).collect(),
    }
}

/// L of order n, row by row, 0 above its diagonal, with L Lᵀ = a symmetric positive matrix. Pivots
/// that aren't positive count as `floor`, which is.
pub fn cholesky(matrix: &[f64], n: usize, floor: f64) -> Vec<f64> {
    let l = decomposed(matrix, n, floor).unpack();
    l.transpose().as_slice().to_vec()
}

/// The inverse of a symmetric positive matrix of order n, by [`cholesky`].
pub fn inverse(matrix: &[f64], n: usize, floor: f64) -> Vec<f64> {
    // It is symmetric: rows are columns.
    decomposed(matrix, n, floor).inverse().as_slice().to_vec()
}

fn decomposed(matrix: &[f64], n: usize, floor: f64) -> Cholesky<f64, Dyn> {
    Cholesky::new_with_substitute(DMatrix::from_row_slice(n, n, matrix), floor)
        .expect("a positive number stands in for each pivot that is not positive")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eigenvectors_rebuild_a_matrix_of_low_rank() {
        // Rows 1 and 2, and their sum.
        let a = [2.0, 0.5, 2.5, 0.5, 1.0, 1.5, 2.5, 1.5, 4.0];
        let Eigen { values, vectors } = eigen(&a, 3);
        assert!(values[0] > values[1] && values[1] > 0.1 && values[2].abs() < 1e-12);
        for i in 0..3 {
            for j in 0..3 {
                let got: f64 = (0..2)
                    .map(|k| values[k] * vectors[k][i] * vectors[k][j])
                    .sum();
                let expected = a[3 * i + j];
                assert!(
                    (got - expected).abs() < 1e-12,
                    "{i} {j}: {got}, expected {expected}"
                );
            }
        }
    }

    #[test]
    fn a_matrix_times_its_inverse_is_the_identity() {
        let a = [4.0, 1.0, 0.5, 1.0, 3.0, -0.2, 0.5, -0.2, 2.0];
        let b = inverse(&a, 3, 1e-12);
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
