//! The `mlp` stage: each part's network, θ_p ⊕ θ_e to e, and its nodes' displacements (model.md,
//! steps 1 and 3).

use super::{
    device::Gpu,
    kernel::{Blocks, Bound, Kernel},
    model::Model,
};
use crate::wgsl;

pub struct Mlp {
    kernel: Kernel,
}

impl Mlp {
    /// Writes to `pose`: features, then nodes in the order of their parts.
    pub fn new(gpu: &Gpu, model: &Model, blocks: &Blocks, pose: &wgpu::Buffer) -> Self {
        let bound = [
            blocks.frame(),
            (1, Bound::Read((&model.networks).into())),
            (2, Bound::Read((&model.nodes).into())),
            (3, Bound::Read((&model.node_starts).into())),
            (4, Bound::Write(pose.into())),
        ];
        let shader = if model.networks_in_bytes {
            &wgsl::MLP_BYTES
        } else {
            &wgsl::MLP
        };
        Self {
            kernel: Kernel::new(gpu, shader, &bound),
        }
    }

    /// `parts`: how many of the first parts hold all that the frame says is not idle.
    pub fn record(&self, pass: &mut wgpu::ComputePass, frame: u32, parts: u32) {
        self.kernel.dispatch(pass, frame, [parts, 1]);
    }
}
