//! How avatars are drawn to be measured.

use effigy_core::{avatar::Avatar, frame::RendererOptions};
use std::borrow::Cow;

/// Everything that trades time for error.
#[derive(Clone, Copy, Debug)]
pub struct RenderSetting {
    /// Options of the renderer.
    pub options: RendererOptions,
    /// Share of the basis rows to retain, 0 to 1.
    pub rows: f64,
    /// Frames that each pose is held for, at least 1.
    pub hold: usize,
}

impl RenderSetting {
    /// All rows, and a new pose in every frame.
    pub fn new(options: RendererOptions) -> Self {
        Self {
            options,
            rows: 1.0,
            hold: 1,
        }
    }

    /// The avatar with the rows that this setting retains.
    pub fn reduce<'a>(&self, avatar: &'a Avatar) -> Cow<'a, Avatar> {
        if self.rows < 1.0 {
            Cow::Owned(avatar.retain_rows(self.rows))
        } else {
            Cow::Borrowed(avatar)
        }
    }
}
