//! A training from start to end: steps, pruning, checkpoints, and the avatar that comes out.

use crate::adam::{Adam, Rates};
use crate::checkpoint::{TrainingCheckpoint, remove_parts};
use crate::data::{LoadedView, ShotIndex, TrainingViews, distinct_shots, training_shots};
use crate::error::{LEAST_SIDE, MAX_EMPTY_VIEWS, TrainError};
use crate::exposure::Exposure;
use crate::gpu::{StepOptions, Trainer, TrainerState, memory_bytes};
use crate::lock::Lock;
use crate::log::{self, ProgressSums, TrainingProgress, TrainingTime};
use crate::parameters::{ParameterLayout, Parameters};
use crate::perceptual::PerceptualLoss;
use crate::preflight::{self, PreflightSubject};
use crate::prune::{Pruning, Sensitivity, feature_covariance, keep_rows};
use crate::recipe::{PruneBy, Recipe};
use crate::refine::{CameraGradient, RefineRates, Refinement, SeenFrom};
use crate::start::start;
use crate::topology::{CorrectiveRows, Topology};
use crate::view::TrainingView;
use crate::watch::{self, WatchedImage, WatchedViews, watched_shots};
use effigy_capture::{Capture, CaptureError};
use effigy_core::avatar::{Avatar, Pose, PoseGradient, Skeleton};
use effigy_core::io::file::{FileError, replace};
use effigy_core::layout::TRAIN_WIDTH_MAX;
use effigy_core::reference::mlp;
use effigy_core::scene::{Camera, Posed};
use effigy_math::facing::face;
use effigy_render::vulkan::Gpu;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::sync::{Arc, OnceLock};
use std::thread;
use std::time::{Duration, Instant};

/// The avatar that a training began with.
const START: &str = "start.avatar";
/// The recipe that it follows.
pub const RECIPE: &str = "recipe.toml";
/// The poses that were learned, as a clip.
pub const POSES: &str = "poses.motion";

/// Longest wait for pictures before `stop` is checked again.
const STOPS_WITHIN: Duration = Duration::from_millis(100);

/// Options of a training besides its recipe.
pub struct SessionOptions {
    /// The training's own folder: checkpoints, log, recipe.
    pub folder: PathBuf,
    /// Resumes the folder's training, if it has one.
    pub resume: bool,
    /// Ends when the training has taken so long in all, whatever the recipe's steps.
    pub minutes: Option<f64>,
    /// Checks first that every input moves some pixel and some derivative ([`preflight::check`]),
    /// unless it resumes.
    pub check: bool,
    /// From one checkpoint to the next.
    pub checkpoint_every: Duration,
    /// From one line of the log to the next, steps.
    pub log_every: u64,
    /// Where the weights of the perceptual loss are.
    pub perceptual_weights: PathBuf,
    /// Kept up to date by the training.
    pub standing: Arc<TrainingStatus>,
    /// Name of the avatar.
    pub name: String,
    /// Where it comes from.
    pub credit: String,
}

/// The state of a training, readable by what may end the program at any time.
#[derive(Default)]
pub struct TrainingStatus {
    /// Steps so far; 0 while it is not known yet.
    pub steps: AtomicU64,
    /// Whether something was learned since the last checkpoint.
    pub is_unsaved: Arc<AtomicBool>,
    /// The folder's lock, once it is taken.
    lock: OnceLock<File>,
}

impl TrainingStatus {
    /// Releases the folder's lock, before the program ends without dropping the session.
    pub fn leave(&self) {
        if let Some(lock) = self.lock.get() {
            lock.set_len(0).ok();
        }
    }
}

/// What a training is about to do, and the memory for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TrainingPlan {
    /// Number of pictures that it learns from.
    pub pictures: usize,
    /// Width and height of every view, px.
    pub view_size: [u32; 2],
    /// Device memory, bytes.
    pub memory_bytes: u64,
    /// Steps taken before.
    pub steps: u64,
    /// Whether [`preflight::check`] runs first.
    pub check: bool,
}

/// How a training ended.
pub enum TrainingOutcome {
    /// With an avatar.
    Done(Box<Avatar>),
    /// It was asked to stop, and can go on from a checkpoint.
    Stopped,
}

/// A training that has begun.
pub struct TrainingSession {
    gpu: Arc<Gpu>,
    capture: Arc<Capture>,
    recipe: Recipe,
    options: SessionOptions,
    start: Avatar,
    topology: Topology,
    rows: CorrectiveRows,
    /// None after pruning ran out of device memory, which ends the session.
    trainer: Option<Trainer>,
    /// Steps when it ended so.
    ended_at: u64,
    views: Arc<TrainingViews>,
    watched: WatchedViews,
    perceptual: Option<PerceptualLoss>,
    exposure: Exposure,
    refinement: Refinement,
    pruned: bool,
    /// How often it was found from where Gaussians show.
    faced: u64,
    place: u64,
    /// Views so far in which no Gaussian was visible; None after the first with one.
    empty_views: Option<u64>,
    /// Seconds before this session.
    seconds: f64,
    begun: Instant,
    _lock: Lock,
}

impl TrainingSession {
    /// Begins a training, or resumes one. `announce` gets the plan before the device is used.
    ///
    /// # Errors
    /// When the folder is taken or has a training that is not to be resumed, the device is not
    /// suitable, or a file can't be read or written.
    pub fn new(
        gpu: &Arc<Gpu>,
        capture: &Arc<Capture>,
        recipe: &Recipe,
        options: SessionOptions,
        announce: impl FnOnce(&TrainingPlan),
    ) -> Result<Self, TrainError> {
        let setup = SessionSetup {
            capture,
            recipe,
            options: &options,
        };
        let (lock, last) = setup.open_folder()?;
        if training_shots(capture).is_empty() {
            return Err(TrainError::NothingToLearn);
        }
        let mut start = setup.start(last.is_some())?;
        if let Some(last) = &last {
            start.gaussians.facing.clone_from(&last.facing);
        }
        let (views, watched) = setup.views(&start)?;
        let topology = Topology::new(&start);
        let perceptual =
            PerceptualLoss::new(&recipe.perceptual, &options.perceptual_weights, recipe.seed)?;
        let check = options.check && last.is_none();
        let checkpoint = last.unwrap_or_else(|| setup.first(&start, &topology, &views));
        setup.expect_same_capture(&checkpoint, &topology, &views)?;
        let batch = recipe.schedule.batch;
        let steps = checkpoint.state.steps;
        options.standing.steps.store(steps, Ordering::SeqCst);
        announce(&TrainingPlan {
            pictures: views.len(),
            view_size: views.size(),
            memory_bytes: memory_bytes(&topology, &checkpoint.rows, views.size(), batch)
                + (perceptual.as_ref())
                    .filter(|loss| loss.suits(gpu, views.size(), batch))
                    .map_or(0, |loss| loss.memory(views.size(), batch)),
            steps,
            check,
        });
        if check {
            // Its memory is free again before the training's is allocated.
            preflight(&PreflightSubject {
                gpu,
                capture,
                recipe,
                start: &start,
                topology: &topology,
                views: &views,
                perceptual: perceptual.as_ref(),
                patience: preflight::PATIENCE,
            })?;
        }
        let (state, rows) = (&checkpoint.state, &checkpoint.rows);
        let loss = perceptual.as_ref();
        let trainer = new_trainer(gpu, &topology, rows, state, views.size(), batch, loss)?;
        for name in [log::LOG, watch::LOG] {
            log::cut(&options.folder, name, steps)?;
        }
        Ok(Self {
            gpu: gpu.clone(),
            capture: capture.clone(),
            recipe: recipe.clone(),
            options,
            start,
            topology,
            rows: checkpoint.rows,
            trainer: Some(trainer),
            ended_at: 0,
            views,
            watched,
            perceptual,
            exposure: checkpoint.exposure,
            refinement: checkpoint.refinement,
            pruned: checkpoint.pruned,
            faced: checkpoint.faced,
            place: checkpoint.place,
            empty_views: Some(0),
            seconds: checkpoint.seconds,
            begun: Instant::now(),
            _lock: lock,
        })
    }

    fn trainer(&self) -> Result<&Trainer, TrainError> {
        self.trainer.as_ref().ok_or(TrainError::Ended)
    }

    fn trainer_mut(&mut self) -> Result<&mut Trainer, TrainError> {
        self.trainer.as_mut().ok_or(TrainError::Ended)
    }

    /// Where it is.
    fn now(&self) -> TrainingTime {
        TrainingTime {
            steps: self.steps(),
            share: self.share(),
            seconds: self.elapsed(),
            pruned: self.pruned,
        }
    }

    /// Steps so far.
    pub fn steps(&self) -> u64 {
        self.trainer.as_ref().map_or(self.ended_at, Trainer::steps)
    }

    /// The avatar as it is now.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn avatar(&self) -> Result<Avatar, TrainError> {
        let mut avatar = self.start.clone();
        let layout = ParameterLayout::new(&self.topology, &self.rows);
        let parameters = self.trainer()?.parameters()?;
        parameters.put_into(&mut avatar, &layout, &self.rows);
        avatar.skeleton = self.skeleton();
        Ok(avatar)
    }

    /// Trains until it is done or `stop` is set. `report` gets the progress, and the training.
    ///
    /// # Errors
    /// When the device, a file or the disk fails, or a loss is not finite. The last checkpoint is
    /// whole, whatever happens.
    pub fn run(
        &mut self,
        stop: &AtomicBool,
        mut report: impl FnMut(&Self, &TrainingProgress),
    ) -> Result<TrainingOutcome, TrainError> {
        self.begun = Instant::now();
        let batch = self.recipe.schedule.batch as u64;
        let views = self.views.clone();
        let first = self.place;
        thread::scope(|scope| {
            // Ahead by a few steps; ends when the receiver is dropped.
            let (send, coming) = sync_channel(4);
            scope.spawn(move || {
                for at in (first..).step_by(batch as usize) {
                    let step: Result<Vec<LoadedView>, CaptureError> = (at..at + batch)
                        .into_par_iter()
                        .map(|place| views.at(place))
                        .collect();
                    let failed = step.is_err();
                    if send.send(step).is_err() || failed {
                        return;
                    }
                }
            });
            let outcome = self.steps_of(&coming, stop, &mut report);
            if let Err(TrainError::Capture(_) | TrainError::File(_)) = &outcome {
                // What was learned since the last checkpoint is right.
                self.save()?;
            }
            outcome
        })
    }

    fn steps_of(
        &mut self,
        coming: &Receiver<Result<Vec<LoadedView>, CaptureError>>,
        stop: &AtomicBool,
        report: &mut impl FnMut(&Self, &TrainingProgress),
    ) -> Result<TrainingOutcome, TrainError> {
        let mut saved = Instant::now();
        let mut sums = ProgressSums::default();
        let first = self.steps();
        loop {
            let share = self.share();
            if share >= 1.0 {
                break;
            }
            if stop.load(Ordering::Relaxed) {
                self.save()?;
                return Ok(TrainingOutcome::Stopped);
            }
            if !self.pruned && share >= self.pruning_share() {
                self.prune()?;
            }
            if self.faced < self.recipe.facing.times_at(share) {
                self.face(share)?;
            }
            let looked = match coming.recv_timeout(STOPS_WITHIN) {
                Ok(looked) => looked?,
                Err(RecvTimeoutError::Timeout) => continue,
                Err(RecvTimeoutError::Disconnected) => return Err(TrainError::LoaderEnded),
            };
            if !self.step(looked, share, stop, &mut sums)? {
                continue;
            }
            let standing = &self.options.standing;
            standing.steps.store(self.steps(), Ordering::SeqCst);
            standing.is_unsaved.store(true, Ordering::SeqCst);
            if self.steps().is_multiple_of(self.options.log_every) || self.steps() == 1 {
                let progress = sums.take(self.now());
                log::add(&self.options.folder, &progress)?;
                report(self, &progress);
            }
            if self.steps() == first + 1 {
                // Drivers compile kernels in the first step, which does not count as training time.
                self.begun = Instant::now();
            }
            if saved.elapsed() >= self.options.checkpoint_every {
                self.save()?;
                if stop.load(Ordering::Relaxed) {
                    return Ok(TrainingOutcome::Stopped);
                }
                self.watch()?;
                saved = Instant::now();
            }
        }
        if !self.pruned {
            self.prune()?;
        }
        self.save()?;
        let avatar = self.avatar()?;
        if self.recipe.rates.pose > 0.0 {
            let clip = self.refinement.clip(&self.capture, &self.options.name);
            clip.write(&self.options.folder.join(POSES))?;
        }
        // The avatar does not depend on the watched views.
        if let Err(error) = self.watch().and_then(|()| self.chart()) {
            tracing::warn!("{error}");
        }
        Ok(TrainingOutcome::Done(Box::new(avatar)))
    }

    /// Draws the watched views: their PSNR goes into a log of its own, and an image of them beside
    /// their pictures.
    fn watch(&mut self) -> Result<(), TrainError> {
        let options = StepOptions {
            weights: self.recipe.loss,
            correctives: self.corrects(self.share()),
            joints: false,
            rates: Rates::NONE,
            adam: self.recipe.rates.adam(),
        };
        let mut seen = Vec::new();
        for number in 0..self.watched.views.len() {
            let looked = self.watched.views.steady(number, [128; 3])?;
            let view = self.refined(looked);
            let image = self
                .trainer_mut()?
                .images(std::slice::from_ref(&view), &options)?
                .remove(0);
            seen.push(WatchedImage { view, image });
        }
        let steps = self.steps();
        self.watched.write(&self.options.folder, steps, &seen)?;
        Ok(())
    }

    /// The chart of both logs.
    fn chart(&self) -> Result<(), TrainError> {
        watch::chart(&self.options.folder)?;
        Ok(())
    }

    /// One step. Returns false where `stop` was set before its end: then nothing is learned.
    fn step(
        &mut self,
        looked: Vec<LoadedView>,
        share: f64,
        stop: &AtomicBool,
        sums: &mut ProgressSums,
    ) -> Result<bool, TrainError> {
        let corrects = self.corrects(share);
        let recipe = &self.recipe;
        let shots: Vec<ShotIndex> = looked.iter().map(|looked| looked.shot).collect();
        let views: Vec<TrainingView> = looked
            .into_iter()
            .map(|looked| self.refined(looked))
            .collect();
        let views = &views[..];
        let before = self.before_pruning(share);
        let refine = recipe.rates.refine_at(share);
        let exposure_rate = recipe.rates.exposure * recipe.rates.end.powf(share);
        let options = StepOptions {
            weights: if self.pruned {
                recipe.loss.without_correctives()
            } else {
                recipe.loss
            },
            correctives: corrects,
            joints: before >= recipe.schedule.refine_share && refine.any(),
            rates: recipe.rates.at(share),
            adam: recipe.rates.adam(),
        };
        let adds_perceptual = before >= recipe.perceptual.from_share
            && self.steps().is_multiple_of(recipe.perceptual.every);
        let step = self.steps() + 1;
        let trainer = self.trainer.as_mut().ok_or(TrainError::Ended)?;
        let found = match &self.perceptual {
            Some(perceptual) if adds_perceptual => {
                let found = perceptual.step(trainer, views, &options, self.place, stop)?;
                let Some(found) = found else {
                    return Ok(false);
                };
                sums.perceptual = Some(found.value);
                found.losses
            }
            _ => trainer.step(views, &options)?,
        };
        self.count_empty_views(found.empty_views as usize, &shots)?;
        if !found.l1.is_finite() {
            return Err(TrainError::NotFinite {
                step,
                loss: found.l1,
            });
        }
        if exposure_rate > 0.0 {
            for (number, shot) in shots.iter().enumerate() {
                let gradient = self.trainer_mut()?.gain_gradient(number);
                self.exposure
                    .learn(shot.camera, gradient, exposure_rate, &options.adam);
            }
            self.exposure.center();
        }
        if options.joints {
            self.refine(&shots, refine, &options.adam)?;
        }
        sums.add(&found);
        self.place += shots.len() as u64;
        Ok(true)
    }

    /// Counts views in which no Gaussian was visible, until there was one; too many are an error.
    fn count_empty_views(&mut self, empty: usize, shots: &[ShotIndex]) -> Result<(), TrainError> {
        self.empty_views = match self.empty_views {
            Some(before) if empty == shots.len() => Some(before + empty as u64),
            _ => None,
        };
        if self
            .empty_views
            .is_some_and(|empty| empty > MAX_EMPTY_VIEWS)
        {
            return Err(TrainError::NothingSeen {
                camera: self.capture.cameras[shots[0].camera].name.clone(),
                frame: self.capture.frames[shots[0].frame].number,
            });
        }
        Ok(())
    }

    /// A view with the refined pose, camera and bones.
    fn refined(&self, looked: LoadedView) -> TrainingView {
        let LoadedView { view, shot } = looked;
        let mut view = TrainingView {
            gain: self.exposure.gain(shot.camera),
            ..view
        };
        let rates = &self.recipe.rates;
        if rates.pose > 0.0 || rates.bone > 0.0 {
            let pose = self.pose(shot.frame);
            view.joints = self.skeleton().matrices(&pose);
            view.input = self.start.inputs.unprojected(&pose);
        }
        if self.recipe.rates.camera > 0.0 {
            view.camera = self.refinement.camera(shot.camera, &view.camera);
        }
        view
    }

    /// The person's refined skeleton.
    fn skeleton(&self) -> Skeleton {
        self.refinement.skeleton(&self.start.skeleton)
    }

    /// The refined pose of a frame.
    fn pose(&self, frame: usize) -> Pose {
        self.refinement
            .pose(frame, &self.capture.frames[frame].pose)
    }

    /// Poses, cameras and bones learn from the views of the last step, each once: frames and cameras
    /// that several views share from the sum.
    fn refine(
        &mut self,
        shots: &[ShotIndex],
        rates: RefineRates,
        adam: &Adam,
    ) -> Result<(), TrainError> {
        let skeleton = &self.skeleton();
        let mut poses: BTreeMap<usize, PoseGradient> = BTreeMap::new();
        let mut cameras: BTreeMap<usize, CameraGradient> = BTreeMap::new();
        for (number, shot) in shots.iter().enumerate() {
            let pose = self.pose(shot.frame);
            let own =
                skeleton.matrices_backward(&pose, &self.trainer_mut()?.joints_gradient(number));
            let given = &self.capture.cameras[shot.camera].camera;
            let seen = SeenFrom {
                skeleton,
                pose: &pose,
                gradient: &own,
            };
            let of_camera = self.refinement.camera_gradient(shot.camera, given, seen);
            cameras.entry(shot.camera).or_default().add(&of_camera);
            match poses.entry(shot.frame) {
                Entry::Occupied(mut sum) => sum.get_mut().add(&own),
                Entry::Vacant(place) => {
                    place.insert(own);
                }
            }
        }
        if rates.camera > 0.0 {
            for (camera, gradient) in &cameras {
                self.refinement
                    .learn_camera(*camera, gradient, rates.camera, adam);
            }
            let given: Vec<&Camera> = self.capture.cameras.iter().map(|own| &own.camera).collect();
            self.refinement.center(&given);
        }
        if rates.bone > 0.0
            && let Some(sum) = poses.values().cloned().reduce(|mut sum, own| {
                sum.add(&own);
                sum
            })
        {
            self.refinement.learn_bones(&sum, rates.bone, adam);
        }
        if rates.pose > 0.0 {
            for (frame, gradient) in &poses {
                self.refinement
                    .learn_pose(*frame, gradient, rates.pose, adam);
            }
        }
        Ok(())
    }

    /// Refined poses of frames that are not held out.
    fn poses(&self) -> Vec<Pose> {
        let own = self.capture.frames.iter().enumerate();
        own.filter(|(_, frame)| !frame.held)
            .map(|(at, _)| self.pose(at))
            .collect()
    }

    /// Mean and largest angle of joints to the capture's, radians. None where poses did not learn.
    pub fn turned_joints(&self) -> Option<[f64; 2]> {
        self.refinement.turned_from(&self.capture)
    }

    /// Mean and largest distance of joints, in their parents, to the body model's, metres. None where
    /// bones did not learn.
    pub fn moved_bones(&self) -> Option<[f64; 2]> {
        self.refinement.bones_moved()
    }

    /// Whether correctives learn at a share of the training.
    fn corrects(&self, share: f64) -> bool {
        self.pruned || self.before_pruning(share) >= self.recipe.schedule.neutral_share
    }

    /// The share of the steps before pruning at a share of the training.
    fn before_pruning(&self, share: f64) -> f64 {
        share / self.pruning_share().max(1e-9)
    }

    /// The share of the training that is over, 0 to 1.
    fn share(&self) -> f64 {
        match self.options.minutes {
            Some(minutes) => self.elapsed() / (60.0 * minutes),
            None => self.steps() as f64 / self.recipe.steps() as f64,
        }
    }

    /// The share of the training at which rows are pruned.
    fn pruning_share(&self) -> f64 {
        self.recipe.schedule.iterations as f64 / self.recipe.steps() as f64
    }

    /// Seconds that it has taken.
    fn elapsed(&self) -> f64 {
        self.seconds + self.begun.elapsed().as_secs_f64()
    }

    /// Removes the basis rows that are worth least, and their moments.
    fn prune(&mut self) -> Result<(), TrainError> {
        let state = self.save()?;
        let layout = ParameterLayout::new(&self.topology, &self.rows);
        let sensitivity = match self.recipe.prune.by {
            PruneBy::Variance => Sensitivity::new(0),
            PruneBy::Pictures => self.sensitivity()?,
        };
        let avatar = self.avatar()?;
        let features: Vec<Vec<f64>> = self
            .poses()
            .par_iter()
            .map(|pose| {
                let posed = Posed::with_projection(&avatar, pose, false);
                mlp::features(&avatar, &posed.input)
            })
            .collect();
        let width = avatar.networks.output();
        let covariance = feature_covariance(&features, layout.parts, width);
        let pruning = Pruning {
            parameters: &state.parameters,
            topology: &self.topology,
            layout: &layout,
            rows: &self.rows,
            covariance: &covariance,
        };
        let share = self.recipe.prune.share;
        let kept = match self.recipe.prune.by {
            PruneBy::Variance => pruning.by_variance(share),
            PruneBy::Pictures => pruning.by_pictures(share, &sensitivity),
        };
        let keep = |numbers| keep_rows(numbers, &layout, &self.rows, &kept);
        let state = TrainerState {
            parameters: keep(&state.parameters),
            first_moments: keep(&state.first_moments),
            second_moments: keep(&state.second_moments),
            ..state
        };
        // Its memory is free before that of its successor is allocated. If that fails, the training
        // resumes from the checkpoint.
        self.ended_at = self.steps();
        self.trainer = None;
        let (size, batch) = (self.views.size(), self.recipe.schedule.batch);
        let (gpu, loss) = (&self.gpu, self.perceptual.as_ref());
        let trainer = new_trainer(gpu, &self.topology, &kept, &state, size, batch, loss)?;
        self.trainer = Some(trainer);
        self.rows = kept;
        self.pruned = true;
        Ok(())
    }

    /// Finds from where Gaussians show, and draws them from there alone from now on.
    fn face(&mut self, share: f64) -> Result<(), TrainError> {
        tracing::info!("finding from where Gaussians show");
        let mut avatar = self.avatar()?;
        let shown = self.recipe.facing.shown / 255.0;
        face(&mut avatar, &self.poses(), shown, &mut |_, _| ());
        self.start.gaussians.facing = avatar.gaussians.facing;
        self.topology = Topology::new(&self.start);
        let trainer = self.trainer.as_mut().ok_or(TrainError::Ended)?;
        trainer.face(&self.topology)?;
        self.faced = self.recipe.facing.times_at(share);
        Ok(())
    }

    /// How much pictures depend on each Gaussian's attributes, over some evenly spaced pictures.
    fn sensitivity(&mut self) -> Result<Sensitivity, TrainError> {
        let count = self.recipe.prune.pictures.min(self.views.len());
        let mut found = Sensitivity::new(self.topology.gaussians.len());
        for k in 0..count {
            let number = (2 * k + 1) * self.views.len() / (2 * count);
            let looked = self.views.steady(number, [128; 3])?;
            let view = self.refined(looked);
            let trainer = self.trainer_mut()?;
            trainer.look(&[view], &StepOptions::LOOK)?;
            found.add(&trainer.attribute_gradients()?);
        }
        Ok(found)
    }

    /// Writes a checkpoint, and returns the trainer's state in it.
    fn save(&self) -> Result<TrainerState, TrainError> {
        let state = self.trainer()?.state()?;
        let all = [
            &state.parameters,
            &state.first_moments,
            &state.second_moments,
        ];
        let count = all
            .iter()
            .flat_map(|numbers| numbers.arrays())
            .map(|array| array.iter().filter(|v| !v.is_finite()).count())
            .sum::<usize>();
        let on_host = self.refinement.numbers().chain(self.exposure.numbers());
        let count = count + on_host.filter(|v| !v.is_finite()).count();
        if count > 0 {
            return Err(TrainError::Spoiled {
                step: self.steps(),
                count,
            });
        }
        let checkpoint = TrainingCheckpoint {
            state,
            rows: self.rows.clone(),
            pruned: self.pruned,
            facing: self.start.gaussians.facing.clone(),
            faced: self.faced,
            place: self.place,
            exposure: self.exposure.clone(),
            refinement: self.refinement.clone(),
            seconds: self.elapsed(),
            data: self.views.name(),
            minutes: self.options.minutes,
            recipe: self.recipe.text(),
        };
        checkpoint.write(&self.options.folder)?;
        let is_unsaved = &self.options.standing.is_unsaved;
        is_unsaved.store(false, Ordering::SeqCst);
        Ok(checkpoint.state)
    }
}

/// A trainer that works out the perceptual loss too, where its device should.
fn new_trainer(
    gpu: &Arc<Gpu>,
    topology: &Topology,
    rows: &CorrectiveRows,
    state: &TrainerState,
    size: [u32; 2],
    batch: usize,
    perceptual: Option<&PerceptualLoss>,
) -> Result<Trainer, TrainError> {
    let mut trainer = Trainer::new(gpu, topology, rows, state, size, batch)?;
    if let Some(loss) = perceptual.filter(|loss| loss.suits(gpu, size, batch)) {
        loss.hand_over(&mut trainer, size)?;
    }
    Ok(trainer)
}

/// What a session is set up from.
struct SessionSetup<'a> {
    capture: &'a Arc<Capture>,
    recipe: &'a Recipe,
    options: &'a SessionOptions,
}

impl SessionSetup<'_> {
    fn folder_name(&self) -> String {
        self.options.folder.display().to_string()
    }

    /// Locks the training's folder and reads its last checkpoint. Later ones, which are broken, are
    /// set aside.
    fn open_folder(&self) -> Result<(Lock, Option<TrainingCheckpoint>), TrainError> {
        let folder = &self.options.folder;
        let unwritable = |file: &Path, cause| FileError::Write {
            file: file.into(),
            cause,
        };
        fs::create_dir_all(folder).map_err(|cause| unwritable(folder, cause))?;
        let lock = Lock::take(folder)?;
        if let Ok(file) = lock.file() {
            self.options.standing.lock.get_or_init(|| file);
        }
        let found = TrainingCheckpoint::last(folder).map_err(|cause| FileError::Read {
            file: folder.clone(),
            cause,
        })?;
        remove_parts(folder).map_err(|cause| unwritable(folder, cause))?;
        for broken in &found.broken {
            tracing::warn!("{}: {}", broken.path.display(), broken.error);
            if found.checkpoint.is_none() {
                return Err(TrainError::Broken {
                    file: broken.path.display().to_string(),
                    fault: broken.error.clone(),
                });
            }
            broken
                .set_aside()
                .map_err(|cause| unwritable(&broken.path, cause))?;
        }
        if let Some(checkpoint) = &found.checkpoint {
            self.expect_resumable(checkpoint)?;
        }
        Ok((lock, found.checkpoint))
    }

    /// Checks that a checkpoint may be resumed, and with the same recipe.
    fn expect_resumable(&self, checkpoint: &TrainingCheckpoint) -> Result<(), TrainError> {
        if !self.options.resume {
            return Err(TrainError::Begun {
                folder: self.folder_name(),
                steps: checkpoint.state.steps,
            });
        }
        let other_time = checkpoint.minutes != self.options.minutes;
        if other_time || Recipe::parse(&checkpoint.recipe).as_ref() != Ok(self.recipe) {
            return Err(TrainError::OtherRecipe {
                folder: self.folder_name(),
            });
        }
        Ok(())
    }

    /// The avatar that the training begins with: the folder's, where it resumes one.
    fn start(&self, resumes: bool) -> Result<Avatar, TrainError> {
        let file = self.options.folder.join(START);
        if resumes && file.exists() {
            let avatar = Avatar::read(&file)?;
            self.expect_same_skeleton(&avatar)?;
            return Ok(avatar);
        }
        let recipe = self.recipe;
        let poses = training_poses(self.capture);
        let mut avatar = start(
            &self.capture.template,
            &poses,
            &recipe.sizes,
            recipe.filter,
            recipe.seed,
        );
        avatar.name.clone_from(&self.options.name);
        avatar.credit.clone_from(&self.options.credit);
        avatar.write(&file)?;
        replace(&self.options.folder.join(RECIPE), recipe.text().as_bytes())?;
        // As the file holds it, so that a resumed training has the same numbers.
        Ok(Avatar::read(&file)?)
    }

    /// The views that are learned from, and those that are watched.
    fn views(&self, start: &Avatar) -> Result<(Arc<TrainingViews>, WatchedViews), TrainError> {
        let Recipe { data, seed, .. } = self.recipe;
        let of_shots =
            |shots, size| TrainingViews::new(self.capture, start, shots, data, *seed, size);
        let views = of_shots(distinct_shots(self.capture, start, data.duplicate), None);
        if views.size().iter().any(|&side| side < LEAST_SIDE) {
            return Err(TrainError::SmallViews { size: views.size() });
        }
        if start.inputs.len() > TRAIN_WIDTH_MAX as usize {
            return Err(TrainError::Inputs {
                found: start.inputs.len(),
            });
        }
        let watched = watched_shots(self.capture, views.size());
        let watched = WatchedViews::new(of_shots(watched, Some(views.size())));
        Ok((Arc::new(views), watched))
    }

    /// The state before the first step.
    fn first(
        &self,
        start: &Avatar,
        topology: &Topology,
        views: &TrainingViews,
    ) -> TrainingCheckpoint {
        let rows = CorrectiveRows::all(start.gaussians.len());
        let layout = ParameterLayout::new(topology, &rows);
        TrainingCheckpoint {
            state: TrainerState::new(&layout, Parameters::of(start, &layout)),
            rows,
            pruned: false,
            facing: vec![],
            faced: 0,
            place: 0,
            exposure: Exposure::new(self.capture.cameras.len()),
            refinement: Refinement::new(self.capture),
            seconds: 0.0,
            data: views.name(),
            minutes: self.options.minutes,
            recipe: self.recipe.text(),
        }
    }

    /// Checks that an avatar has the capture's skeleton.
    fn expect_same_skeleton(&self, avatar: &Avatar) -> Result<(), TrainError> {
        let own = &avatar.skeleton;
        let expected = &self.capture.template.skeleton;
        if own == expected {
            return Ok(());
        }
        Err(TrainError::OtherCapture {
            folder: self.folder_name(),
            found: format!("{} joints", own.len()),
            expected: format!("{} joints, or the same at other places", expected.len()),
        })
    }

    /// Checks that a checkpoint has the numbers of this avatar and capture.
    fn expect_same_capture(
        &self,
        checkpoint: &TrainingCheckpoint,
        topology: &Topology,
        views: &TrainingViews,
    ) -> Result<(), TrainError> {
        let expected = ParameterLayout::new(topology, &checkpoint.rows).lengths();
        let numbers = checkpoint.state.parameters.arrays().map(<[f32]>::len);
        let faced = checkpoint.facing.len();
        let fits = numbers == expected
            && (faced == 0 || faced == topology.gaussians.len())
            && checkpoint.data == views.name()
            && checkpoint.exposure.cameras() == self.capture.cameras.len()
            && checkpoint.refinement.fits(&Refinement::new(self.capture));
        if fits {
            return Ok(());
        }
        let gaussians = topology.gaussians.len();
        Err(TrainError::OtherCapture {
            folder: self.folder_name(),
            found: format!("{gaussians} Gaussians, and {}", checkpoint.data),
            expected: views.name(),
        })
    }
}

/// Runs the preflight check and logs its warnings. Faults are an error.
fn preflight(subject: &PreflightSubject) -> Result<(), TrainError> {
    let began = Instant::now();
    let found = preflight::check(subject)?;
    tracing::info!("checked in {:.1} s", began.elapsed().as_secs_f64());
    for warning in &found.warnings {
        tracing::warn!("{warning}");
    }
    if found.faults.is_empty() {
        return Ok(());
    }
    Err(TrainError::Idle {
        faults: found.faults,
    })
}

/// The poses of frames that are not held out.
fn training_poses(capture: &Capture) -> Vec<Pose> {
    let own = capture.frames.iter().filter(|frame| !frame.held);
    own.map(|frame| frame.pose.clone()).collect()
}
