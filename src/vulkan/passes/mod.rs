//! The stages from an avatar's pose to its splats, in the order a frame runs them, and the avatar
//! in device memory that they read.

pub mod mlp;
pub mod model;
pub mod occluder;
pub mod project;
pub mod sh;
