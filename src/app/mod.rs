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

pub use viewer::{Loss, Options};
pub use window::Display;
