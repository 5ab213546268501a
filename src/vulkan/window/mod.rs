//! From an image to what shows it: a window, or a screen in memory.

pub mod present;
pub mod screen;
#[cfg(feature = "window")]
pub mod swapchain;
#[cfg(feature = "window")]
mod target;
pub mod timing;
pub mod turn;
pub mod watch;
