//! The `sh` stage (spherical harmonics): the colour of each Gaussian as the camera sees it, for
//! avatars whose colours depend on that.

use super::{
    buffer::{STORAGE, filled},
    device::Gpu,
    error::Result,
    kernel::{Blocks, Bound, Kernel},
    model::Model,
    owned::Buffer,
};
use crate::wgsl;
use bytemuck::cast_slice;
use effigy_core::{
    avatar::Avatar,
    layout::{
        SH_WORKGROUP,
        sh::{SPLIT, groups, planes},
    },
};

pub struct SphericalHarmonics {
    kernel: Kernel,
    degree: usize,
    _coefficients: [Buffer; 2],
}

impl SphericalHarmonics {
    /// Writes to the colours in `model`. None for an avatar without harmonics.
    pub fn new(gpu: &Gpu, avatar: &Avatar, model: &Model, blocks: &Blocks) -> Result<Option<Self>> {
        let Some(coefficients) = &avatar.sh else {
            return Ok(None);
        };
        let groups = groups(coefficients.degree);
        let buffer = |name, range| {
            filled(
                gpu,
                name,
                cast_slice(&planes(avatar, coefficients, range)),
                STORAGE,
            )
        };
        let low = buffer("low harmonics", 0..groups.min(SPLIT))?;
        let high = buffer("high harmonics", SPLIT..groups.max(SPLIT))?;
        let (module, both) = match coefficients.degree {
            0 | 1 => (&wgsl::SH_1, false),
            2 => (&wgsl::SH_2, true),
            _ => (&wgsl::SH_3, true),
        };
        let bound = [
            blocks.frame(),
            (1, Bound::Write((&model.gaussians).into())),
            (2, Bound::Read((&low).into())),
            (3, Bound::Read((&high).into())),
        ];
        let kernel = Kernel::new(gpu, module, if both { &bound } else { &bound[..3] });
        Ok(Some(Self {
            kernel,
            degree: coefficients.degree,
            _coefficients: [low, high],
        }))
    }

    /// Highest degree.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Highest degree of an avatar's harmonics; None for one without.
    pub fn degree_of(avatar: &Avatar) -> Option<usize> {
        avatar.sh.as_ref().map(|sh| sh.degree)
    }

    /// Reads the frame's joints and the model, writes the model's colours of the Gaussians that are
    /// drawn.
    pub fn record(&self, pass: &mut wgpu::ComputePass, block: u32, gaussians: u32) {
        self.kernel
            .dispatch(pass, block, [gaussians.div_ceil(SH_WORKGROUP), 1]);
    }
}
