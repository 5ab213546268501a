//! The `harmonics` stage: the colour of each Gaussian as the camera sees it, for avatars whose colours depend on that.

use super::{
    device::Gpu,
    error::Result,
    memory::Buffer,
    model::Model,
    pipeline::{Bindings, Kernel, Slice},
    shaders,
};
use crate::{
    avatar::{Avatar, Harmonics as Coefficients, limits},
    layout::HARMONICS_SIZE,
};
use ash::vk;
use bytemuck::cast_slice;
use half::f16;
use std::sync::Arc;

/// Functions that three half quads hold the RGB of.
const GROUP: usize = 4;
/// Groups in the first of the two buffers.
const SPLIT: usize = 2;

/// Bytes of a group's half quads.
const GROUP_BYTES: usize = 2 * 3 * GROUP;
const _: () = assert!(SPLIT * GROUP_BYTES * limits::GAUSSIANS <= 128 << 20, "128 MiB is the range of a storage buffer everywhere");

pub struct Harmonics {
    kernel: Kernel,
    groups: u32,
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
        Ok(Some(Self { kernel, groups: model.constants.gaussians.div_ceil(HARMONICS_SIZE), _coefficients: [low, high] }))
    }

    /// Reads the frame's joints and the model, writes the model's colours; compute.
    pub fn record(&self, commands: vk::CommandBuffer, frame: u32) {
        self.kernel.dispatch(commands, frame, self.groups);
    }
}

const USAGE: vk::BufferUsageFlags = vk::BufferUsageFlags::STORAGE_BUFFER;

/// Groups of functions up to a degree, the constant one among them.
fn groups(degree: usize) -> usize {
    (degree + 1).pow(2).div_ceil(GROUP)
}

/// Planes of half quads, one entry a Gaussian; see `shaders/harmonics.comp`.
fn planes(avatar: &Avatar, harmonics: &Coefficients, groups: std::ops::Range<usize>) -> Vec<[f16; 4]> {
    let (count, functions) = (avatar.gaussians.len(), harmonics.functions());
    let mut data = vec![[f16::ZERO; 4]; 3 * groups.len() * count];
    for gaussian in 0..count {
        let neutral = std::iter::once(&avatar.gaussians.color[gaussian]);
        let all = neutral.chain(&harmonics.coefficients[gaussian * functions..][..functions]);
        let within = all.skip(GROUP * groups.start).take(GROUP * groups.len());
        for (at, &value) in within.flatten().enumerate() {
            data[at / 4 * count + gaussian][at % 4] = value;
        }
    }
    data
}

/// Device memory that an avatar's harmonics take, bytes.
pub fn bytes(avatar: &Avatar) -> u64 {
    avatar.harmonics.as_ref().map_or(0, |harmonics| (GROUP_BYTES * groups(harmonics.degree) * avatar.gaussians.len()) as u64)
}
