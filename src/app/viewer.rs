//! The viewer's work: wishes and gestures change the scene; a frame draws it, where something has changed.

use super::{
    Loss, Message, Options,
    action::Action,
    gesture::{Gesture, Pointers},
    overlay::Facts,
    painter::Painter,
    panel::Overlay,
    scene::{Look, Scene},
    screenshot::Savers,
    times::{FrameTimes, summary},
};
use crate::{
    avatar::{Avatar, Clip},
    vulkan::{Error, RendererOptions},
};
use anyhow::Context;
use std::{sync::Arc, time::Instant};
use winit::{
    dpi::PhysicalSize,
    event_loop::{ActiveEventLoop, EventLoopProxy},
    keyboard::ModifiersState,
    window::{Fullscreen, Window},
};

/// How often in a row a lost surface may be made anew.
const SURFACES: u32 = 5;
/// How often the overlay asks how much memory is in use, seconds.
const MEMORY: f64 = 0.5;

pub struct Viewer {
    pub(super) scene: Scene,
    options: Options,
    proxy: EventLoopProxy<Message>,
    start: Instant,
    // The painter goes before the window.
    painter: Option<Painter>,
    pub(super) overlay: Option<Overlay>,
    pub(super) window: Option<Arc<Window>>,
    pub(super) pointers: Pointers,
    pub(super) modifiers: ModifiersState,
    /// The window's size as its events say, px. Asking for it would wait for the display server, and fails once the window is gone.
    pub(super) window_size: [u32; 2],
    /// The picture's size, px.
    pub(super) size: [u32; 2],
    shown: Option<Look>,
    /// Something else than the look has changed: the panel, or what the system shows of the window.
    pub(super) dirty: bool,
    /// There is no area to draw to, or none of it is seen.
    pub(super) hidden: bool,
    /// The last chance to draw was not used: nothing had changed.
    resting: bool,
    /// When egui wants to be asked again.
    pub(super) wake: Option<Instant>,
    shoot: bool,
    savers: Savers,
    message: Option<String>,
    times: FrameTimes,
    memory: (f64, u64),
    /// Frames drawn, and their times where they are wanted, ms.
    drawn: u32,
    measured: Vec<f64>,
    lost_device: bool,
    lost_surfaces: u32,
}

impl Viewer {
    pub fn new((avatar, clips): (Avatar, Vec<Clip>), options: Options, proxy: EventLoopProxy<Message>) -> Self {
        let size = options.drawing.size;
        Self {
            scene: Scene::new(avatar, clips, options.background, (size, 0.0)),
            proxy,
            start: Instant::now(),
            painter: None,
            overlay: None,
            window: None,
            pointers: Pointers::default(),
            modifiers: ModifiersState::default(),
            window_size: size,
            size,
            shown: None,
            dirty: true,
            hidden: false,
            resting: true,
            wake: None,
            shoot: false,
            savers: Savers::default(),
            message: None,
            times: FrameTimes::default(),
            memory: (f64::NEG_INFINITY, 0),
            drawn: 0,
            measured: Vec::with_capacity(options.frames.unwrap_or(0).min(1 << 20) as usize),
            lost_device: false,
            lost_surfaces: 0,
            options,
        }
    }

    /// Seconds since the viewer was made.
    pub(super) fn clock(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    pub(super) fn open(&mut self, event_loop: &ActiveEventLoop) -> anyhow::Result<()> {
        if self.window.is_none() {
            let [width, height] = self.options.drawing.size;
            let attributes = Window::default_attributes()
                .with_title(format!("{} – Effigy", self.scene.avatar().name))
                .with_inner_size(PhysicalSize::new(width, height))
                .with_fullscreen(self.options.full_screen.then_some(Fullscreen::Borderless(None)));
            let window = Arc::new(event_loop.create_window(attributes).context("the window could not be opened")?);
            self.window_size = window.inner_size().into();
            self.window = Some(window);
        }
        let Some(window) = &self.window else { return Ok(()) };
        // A new overlay brings all its textures to the new device.
        let visible = self.overlay.as_ref().is_none_or(|overlay| overlay.visible);
        self.overlay = Some(Overlay::new(window, visible));
        let drawing = RendererOptions { size: self.window_size.map(|side| side.max(1)), ..self.options.drawing };
        let painter = Painter::new(window, self.scene.avatar(), &self.options.gpu, drawing)?;
        tracing::info!("showing `{}` with {}", self.scene.avatar().name, painter.gpu().probe.name);
        self.painter = Some(painter);
        self.shown = None;
        self.dirty = true;
        Ok(())
    }

    pub(super) fn close(&mut self) {
        self.painter = None;
    }

    /// A frame should be drawn as soon as the display takes it.
    pub(super) fn wants_frame(&self) -> bool {
        self.painter.is_some() && !self.hidden && (self.dirty || self.scene.is_moving() || self.options.frames.is_some())
    }

    pub(super) fn gesture(&mut self, gesture: &Gesture) {
        if *gesture != Gesture::default() {
            self.wake_up();
            self.scene.gesture(gesture, self.size);
            self.dirty = true;
        }
    }

    pub(super) fn act(&mut self, action: Action, event_loop: &ActiveEventLoop) {
        self.wake_up();
        self.dirty = true;
        self.scene.act(action, self.clock(), self.size);
        let Some(window) = &self.window else { return };
        let is_full = window.fullscreen().is_some();
        match action {
            Action::FullScreen => window.set_fullscreen((!is_full).then_some(Fullscreen::Borderless(None))),
            Action::LeaveFullScreenOrQuit if is_full => window.set_fullscreen(None),
            Action::LeaveFullScreenOrQuit | Action::Quit => event_loop.exit(),
            Action::Screenshot => self.shoot = true,
            Action::Overlay => {
                if let Some(overlay) = &mut self.overlay {
                    overlay.visible = !overlay.visible;
                    overlay.release();
                }
            }
            _ => {}
        }
    }

    /// The time since the last frame was rest, and no part of what begins now.
    fn wake_up(&mut self) {
        if self.resting {
            self.scene.rest(self.clock());
        }
    }

    pub(super) fn say(&mut self, message: String) {
        self.message = Some(message);
        self.dirty = true;
    }

    /// Draws a frame where something has changed. Errors that a new surface or a new device can heal are healed.
    pub(super) fn frame(&mut self, event_loop: &ActiveEventLoop) -> anyhow::Result<()> {
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
                self.open(event_loop).context("after the device was lost, it could not be opened again")?;
            }
            Err(error @ Error::DeviceLost(_)) => {
                return Err(error).context("the device was lost for the second time; is its driver up to date?");
            }
            Err(error) => return Err(error.into()),
        }
        wishes.into_iter().for_each(|wish| self.act(wish, event_loop));
        if self.options.frames.is_some_and(|frames| self.drawn >= frames) {
            event_loop.exit();
        }
        Ok(())
    }

    fn draw(&mut self, wishes: &mut Vec<Action>) -> Result<(), Error> {
        if let Some(at) = self.options.rehearse.iter().position(|&(_, frame)| frame == self.drawn) {
            return Err(match self.options.rehearse.remove(at).0 {
                Loss::Surface => Error::SurfaceLost("a rehearsal"),
                Loss::Device => Error::DeviceLost("a rehearsal"),
            });
        }
        let clock = self.clock();
        let (Some(painter), Some(overlay), Some(window)) = (&mut self.painter, &mut self.overlay, &self.window) else { return Ok(()) };
        let Some(size) = painter.fit(self.window_size)? else {
            self.hidden = true;
            return Ok(());
        };
        if size != self.size {
            self.size = size;
            self.scene.resize(size);
        }
        let look = self.scene.advance(clock, size);
        if self.shown == Some(look) && !self.dirty && self.options.frames.is_none() {
            self.resting = true;
            return Ok(());
        }
        self.times.frame(clock, !self.resting);
        if overlay.visible && clock - self.memory.0 > MEMORY {
            self.memory = (clock, painter.gpu().memory().0);
        }
        let facts = facts(&self.scene, painter, (&self.times, self.memory.1, self.message.as_deref()));
        let (panel, textures, wait) = overlay.lay_out((window, size), &facts, wishes);
        painter.set_textures(textures)?;
        let began = Instant::now();
        if !painter.paint(self.scene.posed(), &look, &panel)? {
            self.dirty = true;
            return Ok(());
        }
        tracing::debug!("frame {} at {clock:.3} s, {} × {}", self.drawn, size[0], size[1]);
        self.drawn += 1;
        if self.options.frames.is_some() {
            self.measured.push(1e3 * (self.start.elapsed().as_secs_f64() - clock));
        }
        self.wake = wait.map(|wait| began + wait);
        (self.shown, self.dirty, self.resting) = (Some(look), false, false);
        if std::mem::take(&mut self.shoot) {
            self.save_screenshot(look.background)?;
        }
        Ok(())
    }

    /// Copies the picture; another thread makes a file of it.
    fn save_screenshot(&mut self, background: [f32; 3]) -> Result<(), Error> {
        let Some(painter) = &mut self.painter else { return Ok(()) };
        let copied = painter.copy()?;
        let proxy = self.proxy.clone();
        self.savers.start(
            move || copied.decode().over(background),
            move |message| {
                // The window may be closed already; then there is no one left to tell.
                let _ = proxy.send_event(Message(message));
            },
        );
        Ok(())
    }

    /// Waits for files that are being written, and prints what was measured.
    pub(super) fn finish(mut self) {
        self.painter = None;
        self.savers.finish();
        if let Some([median, p95]) = summary(&mut self.measured) {
            println!("{} frames: median {median:.2} ms, p95 {p95:.2} ms", self.drawn);
        }
        tracing::info!("drew {} frames in {:.1} s", self.drawn, self.start.elapsed().as_secs_f64());
    }
}

/// What the panel shows. `said`: the frames' times, the memory in use and the last message.
fn facts<'a>(scene: &'a Scene, painter: &'a Painter, (times, memory, message): (&'a FrameTimes, u64, Option<&'a str>)) -> Facts<'a> {
    let (report, probe) = (painter.report(), &painter.gpu().probe);
    Facts {
        avatar: &scene.avatar().name,
        times,
        moving: scene.is_moving(),
        stages: &report.stages,
        gaussians: (report.counters.drawn, scene.avatar().gaussians.len()),
        skipped: &report.skipped,
        device: &probe.name,
        driver: &probe.driver,
        memory,
        playback: scene.playback(),
        background: scene.background(),
        follow: scene.follows(),
        message,
    }
}
