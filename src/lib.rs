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
//!     let gpu = Gpu::new(&GpuOptions::new())?;
//!     let mut renderer = Renderer::new(&gpu, &avatar, RendererOptions::new(size))?;
//!     let framing = renderer.bounds().framing(&posed.joints);
//!     let camera = Camera::around(framing, Orbit { yaw: 0.35, ..Orbit::default() }, size);
//!     renderer.draw(&posed, &camera)?;
//!     # #[cfg(feature = "image")]
//!     renderer.read_image()?.over([1.0; 3]).save("body.png")?;
//!     Ok(())
//! }
//! ```
//!
//! [`Renderer::add_avatar`] and [`Renderer::draw_people`] draw different people, who may pass through
//! each other.
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
//! # Packages
//!
//! `effigy-core` holds avatars, files, frames and the reference, whatever draws them; the internal
//! `effigy-render` draws on Vulkan and WebGPU. This package is what other programs use of both.
//! Viewer, measuring, learning and the command line are packages above them.
//!
//! # Features
//!
//! `image` saves images, `rayon` reads and packs avatars on all cores, `window` draws to windows with
//! `effigy-app`, `webgpu` has the WebGPU backend outside of browsers. None is a default.

#[cfg(not(target_arch = "wasm32"))]
mod device;
#[cfg(not(target_arch = "wasm32"))]
mod renderer;

#[cfg(not(target_arch = "wasm32"))]
pub use device::{Gpu, GpuOptions};
#[cfg(not(target_arch = "wasm32"))]
pub use effigy_core::reference;
pub use effigy_core::{
    avatar::{Avatar, Clip, Pose, Skeleton, motion::Player},
    frame::{AvatarId, FrameReport, Person},
    glam,
    io::file::{FileError, FormatError},
    scene::{AvatarBounds, Camera, FrameImage, Framing, Orbit, Posed},
};
#[cfg(not(target_arch = "wasm32"))]
pub use effigy_render::vulkan::{Error, Result};
#[cfg(not(target_arch = "wasm32"))]
pub use renderer::{Renderer, RendererOptions};
