//! Shader modules and what runs them: descriptor sets, compute kernels, render passes and graphics
//! pipelines.

pub(crate) mod bindings;
mod frame_memory;
pub(crate) mod graphics;
mod kernel;
mod module;
pub(crate) mod set;
pub mod shaders;

pub use bindings::{BoundImage, Resources};
pub(crate) use frame_memory::FrameMemory;
pub use kernel::{Kernel, Launch};
