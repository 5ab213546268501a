//! The backends that can be measured, behind one interface.

use super::{report::DeviceReport, scene::BenchScene};
use effigy::vulkan;
#[cfg(feature = "webgpu")]
use effigy::webgpu;
use effigy_core::{
    avatar::Avatar,
    frame::{FrameReport, RendererOptions},
    scene::{FrameImage, Posed},
};
use std::sync::Arc;

/// A result with an error of either backend.
pub type Result<T> = std::result::Result<T, BackendError>;

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

impl BackendError {
    /// Whether the device refuses a setting and can still draw with others.
    pub fn is_refusal(&self) -> bool {
        match self {
            Self::Vulkan(error) => !matches!(
                error,
                vulkan::Error::Timeout { .. } | vulkan::Error::DeviceLost(_)
            ),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(error) => !matches!(
                error,
                webgpu::Error::Timeout { .. } | webgpu::Error::DeviceLost(_)
            ),
        }
    }
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
    /// The options with everything that was left open set as the device recommends.
    pub fn resolve(&self, options: RendererOptions) -> RendererOptions {
        match self {
            Self::Vulkan(gpu) => effigy::vulkan::raster::resolved(gpu, options),
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
        match self {
            Self::Vulkan(gpu) => gpu.probe.timestamp_bits > 0,
            #[cfg(feature = "webgpu")]
            Self::WebGpu(gpu) => gpu.timestamps,
        }
    }

    /// The device memory of this program; zeros if unknown.
    pub fn memory(&self) -> DeviceMemory {
        let (used, allocated) = match self {
            Self::Vulkan(gpu) => gpu.memory(),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(gpu) => gpu.memory(),
        };
        DeviceMemory { used, allocated }
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
                timestamps: self.is_timed(),
                backend: "webgpu".into(),
            },
        }
    }
}

/// Bytes of device memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DeviceMemory {
    /// In use.
    pub used: u64,
    /// In blocks that the program has allocated.
    pub allocated: u64,
}

/// A renderer of either backend: the only place of the benchmark that calls one.
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

    /// The options that it draws with, resolved.
    pub fn options(&self) -> &RendererOptions {
        match self {
            Self::Vulkan(renderer) => renderer.options(),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(renderer) => renderer.options(),
        }
    }

    /// Submits a frame, unless nothing has changed.
    ///
    /// # Errors
    /// When the device fails.
    pub fn draw(&mut self, scene: &BenchScene) -> Result<()> {
        let shown: Vec<&Posed> = scene
            .instances
            .iter()
            .map(|instance| &instance.drawn)
            .collect();
        match self {
            Self::Vulkan(renderer) => renderer.draw_scene(&shown, &scene.camera, None)?,
            #[cfg(feature = "webgpu")]
            Self::WebGpu(renderer) => drop(renderer.draw_scene(&shown, &scene.camera)?),
        }
        Ok(())
    }

    /// Waits for every submitted frame.
    ///
    /// # Errors
    /// When the device fails.
    pub fn finish(&mut self) -> Result<()> {
        match self {
            Self::Vulkan(renderer) => renderer.finish()?,
            #[cfg(feature = "webgpu")]
            Self::WebGpu(renderer) => renderer.finish()?,
        }
        Ok(())
    }

    /// Waits and copies the last frame's image.
    ///
    /// # Errors
    /// When the device fails.
    pub fn image(&mut self) -> Result<FrameImage> {
        Ok(match self {
            Self::Vulkan(renderer) => renderer.read_image()?,
            #[cfg(feature = "webgpu")]
            Self::WebGpu(renderer) => renderer.read_image()?,
        })
    }

    /// Times and counts of the last finished frame.
    pub fn report(&self) -> &FrameReport {
        match self {
            Self::Vulkan(renderer) => renderer.report(),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(renderer) => renderer.report(),
        }
    }
}
