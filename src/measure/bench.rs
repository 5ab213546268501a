//! The benchmark: an avatar, a clip and a device go in; time, error, memory and bytes come out.
//!
//! Every frame has a new pose, evenly spread over the clip, and one of some views in turn, so nothing is skipped. Two frames are in
//! flight, as in use. Frame time is the time from one frame's hand-over to the next, which in a steady state is what a frame takes.

use super::{bytes, error};
use crate::{
    avatar::{Avatar, motion::Player},
    frame::{Camera, Extent, Posed, Skip},
    reference,
    vulkan::{Gpu, Renderer, RendererOptions, Result},
};
use serde::Serialize;
use std::{sync::Arc, time::Instant};

/// Frames drawn before the clock starts.
const WARM_UP: usize = 3;

/// What to measure.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    /// Frames to time, at least 1.
    pub frames: usize,
    /// Views around the avatar, used in turn, at least 1.
    pub views: usize,
    /// How many of the frames to compare with the reference, spread evenly.
    pub checked: usize,
}

/// Median and 95th percentile, ms.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Spread {
    pub median: f64,
    pub p95: f64,
}

impl Spread {
    /// Of at least one sample.
    fn of(mut samples: Vec<f64>) -> Self {
        samples.sort_by(f64::total_cmp);
        let at = |share: f64| samples[((samples.len() - 1) as f64 * share).round() as usize];
        Self { median: at(0.5), p95: at(0.95) }
    }
}

#[derive(Clone, Debug, Serialize)]
pub struct Stage {
    pub name: &'static str,
    /// Median over the frames.
    pub ms: f64,
    /// Counted, not measured: see [`bytes`].
    pub bytes: u64,
}

/// What the benchmark found; its fields are the JSON's.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    pub device: String,
    pub driver: String,
    pub avatar: String,
    pub gaussians: usize,
    /// Median number that survived culling.
    pub drawn: u64,
    pub size: [u32; 2],
    pub color: String,
    pub half_storage: bool,
    pub frames: usize,
    pub frame_ms: Spread,
    /// GPU time of all stages together. Null without timestamps.
    pub gpu_ms: Option<Spread>,
    pub stages: Vec<Stage>,
    /// Frames that were compared with the reference.
    pub checked_frames: usize,
    /// Worst of the checked frames over covered pixels.
    pub psnr_db: Option<f64>,
    pub max_error: Option<f64>,
    pub within_tolerance: Option<f64>,
    /// The same over whole pictures, empty background included.
    pub psnr_db_whole_picture: Option<f64>,
    pub max_error_whole_picture: Option<f64>,
    /// Blocks that the program took from the driver.
    pub gpu_memory_bytes: u64,
    /// What of them is in use.
    pub gpu_memory_used_bytes: u64,
    pub bytes_per_frame: u64,
}

/// Tells how far a measurement is: what is being done, and how many of how many.
pub type Progress<'a> = &'a mut dyn FnMut(&'static str, usize, usize);

/// Measures. `cameras` have the picture's size and are used in turn, instead of views around the avatar; may be empty.
pub fn run(
    gpu: &Arc<Gpu>,
    avatar: &Avatar,
    player: &Player,
    options: RendererOptions,
    (case, cameras): (Case, &[Camera]),
    progress: Progress,
) -> Result<Report> {
    let mut renderer = Renderer::new(gpu, avatar, RendererOptions { skip: options.skip - Skip::FRAME, ..options })?;
    let extent = Extent::new(avatar);
    let mut scenes: Vec<_> = (0..case.frames).map(|frame| scene(avatar, player, &extent, options.size, (frame, case))).collect();
    scenes.iter_mut().zip(cameras.iter().cycle()).for_each(|(scene, camera)| scene.1 = *camera);
    let (intervals, reports) = time(&mut renderer, &scenes, progress)?;
    let mut drawn: Vec<u64> = reports.iter().map(|report| report.counters.drawn).collect();
    drawn.sort_unstable();
    let drawn = drawn[drawn.len() / 2];
    let (used, reserved) = gpu.memory();
    let errors = check(avatar, &mut renderer, &scenes, case.checked, progress)?;
    let worst = |of: fn(&error::Error) -> f64, worse: fn(f64, f64) -> f64| errors.iter().map(of).reduce(worse);
    let bytes = bytes::per_stage(avatar, &options, drawn);
    let stages = bytes.iter().map(|&(name, bytes)| {
        let times =
            reports.iter().filter_map(|report| report.stages.iter().find(|stage| stage.0 == name)).map(|stage| stage.1).collect::<Vec<_>>();
        Stage { name, ms: if times.is_empty() { f64::NAN } else { Spread::of(times).median }, bytes }
    });
    Ok(Report {
        device: gpu.probe.name.clone(),
        driver: gpu.probe.driver.clone(),
        avatar: avatar.name.clone(),
        gaussians: avatar.gaussians.len(),
        drawn,
        size: options.size,
        color: format!("{:?}", options.color),
        half_storage: gpu.half_storage,
        frames: case.frames,
        frame_ms: Spread::of(intervals),
        gpu_ms: (gpu.probe.timestamp_bits > 0).then(|| Spread::of(reports.iter().map(|report| report.gpu_ms()).collect())),
        stages: stages.collect(),
        checked_frames: errors.len(),
        psnr_db: worst(|e| e.covered.psnr_db, f64::min),
        max_error: worst(|e| e.covered.max_error, f64::max),
        within_tolerance: worst(|e| e.covered.within_tolerance, f64::min),
        psnr_db_whole_picture: worst(|e| e.whole.psnr_db, f64::min),
        max_error_whole_picture: worst(|e| e.whole.max_error, f64::max),
        gpu_memory_bytes: reserved,
        gpu_memory_used_bytes: used,
        bytes_per_frame: bytes.iter().map(|(_, bytes)| bytes).sum(),
    })
}

type Scene = (Posed, Camera);

fn scene(avatar: &Avatar, player: &Player, extent: &Extent, size: [u32; 2], (frame, case): (usize, Case)) -> Scene {
    let seconds = player.clip().duration() * frame as f64 / case.frames as f64;
    let posed = Posed::new(avatar, &player.pose(seconds));
    let bounds = super::upright(extent.bounds(&posed.joints));
    let (fov, yaw) = (35f64.to_radians(), std::f64::consts::TAU * (0.05 + (frame % case.views) as f64 / case.views as f64));
    let camera = Camera::orbit((bounds[0] + bounds[1]) / 2.0, yaw, 0.09, Camera::framing_distance(bounds, fov, size), fov, size);
    (posed, camera)
}

/// Draws the scenes, and gives the time of each and what it said of itself.
fn time(renderer: &mut Renderer, scenes: &[Scene], progress: Progress) -> Result<(Vec<f64>, Vec<crate::vulkan::commands::FrameReport>)> {
    for (posed, camera) in scenes.iter().cycle().take(WARM_UP) {
        renderer.draw(posed, camera, None)?;
    }
    renderer.finish()?;
    let (mut intervals, mut reports) = (Vec::new(), Vec::new());
    // A frame is over when its slot is free again, a few hand-overs later; until the pipeline is full, hand-overs come at another pace.
    let filling = 2 * crate::vulkan::commands::SLOTS;
    let mut last = Instant::now();
    for at in 0..scenes.len() + filling {
        let (posed, camera) = &scenes[at % scenes.len()];
        renderer.draw(posed, camera, None)?;
        let now = Instant::now();
        if at >= filling {
            intervals.push((now - last).as_secs_f64() * 1e3);
            reports.push(renderer.report().clone());
            progress("timing", reports.len(), scenes.len());
        }
        last = now;
    }
    renderer.finish()?;
    Ok((intervals, reports))
}

fn check(avatar: &Avatar, renderer: &mut Renderer, scenes: &[Scene], count: usize, progress: Progress) -> Result<Vec<error::Error>> {
    let count = count.min(scenes.len());
    let mut errors = Vec::new();
    for at in 0..count {
        let (posed, camera) = &scenes[at * scenes.len() / count];
        renderer.draw(posed, camera, None)?;
        errors.push(error::between(&renderer.picture()?, &reference::render(avatar, posed, camera)));
        progress("comparing with the reference", at + 1, count);
    }
    Ok(errors)
}
