//! What may change from frame to frame for the sake of time: a smaller picture, a coarser cutoff, fewer Gaussians. Nothing is allocated.

use super::{Renderer, Scene};
use crate::{
    frame::{Detail, Unusable},
    vulkan::{Error, RendererOptions, Result},
};

impl Renderer {
    /// What it draws with now.
    pub fn options(&self) -> &RendererOptions {
        &self.options
    }

    /// Draws pictures of `size` px from now on, in the upper left corner of what it was made or resized for, nothing fainter than
    /// `cutoff` (as [`RendererOptions::cutoff`]), and at this level of detail. Waits for submitted frames where that changes anything.
    ///
    /// # Errors
    /// When the size does not fit, the cutoff is none, or the device fails. Then the next frame is drawn as before.
    pub fn adjust(&mut self, size: [u32; 2], cutoff: f64, detail: Detail) -> Result<()> {
        let options = RendererOptions { size, cutoff, detail, ..self.options };
        if size == self.options.size && cutoff == self.options.cutoff && detail == self.options.detail {
            return Ok(());
        }
        options.check()?;
        let room = self.raster.image().size;
        if size.iter().zip(room).any(|(&side, room)| !(1..=room).contains(&side)) {
            let [found, room] = [size, room].map(|[width, height]| format!("{width} × {height} px"));
            return Err(Error::Unusable(Unusable {
                what: "the drawn part of the picture".into(),
                found,
                expected: format!("1 px to {room}"),
            }));
        }
        self.finish()?;
        if cutoff != self.options.cutoff {
            self.raster.set_cutoff(&options)?;
        }
        self.raster.draw_within(size);
        self.options = options;
        (self.scene, self.filled) = (Scene::default(), None);
        Ok(())
    }
}
