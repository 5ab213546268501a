//! The learning problem of a dataset: everything that stays the same during a fit, and the solution
//! of every part's bases and neutral values for the networks so far.

use crate::dataset::Dataset;
use crate::train::basis::{BasisProblem, ColumnRun, HalfLoss, Solution, principal_components};
use crate::train::block::{ATTRIBUTES, AttributeStatistics, PartBlock, RetainedRows};
use crate::train::inputs::NetworkInputs;
use crate::train::learner::Learner;
use crate::train::network::QuadraticLoss;
use crate::train::nodes::NodeDisplacements;
use effigy_core::avatar::{Avatar, Inputs, Matrix, Rows};
use half::f16;
use rayon::prelude::*;

/// The L1 constraint on correctives of rotation, log scale and colour (the paper's equation 6).
/// Their ratio is the paper's, 0.02 : 1 : 0.002, except for the scale: in logarithms, the paper's
/// would leave nothing of it.
const CONSTRAINT: [f32; 3] = [0.002, 0.002, 0.0004];

/// A dataset, prepared to be fitted.
pub struct LearningProblem<'a> {
    /// The dataset that is fitted.
    pub dataset: &'a Dataset,
    /// The inputs of the avatar's networks, with their subspaces.
    pub inputs: Inputs,
    /// These inputs in every frame.
    pub network_inputs: NetworkInputs,
    /// The frames to fit to.
    pub training: Vec<usize>,
    /// Of the training frames.
    pub statistics: AttributeStatistics,
    /// Of all frames.
    pub displacements: NodeDisplacements,
    /// The indices of each part's nodes.
    pub nodes: Vec<Vec<usize>>,
    /// N_B.
    pub basis: usize,
    /// The factor of the constraint on correctives.
    pub constraint: f32,
}

/// The choices for a [`LearningProblem`].
pub struct ProblemSettings {
    /// The frames to fit to.
    pub training: Vec<usize>,
    /// N_B.
    pub basis: usize,
    /// How much the constraint on correctives counts; 1 is usual, 0 turns it off.
    pub constraint: f32,
}

/// The weighted numbers of a part's nodes over all frames.
struct NodeBlock {
    x: Vec<f32>,
    columns: usize,
}

/// The bases of one part.
struct PartSolution {
    retained: [Vec<u32>; 3],
    /// See [`PartBlock::start`].
    start: [usize; 4],
    attributes: Solution,
    nodes: Solution,
}

impl<'a> LearningProblem<'a> {
    /// `inputs` have their subspaces. `announce` is called with the name of each step.
    pub fn new(
        dataset: &'a Dataset,
        inputs: Inputs,
        settings: ProblemSettings,
        announce: &dyn Fn(&str),
    ) -> Self {
        let ProblemSettings {
            training,
            basis,
            constraint,
        } = settings;
        announce("placing nodes");
        let network_inputs = NetworkInputs::new(&inputs, &dataset.poses, &training);
        let displacements = NodeDisplacements::new(dataset);
        announce("taking means");
        let spread = displacements.spread(&training);
        let statistics = AttributeStatistics::new(dataset, &training, spread);
        let mut nodes = vec![Vec::new(); dataset.avatar.parts.len()];
        for (node, &part) in dataset.avatar.nodes.part.iter().enumerate() {
            nodes[usize::from(part)].push(node);
        }
        Self {
            dataset,
            inputs,
            network_inputs,
            training,
            statistics,
            displacements,
            nodes,
            basis,
            constraint,
        }
    }

    fn frames(&self) -> Vec<usize> {
        (0..self.dataset.len()).collect()
    }

    fn node_block(&self, part: usize) -> NodeBlock {
        let nodes = &self.nodes[part];
        let weight = self.statistics.node_weight;
        NodeBlock {
            x: self.displacements.block(nodes, &self.frames(), weight),
            columns: 3 * nodes.len(),
        }
    }

    fn part_block(&self, retained: &RetainedRows, part: usize) -> PartBlock {
        PartBlock::load(
            self.dataset,
            &self.statistics,
            retained,
            part,
            &self.frames(),
        )
    }

    /// The first target of a part: its principal components.
    pub fn principal_components(&self, part: usize) -> QuadraticLoss {
        let components = |x: Vec<f32>, columns: usize| {
            principal_components(x, columns, self.dataset.len(), &self.training, self.basis)
        };
        let block = self.part_block(&RetainedRows::All, part);
        let columns = block.columns();
        let attributes = components(block.x, columns);
        let block = self.node_block(part);
        let nodes = components(block.x, block.columns);
        join(&attributes, &nodes, self.basis)
    }

    /// The best bases of a part for its network's features.
    fn solve_part(
        &self,
        learner: &Learner,
        retained: &RetainedRows,
        part: usize,
        constrained: bool,
    ) -> PartSolution {
        let features = learner.features(part, &self.network_inputs);
        let solve = |x: Vec<f32>, columns: usize, first_feature: usize, runs: &[ColumnRun]| {
            let problem = BasisProblem {
                x,
                columns,
                frames: self.dataset.len(),
                training: &self.training,
                features: &features,
                feature_width: 2 * self.basis,
                first_feature,
                basis: self.basis,
                runs,
            };
            problem.solve()
        };
        let block = self.part_block(retained, part);
        let columns = block.columns();
        let runs: [ColumnRun; 3] = std::array::from_fn(|a| ColumnRun {
            end: block.start[a + 1],
            weight: self.statistics.weight[a],
            constraint: if constrained {
                CONSTRAINT[a] * self.constraint
            } else {
                0.0
            },
        });
        let attributes = solve(block.x, columns, 0, &runs);
        let node_block = self.node_block(part);
        let node_run = ColumnRun {
            end: node_block.columns,
            weight: self.statistics.node_weight,
            constraint: 0.0,
        };
        let nodes = solve(node_block.x, node_block.columns, self.basis, &[node_run]);
        PartSolution {
            retained: block.retained,
            start: block.start,
            attributes,
            nodes,
        }
    }

    /// Solves the bases of every part for the networks so far, sets the networks' next targets, and
    /// returns the avatar so far. `constrained`: correctives are held small.
    pub fn refine(
        &self,
        learner: &mut Learner,
        retained: &RetainedRows,
        constrained: bool,
    ) -> Avatar {
        let parts = self.dataset.avatar.parts.len();
        let solutions: Vec<PartSolution> = (0..parts)
            .into_par_iter()
            .map(|part| self.solve_part(learner, retained, part, constrained))
            .collect();
        let avatar = self.avatar(learner, &solutions);
        for (part, solution) in solutions.iter().enumerate() {
            let target = join(&solution.attributes.loss, &solution.nodes.loss, self.basis);
            learner.set_target(part, target, &self.training);
        }
        avatar
    }

    /// The avatar of networks and bases. Gaussians without a corrective have their mean attributes.
    fn avatar(&self, learner: &Learner, parts: &[PartSolution]) -> Avatar {
        let mut avatar = Avatar {
            networks: learner.to_networks(&self.network_inputs),
            inputs: self.inputs.clone(),
            ..self.dataset.avatar.clone()
        };
        avatar.sh = None;
        let neutral = self.neutral_attributes(parts);
        avatar.gaussians.rotation = neutral[0].as_chunks::<4>().0.to_vec();
        avatar.gaussians.log_scale = neutral[1].as_chunks::<3>().0.to_vec();
        avatar.gaussians.color = neutral[2].as_chunks::<3>().0.to_vec();
        avatar.rotation_rows = self.rows(parts, 0);
        avatar.scale_rows = self.rows(parts, 1);
        avatar.color_rows = self.rows(parts, 2);
        self.write_nodes(parts, &mut avatar);
        avatar
    }

    /// Rotation, log scale and colour of every Gaussian without correctives.
    fn neutral_attributes(&self, parts: &[PartSolution]) -> [Vec<f16>; 3] {
        std::array::from_fn(|a| {
            let width = ATTRIBUTES[a].width();
            let mean = &self.statistics.mean[a];
            let mut neutral: Vec<f16> = mean.iter().map(|&m| f16::from_f32(m)).collect();
            for part in parts {
                for (row, &k) in part.retained[a].iter().enumerate() {
                    let own = &part.attributes.neutral[part.start[a] + row * width..][..width];
                    neutral[k as usize * width..][..width].copy_from_slice(own);
                }
            }
            neutral
        })
    }

    /// The basis rows of an attribute of [`ATTRIBUTES`], part after part.
    fn rows<const C: usize>(&self, parts: &[PartSolution], attribute: usize) -> Rows<C> {
        let mut gaussian = Vec::new();
        let mut basis: Vec<f16> = Vec::new();
        for part in parts {
            gaussian.extend_from_slice(&part.retained[attribute]);
            let columns = part.start[attribute]..part.start[attribute + 1];
            let own = columns.start * self.basis..columns.end * self.basis;
            basis.extend_from_slice(&part.attributes.basis[own]);
        }
        Rows {
            gaussian,
            basis: Matrix::from(basis),
        }
    }

    /// Writes the nodes' neutral displacements and their basis.
    fn write_nodes(&self, parts: &[PartSolution], avatar: &mut Avatar) {
        let length = 3 * self.basis;
        let mut node_basis = vec![f16::ZERO; length * avatar.nodes.len()];
        for (part, nodes) in self.nodes.iter().enumerate() {
            let own = &parts[part].nodes;
            for (row, &node) in nodes.iter().enumerate() {
                avatar.nodes.offset[node] = std::array::from_fn(|c| own.neutral[3 * row + c]);
                node_basis[node * length..][..length]
                    .copy_from_slice(&own.basis[row * length..][..length]);
            }
        }
        avatar.nodes.basis = node_basis.into();
    }
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
