//! How an image is cut into tiles and bands.

use effigy_core::layout::TRAIN_RECORD;
use effigy_render::vulkan::Gpu;
use std::ops::Range;

/// Bands that a view may have.
pub(super) const MAX_BANDS: u32 = 64;

/// How the kernels of a tile are launched. Every shape gives the same image and derivative, but for
/// the order of sums.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TileShape {
    /// Side of a tile, px.
    pub side: u32,
    /// Invocations of a tile's workgroup.
    pub workgroup: u32,
    /// Pairs of a batch forward, and backward, where each pair needs shared memory.
    pub batches: [u32; 2],
    /// Largest pair capacity; views with more pairs are drawn in bands. A device's buffers may hold
    /// fewer.
    pub most_pairs: u32,
}

impl TileShape {
    /// For CPU drivers: a workgroup is as wide as a vector, so that it never waits for others.
    pub const CPU: Self = Self {
        side: 8,
        workgroup: 8,
        batches: [32, 32],
        most_pairs: u32::MAX,
    };
    /// For GPUs: many threads, and at most 16 KB that they share.
    pub const GPU: Self = Self {
        side: 16,
        workgroup: 64,
        batches: [32, 4],
        most_pairs: u32::MAX,
    };

    /// The one for a device.
    pub fn of(gpu: &Gpu) -> Self {
        if gpu.probe.is_cpu() {
            Self::CPU
        } else {
            Self::GPU
        }
    }

    /// The largest pair capacity that a device's buffers allow.
    pub(super) fn max_pairs(&self, gpu: &Gpu) -> u32 {
        let record = 4 * TRAIN_RECORD;
        let limit = gpu.probe.limits.max_storage_buffer_range / record;
        self.most_pairs.min(limit)
    }
}

/// How the image is cut, and the capacity for pairs.
#[derive(Clone, Copy, Debug)]
pub(super) struct BandTiling {
    /// Side of a tile, px.
    pub side: u32,
    /// Capacity for the pairs of a band.
    pub pairs: u32,
    /// Bands of rows of tiles, drawn one after the other where the pairs of all don't fit; at most
    /// [`MAX_BANDS`] and as many as there are rows.
    pub bands: u32,
}

impl BandTiling {
    /// Columns and rows of tiles of an image.
    pub fn tiles(&self, size: [u32; 2]) -> [u32; 2] {
        size.map(|side| side.div_ceil(self.side))
    }

    /// The rows of tiles of a band of an image.
    pub fn rows(&self, size: [u32; 2], band: u32) -> Range<u32> {
        let [_, rows] = self.tiles(size);
        let first = |band: u32| (u64::from(band) * u64::from(rows) / u64::from(self.bands)) as u32;
        first(band)..first(band + 1)
    }
}
