//! The check before a long training: what it finds of a capture on a device, and that it leaves the
//! training as it is.

use crate::common::gpu;
use effigy_capture::Capture;
use effigy_core::avatar::Avatar;
use effigy_train::{
    data::{TrainingViews, training_shots},
    perceptual::PerceptualLoss,
    preflight::{self, Findings, PreflightSubject},
    recipe::{PerceptualKind, Preset, Recipe},
    session::{SessionOptions, TrainingOutcome, TrainingSession},
    start::start,
    topology::Topology,
};
use std::{
    path::{Path, PathBuf},
    sync::{Arc, atomic::AtomicBool},
    time::Duration,
};

fn capture() -> Capture {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/data/capture");
    Capture::read(&folder).unwrap()
}

/// A training of seconds, with every switch on.
fn recipe() -> Recipe {
    let mut recipe = Preset::Quick.recipe();
    recipe.sizes.gaussians = 900;
    recipe.sizes.parts = 30;
    recipe.sizes.nodes = 60;
    recipe.sizes.hidden = 16;
    recipe.schedule.iterations = 20;
    recipe.schedule.fine_tune = 10;
    recipe.rates.exposure = 1e-3;
    recipe.perceptual.kind = PerceptualKind::Dssim;
    recipe.perceptual.window = 32;
    recipe
}

/// The avatar that a training begins with.
fn first(capture: &Capture, recipe: &Recipe) -> Avatar {
    let poses: Vec<_> = capture.frames.iter().map(|f| f.pose.clone()).collect();
    start(
        &capture.template,
        &poses,
        &recipe.sizes,
        recipe.filter,
        recipe.seed,
    )
}

fn check(capture: Capture, recipe: &Recipe, start: &Avatar) -> Findings {
    check_within(Duration::from_secs(600), capture, recipe, start)
}

fn check_within(patience: Duration, capture: Capture, recipe: &Recipe, start: &Avatar) -> Findings {
    let capture = Arc::new(capture);
    let shots = training_shots(&capture);
    let perceptual = PerceptualLoss::new(&recipe.perceptual, Path::new(""), 1).unwrap();
    preflight::check(&PreflightSubject {
        gpu: &gpu::gpu(),
        recipe,
        start,
        topology: &Topology::new(start),
        views: &TrainingViews::new(&capture, start, shots, &recipe.data, 1, None),
        perceptual: perceptual.as_ref(),
        patience,
        capture: &capture,
    })
    .unwrap()
}

fn says(sentences: &[String], part: &str, name: &str) -> bool {
    let mut all = sentences.iter();
    all.any(|sentence| sentence.contains(part) && sentence.contains(name))
}

fn a_capture_in_which_all_moves_has_no_faults() {
    let recipe = recipe();
    let capture = capture();
    let start = first(&capture, &recipe);
    let found = check(capture, &recipe, &start);
    assert_eq!(found.faults, [""; 0], "{:?}", found.warnings);
    assert!(
        !says(&found.warnings, "never change", ""),
        "{:?}",
        found.warnings
    );
}

fn what_a_capture_does_not_move_is_named() {
    let recipe = recipe();
    let mut capture = capture();
    let names = capture.template.skeleton.name.clone();
    let stiff = 18;
    for own in &mut capture.template.weights {
        own.retain(|influence| usize::from(influence.joint) != stiff);
    }
    let still = usize::from(capture.template.input_joints[4]);
    for frame in &mut capture.frames {
        frame.pose.rotation[still].y = 0.25;
        frame.pose.expression[3] = 0.5;
    }
    let start = first(&capture, &recipe);
    let found = check(capture, &recipe, &start);
    let warnings = &found.warnings;
    assert!(says(warnings, "skin weight", &names[stiff]), "{warnings:?}");
    let input = format!("input y of `{}`, expression 3", names[still]);
    assert!(says(warnings, "never change", &input), "{warnings:?}");
    assert_eq!(found.faults, [""; 0]);
}

fn a_path_that_is_dead_is_a_fault() {
    let recipe = recipe();
    let capture = capture();
    let mut start = first(&capture, &recipe);
    let last = start.networks.layers.last_mut().unwrap();
    let zeros = vec![half::f16::ZERO; last.bias.len() * last.input];
    last.weight = zeros.into();
    let found = check(capture, &recipe, &start);
    for part in [
        "input x of",
        "moved no pixel",
        "the networks' layer 1 is 0",
        "the first layer's weights of input z of",
    ] {
        assert!(says(&found.faults, part, "expected"), "{:?}", found.faults);
    }
    assert!(!says(&found.faults, "layer 4", ""), "{:?}", found.faults);
    assert!(!says(&found.faults, "turned by", ""), "{:?}", found.faults);
}

fn what_there_was_no_time_for_is_named() {
    let recipe = recipe();
    let capture = capture();
    let joint = capture.template.skeleton.name[1].clone();
    let mut start = first(&capture, &recipe);
    let last = start.networks.layers.last_mut().unwrap();
    last.weight = vec![half::f16::ZERO; last.bias.len() * last.input].into();
    let found = check_within(Duration::ZERO, capture, &recipe, &start);
    let warnings = &found.warnings;
    assert!(says(warnings, "there was no look", &joint), "{warnings:?}");
    // The path is dead, but who has hardly looked can't know.
    assert_eq!(found.faults, [""; 0]);
}

fn a_training_is_the_same_with_and_without_a_check() {
    let folder = tempfile::tempdir().unwrap();
    let capture = Arc::new(capture());
    let train = |check: bool| {
        let options = SessionOptions {
            folder: PathBuf::from(folder.path()).join(format!("{check}")),
            resume: false,
            minutes: None,
            check,
            checkpoint_every: Duration::from_secs(1000),
            log_every: 50,
            perceptual_weights: PathBuf::new(),
            standing: Default::default(),
            name: "same".into(),
            credit: String::new(),
        };
        let mut checked = None;
        let mut session = TrainingSession::new(&gpu::gpu(), &capture, &recipe(), options, |plan| {
            checked = Some(plan.check);
        })
        .unwrap();
        assert_eq!(checked, Some(check));
        match session.run(&AtomicBool::new(false), |_, _| {}).unwrap() {
            TrainingOutcome::Done(avatar) => avatar,
            TrainingOutcome::Stopped => panic!("nobody stopped it"),
        }
    };
    assert!(train(true) == train(false), "the avatars differ");
}

tests! {
    a_capture_in_which_all_moves_has_no_faults,
    what_a_capture_does_not_move_is_named,
    a_path_that_is_dead_is_a_fault,
    what_there_was_no_time_for_is_named,
    a_training_is_the_same_with_and_without_a_check,
}
