//! Draws scenes against the clock: an avatar, a setting and scenes go in; a time and a report for
//! each frame come out.
//!
//! Two frames are in flight, as in use. Frame time is the time from one frame's submission to the
//! next, which in a steady state is the time that a frame takes.

use super::{
    backend::{BenchDevice, BenchRenderer, Result},
    case::BenchCase,
    scene::BenchScene,
};
use crate::{WARM_UP, setting::RenderSetting};
use effigy::vulkan::{FRAMES_IN_FLIGHT, Gpu, GpuOptions, sort::choice};
#[cfg(feature = "webgpu")]
use effigy::webgpu;
use effigy_core::{
    avatar::Avatar,
    frame::{FrameReport, RendererOptions},
    scene::FrameImage,
};
use std::time::Instant;

/// Called with what is being done, how many steps of it are done, and how many there are.
pub type Progress<'a> = &'a mut dyn FnMut(&str, usize, usize);

/// The backend to draw with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Backend {
    /// Vulkan.
    #[default]
    Vulkan,
    /// WebGPU.
    #[cfg(feature = "webgpu")]
    WebGpu,
}

/// Opens the device that a benchmark draws with.
///
/// # Errors
/// When it can't be opened.
pub fn open(backend: Backend, options: &GpuOptions) -> Result<BenchDevice> {
    match backend {
        Backend::Vulkan => {
            let gpu = Gpu::new(options)?;
            // A measurement is of the fastest sort: it is worth the wait.
            choice::choose(&gpu)?;
            Ok(BenchDevice::Vulkan(gpu))
        }
        #[cfg(feature = "webgpu")]
        Backend::WebGpu => Ok(BenchDevice::WebGpu(webgpu::Gpu::open(
            options.device.as_deref(),
        )?)),
    }
}

/// Draws the scenes of a case.
pub struct CaseRenderer {
    renderer: BenchRenderer,
}

impl CaseRenderer {
    /// A renderer of an avatar that the setting has [reduced](RenderSetting::reduce). `count`:
    /// whether to count fragments and Gaussians too, which takes time.
    ///
    /// # Errors
    /// When the device can't draw it.
    pub fn new(
        gpu: &BenchDevice,
        avatar: &Avatar,
        setting: &RenderSetting,
        case: BenchCase,
        count: bool,
    ) -> Result<Self> {
        let options = RendererOptions {
            instances: case.instances(),
            count,
            ..setting.options
        };
        Ok(Self {
            renderer: BenchRenderer::new(gpu, avatar, options)?,
        })
    }

    /// Submits a frame, unless nothing has changed.
    ///
    /// # Errors
    /// When the device fails.
    pub fn draw(&mut self, scene: &BenchScene) -> Result<()> {
        self.renderer.draw(scene)
    }

    /// Waits for every submitted frame.
    ///
    /// # Errors
    /// When the device fails.
    pub fn finish(&mut self) -> Result<()> {
        self.renderer.finish()
    }

    /// Waits and copies the last frame's image.
    ///
    /// # Errors
    /// When the device fails.
    pub fn image(&mut self) -> Result<FrameImage> {
        self.renderer.image()
    }

    /// The options that it draws with, resolved.
    pub fn options(&self) -> &RendererOptions {
        self.renderer.options()
    }
}

/// Timings of some frames, one entry each.
#[derive(Default)]
pub struct Samples {
    /// Frame times, ms.
    pub intervals: Vec<f64>,
    /// Times and counts.
    pub reports: Vec<FrameReport>,
}

/// Times the scenes after drawing `warm_up` frames, or more until [`WARM_UP`] has passed. `tick` is
/// called with the number of frames timed so far.
///
/// # Errors
/// When the device fails.
pub fn time(
    renderer: &mut CaseRenderer,
    scenes: &[BenchScene],
    warm_up: usize,
    mut tick: impl FnMut(usize),
) -> Result<Samples> {
    let begin = Instant::now();
    for (frame, scene) in scenes.iter().cycle().enumerate() {
        if frame >= warm_up && begin.elapsed() >= WARM_UP {
            break;
        }
        renderer.draw(scene)?;
    }
    renderer.finish()?;
    let mut samples = Samples::default();
    // Until the pipeline is full, submissions don't wait for the device.
    let untimed = 2 * FRAMES_IN_FLIGHT;
    let mut last = Instant::now();
    for frame in 0..scenes.len() + untimed {
        renderer.draw(&scenes[frame % scenes.len()])?;
        let now = Instant::now();
        if frame >= untimed {
            samples.intervals.push((now - last).as_secs_f64() * 1e3);
            samples.reports.push(renderer.renderer.report().clone());
            tick(samples.reports.len());
        }
        last = now;
    }
    renderer.finish()?;
    Ok(samples)
}

/// Draws the scenes one at a time and returns the counts of each. `tick` is called with the number
/// of frames counted so far.
///
/// # Errors
/// When the device fails.
pub fn count(
    renderer: &mut CaseRenderer,
    scenes: &[BenchScene],
    mut tick: impl FnMut(usize),
) -> Result<Vec<FrameReport>> {
    // The first frame reuses results of the frame before too, as it does when frames are timed.
    if let Some(scene) = scenes.last() {
        renderer.draw(scene)?;
    }
    let mut reports = Vec::with_capacity(scenes.len());
    for scene in scenes {
        renderer.finish()?;
        renderer.draw(scene)?;
        renderer.finish()?;
        reports.push(renderer.renderer.report().clone());
        tick(reports.len());
    }
    Ok(reports)
}
