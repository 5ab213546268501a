//! The library for JavaScript: an avatar on a canvas. `page/effigy.js` wraps it for pages; nothing
//! else should call it.
//!
//! A `CanvasSurface` is a device with a canvas. An `AvatarCanvas` owns one, and at most one avatar.
//! File contents go in, frames appear on the canvas; errors are sentences. Nothing that waits
//! borrows an `AvatarCanvas`, so a page can call it at any time.

#[cfg(target_arch = "wasm32")]
mod avatar_canvas;
pub mod motion;
#[cfg(target_arch = "wasm32")]
mod panics;
#[cfg(target_arch = "wasm32")]
mod surface;
