//! What the self-test found, and the file that remembers it: one a device and driver, in the program's cache folder.

use super::Variant;
use crate::vulkan::{cache, device::Gpu, shaders};
use serde::{Deserialize, Serialize};
use std::{
    fmt, fs,
    path::{Path, PathBuf},
};

/// How a variant did.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Outcome {
    /// Right everywhere; the best time for the test's keys, ms.
    Right(f64),
    /// The device can't run it, or has no use for it.
    Lacks(String),
    /// It gave something else than the CPU, did not finish in time, or failed.
    Refused(String),
    /// The program ended in its test, more than once.
    Unfinished,
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Right(ms) => write!(f, "{ms:.3} ms"),
            Self::Lacks(why) => write!(f, "not used: {why}"),
            Self::Refused(why) => write!(f, "refused: {why}"),
            Self::Unfinished => write!(f, "refused: the program ended during its test, {ATTEMPTS} times"),
        }
    }
}

/// How to sort on a device, and why.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    pub variant: Variant,
    /// How each variant did.
    pub tried: Vec<(Variant, Outcome)>,
}

impl Verdict {
    /// The fastest that is right. None where none is.
    pub fn of(tried: &[(Variant, Outcome)]) -> Option<Self> {
        let time = |outcome: &Outcome| if let Outcome::Right(ms) = outcome { Some(*ms) } else { None };
        let right = tried.iter().filter_map(|(variant, outcome)| Some((*variant, time(outcome)?)));
        let (variant, _) = right.min_by(|a, b| a.1.total_cmp(&b.1))?;
        Some(Self { variant, tried: tried.to_vec() })
    }
}

/// How often a variant is tested whose test was never heard of again: it may have brought the program down, or the user ended that.
const ATTEMPTS: u32 = 2;

/// What a verdict depends on: with any of it changed, an old one says nothing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Identity {
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
    fn of(gpu: &Gpu) -> Self {
        let probe = &gpu.probe;
        Self {
            device: probe.name.clone(),
            driver: probe.driver.clone(),
            driver_version: probe.driver_version,
            driver_uuid: probe.driver_uuid,
            cache_uuid: probe.cache_uuid,
            program: env!("CARGO_PKG_VERSION").into(),
            shaders: shaders::sort_hash(),
            subgroup_size: probe.subgroup_size,
            subgroup_sizes: probe.subgroup_sizes,
            subgroup_ballot: probe.subgroup_ballot,
        }
    }
}

#[derive(Serialize, Deserialize)]
struct Content {
    identity: Identity,
    /// The variant under test when this was written, and how many such tests were begun.
    trying: Option<(Variant, u32)>,
    tried: Vec<(Variant, Outcome)>,
}

/// The file. Every failure to read or write it only costs the time of a test.
pub struct Record {
    path: Option<PathBuf>,
    identity: Identity,
}

impl Record {
    /// `folder`: None remembers nothing.
    pub fn new(gpu: &Gpu, folder: Option<&Path>) -> Self {
        let uuid: String = gpu.probe.cache_key().iter().map(|byte| format!("{byte:02x}")).collect();
        Self { path: folder.map(|folder| folder.join(format!("sort-{uuid}.json"))), identity: Identity::of(gpu) }
    }

    fn content(&self) -> Option<Content> {
        let text = fs::read(self.path.as_ref()?).ok()?;
        serde_json::from_slice::<Content>(&text).ok().filter(|content| content.identity == self.identity)
    }

    /// How each variant did that was tested before, here and by this program.
    pub fn read(&self) -> Vec<(Variant, Outcome)> {
        let Some(mut content) = self.content() else { return Vec::new() };
        let ended = content.trying.filter(|&(_, attempts)| attempts >= ATTEMPTS);
        content.tried.extend(ended.map(|(variant, _)| (variant, Outcome::Unfinished)));
        content.tried
    }

    /// Notes that a variant's test begins. What is not followed by [`Self::write`] counts against it, after a second time.
    pub fn begin(&self, tried: &[(Variant, Outcome)], variant: Variant) {
        let before = self.content().and_then(|content| content.trying).filter(|&(trying, _)| trying == variant);
        self.save(tried, Some((variant, 1 + before.map_or(0, |(_, attempts)| attempts))));
    }

    /// Notes what was found so far.
    pub fn write(&self, tried: &[(Variant, Outcome)]) {
        self.save(tried, None);
    }

    /// Where it is kept, for a message.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    fn save(&self, tried: &[(Variant, Outcome)], trying: Option<(Variant, u32)>) {
        let Some(path) = &self.path else { return };
        let content = Content { identity: self.identity.clone(), trying, tried: tried.to_vec() };
        let written = serde_json::to_vec_pretty(&content).map_err(std::io::Error::other).and_then(|text| cache::write(path, &text));
        if let Err(error) = written {
            tracing::debug!("the sort's verdict was not saved to {}: {error}", path.display());
        }
    }
}
