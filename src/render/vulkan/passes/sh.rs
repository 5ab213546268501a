//! The `sh` stage (spherical harmonics): the colour of each Gaussian as the camera sees it, for
//! avatars whose colours depend on that.

use super::{
    coefficients::Coefficients,
    model::{GaussianSet, Model},
};
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, recording::Recording},
    pipeline::{FrameMemory, Kernel, Launch, shaders},
};
use effigy_core::{
    frame::{kernels, resource::Resource},
    layout::SH_WORKGROUP,
};
use std::sync::Arc;

/// The kernels of the stage for an avatar.
pub struct SphericalHarmonics {
    /// Of the avatar, then of its levels; empty for an avatar without harmonics.
    sets: Vec<Kernel>,
}

impl SphericalHarmonics {
    /// Writes to the colours in the sets of `model`.
    pub(crate) fn new(gpu: &Arc<Gpu>, model: &Model, memory: &FrameMemory) -> Result<Self> {
        let kernel = |set: &GaussianSet, coefficients: &Coefficients| {
            let memory = memory
                .with(Resource::Gaussians, &set.gaussians)
                .with(Resource::LowHarmonics, &coefficients.low)
                .with(Resource::HighHarmonics, &coefficients.high);
            let degree = [coefficients.degree as u32];
            let launch = Launch::default();
            Kernel::of_frame(gpu, &kernels::SH, &shaders::SH, &degree, &memory, launch)
        };
        let sets = model
            .sets
            .iter()
            .filter_map(|set| Some(kernel(set, set.coefficients.as_ref()?)));
        Ok(Self {
            sets: sets.collect::<Result<_>>()?,
        })
    }

    /// Reads the frame's joints, the nodes and the model, writes the model's colours of the first
    /// `drawn` Gaussians; compute. `model`: which of the avatar's levels; 0 is the avatar itself.
    pub fn record(&self, commands: Recording, frame: u32, model: usize, drawn: u32) {
        let groups = drawn.div_ceil(SH_WORKGROUP);
        self.sets[model].dispatch(commands, frame, groups);
    }
}
