//! The viewer: an avatar and its clips go in, a window that shows it moving comes out.
//!
//! The logic stands apart from the window: [`gesture`] makes gestures of pointers, [`orbit`] a camera of gestures, [`playback`] a moment
//! of the clock, [`action`] wishes of keys, [`overlay`] wishes of the panel, [`scene`] what to draw of them all. [`window`] takes the events,
//! [`viewer`] decides when a frame is drawn, [`painter`] draws it.

pub mod action;
pub mod gesture;
pub mod orbit;
pub mod overlay;
pub mod painter;
pub mod panel;
pub mod playback;
pub mod scene;
pub mod screenshot;
pub mod times;
pub mod viewer;
pub mod window;

pub use window::Display;

use crate::vulkan::{GpuOptions, RendererOptions};

/// What a viewer is started with.
pub struct Options {
    pub gpu: GpuOptions,
    /// Its size is the window's, px.
    pub drawing: RendererOptions,
    pub full_screen: bool,
    /// Display-referred RGB, 0 to 1.
    pub background: [f32; 3],
    /// Draw without a rest, and quit after so many frames.
    pub frames: Option<u32>,
    /// Losses to go through as if they had happened, each before the frame of that number: no driver loses anything on demand.
    pub rehearse: Vec<(Loss, u32)>,
}

/// What a driver can take away while a window is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loss {
    Surface,
    Device,
}

/// Something for the overlay to say, from another thread.
#[derive(Debug)]
pub struct Message(pub String);
