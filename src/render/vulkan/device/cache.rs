//! The pipeline cache, kept on disk from run to run: the first use of a shader costs tens of
//! milliseconds on many drivers.

use super::{handle::PipelineCacheHandle, logical::Device, probe::Probe};
use ash::vk;
use effigy_core::io::file::write_whole;
use std::{
    fs, io,
    path::{Path, PathBuf},
    sync::Arc,
};

/// Begins the names of files with pipelines.
const PIPELINES: &str = "pipelines-";

/// Whether a folder has no compiled pipelines yet: the first program that draws with it waits for
/// the driver to compile shaders.
pub fn is_first_start(folder: Option<&Path>) -> bool {
    let files = folder.and_then(|folder| fs::read_dir(folder).ok());
    let mut names = files.into_iter().flatten().flatten();
    !names.any(|file| file.file_name().to_string_lossy().starts_with(PIPELINES))
}

/// Writes a file of the cache, and creates the folder if it is missing. It appears whole or not at
/// all, also when two programs write at once.
pub(crate) fn write(path: &Path, data: &[u8]) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    write_whole(path, data)
}

/// A pipeline cache and the file that it comes from. Every failure leaves a working, empty cache:
/// it only costs time.
pub(crate) struct PipelineCache {
    /// None where the device gave none.
    cache: Option<DeviceCache>,
    path: Option<PathBuf>,
    /// Bytes that came from the file.
    loaded: usize,
}

/// A Vulkan pipeline cache.
struct DeviceCache {
    handle: PipelineCacheHandle,
    device: Arc<Device>,
}

impl PipelineCache {
    /// No cache at all.
    pub(crate) fn none() -> Self {
        Self {
            cache: None,
            path: None,
            loaded: 0,
        }
    }

    /// One file a device and driver build. The driver checks the content; its header is compared
    /// here too, since not all do.
    pub(crate) fn open(device: &Arc<Device>, probe: &Probe, folder: Option<&Path>) -> Self {
        let name = format!("{PIPELINES}{}.bin", probe.cache_key());
        let path = folder.map(|folder| folder.join(name));
        let data = path
            .as_ref()
            .and_then(|path| fs::read(path).ok())
            .filter(|data| probe.wrote(data))
            .unwrap_or_default();
        let raw = create(device, &data)
            .or_else(|_| create(device, &[]))
            .unwrap_or_default();
        let cache = (raw != vk::PipelineCache::null()).then(|| DeviceCache {
            // SAFETY: the cache is new, and belongs to its owner.
            handle: unsafe { PipelineCacheHandle::new(device, raw, "pipelines") },
            device: device.clone(),
        });
        Self {
            cache,
            path,
            loaded: data.len(),
        }
    }

    /// The cache; null without a cache, which pipeline creation accepts.
    pub(crate) fn raw(&self) -> vk::PipelineCache {
        self.cache
            .as_ref()
            .map_or(vk::PipelineCache::null(), |cache| cache.handle.raw())
    }

    /// Writes what was added.
    pub(crate) fn save(&self) {
        let (Some(path), Some(cache)) = (&self.path, &self.cache) else {
            return;
        };
        // SAFETY: the cache is alive and of this device.
        let read = unsafe { cache.device.raw.get_pipeline_cache_data(cache.handle.raw()) };
        let Ok(data) = read else { return };
        if data.len() == self.loaded {
            return;
        }
        if let Err(error) = write(path, &data) {
            tracing::debug!(
                "the pipeline cache was not saved to {}: {error}",
                path.display()
            );
        }
    }
}

fn create(device: &Device, data: &[u8]) -> std::result::Result<vk::PipelineCache, vk::Result> {
    let info = vk::PipelineCacheCreateInfo::default().initial_data(data);
    // SAFETY: `info` outlives the call.
    unsafe { device.raw.create_pipeline_cache(&info, None) }
}

impl Probe {
    /// Names a file about this device and driver build: hexadecimal digits.
    pub(crate) fn cache_key(&self) -> String {
        self.cache_uuid
            .iter()
            .chain(&self.driver_uuid)
            .map(|byte| format!("{byte:02x}"))
            .collect()
    }

    /// Whether cache data has this device's header: length 32, version 1, vendor, device, cache
    /// UUID.
    fn wrote(&self, data: &[u8]) -> bool {
        let word = |at: usize| {
            data.get(at..at + 4)
                .map(|bytes| u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
        };
        word(4) == Some(1)
            && word(8) == Some(self.vendor)
            && word(12) == Some(self.device)
            && data.get(16..32) == Some(&self.cache_uuid)
    }
}
