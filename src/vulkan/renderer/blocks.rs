//! The uniform blocks of frames under way: one an avatar.

use super::Renderer;
use crate::{
    frame::{
        Body, Camera, block,
        keeper::Keeper,
        scene::{Actor, Staged},
    },
    layout::Frame,
};
use bytemuck::from_bytes_mut;

/// Bytes from one frame's uniform block to the next: every device's alignment divides 256.
pub(super) const FRAME_STRIDE: usize = size_of::<Frame>().next_multiple_of(256);

/// Where in the ring of uniform blocks an avatar's is, bytes.
pub(super) fn frame_at(slot: usize, number: usize, actors: usize) -> usize {
    (slot * actors + number) * FRAME_STRIDE
}

impl Renderer {
    /// Fills the uniform blocks of a frame.
    pub(super) fn write_frame(&mut self, slot: usize, staged: &Staged, camera: &Camera) {
        for actor in staged.actors.iter().filter(|actor| staged.view && actor.needed.body == Body::Keep) {
            self.keepers[actor.number] = Keeper::new(&self.extent, actor.posed, camera);
        }
        let blocks = self.frames.mapped();
        let mut fill = |number: usize, actor: Option<&Actor>| {
            let block: &mut Frame = from_bytes_mut(&mut blocks[frame_at(slot, number, self.options.actors)..][..size_of::<Frame>()]);
            block::fill_shared(block, &self.options, staged, camera);
            self.splats.fill(block);
            block.count_tile = self.sort.tile();
            if let Some(actor) = actor {
                block::fill_actor(block, &self.options, actor, camera);
                self.splats.fill_actor(block, number as u32);
                self.keepers[number].fill(block, camera);
            }
        };
        // An empty picture has a size too.
        fill(0, None);
        for actor in &staged.actors {
            fill(actor.number, Some(actor));
        }
    }
}
