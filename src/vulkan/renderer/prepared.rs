//! What a renderer needs of an avatar before there is a device: it can be made while one is opened.

use crate::vulkan::device::error::Result;
use effigy_core::{
    avatar::Avatar,
    frame::{RendererOptions, Skip},
    layout::PackedModel,
    scene::AvatarBounds,
};
use std::{borrow::Cow, time::Instant};

/// An avatar, checked and packed for a device.
pub struct PreparedAvatar<'a> {
    pub(super) avatar: &'a Avatar,
    pub(super) bounds: AvatarBounds,
    /// The occluder mesh comes later.
    pub(super) without_occluder: bool,
    packed: PackedModel,
}

impl<'a> PreparedAvatar<'a> {
    /// Checks and packs an avatar, on all cores. `options`: those of the renderer to come.
    ///
    /// # Errors
    /// When [`Avatar::check`] finds a fault.
    pub fn new(avatar: &'a Avatar, options: &RendererOptions) -> Result<Self> {
        Self::with(avatar, options.skip.contains(Skip::HIDDEN))
    }

    /// Leaves out the occluder mesh, which takes about as long as all else: frames are right
    /// without it, and take longer. [`Renderer::add_occluder`](super::Renderer::add_occluder) takes
    /// it later.
    ///
    /// # Errors
    /// Those of [`Self::new`].
    pub fn without_occluder(avatar: &'a Avatar) -> Result<Self> {
        Ok(Self {
            without_occluder: true,
            ..Self::with(avatar, false)?
        })
    }

    fn with(avatar: &'a Avatar, occluder: bool) -> Result<Self> {
        let began = Instant::now();
        avatar.check()?;
        let checked = ms_since(began);
        let packed = PackedModel::new(avatar, occluder);
        let bounds = AvatarBounds::new(avatar);
        let all = ms_since(began);
        tracing::info!(
            "checked the avatar in {checked:.1} ms, packed it in {:.1} ms",
            all - checked
        );
        Ok(Self {
            avatar,
            bounds,
            without_occluder: false,
            packed,
        })
    }

    /// The packed avatar. Packs it again if it has no occluder mesh and needs one.
    pub(super) fn packed(&self, occluder: bool) -> Cow<'_, PackedModel> {
        if occluder && self.packed.occluder.is_none() {
            Cow::Owned(PackedModel::new(self.avatar, true))
        } else {
            Cow::Borrowed(&self.packed)
        }
    }
}

/// Milliseconds since then.
pub(super) fn ms_since(then: Instant) -> f64 {
    then.elapsed().as_secs_f64() * 1e3
}
