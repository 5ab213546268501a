//! Checks before a long training that every input moves some pixel and some derivative.
//!
//! The trainer itself takes steps on views of the training, with an avatar in which every path is
//! alive: a quarter opaque, coloured at random, with bases that are not small. Nothing of it is
//! kept, and the training's random numbers stay unused.

use crate::adam::Adam;
use crate::data::TrainingViews;
use crate::gpu::{StepOptions, Trainer, TrainerState};
use crate::parameters::{GAUSSIAN, ParameterLayout, Parameters, logit};
use crate::perceptual::PerceptualLoss;
use crate::recipe::Recipe;
use crate::topology::{CorrectiveRows, Topology};
use crate::view::TrainingView;
use effigy_capture::{Capture, CaptureError, Template};
use effigy_core::avatar::{Avatar, Pose};
use effigy_core::random::Random;
use effigy_render::vulkan::{Error as GpuError, Gpu};
use glam::{DQuat, DVec2, DVec3};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Trainings from this many steps or minutes on are long.
const LONG_STEPS: u64 = 5000;
const LONG_MINUTES: f64 = 10.0;

/// Views that derivatives are taken in, at least.
const VIEWS: u64 = 4;
/// Views that are looked for what was in none before, at most.
const MOST_VIEWS: u64 = 24;
/// Views that show what an input moves, without a pixel that it moves: so many prove a fault.
const TRIES: usize = 3;
/// Runs are bit-reproducible. Differences below this are ignored.
const MIN_DIFFERENCE: f32 = 1e-6;

/// What a check may take after its first derivative: on a CPU driver a view of the paper's sizes
/// takes half a minute.
pub const PATIENCE: Duration = Duration::from_secs(30);

/// How far a joint turns, degrees, and about what: no bone's axis.
const TURN: f64 = 20.0;
const AXIS: DVec3 = DVec3::new(0.48, 0.64, 0.6);
/// How much is added to an input.
const NUDGE: f64 = 0.5;
/// Opacity of every Gaussian: what is behind others is seen through them.
const OPACITY: f64 = 0.25;
/// Bases are within ± these: of nodes, metres, and of rotation, scale and colour.
const NODE_BASIS: f64 = 0.01;
const BASIS: f64 = 0.05;
/// An input that varies by less over all frames does not.
const STILL: f64 = 1e-6;
/// Streams of random numbers.
const AVATAR_STREAM: u64 = 3 << 32;
const INPUT_STREAM: u64 = 4 << 32;

/// The derivative is what a step leaves in the first moment; no number changes. The picture's loss
/// alone counts: others have derivatives where no pixel has.
const OPTIONS: StepOptions = StepOptions {
    adam: Adam {
        beta_1: 0.0,
        weight_decay: 0.0,
        ..Adam::DEFAULT
    },
    ..StepOptions::LOOK
};

/// Whether a training is so long that the check costs little of it.
pub fn is_due(recipe: &Recipe, minutes: Option<f64>) -> bool {
    match minutes {
        Some(minutes) => minutes >= LONG_MINUTES,
        None => recipe.steps() > LONG_STEPS,
    }
}

/// The inputs of a check.
pub struct PreflightSubject<'a> {
    /// The device.
    pub gpu: &'a Arc<Gpu>,
    /// The capture.
    pub capture: &'a Capture,
    /// The recipe.
    pub recipe: &'a Recipe,
    /// The avatar that the training begins with.
    pub start: &'a Avatar,
    /// What training leaves of it as it is.
    pub topology: &'a Topology,
    /// What is learned from.
    pub views: &'a TrainingViews,
    /// The loss that sees pictures as people do.
    pub perceptual: Option<&'a PerceptualLoss>,
    /// Time limit after the first derivative. Inputs not tested by then are a warning.
    pub patience: Duration,
}

/// The findings of a check, each a sentence.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Findings {
    /// Facts of the capture that limit what can be learned from it.
    pub warnings: Vec<String>,
    /// Inputs that should move something and do not: training would be useless.
    pub faults: Vec<String>,
}

/// Why a check failed to run.
#[derive(Debug, thiserror::Error)]
pub enum PreflightError {
    /// The device.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The capture.
    #[error(transparent)]
    Capture(#[from] CaptureError),
}

/// Looks at a capture and a recipe before a training of them.
///
/// # Errors
/// When the device fails, or no picture can be read.
pub fn check(subject: &PreflightSubject) -> Result<Findings, PreflightError> {
    let mut findings = Findings {
        warnings: of_capture(subject),
        faults: Vec::new(),
    };
    let rows = CorrectiveRows::all(subject.topology.gaussians.len());
    let layout = ParameterLayout::new(subject.topology, &rows);
    let state = TrainerState::new(&layout, alive(subject, &layout));
    let mut look = PreflightRun {
        trainer: Trainer::new(
            subject.gpu,
            subject.topology,
            &rows,
            &state,
            subject.views.size(),
            1,
        )?,
        trials: trials(subject),
        kinds: Vec::new(),
        inputs: vec![0.0; subject.topology.widths[0]],
        gain: [0.0; 3],
        perceptual: None,
        began: None,
        broke_off: false,
        layout,
        subject,
    };
    for place in 0..MOST_VIEWS {
        let is_enough =
            look.trials.iter().all(PerturbationTrial::is_over) && look.sees_all_inputs();
        if place >= VIEWS && is_enough || look.broke_off {
            break;
        }
        look.at(place)?;
    }
    look.judge(&mut findings);
    Ok(findings)
}

/// The start's avatar with every path alive. Its networks are random as they are.
fn alive(subject: &PreflightSubject, layout: &ParameterLayout) -> Parameters<f32> {
    let mut all = Parameters::of(subject.start, layout);
    let mut random = Random::new(subject.recipe.seed, AVATAR_STREAM);
    for numbers in all.gaussians.chunks_exact_mut(GAUSSIAN) {
        numbers[7] = logit(OPACITY) as f32;
        for channel in &mut numbers[8..11] {
            *channel = random.range(0.1, 0.9) as f32;
        }
    }
    for number in &mut all.nodes[layout.node_bases..] {
        *number = random.range(-NODE_BASIS, NODE_BASIS) as f32;
    }
    for number in &mut all.bases {
        *number = random.range(-BASIS, BASIS) as f32;
    }
    all
}

/// A change of a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Perturbation {
    /// A joint turns.
    Turn(usize),
    /// An input of the networks grows.
    Input(usize),
}

/// A change, and whether it moves a pixel.
struct PerturbationTrial {
    change: Perturbation,
    name: String,
    /// The Gaussians that it moves.
    moves: Vec<u32>,
    /// Views that show them without a pixel that it moved.
    tries: usize,
    moved: bool,
}

impl PerturbationTrial {
    fn is_over(&self) -> bool {
        self.moved || self.tries >= TRIES
    }
}

/// Every joint that Gaussians follow, and every input that reaches a network.
fn trials(subject: &PreflightSubject) -> Vec<PerturbationTrial> {
    let topology = subject.topology;
    let trial = |change, name, moves| PerturbationTrial {
        change,
        name,
        moves,
        tries: 0,
        moved: false,
    };
    let joints = topology
        .moved()
        .into_iter()
        .enumerate()
        .map(|(joint, moved)| {
            let mut moves: Vec<u32> = moved.iter().map(|follower| follower.gaussian).collect();
            moves.dedup();
            let name = joint_name(&subject.capture.template, joint);
            trial(Perturbation::Turn(joint), format!("joint {name}"), moves)
        });
    let of_head = topology.part_start[topology.head_parts];
    let inputs = (0..topology.widths[0]).map(|input| {
        let reached = if input < topology.expression_start {
            topology.gaussians.len() as u32
        } else {
            of_head
        };
        let name = input_name(subject, input);
        trial(Perturbation::Input(input), name, (0..reached).collect())
    });
    let all = joints.chain(inputs);
    all.filter(|trial| !trial.moves.is_empty()).collect()
}

fn joint_name(template: &Template, joint: usize) -> String {
    format!("`{}`", template.skeleton.name[joint])
}

fn input_name(subject: &PreflightSubject, input: usize) -> String {
    let inputs = &subject.start.inputs;
    match inputs.joint.get(input / 3) {
        Some(&joint) => format!(
            "input {} of {}",
            ["x", "y", "z"][input % 3],
            joint_name(&subject.capture.template, usize::from(joint))
        ),
        None => format!("expression {}", input - 3 * inputs.joint.len()),
    }
}

/// A check in progress.
struct PreflightRun<'a> {
    subject: &'a PreflightSubject<'a>,
    layout: ParameterLayout,
    trainer: Trainer,
    trials: Vec<PerturbationTrial>,
    /// Of every kind of number that is learned, the largest derivative; NaN where one is not finite.
    kinds: Vec<(String, f64)>,
    /// Of the weights that each input has in the first layer, likewise.
    inputs: Vec<f64>,
    /// Of the cameras' gains, RGB, likewise.
    gain: [f64; 3],
    /// The perceptual loss of an image, and of another.
    perceptual: Option<PerceptualAnswer>,
    /// When the first derivative was there: kernels were compiled for it.
    began: Option<Instant>,
    /// The time limit was exceeded.
    broke_off: bool,
}

/// The perceptual loss of an image.
#[derive(Clone, Copy, Debug, PartialEq)]
struct PerceptualAnswer {
    value: f64,
    /// Of another image.
    other: f64,
    /// Largest derivative.
    slope: f64,
}

impl PreflightRun<'_> {
    /// Whether the time limit is over, after a view or an image of one.
    fn is_late(&mut self) -> bool {
        let began = *self.began.get_or_insert_with(Instant::now);
        self.broke_off |= began.elapsed() >= self.subject.patience;
        self.broke_off
    }

    /// Tests the view at a place of the training.
    fn at(&mut self, place: u64) -> Result<(), PreflightError> {
        let looked = self.subject.views.at(place)?;
        let view = &looked.view;
        self.derive(view, place)?;
        let shown = shown(self.subject.topology, view);
        let pose = &self.subject.capture.frames[looked.shot.frame].pose;
        let due: Vec<usize> = (0..self.trials.len())
            .filter(|&number| {
                let trial = &self.trials[number];
                !trial.is_over() && trial.moves.iter().any(|&k| shown[k as usize])
            })
            .collect();
        let image = self.image(view)?;
        for number in due {
            if self.is_late() {
                return Ok(());
            }
            let changed = self.changed(view, pose, self.trials[number].change);
            let other = self.image(&changed)?;
            let trial = &mut self.trials[number];
            trial.moved = differs(&image, &other);
            trial.tries += usize::from(!trial.moved);
        }
        if let (Some(perceptual), None) = (self.subject.perceptual, self.perceptual) {
            self.perceptual = answer(perceptual, view, place, &image);
        }
        Ok(())
    }

    /// Takes the derivative of a view's loss, away from 0 in all inputs: what is 0 gives weights no
    /// derivative.
    fn derive(&mut self, view: &TrainingView, place: u64) -> Result<(), PreflightError> {
        let mut random = Random::new(self.subject.recipe.seed ^ place, INPUT_STREAM);
        let mut nudged = view.clone();
        for input in &mut nudged.input {
            *input += NUDGE * if random.uniform() < 0.5 { -1.0 } else { 1.0 };
        }
        self.trainer.step(&[nudged], &OPTIONS)?;
        let slopes = self.trainer.state()?.first_moments;
        let found = kinds(&slopes, &self.layout);
        if self.kinds.is_empty() {
            self.kinds = found;
        } else {
            for ((_, known), (_, new)) in self.kinds.iter_mut().zip(found) {
                *known = larger(*known, new);
            }
        }
        for (input, known) in self.inputs.iter_mut().enumerate() {
            *known = larger(*known, of_input(&slopes, &self.layout, input));
        }
        for (known, new) in self.gain.iter_mut().zip(self.trainer.gain_gradient(0)) {
            *known = larger(*known, new);
        }
        Ok(())
    }

    fn image(&mut self, view: &TrainingView) -> Result<Vec<[f32; 3]>, GpuError> {
        let mut images = self.trainer.images(std::slice::from_ref(view), &OPTIONS)?;
        Ok(images.swap_remove(0))
    }

    /// A view with a change. A joint that turns leaves the networks what they see.
    fn changed(&self, view: &TrainingView, pose: &Pose, change: Perturbation) -> TrainingView {
        let mut changed = view.clone();
        match change {
            Perturbation::Turn(joint) => {
                let mut turned = pose.clone();
                let joints = self.subject.topology.joints;
                turned.rotation.resize(joints, DVec3::ZERO);
                let own = DQuat::from_scaled_axis(turned.rotation[joint]);
                let further = DQuat::from_axis_angle(AXIS, TURN.to_radians());
                turned.rotation[joint] = (own * further).to_scaled_axis();
                changed.joints = self.subject.start.skeleton.matrices(&turned);
            }
            Perturbation::Input(input) => changed.input[input] += NUDGE,
        }
        changed
    }

    /// Whether every input that can have a derivative has one.
    fn sees_all_inputs(&self) -> bool {
        let mut all = self.inputs.iter().enumerate();
        all.all(|(input, &slope)| slope != 0.0 || !self.is_shown(input))
    }

    /// Whether an input's Gaussians were in a view.
    fn is_shown(&self, input: usize) -> bool {
        let wanted = Perturbation::Input(input);
        let mut trials = self.trials.iter();
        trials.any(|trial| trial.change == wanted && (trial.moved || trial.tries > 0))
    }

    /// Turns the results into sentences.
    fn judge(self, findings: &mut Findings) {
        let unseen: Vec<&str> = self
            .trials
            .iter()
            .filter(|trial| {
                !trial.moved && (trial.tries == 0 || self.broke_off && !trial.is_over())
            })
            .map(|trial| trial.name.as_str())
            .collect();
        let broke_off = self.broke_off;
        if !unseen.is_empty() {
            let what = if broke_off {
                let seconds = self.subject.patience.as_secs_f64();
                format!("in {seconds:.0} s there was no look at these, or too few")
            } else {
                format!(
                    "none of {MOST_VIEWS} views shows what these move, and little can be learned of it"
                )
            };
            findings
                .warnings
                .push(format!("{what}: {}", unseen.join(", ")));
        }
        for trial in self.trials.iter().filter(|trial| !trial.moved) {
            let how = match trial.change {
                Perturbation::Turn(_) => format!("turned by {TURN}°"),
                Perturbation::Input(_) => format!("{NUDGE} larger"),
            };
            // Few tries prove nothing.
            if trial.tries > 0 && (!broke_off || trial.is_over()) {
                findings.faults.push(format!(
                    "{}, {how}, moved no pixel of {} views that show its Gaussians, expected some",
                    trial.name, trial.tries
                ));
            }
        }
        let inputs = (0..self.inputs.len()).filter(|&input| self.is_shown(input));
        let of_inputs = inputs.map(|input| {
            let name = input_name(self.subject, input);
            (
                format!("the first layer's weights of {name}"),
                self.inputs[input],
            )
        });
        let mut slopes: Vec<(String, f64)> = self.kinds.iter().cloned().chain(of_inputs).collect();
        if self.subject.recipe.rates.exposure > 0.0 {
            let channels = ["red", "green", "blue"].into_iter().zip(self.gain);
            slopes.extend(
                channels.map(|(name, slope)| (format!("the cameras' gain of {name}"), slope)),
            );
        }
        if broke_off {
            // One that is 0 may be of what no view has shown yet.
            let (flat, rest): (Vec<_>, Vec<_>) =
                slopes.into_iter().partition(|(_, slope)| *slope == 0.0);
            slopes = rest;
            if !flat.is_empty() {
                let names: Vec<String> = flat.into_iter().map(|(name, _)| name).collect();
                findings.warnings.push(format!(
                    "no derivative was found by then of {}",
                    names.join(", ")
                ));
            }
        }
        findings.faults.extend(of_slopes(&slopes));
        findings.faults.extend(self.perceptual.and_then(of_answer));
    }
}

/// Faults of derivatives.
fn of_slopes(slopes: &[(String, f64)]) -> Vec<String> {
    let bad = slopes
        .iter()
        .filter(|(_, slope)| slope.is_nan() || *slope == 0.0);
    bad.map(|(name, slope)| {
        format!("the derivative of {name} is {slope}, expected some number other than 0")
    })
    .collect()
}

/// The fault of a perceptual loss.
fn of_answer(answer: PerceptualAnswer) -> Option<String> {
    let PerceptualAnswer {
        value,
        other,
        slope,
    } = answer;
    let is_alive = value.is_finite() && other.is_finite() && value != other && slope > 0.0;
    (!is_alive).then(|| {
        format!(
            "the perceptual loss is {value} of an image, {other} of another one, with a derivative of at \
             most {slope}; expected two numbers, and a derivative"
        )
    })
}

/// Evaluates the perceptual loss of an image, and of a darker one.
fn answer(
    perceptual: &PerceptualLoss,
    view: &TrainingView,
    place: u64,
    image: &[[f32; 3]],
) -> Option<PerceptualAnswer> {
    let found = perceptual.compare(view, place, image)?;
    let darker: Vec<[f32; 3]> = image.iter().map(|pixel| pixel.map(|v| 0.8 * v)).collect();
    Some(PerceptualAnswer {
        value: found.value,
        other: perceptual.compare(view, place, &darker)?.value,
        slope: peak(found.gradient.as_flattened()),
    })
}

/// Which Gaussians a view shows, whatever is before them.
fn shown(topology: &Topology, view: &TrainingView) -> Vec<bool> {
    let size = DVec2::from(view.camera.size.map(f64::from));
    let is_shown = |placed: &crate::topology::PlacedGaussian| {
        let moved = placed.joint.iter().zip(placed.joint_weight);
        let at: DVec3 = moved
            .map(|(&joint, weight)| {
                let joint = &view.joints[usize::from(joint)];
                f64::from(weight) / 255.0 * joint.transform_point3(placed.position)
            })
            .sum();
        let seen = view.camera.view.transform_point3(at);
        if seen.z < view.camera.near {
            return false;
        }
        let pixel = view.camera.project(seen);
        pixel.cmpge(DVec2::ZERO).all() && pixel.cmplt(size).all()
    };
    topology.gaussians.par_iter().map(is_shown).collect()
}

/// Whether any channel of any pixel differs. NaN does not count as a difference.
fn differs(a: &[[f32; 3]], b: &[[f32; 3]]) -> bool {
    let pairs = a.as_flattened().iter().zip(b.as_flattened());
    let mut pairs = pairs.into_iter();
    pairs.any(|(a, b)| (a - b).abs() > MIN_DIFFERENCE)
}

/// The larger of two sizes; NaN where one is.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || !b.is_finite() {
        f64::NAN
    } else {
        a.max(b.abs())
    }
}

/// The largest size of some numbers; NaN where one is not finite.
fn peak<'a>(numbers: impl IntoIterator<Item = &'a f32>) -> f64 {
    let numbers = numbers.into_iter();
    numbers.fold(0.0, |most, &v| larger(most, f64::from(v)))
}

/// The largest derivative of each kind of number.
fn kinds(slopes: &Parameters<f32>, layout: &ParameterLayout) -> Vec<(String, f64)> {
    let of_gaussians = |range: Range<usize>| {
        let all = slopes.gaussians.chunks_exact(GAUSSIAN);
        peak(all.flat_map(|numbers| &numbers[range.clone()]))
    };
    let basis = |k: usize| peak(&slopes.bases[layout.bases[k]..layout.bases[k + 1]]);
    let mut all = vec![
        ("rotations".to_owned(), of_gaussians(0..4)),
        ("log scales".to_owned(), of_gaussians(4..7)),
        ("opacities".to_owned(), of_gaussians(7..8)),
        ("colours".to_owned(), of_gaussians(8..11)),
        (
            "nodes' offsets".to_owned(),
            peak(&slopes.nodes[..3 * layout.nodes]),
        ),
        (
            "nodes' bases".to_owned(),
            peak(&slopes.nodes[layout.node_bases..]),
        ),
        ("bases of rotation".to_owned(), basis(0)),
        ("bases of scale".to_owned(), basis(1)),
        ("bases of colour".to_owned(), basis(2)),
    ];
    for (number, layer) in layout.layers.iter().enumerate() {
        let end = layer.biases + layout.parts * layer.output;
        let number = number + 1;
        all.push((
            format!("weights of the networks' layer {number}"),
            peak(&slopes.networks[layer.weights..layer.biases]),
        ));
        all.push((
            format!("biases of the networks' layer {number}"),
            peak(&slopes.networks[layer.biases..end]),
        ));
    }
    all
}

/// The largest derivative of the first layer's weights of an input, of all parts.
fn of_input(slopes: &Parameters<f32>, layout: &ParameterLayout, input: usize) -> f64 {
    let Some(first) = layout.layers.first() else {
        return 0.0;
    };
    let weights = slopes.networks[first.weights..first.biases].chunks_exact(first.output);
    let own = weights.skip(input).step_by(first.input);
    peak(own.flatten())
}

/// Parts of a capture, or of the avatar made for it, that nothing can be learned from.
fn of_capture(subject: &PreflightSubject) -> Vec<String> {
    let template = &subject.capture.template;
    let mut sentences = Vec::new();
    let mut say = |names: Vec<String>, what: &str| {
        if !names.is_empty() {
            sentences.push(format!("{what}: {}", names.join(", ")));
        }
    };
    let mut has_vertices = vec![false; subject.topology.joints];
    for influence in template.weights.iter().flatten() {
        has_vertices[usize::from(influence.joint)] |= influence.weight > 0.0;
    }
    let mut has_gaussians = vec![false; subject.topology.joints];
    for placed in &subject.topology.gaussians {
        for (joint, weight) in placed.joint.into_iter().zip(placed.joint_weight) {
            has_gaussians[usize::from(joint)] |= weight > 0;
        }
    }
    let joints = |takes: &dyn Fn(usize) -> bool| -> Vec<String> {
        let all = (0..subject.topology.joints).filter(|&joint| takes(joint));
        all.map(|joint| joint_name(template, joint)).collect()
    };
    say(
        joints(&|joint| !has_vertices[joint]),
        "no vertex of the body model has a skin weight of these joints, so that turning them bends \
         nothing",
    );
    say(
        joints(&|joint| has_vertices[joint] && !has_gaussians[joint]),
        "no Gaussian follows these joints, though vertices do: there are few there",
    );
    let frames: BTreeSet<usize> = subject
        .views
        .shots()
        .iter()
        .map(|shot| shot.frame)
        .collect();
    let seen: Vec<Vec<f64>> = frames
        .into_iter()
        .map(|frame| {
            let pose = &subject.capture.frames[frame].pose;
            subject.start.inputs.unprojected(pose)
        })
        .collect();
    say(
        still_inputs(subject, &still(&seen)),
        &format!(
            "these never change in the {} frames that are learned from, so that nothing can be learned \
             of them",
            seen.len()
        ),
    );
    if subject.topology.head_parts == 0 && template.expression > 0 {
        sentences.push(format!(
            "no part is the head's, whose networks alone see expressions: nothing can be learned of \
             them with {} parts",
            subject.topology.parts()
        ));
    }
    sentences
}

/// Which numbers are the same in all rows.
fn still(rows: &[Vec<f64>]) -> Vec<bool> {
    let width = rows.first().map_or(0, Vec::len);
    (0..width)
        .map(|at| {
            let column = rows.iter().map(|row| row[at]);
            let low = column.clone().fold(f64::INFINITY, f64::min);
            let high = column.fold(f64::NEG_INFINITY, f64::max);
            high - low < STILL
        })
        .collect()
}

/// Names of inputs that don't move: of joints as a whole, where all three numbers of one don't.
fn still_inputs(subject: &PreflightSubject, still: &[bool]) -> Vec<String> {
    let inputs = &subject.start.inputs;
    let split = 3 * inputs.joint.len();
    let mut names = Vec::new();
    for (number, &joint) in inputs.joint.iter().enumerate() {
        let own = 3 * number..3 * number + 3;
        if still[own.clone()].iter().all(|&still| still) {
            let name = joint_name(&subject.capture.template, usize::from(joint));
            names.push(format!("joint {name}"));
        } else {
            let own = own.filter(|&input| still[input]);
            names.extend(own.map(|input| input_name(subject, input)));
        }
    }
    let expressions = &still[split..];
    if expressions.len() > 1 && expressions.iter().all(|&still| still) {
        names.push(format!("all {} expressions", expressions.len()));
    } else {
        let own = (split..still.len()).filter(|&input| still[input]);
        names.extend(own.map(|input| input_name(subject, input)));
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recipe::Preset;

    #[test]
    fn long_trainings_are_checked() {
        let mut recipe = Preset::Quick.recipe();
        assert!(is_due(&recipe, None) && is_due(&recipe, Some(10.0)));
        assert!(!is_due(&recipe, Some(4.0)), "the clock decides");
        recipe.schedule.iterations = 100;
        assert!(!is_due(&recipe, None) && is_due(&recipe, Some(60.0)));
    }

    #[test]
    fn what_never_changes_is_told_from_what_changes_once() {
        let rows = [
            vec![0.5, 1.0, 0.0],
            vec![0.5, 1.0 + 1e-9, 0.0],
            vec![0.5, 1.0, 0.01],
        ];
        assert_eq!(still(&rows), [true, true, false]);
        assert_eq!(still(&rows[..1]), [true; 3], "one frame moves nothing");
    }

    /// One Gaussian, one node, two parts with networks of 2, 3 and 2 numbers.
    fn layout() -> ParameterLayout {
        use crate::parameters::LayerPlace;
        let layer = |input, output, weights, biases| LayerPlace {
            input,
            output,
            weights,
            biases,
        };
        ParameterLayout {
            gaussians: 1,
            nodes: 1,
            parts: 2,
            node_bases: 64,
            layers: vec![layer(2, 3, 0, 12), layer(3, 2, 18, 30)],
            bases: [0, 4, 7, 10],
        }
    }

    #[test]
    fn every_kind_without_a_derivative_is_named_and_no_other() {
        let layout = layout();
        let mut slopes: Parameters<f32> = Parameters::zeros(&layout);
        let all = kinds(&slopes, &layout);
        assert_eq!(of_slopes(&all).len(), 13, "{all:?}");
        for array in slopes.arrays_mut() {
            array.fill(-1e-9);
        }
        assert_eq!(of_slopes(&kinds(&slopes, &layout)), [""; 0]);
        slopes.gaussians[4..7].fill(0.0);
        slopes.nodes[64..].fill(0.0);
        slopes.bases[5] = f32::NAN;
        slopes.networks[30..].fill(0.0);
        let faults = of_slopes(&kinds(&slopes, &layout));
        let parts = [
            "log scales is 0,",
            "nodes' bases is 0,",
            "bases of scale is NaN",
            "biases of the networks' layer 2 is 0,",
        ];
        assert_eq!(faults.len(), parts.len(), "{faults:?}");
        for (fault, part) in faults.iter().zip(parts) {
            assert!(fault.contains(part), "{fault}");
        }
    }

    #[test]
    fn an_inputs_weights_are_found_in_every_part() {
        let layout = layout();
        let mut slopes: Parameters<f32> = Parameters::zeros(&layout);
        let of = |slopes: &Parameters<f32>| [0, 1].map(|input| of_input(slopes, &layout, input));
        // Part 1, input 1, neuron 2.
        slopes.networks[(2 + 1) * 3 + 2] = -2.0;
        assert_eq!(of(&slopes), [0.0, 2.0]);
        slopes.networks[0] = f32::INFINITY;
        assert!(of(&slopes)[0].is_nan());
    }

    #[test]
    fn a_perceptual_loss_that_does_not_move_is_a_fault() {
        let answer = PerceptualAnswer {
            value: 0.2,
            other: 0.3,
            slope: 1e-3,
        };
        assert_eq!(of_answer(answer), None);
        for dead in [
            PerceptualAnswer {
                other: 0.2,
                ..answer
            },
            PerceptualAnswer {
                slope: 0.0,
                ..answer
            },
            PerceptualAnswer {
                slope: f64::NAN,
                ..answer
            },
            PerceptualAnswer {
                value: f64::NAN,
                ..answer
            },
        ] {
            assert!(of_answer(dead).is_some_and(|fault| fault.contains("expected")));
        }
    }

    #[test]
    fn images_differ_where_a_pixel_does_and_nothing_else_counts() {
        let image = vec![[0.5f32; 3]; 4];
        let mut other = image.clone();
        assert!(!differs(&image, &other));
        other[2][1] += 1e-5;
        assert!(differs(&image, &other));
        other[2][1] = f32::NAN;
        assert!(!differs(&image, &other));
    }
}
