//! 3DGS `.ply` files, plain or compressed as SuperSplat does. [`super::cameras`] reads the cameras
//! that belong to one, [`super::ply_export`] writes one.

mod compressed;
mod header;
mod plain;
mod read;
mod table;

pub(crate) use header::UP_COMMENT;
pub use read::{from_bytes, is_ply, open, read, starts_ply};
