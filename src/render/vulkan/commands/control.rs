//! The counts that a frame starts from.

use crate::vulkan::device::recording::Recording;
use ash::vk;
use bytemuck::bytes_of;
use effigy_core::layout::{Control, QUADS_PER_INSTANCE};

/// Counts before anything is sorted.
pub(crate) fn control(key_count: u32) -> Control {
    Control {
        index_count: 6 * QUADS_PER_INSTANCE,
        key_count,
        ..Control::default()
    }
}

/// Has a buffer hold the counts of a frame before anything is sorted: a transfer.
///
/// # Safety
/// The buffer must be alive until the commands are done, and large enough.
pub(crate) unsafe fn set_control(commands: Recording, buffer: vk::Buffer, key_count: u32) {
    let device = &commands.device().raw;
    let control = control(key_count);
    // SAFETY: the command buffer is recording outside a render pass; the caller promises that the
    // buffer is alive and holds a control.
    unsafe { device.cmd_update_buffer(commands.raw(), buffer, 0, bytes_of(&control)) };
}
