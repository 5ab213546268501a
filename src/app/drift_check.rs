//! One frame, drawn at the start of a soak in a window and again at its end, to measure drift.

use crate::{painter::WindowPainter, scene::ViewerScene};
use effigy_core::scene::{Camera, Posed};
use effigy_measure::{error, report::ErrorReport, soak};
use effigy_render::vulkan::{Copied, Result};

/// The frame as it was drawn at the start.
pub struct DriftCheck {
    posed: Posed,
    camera: Camera,
    size: [u32; 2],
    image: Copied,
}

impl DriftCheck {
    /// Draws the middle of the first clip at full quality. None if the avatar has no clip.
    pub fn draw(painter: &mut WindowPainter, scene: &ViewerScene) -> Result<Option<Self>> {
        let Some(player) = scene.first_player() else {
            return Ok(None);
        };
        let size = painter.size();
        let (posed, camera) = soak::middle_frame(scene.avatar(), player, size);
        let image = painter.draw_offscreen(&posed, &camera)?;
        Ok(Some(Self {
            posed,
            camera,
            size,
            image,
        }))
    }

    /// Draws the frame again and compares. None if the window's size has changed.
    pub fn compare(
        &self,
        painter: &mut WindowPainter,
    ) -> Result<Option<soak::report::RedrawnFrame>> {
        if painter.size() != self.size {
            return Ok(None);
        }
        let after = painter.draw_offscreen(&self.posed, &self.camera)?.decode();
        let before = self.image.decode();
        let error = ErrorReport::new(&error::between(&after, &before), None);
        Ok(Some(soak::report::RedrawnFrame {
            size: self.size,
            same: after == before,
            error,
        }))
    }
}
