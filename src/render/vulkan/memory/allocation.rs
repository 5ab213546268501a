//! Device memory that frees itself.

use crate::vulkan::device::{
    error::{Error, Result},
    gpu::Gpu,
};
use ash::vk;
use gpu_allocator::{
    AllocationError, MemoryLocation,
    vulkan::{Allocation as Block, AllocationCreateDesc, AllocationScheme},
};
use std::sync::Arc;

/// A part of the device's memory. On a device that hangs it is never freed.
pub struct Allocation {
    gpu: Arc<Gpu>,
    /// None only while it is dropped.
    block: Option<Block>,
    memory: vk::DeviceMemory,
    offset: u64,
}

impl Allocation {
    /// `linear`: for buffers, not for images.
    pub fn new(
        gpu: &Arc<Gpu>,
        name: &str,
        requirements: vk::MemoryRequirements,
        location: MemoryLocation,
        linear: bool,
    ) -> Result<Self> {
        let description = AllocationCreateDesc {
            name,
            requirements,
            location,
            linear,
            allocation_scheme: AllocationScheme::GpuAllocatorManaged,
        };
        let allocated = gpu.lock_allocator().allocate(&description);
        let block = allocated.map_err(|source| match source {
            AllocationError::OutOfMemory => Error::OutOfMemory {
                memory: "device",
                call: "vkAllocateMemory",
            },
            source => Error::Allocation {
                what: name.into(),
                reason: source.to_string(),
            },
        })?;
        // SAFETY: the block is kept here, and freed after what is bound to it.
        let memory = unsafe { block.memory() };
        // SAFETY: the block's memory is alive and of this device.
        unsafe { gpu.name(memory, &format!("block, {location:?}")) };
        Ok(Self {
            gpu: gpu.clone(),
            offset: block.offset(),
            block: Some(block),
            memory,
        })
    }

    /// The memory object, and where in it the part starts, bytes.
    pub fn place(&self) -> (vk::DeviceMemory, u64) {
        (self.memory, self.offset)
    }

    /// Its bytes, where the host sees them; empty otherwise.
    pub fn mapped(&mut self) -> &mut [u8] {
        self.block
            .as_mut()
            .and_then(Block::mapped_slice_mut)
            .unwrap_or_default()
    }
}

impl Drop for Allocation {
    fn drop(&mut self) {
        let Some(block) = self.block.take().filter(|_| !self.gpu.hangs()) else {
            return;
        };
        if let Err(error) = self.gpu.lock_allocator().free(block) {
            tracing::warn!("freeing device memory failed: {error}");
        }
    }
}
