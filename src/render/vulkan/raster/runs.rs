//! The lists of tiles for CPU drivers: an invocation takes a run of the drawing order and writes
//! each splat to the lists of the tiles that it meets. `shaders/common/tiles.glsl` has their form.

use super::draw::RasterInputs;
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, recording::Recording},
    memory::{Buffer, Replacement, Slice},
    pipeline::{FrameMemory, Kernel, Launch, shaders},
};
use ash::vk;
use effigy_core::{
    frame::{kernels, resource::Resource},
    layout::{BINNING_BLOCK, BINNING_RUNS, BINNING_WORKGROUP, TILE_LEVELS, TILING},
};
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
    /// The most splats.
    capacity: u32,
    /// Blocks that all levels but the last share.
    blocks: u32,
    /// Whether the device had no memory for others.
    is_fixed: bool,
    buffer: Buffer,
}

impl Runs {
    pub(crate) fn new(gpu: &Arc<Gpu>, inputs: &RasterInputs) -> Result<Self> {
        let capacity = inputs.capacity;
        let blocks = TILING.most_blocks(capacity);
        let buffer = list_buffer(gpu, capacity, blocks)?;
        let memory = inputs.memory.with(Resource::TileLists, &buffer);
        let launch = Launch::default();
        let (spec, module) = (&kernels::BINNING, &shaders::BINNING);
        Ok(Self {
            binning: Kernel::of_frame(gpu, spec, module, &[blocks], &memory, launch)?,
            capacity,
            blocks,
            is_fixed: false,
            buffer,
        })
    }

    /// Where a frame says how many blocks its lists asked for.
    pub fn asked(&self) -> Slice {
        Slice::from(&self.buffer).part(0, 4)
    }

    /// How many blocks frames should have after one that asked for so many. None where nothing
    /// changes.
    pub fn other_blocks(&self, asked: u32) -> Option<u32> {
        let other = TILING.other_blocks(self.capacity, self.blocks, asked);
        other.filter(|_| !self.is_fixed)
    }

    /// Makes lists with another number of blocks, for who binds those before to bind in their
    /// place. None where they stay for want of memory, which costs time alone, since larger tiles
    /// take the splats.
    ///
    /// # Safety
    /// No submitted work may use the lists. What binds them must bind the new ones before they are
    /// used again.
    pub unsafe fn resize(&mut self, gpu: &Arc<Gpu>, blocks: u32) -> Option<Replacement> {
        let resized = list_buffer(gpu, self.capacity, blocks).and_then(|buffer| {
            // SAFETY: no work uses the kernel, as the caller promises.
            unsafe { self.binning.specialize(&[blocks], Launch::default()) }?;
            Ok(buffer)
        });
        let buffer = match resized {
            Ok(buffer) => buffer,
            Err(error) => {
                tracing::warn!("tile lists stay at {} blocks: {error}", self.blocks);
                self.is_fixed = true;
                return None;
            }
        };
        tracing::debug!("tile lists go from {} to {blocks} blocks", self.blocks);
        let replacement = Replacement {
            old: (&self.buffer).into(),
            new: (&buffer).into(),
        };
        // SAFETY: no work uses the kernel, as the caller promises; this keeps the new buffer.
        unsafe { self.binning.replace(replacement) };
        self.buffer = buffer;
        self.blocks = blocks;
        Some(replacement)
    }

    /// Reads splats in the one buffer that it read in the other.
    ///
    /// # Safety
    /// No submitted work may use the kernel, and the new buffer must outlive what will.
    pub unsafe fn replace(&mut self, replacement: Replacement) {
        // SAFETY: the caller promises what the function asks for.
        unsafe { self.binning.replace(replacement) };
    }

    /// This memory, and the lists.
    pub(crate) fn add_to(&self, memory: &FrameMemory) -> FrameMemory {
        memory.with(Resource::TileLists, &self.buffer)
    }

    /// Empties the lists; a transfer.
    pub fn clear(&self, commands: Recording) {
        let heads = Slice {
            size: TILING.head_bytes(),
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

fn list_buffer(gpu: &Arc<Gpu>, capacity: u32, blocks: u32) -> Result<Buffer> {
    let usage = vk::BufferUsageFlags::STORAGE_BUFFER
        | vk::BufferUsageFlags::TRANSFER_SRC
        | vk::BufferUsageFlags::TRANSFER_DST;
    let size = TILING.bytes(capacity, blocks);
    Buffer::new(gpu, "tile lists", size, usage, MemoryLocation::GpuOnly)
}
