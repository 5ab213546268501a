//! A Vulkan device: the loader's instance, what each device has, and the one that was opened.

pub mod cache;
pub(crate) mod calibration;
pub(crate) mod error;
pub(crate) mod gpu;
pub(crate) mod handle;
pub(crate) mod identity;
pub mod instance;
pub(crate) mod kept_pipelines;
pub(crate) mod logical;
pub(crate) mod moment;
pub(crate) mod options;
pub(crate) mod outcome;
pub mod probe;
pub(crate) mod record_file;
pub(crate) mod recording;
pub(crate) mod statistics;
pub mod trial;

pub use error::{Error, Result};
pub use gpu::Gpu;
pub use options::GpuOptions;
