//! The avatars and clips that a phone has: the demo in the package, files in the app's folder, and one that another app opens with us.

use super::java;
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
use winit::platform::android::activity::AndroidApp;

const DEMO: &CStr = c"demo.avatar";
const DEMO_CLIP: &CStr = c"demo.motion";

/// Where avatars and clips are looked for.
pub struct Files {
    app: AndroidApp,
    /// The app's folder that `adb push` writes to.
    folder: Option<PathBuf>,
    /// Files that were in the folder when the app started, by name.
    avatars: Vec<PathBuf>,
    /// Another app wants us to show a file.
    opened: bool,
}

impl Files {
    pub fn new(app: &AndroidApp, folder: Option<PathBuf>) -> Self {
        let avatars = listed(folder.as_deref(), &["avatar", "ply"]);
        Self { app: app.clone(), folder, avatars, opened: java::has_opened(app) }
    }

    /// What the panel offers: the demo first, last what another app wants us to show. Also the number of that, where there is such a thing.
    pub fn shelf(self) -> (Shelf, Option<usize>) {
        let stem = |path: &PathBuf| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let mut names: Vec<String> = std::iter::once("demo".to_string()).chain(self.avatars.iter().map(stem)).collect();
        let opened = self.opened.then_some(names.len());
        names.extend(opened.map(|_| "opened file".into()));
        (Shelf::new(names, 0, move |number| self.load(number)), opened)
    }

    /// What to begin with: the demo, for it takes no time.
    pub fn first(&self) -> anyhow::Result<Show> {
        Ok(self.with_clips(self.demo()?, None))
    }

    fn load(&self, number: usize) -> anyhow::Result<Show> {
        let avatar = match number.checked_sub(1) {
            None => self.demo()?,
            Some(file) => match self.avatars.get(file) {
                Some(path) => import::open(path, None)?,
                None => return self.opened().context("the file that was opened can't be shown"),
            },
        };
        Ok(self.with_clips(avatar, None))
    }

    /// What another app wants us to show; a clip moves the demo.
    fn opened(&self) -> anyhow::Result<Show> {
        Ok(match read(java::opened_file(&self.app)?)? {
            Content::Avatar(avatar) => self.with_clips(*avatar, None),
            Content::Clip(clip) => self.with_clips(self.demo()?, Some(*clip)),
        })
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
        let mut asset = self.app.asset_manager().open(name).ok_or_else(|| anyhow!("{} is missing: install Effigy anew", named()))?;
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
