//! One stress case on a device: a case goes in; the errors of its image and everything that is
//! wrong with it come out.

use super::{bound::ErrorBound, case::StressCase, category::Category, refusal};
use crate::error::{self, ErrorMetrics};
use effigy::vulkan::{self, Gpu, Renderer, instance::validation_messages};
use effigy_core::{
    frame::KeyBits,
    random::{Random, hash},
    reference,
    scene::{AvatarBounds, Camera, FrameImage, Posed},
};
use glam::DVec3;
use std::{
    sync::Arc,
    time::{Duration, Instant},
};

/// The longest time for a case's three frames, set-up included; longer counts as a hang. Compiling
/// a kernel at 512 bits has taken lavapipe half a minute beside other work.
const LIMIT: Duration = Duration::from_secs(90);
/// Largest error where the reference covers nothing: a device may round that much.
const UNCOVERED: f64 = 1.5 / 255.0;
/// Largest value of a channel: one step of f16 above 1 is rounding.
const MAX_CHANNEL: f32 = 1.001;

/// Relative error that f32 and 16-bit quaternions leave in a network's inputs, its features and the
/// rotations.
const ROUNDING: f64 = 4e-6;
/// Relative error of a depth in f32: the translation of the joint's matrix is rounded, and so is
/// each of the three sums that follow.
const DEPTH_ROUNDING: f64 = 2.0 * f32::EPSILON as f64;
/// Error of a key, 0 to 1, in f32: a difference, two products and a sum.
const KEY_ROUNDING: f64 = 2.0 * f32::EPSILON as f64;
/// How far an ill-posed case may be below its conditioning, dB.
const ILL_POSED: f64 = 10.0;

/// The result of drawing a case.
pub struct CaseOutcome {
    /// Time on the device with set-up, without the reference's.
    pub time: Duration,
    /// Against the reference. None if the case could not be drawn.
    pub error: Option<ErrorMetrics>,
    /// Of the device's arithmetic alone: against the reference's image of the model as device
    /// memory holds it.
    pub arithmetic: Option<ErrorMetrics>,
    /// The bound that it was held to.
    pub bound: ErrorBound,
    /// PSNR of the reference against itself with its numbers changed by 4e-6 each and its depths by
    /// what f32 and the keys round, dB. Computed if the arithmetic exceeds its bound: an image that
    /// is no better determined than that has nothing to be compared with, and is only held to 10 dB
    /// below it.
    pub conditioned_db: Option<f64>,
    /// A sentence for everything that is wrong.
    pub faults: Vec<String>,
    /// Hash of the image's bits.
    pub digest: u64,
    /// Whether the device can't be used any longer.
    pub lost: bool,
    /// The device's image and the reference's.
    pub images: Option<[FrameImage; 2]>,
}

/// Draws a case and checks it.
pub fn check_case(gpu: &Arc<Gpu>, case: &StressCase) -> CaseOutcome {
    let messages_before = validation_messages();
    let mut outcome = CaseOutcome {
        time: Duration::ZERO,
        error: None,
        arithmetic: None,
        bound: ErrorBound::for_case(case),
        conditioned_db: None,
        faults: vec![],
        digest: 0,
        lost: false,
        images: None,
    };
    let start = Instant::now();
    let drawn = if case.category == Category::Refused {
        refusal::run(gpu, case, &mut outcome.faults)
    } else {
        draw_twice(gpu, case)
    };
    outcome.time = start.elapsed();
    match drawn {
        Ok([first, second]) => outcome.check_images(case, first, &second),
        Err(error) => {
            outcome.lost = matches!(
                error,
                vulkan::Error::DeviceLost(_) | vulkan::Error::Timeout { .. }
            );
            outcome.faults.push(format!("drawing failed: {error}"));
        }
    }
    if outcome.time > LIMIT {
        outcome.faults.push(format!(
            "it took {:.1} s, {} s are allowed",
            outcome.time.as_secs_f64(),
            LIMIT.as_secs()
        ));
    }
    if validation_messages() != messages_before {
        outcome
            .faults
            .push("the validation layer complained, see above".into());
    }
    outcome
}

/// The case's frame drawn twice, with another one between, so that the second can't reuse anything
/// of the first.
fn draw_twice(gpu: &Arc<Gpu>, case: &StressCase) -> vulkan::Result<[FrameImage; 2]> {
    let mut renderer = Renderer::new(gpu, &case.avatar, case.options)?;
    renderer.draw(&case.posed, &case.camera, None)?;
    let first = renderer.read_image()?;
    renderer.draw(&other_pose(case), &other_camera(case), None)?;
    renderer.draw(&case.posed, &case.camera, None)?;
    Ok([first, renderer.read_image()?])
}

fn other_pose(case: &StressCase) -> Posed {
    let mut posed = case.posed.clone();
    for input in &mut posed.input {
        *input = 0.5 - *input;
    }
    posed
}

fn other_camera(case: &StressCase) -> Camera {
    let mut camera = case.camera;
    camera.view.translation += DVec3::new(0.1, -0.2, 0.3) * camera.near;
    camera
}

impl CaseOutcome {
    fn check_images(&mut self, case: &StressCase, first: FrameImage, second: &FrameImage) {
        self.digest = digest(&first);
        self.faults.extend(pixel_faults(&first, second));

        let reference = reference::render(&case.avatar, &case.posed, &case.camera);
        let stored = reference::render_stored(&case.avatar, &case.posed, &case.camera);
        let error = error::between(&first, &reference);
        let arithmetic = error::between(&first, &stored);
        if !self.is_within_bound(&arithmetic) {
            self.relax_bound(conditioning(case, &reference));
        }
        if !self.is_within_bound(&arithmetic) {
            self.faults.push(format!(
                "arithmetic: {:.2} dB and {:.4} at most over {} covered pixels; {:.2} dB and {:.4} are the bounds",
                arithmetic.covered.psnr_db,
                arithmetic.covered.max_error,
                arithmetic.covered.pixels,
                self.bound.psnr_db,
                self.bound.max_error
            ));
        }
        if error.covered.psnr_db < self.bound.model_db.min(self.bound.psnr_db) {
            self.faults.push(format!(
                "with the model's rounding: {:.2} dB, {:.2} dB is the bound",
                error.covered.psnr_db, self.bound.model_db
            ));
        }
        let is_empty = reference.pixels.iter().all(|pixel| *pixel == [0.0; 4]);
        // A category without a bound of the PSNR has none of what it may cover either.
        if is_empty && error.whole.max_error > UNCOVERED && self.bound.model_db > 0.0 {
            self.faults.push(format!(
                "the reference's image is empty and this one differs by {:.4}",
                error.whole.max_error
            ));
        }
        self.error = Some(error);
        self.arithmetic = Some(arithmetic);
        self.images = Some([first, reference]);
    }

    fn is_within_bound(&self, arithmetic: &ErrorMetrics) -> bool {
        arithmetic.covered.psnr_db >= self.bound.psnr_db
            && arithmetic.covered.max_error <= self.bound.max_error
    }

    /// Lowers the bound of a case that is conditioned to this PSNR only.
    fn relax_bound(&mut self, conditioned_db: f64) {
        self.conditioned_db = Some(conditioned_db);
        if conditioned_db - ILL_POSED < self.bound.psnr_db {
            self.bound.psnr_db = conditioned_db - ILL_POSED;
            self.bound.max_error = 1.0;
        }
    }
}

/// Values out of range in the first image, and differences of the second.
fn pixel_faults(first: &FrameImage, second: &FrameImage) -> Vec<String> {
    let width = first.size[0] as usize;
    let place = |index: usize| (index % width, index / width);
    let find = |is_bad: fn(&f32) -> bool| {
        let has_bad = |pixel: &[f32; 4]| pixel.iter().any(is_bad);
        first.pixels.iter().position(has_bad)
    };
    let mut faults = Vec::new();
    if let Some(index) = find(|v| !v.is_finite()) {
        let pixel = first.pixels[index];
        faults.push(format!("pixel {:?} is {pixel:?}", place(index)));
    }
    if let Some(index) = find(|v| !(0.0..=MAX_CHANNEL).contains(v)) {
        let pixel = first.pixels[index];
        faults.push(format!(
            "pixel {:?} is out of range: {pixel:?}",
            place(index)
        ));
    }
    let bits = |pixel: [f32; 4]| pixel.map(f32::to_bits);
    let mut pairs = first.pixels.iter().zip(&second.pixels);
    if let Some(index) = pairs.position(|(a, b)| bits(*a) != bits(*b)) {
        faults.push(format!(
            "drawn again, pixel {:?} is {:?} instead of {:?}",
            place(index),
            second.pixels[index],
            first.pixels[index]
        ));
    }
    faults
}

/// PSNR of the reference's image against the one with its numbers changed by [`ROUNDING`] and its
/// depths by [`depth_rounding`], dB: the worst of three.
fn conditioning(case: &StressCase, reference: &FrameImage) -> f64 {
    let psnr = (0..3).map(|round| {
        let image = render_changed(case, &mut Random::new(case.number, round));
        error::between(&image, reference).covered.psnr_db
    });
    psnr.fold(f64::INFINITY, f64::min)
}

/// How far f32 and the sort's keys may move a Gaussian along the camera's axis, metres: those that
/// are closer together than that may be drawn in either order. `depth`: its own, metres; `range`:
/// the depths between which keys are linear.
fn depth_rounding(depth: f64, range: [f64; 2], keys: KeyBits) -> f64 {
    let key_steps = 1.0 / f64::from(keys.largest()) + KEY_ROUNDING;
    DEPTH_ROUNDING * depth.abs() + key_steps * (range[1] - range[0])
}

/// Changes each value by up to [`ROUNDING`] of it.
fn round(values: &mut [f64], random: &mut Random) {
    for value in values {
        *value *= 1.0 + random.range(-ROUNDING, ROUNDING);
    }
}

/// The reference's image with inputs and features changed by [`ROUNDING`], and depths by
/// [`depth_rounding`].
fn render_changed(case: &StressCase, random: &mut Random) -> FrameImage {
    let mut posed = case.posed.clone();
    round(&mut posed.input, random);
    let mut features = reference::mlp::features(&case.avatar, &posed.input);
    round(&mut features, random);
    let nodes = reference::nodes::nodes(&case.avatar, &features);
    let mut gaussians = reference::project::gaussians(&case.avatar, &posed, &features, &nodes);
    let camera = &case.camera;
    let range = AvatarBounds::new(&case.avatar).depth(&posed.joints, camera);
    let forward = camera.view.matrix3.row(2);
    for gaussian in &mut gaussians {
        let depth = camera.view.transform_point3(gaussian.mean).z;
        let most = depth_rounding(depth, range, case.options.keys());
        gaussian.mean += forward * random.range(-most, most);
    }
    reference::render_gaussians(&gaussians, camera)
}

/// A hash of an image's bits.
fn digest(image: &FrameImage) -> u64 {
    let width = hash(u64::from(image.size[0]));
    let values = image.pixels.iter().flatten();
    values.fold(width, |sum, value| hash(sum ^ u64::from(value.to_bits())))
}
