//! The `features` stage: each part's network, θ_p ⊕ θ_e to e, and its nodes' displacements (model.md, steps 1 and 3).

use super::{
    device::Gpu,
    error::Result,
    model::Model,
    pipeline::{Bindings, Kernel, Slice},
    shaders,
};
use ash::vk;
use std::sync::Arc;

pub struct Features {
    kernel: Kernel,
}

impl Features {
    /// Writes to `pose`: features, then nodes in the order of their parts.
    pub fn new(gpu: &Arc<Gpu>, model: &Model, frame: Slice, pose: Slice) -> Result<Self> {
        let storage = [(&model.networks).into(), (&model.nodes).into(), (&model.node_starts).into(), pose];
        let bindings = Bindings::new(gpu, vk::ShaderStageFlags::COMPUTE, Some(frame), &storage)?;
        Ok(Self {
            kernel: Kernel::new(gpu, if model.networks_in_bytes { &shaders::FEATURES_BYTES } else { &shaders::FEATURES }, &[], bindings)?,
        })
    }

    /// Reads the frame's input and the networks; compute. `parts`: how many of the first parts hold all that the frame says is not idle.
    pub fn record(&self, commands: vk::CommandBuffer, frame: u32, parts: u32) {
        self.kernel.dispatch(commands, frame, parts);
    }
}
