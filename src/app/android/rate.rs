//! The display's highest refresh rate, asked for where the system can be asked.

use super::java;
use std::ffi::c_void;
use winit::platform::android::activity::{AndroidApp, ndk_sys::ANativeWindow};

/// `ANativeWindow_setFrameRate`, of API level 30: window, Hz, compatibility.
type SetFrameRate = unsafe extern "C" fn(*mut ANativeWindow, f32, i8) -> i32;

/// Asks for the most frames a second that the window's display can show. An older system has one rate, and nothing happens.
pub fn ask(app: &AndroidApp) {
    let (Some(window), Some(set)) = (app.native_window(), function()) else { return };
    let Some(rate) = java::highest_rate(app) else { return };
    // SAFETY: the window is alive; 0 says that other rates do no harm.
    let answer = unsafe { set(window.ptr().as_ptr(), rate, 0) };
    tracing::info!("asked the display for {rate} Hz{}", if answer == 0 { "" } else { ", in vain" });
}

fn function() -> Option<SetFrameRate> {
    // SAFETY: both strings end with a zero; the library is loaded already and stays.
    let found = unsafe {
        let library = libc::dlopen(c"libandroid.so".as_ptr(), libc::RTLD_NOW);
        if library.is_null() { std::ptr::null_mut() } else { libc::dlsym(library, c"ANativeWindow_setFrameRate".as_ptr()) }
    };
    // SAFETY: it is the function of that name, whose type is the system's promise.
    (!found.is_null()).then(|| unsafe { std::mem::transmute::<*mut c_void, SetFrameRate>(found) })
}
