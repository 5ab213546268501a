//! Stage `bins`: splats, the order to draw them in and a tile's side go in; which splats each tile meets comes out. A picture drawn tile by
//! tile is the one that model.md's step 10 describes, since a splat adds nothing outside the box around it.

use super::splats::{Culled, Splat};

/// Splats that may meet a tile: their boxes, grown by `slack` px on every side (shrunk where it is negative), overlap it. Nearest first.
/// `tile`: column and row; `side`: of a tile, px.
pub fn bin(splats: &[Result<Splat, Culled>], order: &[u32], tile: [u32; 2], side: u32, slack: f64) -> Vec<u32> {
    let meets = |&k: &u32| {
        splats[k as usize].as_ref().is_ok_and(|splat| {
            (0..2).all(|axis| {
                let (start, reach) = (f64::from(tile[axis] * side), splat.extent[axis] + slack);
                splat.center[axis] + reach >= start && splat.center[axis] - reach <= start + f64::from(side)
            })
        })
    };
    order.iter().rev().copied().filter(meets).collect()
}
