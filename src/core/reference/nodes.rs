//! Stage `nodes` (docs/model.md, step 3): displacement of every position node from the features.

use super::basis::combine;
use crate::avatar::Avatar;
use crate::constants::FEATURE_MAX;
use glam::DVec3;

/// δx_s = offset + B_s · e of each node, with its part's features, clamped to ±[`FEATURE_MAX`];
/// metres, canonical pose; length N_s.
///
/// `features` has shape N_G, E. Where E is twice N_B, nodes use the second half.
pub fn nodes(avatar: &Avatar, features: &[f64]) -> Vec<DVec3> {
    let basis_len = avatar.basis_len();
    (0..avatar.nodes.len())
        .map(|node| {
            let part = usize::from(avatar.nodes.part[node]);
            let e = &features[part * avatar.networks.output()..][avatar.node_feature_start()..]
                [..basis_len];
            let corrective: [f64; 3] = combine(avatar.nodes.basis.row(node, 3 * basis_len), e);
            let moved =
                DVec3::from(avatar.nodes.offset[node].map(f64::from)) + DVec3::from(corrective);
            moved.clamp(DVec3::splat(-FEATURE_MAX), DVec3::splat(FEATURE_MAX))
        })
        .collect()
}

/// δx of a point that follows three nodes: the sum of their displacements by their weights, metres.
/// `nodes`: of all nodes.
pub fn displacement(weights: [f64; 3], node: [u16; 3], nodes: &[DVec3]) -> DVec3 {
    let pairs = weights.into_iter().zip(node);
    pairs
        .map(|(weight, s)| weight * nodes[usize::from(s)])
        .sum()
}
