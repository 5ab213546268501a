//! The stages on the GPU, on WebGPU with its default limits: in browsers, and natively where the
//! feature `webgpu` is on.
//!
//! [`Gpu`] is a device; [`Renderer`] draws people with it. The stages
//! have a file each, in the order a frame runs them. Nothing here waits on the device but what says
//! so, and that only natively and for a bounded time.

mod buffer;
pub mod device;
#[cfg(not(target_arch = "wasm32"))]
mod download;
mod drawing;
pub mod error;
mod execute;
mod frame_in_flight;
mod held;
mod kernel;
mod mlp;
mod model;
pub mod options;
pub mod owned;
pub mod present;
mod project;
mod raster;
#[cfg(not(target_arch = "wasm32"))]
pub mod readback;
pub mod renderer;
mod sh;
mod shared;
mod sort;
mod splat_buffer;
mod stacked;

pub use device::Gpu;
pub use error::{Error, Result};
pub use renderer::Renderer;
