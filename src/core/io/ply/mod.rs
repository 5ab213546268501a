//! Import of 3DGS `.ply` files: each becomes a static [`Avatar`](crate::avatar::Avatar) with one
//! joint, which rotates the file's axes to ours. [`super::cameras`] reads the cameras that belong
//! to it.
//!
//! The canonical space is the file's own, so that spherical harmonics keep their directions.
//! Numbers are stored as in every avatar: positions as 16-bit coordinates in the Gaussians' box,
//! opacity in 8 bits, all else in f16.

mod gaussians;
mod header;
mod read;
mod up;
mod vertices;

pub use header::UP_COMMENT;
pub use read::{from_bytes, is_ply, open};
pub use up::Up;
