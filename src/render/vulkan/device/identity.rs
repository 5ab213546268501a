//! What a remembered measurement depends on: the device, its driver, and the program's shaders.

use super::gpu::Gpu;
use effigy_core::hash;
use serde::{Deserialize, Serialize};

/// Everything that a measurement on a device depends on. If any of it has changed, what is
/// remembered is ignored.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Identity {
    device: String,
    driver: String,
    driver_version: u32,
    driver_uuid: [u8; 16],
    cache_uuid: [u8; 16],
    program: String,
    shaders: u64,
    subgroup_size: u32,
    subgroup_sizes: Option<[u32; 2]>,
    subgroup_ballot: bool,
}

impl Identity {
    /// `shaders`: a hash of the modules that were measured.
    pub fn new(gpu: &Gpu, shaders: u64) -> Self {
        let probe = &gpu.probe;
        Self {
            device: probe.name.clone(),
            driver: probe.driver.clone(),
            driver_version: probe.driver_version,
            driver_uuid: probe.driver_uuid,
            cache_uuid: probe.cache_uuid,
            program: env!("CARGO_PKG_VERSION").into(),
            shaders,
            subgroup_size: probe.subgroup_size,
            subgroup_sizes: probe.subgroup_sizes,
            subgroup_ballot: probe.subgroup_ballot,
        }
    }

    /// Whether it is that of this device, as it was opened.
    pub fn is_of(&self, gpu: &Gpu) -> bool {
        *self == Self::new(gpu, self.shaders)
    }

    /// A hash of what tells devices, and ways to open one, apart: not of versions.
    pub fn device_hash(&self) -> u64 {
        let [least, most] = self.subgroup_sizes.unwrap_or_default();
        let numbers = [self.subgroup_size, least, most, self.subgroup_ballot.into()];
        let numbers = numbers.iter().flat_map(|number| number.to_le_bytes());
        hash::extend(hash::EMPTY, self.device.bytes().chain(numbers))
    }
}
