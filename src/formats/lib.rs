//! Avatars of other programs. A reader gives what Effigy draws, an
//! [`Avatar`](effigy_core::avatar::Avatar), and says what it had to assume; a writer gives files
//! that those programs read.
//!
//! Readers hold against hostile input: a file may not unpack to more than 16 times its size and 32 MB,
//! archives in archives together, nor a reader take more than four times what is unpacked and 64 MB.
//! Every count is checked before memory is taken for it.

pub use effigy_core::io::assumption;
pub mod bvh;
// A page draws from its own camera alone.
#[cfg(not(target_arch = "wasm32"))]
pub mod cameras;
pub mod capture;
pub mod content;
mod fault;
#[cfg(feature = "fbx")]
pub mod fbx;
mod gltf;
pub mod gltf_motion;
mod guess;
mod json;
pub mod mmlphuman;
pub mod npz;
pub mod open;
pub mod pickle;
pub mod read;
pub mod retarget;
mod scene_tree;
pub mod smpl;
mod smpl_joints;
pub mod source;
pub mod splats;
mod wanted;
pub mod webavatar;
mod zip_file;
