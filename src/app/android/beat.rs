//! The display's beat where Vulkan does not tell it: `AChoreographer`, which every system that the app is for has.

use std::{
    ffi::{c_long, c_void},
    ptr::null_mut,
    sync::atomic::{AtomicBool, AtomicI64, Ordering},
};
use winit::platform::android::activity::ndk_sys::{AChoreographer_getInstance, AChoreographer_postFrameCallback};

/// When the last refresh began that was told, nanoseconds of the system's monotonic clock; 0 where there is none that was not taken.
static TOLD: AtomicI64 = AtomicI64::new(0);
/// A refresh was asked for and not told yet.
static ASKED: AtomicBool = AtomicBool::new(false);

/// Wants to be told of the next refresh: on the thread that listens to the activity, while it listens.
pub fn ask() {
    if ASKED.swap(true, Ordering::AcqRel) {
        return;
    }
    // SAFETY: the glue has given this thread a looper; the callback needs none of what a null pointer could point to.
    unsafe {
        let choreographer = AChoreographer_getInstance();
        if !choreographer.is_null() {
            AChoreographer_postFrameCallback(choreographer, Some(refreshed), null_mut());
        }
    }
}

/// When the refresh began that was told last, once, nanoseconds of the system's monotonic clock.
pub fn take() -> Option<u64> {
    u64::try_from(TOLD.swap(0, Ordering::AcqRel)).ok().filter(|&at| at > 0)
}

/// Now, on the same clock.
pub fn now() -> u64 {
    let mut now = libc::timespec { tv_sec: 0, tv_nsec: 0 };
    // SAFETY: it writes to `now` only. The clock is always there.
    unsafe { libc::clock_gettime(libc::CLOCK_MONOTONIC, &mut now) };
    now.tv_sec as u64 * 1_000_000_000 + now.tv_nsec as u64
}

unsafe extern "C" fn refreshed(nanoseconds: c_long, _: *mut c_void) {
    TOLD.store(nanoseconds, Ordering::Release);
    ASKED.store(false, Ordering::Release);
}
