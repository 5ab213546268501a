//! One stress case on a device: a case goes in, what its pictures were like and all that was wrong with them comes out.

use super::{
    case::Case,
    family::{Bound, Family},
    refusal,
};
use crate::{
    bake::math::{Random, hash},
    frame::{Camera, Picture, Posed},
    measure::error::{self, Error},
    reference,
    vulkan::{self, Gpu, Renderer, instance::validation_messages},
};
use glam::DVec3;
use std::{
    sync::Arc,
    time::{Duration, Instant},
};

/// The longest that a case's three frames may take, set-up included: what takes longer hangs. Compiling a kernel at 512 bits has taken
/// lavapipe half a minute beside other work.
const LIMIT: Duration = Duration::from_secs(90);
/// Where the oracle covers nothing a device may still round to this much.
const UNCOVERED: f64 = 1.5 / 255.0;

/// By how much of themselves f32 and 16-bit quaternions leave a network's inputs, its features and the rotations open.
const ROUNDING: f64 = 4e-6;
/// How far below that an ill-posed case may fall, dB.
const ILL_POSED: f64 = 10.0;

/// What came of a case.
pub struct Outcome {
    /// Device time and set-up, the reference's not.
    pub time: Duration,
    /// Against the reference; none where drawing was to be refused or failed.
    pub error: Option<Error>,
    /// Of the device's arithmetic alone: against the reference's picture of the model as device memory holds it.
    pub arithmetic: Option<Error>,
    pub bound: Bound,
    /// Of the reference against itself with its numbers moved by [`ROUNDING`], dB, where the arithmetic left its bound: what is no better
    /// determined than that has no picture to be compared with, and is only held to [`ILL_POSED`] dB below it.
    pub conditioned_db: Option<f64>,
    /// Everything that was wrong, a sentence each.
    pub faults: Vec<String>,
    /// Of the picture's bits.
    pub digest: u64,
    /// The device can't be used any longer.
    pub lost: bool,
    /// The device's picture and the reference's.
    pub pictures: Option<[Picture; 2]>,
}

/// Draws a case and judges it.
pub fn run(gpu: &Arc<Gpu>, case: &Case) -> Outcome {
    let complaints = validation_messages();
    let mut outcome = Outcome {
        time: Duration::ZERO,
        error: None,
        arithmetic: None,
        bound: case.family.bound(case),
        conditioned_db: None,
        faults: vec![],
        digest: 0,
        lost: false,
        pictures: None,
    };
    let start = Instant::now();
    let drawn = if case.family == Family::Refused { refusal::run(gpu, case, &mut outcome.faults) } else { draw(gpu, case) };
    outcome.time = start.elapsed();
    match drawn {
        Ok(pictures) => judge(case, pictures, &mut outcome),
        Err(error) => {
            outcome.lost = matches!(error, vulkan::Error::DeviceLost(_) | vulkan::Error::Timeout { .. });
            outcome.faults.push(format!("drawing failed: {error}"));
        }
    }
    if outcome.time > LIMIT {
        outcome.faults.push(format!("it took {:.1} s, {} s are allowed", outcome.time.as_secs_f64(), LIMIT.as_secs()));
    }
    if validation_messages() != complaints {
        outcome.faults.push("the validation layer complained, see above".into());
    }
    outcome
}

/// The same frame twice, with another one between, so that nothing of the second can be left from the first.
fn draw(gpu: &Arc<Gpu>, case: &Case) -> vulkan::Result<[Picture; 2]> {
    let mut renderer = Renderer::new(gpu, &case.avatar, case.options)?;
    renderer.draw(&case.posed, &case.camera, None)?;
    let first = renderer.picture()?;
    let (posed, camera) = elsewhere(case);
    renderer.draw(&posed, &camera, None)?;
    renderer.draw(&case.posed, &case.camera, None)?;
    Ok([first, renderer.picture()?])
}

/// Another pose, seen from another side.
fn elsewhere(case: &Case) -> (Posed, Camera) {
    let mut posed = case.posed.clone();
    posed.input.iter_mut().for_each(|input| *input = 0.5 - *input);
    let mut camera = case.camera;
    camera.view.translation += DVec3::new(0.1, -0.2, 0.3) * camera.near;
    (posed, camera)
}

fn judge(case: &Case, [first, second]: [Picture; 2], outcome: &mut Outcome) {
    let oracle = reference::render(&case.avatar, &case.posed, &case.camera);
    outcome.digest = digest(&first);
    let Outcome { faults, bound, conditioned_db, .. } = outcome;
    let place = |at: usize| (at % first.size[0] as usize, at / first.size[0] as usize);
    if let Some(at) = first.pixels.iter().position(|pixel| pixel.iter().any(|v| !v.is_finite())) {
        faults.push(format!("pixel {:?} is {:?}", place(at), first.pixels[at]));
    }
    // One step of f16 above 1 is rounding.
    if let Some(at) = first.pixels.iter().position(|pixel| pixel.iter().any(|v| !(0.0..=1.001).contains(v))) {
        faults.push(format!("pixel {:?} is out of range: {:?}", place(at), first.pixels[at]));
    }
    if let Some(at) = (0..first.pixels.len()).find(|&at| first.pixels[at].map(f32::to_bits) != second.pixels[at].map(f32::to_bits)) {
        faults.push(format!("drawn again, pixel {:?} is {:?} instead of {:?}", place(at), second.pixels[at], first.pixels[at]));
    }
    let error = error::between(&first, &oracle);
    let stored = reference::render_stored(&case.avatar, &case.posed, &case.camera);
    let arithmetic = error::between(&first, &stored);
    let inside = |bound: &Bound| arithmetic.covered.psnr_db >= bound.psnr_db && arithmetic.covered.max_error <= bound.max_error;
    if !inside(bound) {
        let moved = conditioned(case, &oracle);
        *conditioned_db = Some(moved);
        *bound = if moved - ILL_POSED < bound.psnr_db { Bound { psnr_db: moved - ILL_POSED, max_error: 1.0, ..*bound } } else { *bound };
    }
    if !inside(bound) {
        faults.push(format!(
            "arithmetic: {:.2} dB and {:.4} at most over {} covered pixels; {:.2} dB and {:.4} are the bounds",
            arithmetic.covered.psnr_db, arithmetic.covered.max_error, arithmetic.covered.pixels, bound.psnr_db, bound.max_error
        ));
    }
    if error.covered.psnr_db < bound.model_db.min(bound.psnr_db) {
        faults.push(format!("with the model's rounding: {:.2} dB, {:.2} dB is the bound", error.covered.psnr_db, bound.model_db));
    }
    let empty = oracle.pixels.iter().all(|pixel| *pixel == [0.0; 4]);
    // Where no decibel is asked for, neither is what lands in the picture.
    if empty && error.whole.max_error > UNCOVERED && bound.model_db > 0.0 {
        faults.push(format!("the reference's picture is empty and this one differs by {:.4}", error.whole.max_error));
    }
    outcome.error = Some(error);
    outcome.arithmetic = Some(arithmetic);
    outcome.pictures = Some([first, oracle]);
}

/// PSNR of the reference's picture against the one that it draws when its numbers are moved by [`ROUNDING`], dB: the worst of three.
fn conditioned(case: &Case, oracle: &Picture) -> f64 {
    let worst = (0..3u64).map(|round| {
        let random = &mut Random::new(case.number, round);
        let mut moved = |values: &mut [f64]| values.iter_mut().for_each(|v| *v *= 1.0 + random.range(-ROUNDING, ROUNDING));
        let mut posed = case.posed.clone();
        moved(&mut posed.input);
        let mut features = reference::features::features(&case.avatar, &posed.input);
        moved(&mut features);
        let nodes = reference::nodes::nodes(&case.avatar, &features);
        let gaussians = reference::splats::gaussians(&case.avatar, &posed, &features, &nodes);
        error::between(&reference::render_gaussians(&gaussians, &case.camera), oracle).covered.psnr_db
    });
    worst.fold(f64::INFINITY, f64::min)
}

fn digest(picture: &Picture) -> u64 {
    picture.pixels.iter().flatten().fold(hash(u64::from(picture.size[0])), |sum, value| hash(sum ^ u64::from(value.to_bits())))
}
