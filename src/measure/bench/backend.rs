//! The backends that can be measured, behind one face.

use super::{report::Device, scene::Scene};
use crate::{
    avatar::Avatar,
    frame::{FrameReport, Picture, Posed, RendererOptions},
    layout::{BINS, bins::Tiling},
    vulkan,
};
#[cfg(feature = "webgpu")]
use crate::{layout::BINS_WEB, webgpu};
use std::sync::Arc;

pub type Result<T> = std::result::Result<T, Error>;

/// What either has to say.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    Vulkan(#[from] vulkan::Error),
    #[cfg(feature = "webgpu")]
    #[error(transparent)]
    WebGpu(#[from] webgpu::Error),
}

impl Error {
    /// Whether it is a setting's fault, so that another setting may still be drawn with this device.
    pub fn is_refusal(&self) -> bool {
        match self {
            Self::Vulkan(error) => !matches!(error, vulkan::Error::Timeout { .. } | vulkan::Error::DeviceLost(_)),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(error) => !matches!(error, webgpu::Error::Timeout { .. } | webgpu::Error::DeviceLost(_)),
        }
    }
}

/// A device of either.
#[derive(Clone)]
pub enum Opened {
    Vulkan(Arc<vulkan::Gpu>),
    #[cfg(feature = "webgpu")]
    WebGpu(Arc<webgpu::Gpu>),
}

impl Opened {
    /// How it cuts pictures into tiles.
    pub fn tiling(&self) -> Tiling {
        match self {
            Self::Vulkan(_) => BINS,
            #[cfg(feature = "webgpu")]
            Self::WebGpu(_) => BINS_WEB,
        }
    }

    /// The same with what suits the device in place of what was left open.
    pub fn settled(&self, options: RendererOptions) -> RendererOptions {
        match self {
            Self::Vulkan(gpu) => options.settled(gpu),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(gpu) => webgpu::options::settled(gpu, options),
        }
    }

    /// The device, if it is one of Vulkan's.
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

    /// Bytes of its memory in use, and in blocks that the program took; zeros where nobody tells.
    pub fn memory(&self) -> (u64, u64) {
        match self {
            Self::Vulkan(gpu) => gpu.memory(),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(gpu) => gpu.memory(),
        }
    }

    /// What a report says of it.
    pub fn describe(&self) -> Device {
        match self {
            Self::Vulkan(gpu) => device(gpu),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(gpu) => Device {
                name: gpu.info.name.clone(),
                driver: format!("{} {}", gpu.info.driver, gpu.info.driver_info).trim().to_owned(),
                vulkan: String::new(),
                half_storage: false,
                subgroup_size: 0,
                timestamps: self.is_timed(),
                backend: "webgpu".into(),
            },
        }
    }
}

/// What a report says of a device of Vulkan's.
pub(crate) fn device(gpu: &vulkan::Gpu) -> Device {
    let part = |shift: u32, mask: u32| gpu.probe.api_version >> shift & mask;
    Device {
        name: gpu.probe.name.clone(),
        driver: gpu.probe.driver.clone(),
        vulkan: format!("{}.{}.{}", part(22, 0x7f), part(12, 0x3ff), part(0, 0xfff)),
        half_storage: gpu.half_storage,
        subgroup_size: gpu.probe.subgroup_size,
        timestamps: gpu.probe.timestamp_bits > 0,
        backend: "vulkan".into(),
    }
}

/// What draws scenes; the one place of the benchmark that knows how a renderer is called.
pub enum Renderer {
    Vulkan(Box<vulkan::Renderer>),
    #[cfg(feature = "webgpu")]
    WebGpu(Box<webgpu::Renderer>),
}

impl Renderer {
    pub fn new(gpu: &Opened, avatar: &Avatar, options: RendererOptions) -> Result<Self> {
        Ok(match gpu {
            Opened::Vulkan(gpu) => Self::Vulkan(Box::new(vulkan::Renderer::new(gpu, avatar, options)?)),
            #[cfg(feature = "webgpu")]
            Opened::WebGpu(gpu) => Self::WebGpu(Box::new(webgpu::Renderer::new(gpu, avatar, options)?)),
        })
    }

    /// Corners and triangles of the depth surface.
    pub fn surface_size(&self) -> [u64; 2] {
        match self {
            Self::Vulkan(renderer) => renderer.surface_size(),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(renderer) => renderer.surface_size(),
        }
    }

    /// Submits a frame, or finds that none is needed.
    pub fn draw(&mut self, scene: &Scene) -> Result<()> {
        let shown: Vec<&Posed> = scene.actors.iter().map(|actor| &actor.shown).collect();
        match self {
            Self::Vulkan(renderer) => renderer.draw_scene(&shown, &scene.camera, None)?,
            #[cfg(feature = "webgpu")]
            Self::WebGpu(renderer) => drop(renderer.draw_scene(&shown, &scene.camera)?),
        }
        Ok(())
    }

    /// Waits for every submitted frame.
    pub fn finish(&mut self) -> Result<()> {
        match self {
            Self::Vulkan(renderer) => renderer.finish()?,
            #[cfg(feature = "webgpu")]
            Self::WebGpu(renderer) => renderer.finish()?,
        }
        Ok(())
    }

    /// Waits, and copies the last frame's picture.
    pub fn picture(&mut self) -> Result<Picture> {
        Ok(match self {
            Self::Vulkan(renderer) => renderer.picture()?,
            #[cfg(feature = "webgpu")]
            Self::WebGpu(renderer) => renderer.picture()?,
        })
    }

    /// What the last finished frame took and drew.
    pub fn report(&self) -> &FrameReport {
        match self {
            Self::Vulkan(renderer) => renderer.report(),
            #[cfg(feature = "webgpu")]
            Self::WebGpu(renderer) => renderer.report(),
        }
    }
}
