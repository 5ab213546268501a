//! The `mlp` stage: each part's network, θ_p ⊕ θ_e to e, and its nodes' displacements (model.md,
//! steps 1 and 3).

use super::model::Model;
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, recording::Recording},
    pipeline::{FrameMemory, Kernel, Launch, shaders},
};
use effigy_core::frame::{kernels, resource::Resource};
use std::sync::Arc;

/// The kernel of the stage, bound to a model's networks and nodes.
pub struct Mlp {
    kernel: Kernel,
}

impl Mlp {
    /// Writes features, then nodes in the order of their parts.
    pub(crate) fn new(gpu: &Arc<Gpu>, model: &Model, memory: &FrameMemory) -> Result<Self> {
        let memory = memory
            .with(Resource::Networks, &model.networks)
            .with(Resource::Nodes, &model.nodes)
            .with(Resource::NodeStarts, &model.node_starts);
        let module = if model.networks_in_bytes {
            &shaders::MLP_BYTES
        } else {
            &shaders::MLP
        };
        Ok(Self {
            kernel: Kernel::of_frame(gpu, &kernels::MLP, module, &[], &memory, Launch::default())?,
        })
    }

    /// Reads the frame's input and the networks; compute. `parts`: how many of the first parts hold
    /// all that the frame says is not idle.
    pub fn record(&self, commands: Recording, frame: u32, parts: u32) {
        self.kernel.dispatch(commands, frame, parts);
    }
}
