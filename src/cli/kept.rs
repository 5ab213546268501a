//! Avatars of mmlphuman's checkpoints, for commands that draw: distilled once, which takes minutes,
//! and kept in the program's cache folder.

use crate::distil::{self, DistilArgs, Job};
use anyhow::Context;
use effigy_core::{avatar::Avatar, io::file::write_whole, random::hash};
use effigy_formats::{
    mmlphuman,
    open::{self, ClipOptions},
    webavatar::ForeignAvatar,
};
use std::{
    fs,
    path::{Path, PathBuf},
    time::{SystemTime, UNIX_EPOCH},
};

/// Changes with how avatars are distilled, which makes those that are kept worthless.
const VERSION: u64 = 1;
/// Avatars that are kept, the newest: each has some 20 MB.
const KEPT: usize = 16;

/// Where the avatar of a checkpoint is kept.
struct KeptPlace {
    folder: PathBuf,
    /// Begins the names of all that were distilled of a file at this path.
    path: String,
    /// Says which file was there.
    file: String,
}

impl KeptPlace {
    /// None where the system has no folder for it, or says too little of the file.
    fn of(checkpoint: &Path) -> Option<Self> {
        let folder = effigy_runtime::cache::folder()?.join("distilled");
        let whole = fs::canonicalize(checkpoint).ok()?;
        let about = whole.metadata().ok()?;
        let changed = about.modified().ok()?.duration_since(UNIX_EPOCH).ok()?;
        let state = [VERSION, about.len(), changed.as_nanos() as u64];
        let state = state.map(u64::to_le_bytes);
        Some(Self {
            folder,
            path: format!("{:016x}-", hashed(whole.as_os_str().as_encoded_bytes())),
            file: format!("{:016x}.avatar", hashed(state.as_flattened())),
        })
    }

    fn avatar(&self) -> PathBuf {
        self.folder.join(format!("{}{}", self.path, self.file))
    }

    /// Keeps an avatar, and none of what was at its path before or was made long ago.
    fn keep(&self, avatar: &Avatar) -> anyhow::Result<()> {
        let file = self.avatar();
        fs::create_dir_all(&self.folder)?;
        let mut others: Vec<(SystemTime, PathBuf)> = Vec::new();
        for entry in fs::read_dir(&self.folder)?.flatten() {
            if entry.file_name().to_string_lossy().starts_with(&self.path) {
                // What can't be removed takes room and does no harm.
                let _ = fs::remove_file(entry.path());
            } else if let Ok(changed) = entry.metadata().and_then(|about| about.modified()) {
                others.push((changed, entry.path()));
            }
        }
        others.sort();
        for (_, old) in others.iter().rev().skip(KEPT - 1) {
            let _ = fs::remove_file(old);
        }
        write_whole(&file, &avatar.to_bytes()?).with_context(|| file.display().to_string())
    }
}

/// A number of some bytes that no build and no release of Rust changes: files are found by it.
fn hashed(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0, |sum, &byte| hash(sum ^ u64::from(byte)))
}

/// The avatar of a checkpoint: the one that was kept, else one that is distilled now as `effigy
/// import` does it unless told otherwise.
pub fn avatar(checkpoint: &Path) -> anyhow::Result<ForeignAvatar> {
    let job = Job {
        file: checkpoint,
        trained: &[],
        clips: &ClipOptions::default(),
        options: mmlphuman::Options::default(),
    };
    let place = KeptPlace::of(checkpoint);
    if let Some(place) = &place {
        // One that is cut or from a later version is distilled again.
        if let Ok(avatar) = Avatar::read(&place.avatar()) {
            tracing::info!("distilled before: {}", place.avatar().display());
            let taken = open::checkpoint(checkpoint, &job.options, |own| own.assumptions)?;
            return Ok(ForeignAvatar {
                avatar,
                assumptions: taken,
            });
        }
    }
    eprintln!(
        "{} is a training checkpoint of mmlphuman: an avatar is fitted to it, once, which takes \
         minutes",
        checkpoint.display()
    );
    let distilled = distil::run(&DistilArgs::default(), &job)?;
    eprintln!("{}", distil::likeness(&distilled.likeness));
    if let Some(place) = &place
        && let Err(error) = place.keep(&distilled.avatar)
    {
        tracing::warn!("the avatar can't be kept for the next time: {error:#}");
    }
    Ok(ForeignAvatar {
        avatar: distilled.avatar,
        // What the file left open was said when it was fitted.
        assumptions: vec![],
    })
}
