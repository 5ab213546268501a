//! Buffers and images that free themselves, barriers, and copies.

mod allocation;
mod barrier;
mod buffer;
mod copy;
mod image;

pub(crate) use barrier::LayoutChange;
pub use barrier::Scope;
pub use buffer::{Buffer, Slice};
pub(crate) use copy::copy_image;
pub use image::Image;
pub(crate) use image::{COLOR, DEPTH_FORMAT};
