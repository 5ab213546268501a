//! The `harmonics` stage: the colour of each Gaussian as the camera sees it, for avatars whose colours depend on that.

use super::{
    device::Gpu,
    error::Result,
    memory::Buffer,
    model::Model,
    pipeline::{Bindings, Kernel, Slice},
    shaders,
};
pub use crate::layout::harmonics::bytes;
use crate::layout::harmonics::{SPLIT, groups, planes};
use crate::{avatar::Avatar, layout::HARMONICS_SIZE};
use ash::vk;
use bytemuck::cast_slice;
use std::sync::Arc;

pub struct Harmonics {
    kernel: Kernel,
    /// Kept alive for the kernel.
    _coefficients: [Buffer; 2],
}

impl Harmonics {
    /// Writes to the colours in `model`. None for an avatar without harmonics.
    pub fn new(gpu: &Arc<Gpu>, avatar: &Avatar, model: &Model, frame: Slice) -> Result<Option<Self>> {
        let Some(coefficients) = &avatar.harmonics else { return Ok(None) };
        let groups = groups(coefficients.degree);
        let buffer = |name, range| Buffer::with_data(gpu, name, cast_slice(&planes(avatar, coefficients, range)), USAGE);
        let low = buffer("low harmonics", 0..groups.min(SPLIT))?;
        let high = buffer("high harmonics", SPLIT..groups.max(SPLIT))?;
        let storage = [(&model.gaussians).into(), (&low).into(), (&high).into()];
        let bindings = Bindings::new(gpu, vk::ShaderStageFlags::COMPUTE, Some(frame), &storage)?;
        let kernel = Kernel::new(gpu, &shaders::HARMONICS, &[coefficients.degree as u32], bindings)?;
        Ok(Some(Self { kernel, _coefficients: [low, high] }))
    }

    /// Reads the frame's joints and the model, writes the model's colours of the Gaussians that are drawn; compute.
    pub fn record(&self, commands: vk::CommandBuffer, (frame, drawn): (u32, u32)) {
        self.kernel.dispatch(commands, frame, drawn.div_ceil(HARMONICS_SIZE));
    }
}

const USAGE: vk::BufferUsageFlags = vk::BufferUsageFlags::STORAGE_BUFFER;
