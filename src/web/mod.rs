//! What JavaScript calls: an avatar on a canvas. `page/effigy.js` wraps it for pages; nothing else should need to know it.
//!
//! A [`Screen`](screen::Screen) is a device with a canvas; a [`Stage`](stage::Stage) owns one and at most one avatar. Bytes go in, frames
//! appear on the canvas; errors are sentences. Nothing that waits borrows a stage: whatever a page calls meanwhile finds it free.

pub mod motion;
#[cfg(target_arch = "wasm32")]
mod panics;
#[cfg(target_arch = "wasm32")]
mod screen;
#[cfg(target_arch = "wasm32")]
mod stage;
