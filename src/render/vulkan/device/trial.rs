//! The file that remembers what trials of variants found: one for each device and driver, in the
//! program's cache folder.

use super::{cache, gpu::Gpu, outcome::ATTEMPTS, record_file::RecordFile};
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use std::{
    fs,
    marker::PhantomData,
    path::{Path, PathBuf},
    sync::{Mutex, MutexGuard, PoisonError},
};

pub use super::outcome::{SortChoice, TrialOutcome, Tried};

/// The content of the file of a device's trials.
#[derive(Serialize, Deserialize)]
struct TrialRecord<V: Clone> {
    /// The variant under trial when this was written, and how many trials of it were begun.
    trying: Option<(V, u32)>,
    tried: Vec<Tried<V>>,
}

impl<V: Clone> Default for TrialRecord<V> {
    fn default() -> Self {
        Self {
            trying: None,
            tried: Vec::new(),
        }
    }
}

/// The trial that this program is in.
enum OngoingTrial {
    None,
    /// The trial that the file at this path names.
    Begun(Option<PathBuf>),
    /// The program ends: no trial is noted from now on.
    Withdrawn,
}

static TRIAL: Mutex<OngoingTrial> = Mutex::new(OngoingTrial::None);

fn trial() -> MutexGuard<'static, OngoingTrial> {
    TRIAL.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The program ends in good order: that a trial on some thread has no end says nothing about its
/// variant, and none is begun any more.
pub fn withdraw() {
    let mut trial = trial();
    if let OngoingTrial::Begun(Some(path)) = &*trial
        && let Some(text) = withdrawn(path)
        && let Err(error) = cache::write(path, text.as_bytes())
    {
        tracing::debug!("{} was not written: {error}", path.display());
    }
    *trial = OngoingTrial::Withdrawn;
}

/// A record without its last attempt.
fn withdrawn(path: &Path) -> Option<String> {
    let mut content: serde_json::Value = serde_json::from_slice(&fs::read(path).ok()?).ok()?;
    let trying = content.get_mut("trying")?;
    let attempts = trying.get(1)?.as_u64()?;
    if attempts > 1 {
        trying[1] = (attempts - 1).into();
    } else {
        *trying = serde_json::Value::Null;
    }
    serde_json::to_string_pretty(&content).ok()
}

/// What the file says.
pub(crate) struct Record<V> {
    file: RecordFile,
    variants: PhantomData<V>,
}

impl<V: Copy + PartialEq + Serialize + DeserializeOwned> Record<V> {
    /// `folder`: None remembers nothing. `name`: the start of the file's. `shaders`: a hash of the
    /// modules that are tried.
    pub fn new(gpu: &Gpu, folder: Option<&Path>, name: &str, shaders: u64) -> Self {
        Self {
            file: RecordFile::new(gpu, folder, name, shaders),
            variants: PhantomData,
        }
    }

    /// How each variant did that was tried before.
    pub fn read(&self) -> Vec<Tried<V>> {
        let mut content: TrialRecord<V> = self.file.read();
        let ended = content.trying.filter(|&(_, attempts)| attempts >= ATTEMPTS);
        content.tried.extend(ended.map(|(variant, _)| Tried {
            variant,
            outcome: TrialOutcome::Unfinished,
        }));
        content.tried
    }

    /// Notes that a variant's trial begins. What is not followed by [`Self::write`] counts against
    /// it, after a second time. False once the program ends: then nothing is to be tried.
    pub fn begin(&self, tried: &[Tried<V>], variant: V) -> bool {
        let mut trial = trial();
        if let OngoingTrial::Withdrawn = *trial {
            return false;
        }
        *trial = OngoingTrial::Begun(self.path().map(Path::to_path_buf));
        let content: TrialRecord<V> = self.file.read();
        let before = content.trying.filter(|&(trying, _)| trying == variant);
        self.file.write(&TrialRecord {
            trying: Some((variant, 1 + before.map_or(0, |(_, attempts)| attempts))),
            tried: tried.to_vec(),
        });
        true
    }

    /// Notes what was found so far.
    pub fn write(&self, tried: &[Tried<V>]) {
        let mut trial = trial();
        if let OngoingTrial::Begun(_) = *trial {
            *trial = OngoingTrial::None;
        }
        self.file.write(&TrialRecord {
            trying: None,
            tried: tried.to_vec(),
        });
    }

    /// Whether it is about this device, as it was opened.
    pub fn is_of(&self, gpu: &Gpu) -> bool {
        self.file.is_of(gpu)
    }

    /// The record's file, for a message.
    pub fn path(&self) -> Option<&Path> {
        self.file.path()
    }
}
