//! Frames of a case: a device draws its scenes, on the clock or one at a time to be counted. The
//! only place of the benchmark that calls a backend.

use super::case::{BenchCase, BenchScene, BenchTask};
use crate::{
    WARM_UP,
    report::{DeviceReport, ErrorReport},
    setting::RenderSetting,
    {error, flip},
};
use effigy_core::{
    avatar::Avatar,
    constants::ALPHA_MIN,
    frame::{FrameReport, Person, RendererOptions},
    scene::FrameImage,
};
use effigy_render::vulkan::{self, FRAMES_IN_FLIGHT, GpuOptions, sort::choice};
#[cfg(feature = "webgpu")]
use effigy_render::webgpu;
use std::{sync::Arc, time::Instant};

/// Frames that are drawn before the clock starts, at least.
const WARM_UP_FRAMES: usize = 3;

/// A result with an error of either backend.
pub type Result<T> = std::result::Result<T, BackendError>;

/// Called with what is being done, how many steps of it are done, and how many there are.
pub type Progress<'a> = &'a mut dyn FnMut(&str, usize, usize);

/// An error of either backend.
#[derive(Debug, thiserror::Error)]
pub enum BackendError {
    /// By the Vulkan backend.
    #[error(transparent)]
    Vulkan(#[from] vulkan::Error),
    /// By the WebGPU backend.
    #[cfg(feature = "webgpu")]
    #[error(transparent)]
    WebGpu(#[from] webgpu::Error),
}

/// Does the same with what either backend has.
macro_rules! either {
    ($of:expr, $own:pat => $do:expr) => {
        match $of {
            Self::Vulkan($own) => $do,
            #[cfg(feature = "webgpu")]
            Self::WebGpu($own) => $do,
        }
    };
}

impl BackendError {
    /// Whether the device refuses a setting and can still draw with others.
    pub fn is_refusal(&self) -> bool {
        match self {
            Self::Vulkan(vulkan::Error::Timeout { .. } | vulkan::Error::DeviceLost(_)) => false,
            #[cfg(feature = "webgpu")]
            Self::WebGpu(webgpu::Error::Timeout { .. } | webgpu::Error::DeviceLost(_)) => false,
            _ => true,
        }
    }
}

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

/// An open device of either backend.
#[derive(Clone)]
pub enum BenchDevice {
    /// Opened by the Vulkan backend.
    Vulkan(Arc<vulkan::Gpu>),
    /// Opened by the WebGPU backend.
    #[cfg(feature = "webgpu")]
    WebGpu(Arc<webgpu::Gpu>),
}

impl BenchDevice {
    /// Opens a device.
    ///
    /// # Errors
    /// When it can't be opened.
    pub fn open(backend: Backend, options: &GpuOptions) -> Result<Self> {
        match backend {
            Backend::Vulkan => {
                let gpu = vulkan::Gpu::new(options)?;
                // A measurement is of the fastest sort: it is worth the wait.
                choice::choose(&gpu)?;
                Ok(Self::Vulkan(gpu))
            }
            #[cfg(feature = "webgpu")]
            Backend::WebGpu => Ok(Self::WebGpu(webgpu::Gpu::open(options.device.as_deref())?)),
        }
    }

    /// The options with everything that was left open set as the device recommends.
    pub fn resolve(&self, options: RendererOptions) -> RendererOptions {
        match self {
            Self::Vulkan(gpu) => vulkan::raster::resolved(gpu, options),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(gpu) => webgpu::options::resolved(gpu, options),
        }
    }

    /// The device, if it is behind Vulkan.
    pub fn vulkan(&self) -> Option<&Arc<vulkan::Gpu>> {
        match self {
            Self::Vulkan(gpu) => Some(gpu),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(_) => None,
        }
    }

    /// Whether stages are timed.
    pub fn is_timed(&self) -> bool {
        self.describe().timestamps
    }

    /// Bytes of device memory that this program uses, and of the blocks that it has allocated; zeros
    /// if unknown.
    pub fn memory(&self) -> (u64, u64) {
        either!(self, gpu => gpu.memory())
    }

    /// The device's part of a report.
    pub fn describe(&self) -> DeviceReport {
        match self {
            Self::Vulkan(gpu) => DeviceReport::from_vulkan(gpu),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(gpu) => DeviceReport {
                name: gpu.info.name.clone(),
                driver: format!("{} {}", gpu.info.driver, gpu.info.driver_info)
                    .trim()
                    .to_owned(),
                vulkan: String::new(),
                subgroup_size: 0,
                timestamps: gpu.timestamps,
                backend: "webgpu".into(),
            },
        }
    }
}

/// A renderer of either backend.
pub enum BenchRenderer {
    /// Of the Vulkan backend.
    Vulkan(Box<vulkan::Renderer>),
    /// Of the WebGPU backend.
    #[cfg(feature = "webgpu")]
    WebGpu(Box<webgpu::Renderer>),
}

impl BenchRenderer {
    /// A renderer of an avatar.
    ///
    /// # Errors
    /// When the device can't draw it with these options.
    pub fn new(gpu: &BenchDevice, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        Ok(match gpu {
            BenchDevice::Vulkan(gpu) => {
                Self::Vulkan(Box::new(vulkan::Renderer::new(gpu, avatar, options)?))
            }
            #[cfg(feature = "webgpu")]
            BenchDevice::WebGpu(gpu) => {
                Self::WebGpu(Box::new(webgpu::Renderer::new(gpu, avatar, options)?))
            }
        })
    }

    /// A renderer of a case's scenes. `count`: whether to count fragments and Gaussians too, which
    /// takes time.
    ///
    /// # Errors
    /// When the device can't draw with this setting.
    pub fn of_case(
        gpu: &BenchDevice,
        task: &BenchTask,
        setting: &RenderSetting,
        case: BenchCase,
        count: bool,
    ) -> Result<Self> {
        let options = RendererOptions {
            instances: case.instances(),
            count,
            ..setting.options
        };
        Self::new(gpu, &setting.reduce(task.avatar), options)
    }

    /// The options that it draws with, resolved.
    pub fn options(&self) -> &RendererOptions {
        either!(self, renderer => renderer.options())
    }

    /// Submits a frame, unless nothing has changed.
    ///
    /// # Errors
    /// When the device fails.
    pub fn draw(&mut self, scene: &BenchScene) -> Result<()> {
        let people = scene.instances.iter().map(|own| Person::from(&own.drawn));
        let people: Vec<_> = people.collect();
        match self {
            Self::Vulkan(renderer) => renderer.draw_scene(&people, &scene.camera, None)?,
            #[cfg(feature = "webgpu")]
            Self::WebGpu(renderer) => drop(renderer.draw_scene(&people, &scene.camera)?),
        }
        Ok(())
    }

    /// Waits for every submitted frame.
    ///
    /// # Errors
    /// When the device fails.
    pub fn finish(&mut self) -> Result<()> {
        either!(self, renderer => Ok(renderer.finish()?))
    }

    /// Waits and copies the last frame's image.
    ///
    /// # Errors
    /// When the device fails.
    pub fn image(&mut self) -> Result<FrameImage> {
        either!(self, renderer => Ok(renderer.read_image()?))
    }

    /// Times and counts of the last finished frame.
    pub fn report(&self) -> &FrameReport {
        either!(self, renderer => renderer.report())
    }

    /// Times the scenes, once the device is warm. Two frames are in flight, as in use. Returns the
    /// time from each frame's submission to the next, ms, which in a steady state is the time that
    /// a frame takes, and what each reports. `tick` is called with the number of frames so far.
    ///
    /// # Errors
    /// When the device fails.
    pub fn time(
        &mut self,
        scenes: &[BenchScene],
        mut tick: impl FnMut(usize),
    ) -> Result<(Vec<f64>, Vec<FrameReport>)> {
        let begin = Instant::now();
        for (frame, scene) in scenes.iter().cycle().enumerate() {
            if frame >= WARM_UP_FRAMES && begin.elapsed() >= WARM_UP {
                break;
            }
            self.draw(scene)?;
        }
        self.finish()?;
        let mut intervals = Vec::with_capacity(scenes.len());
        let mut reports = Vec::with_capacity(scenes.len());
        // Until the pipeline is full, submissions don't wait for the device.
        let untimed = 2 * FRAMES_IN_FLIGHT;
        let mut last = Instant::now();
        for frame in 0..scenes.len() + untimed {
            self.draw(&scenes[frame % scenes.len()])?;
            let now = Instant::now();
            if frame >= untimed {
                intervals.push((now - last).as_secs_f64() * 1e3);
                reports.push(self.report().clone());
                tick(reports.len());
            }
            last = now;
        }
        self.finish()?;
        Ok((intervals, reports))
    }

    /// Draws the scenes one at a time and returns the counts of each. `tick` is called with the
    /// number of frames so far.
    ///
    /// # Errors
    /// When the device fails.
    pub fn count(
        &mut self,
        scenes: &[BenchScene],
        mut tick: impl FnMut(usize),
    ) -> Result<Vec<FrameReport>> {
        // The first frame reuses results of the frame before too, as it does when frames are timed.
        if let Some(scene) = scenes.last() {
            self.draw(scene)?;
        }
        let mut reports = Vec::with_capacity(scenes.len());
        for scene in scenes {
            self.finish()?;
            self.draw(scene)?;
            self.finish()?;
            reports.push(self.report().clone());
            tick(reports.len());
        }
        Ok(reports)
    }
}

/// How far some of a case's frames are from the reference's images.
#[derive(Clone, Copy, Debug, Default)]
pub struct Checked {
    /// The worst of the frames. None if none was compared.
    pub error: Option<ErrorReport>,
    /// Pixels that the device drew with an alpha of at least 1/255, in all of them.
    covered: usize,
}

impl Checked {
    /// Compares a frame. `flip`: whether to compute FLIP too, which takes seconds.
    pub fn add(&mut self, image: &FrameImage, reference: &FrameImage, flip: bool) {
        let is_covered = |pixel: &&[f32; 4]| f64::from(pixel[3]) >= ALPHA_MIN;
        self.covered += image.pixels.iter().filter(is_covered).count();
        let flip = flip.then(|| flip::between(image, reference).covered);
        let error = ErrorReport::new(&error::between(image, reference), flip);
        self.error = Some(self.error.map_or(error, |worst| worst.worse(error)));
    }

    /// Mean number of covered pixels.
    pub fn covered(&self) -> Option<f64> {
        Some(self.covered as f64 / self.error?.frames as f64)
    }
}
