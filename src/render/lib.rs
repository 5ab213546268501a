//! The stages on devices, for the packages of this workspace: what other programs draw with is
//! `effigy`, and nothing here promises to stay.
//!
//! # A frame
//!
//! [`FrameSchedule::new`](effigy_core::frame::FrameSchedule::new) says what a frame runs; both
//! backends execute it. The stages, in the order that the folders and the shaders follow:
//!
//! ```text
//! pose ─┬→ mlp        one small network a body part: pose, expression → 16 or 32 features
//!       │   ↓
//!       │  nodes      displacements of about 10,000 position nodes
//!       ↓   ↓
//! joints ─→ sh        view-dependent colour, for imported avatars that have it
//!       │   ↓
//!       └→ project    sparse correctives, skinning, projection, culling, depth key
//!           ↓
//!          sort       stable, far to near
//!           ↓
//!         binning     lists of splats by tile, or by bin
//!           ↓
//!        saturation   the depth behind which hardly anything shows, for quads
//!           ↓
//!         raster      quads through the blender, or tiles in a compute kernel
//!           ↓
//!         resolve     small avatars, drawn larger, averaged into the image
//!           ↓
//!         present     over the background, to a window or an image
//! ```
//!
//! # Modules
//!
//! Each imports only modules above it in this list.
//!
//! | module | what it holds |
//! |---|---|
//! | `ndk` | sections for Android's tracer |
//! | `quirks` | what single drivers do wrong or best |
//! | [`vulkan`] | the stages on Vulkan |
//! | `webgpu` | the stages on WebGPU, with the feature of that name or in a browser |

#[cfg(not(target_arch = "wasm32"))]
pub mod ndk;
pub mod quirks;
#[cfg(not(target_arch = "wasm32"))]
pub mod vulkan;
#[cfg(any(feature = "webgpu", target_arch = "wasm32"))]
pub mod webgpu;

#[cfg(any(feature = "webgpu", target_arch = "wasm32"))]
use effigy_wgsl as wgsl;
