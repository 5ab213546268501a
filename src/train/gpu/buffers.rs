//! All memory that the kernels bind.

use super::arrays::{Fixed, Learned, filled, read, words, written};
use super::block::STRIDE;
use super::state::TrainerState;
use super::tiling::{BandTiling, MAX_BANDS};
use crate::parameters::ParameterLayout;
use crate::topology::{CorrectiveRows, Topology};
use effigy_core::frame::KeyBits;
use effigy_core::layout::{Control, TRAIN_BLOCK, TRAIN_LOSS_SUMS, TRAIN_RECORD, TRAIN_WORKGROUP};
use effigy_render::vulkan::compute::{
    Buffer, BufferUsageFlags, MemoryLocation, Slice, Sort, SortOptions, without_test,
};
use effigy_render::vulkan::{Gpu, Result};
use std::sync::Arc;

/// Sums of a workgroup of pixels: |difference|, its square, and the derivative of the gain.
pub(super) type LossSums = [f32; TRAIN_LOSS_SUMS as usize];

/// Workgroups for so many invocations.
pub(super) fn groups(count: usize) -> u32 {
    count.div_ceil(TRAIN_WORKGROUP as usize) as u32
}

/// How large a training's views are, and how many a step has at most.
#[derive(Clone, Copy)]
pub(super) struct Batch {
    /// Width and height of every view, px.
    pub size: [u32; 2],
    /// Views of a step, at most.
    pub views: usize,
}

impl Batch {
    /// Pixels of a view.
    pub fn pixels(&self) -> usize {
        self.size[0] as usize * self.size[1] as usize
    }
}

/// What the host writes for each step.
pub(super) struct HostInputs {
    pub joints: Buffer,
    pub inputs: Buffer,
    pub pictures: Buffer,
    pub behind: Buffer,
}

impl HostInputs {
    fn new(gpu: &Arc<Gpu>, topology: &Topology, batch: Batch) -> Result<Self> {
        let Batch { views, .. } = batch;
        let pixels = batch.pixels() * views;
        Ok(Self {
            joints: written(gpu, "posed joints", 12 * topology.joints * views)?,
            inputs: written(gpu, "network inputs", topology.widths[0] * views)?,
            pictures: written(gpu, "pictures", pixels)?,
            behind: written(gpu, "backgrounds", pixels)?,
        })
    }
}

/// What kernels keep of every view of a step.
pub(super) struct BatchBuffers {
    pub activations: Buffer,
    pub of_sums: Buffer,
    pub displaced: Buffer,
    pub of_nodes: Buffer,
    pub of_gaussians: Buffer,
    pub of_joints: Buffer,
    pub loss_sums: Buffer,
}

impl BatchBuffers {
    fn new(
        gpu: &Arc<Gpu>,
        topology: &Topology,
        layout: &ParameterLayout,
        batch: Batch,
    ) -> Result<Self> {
        let Batch { views, .. } = batch;
        let widths: usize = topology.widths[1..].iter().sum();
        let activations = widths * layout.parts * views;
        let loss_sums = TRAIN_LOSS_SUMS as usize * groups(batch.pixels()) as usize * views;
        Ok(Self {
            activations: words(gpu, "activations", activations)?,
            of_sums: words(gpu, "activations' derivatives", activations)?,
            displaced: words(gpu, "displaced nodes", 4 * layout.nodes * views)?,
            of_nodes: words(gpu, "nodes' derivatives", 4 * layout.nodes * views)?,
            of_gaussians: words(gpu, "Gaussians' derivatives", 16 * layout.gaussians * views)?,
            of_joints: read(gpu, "joints' derivatives", 12 * topology.joints * views)?,
            loss_sums: read(gpu, "loss sums", loss_sums)?,
        })
    }
}

/// What the stages of a view share, used for one view after the other.
pub(super) struct ViewBuffers {
    pub sort: Sort,
    pub blocks: Buffer,
    pub control: Buffer,
    pub splats: Buffer,
    pub splat_pairs: Buffer,
    pub image: Buffer,
    pub of_image: Buffer,
    pub status: Buffer,
    pub canonical: Buffer,
    pub keys: Buffer,
    pub asked: Buffer,
    pub of_skinning: Buffer,
}

impl ViewBuffers {
    fn new(gpu: &Arc<Gpu>, gaussians: usize, batch: Batch) -> Result<Self> {
        let key_count = gaussians as u32;
        let pixels = batch.pixels();
        let keys = words(gpu, "depth keys", gaussians)?;
        let start = Control {
            key_count,
            ..Control::default()
        };
        let control = filled(gpu, "control", &[start])?;
        let options = SortOptions::new(KeyBits::ThirtyTwo, without_test(gpu)?);
        // SAFETY: both buffers live as long as the sort, and `Gpu::run` waits for each submission.
        let sort = unsafe { Sort::new(gpu, (&keys).into(), &control, key_count, options) }?;
        Ok(Self {
            sort,
            blocks: Buffer::new(
                gpu,
                "view blocks",
                STRIDE * u64::from(MAX_BANDS) * batch.views as u64,
                BufferUsageFlags::UNIFORM_BUFFER,
                MemoryLocation::CpuToGpu,
            )?,
            control,
            splats: words(gpu, "training splats", 12 * gaussians)?,
            splat_pairs: words(gpu, "splat pairs", 2 * gaussians)?,
            image: words(gpu, "training image", 4 * pixels)?,
            of_image: words(gpu, "image derivative", 4 * pixels)?,
            status: read(gpu, "training status", 4)?,
            canonical: words(gpu, "canonical Gaussians", 16 * gaussians)?,
            keys,
            of_skinning: words(gpu, "skinning derivatives", 12 * gaussians)?,
            asked: filled(gpu, "asked of the image", &vec![0.0f32; 4 * pixels])?,
        })
    }

    /// The block of the first band of the first view; others follow at offsets.
    pub fn uniform(&self) -> Slice {
        Slice::from(&self.blocks).part(0, STRIDE)
    }
}

/// All memory whose size does not depend on the number of pairs.
pub(super) struct TrainerBuffers {
    pub inputs: HostInputs,
    pub batch: BatchBuffers,
    pub view: ViewBuffers,
    pub fixed: Fixed,
    pub parameters: Learned,
    pub first_moments: Learned,
    pub second_moments: Learned,
}

impl TrainerBuffers {
    pub fn new(
        gpu: &Arc<Gpu>,
        topology: &Topology,
        rows: &CorrectiveRows,
        state: &TrainerState,
        batch: Batch,
    ) -> Result<Self> {
        let layout = ParameterLayout::new(topology, rows);
        let learned = |name, numbers| Learned::new(gpu, name, &layout, numbers);
        Ok(Self {
            view: ViewBuffers::new(gpu, layout.gaussians, batch)?,
            inputs: HostInputs::new(gpu, topology, batch)?,
            batch: BatchBuffers::new(gpu, topology, &layout, batch)?,
            fixed: Fixed::new(gpu, topology, rows)?,
            parameters: learned("parameters", &state.parameters)?,
            first_moments: learned("first moments", &state.first_moments)?,
            second_moments: learned("second moments", &state.second_moments)?,
        })
    }
}

/// Memory for the pairs of splats and tiles of a band.
pub(super) struct PairBuffers {
    pub sort: Sort,
    pub control: Buffer,
    /// Pairs of each block of splats.
    pub blocks: Buffer,
    pub keys: Buffer,
    pub gaussians: Buffer,
    pub ranges: Buffer,
    pub records: Buffer,
    /// Sums over the bands so far, of each Gaussian.
    pub of_splats: Buffer,
}

impl PairBuffers {
    pub fn new(
        gpu: &Arc<Gpu>,
        gaussians: usize,
        tiling: BandTiling,
        size: [u32; 2],
    ) -> Result<Self> {
        let pairs = tiling.pairs as usize;
        let [columns, rows] = tiling.tiles(size);
        let blocks = gaussians.div_ceil(TRAIN_BLOCK as usize).max(1);
        let of_splats = if tiling.bands > 1 {
            (TRAIN_RECORD as usize + 1) * gaussians
        } else {
            1
        };
        let keys = words(gpu, "pair keys", pairs)?;
        let control = words(gpu, "pair control", size_of::<Control>() / 4)?;
        let options = SortOptions::new(KeyBits::TwentyTwo, without_test(gpu)?);
        // SAFETY: both buffers live as long as the sort, and `Gpu::run` waits for each submission.
        let sort = unsafe { Sort::new(gpu, (&keys).into(), &control, tiling.pairs, options) }?;
        Ok(Self {
            sort,
            control,
            blocks: words(gpu, "pair counts", blocks)?,
            keys,
            gaussians: words(gpu, "pair Gaussians", pairs)?,
            ranges: words(gpu, "tile ranges", (columns * rows) as usize + 1)?,
            records: words(gpu, "pair records", TRAIN_RECORD as usize * pairs)?,
            of_splats: words(gpu, "splats' derivatives", of_splats)?,
        })
    }
}
