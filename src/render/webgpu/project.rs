//! The `project` stage: from a Gaussian of the model to a splat on the screen and its depth key
//! (model.md, steps 2 and 4 to 8).

use super::{
    device::Gpu,
    kernel::{Blocks, Bound, Kernel},
    model::Model,
    splat_buffer::SplatBuffer,
};
use crate::wgsl;
use effigy_core::{frame::Skinning, layout::PROJECT_WORKGROUP};

/// The kernels of frames in which only the camera moves.
struct Caching {
    /// Computes posed Gaussians and stores them.
    store: Kernel,
    /// Projects the stored Gaussians.
    cached: Kernel,
}

/// The kernels of the stage for an avatar.
pub struct Project {
    compute: Kernel,
    /// None where poses are not cached.
    caching: Option<Caching>,
}

impl Project {
    /// `caches`: whether frames in which only the camera moves use the pose cache.
    pub fn new(
        gpu: &Gpu,
        model: &Model,
        blocks: &Blocks,
        pose: &wgpu::Buffer,
        splats: &SplatBuffer,
        caches: bool,
    ) -> Self {
        let all = model_bindings(model, 0, blocks, pose, splats);
        let cached = [
            (1, Bound::Write(splats.all())),
            (6, Bound::Write(splats.all_counts())),
            blocks.frame(),
            blocks.settings(),
        ];
        let caching = || Caching {
            store: Kernel::when_needed(gpu, &wgsl::PROJECT_STORE, &all),
            cached: Kernel::when_needed(gpu, &wgsl::PROJECT_CACHED, &cached),
        };
        let mut new = Self {
            compute: Kernel::new(gpu, &wgsl::PROJECT, &all),
            caching: caches.then(caching),
        };
        new.bind(gpu, model, blocks, pose, splats);
        new
    }

    /// Reads these sets of Gaussians from now on.
    pub fn bind(
        &mut self,
        gpu: &Gpu,
        model: &Model,
        blocks: &Blocks,
        pose: &wgpu::Buffer,
        splats: &SplatBuffer,
    ) {
        for set in 0..model.sets() {
            let bound = model_bindings(model, set, blocks, pose, splats);
            self.compute.set(gpu, set, &bound);
            if let Some(caching) = &mut self.caching {
                caching.store.set(gpu, set, &bound);
            }
        }
    }

    /// Projects one avatar, of which the first `gaussians` are drawn. `block`: offset of its
    /// uniform block, bytes. `model`: which of the avatar's levels; 0 is the avatar itself.
    pub fn record(
        &self,
        pass: &mut wgpu::ComputePass,
        block: u32,
        model: usize,
        gaussians: u32,
        skinning: Skinning,
    ) {
        let (kernel, turn) = match (skinning, &self.caching) {
            (Skinning::ComputeAndStore, Some(caching)) => (&caching.store, model),
            // Nothing of the model is read.
            (Skinning::Cached, Some(caching)) => (&caching.cached, 0),
            _ => (&self.compute, model),
        };
        let groups = [gaussians.div_ceil(PROJECT_WORKGROUP), 1];
        kernel.dispatch_turn(pass, turn, block, groups);
    }
}

/// What kernels that read a set of Gaussians are bound to.
fn model_bindings<'a>(
    model: &'a Model,
    set: usize,
    blocks: &'a Blocks,
    pose: &'a wgpu::Buffer,
    splats: &'a SplatBuffer,
) -> [(u32, Bound<'a>); 7] {
    [
        (1, Bound::Read(model.gaussians.set(set))),
        (2, Bound::Read(model.rows.set(set))),
        (3, Bound::Read(pose.into())),
        (4, Bound::Write(splats.all())),
        (6, Bound::Write(splats.all_counts())),
        blocks.frame(),
        blocks.settings(),
    ]
}
