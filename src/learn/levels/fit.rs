//! Fitting of a level's Gaussians to images of the whole avatar, with Adam.

use super::views::{LevelTarget, LevelView};
use effigy_core::avatar::{Avatar, Level};
use effigy_core::random::Random;
use effigy_core::reference::project;
use effigy_math::splatter::{
    self, Blended, FittedShape, ImageSplat, PosedGaussian, Projection, enlarged, loss_gradient,
    shapes,
};
use glam::{DQuat, DVec3, Vec3};
use half::f16;
use rayon::prelude::*;
use std::borrow::Cow;

/// Images a step.
const BATCH: usize = 4;
/// How far numbers move in a step at first: an offset, of its largest standard deviation; a turn,
/// radians; a log scale; a logit; a colour.
const RATES: [f32; 5] = [0.02, 0.02, 0.02, 0.1, 0.01];
/// Rates fall to this share.
const LAST_RATE: f32 = 0.05;
/// Adam's decay of the means of derivatives and of their squares.
const DECAY: [f32; 2] = [0.9, 0.99];
/// Log scales stay within what f16 and renderers hold.
const LOG_SCALES: [f32; 2] = [-16.0, 9.0];

/// The size of an image and how it is drawn.
#[derive(Clone, Copy, Debug)]
pub struct ImageSize {
    /// Height of the avatar, in units.
    pub units: usize,
    /// Samples a pixel along each axis.
    pub samples: usize,
}

/// How a level is fitted.
#[derive(Clone, Debug)]
pub struct FitOptions {
    /// Steps of the optimiser.
    pub steps: usize,
    /// Sizes of the images.
    pub sizes: Vec<ImageSize>,
    /// Decides the order of images.
    pub seed: u64,
}

/// Adam's running means of a number's derivative and of its square.
#[derive(Clone, Copy, Default)]
struct ShapeMoments {
    first: [f32; FittedShape::NUMBERS],
    second: [f32; FittedShape::NUMBERS],
}

/// The rate of each number of a shape.
fn rates(shape: &FittedShape) -> [f32; FittedShape::NUMBERS] {
    let [offset, turn, scale, logit, color] = RATES;
    FittedShape {
        offset: Vec3::splat(offset * shape.log_scale.max_element().exp()),
        turn: Vec3::splat(turn),
        log_scale: Vec3::splat(scale),
        logit,
        color: Vec3::splat(color),
    }
    .to_array()
}

/// An image to fit to.
struct Card {
    target: usize,
    size: ImageSize,
}

/// All images in a random order, again and again, each time at one of the sizes.
struct Deck<'a> {
    random: Random,
    targets: usize,
    left: Vec<usize>,
    sizes: &'a [ImageSize],
}

impl<'a> Deck<'a> {
    fn new(targets: usize, options: &'a FitOptions) -> Self {
        Self {
            random: Random::new(options.seed, 0),
            targets,
            left: vec![],
            sizes: &options.sizes,
        }
    }

    fn below(&mut self, count: usize) -> usize {
        ((self.random.uniform() * count as f64) as usize).min(count - 1)
    }

    fn draw(&mut self) -> Card {
        if self.left.is_empty() {
            self.left = (0..self.targets).collect();
            for at in (1..self.targets).rev() {
                let other = self.below(at + 1);
                self.left.swap(at, other);
            }
        }
        let size = self.below(self.sizes.len());
        Card {
            target: self.left.pop().unwrap_or_default(),
            size: self.sizes[size],
        }
    }
}

/// The derivative of an image's loss by the numbers of every shape.
type Gradients = Vec<[f32; FittedShape::NUMBERS]>;

fn gradients(
    shapes: &[FittedShape],
    placed: &[PosedGaussian],
    target: &LevelTarget,
    ImageSize { units, samples }: ImageSize,
) -> Gradients {
    let camera = target.view.camera_at(units * samples);
    let projection = Projection::new(&camera, Level::FILTER);
    let splats: Vec<Option<ImageSplat>> = shapes
        .iter()
        .zip(placed)
        .map(|(shape, placed)| projection.splat(shape, placed))
        .collect();
    let blended = Blended::new(&splats, camera.size, |_, _, _| ());
    let image = blended.image.averaged(samples as u32);
    let truth = target.truth(units);
    let covered = truth
        .pixels
        .iter()
        .filter(|p| p[3] >= 1.0 / 255.0)
        .count()
        .max(1);
    let mut by = loss_gradient(&image, &truth);
    let scale = 1.0 / (covered * samples * samples) as f32;
    for number in by.pixels.as_flattened_mut() {
        *number *= scale;
    }
    let by_splat = blended.gradient(&splats, &enlarged(&by, samples as u32));
    let gradient = |k: usize| match splats[k] {
        Some(_) => projection.gradient(&shapes[k], &placed[k], &by_splat[k]),
        None => [0.0; FittedShape::NUMBERS],
    };
    (0..shapes.len()).map(gradient).collect()
}

/// A level's Gaussians in the poses of all targets.
struct LevelInPoses<'a> {
    level: &'a Avatar,
    /// By pose; none where colours depend on the view.
    placed: Vec<Vec<PosedGaussian>>,
}

impl<'a> LevelInPoses<'a> {
    fn new(level: &'a Avatar, targets: &[LevelTarget]) -> Self {
        let mut placed = Vec::new();
        for LevelTarget { view, .. } in targets {
            if level.sh.is_none() && view.pose == placed.len() {
                placed.push(splatter::placed(level, &view.posed, &view.camera));
            }
        }
        Self { level, placed }
    }

    fn placed(&self, view: &LevelView) -> Cow<'_, [PosedGaussian]> {
        match self.placed.get(view.pose) {
            Some(placed) => Cow::Borrowed(placed),
            None => Cow::Owned(splatter::placed(self.level, &view.posed, &view.camera)),
        }
    }
}

/// Fits a level. `progress` is called with the number of steps done.
pub fn fit(
    avatar: &Avatar,
    level: &Level,
    targets: &[LevelTarget],
    options: &FitOptions,
    progress: &mut dyn FnMut(usize),
) -> Level {
    let drawn = avatar.at_level(level);
    let mut shapes = shapes(&drawn);
    let initial = shapes.clone();
    let poses = LevelInPoses::new(&drawn, targets);
    let mut moments = vec![ShapeMoments::default(); shapes.len()];
    let mut deck = Deck::new(targets.len(), options);
    for step in 0..options.steps {
        let batch: Vec<Card> = (0..BATCH).map(|_| deck.draw()).collect();
        let found: Vec<Gradients> = batch
            .par_iter()
            .map(|card| {
                let target = &targets[card.target];
                let placed = poses.placed(&target.view);
                gradients(&shapes, &placed, target, card.size)
            })
            .collect();
        let share = step as f32 / options.steps as f32;
        let slower = LAST_RATE.powf(share);
        let correction = DECAY.map(|decay| 1.0 - decay.powi(step as i32 + 1));
        shapes
            .par_iter_mut()
            .zip(&mut moments)
            .enumerate()
            .for_each(|(k, (shape, moments))| {
                let mut numbers = shape.to_array();
                let rates = rates(&initial[k]);
                for (n, number) in numbers.iter_mut().enumerate() {
                    let by: f32 = found.iter().map(|one| one[k][n]).sum();
                    let by = if by.is_finite() { by } else { 0.0 };
                    let first = &mut moments.first[n];
                    *first = DECAY[0] * *first + (1.0 - DECAY[0]) * by;
                    let second = &mut moments.second[n];
                    *second = DECAY[1] * *second + (1.0 - DECAY[1]) * by * by;
                    let step =
                        (*first / correction[0]) / ((*second / correction[1]).sqrt() + 1e-12);
                    *number -= slower * rates[n] * step;
                }
                *shape = FittedShape::from_array(numbers);
            });
        progress(step + 1);
    }
    store(avatar, level, &shapes)
}

/// The level with fitted shapes.
fn store(avatar: &Avatar, level: &Level, shapes: &[FittedShape]) -> Level {
    let mut level = level.clone();
    let gaussians = &mut level.gaussians;
    for (k, shape) in shapes.iter().enumerate() {
        let rotation = project::rotation(gaussians.rotation[k].map(f64::from), [0.0; 4]);
        let bounds = avatar.gaussians.bounds;
        let position = bounds.decode(gaussians.position[k]) + rotation * shape.offset.as_dvec3();
        gaussians.position[k] = bounds.encode(position);
        let turned = (rotation * DQuat::from_scaled_axis(shape.turn.as_dvec3())).normalize();
        gaussians.rotation[k] = [turned.w, turned.x, turned.y, turned.z].map(f16::from_f64);
        gaussians.log_scale[k] = shape
            .log_scale
            .clamp(Vec3::splat(LOG_SCALES[0]), Vec3::splat(LOG_SCALES[1]))
            .to_array()
            .map(f16::from_f32);
        gaussians.opacity[k] = (255.0 * shape.opacity()).round() as u8;
        let color: DVec3 = shape.color.as_dvec3();
        gaussians.color[k] = color.to_array().map(f16::from_f64);
    }
    level
}
