//! Messages from other threads to the viewer, through winit's event loop.

use crate::{dropped::DroppedContent, file_list::LoadedAvatar};
use effigy_core::avatar::Avatar;
use std::{path::PathBuf, sync::Arc};

/// A message from another thread.
pub enum Message {
    /// A text for the panel to show.
    Text(String),
    /// An avatar of the file list has been read.
    Loaded {
        /// Its index in the file list.
        index: usize,
        /// The avatar and its clips.
        loaded: Box<LoadedAvatar>,
    },
    /// Files that were dropped on the window have been read.
    Dropped(Box<DroppedRead>),
    /// A newer state of the avatar that is shown.
    Newer {
        /// The avatar.
        avatar: Arc<Avatar>,
        /// Dropped when it is taken.
        until_taken: Arc<()>,
    },
    /// Nobody is left who makes newer ones.
    Close,
    /// The survey's thread has told something, or has ended.
    Survey,
}

/// Files that were dropped on the window, and what was read of them.
pub struct DroppedRead {
    /// The files.
    pub files: Vec<PathBuf>,
    /// The avatar that was shown when they were dropped: clips are made for it.
    pub shown: Arc<Avatar>,
    /// Number of the file list's latest request when they were dropped.
    pub request: u64,
    /// What they hold.
    pub content: DroppedContent,
}
