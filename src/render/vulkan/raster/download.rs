//! Brings the image from the device to the host.

use super::{stage::Raster, target::FINAL_LAYOUT};
use crate::vulkan::{
    device::{error::Result, gpu::Gpu},
    memory::image_bytes,
};
use effigy_core::{frame::ColorFormat, scene::FrameImage};
use half::f16;
use std::sync::Arc;

/// An image's bytes in the device's format. [`Self::decode`] turns them into numbers, on any
/// thread.
pub struct Copied {
    size: [u32; 2],
    format: ColorFormat,
    bytes: Vec<u8>,
}

impl Copied {
    /// The pixels, premultiplied RGBA, row by row from the top left.
    pub fn decode(&self) -> FrameImage {
        let pixels = match self.format {
            ColorFormat::Rgba8 => self
                .bytes
                .chunks_exact(4)
                .map(|p| [p[0], p[1], p[2], p[3]].map(|v| f32::from(v) / 255.0))
                .collect(),
            ColorFormat::Rgba16F => {
                let half =
                    |p: &[u8], k: usize| f16::from_le_bytes([p[2 * k], p[2 * k + 1]]).to_f32();
                self.bytes
                    .chunks_exact(8)
                    .map(|p| std::array::from_fn(|k| half(p, k)))
                    .collect()
            }
        };
        FrameImage {
            size: self.size,
            pixels,
        }
    }
}

/// Copies an image that was drawn at least once, and waits.
pub(crate) fn read_image(gpu: &Arc<Gpu>, raster: &Raster) -> Result<Copied> {
    let format = raster.format();
    let size = raster.drawn();
    Ok(Copied {
        size,
        format,
        bytes: image_bytes(gpu, raster.image(), FINAL_LAYOUT, size, format.bytes())?,
    })
}
