//! Avatars of mmlphuman's checkpoints, for commands that draw: distilled once, which takes minutes,
//! and kept in the program's cache folder.

use crate::distil::{self, DistilArgs, Job};
use anyhow::Context;
use effigy::vulkan::cache;
use effigy_core::{avatar::Avatar, io::file::write_whole};
use effigy_formats::{mmlphuman, open::ClipOptions, webavatar::Imported};
use std::{
    fs,
    hash::{DefaultHasher, Hash, Hasher},
    path::{Path, PathBuf},
};

/// Changes with how avatars are distilled, which makes those that are kept worthless.
const VERSION: u32 = 1;

/// Where the avatar of a checkpoint is kept.
struct Place {
    folder: PathBuf,
    /// Begins the names of all that were distilled of a file at this path.
    path: String,
    /// Says which file was there.
    file: String,
}

impl Place {
    /// None where the system has no folder for it, or says too little of the file.
    fn of(checkpoint: &Path) -> Option<Self> {
        let folder = cache::folder()?.join("distilled");
        let whole = fs::canonicalize(checkpoint).ok()?;
        let about = whole.metadata().ok()?;
        let state = (VERSION, about.len(), about.modified().ok()?);
        Some(Self {
            folder,
            path: format!("{:016x}-", hashed(&whole)),
            file: format!("{:016x}.avatar", hashed(&state)),
        })
    }

    fn avatar(&self) -> PathBuf {
        self.folder.join(format!("{}{}", self.path, self.file))
    }

    /// Keeps an avatar, and none of what was at its path before.
    fn keep(&self, avatar: &Avatar) -> anyhow::Result<()> {
        let file = self.avatar();
        fs::create_dir_all(&self.folder)?;
        for entry in fs::read_dir(&self.folder)?.flatten() {
            if entry.file_name().to_string_lossy().starts_with(&self.path) {
                // What can't be removed takes room and does no harm.
                let _ = fs::remove_file(entry.path());
            }
        }
        write_whole(&file, &avatar.to_bytes()?).with_context(|| file.display().to_string())
    }
}

fn hashed(what: &impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    what.hash(&mut hasher);
    hasher.finish()
}

/// The avatar of a checkpoint: the one that was kept, else one that is distilled now as `effigy
/// import` does it unless told otherwise.
pub fn avatar(checkpoint: &Path) -> anyhow::Result<Imported> {
    let place = Place::of(checkpoint);
    if let Some(place) = &place {
        // One that is cut or from a later version is distilled again.
        if let Ok(avatar) = Avatar::read(&place.avatar()) {
            tracing::info!("distilled before: {}", place.avatar().display());
            return Ok(Imported {
                avatar,
                assumptions: vec![],
            });
        }
    }
    eprintln!(
        "{} is a training checkpoint of mmlphuman: an avatar is fitted to it, once, which takes \
         minutes",
        checkpoint.display()
    );
    let job = Job {
        file: checkpoint,
        trained: &[],
        clips: &ClipOptions::default(),
        options: mmlphuman::Options::default(),
    };
    let distilled = distil::run(&DistilArgs::default(), &job)?;
    eprintln!("{}", distil::likeness(&distilled.likeness));
    if let Some(place) = &place
        && let Err(error) = place.keep(&distilled.avatar)
    {
        tracing::warn!("the avatar can't be kept for the next time: {error:#}");
    }
    Ok(Imported {
        avatar: distilled.avatar,
        assumptions: vec![],
    })
}
