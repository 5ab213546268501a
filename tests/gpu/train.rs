//! Training's kernels against the derivative in f64, and what its steps promise.

use crate::common::{self, Random, Sizes, gpu};
use effigy_core::avatar::{Activation, Avatar, Filter, Pose, Skeleton};
use effigy_core::reference::raster::Cutoff;
use effigy_core::scene::{Camera, Posed};
use effigy_train::adam::{Adam, Rates};
use effigy_train::gpu::{StepOptions, TileShape, Trainer, TrainerState};
use effigy_train::loss::LossWeights;
use effigy_train::parameters::{GAUSSIAN, ParameterLayout, Parameters};
use effigy_train::reference::Problem;
use effigy_train::refine::Refinement;
use effigy_train::topology::{CorrectiveRows, Topology};
use effigy_train::view::{TrainingView, ViewPicture};
use glam::{DAffine3, DVec3};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// An avatar, and views of it whose pictures are noise: every pixel has a derivative.
struct Scene {
    avatar: Avatar,
    topology: Topology,
    rows: CorrectiveRows,
    layout: ParameterLayout,
    start: TrainerState,
    views: Vec<TrainingView>,
}

#[derive(Clone, Copy)]
struct Setting {
    filter: Filter,
    activation: Activation,
    size: [u32; 2],
    views: usize,
    /// Added to log scales.
    larger: f32,
}

const SETTING: Setting = Setting {
    filter: Filter::DEFAULT,
    activation: Activation::LeakyRelu,
    size: [50, 61],
    views: 2,
    larger: 0.0,
};

impl Scene {
    fn new(seed: u64, setting: Setting) -> Self {
        let mut avatar = common::faced(common::avatar(
            seed,
            Sizes {
                gaussians: 700,
                parts: 7,
                nodes: 60,
                rows: 500,
                split_features: true,
                activation: setting.activation,
                ..Sizes::default()
            },
        ));
        avatar.filter = setting.filter;
        let topology = Topology::new(&avatar);
        let rows = CorrectiveRows::of(&avatar);
        let layout = ParameterLayout::new(&topology, &rows);
        let mut parameters = Parameters::of(&avatar, &layout);
        for numbers in parameters.gaussians.chunks_exact_mut(GAUSSIAN) {
            for scale in &mut numbers[4..7] {
                *scale += setting.larger;
            }
        }
        let random = &mut Random(seed);
        let views = (0..setting.views)
            .map(|number| {
                let posed = Posed::new(&avatar, &common::pose(seed + number as u64, &avatar));
                let middle = posed.joints[0].transform_point3(DVec3::new(0.0, 0.9, 0.0));
                let yaw = number as f64;
                let pixels = setting.size[0] * setting.size[1];
                TrainingView {
                    joints: posed.joints,
                    input: posed.input,
                    camera: Camera::orbit(middle, yaw, 0.1, 3.5, 0.61, setting.size),
                    gain: DVec3::new(1.1, 0.85, 0.95),
                    whole: u64::from(pixels),
                    picture: Arc::new(ViewPicture {
                        size: setting.size,
                        pixels: (0..pixels).map(|_| noise(random)).collect(),
                        behind: (0..pixels).map(|_| noise(random)).collect(),
                    }),
                }
            })
            .collect();
        Self {
            start: TrainerState::new(&layout, parameters),
            avatar,
            topology,
            rows,
            layout,
            views,
        }
    }

    fn trainer(&self, setting: Setting) -> Trainer {
        self.shaped(setting, TileShape::of(&gpu::gpu()))
    }

    fn shaped(&self, setting: Setting, shape: TileShape) -> Trainer {
        let device = gpu::gpu();
        let Setting { size, views, .. } = setting;
        Trainer::with_shape(
            &device,
            &self.topology,
            &self.rows,
            &self.start,
            size,
            views,
            shape,
        )
        .unwrap()
    }

    fn problem<'a>(&'a self, options: &'a StepOptions) -> Problem<'a> {
        Problem {
            topology: &self.topology,
            rows: &self.rows,
            layout: &self.layout,
            weights: &options.weights,
            correctives: options.correctives,
            cutoff: Cutoff::Sharp,
        }
    }
}

/// A colour, and what the pixel shows.
fn noise(random: &mut Random) -> [u8; 4] {
    let shows = [0, 85, 170, 255][random.below(4)];
    [
        random.below(256) as u8,
        random.below(256) as u8,
        random.below(256) as u8,
        shows,
    ]
}

/// Nothing is learned, and the first moment is the derivative.
pub const STILL: StepOptions = StepOptions {
    weights: LossWeights {
        l1: 1.0,
        scale: 0.5,
        scale_above: 0.01,
        correctives: [0.002, 0.01, 0.002],
    },
    correctives: true,
    joints: true,
    rates: Rates::NONE,
    adam: Adam {
        beta_1: 0.0,
        beta_2: 0.999,
        epsilon: 1e-15,
        weight_decay: 0.0,
    },
};

/// Rates at which the small avatar of the tests learns.
pub const LEARNING: StepOptions = StepOptions {
    rates: Rates {
        rotation: 2e-3,
        log_scale: 5e-3,
        opacity: 5e-3,
        color: 5e-3,
        node_offset: 3e-4,
        node_basis: 3e-5,
        network: 5e-4,
        bases: [1e-3; 3],
    },
    adam: Adam::DEFAULT,
    weights: LossWeights::PAPER,
    ..STILL
};

/// That one array of derivatives is another's, as a whole and number by number.
#[track_caller]
fn assert_same(what: &str, found: &[f32], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let dot = |a: &dyn Fn(usize) -> f64, b: &dyn Fn(usize) -> f64| {
        (0..found.len()).map(|k| a(k) * b(k)).sum::<f64>()
    };
    let f = |k: usize| f64::from(found[k]);
    let e = |k: usize| expected[k];
    let length = dot(&e, &e).sqrt();
    assert!(length > 0.0, "{what}: no derivative at all");
    let cosine = dot(&f, &e) / (dot(&f, &f).sqrt() * length);
    let off = |k: usize| f(k) - e(k);
    let relative = dot(&off, &off).sqrt() / length;
    let largest = expected.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
    let mass: f64 = expected.iter().map(|v| v.abs()).sum();
    let bias = (0..found.len())
        .map(|k| off(k) * e(k).signum())
        .sum::<f64>()
        / mass;
    let wrong = (0..found.len())
        .filter(|&k| off(k).abs() > 2e-3 * largest)
        .count();
    println!(
        "{what}: cosine 1 - {:.1e}, relative {relative:.1e}, bias {bias:.1e}, {wrong} wrong of {}",
        1.0 - cosine,
        found.len()
    );
    assert!(
        cosine >= 0.99999 && relative <= 1e-3 && bias.abs() <= 1e-3 && wrong == 0,
        "{what}: cosine {cosine}, relative {relative}, bias {bias}, {wrong} numbers are off by more \
         than 2/1000 of the largest"
    );
}

#[track_caller]
fn assert_gradients(found: &Parameters<f32>, expected: &Parameters<f64>, layout: &ParameterLayout) {
    let kinds = [
        ("rotation", 0..4),
        ("log scale", 4..7),
        ("opacity", 7..8),
        ("colour", 8..11),
    ];
    for (what, columns) in kinds {
        let pick = |k: &usize| columns.contains(&(k % GAUSSIAN));
        let at: Vec<usize> = (0..found.gaussians.len()).filter(pick).collect();
        let f: Vec<f32> = at.iter().map(|&k| found.gaussians[k]).collect();
        let e: Vec<f64> = at.iter().map(|&k| expected.gaussians[k]).collect();
        assert_same(what, &f, &e);
    }
    let nodes = layout.node_bases;
    assert_same(
        "node offsets",
        &found.nodes[..nodes],
        &expected.nodes[..nodes],
    );
    assert_same(
        "node bases",
        &found.nodes[nodes..],
        &expected.nodes[nodes..],
    );
    for (l, layer) in layout.layers.iter().enumerate() {
        let weights = layer.weights..layer.biases;
        let biases = layer.biases..layer.biases + layout.parts * layer.output;
        for (what, range) in [("weights", weights), ("biases", biases)] {
            let what = format!("{what} of layer {l}");
            assert_same(
                &what,
                &found.networks[range.clone()],
                &expected.networks[range],
            );
        }
    }
    for (attribute, what) in ["rotation", "scale", "colour"].into_iter().enumerate() {
        let range = layout.bases[attribute]..layout.bases[attribute + 1];
        let what = format!("bases of {what}");
        assert_same(&what, &found.bases[range.clone()], &expected.bases[range]);
    }
}

fn every_gradient_is_the_references() {
    let settings = [
        SETTING,
        Setting {
            filter: Filter::ANTIALIASED,
            activation: Activation::Relu,
            views: 1,
            ..SETTING
        },
    ];
    for (seed, setting) in (1..).zip(settings) {
        let scene = Scene::new(seed, setting);
        let mut trainer = scene.trainer(setting);
        let report = trainer.step(&scene.views, &STILL).unwrap();
        let found = trainer.state().unwrap();
        assert_eq!(
            found.parameters, scene.start.parameters,
            "nothing is learned"
        );
        let problem = scene.problem(&STILL);
        let doubles = scene.start.parameters.doubles();
        let expected = problem.gradient(&doubles, &scene.views);
        assert_gradients(&found.first_moments, &expected, &scene.layout);
        let weights = LossWeights {
            scale: 0.0,
            correctives: [0.0; 3],
            ..STILL.weights
        };
        let pictures = StepOptions { weights, ..STILL };
        let loss = scene.problem(&pictures).loss(&doubles, &scene.views);
        assert!(
            (report.l1 - loss).abs() < 1e-4 * loss,
            "L1 is {}, expected {loss}",
            report.l1
        );
        assert_eq!(report.empty_views, 0);
        for (number, view) in scene.views.iter().enumerate() {
            let canvas = problem.forward(&doubles, view).canvas;
            let expected = problem.gain_gradient(&canvas, view) / scene.views.len() as f64;
            let of_canvas = problem.picture_loss_backward(&canvas, view);
            let forward = problem.forward(&doubles, view);
            let expected_joints: Vec<f64> = problem
                .joints_gradient(view, &forward, &of_canvas)
                .iter()
                .flat_map(|joint| joint.to_cols_array())
                .map(|v| v / scene.views.len() as f64)
                .collect();
            let found_joints: Vec<f32> = trainer
                .joints_gradient(number)
                .iter()
                .flat_map(|joint| joint.to_cols_array())
                .map(|v| v as f32)
                .collect();
            assert_same("joints", &found_joints, &expected_joints);
            let found = DVec3::from(trainer.gain_gradient(number));
            assert!(
                found.distance(expected) < 1e-4 * expected.length(),
                "of the gain: {found}, expected {expected}"
            );
        }
    }
}

fn tiles_of_gpus_give_the_same_gradients() {
    let scene = Scene::new(8, SETTING);
    let mut trainer = scene.shaped(SETTING, TileShape::GPU);
    trainer.step(&scene.views, &STILL).unwrap();
    let found = trainer.state().unwrap();
    let doubles = scene.start.parameters.doubles();
    let expected = scene.problem(&STILL).gradient(&doubles, &scene.views);
    assert_gradients(&found.first_moments, &expected, &scene.layout);
}

fn only_neutral_numbers_learn_without_correctives() {
    let scene = Scene::new(9, SETTING);
    let options = StepOptions {
        correctives: false,
        ..STILL
    };
    let mut trainer = scene.trainer(SETTING);
    trainer.step(&scene.views, &options).unwrap();
    let found = trainer.state().unwrap();
    assert_eq!((found.steps, found.corrective_steps), (1, 0));
    let moments = &found.first_moments;
    assert!(
        moments
            .networks
            .iter()
            .chain(&moments.bases)
            .all(|&v| v == 0.0)
    );
    let doubles = scene.start.parameters.doubles();
    let expected = scene.problem(&options).gradient(&doubles, &scene.views);
    let offsets = ..scene.layout.node_bases;
    assert_same(
        "node offsets",
        &moments.nodes[offsets],
        &expected.nodes[offsets],
    );
    let neutral = |k: &usize| k % GAUSSIAN < 11;
    let at: Vec<usize> = (0..moments.gaussians.len()).filter(neutral).collect();
    let found: Vec<f32> = at.iter().map(|&k| moments.gaussians[k]).collect();
    let expected: Vec<f64> = at.iter().map(|&k| expected.gaussians[k]).collect();
    assert_same("neutral numbers", &found, &expected);
}

/// Every kind of number goes by a rate of its own, from its own moments.
fn adam_steps_by_each_rate() {
    let scene = Scene::new(10, SETTING);
    let options = StepOptions {
        rates: Rates {
            rotation: 1e-3,
            log_scale: 2e-3,
            opacity: 3e-3,
            color: 4e-3,
            node_offset: 5e-4,
            node_basis: 6e-4,
            network: 7e-4,
            bases: [8e-4, 9e-4, 1.1e-3],
        },
        adam: Adam {
            weight_decay: 0.5,
            ..Adam::DEFAULT
        },
        ..STILL
    };
    let mut trainer = scene.trainer(SETTING);
    for _ in 0..2 {
        trainer.step(&scene.views, &options).unwrap();
    }
    let before = trainer.state().unwrap();
    trainer.step(&scene.views, &options).unwrap();
    let after = trainer.state().unwrap();
    let [main_1, main_2] = options.adam.correction(3);
    let layout = &scene.layout;
    let rates = &options.rates;
    let rate = |array: usize, at: usize| -> (f64, f64) {
        match array {
            0 => match at % GAUSSIAN {
                0..4 => (rates.rotation, 0.0),
                4..7 => (rates.log_scale, 0.0),
                7 => (rates.opacity, 0.0),
                8..11 => (rates.color, 0.0),
                _ => (0.0, 0.0),
            },
            1 if at < layout.node_bases => (rates.node_offset, 0.0),
            1 => (rates.node_basis, 0.0),
            2 => (rates.network, options.adam.weight_decay),
            _ => {
                let kind = (1..3).filter(|&kind| at >= layout.bases[kind]).count();
                (rates.bases[kind], 0.0)
            }
        }
    };
    for array in 0..4 {
        let [p, q, m, v, m0] = [
            before.parameters.arrays()[array],
            after.parameters.arrays()[array],
            after.first_moments.arrays()[array],
            after.second_moments.arrays()[array],
            before.first_moments.arrays()[array],
        ];
        let mut learned = 0;
        for at in 0..p.len() {
            let (rate, decay) = rate(array, at);
            let [p, q, m, v] = [p[at], q[at], m[at], v[at]].map(f64::from);
            let change = m * main_1 / ((v * main_2).sqrt() + 1e-15);
            let expected = p - rate * (change + decay * p);
            assert!(
                (q - expected).abs() < 1e-6 * p.abs().max(1.0) + 1e-3 * rate,
                "number {at} of array {array}: from {p} to {q}, expected {expected}"
            );
            // The second moment is of the same derivative as the first.
            let gradient = (m - 0.9 * f64::from(m0[at])) / 0.1;
            learned += usize::from(gradient.abs() > 0.0);
        }
        assert!(
            learned > p.len() / 4,
            "{learned} numbers of array {array} learn"
        );
    }
}

/// What finds poses and bones: the picture's loss alone.
fn look() -> StepOptions {
    StepOptions {
        weights: LossWeights {
            l1: 1.0,
            scale: 0.0,
            scale_above: 1.0,
            correctives: [0.0; 3],
        },
        ..STILL
    }
}

/// A view of an avatar whose joints are elsewhere.
fn posed(
    scene: &Scene,
    skeleton: &Skeleton,
    pose: &Pose,
    seen: &Pose,
    view: &TrainingView,
) -> TrainingView {
    TrainingView {
        joints: skeleton.matrices(pose),
        input: scene.avatar.inputs.unprojected(seen),
        gain: DVec3::ONE,
        ..view.clone()
    }
}

/// The scene's views with pictures of a pose.
fn pictures(scene: &Scene, size: [u32; 2], truth: &Pose) -> Vec<TrainingView> {
    let options = look();
    let problem = scene.problem(&options);
    let numbers = scene.start.parameters.doubles();
    let views = scene.views.iter().map(|view| {
        let view = posed(scene, &scene.avatar.skeleton, truth, truth, view);
        let pixels = problem.forward(&numbers, &view).canvas.pixels;
        let byte = |v: f64, a: f64| (255.0 * v + (1.0 - a) * 128.0).round() as u8;
        TrainingView {
            picture: Arc::new(ViewPicture {
                size,
                behind: vec![[128; 4]; pixels.len()],
                pixels: pixels
                    .iter()
                    .map(|&[r, g, b, a]| [byte(r, a), byte(g, a), byte(b, a), 255])
                    .collect(),
            }),
            ..view
        }
    });
    views.collect()
}

/// The derivative of the last look with respect to the joints, summed over its views.
fn joints_gradient(trainer: &mut Trainer, views: usize) -> Vec<DAffine3> {
    let all = (0..views).map(|view| trainer.joints_gradient(view));
    let sum = all.reduce(|a, b| {
        let pairs = a.into_iter().zip(b);
        let sum = pairs.map(|(a, b)| DAffine3 {
            matrix3: a.matrix3 + b.matrix3,
            translation: a.translation + b.translation,
        });
        sum.collect()
    });
    sum.unwrap()
}

fn bones_that_are_off_are_found_by_pictures() {
    let setting = Setting {
        views: 3,
        ..SETTING
    };
    let scene = Scene::new(11, setting);
    let pose = common::pose(11, &scene.avatar);
    let pictures = pictures(&scene, setting.size, &pose);
    let truth = &scene.avatar.skeleton;
    let by = |joint: usize| match joint {
        0 => DVec3::ZERO,
        _ => 0.03 * DVec3::new((joint as f64).sin(), (2.0 * joint as f64).cos(), 0.5),
    };
    let off = truth.with_bones(&(0..truth.len()).map(by).collect::<Vec<_>>());
    let mut trainer = scene.trainer(setting);
    let mut refinement = Refinement::of(truth.len(), &[&pose], 0);
    let mut losses = Vec::new();
    for step in 0..120 {
        let own = refinement.skeleton(&off);
        let looked: Vec<TrainingView> = pictures
            .iter()
            .map(|view| posed(&scene, &own, &pose, &pose, view))
            .collect();
        losses.push(trainer.look(&looked, &look()).unwrap().l1);
        let gradient = own.matrices_backward(&pose, &joints_gradient(&mut trainer, looked.len()));
        let rate = 5e-3 * 0.02f64.powf(f64::from(step) / 120.0);
        refinement.learn_bones(&gradient, rate, &Adam::DEFAULT);
    }
    let (first, last) = (losses[0], losses[losses.len() - 1]);
    println!("L1 from {first} to {last}");
    assert!(last < 0.2 * first, "L1 went from {first} to {last}");
}

fn a_pose_that_is_off_is_found_by_its_pictures() {
    let setting = Setting {
        views: 3,
        ..SETTING
    };
    let scene = Scene::new(11, setting);
    let options = look();
    let truth = common::pose(11, &scene.avatar);
    let pictures = pictures(&scene, setting.size, &truth);
    let skeleton = &scene.avatar.skeleton;
    let mut off = truth.clone();
    off.translation += DVec3::new(0.02, -0.03, 0.01);
    for rotation in off.rotation.iter_mut().take(3) {
        *rotation += DVec3::new(0.08, -0.1, 0.06);
    }
    let mut trainer = scene.trainer(setting);
    let joints = scene.avatar.skeleton.len();
    let mut refinement = Refinement::of(joints, &[&off], 0);
    let mut losses = Vec::new();
    for step in 0..120 {
        let pose = refinement.pose(0, &off);
        let looked: Vec<TrainingView> = pictures
            .iter()
            .map(|view| posed(&scene, skeleton, &pose, &truth, view))
            .collect();
        losses.push(trainer.look(&looked, &options).unwrap().l1);
        let gradient = joints_gradient(&mut trainer, looked.len());
        let gradient = skeleton.matrices_backward(&pose, &gradient);
        let rate = 1e-2 * 0.02f64.powf(f64::from(step) / 120.0);
        refinement.learn_pose(0, &gradient, rate, &Adam::DEFAULT);
    }
    let (first, last) = (losses[0], losses[losses.len() - 1]);
    println!("L1 from {first} to {last}");
    assert!(last < 0.1 * first, "L1 went from {first} to {last}");
    let far = |pose: &Pose| pose.translation.distance(truth.translation);
    let left = far(&refinement.pose(0, &off));
    assert!(left < 0.1 * far(&off), "the body is {left} m off");
    assert_eq!(trainer.steps(), 0, "nothing else is learned");
}

fn pairs_that_do_not_fit_get_room() {
    let setting = Setting {
        larger: 2.0,
        ..SETTING
    };
    let scene = Scene::new(3, setting);
    // Small tiles, on a GPU too: a splat meets many.
    let mut trainer = scene.shaped(setting, TileShape::CPU);
    let report = trainer.step(&scene.views, &STILL).unwrap();
    assert!(
        report.pairs > 4 * 700,
        "{} pairs fit from the start",
        report.pairs
    );
    let doubles = scene.start.parameters.doubles();
    let expected = scene.problem(&STILL).gradient(&doubles, &scene.views);
    let found = trainer.state().unwrap();
    assert_gradients(&found.first_moments, &expected, &scene.layout);
    assert_eq!(trainer.steps(), 1);
}

fn pairs_that_no_buffer_holds_are_drawn_in_bands() {
    let setting = Setting {
        larger: 1.0,
        ..SETTING
    };
    let scene = Scene::new(3, setting);
    // Small tiles, on a GPU too: a band is a row of them at least.
    let own = TileShape::CPU;
    let mut whole = scene.shaped(setting, own);
    let all = whole.step(&scene.views, &STILL).unwrap();
    let shape = TileShape {
        most_pairs: all.pairs / 2,
        ..own
    };
    let mut trainer = scene.shaped(setting, shape);
    let report = trainer.step(&scene.views, &STILL).unwrap();
    assert!(
        report.pairs <= shape.most_pairs,
        "{} pairs, and {} in bands",
        all.pairs,
        report.pairs
    );
    assert_eq!((report.l1, report.empty_views), (all.l1, all.empty_views));
    let doubles = scene.start.parameters.doubles();
    let expected = scene.problem(&STILL).gradient(&doubles, &scene.views);
    let found = trainer.state().unwrap();
    assert_gradients(&found.first_moments, &expected, &scene.layout);
    // Sums have the same order.
    assert!(trainer.state().unwrap() == whole.state().unwrap());
    let asked = |trainer: &mut Trainer| {
        let slope = |_: usize, image: &[[f32; 3]]| Some(vec![[1e-3; 3]; image.len()]);
        let goes_on = AtomicBool::new(false);
        trainer
            .step_with_image_loss(&scene.views, &LEARNING, &goes_on, slope)
            .unwrap();
        trainer.state().unwrap()
    };
    assert!(asked(&mut trainer) == asked(&mut whole));
    // A row of tiles is the least.
    let mut none = scene.shaped(
        setting,
        TileShape {
            most_pairs: 10,
            ..own
        },
    );
    let error = none.step(&scene.views, &STILL).unwrap_err().to_string();
    assert!(error.contains("room for 10"), "{error}");
}

fn equal_steps_give_equal_bits() {
    let scene = Scene::new(4, SETTING);
    let run = || {
        let mut trainer = scene.trainer(SETTING);
        for _ in 0..5 {
            trainer.step(&scene.views, &LEARNING).unwrap();
        }
        trainer.state().unwrap()
    };
    let first = run();
    assert!(first != scene.start && first.parameters.gaussians.iter().all(|v| v.is_finite()));
    assert_eq!(first, run());
    // From what a checkpoint holds too.
    let mut half = scene.trainer(SETTING);
    for _ in 0..2 {
        half.step(&scene.views, &LEARNING).unwrap();
    }
    let state = half.state().unwrap();
    let mut resumed = Trainer::new(
        &gpu::gpu(),
        &scene.topology,
        &scene.rows,
        &state,
        SETTING.size,
        SETTING.views,
    )
    .unwrap();
    for _ in 0..3 {
        resumed.step(&scene.views, &LEARNING).unwrap();
    }
    assert_eq!(first, resumed.state().unwrap());
}

fn another_loss_is_asked_once_a_view() {
    let mut scene = Scene::new(5, SETTING);
    for view in &mut scene.views {
        // No pixel is lighter than an image holds.
        view.gain = DVec3::new(0.9, 0.8, 1.0);
    }
    let options = StepOptions {
        weights: LossWeights {
            l1: 0.0,
            scale: 0.0,
            correctives: [0.0; 3],
            ..STILL.weights
        },
        ..STILL
    };
    let mut trainer = scene.trainer(SETTING);
    let pixels = (SETTING.size[0] * SETTING.size[1]) as usize;
    // Each channel has a slope of its own, the same in all pixels.
    let slope = [1e-3f32, -2e-3, 5e-4];
    let mut asked = Vec::new();
    let stop = AtomicBool::new(false);
    let before = trainer.state().unwrap();
    let stopped = trainer.step_with_image_loss(&scene.views, &options, &stop, |_, _| {
        stop.store(true, Ordering::Relaxed);
        None
    });
    assert_eq!(stopped.unwrap(), None);
    assert!(trainer.state().unwrap() == before);
    stop.store(false, Ordering::Relaxed);
    trainer
        .step_with_image_loss(&scene.views, &options, &stop, |view, image| {
            assert_eq!(image.len(), pixels);
            asked.push(view);
            Some(vec![slope; pixels])
        })
        .unwrap();
    assert_eq!(asked, [0, 1]);
    let problem = scene.problem(&options);
    let doubles = scene.start.parameters.doubles();
    let mut expected = Parameters::zeros(&scene.layout);
    for view in &scene.views {
        let forward = problem.forward(&doubles, view);
        let of = DVec3::from(slope.map(f64::from)) / scene.views.len() as f64;
        let of_canvas: Vec<[f64; 4]> = forward
            .canvas
            .pixels
            .iter()
            .enumerate()
            .map(|(at, _)| {
                let behind = view.picture.background(at);
                (view.gain * of).extend(-of.dot(behind)).to_array()
            })
            .collect();
        problem.backward(&doubles, view, &forward, &of_canvas, &mut expected);
    }
    let found = trainer.state().unwrap();
    assert_gradients(&found.first_moments, &expected, &scene.layout);
}

fn it_learns_what_another_avatar_looks_like() {
    let scene = Scene::new(6, SETTING);
    let problem = scene.problem(&LEARNING);
    let truth = scene.start.parameters.doubles();
    let views: Vec<TrainingView> = scene
        .views
        .iter()
        .map(|view| {
            let canvas = problem.forward(&truth, view).canvas;
            let pixels = canvas.pixels.iter().map(|&[r, g, b, a]| {
                let byte = |v: f64| (255.0 * v + (1.0 - a) * 128.0).round() as u8;
                [byte(r), byte(g), byte(b), 255]
            });
            TrainingView {
                gain: DVec3::ONE,
                picture: Arc::new(ViewPicture {
                    size: SETTING.size,
                    pixels: pixels.collect(),
                    behind: vec![[128; 4]; canvas.pixels.len()],
                }),
                ..view.clone()
            }
        })
        .collect();
    let mut start = scene.start.clone();
    let random = &mut Random(7);
    for numbers in start.parameters.gaussians.chunks_exact_mut(GAUSSIAN) {
        numbers[4] += 0.3 * random.normal() as f32;
        for color in &mut numbers[8..11] {
            *color = 0.5;
        }
    }
    let mut trainer = Trainer::new(
        &gpu::gpu(),
        &scene.topology,
        &scene.rows,
        &start,
        SETTING.size,
        SETTING.views,
    )
    .unwrap();
    let first = trainer.step(&views, &LEARNING).unwrap();
    let mut last = first;
    for _ in 0..200 {
        last = trainer.step(&views, &LEARNING).unwrap();
    }
    println!("L1 from {} to {}", first.l1, last.l1);
    assert!(
        last.l1 < 0.25 * first.l1,
        "L1 went from {} to {} in 200 steps",
        first.l1,
        last.l1
    );
    // What files hold of it is nearly as good.
    let mut avatar = scene.avatar.clone();
    let learned = trainer.parameters().unwrap();
    learned.put_into(&mut avatar, &scene.layout, &scene.rows);
    avatar.check().unwrap();
    let stored = Parameters::of(&avatar, &scene.layout).doubles();
    let options = StepOptions {
        weights: LossWeights {
            scale: 0.0,
            correctives: [0.0; 3],
            ..LEARNING.weights
        },
        ..LEARNING
    };
    let loss = scene.problem(&options).loss(&stored, &views);
    assert!(loss < 1.2 * last.l1 + 2e-3, "in a file L1 is {loss}");
}

tests! {
    every_gradient_is_the_references,
    tiles_of_gpus_give_the_same_gradients,
    only_neutral_numbers_learn_without_correctives,
    adam_steps_by_each_rate,
    a_pose_that_is_off_is_found_by_its_pictures,
    bones_that_are_off_are_found_by_pictures,
    pairs_that_do_not_fit_get_room,
    pairs_that_no_buffer_holds_are_drawn_in_bands,
    equal_steps_give_equal_bits,
    another_loss_is_asked_once_a_view,
    it_learns_what_another_avatar_looks_like,
}
