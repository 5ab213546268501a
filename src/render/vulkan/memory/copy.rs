//! Copies between images and buffers.

use super::{
    barrier::{LayoutChange, Scope},
    buffer::Buffer,
    image::{COLOR, Image},
};
use crate::vulkan::device::{error::Result, gpu::Gpu, recording::Recording};
use ash::vk::{self, AccessFlags, PipelineStageFlags};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// Records a copy of a colour image's upper left corner, of a size in px, to the start of a buffer.
/// The image stays in its layout.
///
/// # Safety
/// Image and buffer must be alive until the commands are done and hold the corner, and the image
/// must be in the layout.
pub(crate) unsafe fn copy_image(
    commands: Recording,
    image: vk::Image,
    layout: vk::ImageLayout,
    size: [u32; 2],
    buffer: vk::Buffer,
) {
    let source = vk::ImageLayout::TRANSFER_SRC_OPTIMAL;
    let all = PipelineStageFlags::ALL_COMMANDS;
    let change = LayoutChange {
        from: Scope::new(all, AccessFlags::MEMORY_WRITE),
        to: Scope::new(all, AccessFlags::MEMORY_READ | AccessFlags::MEMORY_WRITE),
        old: layout,
        new: source,
    };
    // SAFETY: the command buffer is recording; the caller promises that image and buffer are alive,
    // that the corner fits both, and the image's layout.
    unsafe {
        commands.change_layout(image, change);
        commands.device().raw.cmd_copy_image_to_buffer(
            commands.raw(),
            image,
            source,
            buffer,
            &[corner(size)],
        );
        let back = LayoutChange {
            old: source,
            new: layout,
            ..change
        };
        commands.change_layout(image, back);
    }
}

/// A colour image's upper left corner, at the start of a buffer.
fn corner([width, height]: [u32; 2]) -> vk::BufferImageCopy {
    vk::BufferImageCopy::default()
        .image_subresource(vk::ImageSubresourceLayers {
            aspect_mask: COLOR.aspect_mask,
            mip_level: 0,
            base_array_layer: 0,
            layer_count: 1,
        })
        .image_extent(vk::Extent3D {
            width,
            height,
            depth: 1,
        })
}

/// Fills a colour image that transfers may write, and waits. `pixels`: row by row from the top left.
/// The image is then in `SHADER_READ_ONLY_OPTIMAL`.
pub(crate) fn fill_image(gpu: &Arc<Gpu>, image: &Image, pixels: &[u8]) -> Result<()> {
    let usage = vk::BufferUsageFlags::TRANSFER_SRC;
    let location = MemoryLocation::CpuToGpu;
    let mut staging = Buffer::new(gpu, "picture", pixels.len() as u64, usage, location)?;
    staging.mapped()[..pixels.len()].copy_from_slice(pixels);
    let target = vk::ImageLayout::TRANSFER_DST_OPTIMAL;
    let all = PipelineStageFlags::ALL_COMMANDS;
    let change = LayoutChange {
        from: Scope::new(all, AccessFlags::empty()),
        to: Scope::TRANSFER_WRITES,
        old: vk::ImageLayout::UNDEFINED,
        new: target,
    };
    let shown = LayoutChange {
        from: Scope::TRANSFER_WRITES,
        to: Scope::new(all, AccessFlags::SHADER_READ),
        old: target,
        new: vk::ImageLayout::SHADER_READ_ONLY_OPTIMAL,
    };
    gpu.run("a picture's upload", |commands| {
        // SAFETY: the command buffer is recording; image and buffer are alive, and `run` waits. The
        // region is the whole image, which the buffer holds.
        unsafe {
            commands.change_layout(image.raw(), change);
            commands.device().raw.cmd_copy_buffer_to_image(
                commands.raw(),
                staging.raw(),
                image.raw(),
                target,
                &[corner(image.size)],
            );
            commands.change_layout(image.raw(), shown);
        }
    })
}

/// Copies an image's upper left corner, of a size in px, and waits. The image must be in the layout.
pub(crate) fn image_bytes(
    gpu: &Arc<Gpu>,
    image: &Image,
    layout: vk::ImageLayout,
    size: [u32; 2],
    bytes_a_pixel: usize,
) -> Result<Vec<u8>> {
    let bytes = size[0] as usize * size[1] as usize * bytes_a_pixel;
    let mut staging = Buffer::new(
        gpu,
        "image copy",
        bytes as u64,
        vk::BufferUsageFlags::TRANSFER_DST,
        MemoryLocation::GpuToCpu,
    )?;
    gpu.run("reading an image", |commands| {
        // SAFETY: image and buffer are alive, the buffer is large enough, and the image is in the
        // layout that every frame leaves it in, which the caller names; `run` waits.
        unsafe { copy_image(commands, image.raw(), layout, size, staging.raw()) };
        commands.show_host();
    })?;
    Ok(staging.mapped()[..bytes].to_vec())
}
