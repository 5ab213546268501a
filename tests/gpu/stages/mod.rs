//! The stages of a frame and whole frames against the reference. Drivers that differ only in their
//! vector width run these alone.

pub mod crowd;
pub mod detail;
pub mod frame;
pub mod mlp;
pub mod nodes;
pub mod people;
pub mod project;
pub mod raster;
pub mod resolve;
pub mod saturation;
pub mod scene;
pub mod sh;
pub mod skip;
pub mod sort;
pub mod stress;
