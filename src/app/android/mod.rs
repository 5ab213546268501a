//! Functions of Android that the viewer calls.

pub mod crash_report;
pub mod files;
pub mod java;
pub mod log;
pub mod notice;
mod refresh_rate;
pub mod vsync;

pub use java::{back, is_destroyed, refresh_rate, share};
pub use refresh_rate::request_highest as request_highest_rate;

use std::ffi::CStr;
use winit::{
    event_loop::ActiveEventLoop,
    platform::android::{ActiveEventLoopExtAndroid, activity::AndroidApp},
};

/// The activity that the windows belong to.
pub fn activity(event_loop: &ActiveEventLoop) -> &AndroidApp {
    event_loop.android_app()
}

/// Keeps the screen from going dark without touches, until it is dropped.
pub struct ScreenOn(AndroidApp);

impl ScreenOn {
    /// From now on.
    pub fn new(app: &AndroidApp) -> Self {
        java::keep_screen_on(app, true);
        Self(app.clone())
    }
}

impl Drop for ScreenOn {
    fn drop(&mut self) {
        java::keep_screen_on(&self.0, false);
    }
}

/// The phone and its system in words, without anything that only one phone has.
pub fn system() -> String {
    let [maker, model, chip, release, level] = [
        c"ro.product.manufacturer",
        c"ro.product.model",
        c"ro.soc.model",
        c"ro.build.version.release",
        c"ro.build.version.sdk",
    ]
    .map(property);
    format!("{maker} {model}, chip {chip}, Android {release}, level {level}")
}

fn property(name: &CStr) -> String {
    let mut value = [0_u8; libc::PROP_VALUE_MAX as usize];
    // SAFETY: the system writes at most so many bytes, and a zero.
    unsafe { libc::__system_property_get(name.as_ptr(), value.as_mut_ptr().cast()) };
    let value = CStr::from_bytes_until_nul(&value).unwrap_or_default();
    value.to_string_lossy().into_owned()
}
