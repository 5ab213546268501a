//! A dataset in, a learned avatar out, stage by stage; and an avatar in, a pruned one out.
//!
//! ```text
//! stage 0   networks learn the parts' principal components
//! stage 1   bases solved for the networks, with the constraint on correctives; networks learn what those bases leave
//! stage 2   bases solved again, rows pruned, bases of the kept ones solved without the constraint; networks learn on
//! end       bases solved a last time
//! ```
//! Unpruned avatars end after stage 1.

use super::block::{Kept, Statistics};
use super::checkpoint::{Point, Position, State};
use super::dataset::{Dataset, Error};
use super::inputs::{Seen, spaces};
use super::learner::{Epoch, Learner};
use super::nodes::Moves;
use super::prune::{Budget, select};
use super::solve::Ground;
use crate::avatar::{Avatar, Inputs};
use rayon::prelude::*;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Epochs between points of the loss curves, and between chances for a checkpoint: this many a fit.
const POINTS: usize = 40;

/// How to fit.
#[derive(Clone, Debug)]
pub struct Options {
    /// N_B.
    pub basis: usize,
    /// Epochs of all stages.
    pub epochs: usize,
    pub seed: u64,
    /// Clips to fit to; all where none is named.
    pub clips: Vec<String>,
    /// How much the constraint on correctives counts; 1 is usual, 0 leaves it out.
    pub constraint: f32,
    /// None: nothing is pruned.
    pub budget: Option<Budget>,
    /// Where the state is kept, and how often it is written.
    pub checkpoint: Option<(PathBuf, Duration)>,
}

impl Default for Options {
    fn default() -> Self {
        Self { basis: 16, epochs: 400, seed: 1, clips: Vec::new(), constraint: 1.0, budget: Some(Budget::Shown(60_000)), checkpoint: None }
    }
}

impl Options {
    /// Epochs of each stage.
    fn stages(&self) -> Vec<usize> {
        let quarter = self.epochs / 4;
        let first = self.epochs - 2 * quarter;
        if self.budget.is_some() { vec![first, quarter, quarter] } else { vec![first, quarter] }
    }
}

/// What a fit made.
pub struct Fitted {
    pub avatar: Avatar,
    pub curve: Vec<Point>,
}

/// Hears how far a fit is: epochs done of all, and what happens.
pub type Hear<'a> = &'a (dyn Fn(usize, &str) + Sync);

/// What a fit works on; `inputs` with their spaces.
fn ground<'a>(dataset: &'a Dataset, inputs: Inputs, options: &Options, hear: Hear) -> Result<Ground<'a>, Error> {
    let training = dataset.training(&options.clips);
    hear(0, "placing nodes");
    let seen = Seen::new(&inputs, &dataset.poses, &training);
    let moves = Moves::new(dataset);
    hear(0, "taking means");
    let statistics = Statistics::new(dataset, &training, moves.spread(&training));
    let mut nodes = vec![Vec::new(); dataset.avatar.parts.len()];
    dataset.avatar.nodes.part.iter().enumerate().for_each(|(node, &part)| nodes[usize::from(part)].push(node));
    Ok(Ground { dataset, inputs, seen, training, statistics, moves, nodes, basis: options.basis, constraint: options.constraint })
}

/// The avatar's inputs with spaces of the training poses.
fn inputs(dataset: &Dataset, options: &Options) -> Inputs {
    let poses: Vec<_> = dataset.training(&options.clips).iter().map(|&frame| &dataset.poses[frame]).collect();
    spaces(&dataset.avatar.inputs, &poses)
}

/// Fits an avatar to a dataset.
///
/// # Errors
/// When a checkpoint cannot be read or written, or is of another fit.
pub fn fit(dataset: &Dataset, options: &Options, hear: Hear) -> Result<Fitted, Error> {
    let ground = ground(dataset, inputs(dataset, options), options, hear)?;
    let fingerprint = fingerprint(dataset, options, "fit");
    let learner = Learner::new(&dataset.avatar, &ground.seen, options.basis, options.seed);
    let fresh = State { at: Position { fingerprint, ..Position::default() }, learner, kept: Kept(None) };
    let (avatar, curve) = course(&ground, options, fresh, None, hear)?;
    Ok(Fitted { avatar, curve })
}

/// Prunes a fitted avatar to a budget and fine-tunes what is left.
///
/// # Errors
/// As [`fit`].
pub fn prune(dataset: &Dataset, from: &Avatar, options: &Options, hear: Hear) -> Result<Fitted, Error> {
    let options = &Options { basis: from.basis_len(), ..options.clone() };
    let ground = ground(dataset, from.inputs.clone(), options, hear)?;
    let learner = Learner::of(from, &ground.seen);
    let fingerprint = fingerprint(dataset, options, &format!("prune {}", from.name));
    let fresh = State { at: Position { fingerprint, stage: 2, ..Position::default() }, learner, kept: Kept(None) };
    let (avatar, curve) = course(&ground, options, fresh, Some(from), hear)?;
    Ok(Fitted { avatar, curve })
}

/// Says of a checkpoint whether it is of the same fit.
fn fingerprint(dataset: &Dataset, options: &Options, what: &str) -> String {
    let plain = Options { checkpoint: None, ..options.clone() };
    format!("{what}: {plain:?}, {:?}, {} parts", dataset.header, dataset.avatar.parts.len())
}

/// Goes through the stages that are left, from a checkpoint where there is one.
fn course(ground: &Ground, options: &Options, fresh: State, from: Option<&Avatar>, hear: Hear) -> Result<(Avatar, Vec<Point>), Error> {
    let stages = options.stages();
    let begun = fresh.at.stage;
    let mut state = match &options.checkpoint {
        Some((path, _)) => State::read(path, &fresh)?.unwrap_or(fresh),
        None => fresh,
    };
    let held: Vec<usize> = (0..ground.dataset.len()).filter(|&frame| ground.dataset.header.frames[frame].held).collect();
    let mut written = Instant::now();
    while state.at.stage < stages.len() {
        let (stage, of) = (state.at.stage, stages[state.at.stage]);
        let done: usize = stages[begun..stage].iter().sum();
        if state.at.epoch == 0 {
            hear(done, ["finding components", "solving bases", "pruning"][stage]);
            prepare(ground, options, &mut state, from);
        }
        hear(done + state.at.epoch, "training networks");
        while state.at.epoch < of {
            let end = (state.at.epoch + options.epochs.div_ceil(POINTS)).min(of);
            let plan = Epoch { seed: options.seed, stage, number: 0, of };
            state.learner.train(&ground.seen, &ground.training, state.at.epoch..end, plan);
            state.at.epoch = end;
            let [training, held] = state.learner.loss(&ground.seen, [&ground.training, &held]);
            state.at.curve.push(Point { stage, epoch: done + end, training, held });
            hear(done + end, &format!("training networks, {:.1} % left, {:.1} % of held-out frames", 100.0 * training, 100.0 * held));
            if let Some((path, every)) = &options.checkpoint
                && written.elapsed() >= *every
            {
                state.write(path)?;
                written = Instant::now();
            }
        }
        (state.at.stage, state.at.epoch) = (stage + 1, 0);
    }
    hear(stages[begun..].iter().sum(), "solving bases");
    let avatar = ground.refine(&mut state.learner, &state.kept, state.kept.0.is_none());
    Ok((avatar, state.at.curve))
}

/// What a stage begins with.
fn prepare(ground: &Ground, options: &Options, state: &mut State, from: Option<&Avatar>) {
    match state.at.stage {
        0 => {
            let parts = ground.dataset.avatar.parts.len();
            let targets: Vec<_> = (0..parts).into_par_iter().map(|part| ground.components(part)).collect();
            targets.into_iter().enumerate().for_each(|(part, target)| state.learner.aim(part, target, &ground.training));
        }
        1 => {
            ground.refine(&mut state.learner, &state.kept, true);
        }
        _ => {
            let whole = from.cloned().unwrap_or_else(|| ground.refine(&mut state.learner, &state.kept, true));
            if let Some(budget) = options.budget {
                state.kept = select(ground, &state.learner, &whole, budget);
            }
            ground.refine(&mut state.learner, &state.kept, false);
        }
    }
    state.learner.networks.iter_mut().for_each(|network| network.rest());
}
