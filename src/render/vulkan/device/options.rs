//! Options for opening a device.

use std::{ffi::CStr, path::PathBuf};

/// How to choose and open a device.
#[derive(Clone, Debug, Default)]
pub struct GpuOptions {
    /// Part of a device's name, in any case, or its number in `effigy devices`. None: the first
    /// that can serve, GPUs before CPUs.
    pub device: Option<String>,
    /// Load the validation layer, synchronisation checks included.
    pub validation: bool,
    /// Use no more than every Vulkan 1.1 device has, as if the device were the least of them.
    pub baseline: bool,
    /// Ask what the driver's compiler makes of each pipeline. Nothing ever runs on a device opened
    /// so.
    pub statistics: bool,
    /// Folder for compiled pipelines, and for what self-tests and measurements found: later starts
    /// save their time. It is made where it is missing. None: nothing is kept.
    pub cache: Option<PathBuf>,
    /// Instance extensions of a window's surface; empty where no window is drawn to.
    pub surface_extensions: Vec<&'static CStr>,
}

impl GpuOptions {
    /// Without a window; validation as the environment variable `EFFIGY_VALIDATION` says (anything
    /// but 0 turns it on).
    pub fn headless(device: Option<String>) -> Self {
        let validation = std::env::var_os("EFFIGY_VALIDATION").is_some_and(|value| value != "0");
        Self {
            device,
            validation,
            ..Self::default()
        }
    }
}
