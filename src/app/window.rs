//! Opens a window on a display and passes its events to the viewer.

use crate::{
    file_list::LoadedAvatar, live::LiveAvatar, message::Message, options::ViewerOptions,
    viewer::Viewer,
};
use anyhow::Context;
use effigy_core::avatar::{Avatar, Clip};
use std::time::Instant;
use winit::{
    application::ApplicationHandler,
    event::{StartCause, WindowEvent},
    event_loop::{ActiveEventLoop, ControlFlow, EventLoop},
    window::WindowId,
};

/// A display to open a window on.
pub struct Display(EventLoop<Message>);

impl Display {
    /// The display of an Android activity.
    #[cfg(target_os = "android")]
    pub fn of_activity(
        app: &winit::platform::android::activity::AndroidApp,
    ) -> anyhow::Result<Self> {
        use winit::platform::android::EventLoopBuilderExtAndroid;
        let event_loop = EventLoop::with_user_event()
            .with_android_app(app.clone())
            .build()
            .context("the activity's events can't be received")?;
        Ok(Self(event_loop))
    }

    /// The desktop's display.
    ///
    /// # Errors
    /// If there is none: no desktop, or a session in a terminal only.
    #[cfg(not(target_os = "android"))]
    pub fn open() -> anyhow::Result<Self> {
        let event_loop = EventLoop::with_user_event().build().map_err(|error| {
            tracing::debug!("{error}");
            anyhow::anyhow!("there is no display to open a window on")
        })?;
        Ok(Self(event_loop))
    }

    /// The way to the window for newer states of the avatar that it will show.
    pub fn live(&self) -> LiveAvatar {
        LiveAvatar::new(self.0.create_proxy())
    }

    /// Shows an avatar until its window is closed.
    ///
    /// # Errors
    /// If no device can draw it, a device is lost for good, or a soak has found faults.
    pub fn show(
        self,
        avatar: Avatar,
        clips: Vec<Clip>,
        options: ViewerOptions,
    ) -> anyhow::Result<()> {
        let first = options.first;
        let loaded = LoadedAvatar { avatar, clips };
        let mut viewer = Viewer::new(loaded, options, self.0.create_proxy());
        if let Some(index) = first {
            viewer.request_avatar(index);
        }
        let mut handler = Handler {
            viewer,
            failed: None,
        };
        self.0
            .run_app(&mut handler)
            .context("the display's connection ended")?;
        let finished = handler.viewer.finish();
        match handler.failed {
            Some(error) => Err(error),
            None => finished,
        }
    }
}

/// Passes events to the viewer until it fails.
struct Handler {
    viewer: Viewer,
    /// The first error, which [`Display::show`] returns.
    failed: Option<anyhow::Error>,
}

impl Handler {
    /// Ends the program on an error.
    fn check(&mut self, result: anyhow::Result<()>, event_loop: &ActiveEventLoop) {
        if let Err(error) = result {
            self.failed.get_or_insert(error);
            event_loop.exit();
        }
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
        self.viewer.free_memory();
    }

    fn new_events(&mut self, event_loop: &ActiveEventLoop, _: StartCause) {
        self.viewer.wake(event_loop);
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, message: Message) {
        let received = self.viewer.receive(event_loop, message);
        self.check(received, event_loop);
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        if !self.viewer.is_open() {
            return;
        }
        let consumed = self.viewer.input(event_loop, &event);
        match event {
            WindowEvent::CloseRequested | WindowEvent::Destroyed => event_loop.exit(),
            WindowEvent::RedrawRequested => {
                let drawn = self.viewer.redraw(event_loop);
                self.check(drawn, event_loop);
            }
            WindowEvent::Resized(size) => self.viewer.resize(size.into()),
            WindowEvent::Occluded(occluded) => self.viewer.set_occluded(occluded),
            // The window is on another display, or its display is in another mode.
            WindowEvent::ScaleFactorChanged { .. } => self.viewer.update_refresh_rate(event_loop),
            WindowEvent::DroppedFile(path) => self.viewer.drop_file(path),
            WindowEvent::Focused(focused) => self.viewer.set_focused(focused),
            WindowEvent::ModifiersChanged(modifiers) => {
                self.viewer.set_modifiers(modifiers.state());
            }
            WindowEvent::KeyboardInput {
                event,
                is_synthetic: false,
                ..
            } if !consumed && event.state.is_pressed() => {
                self.viewer.key_pressed(event_loop, &event);
            }
            _ => {}
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        #[cfg(target_os = "android")]
        if self.viewer.is_suspended()
            && crate::android::is_destroyed(crate::android::activity(event_loop))
        {
            event_loop.exit();
        }
        self.viewer.save_while_suspended();
        // All files of one drop have come.
        self.viewer.open_dropped();
        event_loop.set_control_flow(match self.viewer.wake_at() {
            Some(wake) => ControlFlow::WaitUntil(wake.max(Instant::now())),
            None => ControlFlow::Wait,
        });
        self.viewer.request_redraw();
    }
}
