//! Computing with kernels of one's own: for packages that train.
//!
//! A [`Kernel`] is a module with its bindings: a uniform block at binding 0, at an offset that each
//! dispatch chooses, and storage buffers from binding 1 on. [`Gpu::run`] records a submission and
//! waits for it, a bounded time. Between kernels that read what others wrote stands
//! [`Recording::barrier`].
//!
//! [`Gpu::run`]: super::Gpu::run
//! [`Recording::barrier`]: super::Recording::barrier

pub use super::{
    commands::RunTimes,
    device::recording::Recording,
    memory::{Buffer, Scope, Slice},
    pipeline::{Kernel, Launch, Resources, shaders::Module},
    sort::{Sort, SortOptions, SortVariant, choice::without_test},
};
pub use ash::vk::BufferUsageFlags;
pub use gpu_allocator::MemoryLocation;
