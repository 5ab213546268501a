//! The scene: camera, posed avatar, bounds, level of detail, supersampling, dependencies of parts,
//! and images in memory.

pub mod avatar_bounds;
pub mod camera;
pub mod detail;
pub mod frame_image;
mod framing;
pub mod levels;
mod moved_box;
pub mod parts;
pub mod pixel_rect;
mod plane_box;
pub mod posed;
mod scene_boxes;
pub mod supersampling;

pub use avatar_bounds::{AvatarBounds, PoseShape, Visible};
pub use camera::{Camera, Orbit};
pub use detail::Detail;
pub use frame_image::FrameImage;
pub use framing::Framing;
pub use levels::LevelChoice;
use moved_box::{AxisBox, BoxMover};
pub use parts::{PartDependencies, PartSet};
pub use pixel_rect::{PixelRect, PlaneRect};
use plane_box::PlaneBox;
pub use posed::{Posed, radius_in_sigmas};
use scene_boxes::SceneBoxes;
pub use supersampling::Supersampling;
