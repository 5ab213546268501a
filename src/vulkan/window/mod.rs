//! From an image to what shows it: a window, or a screen in memory.

pub mod pre_transform;
pub mod present;
pub mod screen;
#[cfg(feature = "window")]
pub mod swapchain;
#[cfg(feature = "window")]
mod target;
pub mod timing;
pub mod watch;
