//! Run-time services, besides the renderer, of a program that draws with Effigy.
//!
//! - [`cache`] is the folder for what is kept from start to start.
//! - [`governor`] trades quality for a steady frame rate.
//! - [`thermals`] reads, replays or simulates how warm the device is.
//! - [`ndk`] asks and tells Android about heat and work.
//! - [`trace`] writes timelines of host and device in Chrome's format.
//! - [`capture`] asks RenderDoc, where it is attached, to capture frames.

pub mod cache;
pub mod capture;
pub mod governor;
pub mod ndk;
pub mod slow_start;
pub mod thermals;
pub mod trace;
