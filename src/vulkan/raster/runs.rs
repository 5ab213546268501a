//! The lists of tiles for CPU drivers: an invocation takes a run of the drawing order and writes
//! each splat to the lists of the tiles that it meets. `shaders/common/tiles.glsl` has their form.

use super::draw::RasterInputs;
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, recording::Recording},
    memory::{Buffer, Slice},
    pipeline::{Kernel, Launch, Resources, shaders},
};
use ash::vk;
use effigy_core::layout::{BINNING_BLOCK, BINNING_RUNS, BINNING_WORKGROUP, TILE_LEVELS, TILING};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// The output of the `binning` stage, read back: indices of splats, nearest first, of each tile of
/// each level, row by row from the top left.
pub struct TileLists {
    tiles: Vec<Vec<u32>>,
}

impl TileLists {
    /// The list of one tile, by column and row in its level. Level 0 is the finest.
    pub fn tile(&self, level: u32, [column, row]: [u32; 2]) -> &[u32] {
        &self.tiles[(TILING.first_tile(level)
            + row * (TILING.tiles_per_side >> (2 * level))
            + column) as usize]
    }

    /// The lists of all tiles, level by level, that cover a tile of the finest level.
    pub fn at(&self, [column, row]: [u32; 2]) -> [&[u32]; TILE_LEVELS as usize] {
        let whole = TILE_LEVELS - 1;
        std::array::from_fn(|k| k as u32).map(|level| {
            self.tile(
                level,
                if level < whole {
                    [column, row].map(|v| v >> (2 * level))
                } else {
                    [0; 2]
                },
            )
        })
    }
}

/// The kernel that makes the lists, and their memory.
pub struct Runs {
    binning: Kernel,
    buffer: Buffer,
}

impl Runs {
    pub fn new(gpu: &Arc<Gpu>, inputs: &RasterInputs) -> Result<Self> {
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_SRC
            | vk::BufferUsageFlags::TRANSFER_DST;
        let buffer = Buffer::new(
            gpu,
            "tile lists",
            TILING.bytes(inputs.capacity)[1],
            usage,
            MemoryLocation::GpuOnly,
        )?;
        let resources = Resources {
            uniform: Some(inputs.frame),
            storage: &[
                inputs.order,
                inputs.splats,
                inputs.control,
                (&buffer).into(),
            ],
            image: None,
        };
        let blocks = [TILING.blocks(inputs.capacity)[0]];
        let launch = Launch::default();
        Ok(Self {
            binning: Kernel::new(gpu, &shaders::BINNING, &blocks, resources, launch)?,
            buffer,
        })
    }

    pub fn storage(&self) -> Slice {
        (&self.buffer).into()
    }

    /// Empties the lists; a transfer.
    pub fn clear(&self, commands: Recording) {
        let heads = Slice {
            size: TILING.bytes(0)[0],
            ..(&self.buffer).into()
        };
        // SAFETY: the part lies in the buffer, which is alive.
        unsafe { commands.clear(heads) };
    }

    /// Writes splats to the lists of the tiles that they meet. Reads what the sort left; compute.
    pub fn record(&self, commands: Recording, frame: u32) {
        self.binning
            .dispatch(commands, frame, BINNING_RUNS / BINNING_WORKGROUP);
    }

    /// The lists of the last frame, read back for tests.
    pub fn download(&self) -> Result<TileLists> {
        let words: Vec<u32> =
            bytemuck::pod_collect_to_vec(&self.buffer.download(self.buffer.size as usize)?);
        let tiles = TILING.tiles() as usize;
        let runs = BINNING_RUNS as usize;
        let block_size = BINNING_BLOCK as usize;
        let heads = 1 + tiles;
        // Blocks are numbered from 1: a head or link of 0 ends a list.
        let blocks = heads + tiles * runs - block_size;
        // Each run of a tile has a list of blocks. A head or link is the place of the list's last
        // splat; word 0 of a block links to the block before, splats follow.
        let list = |head: usize| {
            let mut splats = Vec::new();
            let mut last = words[head] as usize;
            while last != 0 {
                let count = last % block_size;
                let link = last - count;
                splats.extend((link + 1..=last).rev().map(|place| words[blocks + place]));
                last = words[blocks + link] as usize;
            }
            splats
        };
        let tile = |tile: usize| {
            (0..runs)
                .rev()
                .flat_map(|run| list(heads + tile * runs + run))
                .collect()
        };
        Ok(TileLists {
            tiles: (0..tiles).map(tile).collect(),
        })
    }
}
