//! An avatar in the room that there is: nothing is compiled or bound anew.

use super::{Renderer, error::Result, surface::Surface};
use crate::{
    avatar::Avatar,
    frame::{Extent, Needs, Skip, keeper::Keeper, scene::Scene},
};

impl Renderer {
    /// Draws this avatar from now on, which has the Gaussians and the nodes of the one before and may have other correctives of the same
    /// number; false, and nothing has changed, where its arrays have other lengths.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn fill(&mut self, avatar: &Avatar) -> Result<bool> {
        if avatar.harmonics.is_some() || !self.take(avatar)? {
            return Ok(false);
        }
        self.frame.clone_from(&self.model.constants);
        (self.extent, self.needs) = (Extent::new(avatar), Needs::new(avatar));
        self.keepers.iter_mut().for_each(|keeper| *keeper = Keeper::default());
        self.scene = Scene::default();
        Ok(true)
    }

    /// Fills the room that [`Self::empty`] made for this avatar, which may have harmonics: those are there already.
    ///
    /// # Errors
    /// When the device has no room, or is lost.
    pub(crate) fn take(&mut self, avatar: &Avatar) -> Result<bool> {
        if !self.model.fill(&self.gpu, avatar) {
            return Ok(false);
        }
        if self.surface.is_none() && self.options.skip.contains(Skip::HIDDEN) {
            self.surface = Surface::new(&self.gpu, avatar, &self.model, (&self.blocks, &self.pose))?;
        }
        self.gpu.check()?;
        Ok(true)
    }
}
