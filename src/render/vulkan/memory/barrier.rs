//! Pipeline barriers: which work on the device waits for which.

use super::image::COLOR;
use crate::vulkan::device::recording::Recording;
use ash::vk::{self, AccessFlags, PipelineStageFlags};

/// Some stages of the device, and what they do with memory.
#[derive(Clone, Copy, Debug)]
pub struct Scope {
    /// The pipeline stages.
    pub(crate) stages: PipelineStageFlags,
    /// How they access memory.
    pub(crate) access: AccessFlags,
}

impl Scope {
    /// Writes of a kernel.
    pub const KERNEL_WRITES: Self = Self::new(
        PipelineStageFlags::COMPUTE_SHADER,
        AccessFlags::SHADER_WRITE,
    );
    /// Accesses of a kernel to buffers and images.
    pub const KERNEL: Self = Self::new(
        PipelineStageFlags::COMPUTE_SHADER,
        AccessFlags::from_raw(
            AccessFlags::SHADER_READ.as_raw() | AccessFlags::SHADER_WRITE.as_raw(),
        ),
    );
    /// Writes of a transfer.
    pub const TRANSFER_WRITES: Self =
        Self::new(PipelineStageFlags::TRANSFER, AccessFlags::TRANSFER_WRITE);
    /// Reads of a transfer.
    pub const TRANSFER_READS: Self =
        Self::new(PipelineStageFlags::TRANSFER, AccessFlags::TRANSFER_READ);

    /// Reads of the host, once the submission is over.
    pub const HOST_READS: Self = Self::new(PipelineStageFlags::HOST, AccessFlags::HOST_READ);

    /// Each access must be one that some of the stages can make.
    pub(crate) const fn new(stages: PipelineStageFlags, access: AccessFlags) -> Self {
        Self { stages, access }
    }
}

/// How an image's layout changes, and between what.
#[derive(Clone, Copy)]
pub(crate) struct LayoutChange {
    pub from: Scope,
    pub to: Scope,
    pub old: vk::ImageLayout,
    pub new: vk::ImageLayout,
}

impl Recording<'_> {
    /// Orders all earlier work of some stages before all later work of others.
    pub fn barrier(self, from: Scope, to: Scope) {
        let memory = [vk::MemoryBarrier::default()
            .src_access_mask(from.access)
            .dst_access_mask(to.access)];
        let none = vk::DependencyFlags::empty();
        // SAFETY: the command buffer is recording.
        unsafe {
            self.device().raw.cmd_pipeline_barrier(
                self.raw(),
                from.stages,
                to.stages,
                none,
                &memory,
                &[],
                &[],
            )
        };
    }

    /// Makes what transfers wrote visible to the host.
    pub(crate) fn show_host(self) {
        self.barrier(Scope::TRANSFER_WRITES, Scope::HOST_READS);
    }

    /// Orders what is done to a colour image, and changes its layout.
    ///
    /// # Safety
    /// The image must be alive until the commands are done, and in the old layout, if that is not
    /// `UNDEFINED`.
    pub(crate) unsafe fn change_layout(self, image: vk::Image, change: LayoutChange) {
        let barrier = [vk::ImageMemoryBarrier::default()
            .src_access_mask(change.from.access)
            .dst_access_mask(change.to.access)
            .old_layout(change.old)
            .new_layout(change.new)
            .src_queue_family_index(vk::QUEUE_FAMILY_IGNORED)
            .dst_queue_family_index(vk::QUEUE_FAMILY_IGNORED)
            .image(image)
            .subresource_range(COLOR)];
        let none = vk::DependencyFlags::empty();
        // SAFETY: the command buffer is recording; the caller promises that the image is alive and
        // in the old layout.
        unsafe {
            self.device().raw.cmd_pipeline_barrier(
                self.raw(),
                change.from.stages,
                change.to.stages,
                none,
                &[],
                &[],
                &barrier,
            )
        };
    }
}
