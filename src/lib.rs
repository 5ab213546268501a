//! Effigy draws animatable human avatars made of Gaussians.
//!
//! One frame, in the order that the folders, the GPU stages and `vulkan::Renderer::record` follow:
//!
//! ```text
//! pose ─┬→ features   one small network a body part: pose, expression → 16 or 32 numbers
//!       │      ↓
//!       │   nodes     position correctives of about 10,000 nodes
//!       ↓      ↓
//! joints ─→ harmonics view-dependent colour, for imported avatars that have it
//!       │      ↓
//!       └──→ splats    sparse correctives, skinning, projection, culling, depth key
//!              ↓
//!            sort     stable, far to near
//!              ↓
//!           raster    quads, blended
//!              ↓
//!           present   over the background, to the window or to a picture
//! ```
//!
//! [`avatar`] is the model as plain arrays and its file; [`frame`] what a frame is, whatever draws it; [`reference`] the stages in
//! f64, the oracle; [`vulkan`] the stages on the GPU; [`measure`] time and error; [`bake`] makes avatars and clips from a real body
//! and real motion; `fit` learns an avatar's correctives from what its Gaussians should look like in each frame.

#[cfg(feature = "window")]
pub mod app;
pub mod avatar;
#[cfg(not(target_arch = "wasm32"))]
pub mod bake;
#[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
pub mod cli;
#[cfg(not(target_arch = "wasm32"))]
pub mod demo;
#[cfg(not(any(target_arch = "wasm32", target_os = "android")))]
pub mod fit;
pub mod frame;
mod hash;
pub mod layout;
#[cfg(not(target_arch = "wasm32"))]
pub mod measure;
#[cfg(not(target_arch = "wasm32"))]
pub mod reference;
#[cfg(not(target_arch = "wasm32"))]
pub mod vulkan;
#[cfg(any(target_arch = "wasm32", test))]
pub mod web;
pub mod webgpu;
