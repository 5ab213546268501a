//! The `raster` stage: splats in drawing order go in, an image comes out (model.md, step 10).
//!
//! | method | how | fragments |
//! |---|---|---|
//! | [`RasterMethod::Quads`] | a quad a splat, blended far to near by the device's blender | all that a quad covers |
//! | [`RasterMethod::Tiles`] | `binning` lists the splats of each tile, a kernel blends each pixel near to far | none behind a saturated pixel |

pub(crate) mod download;
pub(crate) mod draw;
mod options;
mod quads;
mod stage;
pub(crate) mod target;
mod tiles;

pub use effigy_core::frame::{ColorFormat, Damage, RasterMethod};
pub use options::resolved;
pub use stage::Raster;
pub use tiles::TileLists;
