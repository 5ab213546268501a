//! The `features` stage: each part's network, θ_p ⊕ θ_e to e (model.md, step 1).

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
    parts: u32,
    head_parts: u32,
}

impl Features {
    /// Writes to the start of `pose`.
    pub fn new(gpu: &Arc<Gpu>, model: &Model, frame: Slice, pose: Slice) -> Result<Self> {
        let bindings = Bindings::new(gpu, vk::ShaderStageFlags::COMPUTE, Some(frame), &[(&model.networks).into(), pose])?;
        Ok(Self {
            kernel: Kernel::new(gpu, &shaders::FEATURES, &[], bindings)?,
            parts: model.constants.parts,
            head_parts: model.constants.head_parts,
        })
    }

    /// Reads the frame's input and the networks; compute. `head`: only the head's, which come first.
    pub fn record(&self, commands: vk::CommandBuffer, frame: u32, head: bool) {
        self.kernel.dispatch(commands, frame, if head { self.head_parts } else { self.parts });
    }
}
