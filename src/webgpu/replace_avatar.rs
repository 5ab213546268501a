//! Puts another avatar into a renderer's buffers: kernels and bindings stay.

use super::{error::Result, occluder::OccluderPass, renderer::Renderer};
use effigy_core::{
    avatar::Avatar,
    frame::{Skip, pose_cache::PoseCache, state::FrameState},
    scene::{AvatarBounds, PartDependencies},
};

impl Renderer {
    /// Draws this avatar from now on, which has the Gaussians and the nodes of the one before and
    /// may have other correctives of the same number; false, and nothing has changed, where its
    /// arrays have other lengths.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn fill(&mut self, avatar: &Avatar) -> Result<bool> {
        if avatar.sh.is_some() || !self.take(avatar)? {
            return Ok(false);
        }
        self.frame.clone_from(&self.model.constants);
        self.avatar_bounds = AvatarBounds::new(avatar);
        self.needs = PartDependencies::new(avatar);
        for cache in &mut self.pose_caches {
            *cache = PoseCache::default();
        }
        self.state = FrameState::default();
        Ok(true)
    }

    /// Fills the buffers that [`Self::empty`] made for this avatar. It may have spherical
    /// harmonics: [`Self::empty`] has uploaded those.
    ///
    /// # Errors
    /// When the device's memory does not suffice, or it is lost.
    pub fn take(&mut self, avatar: &Avatar) -> Result<bool> {
        if !self.model.fill(&self.gpu, avatar) {
            return Ok(false);
        }
        if self.occluder.is_none() && self.options.skip.contains(Skip::HIDDEN) {
            self.occluder =
                OccluderPass::new(&self.gpu, avatar, &self.model, &self.blocks, &self.pose)?;
        }
        self.gpu.check()?;
        Ok(true)
    }
}
