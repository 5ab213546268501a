//! Stage 4, model.md step 9. In: splats. Out: the order in which they are drawn.

use super::splats::{Culled, Splat};

/// Indices of the splats that are drawn, far to near; of equal depths the lower index comes first.
pub fn order(splats: &[Result<Splat, Culled>]) -> Vec<u32> {
    let mut drawn: Vec<(u32, f64)> = (0..).zip(splats).filter_map(|(k, splat)| Some((k, splat.as_ref().ok()?.depth))).collect();
    drawn.sort_by(|(_, a), (_, b)| b.total_cmp(a));
    drawn.into_iter().map(|(k, _)| k).collect()
}
