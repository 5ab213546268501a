//! The derivative against differences of the loss, with the smooth cutoff.

use super::*;
use crate::topology::{Follower, PlacedGaussian};
use crate::view::ViewPicture;
use effigy_core::avatar::{Activation, Filter, facing};
use effigy_core::random::Random;
use effigy_core::scene::Camera;
use std::sync::Arc;

const SIZE: [u32; 2] = [24, 20];
const JOINTS: usize = 3;

/// A few Gaussians that overlap in front of a camera.
struct TestScene {
    topology: Topology,
    rows: CorrectiveRows,
    layout: ParameterLayout,
    parameters: Parameters<f64>,
    views: Vec<TrainingView>,
}

const GAUSSIANS: usize = 30;
const PARTS: usize = 3;
const NODES: usize = 7;

impl TestScene {
    fn new(seed: u64, filter: Filter) -> Self {
        let mut random = Random::new(seed, 0);
        let topology = topology(&mut random, filter);
        // Some have no row.
        let keep = |step: usize| {
            (0..GAUSSIANS as u32)
                .filter(|k| k % step as u32 != 1)
                .collect()
        };
        let rows = CorrectiveRows {
            gaussian: [keep(3), keep(4), keep(5)],
        };
        let layout = ParameterLayout::new(&topology, &rows);
        let parameters = parameters(&mut random, &layout);
        let views = (0..2).map(|v| view(&mut random, v)).collect();
        Self {
            topology,
            rows,
            layout,
            parameters,
            views,
        }
    }

    fn problem<'a>(&'a self, weights: &'a LossWeights) -> Problem<'a> {
        Problem {
            topology: &self.topology,
            rows: &self.rows,
            layout: &self.layout,
            weights,
            correctives: true,
            cutoff: Cutoff::Smooth,
        }
    }

    /// The loss's slope along a direction, by differences of it.
    fn slope(&self, problem: &Problem, direction: &Parameters<f64>, step: f64) -> f64 {
        let at = |h: f64| {
            let mut moved = self.parameters.clone();
            for (moved, direction) in moved.arrays_mut().into_iter().zip(direction.arrays()) {
                for (moved, direction) in moved.iter_mut().zip(direction) {
                    *moved += h * direction;
                }
            }
            problem.loss(&moved, &self.views)
        };
        (at(step) - at(-step)) / (2.0 * step)
    }
}

fn topology(random: &mut Random, filter: Filter) -> Topology {
    let position = |random: &mut Random| {
        DVec3::new(
            random.range(-0.4, 0.4),
            random.range(-0.4, 0.4),
            random.range(-0.2, 0.2),
        )
    };
    let gaussians: Vec<PlacedGaussian> = (0..GAUSSIANS)
        .map(|k| {
            let weights = [0, 1, 2].map(|_| random.range(0.1, 1.0));
            let sum: f64 = weights.iter().sum();
            PlacedGaussian {
                position: position(random),
                node: std::array::from_fn(|c| ((k + 2 * c) % NODES) as u16),
                node_weight: weights.map(|w| w / sum),
                part: (k * PARTS / GAUSSIANS) as u16,
                joint: [0, 1, 2, 0],
                joint_weight: [100, 100, 55, 0],
                facing: if k % 7 == 3 {
                    facing::NOWHERE
                } else {
                    facing::EVERYWHERE
                },
            }
        })
        .collect();
    let mut followers = vec![Vec::new(); NODES];
    for (k, placed) in gaussians.iter().enumerate() {
        for (&node, &weight) in placed.node.iter().zip(&placed.node_weight) {
            followers[usize::from(node)].push(Follower {
                gaussian: k as u32,
                weight,
            });
        }
    }
    let node_part: Vec<u16> = (0..NODES).map(|s| (s % PARTS) as u16).collect();
    let mut part_nodes = vec![Vec::new(); PARTS];
    for (node, &part) in node_part.iter().enumerate() {
        part_nodes[usize::from(part)].push(node as u32);
    }
    Topology {
        gaussians,
        part_start: vec![0, 10, 20, 30],
        head_parts: 1,
        node_part,
        followers,
        part_nodes,
        widths: vec![8, 6, 5, 2 * BASIS],
        expression_start: 6,
        activation: Activation::LeakyRelu,
        joints: JOINTS,
        filter,
    }
}

fn parameters(random: &mut Random, layout: &ParameterLayout) -> Parameters<f64> {
    let mut parameters = Parameters::zeros(layout);
    for numbers in parameters.gaussians.chunks_exact_mut(GAUSSIAN) {
        for number in &mut numbers[..4] {
            *number = random.normal();
        }
        for number in &mut numbers[4..7] {
            *number = random.range(0.02, 0.12).ln();
        }
        // Some are too faint to be drawn.
        numbers[7] = random.range(-1.0, 2.0) - if random.uniform() < 0.1 { 8.0 } else { 0.0 };
        for number in &mut numbers[8..11] {
            *number = random.range(0.2, 0.8);
        }
    }
    for number in &mut parameters.nodes {
        *number = 0.01 * random.normal();
    }
    for number in parameters.networks.iter_mut() {
        *number = 0.4 * random.normal();
    }
    for number in &mut parameters.bases {
        *number = 0.02 * random.normal();
    }
    parameters
}

/// A view from a side of its own.
fn view(random: &mut Random, number: u32) -> TrainingView {
    let yaw = 0.7 * f64::from(number) - 0.2;
    let pixels = (0..SIZE[0] * SIZE[1])
        .map(|at| {
            let color = [0; 3].map(|_| (random.bits() >> 56) as u8);
            let alpha = [0, 85, 170, 255][at as usize % 4];
            [color[0], color[1], color[2], alpha]
        })
        .collect();
    let behind = (0..SIZE[0] * SIZE[1])
        .map(|at| [77, 153, (at % 100) as u8, 0])
        .collect();
    TrainingView {
        joints: (0..JOINTS)
            .map(|_| {
                let mut joint = DAffine3::from_translation(0.05 * random.direction());
                joint.matrix3.x_axis.y = 0.1 * random.normal();
                joint.matrix3.z_axis.x = 0.1 * random.normal();
                joint
            })
            .collect(),
        input: (0..8).map(|_| random.normal()).collect(),
        camera: Camera::orbit(DVec3::ZERO, yaw, 0.1, 2.0, 0.5, SIZE),
        gain: DVec3::new(1.1, 0.9, 0.95),
        whole: 2 * u64::from(SIZE[0] * SIZE[1]),
        picture: Arc::new(ViewPicture {
            size: SIZE,
            pixels,
            behind,
        }),
    }
}

fn dot(a: &Parameters<f64>, b: &Parameters<f64>) -> f64 {
    let pairs = a.arrays().into_iter().zip(b.arrays());
    pairs
        .map(|(a, b)| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>())
        .sum()
}

/// Large enough weights for every loss to matter.
const WEIGHTS: LossWeights = LossWeights {
    l1: 1.0,
    scale: 0.5,
    scale_above: 0.05,
    correctives: [0.02, 0.1, 0.05],
};

#[test]
fn it_is_the_slope_along_random_directions_of_everything() {
    for (seed, filter) in [
        (1, Filter::DEFAULT),
        (2, Filter::ANTIALIASED),
        (3, Filter::DEFAULT),
    ] {
        let scene = TestScene::new(seed, filter);
        let problem = scene.problem(&WEIGHTS);
        let gradient = problem.gradient(&scene.parameters, &scene.views);
        let mut random = Random::new(seed, 1);
        for _ in 0..6 {
            let mut direction = Parameters::zeros(&scene.layout);
            for array in direction.arrays_mut() {
                for number in array.iter_mut() {
                    *number = 0.1 * random.normal();
                }
            }
            let expected = scene.slope(&problem, &direction, 1e-7);
            let found = dot(&gradient, &direction);
            assert!(
                (found - expected).abs() < 1e-5 * expected.abs().max(1e-3),
                "seed {seed}: the derivative says {found}, the loss {expected}"
            );
        }
    }
}

#[test]
fn it_is_the_slope_of_single_numbers() {
    let scene = TestScene::new(4, Filter::ANTIALIASED);
    let problem = scene.problem(&WEIGHTS);
    let gradient = problem.gradient(&scene.parameters, &scene.views);
    let mut random = Random::new(9, 1);
    for (array, found) in gradient.arrays().into_iter().enumerate() {
        let largest = found.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
        assert!(largest > 0.0, "array {array} has no derivative");
        for _ in 0..60 {
            let at = (random.uniform() * found.len() as f64) as usize;
            let mut direction = Parameters::zeros(&scene.layout);
            direction.arrays_mut()[array][at] = 1.0;
            let expected = scene.slope(&problem, &direction, 1e-6);
            assert!(
                (found[at] - expected).abs() < 2e-5 * largest,
                "number {at} of array {array}: the derivative says {}, the loss {expected}, the largest \
                 is {largest}",
                found[at]
            );
        }
    }
}

#[test]
fn without_correctives_only_neutral_numbers_have_a_derivative() {
    let scene = TestScene::new(5, Filter::DEFAULT);
    let problem = Problem {
        correctives: false,
        ..scene.problem(&WEIGHTS)
    };
    let gradient = problem.gradient(&scene.parameters, &scene.views);
    assert!(
        gradient
            .networks
            .iter()
            .chain(&gradient.bases)
            .all(|&v| v == 0.0)
    );
    let direction = Parameters {
        gaussians: gradient
            .gaussians
            .iter()
            .map(|v| v.signum() * 0.1)
            .collect(),
        nodes: gradient.nodes.iter().map(|v| v.signum() * 0.01).collect(),
        ..Parameters::zeros(&scene.layout)
    };
    let expected = scene.slope(&problem, &direction, 1e-7);
    let found = dot(&gradient, &direction);
    assert!(
        (found - expected).abs() < 1e-5 * expected.abs(),
        "{found}, expected {expected}"
    );
}

#[test]
fn a_gain_has_the_slope_of_the_loss() {
    let scene = TestScene::new(6, Filter::DEFAULT);
    let problem = scene.problem(&WEIGHTS);
    let view = &scene.views[0];
    let forward = problem.forward(&scene.parameters, view);
    let found = problem.gain_gradient(&forward.canvas, view);
    for channel in 0..3 {
        let at = |h: f64| {
            let mut moved = view.clone();
            moved.gain[channel] += h;
            problem.loss(&scene.parameters, &[moved])
        };
        let expected = (at(1e-6) - at(-1e-6)) / 2e-6;
        assert!(
            (found[channel] - expected).abs() < 1e-5 * expected.abs().max(1e-3),
            "{found}, expected {expected} in channel {channel}"
        );
    }
}

#[test]
fn joints_have_the_slope_of_differences() {
    let scene = TestScene::new(5, Filter::ANTIALIASED);
    let problem = scene.problem(&WEIGHTS);
    let view = &scene.views[0];
    let forward = problem.forward(&scene.parameters, view);
    let of_canvas = problem.picture_loss_backward(&forward.canvas, view);
    let found = problem.joints_gradient(view, &forward, &of_canvas);
    let mut random = Random::new(77, 0);
    for _ in 0..4 {
        let direction: Vec<[f64; 12]> = (0..JOINTS)
            .map(|_| [(); 12].map(|()| random.normal()))
            .collect();
        let at = |h: f64| {
            let mut moved = view.clone();
            for (joint, along) in moved.joints.iter_mut().zip(&direction) {
                let mut own = joint.to_cols_array();
                for (own, along) in own.iter_mut().zip(along) {
                    *own += h * along;
                }
                *joint = DAffine3::from_cols_array(&own);
            }
            problem.picture_loss(&problem.forward(&scene.parameters, &moved).canvas, &moved)
        };
        let step = 1e-6;
        let expected = (at(step) - at(-step)) / (2.0 * step);
        let slope: f64 = found
            .iter()
            .zip(&direction)
            .map(|(of, along)| {
                let of = of.to_cols_array();
                of.iter().zip(along).map(|(a, b)| a * b).sum::<f64>()
            })
            .sum();
        assert!(
            (slope - expected).abs() < 1e-5 * expected.abs(),
            "{slope}, expected {expected}"
        );
    }
}
