//! Images that free themselves.

use super::allocation::Allocation;
use crate::vulkan::device::{
    error::{During, Result},
    gpu::Gpu,
    handle::{ImageHandle, ImageView},
};
use ash::vk;
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// A two-dimensional image of one level, its memory and its view.
pub struct Image {
    // In the order in which they have to go.
    view: ImageView,
    handle: ImageHandle,
    _allocation: Allocation,
    /// Width and height, px.
    pub(crate) size: [u32; 2],
}

impl Image {
    /// An image in the device's own memory, in `VK_IMAGE_LAYOUT_UNDEFINED`. `size`: width and
    /// height, px.
    pub(crate) fn new(
        gpu: &Arc<Gpu>,
        name: &'static str,
        size: [u32; 2],
        format: vk::Format,
        usage: vk::ImageUsageFlags,
    ) -> Result<Self> {
        let info = vk::ImageCreateInfo::default()
            .image_type(vk::ImageType::TYPE_2D)
            .format(format)
            .extent(vk::Extent3D {
                width: size[0],
                height: size[1],
                depth: 1,
            })
            .mip_levels(1)
            .array_layers(1)
            .samples(vk::SampleCountFlags::TYPE_1)
            .usage(usage);
        // SAFETY: `info` outlives the call; the image is new and belongs to its owner.
        let handle = unsafe {
            let raw = gpu.raw.create_image(&info, None).during("vkCreateImage")?;
            ImageHandle::new(&gpu.device, raw, name)
        };
        // SAFETY: the image is alive.
        let requirements = unsafe { gpu.raw.get_image_memory_requirements(handle.raw()) };
        let location = MemoryLocation::GpuOnly;
        let allocation = Allocation::new(gpu, name, requirements, location, false)?;
        let (memory, offset) = allocation.place();
        // SAFETY: image and memory are new and fit, as the requirements say.
        unsafe { gpu.raw.bind_image_memory(handle.raw(), memory, offset) }
            .during("vkBindImageMemory")?;
        let range = if format == DEPTH_FORMAT { DEPTH } else { COLOR };
        let view = ImageView::with_range(&gpu.device, handle.raw(), format, range, name)?;
        Ok(Self {
            view,
            handle,
            _allocation: allocation,
            size,
        })
    }

    /// Width and height, px.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The image, for as long as its owner lives.
    pub fn raw(&self) -> vk::Image {
        self.handle.raw()
    }

    /// All of it, for as long as its owner lives.
    pub(crate) fn view(&self) -> vk::ImageView {
        self.view.raw()
    }
}

/// The one level and layer of a colour image.
pub const COLOR: vk::ImageSubresourceRange = vk::ImageSubresourceRange {
    aspect_mask: vk::ImageAspectFlags::COLOR,
    base_mip_level: 0,
    level_count: 1,
    base_array_layer: 0,
    layer_count: 1,
};

/// 16 bits, which every device can draw to and sample.
pub const DEPTH_FORMAT: vk::Format = vk::Format::D16_UNORM;
/// The one level and layer of a depth image.
const DEPTH: vk::ImageSubresourceRange = vk::ImageSubresourceRange {
    aspect_mask: vk::ImageAspectFlags::DEPTH,
    ..COLOR
};
