//! A coarse mesh of the avatar's solid inside, made from its Gaussians. Gaussians behind it are
//! hidden.

pub mod mesh;
mod voxels;

pub use mesh::{Occluder, OccluderVertex};
