//! Displacements of the position nodes: from every Gaussian's offset in a frame, the displacements
//! that come nearest to it when interpolated.

use crate::dataset::{Attribute, Dataset};
use effigy_core::avatar::Avatar;
use rayon::prelude::*;

/// Steps of the conjugate gradients. Gaussians depend on nodes nearby only, so few are enough.
const STEPS: usize = 14;
/// Pulls nodes towards 0, as a share of the pull of a Gaussian midway between three nodes.
const RIDGE: f32 = 1e-3;
/// Squared lengths below this count as 0.
const NEGLIGIBLE: f64 = 1e-30;

/// Displacements of all nodes in all frames.
pub struct NodeDisplacements {
    /// N_s.
    pub nodes: usize,
    /// Shape F, N_s, 3; metres.
    pub displacements: Vec<f32>,
}

/// The interpolation matrix W: three nodes and three weights for each Gaussian.
struct Interpolation<'a> {
    nodes: &'a [[u16; 3]],
    weights: Vec<[f32; 3]>,
    node_count: usize,
}

impl Interpolation<'_> {
    /// Adds a Gaussian's vector to its nodes, by its weights: a row of Wᵀ.
    fn scatter(&self, gaussian: usize, y: &[f32; 3], out: &mut [[f32; 3]]) {
        for (&node, weight) in self.nodes[gaussian].iter().zip(&self.weights[gaussian]) {
            for c in 0..3 {
                out[usize::from(node)][c] += weight * y[c];
            }
        }
    }

    /// Wᵀ y.
    fn transposed_times(&self, y: &[[f32; 3]]) -> Vec<[f32; 3]> {
        let mut out = vec![[0.0; 3]; self.node_count];
        for (gaussian, y) in y.iter().enumerate() {
            self.scatter(gaussian, y, &mut out);
        }
        out
    }

    /// (Wᵀ W + ridge) x: the left side of the normal equations.
    fn normal_times(&self, x: &[[f32; 3]]) -> Vec<[f32; 3]> {
        let mut out: Vec<[f32; 3]> = x.iter().map(|x| x.map(|x| RIDGE * x)).collect();
        for (gaussian, nodes) in self.nodes.iter().enumerate() {
            let interpolated: [f32; 3] = std::array::from_fn(|c| {
                nodes
                    .iter()
                    .zip(&self.weights[gaussian])
                    .map(|(&node, weight)| weight * x[usize::from(node)][c])
                    .sum::<f32>()
            });
            self.scatter(gaussian, &interpolated, &mut out);
        }
        out
    }

    /// The nodes whose interpolation is nearest to `y`, by conjugate gradients on the normal
    /// equations. The three axes are solved side by side and don't influence each other.
    fn solve(&self, y: &[[f32; 3]]) -> Vec<[f32; 3]> {
        let mut x = vec![[0.0f32; 3]; self.node_count];
        let mut residual = self.transposed_times(y);
        let mut direction = residual.clone();
        let mut length = dot(&residual, &residual);
        for _ in 0..STEPS {
            let image = self.normal_times(&direction);
            let step = ratio(length, dot(&direction, &image));
            for s in 0..self.node_count {
                for c in 0..3 {
                    x[s][c] += step[c] * direction[s][c];
                    residual[s][c] -= step[c] * image[s][c];
                }
            }
            let new_length = dot(&residual, &residual);
            let keep = ratio(new_length, length);
            length = new_length;
            for (direction, residual) in direction.iter_mut().zip(&residual) {
                for c in 0..3 {
                    direction[c] = residual[c] + keep[c] * direction[c];
                }
            }
        }
        x
    }
}

/// The dot product of each axis.
fn dot(a: &[[f32; 3]], b: &[[f32; 3]]) -> [f64; 3] {
    let mut sum = [0.0f64; 3];
    for (a, b) in a.iter().zip(b) {
        for c in 0..3 {
            sum[c] += f64::from(a[c]) * f64::from(b[c]);
        }
    }
    sum
}

/// a / b of each axis, 0 where b is negligible.
fn ratio(a: [f64; 3], b: [f64; 3]) -> [f32; 3] {
    std::array::from_fn(|c| {
        if b[c] > NEGLIGIBLE {
            (a[c] / b[c]) as f32
        } else {
            0.0
        }
    })
}

impl NodeDisplacements {
    /// Solves every frame of a dataset.
    pub fn new(dataset: &Dataset) -> Self {
        let avatar: &Avatar = &dataset.avatar;
        let count = avatar.gaussians.len();
        let weights = (0..count)
            .into_par_iter()
            .map(|k| avatar.node_weights(k).map(|w| w as f32))
            .collect();
        let interpolation = Interpolation {
            nodes: &avatar.gaussians.node,
            weights,
            node_count: avatar.nodes.len(),
        };
        let solve_frame = |frame: usize| {
            let mut offsets = Vec::with_capacity(3 * count);
            dataset.append_numbers(frame, Attribute::Offset, 0..count, &mut offsets);
            interpolation
                .solve(offsets.as_chunks::<3>().0)
                .into_iter()
                .flatten()
                .collect::<Vec<f32>>()
        };
        Self {
            nodes: interpolation.node_count,
            displacements: (0..dataset.len())
                .into_par_iter()
                .map(solve_frame)
                .collect::<Vec<_>>()
                .concat(),
        }
    }

    /// Squared displacements over some frames about their means, summed over all nodes, m².
    pub fn spread(&self, frames: &[usize]) -> f64 {
        let width = 3 * self.nodes;
        let column = |k: usize| {
            let number = |&f: &usize| f64::from(self.displacements[f * width + k]);
            let sum: f64 = frames.iter().map(number).sum();
            frames.iter().map(|f| number(f).powi(2)).sum::<f64>()
                - sum * sum / frames.len().max(1) as f64
        };
        (0..width).into_par_iter().map(column).sum()
    }

    /// The displacements of some nodes in some frames, times a weight; shape frames, nodes, 3.
    pub fn block(&self, nodes: &[usize], frames: &[usize], weight: f32) -> Vec<f32> {
        let mut block = Vec::with_capacity(frames.len() * nodes.len() * 3);
        for frame in frames {
            for node in nodes {
                let own = &self.displacements[(frame * self.nodes + node) * 3..][..3];
                block.extend(own.iter().map(|x| weight * x));
            }
        }
        block
    }
}
