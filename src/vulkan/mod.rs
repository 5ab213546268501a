//! The stages on the GPU, on Vulkan 1.1 and what each device has beyond it.
//!
//! [`Gpu`] is a device; [`Renderer`] draws an avatar, or several copies of it, with it, headless. The stages have a file each, in the order a frame runs them.

pub mod cache;
pub mod calibration;
pub mod commands;
mod control;
pub mod device;
pub mod error;
pub mod features;
mod graphics;
pub mod harmonics;
pub mod instance;
pub mod memory;
pub mod model;
mod module;
mod name;
pub mod options;
pub mod picture;
pub mod pipeline;
pub mod present;
pub mod probe;
pub mod raster;
pub mod renderer;
pub mod screen;
pub mod shaders;
pub mod sort;
pub mod splats;
pub mod statistics;
pub mod surface;
#[cfg(feature = "window")]
pub mod swapchain;
#[cfg(feature = "window")]
mod target;
pub mod timing;
pub mod turn;
pub mod watch;

pub use crate::frame::{RendererOptions, preset};
pub use device::{Gpu, GpuOptions};
pub use error::{Error, Result};
pub use probe::Probe;
pub use renderer::Renderer;
