//! The viewer: an avatar and its clips go in, a window that shows it moving comes out.
//!
//! The logic stands apart from the window: [`gesture`] makes gestures of pointers, [`orbit`] a camera of gestures, [`playback`] a moment
//! of the clock, [`action`] wishes of keys, [`overlay`] wishes of the panel.

pub mod action;
pub mod gesture;
pub mod orbit;
pub mod overlay;
pub mod playback;
pub mod screenshot;
pub mod times;
