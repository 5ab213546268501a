//! The bases of a part, and what its network learns for them.
//!
//! Networks and bases are refined in turn. Given the bases, the networks learn the loss as it is
//! ([`QuadraticLoss`]). Given the networks, bases and neutral values are a linear least-squares
//! problem with one solution.

use crate::distil::network::QuadraticLoss;
use half::f16;

/// The loss of one half of a part's features: those of its attributes, or those of its nodes. See
/// [`QuadraticLoss`].
pub struct HalfLoss {
    /// M, shape basis, basis.
    pub quadratic: Vec<f32>,
    /// c, shape F, basis.
    pub linear: Vec<f32>,
    /// Length F.
    pub energy: Vec<f32>,
}

/// A basis, ready to be stored.
pub struct Solution {
    /// One neutral value a column, rounded to f16, without the weight.
    pub neutral: Vec<f16>,
    /// Shape columns, basis; without the weight.
    pub basis: Vec<f16>,
    /// The loss with the rounded numbers.
    pub loss: HalfLoss,
}

/// The losses of attributes and nodes as one: the attributes' features first, then the nodes'.
pub fn join(attributes: &HalfLoss, nodes: &HalfLoss, basis: usize) -> QuadraticLoss {
    let frames = attributes.energy.len();
    let width = 2 * basis;
    let mut joined = QuadraticLoss {
        quadratic: vec![0.0; width * width],
        linear: vec![0.0; frames * width],
        energy: attributes
            .energy
            .iter()
            .zip(&nodes.energy)
            .map(|(a, b)| a + b)
            .collect(),
    };
    for (first, half) in [(0, attributes), (basis, nodes)] {
        for i in 0..basis {
            joined.quadratic[(first + i) * width + first..][..basis]
                .copy_from_slice(&half.quadratic[i * basis..][..basis]);
        }
        for f in 0..frames {
            joined.linear[f * width + first..][..basis]
                .copy_from_slice(&half.linear[f * basis..][..basis]);
        }
    }
    joined
}

/// Subtracts the mean of some rows of a matrix from all of its rows. Returns the mean.
pub fn center(x: &mut [f32], columns: usize, rows: &[usize]) -> Vec<f32> {
    if columns == 0 {
        return Vec::new();
    }
    let mut sum = vec![0.0f64; columns];
    for &row in rows {
        for (sum, &x) in sum.iter_mut().zip(&x[row * columns..][..columns]) {
            *sum += f64::from(x);
        }
    }
    let mean: Vec<f32> = sum
        .iter()
        .map(|sum| (sum / rows.len().max(1) as f64) as f32)
        .collect();
    for row in x.chunks_exact_mut(columns) {
        for (x, mean) in row.iter_mut().zip(&mean) {
            *x -= mean;
        }
    }
    mean
}
