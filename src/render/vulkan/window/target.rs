//! The native handles of a window, from which surfaces are made.

use crate::vulkan::device::error::{During, Result};
use raw_window_handle::{DisplayHandle, RawDisplayHandle, RawWindowHandle, WindowHandle};
use std::ffi::CStr;

/// The native handles of a window, which must outlive it.
#[derive(Clone)]
pub struct NativeWindow {
    pub(crate) display: RawDisplayHandle,
    pub(crate) window: RawWindowHandle,
    /// Keeps what `display` points to.
    #[cfg(target_os = "linux")]
    _connection: Option<std::sync::Arc<xcb::Connection>>,
}

impl NativeWindow {
    /// The handles of a window. On X11 drivers get a connection of their own, since they read from
    /// it on their own threads: they would take key presses out of the socket that the event loop
    /// sleeps on, and leave them in a queue until the next event.
    ///
    /// # Safety
    /// Display and window must outlive it, its clones, and the surfaces that are made of them.
    #[cfg(target_os = "linux")]
    pub unsafe fn new(display: DisplayHandle, window: WindowHandle) -> Self {
        let given = Self {
            display: display.as_raw(),
            window: window.as_raw(),
            _connection: None,
        };
        given.apart().unwrap_or(given)
    }

    /// The handles of a window.
    ///
    /// # Safety
    /// Display and window must outlive it, its clones, and the surfaces that are made of them.
    #[cfg(not(target_os = "linux"))]
    pub unsafe fn new(display: DisplayHandle, window: WindowHandle) -> Self {
        Self {
            display: display.as_raw(),
            window: window.as_raw(),
        }
    }

    /// This X11 window on another connection. Returns `None` if the window is not X11 or no
    /// connection opens.
    #[cfg(target_os = "linux")]
    fn apart(&self) -> Option<Self> {
        use raw_window_handle::{XcbDisplayHandle, XcbWindowHandle};
        let (RawDisplayHandle::Xlib(display), RawWindowHandle::Xlib(window)) =
            (self.display, self.window)
        else {
            return None;
        };
        let window = std::num::NonZeroU32::new(u32::try_from(window.window).ok()?)?;
        let connection = xcb::Connection::open()?;
        Some(Self {
            display: XcbDisplayHandle::new(Some(connection.raw()), display.screen).into(),
            window: XcbWindowHandle::new(window).into(),
            _connection: Some(std::sync::Arc::new(connection)),
        })
    }

    /// The instance extensions that its surface needs.
    pub fn extensions(&self) -> Result<Vec<&'static CStr>> {
        let names =
            ash_window::enumerate_required_extensions(self.display).during("vkCreateSurface")?;
        // SAFETY: the names are constants, zero-terminated, of the library that lists them.
        let name = |&name: &_| unsafe { CStr::from_ptr(name) };
        Ok(names.iter().map(name).collect())
    }
}

#[cfg(target_os = "linux")]
mod xcb {
    use libloading::{Library, Symbol};
    use std::{
        ffi::{c_char, c_int, c_void},
        ptr::{NonNull, null, null_mut},
    };

    /// A connection to the X server of `DISPLAY`.
    pub struct Connection {
        raw: NonNull<c_void>,
        library: Library,
    }

    // SAFETY: libxcb's connections may be used by any thread.
    unsafe impl Send for Connection {}
    // SAFETY: libxcb's connections may be used by several threads at once.
    unsafe impl Sync for Connection {}

    impl Connection {
        /// None where there is no libxcb, or no server that takes another client.
        pub fn open() -> Option<Self> {
            // SAFETY: these are the names, types and duties of libxcb's public functions; a failed
            // connection has to be closed too.
            unsafe {
                let library = Library::new("libxcb.so.1").ok()?;
                let connect: Symbol<
                    unsafe extern "C" fn(*const c_char, *mut c_int) -> *mut c_void,
                > = library.get(b"xcb_connect\0").ok()?;
                let has_error: Symbol<unsafe extern "C" fn(*mut c_void) -> c_int> =
                    library.get(b"xcb_connection_has_error\0").ok()?;
                let raw = NonNull::new(connect(null(), null_mut()))?;
                let failed = has_error(raw.as_ptr()) != 0;
                let connection = Self { raw, library };
                (!failed).then_some(connection)
            }
        }

        pub fn raw(&self) -> NonNull<c_void> {
            self.raw
        }
    }

    impl Drop for Connection {
        fn drop(&mut self) {
            // SAFETY: this is the name and type of libxcb's function. Surfaces hold the connection
            // that they were made of, so that none is left.
            unsafe {
                if let Ok(disconnect) = self
                    .library
                    .get::<unsafe extern "C" fn(*mut c_void)>(b"xcb_disconnect\0")
                {
                    disconnect(self.raw.as_ptr());
                }
            }
        }
    }
}
