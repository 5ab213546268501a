//! Coefficients of spherical harmonics on the device.

use crate::vulkan::{
    device::{error::Result, gpu::Gpu},
    memory::Buffer,
};
use ash::vk;
use bytemuck::cast_slice;
use effigy_core::{
    avatar::Avatar,
    layout::sh::{SPLIT, groups, planes},
};
use std::sync::Arc;

/// The coefficients of a set of Gaussians on the device.
pub struct Coefficients {
    /// Highest degree.
    pub degree: usize,
    /// Of the first functions.
    pub low: Buffer,
    /// Of the others.
    pub high: Buffer,
}

impl Coefficients {
    /// Those of an avatar's own Gaussians. None for an avatar without harmonics.
    pub fn new(gpu: &Arc<Gpu>, avatar: &Avatar) -> Result<Option<Self>> {
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
        Ok(Some(Self {
            degree: coefficients.degree,
            low: buffer("low harmonics", 0..groups.min(SPLIT))?,
            high: buffer("high harmonics", SPLIT..groups.max(SPLIT))?,
        }))
    }
}
