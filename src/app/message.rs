//! Messages from other threads to the viewer, through winit's event loop.

use crate::file_list::LoadedAvatar;

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
}
