//! The `nodes` stage: the displacement of each position node (model.md, step 3).

use super::{
    device::Gpu,
    error::Result,
    model::Model,
    pipeline::{Bindings, Kernel, Slice},
    shaders,
};
use crate::layout::NODES_SIZE;
use ash::vk;
use std::sync::Arc;

pub struct Nodes {
    kernel: Kernel,
    groups: u32,
}

impl Nodes {
    /// Reads the features at the start of `pose` and writes behind them.
    pub fn new(gpu: &Arc<Gpu>, model: &Model, frame: Slice, pose: Slice) -> Result<Self> {
        let bindings = Bindings::new(gpu, vk::ShaderStageFlags::COMPUTE, Some(frame), &[(&model.nodes).into(), pose])?;
        Ok(Self { kernel: Kernel::new(gpu, &shaders::NODES, &[], bindings)?, groups: model.constants.nodes.div_ceil(NODES_SIZE) })
    }

    /// Reads what `features` wrote; compute.
    pub fn record(&self, commands: vk::CommandBuffer, frame: u32) {
        self.kernel.dispatch(commands, frame, self.groups);
    }
}
