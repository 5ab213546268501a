//! Devices that Effigy opens.

use crate::Result;
use effigy_render::vulkan;
use std::{path::PathBuf, sync::Arc};

/// How to choose and open a device.
#[derive(Clone, Debug, Default)]
pub struct GpuOptions(pub(crate) vulkan::GpuOptions);

impl GpuOptions {
    /// The first device that can serve, GPUs before CPUs; nothing is kept on disk.
    pub fn new() -> Self {
        Self::default()
    }

    /// A device by a part of its name, in any case, or by its number in the loader's order.
    pub fn device(mut self, name: impl Into<String>) -> Self {
        self.0.device = Some(name.into());
        self
    }

    /// Keeps compiled pipelines, and what self-tests and measurements found, in a folder, which is
    /// made where it is missing. Later starts save their time, a part of a second to some seconds.
    pub fn cache(mut self, folder: impl Into<PathBuf>) -> Self {
        self.0.cache = Some(folder.into());
        self
    }

    /// Loads the validation layer, synchronisation checks included.
    pub fn validation(mut self, is_on: bool) -> Self {
        self.0.validation = is_on;
        self
    }
}

/// A Vulkan device. Clones are the same device.
#[derive(Clone)]
pub struct Gpu(pub(crate) Arc<vulkan::Gpu>);

impl Gpu {
    /// Opens a device.
    ///
    /// # Errors
    /// When there is no Vulkan loader, no device of that name, or none that has what Effigy needs:
    /// the error says what was found and what is missing.
    pub fn new(options: &GpuOptions) -> Result<Self> {
        vulkan::Gpu::new(&options.0).map(Self)
    }

    /// The device's name.
    pub fn name(&self) -> &str {
        &self.0.probe.name
    }

    /// The driver's name and version.
    pub fn driver(&self) -> &str {
        &self.0.probe.driver
    }
}
