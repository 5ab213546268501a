//! The system's window: whether there is one, whether it is visible, its size and its display's
//! refresh rate.

use anyhow::Context;
use std::{
    sync::Arc,
    time::{Duration, Instant},
};
use winit::{
    dpi::PhysicalSize,
    event_loop::ActiveEventLoop,
    window::{Fullscreen, Window},
};

/// How often to ask whether the window is minimised: some systems do not report it, and the answer
/// may wait for the display server.
const MINIMIZED_CHECK: Duration = Duration::from_secs(1);

/// Whether the window can be drawn to, by the system's events.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WindowState {
    /// It has not been opened yet.
    Unopened,
    /// The system has taken it away for a while.
    Suspended,
    /// It has no area, or none of it is visible.
    Hidden,
    /// It can be drawn to.
    Visible,
}

/// The window that the viewer draws in.
pub struct HostWindow {
    window: Option<Arc<Window>>,
    state: WindowState,
    /// px, by the window's events: asking for it would wait for the display server, and fails once
    /// the window is gone.
    size: [u32; 2],
    /// Of the display, Hz, if known.
    refresh_rate: Option<f64>,
    last_minimized_check: Instant,
}

impl HostWindow {
    /// A window that has not been opened yet. `size`: px.
    pub fn new(size: [u32; 2]) -> Self {
        Self {
            window: None,
            state: WindowState::Unopened,
            size,
            refresh_rate: None,
            last_minimized_check: Instant::now(),
        }
    }

    /// The system has a window for the viewer, for the first time or again. Creates it if needed,
    /// with its initial size in px.
    pub fn open(
        &mut self,
        event_loop: &ActiveEventLoop,
        title: String,
        initial_size: [u32; 2],
        full_screen: bool,
    ) -> anyhow::Result<Arc<Window>> {
        self.state = WindowState::Visible;
        let window = match &self.window {
            Some(window) => window.clone(),
            None => {
                let [width, height] = initial_size;
                let attributes = Window::default_attributes()
                    .with_title(title)
                    .with_inner_size(PhysicalSize::new(width, height))
                    .with_fullscreen(full_screen.then_some(Fullscreen::Borderless(None)));
                let window = event_loop
                    .create_window(attributes)
                    .context("the window could not be opened")?;
                Arc::new(window)
            }
        };
        self.size = window.inner_size().into();
        self.window = Some(window.clone());
        Ok(window)
    }

    /// The window, once it was opened.
    pub fn get(&self) -> Option<&Arc<Window>> {
        self.window.as_ref()
    }

    /// Names the window, if there is one.
    pub fn set_title(&self, title: &str) {
        if let Some(window) = &self.window {
            window.set_title(title);
        }
    }

    /// Width and height, px.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Px a point.
    pub fn scale(&self) -> f64 {
        self.window
            .as_ref()
            .map_or(1.0, |window| window.scale_factor())
    }

    /// The window has a new size, px. It is visible again.
    pub fn resize(&mut self, size: [u32; 2]) {
        self.size = size;
        self.set_hidden(false);
    }

    /// Asks the window for its size. While an Android activity is paused, events that report it
    /// are lost.
    pub fn update_size(&mut self) {
        if let Some(window) = &self.window {
            self.size = window.inner_size().into();
        }
    }

    /// Hides or shows the window, if there is one.
    pub fn set_hidden(&mut self, hidden: bool) {
        if matches!(self.state, WindowState::Hidden | WindowState::Visible) {
            self.state = if hidden {
                WindowState::Hidden
            } else {
                WindowState::Visible
            };
        }
    }

    /// The system takes the window away.
    pub fn suspend(&mut self) {
        self.state = WindowState::Suspended;
    }

    /// Whether there is no window to draw to: it is not open yet, or the system has taken it away.
    pub fn is_suspended(&self) -> bool {
        matches!(self.state, WindowState::Unopened | WindowState::Suspended)
    }

    /// Whether the window can be drawn to and is visible.
    pub fn is_visible(&self) -> bool {
        self.state == WindowState::Visible
    }

    /// Hides a window that is minimised. It asks at most once a second.
    pub fn check_minimized(&mut self) {
        if self.last_minimized_check.elapsed() <= MINIMIZED_CHECK {
            return;
        }
        self.last_minimized_check = Instant::now();
        if let Some(window) = &self.window {
            let is_minimized = window.is_minimized() == Some(true);
            self.set_hidden(is_minimized);
        }
    }

    /// Enters or leaves full screen.
    pub fn toggle_full_screen(&self) {
        if let Some(window) = &self.window {
            let is_full = window.fullscreen().is_some();
            window.set_fullscreen((!is_full).then_some(Fullscreen::Borderless(None)));
        }
    }

    /// Leaves full screen. Returns false if the window is not in it.
    pub fn leave_full_screen(&self) -> bool {
        let Some(window) = &self.window else {
            return false;
        };
        let is_full = window.fullscreen().is_some();
        if is_full {
            window.set_fullscreen(None);
        }
        is_full
    }

    /// The display's refresh rate, Hz, if known.
    pub fn refresh_rate(&self) -> Option<f64> {
        self.refresh_rate
    }

    /// Asks for the display's refresh rate.
    #[cfg(not(target_os = "android"))]
    pub fn update_refresh_rate(&mut self, event_loop: &ActiveEventLoop) {
        self.refresh_rate = self.window.as_ref().and_then(|window| {
            let monitor = window
                .current_monitor()
                .or_else(|| event_loop.primary_monitor())?;
            Some(f64::from(monitor.refresh_rate_millihertz()?) / 1e3)
        });
    }

    /// Asks for the display's refresh rate. `present_rate`: the rate at which the display itself
    /// reports its refreshes, Hz, if it does.
    #[cfg(target_os = "android")]
    pub fn update_refresh_rate(&mut self, event_loop: &ActiveEventLoop, present_rate: Option<f64>) {
        let system_rate = crate::android::refresh_rate(crate::android::activity(event_loop));
        self.refresh_rate = match (system_rate, present_rate) {
            (Some(system), Some(present)) => Some(system.min(present)),
            (system, present) => system.or(present),
        };
    }
}
