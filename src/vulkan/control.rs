//! What the stages of a frame wait for, and the counts that they start from.

use super::{device::Gpu, pipeline::barrier};
use crate::layout::{Control, RASTER_QUADS};
use ash::vk::{self, AccessFlags, PipelineStageFlags};
use bytemuck::bytes_of;

pub(super) type Scope = (PipelineStageFlags, AccessFlags);

const fn stages(all: &[PipelineStageFlags]) -> PipelineStageFlags {
    let (mut bits, mut at) = (0, 0);
    while at < all.len() {
        bits |= all[at].as_raw();
        at += 1;
    }
    PipelineStageFlags::from_raw(bits)
}

pub(super) const COMPUTE: PipelineStageFlags = PipelineStageFlags::COMPUTE_SHADER;
/// What a kernel wrote.
pub(super) const WRITTEN: Scope = (COMPUTE, AccessFlags::SHADER_WRITE);
/// What the next kernel does with it.
pub(super) const SHARED: Scope = (COMPUTE, AccessFlags::from_raw(AccessFlags::SHADER_READ.as_raw() | AccessFlags::SHADER_WRITE.as_raw()));
const TRANSFERRED: Scope = (PipelineStageFlags::TRANSFER, AccessFlags::TRANSFER_WRITE);
/// What may still go on of the frame before when the next one starts.
pub(super) const BEFORE: Scope = (
    stages(&[COMPUTE, PipelineStageFlags::VERTEX_SHADER, PipelineStageFlags::DRAW_INDIRECT, PipelineStageFlags::TRANSFER]),
    AccessFlags::SHADER_WRITE,
);

/// Runs a stage for one avatar after the other. They write to different places, but of one buffer, of which validation knows no places.
pub(super) fn in_turn<T>(gpu: &Gpu, commands: vk::CommandBuffer, all: impl Iterator<Item = T>, mut record: impl FnMut(T)) {
    for (at, one) in all.enumerate() {
        if at > 0 {
            barrier(gpu, commands, WRITTEN, SHARED);
        }
        record(one);
    }
}

/// Counts before anything is sorted.
pub(super) fn control(entering: u32) -> Control {
    Control { index_count: 6 * RASTER_QUADS, entering, ..Control::default() }
}

/// Tells the control how many keys enter the sort, where it has to be told, and clears what is counted: transfers between barriers.
pub(super) fn prepare(gpu: &Gpu, commands: vk::CommandBuffer, told: Option<(vk::Buffer, u32)>, clear: impl FnOnce(vk::CommandBuffer)) {
    barrier(gpu, commands, BEFORE, TRANSFERRED);
    if let Some((buffer, entering)) = told {
        // SAFETY: the command buffer is recording outside a render pass; the buffer is alive and holds a control.
        unsafe { gpu.raw.cmd_update_buffer(commands, buffer, 0, bytes_of(&control(entering))) };
    }
    clear(commands);
    let drawn = (PipelineStageFlags::DRAW_INDIRECT, AccessFlags::INDIRECT_COMMAND_READ);
    barrier(gpu, commands, TRANSFERRED, (COMPUTE | drawn.0 | PipelineStageFlags::VERTEX_SHADER, SHARED.1 | drawn.1));
}
