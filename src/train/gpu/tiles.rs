//! From splats to an image and back: pairs of splats and tiles, in order.

use super::arrays::words;
use super::block::Tiling;
use super::per_view::PerView;
use super::shaders;
use effigy::vulkan::compute::{
    Buffer, Kernel, Launch, Recording, Resources, Scope, Slice, Sort, SortOptions, without_test,
};
use effigy::vulkan::{Gpu, Result};
use effigy_core::frame::KeyBits;
use effigy_core::layout::{Control, TRAIN_BLOCK, TRAIN_RECORD, TRAIN_WORKGROUP};
use std::sync::Arc;

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
    /// Room for pairs at most: what is more is drawn in bands. A device's buffers may hold fewer.
    pub most_pairs: u32,
}

impl TileShape {
    /// For CPU drivers: a workgroup is as wide as a vector, so that it has nothing to wait for.
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
}

/// Pairs of splats and tiles, and the kernels that make and use them. Made again with more room, or
/// more bands, where a view's pairs don't fit.
pub(super) struct Tiles {
    count: Kernel,
    scan: Kernel,
    emit: Kernel,
    sort: Sort,
    ranges: Kernel,
    raster: Kernel,
    raster_backward: Kernel,
    pub records: Buffer,
    /// Sums over the bands so far, of each Gaussian.
    pub of_splats: Buffer,
    pub tiling: Tiling,
    blocks: u32,
    // What kernels and sort use.
    _control: Buffer,
    _words: Vec<Buffer>,
}

impl Tiles {
    pub fn new(
        gpu: &Arc<Gpu>,
        own: &PerView,
        shape: TileShape,
        tiling: Tiling,
        size: [u32; 2],
    ) -> Result<Self> {
        let pairs = tiling.pairs;
        let [columns, rows] = tiling.tiles(size);
        let gaussians = own.gaussians;
        let blocks = gaussians.div_ceil(TRAIN_BLOCK).max(1);
        let block_words = words(gpu, "pair counts", blocks as usize)?;
        let pair_keys = words(gpu, "pair keys", pairs as usize)?;
        let pair_gaussians = words(gpu, "pair Gaussians", pairs as usize)?;
        let range_words = words(gpu, "tile ranges", (columns * rows) as usize + 1)?;
        let records = words(gpu, "pair records", TRAIN_RECORD as usize * pairs as usize)?;
        let of_bands = (TRAIN_RECORD as usize + 1) * gaussians as usize;
        let of_splats = words(
            gpu,
            "splats' derivatives",
            if tiling.bands > 1 { of_bands } else { 1 },
        )?;
        let control = words(gpu, "pair control", size_of::<Control>() / 4)?;
        let options = SortOptions::new(KeyBits::TwentyTwo, without_test(gpu)?);
        // SAFETY: both buffers live as long as the sort, and `Gpu::run` waits for each submission.
        let sort = unsafe { Sort::new(gpu, (&pair_keys).into(), &control, pairs, options) }?;
        let kernel = |module, storage: &[Slice], constants: &[u32]| {
            let resources = Resources {
                uniform: Some(own.uniform()),
                storage,
                image: None,
            };
            Kernel::new(gpu, module, constants, resources, Launch::default())
        };
        let tile = [shape.side];
        let [batch, batch_backward] = shape.batches;
        let drawn = [shape.side, shape.workgroup, batch];
        let drawn_backward = [shape.side, shape.workgroup, batch_backward];
        let depth_order = own.sort.order();
        let pair_order = sort.order();
        Ok(Self {
            count: kernel(
                &shaders::TILES_COUNT,
                &[
                    (&own.control).into(),
                    depth_order,
                    (&own.splats).into(),
                    (&block_words).into(),
                ],
                &tile,
            )?,
            scan: kernel(
                &shaders::TILES_SCAN,
                &[
                    (&own.control).into(),
                    (&block_words).into(),
                    (&control).into(),
                    (&own.status).into(),
                ],
                &[],
            )?,
            emit: kernel(
                &shaders::TILES_EMIT,
                &[
                    (&own.control).into(),
                    depth_order,
                    (&own.splats).into(),
                    (&block_words).into(),
                    (&control).into(),
                    (&pair_keys).into(),
                    (&pair_gaussians).into(),
                    (&own.splat_pairs).into(),
                ],
                &tile,
            )?,
            ranges: kernel(
                &shaders::TILES_RANGES,
                &[
                    (&control).into(),
                    pair_order,
                    (&pair_keys).into(),
                    (&range_words).into(),
                ],
                &[],
            )?,
            raster: kernel(
                &shaders::RASTER,
                &[
                    (&range_words).into(),
                    pair_order,
                    (&pair_gaussians).into(),
                    (&own.splats).into(),
                    (&own.image).into(),
                ],
                &drawn,
            )?,
            raster_backward: kernel(
                &shaders::RASTER_BACKWARD,
                &[
                    (&range_words).into(),
                    pair_order,
                    (&pair_gaussians).into(),
                    (&own.splats).into(),
                    (&own.image).into(),
                    (&own.of_image).into(),
                    (&records).into(),
                ],
                &drawn_backward,
            )?,
            sort,
            records,
            of_splats,
            tiling,
            blocks,
            _control: control,
            _words: vec![block_words, pair_keys, pair_gaussians, range_words],
        })
    }

    /// Sorted splats to the pairs of a band, by tile. Ends with what [`Self::record_image`] reads.
    pub fn record_pairs(&self, commands: Recording, offset: u32, size: [u32; 2], band: u32) {
        let next = || commands.barrier(Scope::KERNEL, Scope::KERNEL);
        let [columns, rows] = self.tiles_of(size, band);
        self.count.dispatch(commands, offset, self.blocks);
        next();
        self.scan.dispatch(commands, offset, 1);
        next();
        self.emit.dispatch(commands, offset, self.blocks);
        next();
        self.sort.record(commands);
        next();
        let tiles = columns * rows + 1;
        self.ranges
            .dispatch(commands, offset, tiles.div_ceil(TRAIN_WORKGROUP));
        next();
    }

    /// A band's pairs to its part of the image.
    pub fn record_image(&self, commands: Recording, offset: u32, size: [u32; 2], band: u32) {
        self.raster
            .dispatch_2d(commands, offset, self.tiles_of(size, band));
    }

    /// The image's derivative to records of a band's pairs.
    pub fn record_backward(&self, commands: Recording, offset: u32, size: [u32; 2], band: u32) {
        self.raster_backward
            .dispatch_2d(commands, offset, self.tiles_of(size, band));
    }

    /// Columns and rows of tiles of a band.
    fn tiles_of(&self, size: [u32; 2], band: u32) -> [u32; 2] {
        let [columns, _] = self.tiling.tiles(size);
        [columns, self.tiling.rows(size, band).len() as u32]
    }
}
