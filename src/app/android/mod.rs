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

use winit::{
    event_loop::ActiveEventLoop,
    platform::android::{ActiveEventLoopExtAndroid, activity::AndroidApp},
};

/// The activity that the windows belong to.
pub fn activity(event_loop: &ActiveEventLoop) -> &AndroidApp {
    event_loop.android_app()
}
