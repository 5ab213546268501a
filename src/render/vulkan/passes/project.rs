//! The `project` stage: from a Gaussian of the model to a splat on the screen and its depth key
//! (model.md, steps 2 and 4 to 8).
//!
//! While only the camera moves, posed Gaussians come from a cache: the first such frame stores
//! them, in its camera's space, and those after it only project them.

use super::{
    model::{GaussianSet, Model},
    splat_buffer::SplatBuffer,
};
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, recording::Recording},
    memory::Replacement,
    pipeline::{FrameMemory, Kernel, Launch, shaders},
};
use effigy_core::{
    frame::{
        Skinning,
        kernels::{self, KernelSpec},
        resource::Resource,
    },
    layout::PROJECT_WORKGROUP,
};
use std::sync::Arc;

/// The kernels of the stage for an avatar.
pub struct Project {
    /// Of the avatar, then of its levels, the finest first.
    sets: Vec<SetKernels>,
}

/// The kernels that project a set of Gaussians.
struct SetKernels {
    compute: Kernel,
    /// None where poses are not cached.
    caching: Option<Caching>,
}

/// The kernels of frames in which only the camera moves.
struct Caching {
    /// Computes posed Gaussians and stores them.
    store: Kernel,
    /// Projects the stored Gaussians.
    cached: Kernel,
}

impl Project {
    /// Reads the output of the `mlp` stage, and writes to the splats that `memory` names too.
    /// `caches`: whether frames in which only the camera moved use the pose cache.
    pub(crate) fn new(
        gpu: &Arc<Gpu>,
        model: &Model,
        memory: &FrameMemory,
        splats: &SplatBuffer,
        caches: bool,
    ) -> Result<Self> {
        let [counts, reasons] = splats.counting();
        let set = |set: &GaussianSet| -> Result<SetKernels> {
            let memory = memory
                .with(Resource::Gaussians, &set.gaussians)
                .with(Resource::Rows, &set.rows);
            let kernel = |spec: &KernelSpec, module, stores: u32| {
                let constants = [stores, counts, reasons];
                Kernel::of_frame(gpu, spec, module, &constants, &memory, Launch::default())
            };
            let caching = if caches {
                Some(Caching {
                    store: kernel(&kernels::PROJECT_STORE, &shaders::PROJECT, 1)?,
                    cached: kernel(&kernels::PROJECT_CACHED, &shaders::PROJECT_CACHED, 0)?,
                })
            } else {
                None
            };
            Ok(SetKernels {
                compute: kernel(&kernels::PROJECT, &shaders::PROJECT, 0)?,
                caching,
            })
        };
        Ok(Self {
            sets: model.sets.iter().map(set).collect::<Result<_>>()?,
        })
    }

    /// Binds the one buffer wherever the other was bound.
    ///
    /// # Safety
    /// No submitted work may use the stage, and the new buffer must outlive what will.
    pub unsafe fn replace(&mut self, replacement: Replacement) {
        for set in &mut self.sets {
            let caching = set.caching.iter_mut();
            let caching = caching.flat_map(|kernels| [&mut kernels.store, &mut kernels.cached]);
            for kernel in caching.chain([&mut set.compute]) {
                // SAFETY: the caller promises what the function asks for.
                unsafe { kernel.replace(replacement) };
            }
        }
    }

    /// Projects one avatar, of which the first `drawn` Gaussians are drawn. Reads the output of
    /// `mlp`, and adds to the counts that [`crate::vulkan::sort::Sort::clear`] zeroed; compute.
    ///
    /// `model`: which of the avatar's levels; 0 is the avatar itself.
    pub fn record(
        &self,
        commands: Recording,
        frame: u32,
        model: usize,
        drawn: u32,
        skinning: Skinning,
    ) {
        let set = &self.sets[model];
        let kernel = match (skinning, &set.caching) {
            (Skinning::ComputeAndStore, Some(caching)) => &caching.store,
            (Skinning::Cached, Some(caching)) => &caching.cached,
            _ => &set.compute,
        };
        kernel.dispatch(commands, frame, drawn.div_ceil(PROJECT_WORKGROUP));
    }
}
