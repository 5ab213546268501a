//! The avatars and clips on a phone: the demo in the package, files in the app's folder, and a file
//! that another app opens with this one.

use super::java;
use crate::file_list::FileList;
use anyhow::{Context, anyhow};
use effigy_core::{
    avatar::{Avatar, Clip},
    io::{file::FileContent, ply},
};
use std::{
    ffi::CStr,
    fs::{self, File},
    io::Read,
    path::{Path, PathBuf},
};
use winit::platform::android::activity::AndroidApp;

const DEMO: &CStr = c"demo.avatar";
const DEMO_CLIP: &CStr = c"demo.motion";

/// The avatars and clips on a phone.
pub struct Files {
    app: AndroidApp,
    /// The app's folder, which `adb push` can write to.
    folder: Option<PathBuf>,
    /// Avatars that were in the folder when the app started, sorted by name.
    avatars: Vec<PathBuf>,
    /// Another app has opened a file with this one.
    opened: bool,
}

impl Files {
    /// Lists the avatars in `folder`.
    pub fn new(app: &AndroidApp, folder: Option<PathBuf>) -> Self {
        let avatars = list_files(folder.as_deref(), &["avatar", "ply"]);
        Self {
            app: app.clone(),
            folder,
            avatars,
            opened: java::has_opened(app),
        }
    }

    /// Index in the file list of the file that another app has opened, if there is one.
    pub fn opened_index(&self) -> Option<usize> {
        self.opened.then_some(1 + self.avatars.len())
    }

    /// The avatars that the panel offers: the demo first, the file that another app has opened
    /// last.
    pub fn into_list(self) -> FileList {
        let stem = |path: &PathBuf| {
            path.file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned()
        };
        let mut names = vec!["demo".to_string()];
        names.extend(self.avatars.iter().map(stem));
        if self.opened {
            names.push("opened file".into());
        }
        FileList::new(names, 0, move |index| self.load(index))
    }

    /// The avatar to start with: the demo, which loads at once.
    pub fn first(&self) -> anyhow::Result<(Avatar, Vec<Clip>)> {
        Ok(self.with_clips(self.demo()?, None))
    }

    /// Reads the avatar with an index in the file list.
    fn load(&self, index: usize) -> anyhow::Result<(Avatar, Vec<Clip>)> {
        let avatar = if index == 0 {
            self.demo()?
        } else if let Some(path) = self.avatars.get(index - 1) {
            ply::open(path, None)?
        } else {
            return self
                .opened()
                .context("the file that was opened can't be shown");
        };
        Ok(self.with_clips(avatar, None))
    }

    /// The file that another app has opened. A clip is shown with the demo.
    fn opened(&self) -> anyhow::Result<(Avatar, Vec<Clip>)> {
        Ok(match read_content(java::opened_file(&self.app)?)? {
            FileContent::Avatar(avatar) => self.with_clips(*avatar, None),
            FileContent::Clip(clip) => self.with_clips(self.demo()?, Some(*clip)),
        })
    }

    /// Adds the clips that move a joint of the avatar, `first` before the others.
    fn with_clips(&self, avatar: Avatar, first: Option<Clip>) -> (Avatar, Vec<Clip>) {
        let mut clips: Vec<Clip> = first.into_iter().collect();
        if !avatar.is_static() {
            if let Ok(bytes) = self.asset(DEMO_CLIP)
                && let Ok(clip) = Clip::from_bytes(&bytes)
            {
                clips.push(clip);
            }
            for path in list_files(self.folder.as_deref(), &["motion"]) {
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
        let mut asset = self
            .app
            .asset_manager()
            .open(name)
            .ok_or_else(|| anyhow!("{} is missing: reinstall Effigy", named()))?;
        Ok(asset.buffer().with_context(named)?.to_vec())
    }
}

/// Files in a folder with one of these extensions, sorted by name.
fn list_files(folder: Option<&Path>, extensions: &[&str]) -> Vec<PathBuf> {
    let entries = folder
        .and_then(|folder| fs::read_dir(folder).ok())
        .into_iter()
        .flatten()
        .flatten();
    let fits = |path: &PathBuf| {
        path.extension().is_some_and(|extension| {
            extensions
                .iter()
                .any(|known| extension.eq_ignore_ascii_case(known))
        })
    };
    let mut found: Vec<_> = entries.map(|entry| entry.path()).filter(fits).collect();
    found.sort();
    found
}

/// Reads an avatar, a .ply file or a clip.
fn read_content(mut file: File) -> anyhow::Result<FileContent> {
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    if bytes.starts_with(b"ply") {
        return Ok(FileContent::Avatar(Box::new(ply::from_bytes(
            &bytes, "opened", None,
        )?)));
    }
    Ok(FileContent::from_bytes(&bytes)?)
}
