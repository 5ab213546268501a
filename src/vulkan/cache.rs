//! The pipeline cache, kept on disk from run to run: the first use of a shader costs tens of milliseconds on many drivers.

use super::probe::Probe;
use ash::vk;
use std::{
    fs,
    io::{self, Write},
    path::{Path, PathBuf},
    sync::OnceLock,
};

/// A folder that is to be used in place of the system's.
static FOLDER: OnceLock<PathBuf> = OnceLock::new();

/// Keeps caches in a folder from now on, where the system says only to the app itself which one is its own. The first call counts.
pub fn set_folder(folder: PathBuf) {
    let _ = FOLDER.set(folder);
}

/// The program's cache folder, where the system has such a thing. It may not exist yet.
pub fn folder() -> Option<PathBuf> {
    FOLDER.get().cloned().or_else(|| directories::ProjectDirs::from("", "", "effigy").map(|dirs| dirs.cache_dir().to_path_buf()))
}

/// Writes a file that appears whole or not at all, also when two programs write at once.
pub(super) fn write(path: &Path, data: &[u8]) -> io::Result<()> {
    let temporary = path.with_extension(format!("{}.tmp", std::process::id()));
    let written = path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| {
        fs::File::create(&temporary).and_then(|mut file| file.write_all(data).and_then(|()| file.sync_all()))?;
        fs::rename(&temporary, path)
    });
    if written.is_err() {
        let _ = fs::remove_file(&temporary);
    }
    written
}

/// A pipeline cache and the file that it comes from. Every failure leaves a working, empty cache: it only costs time.
pub struct PipelineCache {
    /// Null where the device gave none, which pipeline creation accepts.
    pub raw: vk::PipelineCache,
    path: Option<PathBuf>,
    loaded: usize,
}

impl PipelineCache {
    /// No cache at all.
    pub(super) fn none() -> Self {
        Self { raw: vk::PipelineCache::null(), path: None, loaded: 0 }
    }

    /// One file a device and driver build. The driver checks the content; its header is compared here too, since not all do.
    pub(super) fn open(device: &ash::Device, probe: &Probe) -> Self {
        let uuid: String = probe.cache_key().iter().map(|byte| format!("{byte:02x}")).collect();
        let path = folder().map(|folder| folder.join(format!("pipelines-{uuid}.bin")));
        let data = path.as_ref().and_then(|path| fs::read(path).ok()).filter(|data| probe.wrote(data)).unwrap_or_default();
        let create = |data: &[u8]| {
            let info = vk::PipelineCacheCreateInfo::default().initial_data(data);
            // SAFETY: `info` outlives the call.
            unsafe { device.create_pipeline_cache(&info, None) }
        };
        let raw = create(&data).or_else(|_| create(&[])).unwrap_or_default();
        Self { raw, path, loaded: data.len() }
    }

    /// Writes what was added.
    pub(super) fn save(&self, device: &ash::Device) {
        let Some(path) = &self.path else { return };
        // SAFETY: the cache is of this device.
        let Ok(data) = (unsafe { device.get_pipeline_cache_data(self.raw) }) else { return };
        if data.len() == self.loaded {
            return;
        }
        if let Err(error) = write(path, &data) {
            tracing::debug!("the pipeline cache was not saved to {}: {error}", path.display());
        }
    }

    pub(super) unsafe fn destroy(&self, device: &ash::Device) {
        // SAFETY: the caller drops the device next, so no pipeline is being made.
        unsafe { device.destroy_pipeline_cache(self.raw, None) };
    }
}

impl Probe {
    /// Names the cache file: driver build and device.
    pub(super) fn cache_key(&self) -> Vec<u8> {
        self.cache_uuid.iter().chain(&self.driver_uuid).copied().collect()
    }

    /// Whether cache data has this device's header: length 32, version 1, vendor, device, cache UUID.
    fn wrote(&self, data: &[u8]) -> bool {
        let word = |at: usize| data.get(at..at + 4).map(|bytes| u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]));
        word(4) == Some(1) && word(8) == Some(self.vendor) && word(12) == Some(self.device) && data.get(16..32) == Some(&self.cache_uuid)
    }
}
