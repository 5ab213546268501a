//! A command buffer that is being recorded.

use super::logical::Device;
use ash::vk;

/// A command buffer that is being recorded, outside of a render pass unless it is said otherwise.
#[derive(Clone, Copy)]
pub struct Recording<'a> {
    device: &'a Device,
    raw: vk::CommandBuffer,
}

impl<'a> Recording<'a> {
    /// # Safety
    /// The command buffer must be of this device, and recording for as long as the value lives.
    pub(crate) unsafe fn new(device: &'a Device, raw: vk::CommandBuffer) -> Self {
        Self { device, raw }
    }

    /// The device of the command buffer.
    pub fn device(self) -> &'a Device {
        self.device
    }

    /// The command buffer.
    pub fn raw(self) -> vk::CommandBuffer {
        self.raw
    }
}
