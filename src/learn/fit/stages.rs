//! The stages of a fit.
//!
//! ```text
//! stage 0   networks learn the parts' principal components
//! stage 1   bases solved for the networks, correctives constrained;
//!           networks learn with these bases
//! stage 2   bases solved again, rows pruned, bases of the retained rows solved unconstrained;
//!           networks learn on
//! end       bases solved a last time
//! ```
//!
//! Without a budget for rows, stage 2 is left out.

use crate::dataset::{Dataset, LearnError};
use crate::fit::checkpoint::{FitState, StageProgress};
use crate::fit::loss_curve::LossPoint;
use crate::fit::options::{CheckpointOptions, FitOptions};
use crate::prune::{RowSubject, select_rows};
use crate::train::block::RetainedRows;
use crate::train::inputs::fit_subspaces;
use crate::train::learner::{Learner, StageSchedule};
use crate::train::problem::{LearningProblem, ProblemSettings};
use effigy_core::avatar::{Avatar, Inputs};
use rayon::prelude::*;
use std::time::Instant;

/// About how many points the loss curves have, and how many chances there are for a checkpoint.
const POINTS: usize = 40;

/// Deviation of the noise added to poses while training, radians: similar poses look alike.
const POSE_NOISE: f32 = 0.03;

/// The result of a fit.
pub struct Fitted {
    /// The learned avatar.
    pub avatar: Avatar,
    /// The loss over the epochs.
    pub curve: Vec<LossPoint>,
}

/// A callback for progress, called with the epochs done and the name of the next step.
pub type FitProgress<'a> = &'a (dyn Fn(usize, &str) + Sync);

/// Fits an avatar to a dataset.
///
/// # Errors
/// When a checkpoint cannot be read or written, or is of another fit.
pub fn fit(
    dataset: &Dataset,
    options: &FitOptions,
    progress: FitProgress,
) -> Result<Fitted, LearnError> {
    let poses: Vec<_> = dataset
        .training(&options.clips)
        .iter()
        .map(|&frame| &dataset.poses[frame])
        .collect();
    let inputs = fit_subspaces(&dataset.avatar.inputs, &poses);
    let problem = problem(dataset, inputs, options, progress);
    let learner = Learner::new(
        &dataset.avatar,
        &problem.network_inputs,
        options.basis,
        options.seed,
    );
    let stages = FitRun {
        problem: &problem,
        options,
        epochs: options.stage_epochs(),
        first: 0,
        unpruned: None,
        progress,
    };
    stages.run(learner, fingerprint(dataset, options, "fit"))
}

/// Prunes a fitted avatar to a budget and trains the retained rows on: stage 2 alone. N_B is the
/// avatar's.
///
/// # Errors
/// When a checkpoint cannot be read or written, or is of another fit.
pub fn prune(
    dataset: &Dataset,
    avatar: &Avatar,
    options: &FitOptions,
    progress: FitProgress,
) -> Result<Fitted, LearnError> {
    let options = &FitOptions {
        basis: avatar.basis_len(),
        ..options.clone()
    };
    let problem = problem(dataset, avatar.inputs.clone(), options, progress);
    let learner = Learner::from_avatar(avatar, &problem.network_inputs);
    let stages = FitRun {
        problem: &problem,
        options,
        epochs: options.stage_epochs(),
        first: 2,
        unpruned: Some(avatar),
        progress,
    };
    let task = format!("prune {}", avatar.name);
    stages.run(learner, fingerprint(dataset, options, &task))
}

fn problem<'a>(
    dataset: &'a Dataset,
    inputs: Inputs,
    options: &FitOptions,
    progress: FitProgress,
) -> LearningProblem<'a> {
    let settings = ProblemSettings {
        training: dataset.training(&options.clips),
        basis: options.basis,
        constraint: options.constraint,
    };
    LearningProblem::new(dataset, inputs, settings, &|step| progress(0, step))
}

/// Tells one fit's checkpoints from another's.
fn fingerprint(dataset: &Dataset, options: &FitOptions, task: &str) -> String {
    let plain = FitOptions {
        checkpoint: None,
        ..options.clone()
    };
    format!(
        "{task}: {plain:?}, {:?}, {} parts",
        dataset.header,
        dataset.avatar.parts.len()
    )
}

/// A run through the stages.
struct FitRun<'a> {
    problem: &'a LearningProblem<'a>,
    options: &'a FitOptions,
    /// Epochs of each stage.
    epochs: Vec<usize>,
    /// The stage to begin with.
    first: usize,
    /// The avatar to prune; the fit's own if `None`.
    unpruned: Option<&'a Avatar>,
    progress: FitProgress<'a>,
}

impl FitRun<'_> {
    /// Runs the stages that are left: all, or those after a checkpoint.
    fn run(&self, learner: Learner, fingerprint: String) -> Result<Fitted, LearnError> {
        let fresh = FitState {
            progress: StageProgress {
                fingerprint,
                stage: self.first,
                ..StageProgress::default()
            },
            learner,
            retained: RetainedRows::All,
        };
        let mut state = match &self.options.checkpoint {
            Some(checkpoint) => FitState::read(&checkpoint.path, &fresh)?.unwrap_or(fresh),
            None => fresh,
        };
        let mut written = Instant::now();
        while state.progress.stage < self.epochs.len() {
            self.run_stage(&mut state, &mut written)?;
            state.progress.stage += 1;
            state.progress.epoch = 0;
        }
        (self.progress)(self.epochs_before(self.epochs.len()), "solving bases");
        let unpruned = state.retained == RetainedRows::All;
        let avatar = self
            .problem
            .refine(&mut state.learner, &state.retained, unpruned);
        Ok(Fitted {
            avatar,
            curve: state.progress.curve,
        })
    }

    /// Epochs of this run's stages before `stage`.
    fn epochs_before(&self, stage: usize) -> usize {
        self.epochs[self.first..stage].iter().sum()
    }

    /// Runs the rest of the state's stage. `written`: the time of the last checkpoint.
    fn run_stage(&self, state: &mut FitState, written: &mut Instant) -> Result<(), LearnError> {
        let stage = state.progress.stage;
        let epochs = self.epochs[stage];
        let before = self.epochs_before(stage);
        if state.progress.epoch == 0 {
            let step = ["finding components", "solving bases", "pruning"][stage];
            (self.progress)(before, step);
            self.begin_stage(state);
        }
        (self.progress)(before + state.progress.epoch, "training networks");
        let schedule = StageSchedule {
            seed: self.options.seed,
            stage,
            epochs,
            noise: POSE_NOISE,
        };
        while state.progress.epoch < epochs {
            let end = (state.progress.epoch + self.options.epochs.div_ceil(POINTS)).min(epochs);
            state.learner.train(
                &self.problem.network_inputs,
                &self.problem.training,
                state.progress.epoch..end,
                schedule,
            );
            state.progress.epoch = end;
            self.record_loss(state, before + end);
            if let Some(CheckpointOptions { path, interval }) = &self.options.checkpoint
                && written.elapsed() >= *interval
            {
                state.write(path)?;
                *written = Instant::now();
            }
        }
        Ok(())
    }

    /// Appends a point to the loss curves and reports it. `epoch` counts from the start of the fit.
    fn record_loss(&self, state: &mut FitState, epoch: usize) {
        let dataset = self.problem.dataset;
        let held_out: Vec<usize> = (0..dataset.len())
            .filter(|&frame| dataset.header.frames[frame].held)
            .collect();
        let [training, held] = state.learner.unexplained(
            &self.problem.network_inputs,
            [&self.problem.training, &held_out],
        );
        state.progress.curve.push(LossPoint {
            stage: state.progress.stage,
            epoch,
            training,
            held,
        });
        let message = format!(
            "training networks, {:.1} % left, {:.1} % of held-out frames",
            100.0 * training,
            100.0 * held
        );
        (self.progress)(epoch, &message);
    }

    /// Sets the networks' targets for the state's stage.
    fn begin_stage(&self, state: &mut FitState) {
        let problem = self.problem;
        match state.progress.stage {
            0 => {
                let parts = problem.dataset.avatar.parts.len();
                let targets: Vec<_> = (0..parts)
                    .into_par_iter()
                    .map(|part| problem.principal_components(part))
                    .collect();
                for (part, target) in targets.into_iter().enumerate() {
                    state.learner.set_target(part, target, &problem.training);
                }
            }
            1 => {
                problem.refine(&mut state.learner, &state.retained, true);
            }
            _ => {
                let unpruned = match self.unpruned {
                    Some(avatar) => avatar.clone(),
                    None => problem.refine(&mut state.learner, &state.retained, true),
                };
                if let Some(budget) = self.options.budget {
                    let subject = RowSubject {
                        body: &problem.dataset.avatar,
                        poses: problem
                            .training
                            .iter()
                            .map(|&frame| &problem.dataset.poses[frame])
                            .collect(),
                        mean: &problem.statistics.mean,
                        covariances: state
                            .learner
                            .feature_covariances(&problem.network_inputs, &problem.training),
                    };
                    state.retained = select_rows(&subject, &unpruned, budget);
                }
                problem.refine(&mut state.learner, &state.retained, false);
            }
        }
        for network in &mut state.learner.networks {
            network.reset_moments();
        }
    }
}
