//! The lists of tiles in four levels, which invocations write from runs of the drawing order:
//! `shaders/common/tiles.glsl`.

use super::{
    super::{
        buffer::{STORAGE, Slice, empty},
        device::Gpu,
        error::Result,
        kernel::{Blocks, Bound, Kernel},
        owned::Buffer,
    },
    inputs::RasterInputs,
};
use crate::wgsl;
use effigy_core::layout::{BINNING_RUNS, BINNING_WORKGROUP, TILING_WEB};

/// The kernel that makes the lists, and their memory.
pub struct Runs {
    kernel: Kernel,
    lists: Buffer,
}

impl Runs {
    pub fn new(gpu: &Gpu, blocks: &Blocks, inputs: RasterInputs) -> Result<Self> {
        let size = TILING_WEB.bytes(inputs.capacity, TILING_WEB.most_blocks(inputs.capacity));
        let lists = empty(gpu, "tile lists", size, STORAGE)?;
        let bound = [
            blocks.frame(),
            (1, Bound::Read(inputs.order)),
            (2, Bound::Read(inputs.splats)),
            (3, Bound::Write(inputs.control.into())),
            (4, Bound::Write((&lists).into())),
            blocks.settings(),
        ];
        Ok(Self {
            kernel: Kernel::new(gpu, &wgsl::BINNING, &bound),
            lists,
        })
    }

    /// The lists.
    pub fn buffer(&self) -> Slice<'_> {
        (&self.lists).into()
    }

    /// Empties the lists.
    pub fn clear(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.clear_buffer(&self.lists, 0, Some(TILING_WEB.head_bytes()));
    }

    /// Writes splats to the lists of the tiles that they meet.
    pub fn record(&self, pass: &mut wgpu::ComputePass, block: u32) {
        self.kernel
            .dispatch(pass, block, [BINNING_RUNS / BINNING_WORKGROUP, 1]);
    }
}
