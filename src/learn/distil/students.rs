//! Students: a network a part that learns the features which describe the teacher's Gaussians best,
//! and the bases for them. In stages: networks learn principal components; bases are solved for them
//! and networks learn on; rows are pruned and networks learn on; bases are solved a last time.

use crate::distil::basis::{HalfLoss, Solution, join};
use crate::distil::body::{UntrainedAvatar, plain_inputs};
use crate::distil::columns::{Attribute, ColumnSet};
use crate::distil::judge::{Likeness, judge};
use crate::distil::learner::{Learner, StageSchedule};
use crate::distil::samples::{InputSamples, SampleOptions};
use crate::distil::solve::PartProblem;
use crate::distil::teacher::{AnchorFeatures, Teacher};
use crate::prune::{RowBudget, RowSubject, select_rows};
use effigy_core::avatar::{Avatar, Matrix, Pose, ROW_COMPONENTS, Rows};
use effigy_core::io::file::FormatError;
use effigy_formats::mmlphuman::Checkpoint;
use effigy_math::sampling::evenly_spaced;
use half::f16;
use rayon::prelude::*;
use std::ops::Range;

/// Fewest training poses.
pub const MIN_POSES: usize = 8;
/// Rows over which the attributes' spreads are taken.
const SPREAD_ROWS: usize = 256;
/// Reports of the networks' progress a stage.
const REPORTS: usize = 16;
/// How much of the loss rotation, scale and colour are. Colour is seen most.
const ATTRIBUTE_SHARES: [f64; 3] = [0.2, 0.2, 0.6];
/// How much of the loss the nodes' displacements are, beside the attributes.
const NODE_SHARE: f64 = 0.5;

/// Called with the epochs done and the name of the next step.
pub type DistilProgress<'a> = &'a (dyn Fn(usize, &str) + Sync);

/// How to distil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DistilOptions {
    /// Poses at which the teacher is asked.
    pub samples: SampleOptions,
    /// N_B, a multiple of 4.
    pub basis: usize,
    /// Times that networks see each row, over all stages.
    pub epochs: usize,
    /// Rows to retain.
    pub budget: RowBudget,
    /// Decides the first weights and the order of rows.
    pub seed: u64,
}

/// A distilled avatar.
pub struct Distilled {
    /// The avatar.
    pub avatar: Avatar,
    /// How like the teacher it is.
    pub likeness: Likeness,
}

/// Fits an avatar to a checkpoint. `name`: of the avatar. `trained`: training poses beside the
/// checkpoint's own, of its skeleton. `progress` is called with the epochs done.
///
/// # Errors
/// When there are too few training poses, a number is not finite, or one is too large for the
/// avatar's file.
pub fn distil(
    checkpoint: &Checkpoint,
    name: &str,
    trained: &[Pose],
    options: &DistilOptions,
    progress: DistilProgress,
) -> Result<Distilled, FormatError> {
    let sequence: Vec<Pose> = checkpoint.poses.iter().chain(trained).cloned().collect();
    if sequence.len() < MIN_POSES {
        let found = format!("{} poses", sequence.len());
        return Err(FormatError::metadata(
            "all_poses",
            found,
            format!("at least {MIN_POSES}"),
        ));
    }
    progress(0, "choosing poses");
    let samples = InputSamples::new(&plain_inputs(checkpoint), &sequence, &options.samples);
    let count = checkpoint.networks.count;
    let features = AnchorFeatures::new(&checkpoint.networks, &samples.rows.raw, &|done| {
        progress(0, &format!("asking network {done} of {count}"))
    })?;
    progress(0, "taking means");
    let students = Students::new(checkpoint, name, &samples, &features, options.basis);
    let (avatar, learner) = students.learn(options, progress);
    let avatar = Avatar {
        name: name.into(),
        ..avatar
    };
    avatar.check()?;
    progress(options.epochs, "comparing");
    let unexplained = learner.unexplained(&samples.rows, [&samples.training, &samples.held_rows]);
    let teacher = Teacher { checkpoint };
    let mut likeness = judge(&teacher, &features, &samples, &students.body, &avatar);
    likeness.unexplained = unexplained;
    Ok(Distilled { avatar, likeness })
}

/// Everything that stays the same while networks learn.
struct Students<'a> {
    checkpoint: &'a Checkpoint<'a>,
    samples: &'a InputSamples,
    features: &'a AnchorFeatures,
    /// Of each anchor over the training rows.
    means: Vec<Vec<f32>>,
    body: UntrainedAvatar,
    /// Nodes of each part.
    nodes: Vec<Vec<usize>>,
    /// 1 / length of each Gaussian's mean quaternion; the checkpoint's order.
    unit: Vec<f32>,
    /// Rotation, log scale, colour at the mean features; the avatar's order.
    mean: [Vec<f32>; 3],
    /// The factor of each attribute's numbers.
    weight: [f32; 3],
    node_weight: f32,
    /// N_B.
    basis: usize,
}

/// A part's attributes, ready to be learned.
struct PartColumns {
    columns: ColumnSet,
    /// The factor of each column.
    weights: Vec<f32>,
    /// The avatar's Gaussians that have columns, for each attribute.
    retained: [Vec<u32>; 3],
}

/// The bases of one part.
struct PartSolution {
    retained: [Vec<u32>; 3],
    /// Column after column: of each Gaussian its retained attributes.
    attributes: Solution,
    nodes: Solution,
}

impl<'a> Students<'a> {
    fn new(
        checkpoint: &'a Checkpoint<'a>,
        name: &str,
        samples: &'a InputSamples,
        features: &'a AnchorFeatures,
        basis: usize,
    ) -> Self {
        let means = features.means(&samples.training);
        let body =
            UntrainedAvatar::new(checkpoint, name, features, &means, &samples.training, basis);
        let mut nodes = vec![Vec::new(); body.avatar.parts.len()];
        for (node, &part) in body.avatar.nodes.part.iter().enumerate() {
            nodes[usize::from(part)].push(node);
        }
        let look = Teacher { checkpoint }.look(&AnchorFeatures::of_means(&means), 0);
        let length = |q: &[f64; 4]| q.iter().map(|part| part * part).sum::<f64>().sqrt();
        let unit: Vec<f32> = look
            .rotation
            .iter()
            .map(|q| (1.0 / length(q).max(1e-6)) as f32)
            .collect();
        let mut students = Self {
            checkpoint,
            samples,
            features,
            means,
            body,
            nodes,
            unit,
            mean: [vec![], vec![], vec![]],
            weight: [1.0; 3],
            node_weight: 1.0,
            basis,
        };
        students.take_statistics();
        students
    }

    fn parts(&self) -> usize {
        self.body.avatar.parts.len()
    }

    /// Means, and the weights that make the attributes' losses comparable.
    fn take_statistics(&mut self) {
        let rows = evenly_spaced(&self.samples.training, SPREAD_ROWS);
        struct PartStatistics {
            mean: Vec<f32>,
            spread: f64,
        }
        let own = |attribute: usize, part: usize| {
            let mut lists: [Vec<u32>; 3] = Default::default();
            let range = self.body.avatar.parts.gaussians(part);
            lists[attribute] = (range.start as u32..range.end as u32).collect();
            let own = self.part_columns(part, &RetainedRows::Listed(lists));
            let mean = own.columns.mean.clone();
            PartStatistics {
                spread: self.problem(own.columns, &rows).spread(),
                mean,
            }
        };
        let attributes: [Vec<PartStatistics>; 3] = std::array::from_fn(|attribute| {
            (0..self.parts())
                .into_par_iter()
                .map(|part| own(attribute, part))
                .collect()
        });
        let nodes: f64 = (0..self.parts())
            .into_par_iter()
            .map(|part| self.problem(self.node_columns(part), &rows).spread())
            .sum();
        // What does not vary has no loss, whatever its weight.
        let weight = |share: f64, spread: f64| {
            if spread > 1e-12 {
                (share / spread).sqrt() as f32
            } else {
                1.0
            }
        };
        self.weight = std::array::from_fn(|attribute| {
            let spread = attributes[attribute].iter().map(|part| part.spread).sum();
            weight(ATTRIBUTE_SHARES[attribute], spread)
        });
        self.node_weight = weight(NODE_SHARE, nodes);
        self.mean =
            attributes.map(|parts| parts.iter().flat_map(|part| &part.mean).copied().collect());
    }

    fn problem<'b>(&self, columns: ColumnSet, training: &'b [usize]) -> PartProblem<'b> {
        PartProblem::new(columns, self.features, &self.means, training)
    }

    /// The columns of a part's retained attributes, times their weights.
    fn part_columns(&self, part: usize, retained: &RetainedRows) -> PartColumns {
        let Checkpoint {
            gaussians,
            bases,
            basis,
            color_unit,
            ..
        } = self.checkpoint;
        let range = self.body.avatar.parts.gaussians(part);
        let retained: [Vec<u32>; 3] = std::array::from_fn(|a| retained.within(a, &range));
        let mut columns = ColumnSet::new(0..*basis);
        let mut weights = Vec::new();
        let basis_of =
            |all: fn(&effigy_formats::mmlphuman::AttributeBases) -> &[f32], k: usize, c: usize| {
                let bases = bases.as_ref().map(all);
                bases.map(|bases| &bases[k * basis * c..][..basis * c])
            };
        let unit = *color_unit as f32;
        for gaussian in range {
            let has = |a: usize| retained[a].binary_search(&(gaussian as u32)).is_ok();
            let k = self.body.order[gaussian] as usize;
            let color = gaussians.color[k].map(|c| 0.5 / unit + c);
            let all = [
                Attribute {
                    neutral: &gaussians.rotation[k],
                    basis: basis_of(|bases| &bases.rotation, k, 4),
                    scale: self.weight[0] * self.unit[k],
                },
                Attribute {
                    neutral: &gaussians.log_scale[k],
                    basis: basis_of(|bases| &bases.log_scale, k, 3),
                    scale: self.weight[1],
                },
                Attribute {
                    neutral: &color,
                    basis: basis_of(|bases| &bases.color, k, 3),
                    scale: self.weight[2] * unit,
                },
            ];
            let mut own = Vec::with_capacity(3);
            for (a, attribute) in all.into_iter().enumerate() {
                if has(a) {
                    weights.extend(std::iter::repeat_n(self.weight[a], attribute.neutral.len()));
                    own.push(attribute);
                }
            }
            if !own.is_empty() {
                columns.add(&self.checkpoint.gaussian_anchors, k, &own, &self.means);
            }
        }
        PartColumns {
            columns,
            weights,
            retained,
        }
    }

    /// The columns of a part's nodes: displacements about their means, which the body has already.
    fn node_columns(&self, part: usize) -> ColumnSet {
        let Checkpoint {
            nodes,
            basis,
            node_basis,
            ..
        } = self.checkpoint;
        let mut columns = ColumnSet::new(*basis..basis + node_basis);
        for &node in &self.nodes[part] {
            let own = nodes.basis.as_ref();
            let attribute = Attribute {
                neutral: &nodes.offset[node],
                basis: own.map(|own| &own[node * node_basis * 3..][..node_basis * 3]),
                scale: self.node_weight,
            };
            columns.add(&nodes.anchors, node, &[attribute], &self.means);
        }
        columns.mean.fill(0.0);
        columns
    }

    /// The first target of a part: its principal components.
    fn principal_components(&self, part: usize) -> [HalfLoss; 2] {
        let own = self.part_columns(part, &RetainedRows::All);
        [own.columns, self.node_columns(part)].map(|columns| {
            let problem = self.problem(columns, &self.samples.training);
            problem.principal_components(self.basis)
        })
    }

    fn solve_part(&self, learner: &Learner, retained: &RetainedRows, part: usize) -> PartSolution {
        let features = learner.features(part, &self.samples.rows);
        let solve = |columns: ColumnSet, first: usize, weights: &[f32]| {
            let problem = self.problem(columns, &self.samples.training);
            problem.solve(&features, 2 * self.basis, first, self.basis, weights)
        };
        let own = self.part_columns(part, retained);
        let nodes = self.node_columns(part);
        let node_weights = vec![self.node_weight; nodes.len()];
        PartSolution {
            attributes: solve(own.columns, 0, &own.weights),
            nodes: solve(nodes, self.basis, &node_weights),
            retained: own.retained,
        }
    }

    /// Solves the bases of every part for the networks so far, sets the networks' next targets, and
    /// returns the avatar so far.
    fn refine(&self, learner: &mut Learner, retained: &RetainedRows) -> Avatar {
        let solutions: Vec<PartSolution> = (0..self.parts())
            .into_par_iter()
            .map(|part| self.solve_part(learner, retained, part))
            .collect();
        let avatar = self.avatar(learner, &solutions);
        for (part, solution) in solutions.iter().enumerate() {
            let target = join(&solution.attributes.loss, &solution.nodes.loss, self.basis);
            learner.set_target(part, target, &self.samples.training);
        }
        avatar
    }

    /// The avatar of networks and bases. Gaussians without a corrective have their mean attributes.
    fn avatar(&self, learner: &Learner, parts: &[PartSolution]) -> Avatar {
        let mut avatar = Avatar {
            networks: learner.to_networks(&self.samples.rows),
            inputs: self.samples.inputs.clone(),
            ..self.body.avatar.clone()
        };
        let mut neutral: [Vec<f16>; 3] = std::array::from_fn(|a| {
            self.mean[a]
                .iter()
                .map(|&mean| f16::from_f32(mean))
                .collect()
        });
        let mut basis: [Vec<f16>; 3] = Default::default();
        let mut node_basis = vec![f16::ZERO; 3 * self.basis * avatar.nodes.len()];
        for (part, solution) in parts.iter().enumerate() {
            let mut column = 0;
            for gaussian in avatar.parts.gaussians(part) {
                for (a, width) in ROW_COMPONENTS.into_iter().enumerate() {
                    if solution.retained[a]
                        .binary_search(&(gaussian as u32))
                        .is_err()
                    {
                        continue;
                    }
                    let own = column..column + width;
                    column = own.end;
                    neutral[a][gaussian * width..][..width]
                        .copy_from_slice(&solution.attributes.neutral[own.clone()]);
                    let rows = own.start * self.basis..own.end * self.basis;
                    basis[a].extend_from_slice(&solution.attributes.basis[rows]);
                }
            }
            for (row, &node) in self.nodes[part].iter().enumerate() {
                let own = &solution.nodes;
                avatar.nodes.offset[node] = std::array::from_fn(|c| own.neutral[3 * row + c]);
                let length = 3 * self.basis;
                node_basis[node * length..][..length]
                    .copy_from_slice(&own.basis[row * length..][..length]);
            }
        }
        avatar.gaussians.rotation = neutral[0].as_chunks::<4>().0.to_vec();
        avatar.gaussians.log_scale = neutral[1].as_chunks::<3>().0.to_vec();
        avatar.gaussians.color = neutral[2].as_chunks::<3>().0.to_vec();
        let [rotation, scale, color] = basis;
        avatar.rotation_rows = rows(parts, 0, rotation);
        avatar.scale_rows = rows(parts, 1, scale);
        avatar.color_rows = rows(parts, 2, color);
        avatar.nodes.basis = node_basis.into();
        avatar
    }

    /// Runs the stages. Returns the avatar and its networks.
    fn learn(&self, options: &DistilOptions, progress: DistilProgress) -> (Avatar, Learner) {
        let mut learner = Learner::new(
            &self.body.avatar,
            &self.samples.rows,
            self.basis,
            options.seed,
        );
        let quarter = options.epochs / 4;
        let first = options.epochs - 2 * quarter;
        progress(0, "finding components");
        let targets: Vec<[HalfLoss; 2]> = (0..self.parts())
            .into_par_iter()
            .map(|part| self.principal_components(part))
            .collect();
        for (part, [attributes, nodes]) in targets.iter().enumerate() {
            let target = join(attributes, nodes, self.basis);
            learner.set_target(part, target, &self.samples.training);
        }
        drop(targets);
        let mut run = StageRun {
            students: self,
            options,
            progress,
            done: 0,
        };
        run.stage(&mut learner, 0, first);
        progress(run.done, "solving bases");
        self.refine(&mut learner, &RetainedRows::All);
        run.stage(&mut learner, 1, quarter);
        progress(run.done, "pruning");
        let whole = self.refine(&mut learner, &RetainedRows::All);
        let samples = self.samples;
        let subject = RowSubject {
            poses: samples
                .learned
                .iter()
                .map(|&pose| &samples.poses[pose])
                .collect(),
            mean: &self.mean,
            covariances: learner.feature_covariances(&samples.rows, &samples.training),
        };
        let retained = RetainedRows::Listed(select_rows(&subject, &whole, options.budget));
        self.refine(&mut learner, &retained);
        run.stage(&mut learner, 2, quarter);
        progress(run.done, "solving bases");
        let avatar = self.refine(&mut learner, &retained);
        (avatar, learner)
    }
}

/// Which Gaussians keep a corrective, after pruning or before.
enum RetainedRows {
    /// Every Gaussian has a corrective of every attribute: nothing was pruned.
    All,
    /// For rotation, scale and colour the Gaussians that have a corrective, in rising order.
    Listed([Vec<u32>; 3]),
}

impl RetainedRows {
    /// Those of a range of Gaussians. `attribute`: 0 to 2, rotation, scale and colour.
    fn within(&self, attribute: usize, range: &Range<usize>) -> Vec<u32> {
        match self {
            Self::All => (range.start as u32..range.end as u32).collect(),
            Self::Listed(lists) => {
                let list = &lists[attribute];
                let first_from =
                    |gaussian: usize| list.partition_point(|&k| (k as usize) < gaussian);
                list[first_from(range.start)..first_from(range.end)].to_vec()
            }
        }
    }
}

/// The rows of one attribute.
fn rows<const C: usize>(parts: &[PartSolution], attribute: usize, basis: Vec<f16>) -> Rows<C> {
    let gaussian = parts.iter().flat_map(|part| &part.retained[attribute]);
    Rows {
        gaussian: gaussian.copied().collect(),
        basis: Matrix::from(basis),
    }
}

/// Stages that follow one another.
struct StageRun<'a> {
    students: &'a Students<'a>,
    options: &'a DistilOptions,
    progress: DistilProgress<'a>,
    /// Epochs of all stages so far.
    done: usize,
}

impl StageRun<'_> {
    /// Lets all networks learn for some epochs.
    fn stage(&mut self, learner: &mut Learner, stage: usize, epochs: usize) {
        for network in &mut learner.networks {
            network.reset_moments();
        }
        let schedule = StageSchedule {
            seed: self.options.seed,
            stage,
            epochs,
        };
        let samples = self.students.samples;
        let step = epochs.div_ceil(REPORTS).max(1);
        for start in (0..epochs).step_by(step) {
            let end = (start + step).min(epochs);
            learner.train(&samples.rows, &samples.training, start..end, schedule);
            self.done += end - start;
            let [training, held] =
                learner.unexplained(&samples.rows, [&samples.training, &samples.held_rows]);
            let message = format!(
                "training networks, {:.1} % left, {:.1} % of held-out poses",
                100.0 * training,
                100.0 * held
            );
            (self.progress)(self.done, &message);
        }
    }
}
