//! What keeps a viewer going while the system takes things away and gives them back: windows, surfaces, devices, memory; and what it shows.

use super::{
    Loss, Message, action::Action, painter::Painter, panel::Overlay, scene::Scene, shelf::Show, steady::Pace, times::summary,
    viewer::Viewer,
};
use crate::{
    measure::{capture::RenderDoc, trace::Trace},
    vulkan::{Error, RendererOptions},
};
use anyhow::Context;
use std::sync::Arc;
use winit::{
    dpi::PhysicalSize,
    event_loop::ActiveEventLoop,
    window::{Fullscreen, Window},
};

/// How often in a row a lost surface may be made anew.
const SURFACES: u32 = 5;

impl Viewer {
    /// There is a window to draw in, for the first time or again. What was kept of the device while there was none is used again.
    pub(super) fn open(&mut self, event_loop: &ActiveEventLoop) -> anyhow::Result<()> {
        self.suspended = false;
        (self.hidden, self.dirty, self.shown) = (false, true, None);
        if self.window.is_none() {
            let [width, height] = self.options.drawing.size;
            let attributes = Window::default_attributes()
                .with_title(format!("{} – Effigy", self.scene.avatar().name))
                .with_inner_size(PhysicalSize::new(width, height))
                .with_fullscreen(self.options.full_screen.then_some(Fullscreen::Borderless(None)));
            self.window = Some(Arc::new(event_loop.create_window(attributes).context("the window could not be opened")?));
        }
        let Some(window) = &self.window else { return Ok(()) };
        self.window_size = window.inner_size().into();
        #[cfg(target_os = "android")]
        super::android::ask_rate(super::viewer::app(event_loop));
        if let Some(painter) = &mut self.painter
            && painter.resume(window)?
        {
            return Ok(());
        }
        self.painter = None;
        self.equip()
    }

    /// Opens a device for the window, and all that the avatar needs on it.
    fn equip(&mut self) -> anyhow::Result<()> {
        let Some(window) = &self.window else { return Ok(()) };
        // A new overlay brings all its textures to the new device.
        let visible = self.overlay.as_ref().is_none_or(|overlay| overlay.visible);
        self.overlay = Some(Overlay::new(window, visible));
        let drawing = RendererOptions { size: self.window_size.map(|side| side.max(1)), ..self.options.drawing };
        let painter = Painter::new(window, self.scene.avatar(), &self.options.gpu, drawing)?;
        tracing::info!("showing `{}` with {}", self.scene.avatar().name, painter.gpu().probe.name);
        self.trace = self.options.trace.as_ref().map(|_| Trace::new(painter.gpu()));
        if self.pace.is_none() {
            let display = window.current_monitor().and_then(|monitor| monitor.refresh_rate_millihertz());
            self.pace = self.options.steady.as_ref().map(|steady| Pace::new(steady, display.map(|rate| f64::from(rate) / 1e3)));
        }
        self.painter = Some(painter);
        self.capturable = RenderDoc::attached().is_some();
        (self.shown, self.dirty) = (None, true);
        Ok(())
    }

    /// The window is about to go: what is its own goes first, the rest waits for the next one.
    pub(super) fn suspend(&mut self) {
        (self.suspended, self.resting) = (true, true);
        self.pointers.cancel();
        self.taps.forget();
        if let Some(overlay) = &mut self.overlay {
            overlay.release();
        }
        if let Some(Err(error)) = self.painter.as_mut().map(Painter::suspend) {
            tracing::warn!("{error}; opening the device again with the next window");
            self.painter = None;
        }
    }

    /// The system is short of memory: what no one can see gives up all of its own on the GPU.
    pub(super) fn save_memory(&mut self) {
        if self.suspended && self.painter.take().is_some() {
            tracing::info!("gave up the GPU's memory until there is a window again");
        }
    }

    /// Draws a frame where something has changed. Errors that a new surface or a new device can heal are healed.
    pub(super) fn frame(&mut self, event_loop: &ActiveEventLoop) -> anyhow::Result<()> {
        // The system's last wish for a frame may come when the window has gone.
        if self.suspended {
            return Ok(());
        }
        let mut wishes = Vec::new();
        match self.draw(&mut wishes) {
            Ok(()) => self.lost_surfaces = 0,
            Err(Error::SurfaceLost(call)) if self.lost_surfaces < SURFACES => {
                tracing::warn!("the window's surface was lost at {call}; making another");
                self.lost_surfaces += 1;
                self.dirty = true;
                self.painter.as_mut().map_or(Ok(()), Painter::lose_surface)?;
            }
            Err(error @ Error::DeviceLost(_)) if !self.lost_device => {
                tracing::warn!("{error}; opening it again");
                self.lost_device = true;
                self.painter = None;
                self.equip().context("after the device was lost, it could not be opened again")?;
            }
            Err(error @ Error::DeviceLost(_)) => {
                return Err(error).context("the device was lost for the second time; is its driver up to date?");
            }
            Err(error) => return Err(error.into()),
        }
        wishes.into_iter().for_each(|wish| self.act(wish, event_loop));
        if let (Some(pace), Some(painter)) = (self.pace.as_ref().filter(|pace| pace.is_over()), &self.painter) {
            event_loop.exit();
            return pace.conclude(&self.scene, painter);
        }
        if self.options.frames.is_some_and(|frames| self.drawn >= frames) {
            event_loop.exit();
        }
        Ok(())
    }

    /// Fails as if something had been lost, where that is to be rehearsed now.
    pub(super) fn rehearse(&mut self) -> Result<(), Error> {
        let Some(at) = self.options.rehearse.iter().position(|&(_, frame)| frame == self.drawn) else { return Ok(()) };
        Err(match self.options.rehearse.remove(at).0 {
            Loss::Surface => Error::SurfaceLost("a rehearsal"),
            Loss::Device => Error::DeviceLost("a rehearsal"),
        })
    }

    /// Takes what another thread has to say.
    pub(super) fn hear(&mut self, message: Message) -> anyhow::Result<()> {
        match message {
            Message::Say(text) => self.say(text),
            Message::Show(number, show) => {
                self.options.shelf.shown = number;
                return self.show(*show);
            }
        }
        Ok(())
    }

    /// Shows another avatar.
    fn show(&mut self, (avatar, clips): Show) -> anyhow::Result<()> {
        let background = self.scene.background();
        self.scene = Scene::new(avatar, clips, background, (self.size, self.clock()));
        (self.shown, self.dirty) = (None, true);
        // Its memory is free before the next one takes more.
        match self.painter.take() {
            Some(_) if !self.suspended => self.equip(),
            _ => Ok(()),
        }
    }

    /// Gets an avatar of the shelf; the one that is shown stays until it is read.
    pub(super) fn fetch(&mut self, number: usize) {
        let proxy = self.proxy.clone();
        self.options.shelf.fetch(number, move |read| {
            let message = match read {
                Ok(show) => Message::Show(number, Box::new(show)),
                Err(error) => Message::Say(format!("{error:#}")),
            };
            // The window may be closed already; then there is no one left to tell.
            let _ = proxy.send_event(message);
        });
    }

    /// A finger has tapped twice, or stayed for long.
    pub(super) fn tapped(&mut self, event_loop: &ActiveEventLoop, twice: bool) {
        self.act(if twice { Action::ResetView } else { Action::Overlay }, event_loop);
    }

    /// Waits for files that are being written, and writes and prints what was measured.
    pub(super) fn finish(mut self) {
        if let (Some(path), Some(trace), Some(painter)) = (&self.options.trace, &self.trace, &self.painter)
            && let Err(error) = trace.write(path, painter.gpu())
        {
            tracing::error!("{} can't be written: {error}", path.display());
        }
        self.painter = None;
        self.savers.finish();
        if let Some([median, p95]) = summary(&mut self.measured) {
            println!("{} frames: median {median:.2} ms, p95 {p95:.2} ms", self.drawn);
        }
        tracing::info!("drew {} frames in {:.1} s", self.drawn, self.start.elapsed().as_secs_f64());
    }
}
