//! Brings the image from the device to the host.

use super::{stage::Raster, target::FINAL_LAYOUT};
use crate::vulkan::{
    device::{error::Result, gpu::Gpu},
    memory::{Buffer, copy_image},
};
use ash::vk;
use effigy_core::{frame::ColorFormat, scene::FrameImage};
use gpu_allocator::MemoryLocation;
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
    let image = raster.image();
    let [width, height] = raster.drawn();
    let bytes = width as usize * height as usize * raster.format().bytes();
    let mut staging = Buffer::new(
        gpu,
        "image copy",
        bytes as u64,
        vk::BufferUsageFlags::TRANSFER_DST,
        MemoryLocation::GpuToCpu,
    )?;
    gpu.run("reading an image", |commands| {
        // SAFETY: image and buffer are alive, the buffer is large enough, and the image is in the
        // layout that every frame leaves it in; `run` waits.
        unsafe {
            copy_image(
                commands,
                image.raw(),
                FINAL_LAYOUT,
                raster.drawn(),
                staging.raw(),
            )
        };
        commands.show_host();
    })?;
    Ok(Copied {
        size: [width, height],
        format: raster.format(),
        bytes: staging.mapped()[..bytes].to_vec(),
    })
}
