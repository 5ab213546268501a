//! One frame, drawn at the start of a soak in a window and again at its end: what has drifted between them.

use super::{painter::Painter, scene::Scene};
use crate::{
    frame::{Camera, Posed},
    measure::{bench, error, soak},
    vulkan::{Result, picture::Copied},
};

/// The frame and what came of it at first.
pub(super) struct Still {
    posed: Posed,
    camera: Camera,
    size: [u32; 2],
    picture: Copied,
}

impl Still {
    /// Draws the middle of the first clip, at the whole quality. None of an avatar without a clip.
    pub fn take(painter: &mut Painter, scene: &Scene) -> Result<Option<Self>> {
        let Some(player) = scene.first_player() else { return Ok(None) };
        let size = painter.size();
        let (posed, camera) = soak::middle(scene.avatar(), player, size);
        let picture = painter.still(&posed, &camera)?;
        Ok(Some(Self { posed, camera, size, picture }))
    }

    /// Draws it again and compares. None where the window has another size by now.
    pub fn again(&self, painter: &mut Painter) -> Result<Option<soak::report::Still>> {
        if painter.size() != self.size {
            return Ok(None);
        }
        let (after, before) = (painter.still(&self.posed, &self.camera)?.decode(), self.picture.decode());
        let error = bench::check::report(&error::between(&after, &before), None);
        Ok(Some(soak::report::Still { size: self.size, same: after == before, error }))
    }
}
