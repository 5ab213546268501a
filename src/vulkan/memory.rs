//! Buffers and images that free themselves, and copies into and out of them.

use super::{
    device::Gpu,
    error::{During, Error, Result},
};
use ash::vk;
use gpu_allocator::{
    MemoryLocation,
    vulkan::{Allocation, AllocationCreateDesc, AllocationScheme},
};
use std::sync::Arc;

/// A buffer and its memory.
pub struct Buffer {
    gpu: Arc<Gpu>,
    pub raw: vk::Buffer,
    /// Bytes.
    pub size: u64,
    allocation: Option<Allocation>,
}

impl Buffer {
    /// `size` is rounded up to at least 16 bytes: Vulkan has no empty buffers, avatars have empty arrays.
    pub fn new(gpu: &Arc<Gpu>, name: &'static str, size: u64, usage: vk::BufferUsageFlags, location: MemoryLocation) -> Result<Self> {
        let size = size.max(16);
        let limit = u64::from(gpu.probe.limits.max_storage_buffer_range);
        if usage.contains(vk::BufferUsageFlags::STORAGE_BUFFER) && size > limit {
            return Err(Error::TooLarge { what: name, found: size, limit, device: gpu.probe.name.clone() });
        }
        let info = vk::BufferCreateInfo::default().size(size).usage(usage);
        // SAFETY: `info` outlives the call.
        let raw = unsafe { gpu.raw.create_buffer(&info, None) }.during("vkCreateBuffer")?;
        let mut buffer = Self { gpu: gpu.clone(), raw, size, allocation: None };
        gpu.name(raw, name);
        // SAFETY: the buffer was made above.
        let requirements = unsafe { gpu.raw.get_buffer_memory_requirements(raw) };
        let allocation = allocate(gpu, name, requirements, location, true)?;
        // SAFETY: the allocation is kept, and freed after what is bound to it.
        let (memory, offset) = (unsafe { allocation.memory() }, allocation.offset());
        buffer.allocation = Some(allocation);
        // SAFETY: buffer and memory are fresh and fit, as the requirements say.
        unsafe { gpu.raw.bind_buffer_memory(raw, memory, offset) }.during("vkBindBufferMemory")?;
        Ok(buffer)
    }

    /// A buffer of the device's own that shaders read, filled once.
    pub fn with_data(gpu: &Arc<Gpu>, name: &'static str, data: &[u8], usage: vk::BufferUsageFlags) -> Result<Self> {
        let buffer = Self::new(gpu, name, data.len() as u64, usage | vk::BufferUsageFlags::TRANSFER_DST, MemoryLocation::GpuOnly)?;
        buffer.upload(data)?;
        Ok(buffer)
    }

    /// Mapped bytes of a buffer that the host sees. Empty for others.
    pub fn mapped(&mut self) -> &mut [u8] {
        self.allocation.as_mut().and_then(|allocation| allocation.mapped_slice_mut()).unwrap_or_default()
    }

    /// Copies data to the start of a buffer of the device's own, and waits.
    pub fn upload(&self, data: &[u8]) -> Result<()> {
        /// Staging never takes more than this, whatever the avatar's size.
        const CHUNK: usize = 8 << 20;
        if data.is_empty() {
            return Ok(());
        }
        let size = data.len().min(CHUNK) as u64;
        let mut staging = Self::new(&self.gpu, "staging", size, vk::BufferUsageFlags::TRANSFER_SRC, MemoryLocation::CpuToGpu)?;
        for (at, chunk) in data.chunks(CHUNK).enumerate() {
            staging.mapped()[..chunk.len()].copy_from_slice(chunk);
            let region = vk::BufferCopy { src_offset: 0, dst_offset: (at * CHUNK) as u64, size: chunk.len() as u64 };
            // SAFETY: both buffers are alive, the region is inside both, and `run` waits.
            self.gpu.run("an upload", |commands| unsafe { self.gpu.raw.cmd_copy_buffer(commands, staging.raw, self.raw, &[region]) })?;
        }
        Ok(())
    }

    /// Copies the start of a buffer back, and waits: for pictures and tests.
    pub fn download(&self, bytes: usize) -> Result<Vec<u8>> {
        if bytes == 0 {
            return Ok(Vec::new());
        }
        let size = bytes as u64;
        let mut staging = Self::new(&self.gpu, "read-back", size, vk::BufferUsageFlags::TRANSFER_DST, MemoryLocation::GpuToCpu)?;
        self.gpu.run("a read-back", |commands| {
            // SAFETY: both buffers are alive, the region is inside both, and `run` waits.
            unsafe {
                let all = vk::MemoryBarrier::default()
                    .src_access_mask(vk::AccessFlags::MEMORY_WRITE)
                    .dst_access_mask(vk::AccessFlags::TRANSFER_READ);
                let (src, dst) = (vk::PipelineStageFlags::ALL_COMMANDS, vk::PipelineStageFlags::TRANSFER);
                self.gpu.raw.cmd_pipeline_barrier(commands, src, dst, vk::DependencyFlags::empty(), &[all], &[], &[]);
                self.gpu.raw.cmd_copy_buffer(commands, self.raw, staging.raw, &[vk::BufferCopy { src_offset: 0, dst_offset: 0, size }]);
                to_host(&self.gpu, commands);
            }
        })?;
        Ok(staging.mapped()[..bytes].to_vec())
    }
}

/// Makes what transfers wrote visible to the host.
pub(super) fn to_host(gpu: &Gpu, commands: vk::CommandBuffer) {
    let host = vk::MemoryBarrier::default().src_access_mask(vk::AccessFlags::TRANSFER_WRITE).dst_access_mask(vk::AccessFlags::HOST_READ);
    let (src, dst) = (vk::PipelineStageFlags::TRANSFER, vk::PipelineStageFlags::HOST);
    // SAFETY: the command buffer is recording.
    unsafe { gpu.raw.cmd_pipeline_barrier(commands, src, dst, vk::DependencyFlags::empty(), &[host], &[], &[]) };
}

impl Drop for Buffer {
    fn drop(&mut self) {
        // SAFETY: owners drop a buffer only when no submitted work uses it.
        self.gpu.destroy(|device| unsafe { device.destroy_buffer(self.raw, None) });
        free(&self.gpu, self.allocation.take());
    }
}

/// A two-dimensional image of one level, its memory and its view.
pub struct Image {
    gpu: Arc<Gpu>,
    pub raw: vk::Image,
    pub view: vk::ImageView,
    pub format: vk::Format,
    /// Width and height, px.
    pub size: [u32; 2],
    allocation: Option<Allocation>,
}

impl Image {
    pub fn new(gpu: &Arc<Gpu>, name: &'static str, size: [u32; 2], format: vk::Format, usage: vk::ImageUsageFlags) -> Result<Self> {
        let info = vk::ImageCreateInfo::default()
            .image_type(vk::ImageType::TYPE_2D)
            .format(format)
            .extent(vk::Extent3D { width: size[0], height: size[1], depth: 1 })
            .mip_levels(1)
            .array_layers(1)
            .samples(vk::SampleCountFlags::TYPE_1)
            .usage(usage);
        // SAFETY: `info` outlives the call.
        let raw = unsafe { gpu.raw.create_image(&info, None) }.during("vkCreateImage")?;
        let mut image = Self { gpu: gpu.clone(), raw, view: vk::ImageView::null(), format, size, allocation: None };
        gpu.name(raw, name);
        // SAFETY: the image was made above.
        let requirements = unsafe { gpu.raw.get_image_memory_requirements(raw) };
        let allocation = allocate(gpu, name, requirements, MemoryLocation::GpuOnly, false)?;
        // SAFETY: the allocation is kept, and freed after what is bound to it.
        let (memory, offset) = (unsafe { allocation.memory() }, allocation.offset());
        image.allocation = Some(allocation);
        // SAFETY: image and memory are fresh and fit, as the requirements say.
        unsafe { gpu.raw.bind_image_memory(raw, memory, offset) }.during("vkBindImageMemory")?;
        let range = if format == DEPTH_FORMAT { DEPTH } else { COLOR };
        let info =
            vk::ImageViewCreateInfo::default().image(raw).view_type(vk::ImageViewType::TYPE_2D).format(format).subresource_range(range);
        // SAFETY: `info` outlives the call.
        image.view = unsafe { gpu.raw.create_image_view(&info, None) }.during("vkCreateImageView")?;
        gpu.name(image.view, name);
        Ok(image)
    }
}

impl Drop for Image {
    fn drop(&mut self) {
        // SAFETY: owners drop an image only when no submitted work uses it. Destroying a null view does nothing.
        self.gpu.destroy(|device| unsafe {
            device.destroy_image_view(self.view, None);
            device.destroy_image(self.raw, None);
        });
        free(&self.gpu, self.allocation.take());
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
const DEPTH: vk::ImageSubresourceRange = vk::ImageSubresourceRange { aspect_mask: vk::ImageAspectFlags::DEPTH, ..COLOR };

fn allocate(gpu: &Gpu, name: &str, requirements: vk::MemoryRequirements, location: MemoryLocation, linear: bool) -> Result<Allocation> {
    let description =
        AllocationCreateDesc { name, requirements, location, linear, allocation_scheme: AllocationScheme::GpuAllocatorManaged };
    let mut allocator = gpu.allocator.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let allocation = allocator.allocate(&description).map_err(|source| match source {
        gpu_allocator::AllocationError::OutOfMemory => Error::OutOfMemory { memory: "device", call: "vkAllocateMemory" },
        source => Error::Allocation { what: name.into(), source },
    })?;
    // SAFETY: the memory is only named.
    gpu.name(unsafe { allocation.memory() }, &format!("block, {location:?}"));
    Ok(allocation)
}

fn free(gpu: &Gpu, allocation: Option<Allocation>) {
    let Some(allocation) = allocation.filter(|_| !gpu.hangs()) else { return };
    let mut allocator = gpu.allocator.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    if let Err(error) = allocator.free(allocation) {
        tracing::warn!("freeing device memory failed: {error}");
    }
}
