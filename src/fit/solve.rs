//! Networks in; every part's best bases and neutral values out, and the avatar that they make.

use super::basis::{Half, Problem, Solution, components};
use super::block::{ATTRIBUTES, Block, Kept, Statistics};
use super::dataset::Dataset;
use super::inputs::Seen;
use super::learner::Learner;
use super::network::Target;
use super::nodes::Moves;
use crate::avatar::{Avatar, Inputs, Matrix, Rows};
use half::f16;
use rayon::prelude::*;

/// The L1 constraint on correctives of rotation, log scale and colour (the paper's equation 6): their relation is the paper's, 0.02 : 1 :
/// 0.002, but for the scale's, which in logarithms would leave nothing of it.
const CONSTRAINT: [f32; 3] = [0.002, 0.002, 0.0004];

/// All that a fit starts from.
pub struct Ground<'a> {
    pub dataset: &'a Dataset,
    /// What the avatar's networks see of a pose.
    pub inputs: Inputs,
    pub seen: Seen,
    pub training: Vec<usize>,
    pub statistics: Statistics,
    pub moves: Moves,
    /// The avatar's nodes of each part.
    pub nodes: Vec<Vec<usize>>,
    pub basis: usize,
    /// How much the constraint counts; 0: not at all.
    pub constraint: f32,
}

/// A part's solution: of its attributes, and of its nodes.
pub struct Solved {
    kept: [Vec<u32>; 3],
    start: [usize; 4],
    attributes: Solution,
    nodes: Solution,
}

/// The two halves of a part's loss as one.
fn join(attributes: Half, nodes: Half, basis: usize) -> Target {
    let (frames, width) = (attributes.energy.len(), 2 * basis);
    let mut target = Target { form: vec![0.0; width * width], pull: vec![0.0; frames * width], energy: Vec::with_capacity(frames) };
    for (first, half) in [(0, &attributes), (basis, &nodes)] {
        for i in 0..basis {
            target.form[(first + i) * width + first..][..basis].copy_from_slice(&half.form[i * basis..][..basis]);
        }
        for f in 0..frames {
            target.pull[f * width + first..][..basis].copy_from_slice(&half.pull[f * basis..][..basis]);
        }
    }
    target.energy.extend(attributes.energy.iter().zip(&nodes.energy).map(|(a, b)| a + b));
    target
}

impl Ground<'_> {
    pub fn frames(&self) -> Vec<usize> {
        (0..self.dataset.len()).collect()
    }

    fn node_block(&self, part: usize) -> (Vec<f32>, usize) {
        let columns = 3 * self.nodes[part].len();
        (self.moves.block(&self.nodes[part], &self.frames(), self.statistics.node_weight), columns)
    }

    /// The first target of a part: its principal components.
    pub fn components(&self, part: usize) -> Target {
        let block = Block::load(self.dataset, &self.statistics, &Kept(None), part, &self.frames());
        let (columns, frames) = (block.columns(), self.dataset.len());
        let attributes = components(block.x, columns, frames, &self.training, self.basis);
        let (x, columns) = self.node_block(part);
        join(attributes, components(x, columns, frames, &self.training, self.basis), self.basis)
    }

    /// The best bases of a part for what its network says. `constrain`: with the constraint on correctives.
    pub fn solve(&self, learner: &Learner, kept: &Kept, part: usize, constrain: bool) -> Solved {
        let features = learner.features(part, &self.seen);
        let block = Block::load(self.dataset, &self.statistics, kept, part, &self.frames());
        let least = |a: usize| if constrain { CONSTRAINT[a] * self.constraint } else { 0.0 };
        let runs: [_; 3] = std::array::from_fn(|a| (block.start[a + 1], self.statistics.weight[a], least(a)));
        let columns = block.columns();
        let problem = |x, columns, first, runs| Problem {
            x,
            columns,
            frames: self.dataset.len(),
            training: &self.training,
            features: &features,
            width: 2 * self.basis,
            first,
            basis: self.basis,
            runs,
        };
        let attributes = problem(block.x, columns, 0, &runs).solve();
        let (x, columns) = self.node_block(part);
        let nodes = problem(x, columns, self.basis, &[(columns, self.statistics.node_weight, 0.0)]).solve();
        Solved { kept: block.kept, start: block.start, attributes, nodes }
    }

    /// Solves every part, aims the networks at what is left, and returns the avatar so far.
    pub fn refine(&self, learner: &mut Learner, kept: &Kept, constrain: bool) -> Avatar {
        let parts = self.dataset.avatar.parts.len();
        let solved: Vec<Solved> = (0..parts).into_par_iter().map(|part| self.solve(learner, kept, part, constrain)).collect();
        let avatar = self.avatar(learner, &solved);
        for (part, solved) in solved.into_iter().enumerate() {
            learner.aim(part, join(solved.attributes.half, solved.nodes.half, self.basis), &self.training);
        }
        avatar
    }

    /// The avatar that networks and solutions make. Gaussians without a corrective have their mean attributes.
    fn avatar(&self, learner: &Learner, solved: &[Solved]) -> Avatar {
        let mut avatar = Avatar { networks: learner.stored(&self.seen), inputs: self.inputs.clone(), ..self.dataset.avatar.clone() };
        avatar.harmonics = None;
        let mean = |a: usize| self.statistics.mean[a].iter().map(|&m| f16::from_f32(m));
        let mut neutral: [Vec<f16>; 3] = std::array::from_fn(|a| mean(a).collect());
        let rows = |a: usize| solved.iter().flat_map(move |part| part.kept[a].iter().copied()).collect::<Vec<u32>>();
        let basis = |a: usize| {
            let own = |part: &'_ Solved| part.attributes.basis[part.start[a] * self.basis..part.start[a + 1] * self.basis].to_vec();
            solved.iter().flat_map(own).collect::<Matrix>()
        };
        for part in solved {
            for (a, attribute) in ATTRIBUTES.into_iter().enumerate() {
                let width = attribute.width();
                for (row, &k) in part.kept[a].iter().enumerate() {
                    let own = &part.attributes.neutral[part.start[a] + row * width..][..width];
                    neutral[a][k as usize * width..][..width].copy_from_slice(own);
                }
            }
        }
        avatar.gaussians.rotation = neutral[0].as_chunks::<4>().0.to_vec();
        avatar.gaussians.log_scale = neutral[1].as_chunks::<3>().0.to_vec();
        avatar.gaussians.color = neutral[2].as_chunks::<3>().0.to_vec();
        avatar.rotation_rows = Rows { gaussian: rows(0), basis: basis(0) };
        avatar.scale_rows = Rows { gaussian: rows(1), basis: basis(1) };
        avatar.color_rows = Rows { gaussian: rows(2), basis: basis(2) };
        let mut node_basis = vec![f16::ZERO; 3 * self.basis * avatar.nodes.len()];
        for (part, nodes) in self.nodes.iter().enumerate() {
            for (at, &s) in nodes.iter().enumerate() {
                let own = &solved[part].nodes;
                avatar.nodes.offset[s] = std::array::from_fn(|c| own.neutral[3 * at + c]);
                let length = 3 * self.basis;
                node_basis[s * length..][..length].copy_from_slice(&own.basis[at * length..][..length]);
            }
        }
        avatar.nodes.basis = node_basis.into();
        avatar
    }
}
