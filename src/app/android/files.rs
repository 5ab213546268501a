//! The avatars and clips on a phone: the demo in the package, files in the app's folder, and a file
//! that another app opens with this one. Files of other programs are told apart by their content.

use super::java;
use crate::file_list::{FileList, LoadedAvatar, stem};
use anyhow::{Context, anyhow};
use effigy_core::{
    avatar::{Avatar, Clip},
    io::file::FileContent,
};
use effigy_formats::{
    assumption::Assumption,
    content::Content,
    open,
    read::{self, ClipOptions, OpenOptions, OpenedClip, Source},
    retarget::Girth,
    splats::Nothing,
};
use std::{
    ffi::CStr,
    fs,
    io::Read,
    path::{Path, PathBuf},
};
use winit::platform::android::activity::AndroidApp;

const DEMO: &CStr = c"demo.avatar";
const DEMO_CLIP: &CStr = c"demo.motion";
/// What a file is called that another app opens: its name is not passed on.
const OPENED: &str = "opened";

/// The avatars and clips on a phone.
pub struct PhoneFiles {
    app: AndroidApp,
    /// The app's folder, which `adb push` can write to.
    folder: Option<PathBuf>,
    /// Avatars that were in the folder when the app started, sorted by name.
    avatars: Vec<PathBuf>,
    /// Another app has opened a file with this one.
    opened: bool,
}

impl PhoneFiles {
    /// Lists the avatars in `folder`.
    pub fn new(app: &AndroidApp, folder: Option<PathBuf>) -> Self {
        let is_avatar =
            |path: &Path| has_extension(path, "avatar") || open::content(path).is_avatar();
        let avatars = list_files(folder.as_deref(), is_avatar);
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
        let mut names = vec!["demo".to_string()];
        names.extend(self.avatars.iter().map(|path| stem(path)));
        if self.opened {
            names.push("opened file".into());
        }
        FileList::new(names, 0, move |index| self.load(index))
    }

    /// The avatar to start with: the demo, which loads at once. Motion of other programs, which
    /// takes longer, is there when it is chosen again.
    pub fn first(&self) -> anyhow::Result<LoadedAvatar> {
        let demo = self.demo()?;
        let clips = self.own_clips(&demo);
        Ok(LoadedAvatar::new(demo, clips))
    }

    /// Reads the avatar with an index in the file list.
    fn load(&self, index: usize) -> anyhow::Result<LoadedAvatar> {
        if index == 0 {
            let demo = self.demo()?;
            let clips = self.clips(&demo);
            return Ok(LoadedAvatar::new(demo, clips));
        }
        let Some(path) = self.avatars.get(index - 1) else {
            return self
                .opened()
                .context("the file that was opened can't be shown");
        };
        let imported = open::avatar(path, &OpenOptions::default())?;
        log(&imported.assumptions);
        let avatar = imported.avatar;
        let mut clips = self.clips(&avatar);
        // The poses beside a model of the paper are its own: they come first.
        if let Some(poses) = open::poses_beside(path)
            && let Some(stem) = poses.file_stem()
        {
            clips.sort_by_key(|clip| stem != clip.name.as_str());
        }
        Ok(LoadedAvatar::new(avatar, clips))
    }

    /// The file that another app has opened. Motion is shown with the demo.
    fn opened(&self) -> anyhow::Result<LoadedAvatar> {
        let mut bytes = Vec::new();
        java::opened_file(&self.app)?.read_to_end(&mut bytes)?;
        let content = Content::of(&bytes, Path::new(OPENED));
        let mut beside = Nothing;
        let source = Source::new(&bytes, Path::new(OPENED), &mut beside);
        // Reading a checkpoint says what becomes an avatar of it.
        let (avatar, first) = if content.is_avatar() || content == Content::Checkpoint {
            let imported = read::avatar(source, &OpenOptions::default())?;
            log(&imported.assumptions);
            (imported.avatar, None)
        } else if content.is_motion() {
            let demo = self.demo()?;
            let girth = || Girth::of(&demo);
            let opened = read::clip(source, &demo.skeleton, girth, &ClipOptions::default())?;
            let clip = logged(opened);
            (demo, Some(clip))
        } else {
            let found = FileContent::from_bytes(&bytes);
            match found.map_err(|fault| read::unknown(&bytes, fault))? {
                FileContent::Avatar(avatar) => (*avatar, None),
                FileContent::Clip(clip) => (self.demo()?, Some(*clip)),
            }
        };
        let clips = first.into_iter().chain(self.clips(&avatar)).collect();
        Ok(LoadedAvatar::new(avatar, clips))
    }

    /// The demo's clip and those of Effigy's own in the folder.
    fn own_clips(&self, avatar: &Avatar) -> Vec<Clip> {
        if avatar.is_static() {
            return vec![];
        }
        let demo = self.asset(DEMO_CLIP).ok();
        let demo = demo.and_then(|bytes| Clip::from_bytes(&bytes).ok());
        let is_motion = |path: &Path| has_extension(path, "motion");
        let files = list_files(self.folder.as_deref(), is_motion);
        let own = files.iter().filter_map(|path| open_clip(path, avatar));
        demo.into_iter().chain(own).collect()
    }

    /// [`Self::own_clips`], and motion of other programs in the folder.
    fn clips(&self, avatar: &Avatar) -> Vec<Clip> {
        let mut clips = self.own_clips(avatar);
        if !avatar.is_static() {
            let is_motion = |path: &Path| open::is_capture(path);
            let files = list_files(self.folder.as_deref(), is_motion);
            clips.extend(files.iter().filter_map(|path| open_clip(path, avatar)));
        }
        clips
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

/// Files in a folder that are wanted, sorted by name.
fn list_files(folder: Option<&Path>, wanted: impl Fn(&Path) -> bool) -> Vec<PathBuf> {
    let entries = folder
        .and_then(|folder| fs::read_dir(folder).ok())
        .into_iter()
        .flatten()
        .flatten();
    let paths = entries.map(|entry| entry.path());
    let mut found: Vec<_> = paths.filter(|path| wanted(path)).collect();
    found.sort();
    found
}

fn has_extension(path: &Path, extension: &str) -> bool {
    path.extension()
        .is_some_and(|own| own.eq_ignore_ascii_case(extension))
}

/// Reads a clip for an avatar. One that can't be read is logged.
fn open_clip(path: &Path, avatar: &Avatar) -> Option<Clip> {
    match open::clip(path, avatar, &ClipOptions::default()) {
        Ok(opened) => Some(logged(opened)),
        Err(error) => {
            tracing::warn!("{error}");
            None
        }
    }
}

/// The clip of a file, after what was assumed of it is logged.
fn logged(opened: OpenedClip) -> Clip {
    log(&opened.assumptions);
    opened.clip
}

fn log(assumptions: &[Assumption]) {
    for assumption in assumptions {
        tracing::info!("{assumption}");
    }
}
