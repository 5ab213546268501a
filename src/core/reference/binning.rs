//! Stage `binning`: which splats meet which tile or bin. Drawing tile by tile gives the image of
//! docs/model.md, step 10, since a splat contributes nothing outside its bounding box.

use super::project::{Culled, Splat};

/// Indices of the splats that may meet a tile, nearest first: those whose bounding box, grown by
/// `slack` px on every side (shrunk where negative), overlaps it. `tile`: column and row; `side`:
/// side of a tile, px.
pub fn bin(
    splats: &[Result<Splat, Culled>],
    order: &[u32],
    tile: [u32; 2],
    side: u32,
    slack: f64,
) -> Vec<u32> {
    let meets = |&k: &u32| {
        splats[k as usize].as_ref().is_ok_and(|splat| {
            (0..2).all(|axis| {
                let start = f64::from(tile[axis] * side);
                let radius = splat.radius[axis] + slack;
                splat.center[axis] + radius >= start
                    && splat.center[axis] - radius <= start + f64::from(side)
            })
        })
    };
    order.iter().rev().copied().filter(meets).collect()
}
