//! The kernels of a sort: for each pass which form its entries have, and which kernels run.

use super::{KeyBits, SortOptions, Variant};
use crate::{
    layout::SORT_GROUP,
    vulkan::{
        device::Gpu,
        error::Result,
        memory::Buffer,
        pipeline::{Bindings, Kernel, Launch, Slice, barrier},
        shaders::{self, Module},
    },
};
use ash::vk;
use std::sync::Arc;

/// Above this many tiles two more kernels a pass sum their histograms; below, each scatter does.
const MOST_SUMMED: u32 = 128;

/// What an entry is: `shaders/sort.glsl` says it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Keys = 0,
    Pairs = 1,
    Packed = 2,
    Values = 3,
    Halves = 4,
}

/// What the passes of a sort follow from.
pub struct Shape {
    pub capacity: u32,
    pub tiles: u32,
    pub options: SortOptions,
}

/// A pass: what counts and scans, where it does, and what moves.
pub struct Pass {
    count: Option<Kernel>,
    scan: Option<[Kernel; 2]>,
    scatter: Kernel,
}

impl Shape {
    fn forms(&self, pass: u32) -> [Form; 2] {
        let passes = self.options.bits.passes();
        let before = |pass: u32| match passes - pass {
            _ if pass == 0 && self.options.bits.halves() => Form::Halves,
            _ if pass == 0 => Form::Keys,
            0 => Form::Values,
            1 if self.capacity <= 1 << 24 => Form::Packed,
            _ => Form::Pairs,
        };
        [before(pass), before(pass + 1)]
    }

    /// Bytes of the buffers between passes, which passes write and read in turn.
    pub fn between(&self) -> Vec<u64> {
        let bytes = |pass: u32| u64::from(self.capacity) * if self.forms(pass)[1] == Form::Packed { 4 } else { 8 };
        match self.options.bits {
            KeyBits::Sixteen => vec![bytes(0)],
            KeyBits::TwentyFour | KeyBits::ThirtyTwo => vec![bytes(0), bytes(1)],
        }
    }

    /// `ends`: keys and order. `shared`: counts and control.
    pub fn passes(&self, gpu: &Arc<Gpu>, ends: [Slice; 2], between: &[Buffer], shared: [Slice; 2]) -> Result<Vec<Pass>> {
        let passes = self.options.bits.passes();
        let buffer = |pass: u32| Slice::from(&between[pass as usize % between.len()]);
        let one = |pass: u32| {
            let from = if pass == 0 { ends[0] } else { buffer(pass - 1) };
            let to = if pass + 1 == passes { ends[1] } else { buffer(pass) };
            self.pass(gpu, pass, [from, shared[0], shared[1], to])
        };
        (0..passes).map(one).collect()
    }

    fn pass(&self, gpu: &Arc<Gpu>, pass: u32, storage: [Slice; 4]) -> Result<Pass> {
        let variant = self.options.variant;
        let chained = variant == Variant::OneSweep && pass > 0;
        let scanned = !chained && self.tiles > MOST_SUMMED;
        let [reads, writes] = self.forms(pass);
        let unrolled = !gpu.probe.is_cpu();
        let entries = [pass, reads as u32, writes as u32];
        let sizes = [variant.tile(), self.tiles, self.capacity];
        let constants = [&entries[..], &sizes, &[u32::from(scanned), self.options.stall, u32::from(unrolled)]].concat();
        let kernel = |module: &'static Module, storage: &[Slice], subgroup| {
            let bindings = Bindings::new(gpu, vk::ShaderStageFlags::COMPUTE, None, storage)?;
            Kernel::with_launch(gpu, module, &constants, bindings, Launch { subgroup, ..Launch::default() })
        };
        let (count, scatter) = match variant {
            Variant::OneSweep => (&shaders::SORT_COUNT, &shaders::SORT_CHAIN),
            Variant::SelfScan => (&shaders::SORT_COUNT, &shaders::SORT_SCATTER),
            Variant::LaneScan => (&shaders::SORT_LANES_COUNT, &shaders::SORT_LANES_SCATTER),
        };
        let plain = |module| kernel(module, &storage[..3], None);
        let subgroup = if variant == Variant::OneSweep { self.subgroup(gpu) } else { None };
        Ok(Pass {
            count: if chained { None } else { Some(plain(count)?) },
            scan: if scanned { Some([plain(&shaders::SORT_REDUCE)?, plain(&shaders::SORT_SCAN)?]) } else { None },
            scatter: kernel(scatter, &storage, subgroup)?,
        })
    }

    /// Full subgroups of the size that the device reports, where it can be asked for that.
    fn subgroup(&self, gpu: &Gpu) -> Option<u32> {
        let [low, high] = gpu.probe.subgroup_sizes?;
        let size = self.options.subgroup.unwrap_or(gpu.probe.subgroup_size);
        (low..=high).contains(&size).then_some(size)
    }
}

impl Pass {
    pub fn dispatches(&self) -> usize {
        1 + usize::from(self.count.is_some()) + 2 * usize::from(self.scan.is_some())
    }

    pub fn record(&self, gpu: &Gpu, commands: vk::CommandBuffer, tiles: u32, counted: bool) {
        if let (Some(count), false) = (&self.count, counted) {
            count.dispatch(commands, 0, tiles);
            between(gpu, commands);
        }
        for kernel in self.scan.iter().flatten() {
            kernel.dispatch(commands, 0, tiles.div_ceil(SORT_GROUP));
            between(gpu, commands);
        }
        self.scatter.dispatch(commands, 0, tiles);
    }
}

/// Between two kernels.
pub fn between(gpu: &Gpu, commands: vk::CommandBuffer) {
    let compute = vk::PipelineStageFlags::COMPUTE_SHADER;
    let after = (compute, vk::AccessFlags::SHADER_READ | vk::AccessFlags::SHADER_WRITE);
    barrier(gpu, commands, (compute, vk::AccessFlags::SHADER_WRITE), after);
}
