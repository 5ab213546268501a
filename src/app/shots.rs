//! What the viewer keeps of its pictures: screenshots, and captures for a profiler.

use super::{Message, viewer::Viewer};
use crate::{
    measure::capture::{ATTACH, RenderDoc},
    vulkan::Error,
};

impl Viewer {
    /// Has RenderDoc capture what is shown next, and says so.
    pub(super) fn capture(&mut self) {
        self.message = Some(match RenderDoc::attached() {
            Some(renderdoc) => {
                renderdoc.trigger();
                "RenderDoc captures the next frame".into()
            }
            None => {
                tracing::warn!("{ATTACH}");
                ATTACH.into()
            }
        });
    }

    /// Copies the picture; another thread makes a file of it.
    pub(super) fn save_screenshot(&mut self, background: [f32; 3]) -> Result<(), Error> {
        let Some(painter) = &mut self.painter else { return Ok(()) };
        let copied = painter.copy()?;
        let proxy = self.proxy.clone();
        let tell = move |message| {
            // The window may be closed already; then there is no one left to tell.
            let _ = proxy.send_event(Message::Say(message));
        };
        self.savers.start(move || copied.decode().over(background), (self.options.folders.clone(), tell));
        Ok(())
    }
}
