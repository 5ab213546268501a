//! Effigy draws animatable human avatars made of Gaussians.
//!
//! Read an [`Avatar`], pose it, and draw it to an image on a device that Effigy opens:
//!
//! ```no_run
//! use effigy::{Avatar, Camera, Gpu, GpuOptions, Orbit, Pose, Posed, Renderer, RendererOptions};
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     let avatar = Avatar::read("body.avatar".as_ref())?;
//!     let pose = Pose::rest(avatar.skeleton.len(), avatar.inputs.expression);
//!     let posed = Posed::new(&avatar, &pose);
//!
//!     let size = [640, 960];
//!     let gpu = Gpu::new(&GpuOptions::headless(None))?;
//!     let mut renderer = Renderer::new(&gpu, &avatar, RendererOptions::new(size))?;
//!     let framing = renderer.bounds().framing(&posed.joints);
//!     let camera = Camera::around(framing, Orbit { yaw: 0.35, ..Orbit::default() }, size);
//!     renderer.draw(&posed, &camera, None)?;
//!     renderer.read_image()?.over([1.0; 3]).save("body.png")?;
//!     Ok(())
//! }
//! ```
//!
//! A camera and a pose need no device, and neither does the reference, which draws in f64. The demo
//! is in a package of its own, `effigy-demo`, below `src/demo`:
//!
//! ```
//! use effigy::{AvatarBounds, Camera, Orbit, Player, Posed, reference};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let avatar = effigy_demo::avatar()?;
//! let player = Player::new(effigy_demo::clip()?, &avatar.skeleton);
//! let posed = Posed::new(&avatar, &player.pose(0.5));
//! let framing = AvatarBounds::new(&avatar).framing(&posed.joints);
//! let camera = Camera::around(framing, Orbit::default(), [32, 48]);
//! let image = reference::render(&avatar, &posed, &camera);
//! assert_eq!(image.size, [32, 48]);
//! assert!(image.pixels.iter().any(|pixel| pixel[3] > 0.9));
//! # Ok(())
//! # }
//! ```
//!
//! `examples/` has an image, a window, and a measurement of an avatar of one's own. Drawing inside
//! another program's Vulkan device is not possible yet.
//!
//! # A frame
//!
//! [`FrameSchedule::new`] says what a frame runs; both backends
//! execute it. The stages, in the order that the folders and the shaders follow:
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
//! Each imports only modules above it in this list; those without a link are no part of the API.
//!
//! | module | what it holds |
//! |---|---|
//! | `ndk` | sections for Android's tracer |
//! | `quirks` | what single drivers do wrong or best |
//! | [`vulkan`] | the stages on Vulkan |
//! | `webgpu` | the stages on WebGPU, with the feature of that name or in a browser |
//!
//! # Packages
//!
//! `effigy-core` holds avatars, files, frames and the reference, whatever draws them; `effigy-wgsl`
//! the shaders in WGSL; this package draws, on Vulkan ([`vulkan`]) and WebGPU. The viewer,
//! measuring, learning and the command line are packages above it.

#[cfg(not(target_arch = "wasm32"))]
#[doc(hidden)]
pub mod ndk;
#[doc(hidden)]
pub mod quirks;
#[cfg(not(target_arch = "wasm32"))]
pub mod vulkan;
#[cfg(any(feature = "webgpu", target_arch = "wasm32"))]
pub mod webgpu;

#[cfg(any(feature = "webgpu", target_arch = "wasm32"))]
use effigy_wgsl as wgsl;

#[cfg(not(target_arch = "wasm32"))]
pub use effigy_core::reference;
pub use effigy_core::{
    avatar::{Avatar, Clip, Pose, Skeleton, motion::Player},
    frame::{
        ColorFormat, FrameReport, FrameSchedule, RasterMethod, RendererOptions, Skip, SortVariant,
    },
    glam,
    io::file::{FileError, FormatError},
    scene::{AvatarBounds, Camera, Detail, FrameImage, Framing, Orbit, Posed},
};
#[cfg(not(target_arch = "wasm32"))]
pub use vulkan::{Error, Gpu, GpuOptions, Presentation, Renderer};
