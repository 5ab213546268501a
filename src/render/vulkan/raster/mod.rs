//! The `raster` stage: splats in drawing order go in, an image comes out (model.md, step 10); and
//! `resolve`, for what is drawn larger than it is shown.
//!
//! | method | how | fragments |
//! |---|---|---|
//! | [`RasterMethod::Quads`] | a quad a splat, blended far to near by the device's blender | all that a quad covers; behind the saturation depth they fail the depth test |
//! | [`RasterMethod::SharedTiles`], [`RasterMethod::CooperativeTiles`] | `binning` lists the splats of each bin or tile, a kernel blends each pixel near to far | none behind a saturated pixel |

mod bins;
pub mod choice;
pub(crate) mod download;
pub(crate) mod draw;
mod options;
pub(crate) mod quad_pass;
mod quads;
pub(crate) mod resolve;
mod runs;
mod saturation;
mod stage;
pub(crate) mod target;
mod tiles;

pub use effigy_core::{
    frame::{ColorFormat, Damage, RasterMethod},
    layout::BinLists,
};
pub(crate) use options::drawn_by;
pub use options::resolved;
pub use runs::TileLists;
pub use stage::Raster;
