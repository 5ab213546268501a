//! The file that remembers what the self-test found: one a device and driver, in the program's
//! cache folder.

use crate::vulkan::{
    device::{
        gpu::Gpu,
        record_file::RecordFile,
        sort_choice::{ATTEMPTS, Outcome, TestedVariant},
    },
    pipeline::shaders,
};
use effigy_core::frame::SortVariant;
use serde::{Deserialize, Serialize};
use std::path::Path;

#[derive(Default, Serialize, Deserialize)]
struct Content {
    /// The variant under test when this was written, and how many such tests were begun.
    trying: Option<(SortVariant, u32)>,
    tried: Vec<TestedVariant>,
}

/// What the file says.
pub struct Record {
    file: RecordFile,
}

impl Record {
    /// `folder`: None remembers nothing.
    pub fn new(gpu: &Gpu, folder: Option<&Path>) -> Self {
        Self {
            file: RecordFile::new(gpu, folder, "sort", shaders::sort_hash()),
        }
    }

    /// How each variant did that was tested before, here and by this program.
    pub fn read(&self) -> Vec<TestedVariant> {
        let mut content: Content = self.file.read();
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
        let content: Content = self.file.read();
        let before = content.trying.filter(|&(trying, _)| trying == variant);
        self.file.write(&Content {
            trying: Some((variant, 1 + before.map_or(0, |(_, attempts)| attempts))),
            tried: tried.to_vec(),
        });
    }

    /// Notes what was found so far.
    pub fn write(&self, tried: &[TestedVariant]) {
        self.file.write(&Content {
            trying: None,
            tried: tried.to_vec(),
        });
    }

    /// The record's file, for a message.
    pub fn path(&self) -> Option<&Path> {
        self.file.path()
    }
}
