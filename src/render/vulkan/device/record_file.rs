//! A file in the cache folder that remembers what was found about a device.

use super::{cache, gpu::Gpu, identity::Identity};
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use std::{
    fs,
    path::{Path, PathBuf},
};

#[derive(Serialize, Deserialize)]
struct Identified<C> {
    identity: Identity,
    #[serde(flatten)]
    content: C,
}

/// The file: one for each driver build, device, and way to open it. Every failure to read or write
/// it only costs the time of finding out again: a file that is cut, or of another device, driver or
/// program, is as none.
pub(crate) struct RecordFile {
    path: Option<PathBuf>,
    identity: Identity,
}

impl RecordFile {
    /// `folder`: None remembers nothing. `name`: the start of the file's. `shaders`: a hash of the
    /// modules that the content is about.
    pub fn new(gpu: &Gpu, folder: Option<&Path>, name: &str, shaders: u64) -> Self {
        let key = gpu.probe.cache_key();
        let identity = Identity::new(gpu, shaders);
        // Two devices may share both UUIDs, and one device may be opened in two ways: neither must
        // write over what was found about the other.
        let device = identity.device_hash();
        Self {
            path: folder.map(|folder| folder.join(format!("{name}-{key}-{device:016x}.json"))),
            identity,
        }
    }

    /// Whether it is about this device, as it was opened.
    pub fn is_of(&self, gpu: &Gpu) -> bool {
        self.identity.is_of(gpu)
    }

    /// The content; the default if there is no file.
    pub fn read<C: DeserializeOwned + Default>(&self) -> C {
        let text = self.path.as_ref().and_then(|path| fs::read(path).ok());
        let read: Option<Identified<C>> = text.and_then(|text| serde_json::from_slice(&text).ok());
        read.filter(|read| read.identity == self.identity)
            .map_or_else(C::default, |read| read.content)
    }

    /// Replaces the content.
    pub fn write<C: Serialize>(&self, content: &C) {
        let Some(path) = &self.path else { return };
        let identified = Identified {
            identity: self.identity.clone(),
            content,
        };
        let written = serde_json::to_vec_pretty(&identified)
            .map_err(std::io::Error::other)
            .and_then(|text| cache::write(path, &text));
        if let Err(error) = written {
            tracing::debug!("{} was not written: {error}", path.display());
        }
    }

    /// Its path, for a message.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }
}
