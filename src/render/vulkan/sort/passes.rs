//! The passes of a sort: the form of the entries and the kernels of each.

use super::options::SortOptions;
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, recording::Recording},
    memory::{Buffer, Replacement, Scope, Slice},
    pipeline::{
        Kernel, Launch, Resources,
        shaders::{self, Module},
    },
};
use ash::vk;
use effigy_core::{
    frame::SortVariant,
    layout::{MAX_SUMMED_TILES, SORT_GROUP},
};
use std::sync::Arc;

/// Size and options of a sort, which decide its passes.
pub struct SortSize {
    pub capacity: u32,
    pub tiles: u32,
    pub options: SortOptions,
}

/// Buffers that a sort reads and writes.
#[derive(Clone, Copy)]
pub struct SortBuffers {
    pub keys: Slice,
    pub counts: Slice,
    pub control: Slice,
}

/// The kernels of a pass. `count` and `scan` are None where the pass needs none.
pub struct SortPass {
    count: Option<Kernel>,
    scan: Option<[Kernel; 2]>,
    scatter: Kernel,
}

impl SortSize {
    /// `in_turn`: buffers of the lengths of
    /// [`KeyBits::written_in_turn`](effigy_core::frame::KeyBits::written_in_turn).
    pub fn passes(
        &self,
        gpu: &Arc<Gpu>,
        buffers: SortBuffers,
        in_turn: &[Buffer; 2],
    ) -> Result<Vec<SortPass>> {
        let entries = |pass: u32| Slice::from(&in_turn[pass as usize % 2]);
        let mut passes = Vec::new();
        for pass in 0..self.options.bits.passes() {
            let from = if pass == 0 {
                buffers.keys
            } else {
                entries(pass - 1)
            };
            let storage = [from, buffers.counts, buffers.control, entries(pass)];
            passes.push(self.pass(gpu, pass, storage)?);
        }
        Ok(passes)
    }

    fn pass(&self, gpu: &Arc<Gpu>, pass: u32, storage: [Slice; 4]) -> Result<SortPass> {
        let variant = self.options.variant;
        let looks_back = variant == SortVariant::OneSweep && pass > 0;
        let scanned = !looks_back && self.tiles > MAX_SUMMED_TILES;
        let bits = self.options.bits;
        let [reads, writes] = [pass, pass + 1].map(|at| bits.form_before(at, self.capacity));
        let unrolled = !gpu.probe.is_cpu();
        let entries = [pass, reads as u32, writes as u32];
        let sizes = [variant.tile(), self.tiles, self.capacity];
        let constants = [
            &entries[..],
            &sizes,
            &[
                u32::from(scanned),
                self.options.stall,
                u32::from(unrolled),
                bits.value_bits(self.capacity),
                tiles_read_at_once(gpu.probe.kind),
            ],
        ]
        .concat();
        let kernel = |module: &'static Module, storage: &[Slice], subgroup| {
            let resources = Resources {
                storage,
                ..Resources::default()
            };
            let launch = Launch {
                subgroup,
                ..Launch::default()
            };
            Kernel::new(gpu, module, &constants, resources, launch)
        };
        let (count, scatter) = match variant {
            SortVariant::OneSweep => (&shaders::SORT_COUNT, &shaders::SORT_ONESWEEP),
            SortVariant::ReduceThenScan => (&shaders::SORT_COUNT, &shaders::SORT_SCATTER),
            SortVariant::PerThread => (
                &shaders::SORT_PER_THREAD_COUNT,
                &shaders::SORT_PER_THREAD_SCATTER,
            ),
        };
        let plain = |module| kernel(module, &storage[..3], None);
        let subgroup = if variant == SortVariant::OneSweep {
            self.subgroup(gpu)
        } else {
            None
        };
        Ok(SortPass {
            count: if looks_back {
                None
            } else {
                Some(plain(count)?)
            },
            scan: if scanned {
                Some([plain(&shaders::SORT_REDUCE)?, plain(&shaders::SORT_SCAN)?])
            } else {
                None
            },
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

/// Earlier tiles whose counts OneSweep reads at a time. A CPU runs few tiles together: the one
/// before has its sums. With 8, Mali's registers don't hold a tile's entries too.
fn tiles_read_at_once(kind: vk::PhysicalDeviceType) -> u32 {
    match kind {
        vk::PhysicalDeviceType::CPU => 1,
        vk::PhysicalDeviceType::DISCRETE_GPU => 8,
        _ => 4,
    }
}

impl SortPass {
    pub fn dispatches(&self) -> usize {
        1 + usize::from(self.count.is_some()) + 2 * usize::from(self.scan.is_some())
    }

    /// Binds the one buffer wherever the other was bound.
    ///
    /// # Safety
    /// No submitted work may use the pass, and the new buffer must outlive what will.
    pub unsafe fn replace(&mut self, replacement: Replacement) {
        let scans = self.scan.iter_mut().flatten();
        for kernel in self
            .count
            .iter_mut()
            .chain(scans)
            .chain([&mut self.scatter])
        {
            // SAFETY: the caller promises what the function asks for.
            unsafe { kernel.replace(replacement) };
        }
    }

    /// `counted`: whether the counts are there already.
    pub fn record(&self, commands: Recording, tiles: u32, counted: bool) {
        if let Some(count) = &self.count
            && !counted
        {
            count.dispatch(commands, 0, tiles);
            commands.barrier(Scope::KERNEL_WRITES, Scope::KERNEL);
        }
        for kernel in self.scan.iter().flatten() {
            kernel.dispatch(commands, 0, tiles.div_ceil(SORT_GROUP));
            commands.barrier(Scope::KERNEL_WRITES, Scope::KERNEL);
        }
        self.scatter.dispatch(commands, 0, tiles);
    }
}
