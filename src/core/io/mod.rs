//! Files: avatars and motion, splats, 3DGS `.ply` files, and the cameras that belong to those.

pub mod assumption;
#[cfg(not(target_arch = "wasm32"))]
pub mod cameras;
pub mod file;
#[cfg(not(target_arch = "wasm32"))]
pub mod pack;
pub mod ply;
pub mod ply_export;
pub mod splats;
pub mod text;
