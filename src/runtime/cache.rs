//! The folder of what programs keep from start to start: compiled pipelines, and what was measured.

use effigy_render::vulkan::GpuOptions;
use std::{path::PathBuf, sync::OnceLock};

/// A folder that is to be used in place of the system's.
static FOLDER: OnceLock<PathBuf> = OnceLock::new();

/// Keeps things in a folder from now on, where the system says only to the app itself which one is
/// its own. The first call counts.
pub fn set_folder(folder: PathBuf) {
    let _ = FOLDER.set(folder);
}

/// The user's folder for it, where the system has such a thing. It may not exist yet.
pub fn folder() -> Option<PathBuf> {
    FOLDER.get().cloned().or_else(|| {
        directories::ProjectDirs::from("", "", "effigy").map(|dirs| dirs.cache_dir().to_path_buf())
    })
}

/// Options to open a device with, without a window, that keep things in [`folder`]. `device`: see
/// [`GpuOptions::device`].
pub fn headless(device: Option<String>) -> GpuOptions {
    GpuOptions {
        cache: folder(),
        ..GpuOptions::headless(device)
    }
}
