//! Products of matrices, on one thread.

/// A matrix in a slice, with the distances between its neighbours.
#[derive(Clone, Copy)]
pub struct StridedMatrix<'a> {
    pub numbers: &'a [f32],
    pub rows: usize,
    pub columns: usize,
    pub row_stride: usize,
    pub column_stride: usize,
}

impl<'a> StridedMatrix<'a> {
    /// A matrix whose rows follow each other.
    pub fn new(numbers: &'a [f32], rows: usize, columns: usize) -> Self {
        Self {
            numbers,
            rows,
            columns,
            row_stride: columns,
            column_stride: 1,
        }
    }

    pub fn transposed(self) -> Self {
        Self {
            rows: self.columns,
            columns: self.rows,
            row_stride: self.column_stride,
            column_stride: self.row_stride,
            ..self
        }
    }

    fn span(&self) -> usize {
        if self.rows == 0 || self.columns == 0 {
            return 0;
        }
        (self.rows - 1) * self.row_stride + (self.columns - 1) * self.column_stride + 1
    }
}

/// `out` = `a` · `b`, in rows of `b.columns`.
pub fn multiply(a: StridedMatrix, b: StridedMatrix, out: &mut [f32]) {
    assert!(a.columns == b.rows && out.len() == a.rows * b.columns);
    assert!(a.span() <= a.numbers.len() && b.span() <= b.numbers.len());
    // SAFETY: both matrices stay within their slices, and `out` has a number for each of theirs.
    unsafe {
        matrixmultiply::sgemm(
            a.rows,
            a.columns,
            b.columns,
            1.0,
            a.numbers.as_ptr(),
            a.row_stride as isize,
            a.column_stride as isize,
            b.numbers.as_ptr(),
            b.row_stride as isize,
            b.column_stride as isize,
            0.0,
            out.as_mut_ptr(),
            b.columns as isize,
            1,
        );
    }
}
