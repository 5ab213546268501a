//! Sections for Android's tracer, from the system's native library: loaded at run time, since each
//! function came with another version of the system. Where there is none, on older systems and on
//! others than Android, nothing opens. Sections are there from API 23 on.

#[cfg(feature = "window")]
use libloading::Library;
use std::ffi::CStr;
#[cfg(feature = "window")]
use std::{ffi::c_char, sync::OnceLock};

#[cfg(feature = "window")]
/// The system's library.
pub const LIBRARY: &str = "libandroid.so";

#[cfg(feature = "window")]
/// Opens the system's library, or one that stands in for it.
pub fn load(name: &str) -> Option<Library> {
    // SAFETY: the system's own library, which every app has open already; its initialisers have
    // run.
    unsafe { Library::new(name) }.ok()
}

#[cfg(feature = "window")]
/// A function of the library.
///
/// # Safety
/// `F` must be its type.
pub unsafe fn function<F: Copy>(library: &Library, name: &CStr) -> Option<F> {
    // SAFETY: the caller promises the type.
    unsafe { library.get::<F>(name.to_bytes_with_nul()) }
        .ok()
        .map(|symbol| *symbol)
}

#[cfg(feature = "window")]
type IsEnabled = unsafe extern "C" fn() -> bool;
#[cfg(feature = "window")]
type Begin = unsafe extern "C" fn(*const c_char);
#[cfg(feature = "window")]
type End = unsafe extern "C" fn();

#[cfg(feature = "window")]
/// A section of this thread's time, until it is dropped, for the system's tracer where someone
/// traces.
pub fn section(name: &CStr) -> Section {
    static SECTIONS: OnceLock<Option<Sections>> = OnceLock::new();
    let sections = SECTIONS.get_or_init(Sections::open).as_ref();
    Section(sections.filter(|sections| sections.begin(name)))
}

/// Nothing, without a window.
#[cfg(not(feature = "window"))]
pub fn section(_: &CStr) -> Section {
    Section()
}

/// See [`section`].
pub struct Section(#[cfg(feature = "window")] Option<&'static Sections>);

#[cfg(feature = "window")]
impl Drop for Section {
    fn drop(&mut self) {
        if let Some(sections) = self.0 {
            sections.end();
        }
    }
}

#[cfg(feature = "window")]
/// `ATrace`: sections that the system's tracer, Perfetto, shows on the thread that begins and ends
/// them.
pub struct Sections {
    enabled: IsEnabled,
    begin: Begin,
    end: End,
    _library: Library,
}

#[cfg(feature = "window")]
impl Sections {
    /// None where the system has no such thing.
    pub fn open() -> Option<Self> {
        Self::of(LIBRARY)
    }

    /// Opens it from a library by name, for tests with a stand-in.
    pub fn of(library: &str) -> Option<Self> {
        let library = load(library)?;
        // SAFETY: the types are those of the NDK's trace.h.
        unsafe {
            Some(Self {
                enabled: function(&library, c"ATrace_isEnabled")?,
                begin: function(&library, c"ATrace_beginSection")?,
                end: function(&library, c"ATrace_endSection")?,
                _library: library,
            })
        }
    }

    /// Begins a section, where someone traces. True where it has to be ended.
    pub fn begin(&self, name: &CStr) -> bool {
        // SAFETY: the name is a string that outlives the call.
        unsafe {
            let enabled = (self.enabled)();
            if enabled {
                (self.begin)(name.as_ptr());
            }
            enabled
        }
    }

    /// Ends the section that was begun last on this thread.
    pub fn end(&self) {
        // SAFETY: it takes nothing.
        unsafe { (self.end)() };
    }
}
