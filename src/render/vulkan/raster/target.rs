//! The images that both methods draw to.

use crate::vulkan::{
    device::{
        error::{Error, Result},
        gpu::Gpu,
        recording::Recording,
    },
    memory::{Image, LayoutChange, Scope},
};
use ash::vk::{self, AccessFlags, PipelineStageFlags};
use effigy_core::frame::ColorFormat;

/// The layout that every frame leaves the image in.
pub(crate) const FINAL_LAYOUT: vk::ImageLayout = vk::ImageLayout::SHADER_READ_ONLY_OPTIMAL;

/// The pipeline stages that read the image.
pub(crate) const READER_STAGES: PipelineStageFlags = PipelineStageFlags::from_raw(
    PipelineStageFlags::FRAGMENT_SHADER.as_raw() | PipelineStageFlags::TRANSFER.as_raw(),
);

/// Those stages, and their accesses.
pub(crate) const READER_SCOPE: Scope = Scope::new(
    READER_STAGES,
    AccessFlags::from_raw(AccessFlags::SHADER_READ.as_raw() | AccessFlags::TRANSFER_READ.as_raw()),
);

/// The Vulkan format of a colour format.
pub(crate) fn vulkan_format(format: ColorFormat) -> vk::Format {
    match format {
        ColorFormat::Rgba8 => vk::Format::R8G8B8A8_UNORM,
        ColorFormat::Rgba16F => vk::Format::R16G16B16A16_SFLOAT,
    }
}

/// Fails where a device can't have an image of this size, px. `limit`: its largest side.
pub(crate) fn check_size(gpu: &Gpu, size: [u32; 2], limit: u32) -> Result<()> {
    if size.iter().any(|&side| side == 0 || side > limit) {
        return Err(Error::ImageSize {
            found: format!("{} × {}", size[0], size[1]),
            limit,
            device: gpu.probe.name.clone(),
        });
    }
    Ok(())
}

/// Has an image in the layout that render passes expect, whatever it holds.
pub(crate) fn forget(commands: Recording, image: &Image) {
    let output = PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT;
    let write = AccessFlags::COLOR_ATTACHMENT_WRITE;
    let change = LayoutChange {
        from: Scope::new(READER_STAGES | output, write),
        to: Scope::new(output, write),
        old: vk::ImageLayout::UNDEFINED,
        new: FINAL_LAYOUT,
    };
    // SAFETY: the image is alive.
    unsafe { commands.change_layout(image.raw(), change) };
}
