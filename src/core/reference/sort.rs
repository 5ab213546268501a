//! Stage `sort` (docs/model.md, step 9): the order in which splats are drawn.

use super::project::{Culled, Splat};

/// By which depth splats are drawn far to near.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sorting {
    /// That of their centres, in one order for the whole image: the model's, and what renderers do.
    #[default]
    Centers,
    /// That at which each is densest along the pixel's ray, in an order of the pixel's own: exact,
    /// and far too slow for a renderer.
    PerPixel,
}

/// Indices of the splats that are not culled, far to near; at equal depth the lower index comes
/// first.
pub fn order(splats: &[Result<Splat, Culled>]) -> Vec<u32> {
    let mut drawn: Vec<(u32, f64)> = (0..)
        .zip(splats)
        .filter_map(|(k, splat)| Some((k, splat.as_ref().ok()?.depth)))
        .collect();
    drawn.sort_by(|(_, a), (_, b)| b.total_cmp(a));
    drawn.into_iter().map(|(k, _)| k).collect()
}
