//! The window's events: what winit reports goes in, gestures, wishes and frames of the viewer come out.

use super::{
    Message, Options,
    action::action,
    gesture::{Button, Gesture},
    viewer::Viewer,
};
use crate::avatar::{Avatar, Clip};
use anyhow::Context;
use glam::DVec2;
use std::time::{Duration, Instant};
use winit::{
    application::ApplicationHandler,
    event::{ElementState, MouseButton, MouseScrollDelta, StartCause, Touch, TouchPhase, WindowEvent},
    event_loop::{ActiveEventLoop, ControlFlow, EventLoop},
    window::WindowId,
};

/// A display to open windows on.
pub struct Display(EventLoop<Message>);

impl Display {
    /// A phone's: its windows come from the activity.
    #[cfg(target_os = "android")]
    pub(super) fn of(app: &winit::platform::android::activity::AndroidApp) -> anyhow::Result<Self> {
        use winit::platform::android::EventLoopBuilderExtAndroid;
        let event_loop = EventLoop::with_user_event().with_android_app(app.clone()).build();
        Ok(Self(event_loop.context("the activity can't be listened to")?))
    }

    #[cfg(not(target_os = "android"))]
    /// Fails where there is none: no desktop, or a session over a terminal only.
    pub fn open() -> anyhow::Result<Self> {
        let event_loop = EventLoop::with_user_event().build().map_err(|error| {
            tracing::debug!("{error}");
            anyhow::anyhow!("there is no display to open a window on")
        })?;
        Ok(Self(event_loop))
    }

    /// Shows an avatar until its window is closed.
    pub fn show(self, avatar: Avatar, clips: Vec<Clip>, options: Options) -> anyhow::Result<()> {
        let first = options.first;
        let mut viewer = Viewer::new((avatar, clips), options, self.0.create_proxy());
        first.into_iter().for_each(|number| viewer.fetch(number));
        let mut handler = Handler { viewer, asked: Instant::now(), failed: None };
        self.0.run_app(&mut handler).context("the display's connection ended")?;
        let finished = handler.viewer.finish();
        handler.failed.map_or(finished, Err)
    }
}

/// How often to ask whether the window is minimised, since some systems do not tell. The answer may wait for the display server.
const ASK: Duration = Duration::from_secs(1);

struct Handler {
    viewer: Viewer,
    asked: Instant,
    failed: Option<anyhow::Error>,
}

impl Handler {
    /// Ends the program on an error, which [`Display::show`] then returns.
    fn check(&mut self, result: anyhow::Result<()>, event_loop: &ActiveEventLoop) {
        if let Err(error) = result {
            self.failed.get_or_insert(error);
            event_loop.exit();
        }
    }

    /// Whether a touch makes a double tap. `taken`: it is the panel's.
    fn tap(&mut self, touch: &Touch, taken: bool) -> bool {
        let (at, clock) = (DVec2::new(touch.location.x, touch.location.y), self.viewer.clock());
        let scale = self.viewer.window.as_ref().map_or(1.0, |window| window.scale_factor());
        let taps = &mut self.viewer.taps;
        match touch.phase {
            TouchPhase::Started if !taken => taps.finger_down(touch.id, at, clock),
            TouchPhase::Started => taps.cancel(),
            TouchPhase::Moved => taps.finger_moved(touch.id, at, scale),
            TouchPhase::Ended => return taps.finger_up(touch.id, clock, scale),
            TouchPhase::Cancelled => taps.forget(),
        }
        false
    }

    /// Events that turn, move and zoom.
    fn pointer(&mut self, event: &WindowEvent, taken: bool) -> Option<Gesture> {
        let shift = self.viewer.modifiers.shift_key();
        let pointers = &mut self.viewer.pointers;
        match event {
            WindowEvent::CursorMoved { position, .. } => return Some(pointers.moved(DVec2::new(position.x, position.y), shift)),
            WindowEvent::MouseInput { state, button, .. } => {
                let button = match button {
                    MouseButton::Left => Button::Left,
                    MouseButton::Middle => Button::Middle,
                    MouseButton::Right => Button::Right,
                    _ => return None,
                };
                match state {
                    ElementState::Pressed if !taken => pointers.press(button),
                    ElementState::Pressed => {}
                    ElementState::Released => pointers.release(button),
                }
            }
            WindowEvent::MouseWheel { delta, .. } if !taken => {
                return Some(match delta {
                    MouseScrollDelta::LineDelta(_, lines) => pointers.wheel(f64::from(*lines)),
                    MouseScrollDelta::PixelDelta(by) => pointers.scroll(DVec2::new(by.x, by.y), shift),
                });
            }
            WindowEvent::PinchGesture { delta, .. } if !taken => return Some(pointers.pinch(*delta)),
            WindowEvent::Touch(Touch { phase, location, id, .. }) => {
                let at = DVec2::new(location.x, location.y);
                match phase {
                    TouchPhase::Started if !taken => pointers.finger_down(*id, at),
                    TouchPhase::Started => {}
                    TouchPhase::Moved => return Some(pointers.finger_moved(*id, at)),
                    TouchPhase::Ended | TouchPhase::Cancelled => pointers.finger_up(*id),
                }
            }
            _ => {}
        }
        None
    }
}

impl ApplicationHandler<Message> for Handler {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        let opened = self.viewer.open(event_loop);
        self.check(opened, event_loop);
    }

    fn suspended(&mut self, _: &ActiveEventLoop) {
        self.viewer.suspend();
    }

    fn memory_warning(&mut self, _: &ActiveEventLoop) {
        self.viewer.save_memory();
    }

    fn new_events(&mut self, event_loop: &ActiveEventLoop, _: StartCause) {
        if self.viewer.wake.take_if(|wake| *wake <= Instant::now()).is_some() {
            self.viewer.dirty = true;
        }
        if self.viewer.taps.held(self.viewer.clock()) {
            self.viewer.tapped(event_loop, false);
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, message: Message) {
        let heard = self.viewer.hear(message);
        self.check(heard, event_loop);
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let (Some(window), Some(overlay)) = (&self.viewer.window, &mut self.viewer.overlay) else { return };
        let panel = overlay.event(window, &event);
        self.viewer.dirty |= panel.changed;
        if let WindowEvent::Touch(touch) = &event
            && self.tap(touch, panel.taken)
        {
            self.viewer.tapped(event_loop, true);
        }
        if let Some(gesture) = self.pointer(&event, panel.taken) {
            self.viewer.gesture(&gesture);
        }
        match event {
            WindowEvent::CloseRequested | WindowEvent::Destroyed => event_loop.exit(),
            WindowEvent::RedrawRequested => {
                // Without a wish of ours the system asks: what it showed of the window is gone.
                self.viewer.dirty |= !self.viewer.wants_frame();
                self.viewer.hidden = false;
                let drawn = self.viewer.frame(event_loop);
                self.check(drawn, event_loop);
            }
            WindowEvent::Resized(size) => {
                self.viewer.window_size = size.into();
                self.viewer.hidden = false;
                self.viewer.dirty = true;
            }
            WindowEvent::Occluded(hidden) => {
                self.viewer.hidden = hidden;
                self.viewer.resting |= hidden;
                self.viewer.dirty |= !hidden;
            }
            // Another display, or this one in another mode.
            WindowEvent::ScaleFactorChanged { .. } => self.viewer.see_display(event_loop),
            WindowEvent::Focused(true) => self.viewer.hidden = false,
            WindowEvent::ModifiersChanged(modifiers) => self.viewer.modifiers = modifiers.state(),
            WindowEvent::Focused(false) => {
                self.viewer.pointers.cancel();
                self.viewer.taps.forget();
                if let Some(overlay) = &mut self.viewer.overlay {
                    overlay.release();
                }
            }
            WindowEvent::KeyboardInput { event, is_synthetic: false, .. } if !panel.taken && event.state.is_pressed() => {
                let (shift, repeat) = (self.viewer.modifiers.shift_key(), self.viewer.scene.playback().repeat());
                if let Some(action) = action(&event.logical_key, shift, event.repeat, repeat) {
                    self.viewer.act(action, event_loop);
                }
            }
            _ => {}
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        #[cfg(target_os = "android")]
        if self.viewer.suspended && super::android::is_destroyed(super::viewer::app(event_loop)) {
            event_loop.exit();
        }
        self.viewer.keep_books();
        event_loop.set_control_flow(match self.viewer.wake_at() {
            Some(wake) => ControlFlow::WaitUntil(wake.max(Instant::now())),
            None => ControlFlow::Wait,
        });
        let Some(window) = self.viewer.window.as_ref().filter(|_| self.viewer.wants_frame()) else { return };
        if self.asked.elapsed() > ASK {
            self.asked = Instant::now();
            self.viewer.hidden = window.is_minimized() == Some(true);
        }
        if !self.viewer.hidden {
            window.request_redraw();
        }
    }
}
