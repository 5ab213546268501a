//! From splats to an image and back: pairs of splats and tiles, in order.

use super::buffers::{PairBuffers, TrainerBuffers};
use super::kernels::{KernelSource, PairKernels};
use super::tiling::{BandTiling, TileShape};
use crate::parameters::ParameterLayout;
use effigy_core::layout::{TRAIN_BLOCK, TRAIN_WORKGROUP};
use effigy_render::vulkan::compute::{Recording, Scope};
use effigy_render::vulkan::{Gpu, Result};
use std::sync::Arc;

/// Pairs of splats and tiles, and the kernels that make and use them. Made again with a larger
/// capacity, or more bands, where a view's pairs don't fit.
pub(super) struct PairStage {
    // Kernels go before what they are bound to.
    pub kernels: PairKernels,
    pub buffers: PairBuffers,
    pub tiling: BandTiling,
    blocks: u32,
}

impl PairStage {
    pub fn new(
        gpu: &Arc<Gpu>,
        buffers: &TrainerBuffers,
        layout: &ParameterLayout,
        shape: TileShape,
        tiling: BandTiling,
        size: [u32; 2],
    ) -> Result<Self> {
        let pairs = PairBuffers::new(gpu, layout.gaussians, tiling, size)?;
        let source = KernelSource {
            gpu,
            buffers,
            pairs: &pairs,
            layout,
            shape,
        };
        Ok(Self {
            kernels: PairKernels::new(&source)?,
            buffers: pairs,
            tiling,
            blocks: (layout.gaussians as u32).div_ceil(TRAIN_BLOCK).max(1),
        })
    }

    /// Sorted splats to the pairs of a band, by tile. Ends with what [`Self::record_image`] reads.
    pub fn record_pairs(&self, commands: Recording, offset: u32, size: [u32; 2], band: u32) {
        let next = || commands.barrier(Scope::KERNEL, Scope::KERNEL);
        let [columns, rows] = self.tiles_of(size, band);
        self.kernels.count.dispatch(commands, offset, self.blocks);
        next();
        self.kernels.scan.dispatch(commands, offset, 1);
        next();
        self.kernels.emit.dispatch(commands, offset, self.blocks);
        next();
        self.buffers.sort.record(commands);
        next();
        let tiles = columns * rows + 1;
        self.kernels
            .ranges
            .dispatch(commands, offset, tiles.div_ceil(TRAIN_WORKGROUP));
        next();
    }

    /// A band's pairs to its part of the image.
    pub fn record_image(&self, commands: Recording, offset: u32, size: [u32; 2], band: u32) {
        self.kernels
            .raster
            .dispatch_2d(commands, offset, self.tiles_of(size, band));
    }

    /// The image's derivative to records of a band's pairs.
    pub fn record_backward(&self, commands: Recording, offset: u32, size: [u32; 2], band: u32) {
        self.kernels
            .raster_backward
            .dispatch_2d(commands, offset, self.tiles_of(size, band));
    }

    /// Columns and rows of tiles of a band.
    fn tiles_of(&self, size: [u32; 2], band: u32) -> [u32; 2] {
        let [columns, _] = self.tiling.tiles(size);
        [columns, self.tiling.rows(size, band).len() as u32]
    }
}
