//! The stages on the GPU, on WebGPU with its default limits: in browsers, and natively where the feature `webgpu` is on.
//!
//! [`Gpu`] is a device; [`Renderer`] draws an avatar, or several copies of it, with it. The stages have a file each, in the order a frame
//! runs them. Nothing here waits on the device but what says so, and that only natively and for a bounded time.

pub mod shaders;

#[cfg(any(feature = "webgpu", target_arch = "wasm32"))]
mod backend;
#[cfg(any(feature = "webgpu", target_arch = "wasm32"))]
pub use backend::*;
