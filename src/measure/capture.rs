//! RenderDoc, where it is attached: asks it to capture frames, through the interface that it offers in the program itself.
//!
//! It is attached where its library is in the process already, since its Vulkan layer has loaded it. It is never loaded from here: that would
//! be too late to see what the device was made of.

use libloading::Library;
use std::{
    ffi::{CStr, c_char, c_int, c_void},
    path::PathBuf,
    ptr,
};

/// The library's name, by which it is found among those that are loaded.
#[cfg(windows)]
const LIBRARY: &str = "renderdoc.dll";
#[cfg(target_os = "android")]
const LIBRARY: &str = "libVkLayer_GLES_RenderDoc.so";
#[cfg(not(any(windows, target_os = "android")))]
const LIBRARY: &str = "librenderdoc.so";

/// Version 1.0.0 of the interface: major · 10000 + minor · 100 + patch.
const VERSION: c_int = 10_000;

/// How to attach it, in a sentence.
pub const ATTACH: &str = "RenderDoc is not attached: start the program from it (Launch Application in qrenderdoc, or `renderdoccmd capture \
                          effigy capture`), or set ENABLE_VULKAN_RENDERDOC_CAPTURE=1 where it is installed";

/// Functions of the interface in its order; those that are not called have no type here.
#[repr(C)]
struct Table {
    /// Version, options, keys, overlay, hooks and crash handler.
    before: [*const c_void; 11],
    set_path: unsafe extern "C" fn(*const c_char),
    get_path: *const c_void,
    count: unsafe extern "C" fn() -> u32,
    capture: unsafe extern "C" fn(u32, *mut c_char, *mut u32, *mut u64) -> u32,
    trigger: unsafe extern "C" fn(),
    /// Whether its window is connected, launching it, and which window is captured.
    window: [*const c_void; 3],
    start: unsafe extern "C" fn(*mut c_void, *mut c_void),
    capturing: *const c_void,
    end: unsafe extern "C" fn(*mut c_void, *mut c_void) -> u32,
}

/// RenderDoc in this process.
pub struct RenderDoc {
    table: ptr::NonNull<Table>,
    _library: Library,
}

// SAFETY: the table is the library's own and never changes; its functions may be called on any thread.
unsafe impl Send for RenderDoc {}

fn loaded(name: &str) -> Option<Library> {
    #[cfg(unix)]
    {
        use libloading::os::unix::{Library, RTLD_LOCAL, RTLD_NOW};
        /// Only what is loaded already.
        const NO_LOAD: c_int = if cfg!(any(target_os = "macos", target_os = "ios")) { 0x10 } else { 0x4 };
        // SAFETY: nothing is loaded, so no initialiser runs.
        unsafe { Library::open(Some(name), RTLD_NOW | RTLD_LOCAL | NO_LOAD) }.ok().map(Into::into)
    }
    #[cfg(windows)]
    {
        libloading::os::windows::Library::open_already_loaded(name).ok().map(Into::into)
    }
    #[cfg(not(any(unix, windows)))]
    {
        let _ = name;
        None
    }
}

impl RenderDoc {
    /// None where it is not attached. To be asked once a device is open, since the device's layer brings it.
    pub fn attached() -> Option<Self> {
        Self::of(LIBRARY)
    }

    /// The same of a library by another name, which must be loaded.
    pub fn of(library: &str) -> Option<Self> {
        let library = loaded(library)?;
        let mut table: *mut c_void = ptr::null_mut();
        // SAFETY: the type is that of renderdoc_app.h; it fills in the table's address or leaves it.
        let found = unsafe {
            let get =
                library.get::<unsafe extern "C" fn(c_int, *mut *mut c_void) -> c_int>(c"RENDERDOC_GetAPI".to_bytes_with_nul()).ok()?;
            get(VERSION, &mut table)
        };
        let table = ptr::NonNull::new(table.cast()).filter(|_| found == 1)?;
        Some(Self { table, _library: library })
    }

    fn table(&self) -> &Table {
        // SAFETY: the library is loaded, and the table lives as long as it.
        unsafe { self.table.as_ref() }
    }

    /// Where captures go from now on: the beginning of their files' names.
    pub fn set_path(&self, beginning: &CStr) {
        // SAFETY: the string outlives the call, which copies it.
        unsafe { (self.table().set_path)(beginning.as_ptr()) };
    }

    /// Captures the next frame that is shown in a window, from one presentation to the next.
    pub fn trigger(&self) {
        // SAFETY: it takes nothing.
        unsafe { (self.table().trigger)() };
    }

    /// Captures all that is submitted within a call. The file, where it became one.
    ///
    /// # Errors
    /// Those of the call.
    pub fn during<T, E>(&self, call: impl FnOnce() -> Result<T, E>) -> Result<(T, Option<PathBuf>), E> {
        let before = self.count();
        // SAFETY: null stands for the only device there is.
        unsafe { (self.table().start)(ptr::null_mut(), ptr::null_mut()) };
        let outcome = call();
        // SAFETY: as above; a capture was begun.
        let ended = unsafe { (self.table().end)(ptr::null_mut(), ptr::null_mut()) } == 1;
        let count = self.count();
        Ok((outcome?, (ended && count > before).then(|| self.file(count - 1)).flatten()))
    }

    fn count(&self) -> u32 {
        // SAFETY: it takes nothing.
        unsafe { (self.table().count)() }
    }

    fn file(&self, number: u32) -> Option<PathBuf> {
        let mut length = 0;
        // SAFETY: null asks for the length, the zero at the end included; a buffer of that length is then filled.
        let text = unsafe {
            if (self.table().capture)(number, ptr::null_mut(), &mut length, ptr::null_mut()) == 0 {
                return None;
            }
            let mut text = vec![0u8; length as usize + 1];
            (self.table().capture)(number, text.as_mut_ptr().cast(), &mut length, ptr::null_mut());
            text
        };
        CStr::from_bytes_until_nul(&text).ok().map(|path| PathBuf::from(path.to_string_lossy().into_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_loaded_is_not_attached() {
        assert!(RenderDoc::of("libno-such-library.so").is_none());
        // In every process of these tests, and not RenderDoc.
        #[cfg(target_os = "linux")]
        assert!(loaded("libc.so.6").is_some() && RenderDoc::of("libc.so.6").is_none());
    }
}
