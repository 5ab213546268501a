//! The reference renderer: every stage of docs/model.md in f64, in plain Rust, written to be read
//! against the paper's section "Local Linear Blendshapes".
//!
//! It starts from the stored numbers that the GPU reads, sorts by exact depth and blends in f64.
//! Whatever a GPU's stage or image differs by is that GPU's arithmetic.

pub mod basis;
pub mod binning;
pub mod frame;
pub mod mlp;
pub mod nodes;
pub mod present;
pub mod project;
pub mod raster;
pub mod ray;
pub mod saturation;
pub mod sh;
pub mod shown;
pub mod sort;
pub mod surface;

pub use frame::{
    Person, ReferenceFrame, average_of, drawn_rect, gaussians_of, people, render, render_gaussians,
    render_scene, render_sorted, render_stored, render_supersampled, stored,
};
pub use project::{Culled, Gaussian, Splat};
pub use raster::Canvas;
pub use ray::RayGaussian;
pub use shown::render_shown;
pub use sort::Sorting;
pub use surface::{Carried, SurfaceView, carry};
