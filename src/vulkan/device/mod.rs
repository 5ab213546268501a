//! A Vulkan device: the loader's instance, what each device has, and the one that was opened.

pub mod cache;
pub mod calibration;
pub mod error;
pub mod gpu;
pub mod handle;
pub mod instance;
pub mod logical;
pub mod moment;
pub mod options;
pub mod probe;
pub mod recording;
pub mod sort_choice;
pub mod statistics;

pub use error::{Error, Result};
pub use gpu::Gpu;
pub use options::GpuOptions;
