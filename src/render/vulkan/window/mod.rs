//! From an image to what shows it: a window, or a screen in memory.

pub(crate) mod pre_transform;
pub(crate) mod present;
pub(crate) mod screen;
mod screen_pass;
#[cfg(feature = "window")]
pub mod swapchain;
#[cfg(feature = "window")]
mod target;
#[cfg(feature = "window")]
pub(crate) mod timing;
pub(crate) mod watch;
