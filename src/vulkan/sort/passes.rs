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

/// Form of the entries between passes; see `shaders/sort/pass.glsl`.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    Keys = 0,
    Pairs = 1,
    Packed = 2,
    Values = 3,
    Halves = 4,
}

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
    /// The forms of the entries that a pass reads and writes.
    fn forms(&self, pass: u32) -> [Form; 2] {
        [self.form_before(pass), self.form_before(pass + 1)]
    }

    /// The form of the entries before a pass; after the last one with the number of passes.
    fn form_before(&self, pass: u32) -> Form {
        let passes = self.options.bits.passes();
        if pass == 0 {
            return if self.options.bits.halves() {
                Form::Halves
            } else {
                Form::Keys
            };
        }
        if pass == passes {
            return Form::Values;
        }
        if self.options.bits.packs_before(pass, self.capacity) {
            Form::Packed
        } else {
            Form::Pairs
        }
    }

    /// Bits that the value, which is an index, has beside the bits left of the key in the packed
    /// form: all that are left when it begins. 24 where it never does.
    fn value_bits(&self) -> u32 {
        let bits = self.options.bits;
        let packed = |&pass: &u32| bits.packs_before(pass, self.capacity);
        (1..bits.passes())
            .find(packed)
            .map_or(24, |pass| 32 - bits.bits_left(pass))
    }

    /// Bytes that a pass writes.
    fn written(&self, pass: u32) -> u64 {
        let entry = match self.forms(pass)[1] {
            Form::Packed | Form::Values => 4,
            _ => 8,
        };
        entry * u64::from(self.capacity)
    }

    /// Bytes of the two buffers that passes write in turn: the first pass the first, the last pass
    /// [`Self::last`].
    pub fn written_in_turn(&self) -> [u64; 2] {
        let passes = self.options.bits.passes();
        let largest = |first| {
            (first..passes)
                .step_by(2)
                .map(|pass| self.written(pass))
                .max()
        };
        [0, 1].map(|first| largest(first).unwrap_or_default())
    }

    /// The buffer that the last pass writes: the order is there.
    pub fn last(&self) -> usize {
        (self.options.bits.passes() as usize - 1) % 2
    }

    /// `in_turn`: buffers of the lengths of [`Self::written_in_turn`].
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
        let [reads, writes] = self.forms(pass);
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
                self.value_bits(),
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
