//! Files that are dropped on the window: avatars, splats and motion of any kind. They are read on
//! another thread, and what is shown stays until then.

use crate::file_list::LoadedAvatar;
use effigy_core::avatar::{Avatar, Clip};
use std::path::{Path, PathBuf};

/// How a program opens files that it learns of while its window is open.
pub trait OpenFiles: Send + Sync {
    /// Whether a file is motion, by its content.
    fn is_motion(&self, path: &Path) -> bool;

    /// Reads an avatar or splats, with clips for it.
    ///
    /// # Errors
    /// If the file can't be read: a text for the user.
    fn avatar(&self, path: &Path) -> anyhow::Result<OpenedFile<LoadedAvatar>>;

    /// Reads motion for an avatar.
    ///
    /// # Errors
    /// If the file can't be read or moves no joint of the avatar: a text for the user.
    fn clip(&self, path: &Path, avatar: &Avatar) -> anyhow::Result<OpenedFile<Clip>>;
}

/// The content of a file, and what its reader assumed.
pub struct OpenedFile<T> {
    /// What was read.
    pub content: T,
    /// Sentences for the user.
    pub notes: Vec<String>,
}

/// An avatar, and its file.
pub struct DroppedAvatar {
    /// Its file.
    pub path: PathBuf,
    /// Clips that were dropped with it come first.
    pub loaded: LoadedAvatar,
}

/// What some files hold.
#[derive(Default)]
pub struct DroppedContent {
    /// The last avatar among them.
    pub avatar: Option<DroppedAvatar>,
    /// Clips for the avatar that was shown. Empty if there is another one.
    pub clips: Vec<Clip>,
    /// What files left open, and why some can't be shown, each a text.
    pub messages: Vec<String>,
    /// Some files can't be shown.
    pub failed: bool,
}

impl DroppedContent {
    /// Reads the last avatar of some files, and all motion: for that avatar, else for the one that
    /// is `shown`. Files that can't be read get a message.
    pub fn read(files: &[PathBuf], shown: &Avatar, opener: &dyn OpenFiles) -> Self {
        let mut content = Self::default();
        let (motion, avatars): (Vec<&PathBuf>, Vec<&PathBuf>) =
            files.iter().partition(|path| opener.is_motion(path));
        let loaded = avatars.last().and_then(|path| {
            let loaded = content.take(opener.avatar(path))?;
            Some(DroppedAvatar {
                path: path.to_path_buf(),
                loaded,
            })
        });
        // Without the avatar that its motion was for, the one that is shown moves.
        let moved = loaded.as_ref().map_or(shown, |new| &new.loaded.avatar);
        let clips: Vec<Clip> = motion
            .into_iter()
            .filter_map(|path| content.take(opener.clip(path, moved)))
            .collect();
        match loaded {
            Some(mut new) => {
                new.loaded.clips.splice(0..0, clips);
                content.avatar = Some(new);
            }
            None => content.clips = clips,
        }
        content
    }

    /// What was read, after its notes or its error are kept.
    fn take<T>(&mut self, opened: anyhow::Result<OpenedFile<T>>) -> Option<T> {
        match opened {
            Ok(OpenedFile { content, notes }) => {
                self.messages.extend(notes);
                Some(content)
            }
            Err(error) => {
                tracing::warn!("{error:#}");
                self.messages.push(format!("{error:#}"));
                self.failed = true;
                None
            }
        }
    }
}
