//! The display's refreshes, if Vulkan does not report them: from `AChoreographer`, which every
//! supported system has.

use std::{
    ffi::{c_long, c_void},
    ptr::null_mut,
    sync::atomic::{AtomicBool, AtomicI64, Ordering},
};
use winit::platform::android::activity::ndk_sys::{
    AChoreographer_getInstance, AChoreographer_postFrameCallback,
};

/// When the last reported refresh began, nanoseconds of the system's monotonic clock; 0 once it was
/// taken.
static LAST_REFRESH: AtomicI64 = AtomicI64::new(0);
/// The next refresh was requested, and has not been reported yet.
static REQUESTED: AtomicBool = AtomicBool::new(false);

/// Asks for a report of the next refresh. Call it on the thread that polls the activity's events;
/// the report comes while it polls.
pub fn request() {
    if REQUESTED.swap(true, Ordering::AcqRel) {
        return;
    }
    // SAFETY: the glue has given this thread a looper; the callback does not use its data pointer.
    unsafe {
        let choreographer = AChoreographer_getInstance();
        if !choreographer.is_null() {
            AChoreographer_postFrameCallback(choreographer, Some(refreshed), null_mut());
        }
    }
}

/// When the last reported refresh began, nanoseconds of the system's monotonic clock. Each one is
/// returned once.
pub fn take() -> Option<u64> {
    u64::try_from(LAST_REFRESH.swap(0, Ordering::AcqRel))
        .ok()
        .filter(|&at| at > 0)
}

/// The system's monotonic clock, nanoseconds.
pub fn now() -> u64 {
    let mut now = libc::timespec {
        tv_sec: 0,
        tv_nsec: 0,
    };
    // SAFETY: it writes to `now` only. Every system has this clock.
    unsafe { libc::clock_gettime(libc::CLOCK_MONOTONIC, &mut now) };
    now.tv_sec as u64 * 1_000_000_000 + now.tv_nsec as u64
}

unsafe extern "C" fn refreshed(nanoseconds: c_long, _: *mut c_void) {
    LAST_REFRESH.store(nanoseconds, Ordering::Release);
    REQUESTED.store(false, Ordering::Release);
}
