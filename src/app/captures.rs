//! Saves frames: screenshots, RenderDoc captures and a trace.

use crate::{message::Message, painter::WindowPainter, screenshot::ScreenshotWriters};
use effigy_render::vulkan::{Error, Gpu};
use effigy_runtime::{capture::RenderDoc, trace::TraceRecorder};
use std::path::PathBuf;
use winit::event_loop::EventLoopProxy;

/// That RenderDoc is not attached, and how to attach it.
const ATTACH: &str = "RenderDoc is not attached: start the program from it (Launch Application \
    in qrenderdoc, or `renderdoccmd capture effigy capture`), or set \
    ENABLE_VULKAN_RENDERDOC_CAPTURE=1 where it is installed";

/// Screenshots, RenderDoc captures and the trace of a viewer.
pub struct Captures {
    /// Folders for screenshots, in order of preference.
    folders: Vec<PathBuf>,
    writers: ScreenshotWriters,
    /// The next frame is to be saved.
    screenshot_requested: bool,
    /// RenderDoc was attached when the device was opened.
    renderdoc_attached: bool,
    trace_path: Option<PathBuf>,
    trace: Option<TraceRecorder>,
    /// Takes messages of the threads that write screenshots.
    proxy: EventLoopProxy<Message>,
}

impl Captures {
    /// `folders`: for screenshots, in order of preference. `trace_path`: the file of the trace, if
    /// one is wanted.
    pub fn new(
        folders: Vec<PathBuf>,
        trace_path: Option<PathBuf>,
        proxy: EventLoopProxy<Message>,
    ) -> Self {
        Self {
            folders,
            writers: ScreenshotWriters::default(),
            screenshot_requested: false,
            renderdoc_attached: false,
            trace_path,
            trace: None,
            proxy,
        }
    }

    /// A device was opened: a trace of it starts.
    pub fn device_opened(&mut self, gpu: &Gpu) {
        self.trace = self.trace_path.as_ref().map(|_| TraceRecorder::new(gpu));
        self.renderdoc_attached = RenderDoc::attached().is_some();
    }

    /// Folders for what is saved, in order of preference.
    pub fn folders(&self) -> &[PathBuf] {
        &self.folders
    }

    /// Whether RenderDoc can capture a frame.
    pub fn has_renderdoc(&self) -> bool {
        self.renderdoc_attached
    }

    /// Saves the next frame as a PNG.
    pub fn request_screenshot(&mut self) {
        self.screenshot_requested = true;
    }

    /// Whether the next frame is to be saved.
    pub fn wants_frame(&self) -> bool {
        self.screenshot_requested
    }

    /// Has RenderDoc capture the next frame. Returns a message for the user.
    pub fn request_renderdoc(&self) -> String {
        match RenderDoc::attached() {
            Some(renderdoc) => {
                renderdoc.trigger();
                "RenderDoc captures the next frame".into()
            }
            None => {
                tracing::warn!("{ATTACH}");
                ATTACH.into()
            }
        }
    }

    /// A frame was drawn: adds it to the trace.
    pub fn trace_frame(&mut self, painter: &WindowPainter) {
        if let Some(trace) = &mut self.trace {
            trace.add_frame(painter.report());
        }
    }

    /// Saves the last frame over `background`, if a screenshot was requested. Another thread
    /// encodes and writes it.
    pub fn save_screenshot(
        &mut self,
        painter: &mut WindowPainter,
        background: Option<[f32; 3]>,
    ) -> Result<(), Error> {
        if !std::mem::take(&mut self.screenshot_requested) {
            return Ok(());
        }
        let copied = painter.copy()?;
        let proxy = self.proxy.clone();
        let report = move |text| {
            // If the window is closed already, no one is left to read it.
            let _ = proxy.send_event(Message::Text(text));
        };
        let behind = painter.behind(background);
        let image = move || behind(&copied.decode());
        self.writers.start(self.folders.clone(), image, report);
        Ok(())
    }

    /// Writes the trace, if there is one. Call it before the device is closed.
    pub fn write_trace(&self, gpu: &Gpu) {
        if let Some(path) = &self.trace_path
            && let Some(trace) = &self.trace
            && let Err(error) = trace.write(path, gpu)
        {
            tracing::error!("{} can't be written: {error}", path.display());
        }
    }

    /// Waits for screenshots that are being written.
    pub fn finish(&mut self) {
        self.writers.finish();
    }
}
