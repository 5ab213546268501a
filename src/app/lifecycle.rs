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

/// How often a phone's display is asked for its rate, seconds: it changes that as it sees fit.
#[cfg(target_os = "android")]
const ASK: f64 = 1.0;

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
        let Some(window) = self.window.clone() else { return Ok(()) };
        self.window_size = window.inner_size().into();
        #[cfg(target_os = "android")]
        super::android::ask_rate(super::viewer::app(event_loop));
        self.see_display(event_loop);
        match self.painter.as_mut().map(|painter| painter.resume(&window)).transpose() {
            Ok(Some(true)) => Ok(()),
            Ok(_) => {
                self.painter = None;
                self.equip().or_else(|error| self.heal(error))
            }
            Err(error) => self.heal(error),
        }
    }

    /// Asks how often the display shows something new: that is the rate to hold, where the user did not name one.
    pub(super) fn see_display(&mut self, event_loop: &ActiveEventLoop) {
        #[cfg(target_os = "android")]
        let rate = super::android::rate(super::viewer::app(event_loop)).into_iter().chain(self.pacing.rate()).reduce(f64::min);
        #[cfg(not(target_os = "android"))]
        let rate = self.window.as_ref().and_then(|window| {
            let monitor = window.current_monitor().or_else(|| event_loop.primary_monitor())?;
            Some(f64::from(monitor.refresh_rate_millihertz()?) / 1e3)
        });
        self.display = (rate, self.clock());
        if let (Some(pace), Some(rate)) = (&mut self.pace, rate) {
            pace.display(rate);
        }
    }

    /// Opens a device for the window, and all that the avatar needs on it.
    pub(super) fn equip(&mut self) -> anyhow::Result<()> {
        let Some(window) = self.window.clone() else { return Ok(()) };
        let window = &window;
        // A new overlay brings all its textures to the new device.
        let visible = self.overlay.as_ref().is_none_or(|overlay| overlay.visible);
        self.overlay = Some(Overlay::new(window, visible));
        let number = self.losses.open();
        self.rehearse(&[Loss::Memory], number)?;
        let drawing = RendererOptions { size: self.window_size.map(|side| side.max(1)), ..self.options.drawing };
        let painter = Painter::new(window, self.scene.avatar(), &self.options.gpu, drawing)?;
        tracing::info!("showing `{}` with {}", self.scene.avatar().name, painter.gpu().probe.name);
        self.trace = self.options.trace.as_ref().map(|_| Trace::new(painter.gpu()));
        if self.pace.is_none() {
            self.pace = self.options.steady.as_ref().map(|steady| Pace::new(steady, self.display.0));
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
        #[cfg(target_os = "android")]
        if self.clock() - self.display.1 > ASK {
            self.see_display(event_loop);
        }
        let mut wishes = Vec::new();
        self.draw(&mut wishes).or_else(|error| self.heal(error.into()))?;
        wishes.into_iter().for_each(|wish| self.act(wish, event_loop));
        if let Some(pace) = self.pace.as_mut().filter(|pace| pace.is_over()) {
            event_loop.exit();
            return pace.conclude(&self.scene, self.painter.as_mut());
        }
        if self.options.frames.is_some_and(|frames| self.drawn >= frames) {
            event_loop.exit();
        }
        Ok(())
    }

    /// Makes anew what was lost, and goes back to what was shown before where the device can't draw what is to be shown now. What neither heals
    /// is handed back.
    pub(super) fn heal(&mut self, mut error: anyhow::Error) -> anyhow::Result<()> {
        loop {
            let healed = match error.downcast_ref::<Error>() {
                Some(Error::SurfaceLost(call)) if self.losses.surface() => {
                    tracing::warn!("the window's surface was lost at {call}; making another");
                    self.dirty = true;
                    match &mut self.painter {
                        Some(painter) => painter.lose_surface().map_err(Into::into),
                        None => self.equip(),
                    }
                }
                Some(Error::DeviceLost(_)) => {
                    if !self.losses.device() {
                        return Err(error.context("the device was lost for the second time in a row; is its driver up to date?"));
                    }
                    tracing::warn!("{error}; opening it again");
                    self.painter = None;
                    self.equip().context("after the device was lost, it could not be opened again")
                }
                _ => match self.before.take() {
                    Some((scene, shown)) => {
                        let said = format!("`{}` can't be shown: {error:#}", self.scene.avatar().name);
                        tracing::warn!("{said}");
                        self.painter = None;
                        (self.scene, self.options.shelf.shown) = (scene, shown);
                        self.scene.rest(self.clock());
                        self.say(said);
                        self.equip()
                    }
                    None => return Err(error),
                },
            };
            match healed {
                Ok(()) => return Ok(()),
                Err(next) => error = next,
            }
        }
    }

    /// Fails as if something had been lost, where one of these losses is to be rehearsed at that number.
    pub(super) fn rehearse(&mut self, losses: &[Loss], number: u32) -> Result<(), Error> {
        let due = |&(loss, at): &(Loss, u32)| at == number && losses.contains(&loss);
        let Some(at) = self.options.rehearse.iter().position(due) else { return Ok(()) };
        Err(match self.options.rehearse.remove(at).0 {
            Loss::Surface => Error::SurfaceLost("a rehearsal"),
            Loss::Device => Error::DeviceLost("a rehearsal"),
            Loss::Memory => Error::OutOfMemory { memory: "device", call: "a rehearsal" },
        })
    }

    /// Takes what another thread has to say.
    pub(super) fn hear(&mut self, message: Message) -> anyhow::Result<()> {
        match message {
            Message::Say(text) => self.say(text),
            Message::Show(number, show) => return self.show(number, *show),
        }
        Ok(())
    }

    /// Shows another avatar.
    fn show(&mut self, number: usize, (avatar, clips): Show) -> anyhow::Result<()> {
        let scene = Scene::new(avatar, clips, self.scene.background(), (self.size, self.clock()));
        let before = (std::mem::replace(&mut self.scene, scene), std::mem::replace(&mut self.options.shelf.shown, number));
        self.before.get_or_insert(before);
        self.pace.iter_mut().for_each(Pace::forget_still);
        (self.shown, self.dirty) = (None, true);
        // Its memory and the window are free before the next one takes them: Android gives a window to one surface at a time.
        let painted = self.painter.take().is_some();
        if painted && !self.suspended { self.equip().or_else(|error| self.heal(error)) } else { Ok(()) }
    }

    /// Gets an avatar of the shelf; the one that is shown stays until it is read.
    pub(super) fn fetch(&mut self, number: usize) {
        let proxy = self.proxy.clone();
        self.options.shelf.fetch(number, move |read| {
            let message = match read {
                Ok(show) => Message::Show(number, Box::new(show)),
                Err(error) => {
                    tracing::warn!("{error:#}");
                    Message::Say(format!("{error:#}"))
                }
            };
            // The window may be closed already; then there is no one left to tell.
            let _ = proxy.send_event(message);
        });
    }

    /// A finger has tapped twice, or stayed for long.
    pub(super) fn tapped(&mut self, event_loop: &ActiveEventLoop, twice: bool) {
        self.act(if twice { Action::ResetView } else { Action::Overlay }, event_loop);
    }

    /// A soak's results are written down while there is no window, for the system may end what no one sees without a word.
    pub(super) fn keep_books(&mut self) {
        if let Some(pace) = self.pace.as_mut().filter(|_| self.suspended) {
            pace.keep(&self.scene);
        }
    }

    /// Waits for files that are being written, and writes and prints what was measured.
    ///
    /// # Errors
    /// When a soak that was not over did not hold what it promised, or its files can't be written.
    pub(super) fn finish(mut self) -> anyhow::Result<()> {
        let concluded = self.pace.as_mut().map_or(Ok(()), |pace| pace.conclude(&self.scene, None));
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
        concluded
    }
}
