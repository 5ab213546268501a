//! The viewer: it connects the window's events, the scene and the painter. Everything that happens
//! to the window is decided here. Each concern keeps its state in a module of its own.

use crate::{
    action::Action,
    captures::Captures,
    dropped::{DroppedAvatar, DroppedContent},
    file_list::LoadedAvatar,
    frame_clock::{DrawnFrame, FrameClock},
    gesture::Gesture,
    host_window::HostWindow,
    input::InputState,
    message::{DroppedRead, Message},
    options::{DriverLoss, ViewerOptions},
    painter::WindowPainter,
    quality_control::{QualityControl, QualityController, SoakOptions},
    question::BackgroundTrials,
    recovery::{REHEARSAL, Recovery},
    scene::{FrameContent, ViewerBackground, ViewerScene},
    survey::{Survey, SurveyStart},
    ui::{Overlay, OverlayFrame, panel::PanelFacts},
};
use anyhow::Context;
use effigy_core::avatar::Avatar;
use effigy_measure::{soak::faults::SoakLimits, survey};
use effigy_render::vulkan::{Error, RendererOptions, cache};
use effigy_runtime::{governor::FrameQuality, slow_start::SlowStart};
use std::{path::PathBuf, sync::Arc, time::Instant};
use winit::{
    event::{KeyEvent, WindowEvent},
    event_loop::{ActiveEventLoop, EventLoopProxy},
    keyboard::ModifiersState,
};

/// How often the panel's memory use is read, seconds.
const MEMORY_INTERVAL: f64 = 0.5;
/// How often a phone's display is asked for its refresh rate, seconds: it changes on its own.
#[cfg(target_os = "android")]
const REFRESH_RATE_INTERVAL: f64 = 1.0;

/// An avatar in a window.
pub struct Viewer {
    options: ViewerOptions,
    proxy: EventLoopProxy<Message>,
    scene: ViewerScene,
    /// Dropped before the window. None while there is no device.
    painter: Option<WindowPainter>,
    overlay: Option<Overlay>,
    window: HostWindow,
    /// Size of the frames, px.
    frame_size: [u32; 2],
    input: InputState,
    clock: FrameClock,
    /// Created with the first device, if a frame rate is to be held.
    quality: Option<QualityController>,
    recovery: Recovery,
    /// Started with the first frame, if there is anything left to time.
    trials: Option<BackgroundTrials>,
    /// The last survey of the device.
    survey: Option<Survey>,
    /// While it runs.
    #[cfg(target_os = "android")]
    screen_on: Option<crate::android::ScreenOn>,
    /// From a device's opening to its first frame.
    slow_start: Option<SlowStart>,
    /// Shown before, until the first frame of the scene is drawn.
    previous: Option<PreviousScene>,
    captures: Captures,
    dropped: DroppedFiles,
    /// The panel's last message.
    message: Option<String>,
    memory: MemoryUse,
    /// When the display was last asked for its refresh rate, seconds.
    #[cfg(target_os = "android")]
    refresh_rate_read: f64,
}

/// The scene to go back to if the new one can't be drawn.
struct PreviousScene {
    scene: ViewerScene,
    /// Its index in the file list.
    index: usize,
}

/// Files that were dropped on the window.
#[derive(Default)]
struct DroppedFiles {
    /// Not read yet.
    waiting: Vec<PathBuf>,
    /// Others are being read: what was dropped first is shown first.
    reading: bool,
}

/// GPU memory in use.
struct MemoryUse {
    bytes: u64,
    /// When it was read, seconds.
    read: f64,
}

impl Viewer {
    /// A viewer without a window. It shows `loaded` once [`Self::open`] gives it one.
    pub fn new(
        loaded: LoadedAvatar,
        mut options: ViewerOptions,
        proxy: EventLoopProxy<Message>,
    ) -> Self {
        let size = options.renderer.size;
        let LoadedAvatar { avatar, clips } = loaded;
        let background = ViewerBackground {
            color: options.background,
            has_picture: options.picture.is_some(),
            shows_picture: options.picture.is_some(),
        };
        let mut scene = ViewerScene::new(avatar, clips, background, size, 0.0);
        if options.live {
            scene.act(Action::PlayOrPause, 0.0, size);
        }
        Self {
            scene,
            painter: None,
            overlay: None,
            window: HostWindow::new(size),
            frame_size: size,
            input: InputState::default(),
            clock: FrameClock::new(options.frames),
            quality: None,
            recovery: Recovery::new(std::mem::take(&mut options.rehearse)),
            trials: None,
            survey: None,
            #[cfg(target_os = "android")]
            screen_on: None,
            slow_start: None,
            previous: None,
            captures: Captures::new(
                std::mem::take(&mut options.folders),
                options.trace.take(),
                proxy.clone(),
            ),
            dropped: DroppedFiles::default(),
            message: options.message.take(),
            memory: MemoryUse {
                bytes: 0,
                read: f64::NEG_INFINITY,
            },
            #[cfg(target_os = "android")]
            refresh_rate_read: f64::NEG_INFINITY,
            options,
            proxy,
        }
    }

    // Window and device.

    /// There is a window to draw in, for the first time or again. A device that outlived the last
    /// window is used again.
    pub fn open(&mut self, event_loop: &ActiveEventLoop) -> anyhow::Result<()> {
        self.clock.invalidate_all();
        let window = self.window.open(
            event_loop,
            title(&self.scene),
            self.options.renderer.size,
            self.options.full_screen,
        )?;
        #[cfg(target_os = "android")]
        crate::android::request_highest_rate(crate::android::activity(event_loop));
        self.update_refresh_rate(event_loop);
        let Some(painter) = &mut self.painter else {
            return self.open_device_or_recover();
        };
        match painter.resume(&window) {
            Ok(true) => Ok(()),
            Ok(false) => {
                self.painter = None;
                self.open_device_or_recover()
            }
            Err(error) => self.recover(error),
        }
    }

    /// Opens a device for the window, with all that the avatar needs on it.
    fn open_device(&mut self) -> anyhow::Result<()> {
        let Some(window) = self.window.get() else {
            return Ok(());
        };
        // The textures of a new overlay are all uploaded to the new device.
        let is_visible = self.overlay.as_ref().is_none_or(Overlay::is_visible);
        self.overlay = Some(Overlay::new(window, is_visible));
        self.recovery.open_device()?;
        let full_quality = RendererOptions {
            size: self.window.size().map(|side| side.max(1)),
            ..self.options.renderer
        };
        let avatar = self.scene.avatar();
        let slow_start = cache::is_first_start(self.options.gpu.cache.as_deref()).then(|| {
            SlowStart::new(|| {
                tracing::warn!("starting: the driver compiles shaders at a first start");
            })
        });
        let picture = self.options.picture.clone();
        let painter = WindowPainter::new(window, avatar, &self.options.gpu, full_quality, picture)?;
        self.slow_start = slow_start;
        tracing::info!(
            "showing `{}` with {}",
            avatar.name,
            painter.gpu().probe.name
        );
        self.captures.device_opened(painter.gpu());
        if self.quality.is_none()
            && let Some(options) = &self.options.quality_control
        {
            let refresh_rate = self.window.refresh_rate();
            self.quality = Some(QualityController::new(options, refresh_rate));
        }
        self.painter = Some(painter);
        self.clock.invalidate_all();
        Ok(())
    }

    fn open_device_or_recover(&mut self) -> anyhow::Result<()> {
        match self.open_device() {
            Ok(()) => Ok(()),
            Err(error) => self.recover(error),
        }
    }

    /// The system takes the window away. The device stays for the next one.
    pub fn suspend(&mut self) {
        self.end_survey("the window was left");
        self.window.suspend();
        self.clock.rest();
        self.release_pointers();
        // The system may end the program now, as it likes.
        if let Some(trials) = &self.trials {
            trials.withdraw();
        }
        if let Some(painter) = &mut self.painter
            && let Err(error) = painter.suspend()
        {
            tracing::warn!("{error}; opening the device again with the next window");
            self.painter = None;
        }
    }

    /// The system is short of memory. Without a window the device is closed.
    pub fn free_memory(&mut self) {
        if self.window.is_suspended() && self.painter.take().is_some() {
            tracing::info!("gave up the GPU's memory until there is a window again");
        }
    }

    /// The window has a new size, px.
    pub fn resize(&mut self, size: [u32; 2]) {
        self.window.resize(size);
        self.clock.invalidate();
    }

    /// Other windows hide this one, or no longer do.
    pub fn set_occluded(&mut self, occluded: bool) {
        self.window.set_hidden(occluded);
        if occluded {
            self.clock.rest();
        } else {
            self.clock.invalidate();
        }
    }

    /// The window has got or lost the keyboard's focus.
    pub fn set_focused(&mut self, focused: bool) {
        if focused {
            self.window.set_hidden(false);
        } else {
            self.release_pointers();
        }
    }

    /// Asks for the display's refresh rate: the one to hold, unless the user has named another.
    pub fn update_refresh_rate(&mut self, event_loop: &ActiveEventLoop) {
        #[cfg(not(target_os = "android"))]
        self.window.update_refresh_rate(event_loop);
        #[cfg(target_os = "android")]
        {
            let present_rate = self.clock.sync().display_rate();
            self.window.update_refresh_rate(event_loop, present_rate);
            self.refresh_rate_read = self.clock.now();
        }
        if let Some(quality) = &mut self.quality
            && let Some(rate) = self.window.refresh_rate()
        {
            quality.set_refresh_rate(rate);
        }
    }

    /// Whether there is no window to draw to.
    #[cfg(target_os = "android")]
    pub fn is_suspended(&self) -> bool {
        self.window.is_suspended()
    }

    // Input.

    /// Passes an event to the panel, and to the scene if the panel leaves it. Returns whether the
    /// panel has consumed it.
    pub fn input(&mut self, event_loop: &ActiveEventLoop, event: &WindowEvent) -> bool {
        let Some(window) = self.window.get() else {
            return false;
        };
        let Some(overlay) = &mut self.overlay else {
            return false;
        };
        let response = overlay.event(window, event);
        if response.repaint {
            self.clock.invalidate();
        }
        if let WindowEvent::Touch(touch) = event {
            let now = self.clock.now();
            let scale = self.window.scale();
            if self
                .input
                .is_double_tap(touch, response.consumed, now, scale)
            {
                self.act(Action::ResetView, event_loop);
            }
        }
        if let Some(gesture) = self.input.gesture(event, response.consumed) {
            self.gesture(&gesture);
        }
        response.consumed
    }

    /// Whether the window is open and has its panel: only then it handles events.
    pub fn is_open(&self) -> bool {
        self.window.get().is_some() && self.overlay.is_some()
    }

    /// A key was pressed that the panel leaves.
    pub fn key_pressed(&mut self, event_loop: &ActiveEventLoop, event: &KeyEvent) {
        let repeat = self.scene.playback().repeat();
        if let Some(action) = self.input.key_action(event, repeat) {
            self.act(action, event_loop);
        }
    }

    /// The modifier keys that are down have changed.
    pub fn set_modifiers(&mut self, modifiers: ModifiersState) {
        self.input.set_modifiers(modifiers);
    }

    /// Time has passed: carries out what waited for it.
    pub fn wake(&mut self, event_loop: &ActiveEventLoop) {
        self.clock.check_panel_wake();
        if self.input.take_long_press(self.clock.now()) {
            self.act(Action::Overlay, event_loop);
        }
    }

    fn gesture(&mut self, gesture: &Gesture) {
        if *gesture != Gesture::default() {
            self.skip_rest();
            self.scene.gesture(gesture, self.frame_size);
            self.clock.invalidate();
        }
    }

    /// Carries out what the user asks for.
    fn act(&mut self, action: Action, event_loop: &ActiveEventLoop) {
        self.skip_rest();
        self.clock.invalidate();
        self.scene.act(action, self.clock.now(), self.frame_size);
        if self.window.get().is_none() {
            return;
        }
        match action {
            Action::FullScreen => self.window.toggle_full_screen(),
            Action::LeaveFullScreenOrQuit if self.close_lists() => {}
            Action::LeaveFullScreenOrQuit if self.window.leave_full_screen() => {}
            Action::LeaveFullScreenOrQuit | Action::Quit => quit(event_loop),
            Action::Avatar(index) => self.request_avatar(index),
            Action::NextAvatar => {
                if let Some(next) = self.options.file_list.next() {
                    self.request_avatar(next);
                }
            }
            #[cfg(target_os = "android")]
            Action::Share => {
                let report = self.options.crash_report.clone().unwrap_or_default();
                crate::android::share(crate::android::activity(event_loop), report);
            }
            #[cfg(target_os = "android")]
            Action::ShareSurvey => {
                let text = self.survey.as_ref().map(Survey::json).unwrap_or_default();
                crate::android::share(crate::android::activity(event_loop), text);
            }
            Action::Survey if self.is_surveying() => self.end_survey("it was stopped"),
            Action::Survey => self.start_survey(survey::MINUTES, event_loop),
            Action::Screenshot => self.captures.request_screenshot(),
            Action::Capture => self.message = Some(self.captures.request_renderdoc()),
            Action::Overlay => {
                if let Some(overlay) = &mut self.overlay {
                    overlay.toggle();
                }
            }
            Action::Keys => {
                if let Some(overlay) = &mut self.overlay {
                    overlay.toggle_keys();
                }
            }
            Action::Open if self.options.opener.is_some() => {
                if let Some(overlay) = &mut self.overlay {
                    overlay.toggle_browser();
                }
            }
            _ => {}
        }
    }

    /// Hides the lists over the avatar. Returns whether one was shown.
    fn close_lists(&mut self) -> bool {
        self.overlay.as_mut().is_some_and(Overlay::close_lists)
    }

    /// Nothing was drawn until now: this time is not part of the movement that begins.
    fn skip_rest(&mut self) {
        if self.clock.is_resting() {
            self.scene.skip_to(self.clock.now());
        }
    }

    /// Stops following buttons and fingers that are down: their events will not come any more.
    fn release_pointers(&mut self) {
        self.input.cancel();
        if let Some(overlay) = &mut self.overlay {
            overlay.release();
        }
    }

    // Messages and avatars.

    /// Receives a message from another thread.
    pub fn receive(
        &mut self,
        event_loop: &ActiveEventLoop,
        message: Message,
    ) -> anyhow::Result<()> {
        match message {
            Message::Text(text) => {
                self.show_message(text);
                Ok(())
            }
            Message::Loaded { index, loaded } => self.show_avatar(index, *loaded),
            Message::Dropped(read) => self.show_dropped(*read),
            Message::Newer { avatar, .. } => self.show_newer(avatar),
            Message::Survey => {
                self.advance_survey();
                Ok(())
            }
            Message::Close => {
                event_loop.exit();
                Ok(())
            }
        }
    }

    fn show_message(&mut self, message: String) {
        self.message = Some(message);
        self.clock.invalidate();
    }

    /// Reads an avatar of the file list on another thread. The current one stays until then.
    pub fn request_avatar(&mut self, index: usize) {
        let proxy = self.proxy.clone();
        self.options.file_list.request(index, move |loaded| {
            let message = match loaded {
                Ok(loaded) => Message::Loaded {
                    index,
                    loaded: Box::new(loaded),
                },
                Err(error) => {
                    tracing::warn!("{error:#}");
                    Message::Text(format!("{error:#}"))
                }
            };
            // If the window is closed already, no one is left to receive it.
            let _ = proxy.send_event(message);
        });
    }

    /// A file was dropped on the window. Others of the same drop may follow.
    pub fn drop_file(&mut self, path: PathBuf) {
        if self.options.opener.is_some() {
            self.dropped.waiting.push(path);
        }
    }

    /// Reads files that were dropped, on another thread. What is shown stays until then.
    pub fn open_dropped(&mut self) {
        if self.dropped.reading || self.dropped.waiting.is_empty() {
            return;
        }
        let Some(opener) = self.options.opener.clone() else {
            return;
        };
        let files = std::mem::take(&mut self.dropped.waiting);
        let shown = self.scene.avatar().clone();
        let request = self.options.file_list.latest_request();
        let proxy = self.proxy.clone();
        let names = files.iter().filter_map(|path| path.file_name());
        let names: Vec<_> = names.map(|name| name.to_string_lossy()).collect();
        self.show_message(format!("opening {}", names.join(", ")));
        let read = move || {
            let content = DroppedContent::read(&files, &shown, opener.as_ref());
            let read = DroppedRead {
                files,
                shown,
                request,
                content,
            };
            // If the window is closed already, no one is left to receive it.
            let _ = proxy.send_event(Message::Dropped(Box::new(read)));
        };
        let thread = std::thread::Builder::new().name("dropped files".into());
        match thread.spawn(read) {
            Ok(_) => self.dropped.reading = true,
            Err(error) => self.show_message(format!("the files can't be opened: {error}")),
        }
    }

    /// Shows what was read of files that were dropped.
    fn show_dropped(&mut self, read: DroppedRead) -> anyhow::Result<()> {
        self.dropped.reading = false;
        let DroppedContent {
            avatar,
            clips,
            messages,
            failed,
        } = read.content;
        let is_shown = Arc::ptr_eq(self.scene.avatar(), &read.shown);
        if avatar.is_none() && !clips.is_empty() && !is_shown {
            // Another avatar was chosen meanwhile: it is the one to move.
            self.dropped.waiting.splice(0..0, read.files);
            return Ok(());
        }
        self.message = (!messages.is_empty()).then(|| messages.join("\n"));
        if failed && let Some(overlay) = &mut self.overlay {
            overlay.show();
        }
        self.skip_rest();
        self.clock.invalidate();
        self.scene.add_clips(clips, self.clock.now());
        let is_latest = self.options.file_list.latest_request() == read.request;
        let (Some(avatar), Some(opener), true) = (avatar, &self.options.opener, is_latest) else {
            return Ok(());
        };
        // An avatar that is still being read was asked for before this one.
        self.options.file_list.begin_request();
        let DroppedAvatar { path, loaded } = avatar;
        let load = {
            let (path, opener) = (path.clone(), opener.clone());
            move || opener.avatar(&path).map(|opened| opened.content)
        };
        let index = self.options.file_list.add(&path, load);
        self.show_avatar(index, loaded)
    }

    /// Shows another avatar of the file list.
    fn show_avatar(&mut self, index: usize, loaded: LoadedAvatar) -> anyhow::Result<()> {
        self.end_survey("another avatar was shown");
        let LoadedAvatar { avatar, clips } = loaded;
        let background = self.scene.background();
        let now = self.clock.now();
        let scene = ViewerScene::new(avatar, clips, background, self.frame_size, now);
        let previous = PreviousScene {
            scene: std::mem::replace(&mut self.scene, scene),
            index: std::mem::replace(&mut self.options.file_list.shown, index),
        };
        // A scene that was never drawn is nothing to go back to.
        self.previous.get_or_insert(previous);
        self.window.set_title(&title(&self.scene));
        if let Some(quality) = &mut self.quality {
            quality.avatar_changed();
        }
        self.clock.invalidate_all();
        // The old painter's memory and window must be free before there is a new one: Android gives
        // a window to one surface at a time.
        let had_device = self.painter.take().is_some();
        if had_device && !self.window.is_suspended() {
            return self.open_device_or_recover();
        }
        Ok(())
    }

    /// Shows a newer state of the avatar. Where it can't be drawn, the last one stays.
    fn show_newer(&mut self, avatar: Arc<Avatar>) -> anyhow::Result<()> {
        let began = Instant::now();
        let replaced = match &mut self.painter {
            Some(painter) => painter.replace_avatar(&avatar),
            None => Ok(()),
        };
        match replaced {
            Ok(()) => {}
            Err(error @ (Error::DeviceLost(_) | Error::Timeout { .. })) => {
                return self.recover(error.into());
            }
            Err(error) => {
                tracing::warn!("the newer avatar can't be shown: {error}");
                self.show_message(format!("the newer avatar can't be shown: {error}"));
                return Ok(());
            }
        }
        self.scene.replace_avatar(avatar);
        if let Some(quality) = &mut self.quality {
            quality.avatar_changed();
        }
        self.clock.invalidate_all();
        let took = began.elapsed().as_secs_f64() * 1e3;
        tracing::debug!("a newer avatar, in {took:.0} ms");
        Ok(())
    }

    // Frames.

    /// The system wants a frame: draws it, if something has changed.
    pub fn redraw(&mut self, event_loop: &ActiveEventLoop) -> anyhow::Result<()> {
        if !self.wants_frame() {
            // The viewer did not ask for it: the system has lost what it showed of the window.
            self.clock.invalidate();
        }
        self.window.set_hidden(false);
        // The last request may come when the window has gone.
        if self.window.is_suspended() {
            return Ok(());
        }
        #[cfg(target_os = "android")]
        if self.clock.now() - self.refresh_rate_read > REFRESH_RATE_INTERVAL {
            self.update_refresh_rate(event_loop);
        }
        let mut actions = Vec::new();
        if let Err(error) = self.draw(&mut actions) {
            self.recover(error.into())?;
        }
        for action in actions {
            self.act(action, event_loop);
        }
        if self.clock.frames() > 0
            && let Some(minutes) = self.options.survey.take()
        {
            self.start_survey(minutes, event_loop);
        }
        let is_over = self
            .quality
            .as_ref()
            .is_some_and(QualityController::is_over);
        if is_over && self.is_surveying() {
            self.end_survey("its soak drew nothing");
        } else if is_over && let Some(quality) = &mut self.quality {
            event_loop.exit();
            return quality.conclude(&self.scene, self.painter.as_mut());
        }
        if self.clock.has_reached_limit() {
            event_loop.exit();
        }
        Ok(())
    }

    /// Draws a frame, if something has changed. The user's actions in the panel are added to
    /// `actions`.
    fn draw(&mut self, actions: &mut Vec<Action>) -> Result<(), Error> {
        self.recovery.rehearse(
            &[DriverLoss::Surface, DriverLoss::Device],
            self.clock.frames(),
        )?;
        let began = self.clock.now();
        let Some(content) = self.next_content(began)? else {
            return Ok(());
        };
        self.clock.begin_frame(began);
        let Some(mut panel) = self.lay_out_panel(began) else {
            return Ok(());
        };
        actions.append(&mut panel.actions);
        if let Some(path) = panel.chosen.take() {
            self.drop_file(path);
        }
        let Some(painter) = &mut self.painter else {
            return Ok(());
        };
        painter.set_textures(panel.textures)?;
        if self.captures.wants_frame() {
            painter.request_copy();
        }
        let painted = Instant::now();
        if !painter.paint(self.scene.posed(), &content, &mut panel.mesh)? {
            self.clock.invalidate();
            return Ok(());
        }
        self.end_frame(DrawnFrame {
            content,
            began,
            painted,
            repaint_after: panel.repaint_after,
        })
    }

    /// Fits the painter to the window, and moves the scene on. Returns the content of a frame that
    /// begins at `now`, seconds. None: there is nothing new to draw, or nothing to draw on.
    fn next_content(&mut self, now: f64) -> Result<Option<FrameContent>, Error> {
        let refreshes = self.refreshes();
        let is_continuous = self.is_continuous();
        let Some(painter) = &mut self.painter else {
            return Ok(None);
        };
        let time = self.clock.frame_time(now, refreshes, painter);
        if cfg!(target_os = "android") {
            self.window.update_size();
        }
        let Some(size) = painter.fit(self.window.size())? else {
            self.window.set_hidden(true);
            return Ok(None);
        };
        if size != self.frame_size {
            self.frame_size = size;
            self.scene.resize(size);
        }

        let mut holds_pose = false;
        if let Some(quality) = &mut self.quality {
            quality.prepare(painter, &self.scene)?;
            holds_pose = quality.holds_pose();
            if self.clock.is_resting() {
                quality.rest(now);
            }
        }
        let content = if holds_pose {
            self.scene.hold_pose(time, size)
        } else {
            self.scene.advance(time, size)
        };
        // A held pose is drawn again: only a stream of frames stays in step with the display.
        if self.clock.shows(&content) && !holds_pose && !is_continuous {
            self.clock.rest();
            return Ok(None);
        }
        Ok(Some(content))
    }

    /// Lays out the panel for a frame that begins at `now`, seconds. None without a window.
    fn lay_out_panel(&mut self, now: f64) -> Option<OverlayFrame> {
        let is_surveying = self.is_surveying();
        let can_survey = is_surveying || !self.options.live && !self.is_continuous();
        let window = self.window.get()?;
        let overlay = self.overlay.as_mut()?;
        let painter = self.painter.as_ref()?;
        if overlay.is_visible() && now - self.memory.read > MEMORY_INTERVAL {
            self.memory = MemoryUse {
                bytes: painter.gpu().memory().0,
                read: now,
            };
        }
        let report = painter.report();
        let probe = &painter.gpu().probe;
        let facts = PanelFacts {
            avatar: &self.scene.avatar().name,
            times: self.clock.times(),
            moving: self.scene.is_moving(),
            stages: &report.stages,
            drawn_gaussians: report.counters.drawn,
            samples: report.counters.most_samples,
            level: report.counters.coarsest_level,
            gaussians: self.scene.avatar().gaussians.len(),
            skipped: &report.skipped,
            device: &probe.name,
            driver: &probe.driver,
            drawing: painter.drawing(),
            memory: self.memory.bytes,
            playback: self.scene.playback(),
            can_survey,
            is_surveying,
            survey: self.survey.as_ref().map_or(&[], Survey::words),
            file_list: &self.options.file_list,
            has_crash_report: self.options.crash_report.is_some(),
            has_renderdoc: self.captures.has_renderdoc(),
            background: self.scene.background().color,
            follow: self.scene.follows(),
            message: self.message.as_deref(),
        };
        Some(overlay.lay_out(window, self.frame_size, &facts))
    }

    /// A frame was submitted: all that follows from it.
    fn end_frame(&mut self, frame: DrawnFrame) -> Result<(), Error> {
        let Some(painter) = &mut self.painter else {
            return Ok(());
        };
        let FrameContent { background, .. } = frame.content;
        let [width, height] = self.frame_size;
        let number = self.clock.frames();
        tracing::debug!("frame {number} at {:.3} s, {width} × {height}", frame.began);
        if number == 0 {
            tracing::info!(
                "the first frame, {:.2} s after the avatar was read",
                frame.began
            );
            // A measurement would be disturbed.
            let is_soaking = self
                .quality
                .as_ref()
                .is_some_and(QualityController::is_soaking);
            if self.options.frames.is_none() && !self.options.live && !is_soaking {
                self.trials = BackgroundTrials::start(&self.options.gpu, painter, &self.scene);
            }
        }
        self.previous = None;
        self.slow_start = None;
        self.recovery.frame_drawn(frame.began);
        let validation = painter.poll_validation();
        let submitted = self.clock.now();
        if let Some(quality) = &mut self.quality
            && quality.frame_submitted(submitted, painter, validation)
        {
            painter.request_validation();
        }
        self.captures.trace_frame(painter);
        self.clock.end_frame(&frame, painter.report());
        self.captures.save_screenshot(painter, background)?;
        Ok(())
    }

    /// Whether a frame should be drawn as soon as the display takes it.
    pub fn wants_frame(&self) -> bool {
        let is_early = self
            .next_frame()
            .is_some_and(|next| self.clock.now() < next);
        self.painter.is_some()
            && self.window.is_visible()
            && !is_early
            && (self.clock.is_dirty() || self.scene.is_moving() || self.is_continuous())
    }

    /// Asks the system to redraw the window, if a frame is needed and can be seen.
    pub fn request_redraw(&mut self) {
        if !self.wants_frame() {
            return;
        }
        self.window.check_minimized();
        if self.window.is_visible()
            && let Some(window) = self.window.get()
        {
            window.request_redraw();
        }
    }

    /// When to call [`Self::wake`]: a frame is due, the panel wants one, or a finger becomes a long
    /// press.
    pub fn wake_at(&self) -> Option<Instant> {
        let long_press = self.input.long_press_at().map(|at| self.clock.instant(at));
        let mut panel = None;
        let mut frame = None;
        if self.window.is_visible() {
            panel = self.clock.panel_wake();
            if self.scene.is_moving() {
                frame = self.next_frame().map(|at| self.clock.instant(at));
            }
        }
        [long_press, panel, frame].into_iter().flatten().min()
    }

    /// Whether frames are drawn even if nothing changes.
    fn is_continuous(&self) -> bool {
        self.clock.has_limit()
            || self
                .quality
                .as_ref()
                .is_some_and(QualityController::is_soaking)
    }

    /// Refreshes of the display that every frame is shown for.
    fn refreshes(&self) -> u32 {
        self.quality
            .as_ref()
            .map_or(1, |quality| quality.quality().refreshes)
    }

    /// When the next frame may begin, seconds. None: at once.
    fn next_frame(&self) -> Option<f64> {
        let quality = self.quality.as_ref()?;
        self.clock
            .sync()
            .next_frame(self.clock.now(), self.refreshes())
            .or_else(|| quality.next_frame())
    }

    // Losses and the end.

    /// Replaces a lost surface or device. If the new scene can't be drawn, goes back to the one
    /// before. Returns errors that none of this helps against.
    fn recover(&mut self, mut error: anyhow::Error) -> anyhow::Result<()> {
        loop {
            let excused = self.is_excused(&error);
            // A device that hangs is opened again only to be drawn on in another way, or without
            // trials.
            let may_reopen = match error.downcast_ref::<Error>() {
                Some(failure @ Error::DeviceLost(call)) => {
                    if *call != REHEARSAL && !excused {
                        self.strike_off(failure);
                    }
                    true
                }
                Some(failure @ Error::Timeout { .. }) => excused || self.strike_off(failure),
                _ => false,
            };
            let recovered = match error.downcast_ref::<Error>() {
                Some(Error::SurfaceLost(call)) if self.recovery.surface_lost() => {
                    tracing::warn!("the window's surface was lost at {call}; making another");
                    self.clock.invalidate();
                    match &mut self.painter {
                        Some(painter) => painter.drop_surface().map_err(Into::into),
                        None => self.open_device(),
                    }
                }
                Some(Error::DeviceLost(_) | Error::Timeout { .. }) if may_reopen => {
                    if !excused && !self.recovery.device_lost() {
                        return Err(error.context(
                            "the device was lost for the second time in a row; is its driver up to date?",
                        ));
                    }
                    tracing::warn!("{error}; opening it again");
                    self.painter = None;
                    self.open_device()
                        .context("after the device was lost, it could not be opened again")
                }
                _ => {
                    let Some(previous) = self.previous.take() else {
                        return Err(error);
                    };
                    self.revert(previous, &error);
                    self.open_device()
                }
            };
            match recovered {
                Ok(()) => return Ok(()),
                Err(next) => error = next,
            }
        }
    }

    /// Whether the device was lost or hangs, and trials behind the window may be to blame. Then the
    /// way to draw is not, before it loses the device again.
    fn is_excused(&mut self, error: &anyhow::Error) -> bool {
        let is_lost = match error.downcast_ref::<Error>() {
            Some(Error::DeviceLost(call)) => *call != REHEARSAL,
            Some(Error::Timeout { .. }) => true,
            _ => false,
        };
        if is_lost && self.survey.as_ref().is_some_and(Survey::is_measuring) {
            tracing::warn!("the device was lost while it was surveyed on another");
            self.end_survey("the device was lost");
            return true;
        }
        let trials = self.trials.as_ref().filter(|_| is_lost);
        let is_excused = trials.is_some_and(BackgroundTrials::may_have_lost_the_device);
        if is_excused {
            tracing::warn!("the device was lost while quads and tiles were compared on another");
        }
        is_excused
    }

    /// The device was lost or hangs. Returns whether the next one draws in another way: the way
    /// that was measured to be fastest is then not used any more.
    fn strike_off(&self, failure: &Error) -> bool {
        let painter = self.painter.as_ref();
        painter.is_some_and(|painter| painter.strike_off(failure))
    }

    /// Goes back to the previous scene, since the current one can't be drawn.
    fn revert(&mut self, previous: PreviousScene, error: &anyhow::Error) {
        let message = format!("`{}` can't be shown: {error:#}", self.scene.avatar().name);
        tracing::warn!("{message}");
        self.painter = None;
        self.scene = previous.scene;
        self.options.file_list.shown = previous.index;
        self.window.set_title(&title(&self.scene));
        self.scene.skip_to(self.clock.now());
        self.show_message(message);
    }

    // The survey.

    fn is_surveying(&self) -> bool {
        self.survey.as_ref().is_some_and(Survey::is_running)
    }

    /// Starts a survey of the device. The clip stands still while nothing but it is to be measured.
    fn start_survey(&mut self, minutes: f64, event_loop: &ActiveEventLoop) {
        let Some(painter) = &self.painter else {
            return;
        };
        self.survey = Survey::start(SurveyStart {
            options: &self.options.gpu,
            painter,
            scene: &self.scene,
            trials: self.trials.as_ref(),
            last: self.survey.take(),
            minutes,
            folders: self.captures.folders().to_vec(),
            proxy: self.proxy.clone(),
        });
        self.play(false);
        #[cfg(not(target_os = "android"))]
        let _ = event_loop;
        #[cfg(target_os = "android")]
        {
            let activity = crate::android::activity(event_loop);
            self.screen_on = Some(crate::android::ScreenOn::new(activity));
        }
    }

    /// The survey's thread has told something, or has ended: then the window soaks.
    fn advance_survey(&mut self) {
        self.clock.invalidate();
        let Some(seconds) = self.survey.as_mut().and_then(Survey::receive) else {
            return;
        };
        let options = QualityControl {
            rate: None,
            governed: true,
            soak: Some(SoakOptions {
                seconds,
                out: None,
                bounds: SoakLimits::default(),
            }),
        };
        let rate = self.window.refresh_rate();
        self.quality = Some(QualityController::new(&options, rate));
        self.play(true);
    }

    /// Ends the survey, if one runs, and keeps what it has. `why`: of what is missing.
    fn end_survey(&mut self, why: &str) {
        let Some(survey) = self.survey.as_mut().filter(|survey| survey.is_running()) else {
            return;
        };
        let mut soak = None;
        if survey.is_soaking() {
            let own = self.options.quality_control.as_ref();
            let rate = self.window.refresh_rate();
            let own = own.map(|options| QualityController::new(options, rate));
            let soaked = std::mem::replace(&mut self.quality, own);
            soak = soaked.and_then(|mut quality| {
                let painter = self.painter.as_mut().filter(|_| quality.is_over());
                quality.result(&self.scene, painter)
            });
            if let Some(painter) = &mut self.painter
                && let Err(error) = painter.set_quality(&FrameQuality::FULL)
            {
                tracing::warn!("{error}");
            }
        }
        let message = survey.end(soak, why);
        println!("{message}");
        let was_playing = survey.was_playing;
        self.play(was_playing);
        self.show_message(message);
        #[cfg(target_os = "android")]
        {
            self.screen_on = None;
        }
    }

    /// Has the clip play or stand still.
    fn play(&mut self, play: bool) {
        if self.scene.playback().is_playing() != play {
            let now = self.clock.now();
            self.scene.act(Action::PlayOrPause, now, self.frame_size);
        }
    }

    /// Saves a soak's results while there is no window: the system may then end the program without
    /// notice.
    pub fn save_while_suspended(&mut self) {
        if self.window.is_suspended()
            && let Some(quality) = &mut self.quality
        {
            quality.save(&self.scene);
        }
    }

    /// Waits for files that are being written, and writes and prints measurements.
    ///
    /// # Errors
    /// If a soak has found faults, or its results can't be written.
    pub fn finish(mut self) -> anyhow::Result<()> {
        self.end_survey("the window was closed");
        let concluded = match &mut self.quality {
            Some(quality) => quality.conclude(&self.scene, None),
            None => Ok(()),
        };
        if let Some(trials) = &self.trials {
            trials.withdraw();
        }
        if let Some(painter) = &self.painter {
            self.captures.write_trace(painter.gpu());
        }
        self.painter = None;
        if let Some(survey) = self.survey.take() {
            survey.wait();
        }
        self.captures.finish();
        let frames = self.clock.frames();
        if let Some([median, p95]) = self.clock.durations_ms() {
            println!("{frames} frames: median {median:.2} ms, p95 {p95:.2} ms");
        }
        tracing::info!("drew {frames} frames in {:.1} s", self.clock.now());
        concluded
    }
}

/// The title of a window that shows a scene.
fn title(scene: &ViewerScene) -> String {
    format!("{} – Effigy", scene.avatar().name)
}

/// Closes the window. On Android, does what the system's back button does.
fn quit(event_loop: &ActiveEventLoop) {
    #[cfg(target_os = "android")]
    crate::android::back(crate::android::activity(event_loop));
    #[cfg(not(target_os = "android"))]
    event_loop.exit();
}
