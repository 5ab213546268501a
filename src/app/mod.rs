//! The viewer: an avatar and its clips go in, a window that shows it moving comes out.
//!
//! The logic stands apart from the window: [`gesture`] makes gestures of pointers, [`taps`] taps of fingers, [`orbit`] a camera of gestures, [`playback`] a moment
//! of the clock, [`action`] wishes of keys, [`overlay`] wishes of the panel, [`scene`] what to draw of them all. [`window`] takes the events,
//! [`viewer`] decides when a frame is drawn, [`steady`] at which quality, [`pacing`] for which refresh of the display, [`painter`] draws it.

pub mod action;
#[cfg(target_os = "android")]
mod android;
mod device;
pub mod gesture;
pub mod icons;
#[cfg(any(target_os = "android", test))]
mod letters;
mod lifecycle;
mod losses;
pub mod orbit;
pub mod overlay;
pub mod pacing;
pub mod painter;
pub mod panel;
pub mod playback;
pub mod scene;
pub mod screenshot;
pub mod shelf;
mod shots;
pub mod steady;
mod step;
mod still;
pub mod taps;
pub mod times;
pub mod viewer;
pub mod window;

pub use window::Display;

use crate::vulkan::{GpuOptions, RendererOptions};
use shelf::{Shelf, Show};
use std::path::PathBuf;
use steady::Steady;

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
    /// Losses to go through as if they had happened, each before the frame of that number, of memory when the device of that number is opened:
    /// no driver loses anything on demand.
    pub rehearse: Vec<(Loss, u32)>,
    /// Avatars to choose from in the panel.
    pub shelf: Shelf,
    /// The one of them to read and show once the viewer runs.
    pub first: Option<usize>,
    /// Where screenshots go: the first that takes one.
    pub folders: Vec<PathBuf>,
    /// Something for the panel to say at first.
    pub said: Option<String>,
    /// What is left of a crash, for the panel to offer to share.
    pub report: Option<String>,
    /// Whether and how to hold a frame rate. None draws at the whole quality, come what may.
    pub steady: Option<Steady>,
    /// Where to write a timeline of host and device at the end.
    pub trace: Option<PathBuf>,
}

/// What a driver can take away or refuse while a window is open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loss {
    Surface,
    Device,
    /// Not lost, but too little of it for an avatar.
    Memory,
}

/// What another thread has to tell the viewer.
pub enum Message {
    /// Something for the panel to say.
    Say(String),
    /// An avatar of the shelf, by its number, has been read.
    Show(usize, Box<Show>),
}
