//! Files: avatars and motion, import of 3DGS `.ply` files and their cameras, and export of posed
//! frames for other viewers.

#[cfg(not(target_arch = "wasm32"))]
pub mod cameras;
pub mod file;
#[cfg(not(target_arch = "wasm32"))]
pub mod pack;
#[cfg(not(target_arch = "wasm32"))]
pub mod ply;
#[cfg(not(target_arch = "wasm32"))]
pub mod ply_export;
