//! What a renderer needs of an avatar before there is a device: it can be made while one is opened.

use crate::vulkan::device::error::Result;
use effigy_core::{avatar::Avatar, layout::PackedModel, scene::AvatarBounds};
use std::time::Instant;

/// An avatar, checked and packed for a device.
pub struct PreparedAvatar<'a> {
    pub(super) avatar: &'a Avatar,
    pub(super) bounds: AvatarBounds,
    pub(super) packed: PackedModel,
}

impl<'a> PreparedAvatar<'a> {
    /// Checks and packs an avatar, on all cores.
    ///
    /// # Errors
    /// When [`Avatar::check`] finds a fault.
    pub fn new(avatar: &'a Avatar) -> Result<Self> {
        let began = Instant::now();
        avatar.check()?;
        let checked = ms_since(began);
        let packed = PackedModel::new(avatar);
        let bounds = AvatarBounds::new(avatar);
        let all = ms_since(began);
        tracing::info!(
            "checked the avatar in {checked:.1} ms, packed it in {:.1} ms",
            all - checked
        );
        Ok(Self {
            avatar,
            bounds,
            packed,
        })
    }
}

/// Milliseconds since then.
pub(super) fn ms_since(then: Instant) -> f64 {
    then.elapsed().as_secs_f64() * 1e3
}
