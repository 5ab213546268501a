//! Brings the picture from the device to the host.

use super::{
    device::Gpu,
    error::Result,
    memory::{Buffer, COLOR, to_host},
    raster::{ColorFormat, Raster},
};
use crate::frame::Picture;
use ash::vk;
use gpu_allocator::MemoryLocation;
use half::f16;
use std::sync::Arc;

/// A picture's bytes as the device has them. Turning them into numbers is left to whoever has the time.
pub struct Copied {
    size: [u32; 2],
    format: ColorFormat,
    bytes: Vec<u8>,
}

impl Copied {
    pub fn decode(&self) -> Picture {
        let pixels = match self.format {
            ColorFormat::Rgba8 => self.bytes.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]].map(|v| f32::from(v) / 255.0)).collect(),
            ColorFormat::Rgba16F => {
                let half = |p: &[u8], k: usize| f16::from_le_bytes([p[2 * k], p[2 * k + 1]]).to_f32();
                self.bytes.chunks_exact(8).map(|p| std::array::from_fn(|k| half(p, k))).collect()
            }
        };
        Picture { size: self.size, pixels }
    }
}

/// Copies a picture that was drawn at least once, and waits.
pub fn download(gpu: &Arc<Gpu>, raster: &Raster) -> Result<Copied> {
    let image = raster.image();
    let [width, height] = raster.drawn();
    let bytes = width as usize * height as usize * raster.format().bytes();
    let mut staging = Buffer::new(gpu, "picture", bytes as u64, vk::BufferUsageFlags::TRANSFER_DST, MemoryLocation::GpuToCpu)?;
    gpu.run("reading a picture", |commands| {
        copy(gpu, commands, (image.raw, [width, height], READY), staging.raw);
        to_host(gpu, commands);
    })?;
    Ok(Copied { size: [width, height], format: raster.format(), bytes: staging.mapped()[..bytes].to_vec() })
}

/// How a picture is left after every frame.
pub(super) const READY: vk::ImageLayout = vk::ImageLayout::SHADER_READ_ONLY_OPTIMAL;

/// Records a copy of an image's upper left corner, of a size in px, to the start of a buffer. The image is in a layout, and stays in it.
pub(super) fn copy(
    gpu: &Gpu,
    commands: vk::CommandBuffer,
    (image, [width, height], layout): (vk::Image, [u32; 2], vk::ImageLayout),
    to: vk::Buffer,
) {
    let source = vk::ImageLayout::TRANSFER_SRC_OPTIMAL;
    transition(gpu, commands, image, [layout, source]);
    let region = vk::BufferImageCopy::default()
        .image_subresource(vk::ImageSubresourceLayers { aspect_mask: COLOR.aspect_mask, mip_level: 0, base_array_layer: 0, layer_count: 1 })
        .image_extent(vk::Extent3D { width, height, depth: 1 });
    // SAFETY: the command buffer is recording; image and buffer are alive, the region fits both.
    unsafe { gpu.raw.cmd_copy_image_to_buffer(commands, image, source, to, &[region]) };
    transition(gpu, commands, image, [source, layout]);
}

fn transition(gpu: &Gpu, commands: vk::CommandBuffer, image: vk::Image, [from, to]: [vk::ImageLayout; 2]) {
    let barrier = vk::ImageMemoryBarrier::default()
        .src_access_mask(vk::AccessFlags::MEMORY_WRITE)
        .dst_access_mask(vk::AccessFlags::MEMORY_READ | vk::AccessFlags::MEMORY_WRITE)
        .old_layout(from)
        .new_layout(to)
        .src_queue_family_index(vk::QUEUE_FAMILY_IGNORED)
        .dst_queue_family_index(vk::QUEUE_FAMILY_IGNORED)
        .image(image)
        .subresource_range(COLOR);
    let all = vk::PipelineStageFlags::ALL_COMMANDS;
    // SAFETY: the command buffer is recording, the image is alive and in the layout it is said to be in.
    unsafe { gpu.raw.cmd_pipeline_barrier(commands, all, all, vk::DependencyFlags::empty(), &[], &[], &[barrier]) };
}
