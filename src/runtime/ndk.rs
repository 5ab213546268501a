//! What Android tells and is told about heat and work, in its native library: loaded at run time,
//! since each function came with another version of the system. Where there is none, on older
//! systems and on others than Android, nothing opens.
//!
//! Thermal headroom is there from API 31 on, hint sessions from 33.

use effigy_render::ndk::{LIBRARY, function, load};
use libloading::Library;
use std::{
    ffi::{c_int, c_void},
    ptr::NonNull,
    time::Duration,
};

type Headroom = unsafe extern "C" fn(*mut c_void, c_int) -> f32;
type Acquire = unsafe extern "C" fn() -> *mut c_void;
type Release = unsafe extern "C" fn(*mut c_void);

/// `AThermal`: how near the system is to taking clocks away.
pub struct Thermal {
    manager: NonNull<c_void>,
    headroom: Headroom,
    release: Release,
    _library: Library,
}

// SAFETY: the manager may be used on any thread, by one at a time.
unsafe impl Send for Thermal {}

impl Thermal {
    /// None where the system has no such thing.
    pub fn open() -> Option<Self> {
        Self::of(LIBRARY)
    }

    /// Opens it from a library by name, for tests with a stand-in.
    pub fn of(library: &str) -> Option<Self> {
        let library = load(library)?;
        // SAFETY: the types are those of the NDK's thermal.h.
        let (acquire, release, headroom): (Acquire, Release, Headroom) = unsafe {
            (
                function(&library, c"AThermal_acquireManager")?,
                function(&library, c"AThermal_releaseManager")?,
                function(&library, c"AThermal_getThermalHeadroom")?,
            )
        };
        // SAFETY: it takes nothing.
        let manager = NonNull::new(unsafe { acquire() })?;
        Some(Self {
            manager,
            headroom,
            release,
            _library: library,
        })
    }

    /// Headroom used up in so many seconds from now: 1 is where severe throttling begins. None
    /// where the device can't tell, or was asked less than a second ago.
    pub fn headroom(&self, ahead: i32) -> Option<f64> {
        // SAFETY: the manager is alive.
        let headroom = unsafe { (self.headroom)(self.manager.as_ptr(), ahead) };
        Some(f64::from(headroom)).filter(|headroom| headroom.is_finite() && *headroom >= 0.0)
    }
}

impl Drop for Thermal {
    fn drop(&mut self) {
        // SAFETY: the manager is alive, and not used after this.
        unsafe { (self.release)(self.manager.as_ptr()) };
    }
}

type CreateSession = unsafe extern "C" fn(*mut c_void, *const i32, usize, i64) -> *mut c_void;
type Tell = unsafe extern "C" fn(*mut c_void, i64) -> c_int;

/// A performance hint session: the system learns how long frames take and may take, and sets clocks
/// by it.
pub struct Hints {
    session: NonNull<c_void>,
    target: Tell,
    actual: Tell,
    close: Release,
    _library: Library,
}

// SAFETY: the session may be used on any thread, by one at a time.
unsafe impl Send for Hints {}

impl Hints {
    /// For the threads that make frames, by their system's numbers, and the time that a frame may
    /// take. None where there is no such thing.
    pub fn open(threads: &[i32], frame: Duration) -> Option<Self> {
        Self::of(LIBRARY, threads, frame)
    }

    /// Opens a session, see [`Self::open`], from a library by name, for tests with a stand-in.
    pub fn of(library: &str, threads: &[i32], frame: Duration) -> Option<Self> {
        let library = load(library)?;
        // SAFETY: the types are those of the NDK's performance_hint.h.
        let (manager, create, target, actual, close): (
            Acquire,
            CreateSession,
            Tell,
            Tell,
            Release,
        ) = unsafe {
            (
                function(&library, c"APerformanceHint_getManager")?,
                function(&library, c"APerformanceHint_createSession")?,
                function(&library, c"APerformanceHint_updateTargetWorkDuration")?,
                function(&library, c"APerformanceHint_reportActualWorkDuration")?,
                function(&library, c"APerformanceHint_closeSession")?,
            )
        };
        // SAFETY: the manager is the process's own; the threads are as many as is said.
        let session = unsafe {
            let manager = NonNull::new(manager())?;
            create(
                manager.as_ptr(),
                threads.as_ptr(),
                threads.len(),
                nanoseconds(frame),
            )
        };
        Some(Self {
            session: NonNull::new(session)?,
            target,
            actual,
            close,
            _library: library,
        })
    }

    /// Frames may take this long from now on.
    pub fn set_frame(&self, frame: Duration) {
        // SAFETY: the session is alive. A hint that is not taken costs nothing.
        unsafe { (self.target)(self.session.as_ptr(), nanoseconds(frame)) };
    }

    /// A frame took this long.
    pub fn took(&self, busy: Duration) {
        // SAFETY: as above; the system refuses zero.
        unsafe { (self.actual)(self.session.as_ptr(), nanoseconds(busy).max(1)) };
    }
}

impl Drop for Hints {
    fn drop(&mut self) {
        // SAFETY: the session is alive, and not used after this.
        unsafe { (self.close)(self.session.as_ptr()) };
    }
}

fn nanoseconds(time: Duration) -> i64 {
    i64::try_from(time.as_nanos()).unwrap_or(i64::MAX)
}
