//! Every Gaussian's offset over the frames in; the displacements of the nodes that come nearest to them when interpolated, out.

use super::dataset::{Attribute, Dataset};
use crate::avatar::Avatar;
use rayon::prelude::*;

/// Steps of the conjugate gradients: Gaussians hang on nodes nearby, so few are enough.
const STEPS: usize = 14;
/// Pulls nodes towards 0, as a share of what a Gaussian in the middle of three nodes does.
const RIDGE: f32 = 1e-3;

/// Displacements over all frames, shape F, N_s, 3; metres.
pub struct Moves {
    pub nodes: usize,
    pub moves: Vec<f32>,
}

/// How Gaussians hang on nodes: for each three nodes and three weights.
struct Web<'a> {
    node: &'a [[u16; 3]],
    weight: Vec<[f32; 3]>,
    count: usize,
}

impl Web<'_> {
    /// Wᵀ y.
    fn gather(&self, y: &[[f32; 3]]) -> Vec<[f32; 3]> {
        let mut out = vec![[0.0; 3]; self.count];
        for ((node, weight), y) in self.node.iter().zip(&self.weight).zip(y) {
            for (&s, w) in node.iter().zip(weight) {
                (0..3).for_each(|c| out[usize::from(s)][c] += w * y[c]);
            }
        }
        out
    }

    /// (Wᵀ W + ridge) x.
    fn normal(&self, x: &[[f32; 3]]) -> Vec<[f32; 3]> {
        let mut out: Vec<[f32; 3]> = x.iter().map(|x| x.map(|x| RIDGE * x)).collect();
        for (node, weight) in self.node.iter().zip(&self.weight) {
            let at = |c: usize| node.iter().zip(weight).map(|(&s, w)| w * x[usize::from(s)][c]).sum::<f32>();
            let y: [f32; 3] = std::array::from_fn(at);
            for (&s, w) in node.iter().zip(weight) {
                (0..3).for_each(|c| out[usize::from(s)][c] += w * y[c]);
            }
        }
        out
    }

    /// Least squares: the nodes whose interpolation is nearest to `y`.
    fn solve(&self, y: &[[f32; 3]]) -> Vec<[f32; 3]> {
        let dot = |a: &[[f32; 3]], b: &[[f32; 3]]| {
            let mut sum = [0.0f64; 3];
            a.iter().zip(b).for_each(|(a, b)| (0..3).for_each(|c| sum[c] += f64::from(a[c]) * f64::from(b[c])));
            sum
        };
        let mut x = vec![[0.0f32; 3]; self.count];
        let mut rest = self.gather(y);
        let mut along = rest.clone();
        let mut size = dot(&rest, &rest);
        for _ in 0..STEPS {
            let image = self.normal(&along);
            let bend = dot(&along, &image);
            let step: [f32; 3] = std::array::from_fn(|c| if bend[c] > 1e-30 { (size[c] / bend[c]) as f32 } else { 0.0 });
            for s in 0..self.count {
                for c in 0..3 {
                    x[s][c] += step[c] * along[s][c];
                    rest[s][c] -= step[c] * image[s][c];
                }
            }
            let now = dot(&rest, &rest);
            let turn: [f32; 3] = std::array::from_fn(|c| if size[c] > 1e-30 { (now[c] / size[c]) as f32 } else { 0.0 });
            size = now;
            along.iter_mut().zip(&rest).for_each(|(a, r)| (0..3).for_each(|c| a[c] = r[c] + turn[c] * a[c]));
        }
        x
    }
}

impl Moves {
    pub fn new(dataset: &Dataset) -> Self {
        let avatar: &Avatar = &dataset.avatar;
        let count = avatar.gaussians.len();
        let weight = (0..count).into_par_iter().map(|k| avatar.node_weights(k).map(|w| w as f32)).collect();
        let web = Web { node: &avatar.gaussians.node, weight, count: avatar.nodes.len() };
        let frame = |frame: usize| {
            let mut offsets = Vec::with_capacity(3 * count);
            dataset.numbers(frame, Attribute::Offset, 0..count, &mut offsets);
            web.solve(offsets.as_chunks::<3>().0).into_iter().flatten().collect::<Vec<f32>>()
        };
        Self { nodes: web.count, moves: (0..dataset.len()).into_par_iter().map(frame).collect::<Vec<_>>().concat() }
    }

    /// Squared displacements over some frames about their means.
    pub fn spread(&self, frames: &[usize]) -> f64 {
        let width = 3 * self.nodes;
        let column = |k: usize| {
            let at = |&f: &usize| f64::from(self.moves[f * width + k]);
            let sum: f64 = frames.iter().map(at).sum();
            frames.iter().map(|f| at(f).powi(2)).sum::<f64>() - sum * sum / frames.len().max(1) as f64
        };
        (0..width).into_par_iter().map(column).sum()
    }

    /// Some nodes over some frames, times a weight; shape frames, nodes · 3.
    pub fn block(&self, nodes: &[usize], frames: &[usize], weight: f32) -> Vec<f32> {
        let at = |&f: &usize| nodes.iter().flat_map(move |s| (0..3).map(move |c| (f * self.nodes + s) * 3 + c));
        frames.iter().flat_map(at).map(|k| weight * self.moves[k]).collect()
    }
}
