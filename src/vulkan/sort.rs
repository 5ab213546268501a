//! The `sort` stage: a stable radix sort of 32-bit keys, 8 bits a pass.
//!
//! A module of its own: it reads keys and a [`Control`], writes the order, and brings its own scratch memory. Three kernels a pass
//! (count, scan, scatter), no subgroup operation, no waiting of one workgroup for another: it is right on every device. Keys equal to
//! [`SORT_DROPPED`] are left out, which is how culled Gaussians disappear.
//!
//! What it reads must be visible to compute shaders before [`Sort::record`]; what it wrote is visible to nothing until the caller's barrier.

use super::{
    device::Gpu,
    error::Result,
    memory::Buffer,
    pipeline::{Bindings, Kernel, Slice, barrier},
    shaders,
};
#[cfg(doc)]
use crate::layout::{Control, SORT_DROPPED};
use crate::layout::{SORT_DIGITS, SORT_TILE};
use ash::vk;
use gpu_allocator::MemoryLocation;
use std::sync::Arc;

/// How much of a key counts: a pass for every 8 bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum KeyBits {
    #[default]
    Sixteen,
    TwentyFour,
    ThirtyTwo,
}

impl KeyBits {
    /// Passes of the sort.
    pub fn passes(self) -> u32 {
        match self {
            Self::Sixteen => 2,
            Self::TwentyFour => 3,
            Self::ThirtyTwo => 4,
        }
    }

    /// The largest key that a depth becomes: one that f32 holds, below [`SORT_DROPPED`].
    pub fn largest(self) -> u32 {
        match self {
            Self::Sixteen => 0xffff,
            Self::TwentyFour => 0xff_ffff,
            Self::ThirtyTwo => 0xffff_ff00,
        }
    }
}

struct Pass {
    count: Kernel,
    scan: Kernel,
    scatter: Kernel,
}

pub struct Sort {
    gpu: Arc<Gpu>,
    passes: Vec<Pass>,
    tiles: u32,
    order: Buffer,
    /// Kept alive for the kernels: the histograms and the entries between passes.
    _scratch: Vec<Buffer>,
}

impl Sort {
    /// Sorts at most `capacity` keys; how many is read from `control.entering` when the sort runs, and how many were left after
    /// dropping is written to `control.survivors`.
    pub fn new(gpu: &Arc<Gpu>, keys: Slice, control: &Buffer, capacity: u32, bits: KeyBits) -> Result<Self> {
        let passes = bits.passes() as usize;
        let tiles = capacity.div_ceil(SORT_TILE).max(1);
        let storage = |name, size| {
            Buffer::new(gpu, name, size, vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_SRC, MemoryLocation::GpuOnly)
        };
        let histograms = storage("sort histograms", 4 * u64::from(tiles * SORT_DIGITS))?;
        let order = storage("order", 4 * u64::from(capacity))?;
        // The last pass writes the order, the others go to and fro between these.
        let between = (1..passes.min(3)).map(|_| storage("sort entries", 8 * u64::from(capacity))).collect::<Result<Vec<_>>>()?;
        let mut kernels = Vec::new();
        for pass in 0..passes {
            let first = pass == 0;
            let last = pass + 1 == passes;
            let from = if first { keys } else { (&between[(pass - 1) % between.len()]).into() };
            let to = if last { (&order).into() } else { (&between[pass % between.len()]).into() };
            kernels.push(Self::pass(
                gpu,
                from,
                to,
                (&histograms).into(),
                control.into(),
                [8 * pass as u32, u32::from(first), tiles, u32::from(last)],
            )?);
        }
        let scratch = between.into_iter().chain([histograms]).collect();
        Ok(Self { gpu: gpu.clone(), passes: kernels, tiles, order, _scratch: scratch })
    }

    fn pass(gpu: &Arc<Gpu>, from: Slice, to: Slice, histograms: Slice, control: Slice, constants: [u32; 4]) -> Result<Pass> {
        let kernel = |module, storage: &[Slice], constants: &[u32]| {
            Kernel::new(gpu, module, constants, Bindings::new(gpu, vk::ShaderStageFlags::COMPUTE, None, storage)?)
        };
        Ok(Pass {
            count: kernel(&shaders::SORT_COUNT, &[from, histograms, control], &constants[..2])?,
            scan: kernel(&shaders::SORT_SCAN, &[histograms, control], &constants[..3])?,
            scatter: kernel(&shaders::SORT_SCATTER, &[from, histograms, control, to], &constants)?,
        })
    }

    /// The indices of the surviving keys, lowest key first, equal keys in index order.
    pub fn order(&self) -> Slice {
        (&self.order).into()
    }

    /// The first `count` indices, for tests.
    pub fn download(&self, count: u32) -> Result<Vec<u32>> {
        Ok(bytemuck::pod_collect_to_vec(&self.order.download(4 * count as usize)?))
    }

    /// Reads keys and control; compute.
    pub fn record(&self, commands: vk::CommandBuffer) {
        let compute = vk::PipelineStageFlags::COMPUTE_SHADER;
        let between = |commands| {
            let after = (compute, vk::AccessFlags::SHADER_READ | vk::AccessFlags::SHADER_WRITE);
            barrier(&self.gpu, commands, (compute, vk::AccessFlags::SHADER_WRITE), after);
        };
        for (number, pass) in self.passes.iter().enumerate() {
            if number > 0 {
                between(commands);
            }
            pass.count.dispatch(commands, 0, self.tiles);
            between(commands);
            pass.scan.dispatch(commands, 0, 1);
            between(commands);
            pass.scatter.dispatch(commands, 0, self.tiles);
        }
    }
}
