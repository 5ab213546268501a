//! The stages from an avatar's pose to its splats, in the order a frame runs them, and the avatar
//! in device memory that they read.

pub(crate) mod coefficients;
pub(crate) mod mlp;
pub(crate) mod model;
pub(crate) mod project;
pub(crate) mod sh;
pub(crate) mod splat_buffer;
