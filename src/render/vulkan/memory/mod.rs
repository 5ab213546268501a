//! Buffers and images that free themselves, barriers, and copies.

mod allocation;
mod barrier;
mod buffer;
mod copy;
mod image;

pub(crate) use barrier::LayoutChange;
pub use barrier::Scope;
pub use buffer::{Buffer, Slice};
pub(crate) use buffer::{Replacement, Upload, upload_all};
pub(crate) use copy::{copy_image, fill_image, image_bytes};
#[cfg(feature = "window")]
pub(crate) use image::COLOR;
pub(crate) use image::DEPTH_FORMAT;
pub use image::Image;
