//! Products of basis rows with features.

use crate::avatar::{Rows, matrix::Row};

/// B · e: the weighted sum over the basis. `basis` has shape C, N_B, `e` length N_B.
pub fn combine<const C: usize>(basis: Row, e: &[f64]) -> [f64; C] {
    std::array::from_fn(|c| basis.piece(c * e.len(), e.len()).dot(e))
}

/// The derivative of [`combine`] with respect to e, added to `e`: Bᵀ · `gradient`.
pub fn combine_backward<const C: usize>(basis: Row, gradient: [f64; C], e: &mut [f64]) {
    for (c, g) in gradient.into_iter().enumerate() {
        let row = basis.piece(c * e.len(), e.len());
        for (e, b) in e.iter_mut().zip(row.iter()) {
            *e += g * b;
        }
    }
}

/// The corrective of one Gaussian: its basis row · e, or zero where pruning removed the row.
pub fn corrective<const C: usize>(rows: &Rows<C>, gaussian: usize, e: &[f64]) -> [f64; C] {
    match rows.gaussian.binary_search(&(gaussian as u32)) {
        Ok(row) => combine(rows.basis.row(row, C * e.len()), e),
        Err(_) => [0.0; C],
    }
}

/// a + b.
pub fn plus<const C: usize>(a: [f64; C], b: [f64; C]) -> [f64; C] {
    std::array::from_fn(|k| a[k] + b[k])
}
