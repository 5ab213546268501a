//! The avatars and clips that a phone has: the demo in the package, files in the app's folder, and one that another app opens with us.

use crate::{
    app::shelf::{Shelf, Show},
    avatar::{Avatar, Clip, file::Content, import},
};
use anyhow::{Context, anyhow};
use std::{
    ffi::CStr,
    fs::{self, File},
    io::Read,
    path::{Path, PathBuf},
};
use winit::platform::android::activity::ndk::asset::AssetManager;

const DEMO: &CStr = c"demo.avatar";
const DEMO_CLIP: &CStr = c"demo.motion";

/// Where avatars and clips are looked for.
pub struct Files {
    assets: AssetManager,
    /// The app's folder that `adb push` writes to.
    folder: Option<PathBuf>,
    /// Files that were in the folder when the app started, by name.
    avatars: Vec<PathBuf>,
}

impl Files {
    pub fn new(assets: AssetManager, folder: Option<PathBuf>) -> Self {
        let avatars = listed(folder.as_deref(), &["avatar", "ply"]);
        Self { assets, folder, avatars }
    }

    /// What the panel offers: the demo first.
    pub fn shelf(&self) -> Shelf {
        let stem = |path: &PathBuf| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let names = std::iter::once("demo".to_string()).chain(self.avatars.iter().map(stem)).collect();
        let files = Self {
            // SAFETY: the glue keeps the manager for as long as the process lives.
            assets: unsafe { AssetManager::from_ptr(self.assets.ptr()) },
            folder: self.folder.clone(),
            avatars: self.avatars.clone(),
        };
        Shelf::new(names, 0, move |number| files.load(number))
    }

    fn load(&self, number: usize) -> anyhow::Result<Show> {
        let avatar = match number.checked_sub(1).and_then(|file| self.avatars.get(file)) {
            Some(path) => import::open(path, None)?,
            None => self.demo()?,
        };
        Ok(self.with_clips(avatar, None))
    }

    /// What to begin with: what `opened` holds, else the demo. Also says what is wrong with what was opened.
    pub fn first(&self, opened: Option<File>) -> (anyhow::Result<Show>, Option<String>) {
        let given = opened.map(|file| read(file).context("the file that was opened can't be shown"));
        let (avatar, clip, complaint) = match given {
            Some(Ok(Content::Avatar(avatar))) => return (Ok(self.with_clips(*avatar, None)), None),
            Some(Ok(Content::Clip(clip))) => (self.demo(), Some(*clip), None),
            Some(Err(error)) => (self.demo(), None, Some(format!("{error:#}"))),
            None => (self.demo(), None, None),
        };
        (avatar.map(|avatar| self.with_clips(avatar, clip)), complaint)
    }

    /// Adds the clips that move something of the avatar, `first` in front.
    fn with_clips(&self, avatar: Avatar, first: Option<Clip>) -> Show {
        let mut clips: Vec<Clip> = first.into_iter().collect();
        if !avatar.is_static() {
            clips.extend(self.asset(DEMO_CLIP).and_then(|bytes| Ok(Clip::from_bytes(&bytes)?)).ok());
            for path in listed(self.folder.as_deref(), &["motion"]) {
                match Clip::read(&path) {
                    Ok(clip) => clips.push(clip),
                    Err(error) => tracing::warn!("{error}"),
                }
            }
        }
        clips.retain(|clip| clip.map_to(&avatar.skeleton).iter().flatten().count() > 0);
        if clips.is_empty() {
            clips.push(Clip::still(&avatar.skeleton));
        }
        (avatar, clips)
    }

    fn demo(&self) -> anyhow::Result<Avatar> {
        Ok(Avatar::from_bytes(&self.asset(DEMO)?)?)
    }

    fn asset(&self, name: &CStr) -> anyhow::Result<Vec<u8>> {
        let named = || format!("{} in the package", name.to_string_lossy());
        let mut asset = self.assets.open(name).ok_or_else(|| anyhow!("{} is missing: install Effigy anew", named()))?;
        Ok(asset.buffer().with_context(named)?.to_vec())
    }
}

/// Files of a folder with one of these endings, sorted by name.
fn listed(folder: Option<&Path>, endings: &[&str]) -> Vec<PathBuf> {
    let entries = folder.and_then(|folder| fs::read_dir(folder).ok()).into_iter().flatten().flatten();
    let fits = |path: &PathBuf| path.extension().is_some_and(|ending| endings.iter().any(|known| ending.eq_ignore_ascii_case(known)));
    let mut found: Vec<_> = entries.map(|entry| entry.path()).filter(fits).collect();
    found.sort();
    found
}

fn read(mut file: File) -> anyhow::Result<Content> {
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    if bytes.starts_with(b"ply") {
        return Ok(Content::Avatar(Box::new(import::from_bytes(&bytes, "opened", None)?)));
    }
    Ok(Content::from_bytes(&bytes)?)
}
