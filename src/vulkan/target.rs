//! A window as drivers know it.

use super::error::{During, Result};
use raw_window_handle::{DisplayHandle, RawDisplayHandle, RawWindowHandle, WindowHandle};

/// A window as drivers know it. The window must outlive it.
#[derive(Clone, Copy)]
pub struct Target {
    pub(super) display: RawDisplayHandle,
    pub(super) window: RawWindowHandle,
}

impl Target {
    pub fn new(display: DisplayHandle, window: WindowHandle) -> Self {
        Self { display: display.as_raw(), window: window.as_raw() }
    }

    /// The other name of a window of X11, which is the only one that some drivers know. None where there is no other.
    #[cfg(target_os = "linux")]
    pub fn through_xcb(&self) -> Option<Self> {
        use raw_window_handle::{XcbDisplayHandle, XcbWindowHandle};
        let (RawDisplayHandle::Xlib(display), RawWindowHandle::Xlib(window)) = (self.display, self.window) else { return None };
        let library = x11_dl::xlib_xcb::Xlib_xcb::open().ok()?;
        // SAFETY: the display is open while its window lives, and its connection as long as the display.
        let connection = unsafe { (library.XGetXCBConnection)(display.display?.as_ptr().cast()) };
        let window = std::num::NonZeroU32::new(u32::try_from(window.window).ok()?)?;
        let display = XcbDisplayHandle::new(Some(std::ptr::NonNull::new(connection)?), display.screen);
        Some(Self { display: display.into(), window: XcbWindowHandle::new(window).into() })
    }

    #[cfg(not(target_os = "linux"))]
    pub fn through_xcb(&self) -> Option<Self> {
        None
    }

    /// The instance extensions that its surface needs.
    pub fn extensions(&self) -> Result<Vec<*const std::ffi::c_char>> {
        ash_window::enumerate_required_extensions(self.display).map(<[_]>::to_vec).during("vkCreateSurface")
    }
}
