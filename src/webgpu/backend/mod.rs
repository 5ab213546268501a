//! All that needs `wgpu`.

mod buffer;
pub mod device;
pub mod error;
mod features;
mod harmonics;
mod kernel;
mod model;
pub mod options;
pub mod owned;
#[cfg(not(target_arch = "wasm32"))]
mod picture;
pub mod present;
mod raster;
#[cfg(not(target_arch = "wasm32"))]
pub mod readback;
mod refill;
pub mod renderer;
mod slot;
mod sort;
mod splats;
mod surface;

pub use device::Gpu;
pub use error::{Error, Result};
pub use renderer::Renderer;
