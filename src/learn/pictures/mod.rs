//! Captures of the baked person: what real ones have, pictures, masks, cameras, poses and a body
//! model, made from the mesh that [`crate::ground_truth`] settles and lights.
//!
//! ```text
//! poses ── rig: cameras around all of them ── scene: rays traced against the posed mesh
//!                                                ↓
//!          template: the naked body       flaws: noise, exposure, blur, masks, poses, calibration
//!                         └───────── shoot: the capture's folder ─────────┘
//! ```

mod flaws;
mod frames;
mod image;
mod rig;
mod scene;
mod shoot;
mod template;

pub use flaws::Flaws;
pub use frames::{ClipFrame, plan_frames};
pub use rig::{RigOptions, rig};
pub use scene::{BodyPart, PosedScene, Studio};
pub use shoot::{PictureOptions, Summary, shoot};
pub use template::template;
