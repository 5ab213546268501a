//! Options of a sort, and the size of its counts.

use crate::vulkan::{device::gpu::Gpu, memory::Slice};
use effigy_core::frame::{KeyBits, SortVariant};

/// Why a device can't run a variant at all.
pub fn unsupported(variant: SortVariant, gpu: &Gpu) -> Option<&'static str> {
    match variant {
        SortVariant::OneSweep if !gpu.probe.subgroup_ballot => {
            Some("the device has no subgroup ballots in compute shaders")
        }
        _ => None,
    }
}

/// Options of a sort.
#[derive(Clone, Copy)]
pub struct SortOptions {
    /// Width of the keys.
    pub bits: KeyBits,
    /// The variant that sorts; [`unsupported`] tells whether the device can run it.
    pub variant: SortVariant,
    /// Where the counts lie; [`counts_size`] bytes at an offset for storage buffers, in a buffer
    /// with transfer usage. None: the sort's own.
    pub counts: Option<Slice>,
    /// For tests of OneSweep: every so many tiles, one never tells its counts. 0: none.
    pub stall: u32,
    /// For OneSweep: lanes of a subgroup, of those in `Probe::subgroup_sizes`.
    pub subgroup: Option<u32>,
}

impl SortOptions {
    /// For a sort with counts of its own, at the driver's subgroup size.
    pub fn new(bits: KeyBits, variant: SortVariant) -> Self {
        Self {
            bits,
            variant,
            counts: None,
            stall: 0,
            subgroup: None,
        }
    }
}

/// Bytes that the counts of a sort take.
pub fn counts_size(capacity: u32, variant: SortVariant) -> u64 {
    variant.counts_size(tiles(capacity, variant))
}

pub(crate) fn tiles(capacity: u32, variant: SortVariant) -> u32 {
    capacity.div_ceil(variant.tile()).max(1)
}
