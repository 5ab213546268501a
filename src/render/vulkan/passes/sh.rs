//! The `sh` stage (spherical harmonics): the colour of each Gaussian as the camera sees it, for
//! avatars whose colours depend on that.

use super::model::{GaussianSet, Model};
use crate::vulkan::{
    device::{error::Result, gpu::Gpu, recording::Recording},
    memory::Buffer,
    pipeline::{FrameMemory, Kernel, Launch, shaders},
};
use ash::vk;
use bytemuck::cast_slice;
use effigy_core::{
    avatar::Avatar,
    frame::{kernels, resource::Resource},
    layout::{
        SH_WORKGROUP,
        sh::{SPLIT, groups, planes},
    },
};
use std::sync::Arc;

/// The kernel of the stage, with the coefficients of an avatar.
pub struct SphericalHarmonics {
    kernel: Kernel,
    /// Kept alive for the kernel.
    _coefficients: [Buffer; 2],
}

impl SphericalHarmonics {
    /// The kernels of an avatar, then of its levels; empty for an avatar without harmonics.
    pub(crate) fn of_model(
        gpu: &Arc<Gpu>,
        avatar: &Avatar,
        model: &Model,
        memory: &FrameMemory,
    ) -> Result<Vec<Self>> {
        let Some(own) = Self::new(gpu, avatar, model.own(), memory)? else {
            return Ok(vec![]);
        };
        let mut all = vec![own];
        let levels = avatar.levels.iter().map(|level| avatar.at_level(level));
        for (level, set) in levels.zip(&model.sets[1..]) {
            all.extend(Self::new(gpu, &level, set, memory)?);
        }
        Ok(all)
    }

    /// Writes to the colours in `set`, the avatar's Gaussians. None for an avatar without
    /// harmonics.
    fn new(
        gpu: &Arc<Gpu>,
        avatar: &Avatar,
        set: &GaussianSet,
        memory: &FrameMemory,
    ) -> Result<Option<Self>> {
        let Some(coefficients) = &avatar.sh else {
            return Ok(None);
        };
        let groups = groups(coefficients.degree);
        let buffer = |name, range| {
            Buffer::with_data(
                gpu,
                name,
                cast_slice(&planes(avatar, coefficients, range)),
                vk::BufferUsageFlags::STORAGE_BUFFER,
            )
        };
        let low = buffer("low harmonics", 0..groups.min(SPLIT))?;
        let high = buffer("high harmonics", SPLIT..groups.max(SPLIT))?;
        let memory = memory
            .with(Resource::Gaussians, &set.gaussians)
            .with(Resource::LowHarmonics, &low)
            .with(Resource::HighHarmonics, &high);
        let degree = [coefficients.degree as u32];
        let launch = Launch::default();
        let kernel = Kernel::of_frame(gpu, &kernels::SH, &shaders::SH, &degree, &memory, launch)?;
        Ok(Some(Self {
            kernel,
            _coefficients: [low, high],
        }))
    }

    /// Reads the frame's joints, the nodes and the model, writes the model's colours of the first
    /// `drawn` Gaussians; compute.
    pub fn record(&self, commands: Recording, frame: u32, drawn: u32) {
        let groups = drawn.div_ceil(SH_WORKGROUP);
        self.kernel.dispatch(commands, frame, groups);
    }
}
