//! Requests the display's highest refresh rate, if the system supports it.

use super::java;
use std::ffi::c_void;
use winit::platform::android::activity::{AndroidApp, ndk_sys::ANativeWindow};

/// `ANativeWindow_setFrameRate`, of API level 30: window, Hz, compatibility.
type SetFrameRate = unsafe extern "C" fn(*mut ANativeWindow, f32, i8) -> i32;

/// Requests the highest refresh rate of the window's display. Does nothing on systems before API
/// level 30, which have one rate.
pub fn request_highest(app: &AndroidApp) {
    let Some(window) = app.native_window() else {
        return;
    };
    let Some(set) = set_frame_rate() else {
        return;
    };
    let Some(rate) = java::highest_rate(app) else {
        return;
    };
    // SAFETY: the window is alive; compatibility 0 accepts other rates too.
    let answer = unsafe { set(window.ptr().as_ptr(), rate, 0) };
    tracing::info!(
        "asked the display for {rate} Hz{}",
        if answer == 0 { "" } else { ", in vain" }
    );
}

/// Looks the function up: older systems do not have it.
fn set_frame_rate() -> Option<SetFrameRate> {
    // SAFETY: both strings end with a zero; the library is loaded already and stays.
    let found = unsafe {
        let library = libc::dlopen(c"libandroid.so".as_ptr(), libc::RTLD_NOW);
        if library.is_null() {
            std::ptr::null_mut()
        } else {
            libc::dlsym(library, c"ANativeWindow_setFrameRate".as_ptr())
        }
    };
    // SAFETY: the system documents this type for the function of that name.
    (!found.is_null()).then(|| unsafe { std::mem::transmute::<*mut c_void, SetFrameRate>(found) })
}
