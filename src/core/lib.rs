//! Avatars and frames, independent of what draws them. Modules import only modules above them in
//! this list:
//!
//! - [`constants`], [`hash`], [`random`], `each`: constants, FNV-1a, random numbers, work on all cores
//! - [`avatar`]: the model as plain arrays, its skeleton, poses and clips
//! - [`layout`]: the GPU's structs, constants and packed arrays
//! - [`scene`]: camera, posed avatar, bounds, images
//! - [`frame`]: options of a renderer, the plan of a frame, its report
//! - [`reference`](mod@reference): every stage in f64
//! - [`io`](mod@io): files

pub mod avatar;
pub mod constants;
#[cfg(test)]
mod demo;
mod each;
pub mod frame;
pub mod hash;
pub mod io;
pub mod layout;
pub mod random;
#[cfg(not(target_arch = "wasm32"))]
pub mod reference;
pub mod scene;

/// The vectors and matrices of poses, cameras and bounds, in the version that these use.
pub use glam;
