//! The stages on the GPU, on Vulkan 1.1 and what each device has beyond it.
//!
//! [`Gpu`] is a device; [`Renderer`] draws people with it, headless.
//!
//! The folders are layers; each imports only folders above it in this list. What other programs
//! call of those without a link is re-exported here:
//!
//! | folder | what it holds |
//! |---|---|
//! | `device` | errors, the instance, what a device has, the device and its queue |
//! | [`memory`] | buffers and images, barriers and copies |
//! | `pipeline` | shader modules, descriptor sets, kernels, render passes |
//! | `commands` | frames in flight; a stopwatch |
//! | [`sort`] | the radix sort, and the self-test that chooses its variant |
//! | `passes` | the stages from an avatar's pose to its splats |
//! | [`raster`] | the stages from sorted splats to an image |
//! | [`compute`] | what other packages compute with: kernels of their own, and buffers |
//! | [`rates`] | bytes and fragments that a device manages in a second |
//! | `renderer` | the frame |
//! | [`question`] | quads or tiles: measured once |
//! | `window` | from an image to a window or a screen in memory |
//! | [`statistics`] | what a driver's compiler says of every shader |

pub(crate) mod commands;
pub mod compute;
pub(crate) mod device;
pub mod memory;
pub(crate) mod passes;
pub(crate) mod pipeline;
pub mod question;
pub mod raster;
pub mod rates;
pub(crate) mod renderer;
pub mod sort;
pub mod statistics;
pub(crate) mod window;

pub use commands::{FRAMES_IN_FLIGHT, RunTimes, Semaphores};
pub use device::{
    Error, Gpu, GpuOptions, Result, cache, error::During, handle::CommandPool, instance,
    moment::ClockMoment, probe, probe::Probe, recording::Recording, trial,
};
pub use effigy_core::frame::{FrameReport, RendererOptions};
pub use pipeline::shaders;
pub use raster::{download::Copied, quad_pass::OnePassTarget};
pub use renderer::{PreparedAvatar, Presentation, Renderer, Stages};
pub use window::{
    pre_transform::PreTransform,
    present::{Present, PresentTarget, PresentedImage},
    screen::Offscreen,
    watch::{FrameValidator, PixelCounts},
};
#[cfg(feature = "window")]
pub use window::{swapchain, timing::PresentFeedback};
