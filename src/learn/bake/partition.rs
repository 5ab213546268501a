//! The parts of a body's points.

use crate::bake::joints::is_head;
use crate::bake::surface::Site;
use effigy_math::partition::{Partition, divide};
use glam::DVec3;

/// A part must see the expression if it moves one of its points further than this, metres.
const EXPRESSION_THRESHOLD: f64 = 0.0008;

/// Divides points into `count` parts ([`divide`]). `sites` are the points in the rest pose.
pub fn partition(positions: &[DVec3], sites: &[&Site], count: usize) -> Partition {
    let has_expression = |i: &usize| {
        let displacements = &sites[*i].expression;
        displacements
            .iter()
            .any(|d| d.length() > EXPRESSION_THRESHOLD)
    };
    let is_on_head = |i: &&usize| sites[**i].share(is_head) > 0.5;
    divide(positions, count, |list| {
        list.iter().any(has_expression) || 2 * list.iter().filter(is_on_head).count() > list.len()
    })
}
