//! Another avatar of the same sizes in the buffers that there are: nothing is compiled or bound anew.

use super::{Renderer, error::Result};
use crate::{
    avatar::Avatar,
    frame::{Extent, Needs, keeper::Keeper, scene::Scene},
    layout::pack,
};
use bytemuck::cast_slice;

impl Renderer {
    /// Draws this avatar from now on, which has the Gaussians and the nodes of the one before and may have other correctives of the same
    /// number; false, and nothing has changed, where its arrays have other lengths.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn fill(&mut self, avatar: &Avatar) -> Result<bool> {
        let mut constants = Box::new(pack::constants(avatar));
        let networks = pack::networks(avatar, &mut constants);
        let rows = pack::rows(avatar, &mut constants);
        let (places, starts) = pack::node_places(avatar);
        let (nodes, gaussians) = (pack::nodes(avatar, &places), pack::gaussians(avatar, &places));
        let model = &self.model;
        let all: [(&wgpu::Buffer, &[u8]); 5] = [
            (&model.networks, cast_slice(&networks)),
            (&model.nodes, cast_slice(&nodes)),
            (&model.node_starts, cast_slice(&starts)),
            (&model.gaussians, cast_slice(&gaussians)),
            (&model.rows, cast_slice(&rows)),
        ];
        // Whole words, as all of these are; see `buffer::empty`.
        let fits = |&(buffer, data): &(&wgpu::Buffer, &[u8])| data.len().is_multiple_of(4) && buffer.size() == (data.len() as u64).max(16);
        if !all.iter().all(fits) || avatar.harmonics.is_some() {
            return Ok(false);
        }
        all.iter().for_each(|(buffer, data)| self.gpu.queue.write_buffer(buffer, 0, data));
        self.frame = constants.clone();
        self.model.constants = constants;
        (self.extent, self.needs) = (Extent::new(avatar), Needs::new(avatar));
        self.keepers.iter_mut().for_each(|keeper| *keeper = Keeper::default());
        self.scene = Scene::default();
        self.gpu.check()?;
        Ok(true)
    }
}
