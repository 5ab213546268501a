//! The viewer's work: wishes and gestures change the scene; a frame draws it, where something has changed.

use super::{
    Loss, Message, Options,
    action::Action,
    gesture::{Gesture, Pointers},
    losses::Losses,
    overlay::Facts,
    pacing::Pacing,
    painter::Painter,
    panel::Overlay,
    scene::{Look, Scene},
    screenshot::Savers,
    steady::Pace,
    taps::Taps,
    times::FrameTimes,
};
use crate::{
    avatar::{Avatar, Clip},
    measure::trace::Trace,
    vulkan::Error,
};
use std::{
    sync::Arc,
    time::{Duration, Instant},
};
use winit::{
    event_loop::{ActiveEventLoop, EventLoopProxy},
    keyboard::ModifiersState,
    window::{Fullscreen, Window},
};

/// How often the overlay asks how much memory is in use, seconds.
const MEMORY: f64 = 0.5;

pub struct Viewer {
    pub(super) scene: Scene,
    pub(super) options: Options,
    pub(super) proxy: EventLoopProxy<Message>,
    pub(super) start: Instant,
    // The painter goes before the window.
    pub(super) painter: Option<Painter>,
    /// There is no window yet, or the system has taken it away for a while.
    pub(super) suspended: bool,
    pub(super) overlay: Option<Overlay>,
    pub(super) window: Option<Arc<Window>>,
    pub(super) pointers: Pointers,
    pub(super) taps: Taps,
    pub(super) modifiers: ModifiersState,
    /// The window's size as its events say, px. Asking for it would wait for the display server, and fails once the window is gone.
    pub(super) window_size: [u32; 2],
    /// The picture's size, px.
    pub(super) size: [u32; 2],
    pub(super) shown: Option<Look>,
    /// Something else than the look has changed: the panel, or what the system shows of the window.
    pub(super) dirty: bool,
    /// There is no area to draw to, or none of it is seen.
    pub(super) hidden: bool,
    /// The last chance to draw was not used: nothing had changed.
    pub(super) resting: bool,
    /// When egui wants to be asked again.
    pub(super) wake: Option<Instant>,
    shoot: bool,
    pub(super) savers: Savers,
    pub(super) message: Option<String>,
    times: FrameTimes,
    memory: (f64, u64),
    /// Frames drawn, and their times where they are wanted, ms.
    pub(super) drawn: u32,
    pub(super) measured: Vec<f64>,
    pub(super) pace: Option<Pace>,
    pub(super) pacing: Pacing,
    pub(super) trace: Option<Trace>,
    /// RenderDoc was attached when the device was opened.
    pub(super) capturable: bool,
    pub(super) losses: Losses,
    /// What was shown before, and its number on the shelf, until a frame of what is shown now has been drawn.
    pub(super) before: Option<(Scene, usize)>,
    /// How often the display shows something new, a second, where it says so; and when it was asked, seconds.
    pub(super) display: (Option<f64>, f64),
}

impl Viewer {
    pub fn new((avatar, clips): (Avatar, Vec<Clip>), mut options: Options, proxy: EventLoopProxy<Message>) -> Self {
        let size = options.drawing.size;
        Self {
            scene: Scene::new(avatar, clips, options.background, (size, 0.0)),
            proxy,
            start: Instant::now(),
            painter: None,
            suspended: true,
            overlay: None,
            window: None,
            pointers: Pointers::default(),
            taps: Taps::default(),
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
            message: options.said.take(),
            times: FrameTimes::default(),
            memory: (f64::NEG_INFINITY, 0),
            drawn: 0,
            measured: Vec::with_capacity(options.frames.unwrap_or(0).min(1 << 20) as usize),
            pace: None,
            pacing: Pacing::default(),
            trace: None,
            capturable: false,
            losses: Losses::default(),
            before: None,
            display: (None, f64::NEG_INFINITY),
            options,
        }
    }

    /// Seconds since the viewer was made.
    pub(super) fn clock(&self) -> f64 {
        self.start.elapsed().as_secs_f64()
    }

    /// A frame should be drawn as soon as the display takes it.
    pub(super) fn wants_frame(&self) -> bool {
        let early = self.next_frame().is_some_and(|next| self.clock() < next);
        self.painter.is_some() && !self.suspended && !self.hidden && !early && (self.dirty || self.scene.is_moving() || self.is_restless())
    }

    /// Frames are drawn even where nothing changes.
    fn is_restless(&self) -> bool {
        self.options.frames.is_some() || self.pace.as_ref().is_some_and(Pace::soaks)
    }

    /// When something is to be done without anyone's doing: egui asks for a frame, or a finger has pressed for long.
    pub(super) fn wake_at(&self) -> Option<Instant> {
        let pressed = self.taps.due().map(|due| self.start + Duration::from_secs_f64(due));
        let next = self.next_frame().filter(|_| self.scene.is_moving());
        let next = next.map(|due| self.start + Duration::from_secs_f64(due.max(0.0)));
        let shown = [self.wake, next].map(|due| due.filter(|_| !self.hidden && !self.suspended));
        shown.into_iter().chain([pressed]).flatten().min()
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
            Action::LeaveFullScreenOrQuit | Action::Quit => quit(event_loop),
            Action::Avatar(number) => self.fetch(number),
            Action::NextAvatar => self.fetch((self.options.shelf.shown + 1) % self.options.shelf.names.len().max(1)),
            #[cfg(target_os = "android")]
            Action::Share => super::android::share(app(event_loop), self.options.report.clone().unwrap_or_default()),
            Action::Screenshot => self.shoot = true,
            Action::Capture => self.capture(),
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

    pub(super) fn draw(&mut self, wishes: &mut Vec<Action>) -> Result<(), Error> {
        self.rehearse(&[Loss::Surface, Loss::Device], self.drawn)?;
        let (clock, restless) = (self.clock(), self.is_restless());
        let moment = self.in_step(clock);
        let (Some(painter), Some(overlay), Some(window)) = (&mut self.painter, &mut self.overlay, &self.window) else { return Ok(()) };
        if cfg!(target_os = "android") {
            // While the activity is paused its window's events are lost.
            self.window_size = window.inner_size().into();
        }
        let Some(size) = painter.fit(self.window_size)? else {
            self.hidden = true;
            return Ok(());
        };
        if size != self.size {
            self.size = size;
            self.scene.resize(size);
        }
        let mut held = false;
        if let Some(pace) = &mut self.pace {
            pace.prepare(painter, &self.scene)?;
            // A held pose is shown once more, for it is showing frames that keeps the display's time.
            held = pace.holds();
            if self.resting {
                pace.rest(clock);
            }
        }
        let look = if held { self.scene.hold(moment, size) } else { self.scene.advance(moment, size) };
        if self.shown == Some(look) && !self.dirty && !held && !restless {
            self.resting = true;
            return Ok(());
        }
        self.times.frame(clock, !self.resting);
        if overlay.visible && clock - self.memory.0 > MEMORY {
            self.memory = (clock, painter.gpu().memory().0);
        }
        let facts = facts(&self.scene, (painter, &self.options, self.capturable), (&self.times, self.memory.1, self.message.as_deref()));
        let (mut panel, textures, wait) = overlay.lay_out((window, size), &facts, wishes);
        painter.set_textures(textures)?;
        let began = Instant::now();
        if !painter.paint(self.scene.posed(), &look, &mut panel)? {
            self.dirty = true;
            return Ok(());
        }
        tracing::debug!("frame {} at {clock:.3} s, {} × {}", self.drawn, size[0], size[1]);
        if self.drawn == 0 {
            tracing::info!("the first frame, {clock:.2} s after the avatar was read");
        }
        (self.drawn, self.before) = (self.drawn + 1, None);
        self.losses.drawn(clock);
        let (seen, now) = (painter.seen(), self.start.elapsed().as_secs_f64());
        if self.pace.as_mut().is_some_and(|pace| pace.frame(now, painter, seen)) {
            painter.look();
        }
        self.trace.iter_mut().for_each(|trace| trace.frame(painter.report()));
        self.stepped(clock, began);
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
}

/// The activity that the windows belong to.
#[cfg(target_os = "android")]
pub(super) fn app(event_loop: &ActiveEventLoop) -> &winit::platform::android::activity::AndroidApp {
    winit::platform::android::ActiveEventLoopExtAndroid::android_app(event_loop)
}

/// Ends the program; on a phone that is the system's to do.
fn quit(event_loop: &ActiveEventLoop) {
    #[cfg(target_os = "android")]
    super::android::back(app(event_loop));
    #[cfg(not(target_os = "android"))]
    event_loop.exit();
}

/// What the panel shows. `said`: the frames' times, the memory in use and the last message.
fn facts<'a>(
    scene: &'a Scene,
    (painter, options, capture): (&'a Painter, &'a Options, bool),
    (times, memory, message): (&'a FrameTimes, u64, Option<&'a str>),
) -> Facts<'a> {
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
        shelf: &options.shelf,
        report: options.report.is_some(),
        capture,
        background: scene.background(),
        follow: scene.follows(),
        message,
    }
}
