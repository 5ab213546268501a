//! The viewer: a window that shows an avatar moving, on desktops and on Android.
//!
//! [`Display::show`] runs it. [`window`] receives winit's events and passes them to [`viewer`], the
//! one place that decides what happens. The viewer owns a state for each concern:
//!
//! | state | module | answers |
//! |---|---|---|
//! | scene | [`scene`], [`playback`], [`orbit`] | which pose, camera and background to draw |
//! | window | `host_window` | is there a window, is it visible, how large is it |
//! | input | `input`, [`gesture`], [`tap_gesture`] | what pointers and fingers ask for |
//! | frame clock | `frame_clock`, `frame_sync`, [`pacing`] | when to draw the next frame |
//! | quality | [`quality_control`], `drift_check` | at which quality to hold the frame rate |
//! | recovery | `recovery` | whether to go on after a loss |
//! | dropped files | [`dropped`], [`file_list`] | what to show next |
//! | live avatar | [`live`] | what the avatar is by now |
//! | captures | `captures`, [`screenshot`] | screenshots, RenderDoc captures, the trace |
//! | trials | `question` | whether quads or tiles are faster, for the next start |
//! | survey | `survey` | what the device manages, measured when asked for |
//!
//! [`painter`] draws a frame into the window, [`ui`] the panel over it. [`action`] lists what a
//! user can ask for, and the keys.

pub mod action;
#[cfg(target_os = "android")]
mod android;
#[cfg(target_os = "android")]
mod android_entry;
mod captures;
mod device;
mod drift_check;
pub mod dropped;
pub mod file_list;
#[cfg(any(target_os = "android", test))]
mod font;
mod frame_clock;
mod frame_sync;
pub mod frame_times;
pub mod gesture;
mod host_window;
mod input;
pub mod live;
mod message;
pub mod options;
pub mod orbit;
pub mod pacing;
pub mod painter;
pub mod playback;
pub mod quality_control;
mod question;
mod recovery;
pub mod scene;
pub mod screenshot;
mod survey;
pub mod tap_gesture;
pub mod ui;
pub mod viewer;
pub mod views;
pub mod window;

pub use effigy_core::frame::RendererOptions;
pub use options::{DriverLoss, Rehearsal, ViewerOptions};
pub use window::Display;
