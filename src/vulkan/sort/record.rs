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
use std::{
    path::Path,
    sync::{Mutex, MutexGuard, PoisonError},
};

#[derive(Default, Serialize, Deserialize)]
struct Content {
    /// The variant under test when this was written, and how many such tests were begun.
    trying: Option<(SortVariant, u32)>,
    tried: Vec<TestedVariant>,
}

/// The self-test of this program.
#[derive(PartialEq)]
enum Test {
    None,
    /// That of the variant that the file names.
    Begun,
    /// The program ends: what is tested from now on is not noted.
    Withdrawn,
}

static TEST: Mutex<Test> = Mutex::new(Test::None);

fn test() -> MutexGuard<'static, Test> {
    TEST.lock().unwrap_or_else(PoisonError::into_inner)
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
        let mut test = test();
        if *test == Test::Withdrawn {
            return;
        }
        *test = Test::Begun;
        let content: Content = self.file.read();
        let before = content.trying.filter(|&(trying, _)| trying == variant);
        self.file.write(&Content {
            trying: Some((variant, 1 + before.map_or(0, |(_, attempts)| attempts))),
            tried: tried.to_vec(),
        });
    }

    /// The program ends in good order: that a test on some thread has no end says nothing about its
    /// variant.
    pub fn withdraw(&self) {
        let mut test = test();
        if *test == Test::Begun {
            let mut content: Content = self.file.read();
            content.trying = content
                .trying
                .map(|(variant, attempts)| (variant, attempts.saturating_sub(1)))
                .filter(|&(_, attempts)| attempts > 0);
            self.file.write(&content);
        }
        *test = Test::Withdrawn;
    }

    /// Notes what was found so far.
    pub fn write(&self, tried: &[TestedVariant]) {
        let mut test = test();
        if *test == Test::Begun {
            *test = Test::None;
        }
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
