//! Captures of frames by RenderDoc, through its in-application interface.
//!
//! RenderDoc is attached if its Vulkan layer has loaded its library into this process. The library
//! is never loaded from here: by then it would have missed the device's creation.

use libloading::Library;
use std::{
    ffi::{CStr, c_char, c_int, c_void},
    path::PathBuf,
    ptr,
};

/// Name of the library, by which it is found among those loaded.
#[cfg(windows)]
const LIBRARY: &str = "renderdoc.dll";
#[cfg(target_os = "android")]
const LIBRARY: &str = "libVkLayer_GLES_RenderDoc.so";
#[cfg(not(any(windows, target_os = "android")))]
const LIBRARY: &str = "librenderdoc.so";

/// Version 1.0.0 of the interface: major · 10000 + minor · 100 + patch.
const VERSION: c_int = 10_000;

/// The interface's function table. Functions that are not called here are untyped.
#[repr(C)]
struct ApiTable {
    /// Version, options, keys, overlay, hooks and crash handler.
    unused_first: [*const c_void; 11],
    set_path: unsafe extern "C" fn(*const c_char),
    get_path: *const c_void,
    count: unsafe extern "C" fn() -> u32,
    capture: unsafe extern "C" fn(u32, *mut c_char, *mut u32, *mut u64) -> u32,
    trigger: unsafe extern "C" fn(),
    /// Connection to its window, launching that, and choice of the window to capture.
    unused_window: [*const c_void; 3],
    start: unsafe extern "C" fn(*mut c_void, *mut c_void),
    capturing: *const c_void,
    end: unsafe extern "C" fn(*mut c_void, *mut c_void) -> u32,
}

/// RenderDoc in this process.
pub struct RenderDoc {
    table: ptr::NonNull<ApiTable>,
    _library: Library,
}

// SAFETY: the table is the library's own and never changes; its functions may be called on any
// thread.
unsafe impl Send for RenderDoc {}

/// A handle to a library that this process has loaded already.
fn loaded(name: &str) -> Option<Library> {
    #[cfg(unix)]
    {
        use libloading::os::unix::{Library, RTLD_LOCAL, RTLD_NOW};
        /// RTLD_NOLOAD: opens only a library that is loaded already.
        const NO_LOAD: c_int = if cfg!(any(target_os = "macos", target_os = "ios")) {
            0x10
        } else {
            0x4
        };
        // SAFETY: nothing is loaded, so no initialiser runs.
        unsafe { Library::open(Some(name), RTLD_NOW | RTLD_LOCAL | NO_LOAD) }
            .ok()
            .map(Into::into)
    }
    #[cfg(windows)]
    {
        libloading::os::windows::Library::open_already_loaded(name)
            .ok()
            .map(Into::into)
    }
    #[cfg(not(any(unix, windows)))]
    {
        let _ = name;
        None
    }
}

impl RenderDoc {
    /// RenderDoc's interface. None if it is not attached. Call this after opening a device: the
    /// device's layer loads RenderDoc.
    pub fn attached() -> Option<Self> {
        Self::in_library(LIBRARY)
    }

    /// RenderDoc's interface in a library of another name. None if that library is not loaded or
    /// has no such interface.
    pub fn in_library(library: &str) -> Option<Self> {
        let library = loaded(library)?;
        let mut table: *mut c_void = ptr::null_mut();
        // SAFETY: the type is that of renderdoc_app.h; the function writes the table's address or
        // leaves it.
        let found = unsafe {
            let get = library
                .get::<unsafe extern "C" fn(c_int, *mut *mut c_void) -> c_int>(
                    c"RENDERDOC_GetAPI".to_bytes_with_nul(),
                )
                .ok()?;
            get(VERSION, &mut table)
        };
        let table = ptr::NonNull::new(table.cast()).filter(|_| found == 1)?;
        Some(Self {
            table,
            _library: library,
        })
    }

    fn table(&self) -> &ApiTable {
        // SAFETY: `self` holds the library, and the table lives as long as it is loaded.
        unsafe { self.table.as_ref() }
    }

    /// Sets the prefix of the paths that captures are written to from now on.
    pub fn set_path(&self, prefix: &CStr) {
        // SAFETY: the string outlives the call, which copies it.
        unsafe { (self.table().set_path)(prefix.as_ptr()) };
    }

    /// Captures the next frame of a window, from one presentation to the next.
    pub fn trigger(&self) {
        // SAFETY: the function has no arguments.
        unsafe { (self.table().trigger)() };
    }

    /// Captures everything that is submitted during `call`. Returns its result and the path of the
    /// capture, None if RenderDoc wrote none.
    ///
    /// # Errors
    /// Those of `call`.
    pub fn capture_call<T, E>(
        &self,
        call: impl FnOnce() -> Result<T, E>,
    ) -> Result<(T, Option<PathBuf>), E> {
        let before = self.count();
        // SAFETY: null stands for the only device and window.
        unsafe { (self.table().start)(ptr::null_mut(), ptr::null_mut()) };
        let result = call();
        // SAFETY: null stands for the only device and window, and a capture was started above.
        let ended = unsafe { (self.table().end)(ptr::null_mut(), ptr::null_mut()) } == 1;
        let result = result?;
        let count = self.count();
        let path = if ended && count > before {
            self.file(count - 1)
        } else {
            None
        };
        Ok((result, path))
    }

    /// How many captures this process has written.
    fn count(&self) -> u32 {
        // SAFETY: the function has no arguments.
        unsafe { (self.table().count)() }
    }

    /// The path of a capture.
    fn file(&self, number: u32) -> Option<PathBuf> {
        let mut length = 0;
        // SAFETY: with null the function returns the length, including the terminating zero; then
        // it fills a buffer of more than that length.
        let text = unsafe {
            if (self.table().capture)(number, ptr::null_mut(), &mut length, ptr::null_mut()) == 0 {
                return None;
            }
            let mut text = vec![0u8; length as usize + 1];
            (self.table().capture)(
                number,
                text.as_mut_ptr().cast(),
                &mut length,
                ptr::null_mut(),
            );
            text
        };
        CStr::from_bytes_until_nul(&text)
            .ok()
            .map(|path| PathBuf::from(path.to_string_lossy().into_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_library_that_is_not_loaded_is_not_attached() {
        assert!(RenderDoc::in_library("libno-such-library.so").is_none());
        // The C library is in every process and is not RenderDoc.
        #[cfg(target_os = "linux")]
        assert!(loaded("libc.so.6").is_some() && RenderDoc::in_library("libc.so.6").is_none());
    }
}
