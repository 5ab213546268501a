//! The file that remembers what the self-test found: one a device and driver, in the program's
//! cache folder.

use crate::vulkan::{
    device::{
        cache,
        gpu::Gpu,
        identity::Identity,
        sort_choice::{ATTEMPTS, Outcome, TestedVariant},
    },
    pipeline::shaders,
};
use effigy_core::frame::SortVariant;
use serde::{Deserialize, Serialize};
use std::{
    fs,
    path::{Path, PathBuf},
};

#[derive(Serialize, Deserialize)]
struct Content {
    identity: Identity,
    /// The variant under test when this was written, and how many such tests were begun.
    trying: Option<(SortVariant, u32)>,
    tried: Vec<TestedVariant>,
}

/// The file. Every failure to read or write it only costs the time of a test.
pub struct Record {
    path: Option<PathBuf>,
    identity: Identity,
}

impl Record {
    /// `folder`: None remembers nothing.
    pub fn new(gpu: &Gpu, folder: Option<&Path>) -> Self {
        let key = gpu.probe.cache_key();
        Self {
            path: folder.map(|folder| folder.join(format!("sort-{key}.json"))),
            identity: Identity::new(gpu, shaders::hash("sort/")),
        }
    }

    fn content(&self) -> Option<Content> {
        let text = fs::read(self.path.as_ref()?).ok()?;
        serde_json::from_slice::<Content>(&text)
            .ok()
            .filter(|content| content.identity == self.identity)
    }

    /// How each variant did that was tested before, here and by this program.
    pub fn read(&self) -> Vec<TestedVariant> {
        let Some(mut content) = self.content() else {
            return Vec::new();
        };
        let ended = content.trying.filter(|&(_, attempts)| attempts >= ATTEMPTS);
        content
            .tried
            .extend(ended.map(|(variant, _)| TestedVariant {
                variant,
                outcome: Outcome::Unfinished,
            }));
        content.tried
    }

    /// Notes that a variant's test begins. What is not followed by [`Self::write`] counts against
    /// it, after a second time.
    pub fn begin(&self, tried: &[TestedVariant], variant: SortVariant) {
        let before = self
            .content()
            .and_then(|content| content.trying)
            .filter(|&(trying, _)| trying == variant);
        self.save(
            tried,
            Some((variant, 1 + before.map_or(0, |(_, attempts)| attempts))),
        );
    }

    /// Notes what was found so far.
    pub fn write(&self, tried: &[TestedVariant]) {
        self.save(tried, None);
    }

    /// The record's file, for a message.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    fn save(&self, tried: &[TestedVariant], trying: Option<(SortVariant, u32)>) {
        let Some(path) = &self.path else { return };
        let content = Content {
            identity: self.identity.clone(),
            trying,
            tried: tried.to_vec(),
        };
        let written = serde_json::to_vec_pretty(&content)
            .map_err(std::io::Error::other)
            .and_then(|text| cache::write(path, &text));
        if let Err(error) = written {
            tracing::debug!(
                "the sort's self-test was not saved to {}: {error}",
                path.display()
            );
        }
    }
}
