//! The `splats` stage: from a Gaussian of the model to a splat on the screen and its depth key (model.md, steps 2 and 4 to 8).

use super::{
    buffer::{STORAGE, Slice, empty},
    device::Gpu,
    error::Result,
    kernel::{Blocks, Bound, Kernel},
    model::Model,
    owned::Buffer,
    sort,
};
use crate::{
    frame::{Body, KeyBits, RendererOptions, Skip, scene::slots},
    layout::{Frame, POSED_WORDS, SPLATS_SIZE},
    webgpu::shaders,
};

/// Bytes of what counts the Gaussians left out for each reason, before the sort's counts.
pub const REASONS: u64 = 16;
/// Where in the counts those of the sort start, bytes.
const COUNTS_AT: u64 = 256;

pub struct Splats {
    computing: Kernel,
    /// Computes and keeps; draws what was kept. None where nothing is kept.
    keeping: Option<[Kernel; 2]>,
    /// Gaussians that there is room for: those of all avatars.
    capacity: u32,
    posed_start: u32,
    /// Splats, keys, and what is kept of the pose.
    buffer: Buffer,
    /// Reasons, then the sort's counts: all that atomics add to.
    counts: Buffer,
}

impl Splats {
    pub fn new(gpu: &Gpu, model: &Model, (blocks, pose): (&Blocks, &wgpu::Buffer), options: &RendererOptions) -> Result<Self> {
        let count = model.constants.gaussians;
        let capacity = options.actors as u32 * slots(count);
        // Whether frames in which only the camera moved shall find what it can't change.
        let keep = options.skip.contains(Skip::SKINNING);
        let keys = KeyBits::Sixteen.bytes(u64::from(capacity));
        let posed = (key_offset(capacity) + keys).next_multiple_of(256);
        let size = posed + if keep { 4 * u64::from(POSED_WORDS) * u64::from(capacity) } else { 0 };
        let buffer = empty(gpu, "splats", size, STORAGE)?;
        let counts = empty(gpu, "counts", COUNTS_AT + sort::counts_size(capacity, sort::variant(options)), STORAGE)?;
        let after = [(4, Bound::Write((&buffer).into())), (6, Bound::Write((&counts).into())), blocks.frame(), blocks.settings()];
        let model_and_pose =
            [(1, Bound::Read((&model.gaussians).into())), (2, Bound::Read((&model.rows).into())), (3, Bound::Read(pose.into()))];
        let all = [&model_and_pose[..], &after].concat();
        let kept = [
            (1, Bound::Read(pose.into())),
            (2, Bound::Write((&buffer).into())),
            (6, Bound::Write((&counts).into())),
            blocks.frame(),
            blocks.settings(),
        ];
        let keeping = || [Kernel::when_needed(gpu, &shaders::SPLATS_KEEP, &all), Kernel::when_needed(gpu, &shaders::SPLATS_POSED, &kept)];
        Ok(Self {
            computing: Kernel::new(gpu, &shaders::SPLATS, &all),
            keeping: keep.then(keeping),
            capacity,
            posed_start: (posed / 4) as u32,
            buffer,
            counts,
        })
    }

    /// Splats that there is room for.
    pub fn capacity(&self) -> u32 {
        self.capacity
    }

    /// Says in a frame's block where what is kept of an avatar is, by its place in the renderer.
    pub fn fill_actor(&self, block: &mut Frame, number: u32) {
        block.posed_start = self.posed_start + number * POSED_WORDS * block.gaussians;
    }

    /// Says in a frame's block where things are that are all avatars'.
    pub fn fill(&self, block: &mut Frame) {
        block.key_start = (key_offset(self.capacity) / 4) as u32;
        block.half_keys = 1;
        block.count_start = (COUNTS_AT / 4) as u32;
    }

    /// Splats, then the keys, then more.
    pub fn all(&self) -> Slice<'_> {
        (&self.buffer).into()
    }

    /// A key a Gaussian, larger is nearer.
    pub fn keys(&self) -> Slice<'_> {
        Slice { buffer: &self.buffer, offset: key_offset(self.capacity), size: KeyBits::Sixteen.bytes(u64::from(self.capacity)).max(4) }
    }

    /// Where the sort counts.
    pub fn counts(&self) -> Slice<'_> {
        Slice { buffer: &self.counts, offset: COUNTS_AT, size: self.counts.size() - COUNTS_AT }
    }

    /// How many Gaussians were left out for each reason: [`REASONS`] bytes.
    pub fn reasons(&self) -> Slice<'_> {
        Slice { buffer: &self.counts, offset: 0, size: REASONS }
    }

    /// Zeroes what this stage adds to.
    pub fn clear(&self, encoder: &mut wgpu::CommandEncoder) {
        encoder.clear_buffer(&self.counts, 0, Some(COUNTS_AT + sort::first_counts_size(self.capacity)));
    }

    /// One avatar's, of which so many Gaussians are drawn.
    pub fn record(&self, pass: &mut wgpu::ComputePass, (frame, drawn): (u32, u32), body: Body) {
        let kernel = match (body, &self.keeping) {
            (Body::Keep, Some([keep, _])) => keep,
            (Body::Kept, Some([_, kept])) => kept,
            _ => &self.computing,
        };
        kernel.dispatch(pass, frame, [drawn.div_ceil(SPLATS_SIZE), 1]);
    }
}

/// Where the keys of `count` Gaussians start, in bytes.
fn key_offset(count: u32) -> u64 {
    (16 * u64::from(count)).next_multiple_of(256)
}
