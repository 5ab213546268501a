//! Points divided into parts, head parts first; inside a part they follow a curve through space.

use crate::sampling::{farthest_points, morton_code};
use glam::DVec3;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rayon::prelude::*;
use std::ops::Range;

/// Parts and the points' new order.
pub struct Partition {
    /// The old index of each point.
    pub order: Vec<usize>,
    /// Part i is `order[start[i]..start[i + 1]]`.
    pub start: Vec<u32>,
    /// Parts before this one are head parts: they see the expression.
    pub head: usize,
    /// The mean of each part's points.
    pub center: Vec<DVec3>,
}

impl Partition {
    /// The part's range of [`order`](Self::order).
    pub fn range(&self, part: usize) -> Range<usize> {
        self.start[part] as usize..self.start[part + 1] as usize
    }
}

/// Divides points into `count` parts, at most as many as there are points, around seeds that are as
/// far from each other as can be, every point into its nearest seed's part. `is_head`: whether a
/// part of these points sees the expression.
pub fn divide(positions: &[DVec3], count: usize, is_head: impl Fn(&[usize]) -> bool) -> Partition {
    let seeds: Vec<[f64; 3]> = farthest_points(positions, count)
        .iter()
        .map(|seed| seed.to_array())
        .collect();
    let tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(&seeds);
    let nearest: Vec<usize> = positions
        .par_iter()
        .map(|p| tree.nearest_one::<SquaredEuclidean>(&p.to_array()).item as usize)
        .collect();
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); seeds.len()];
    for (i, &part) in nearest.iter().enumerate() {
        members[part].push(i);
    }
    let (mut parts, other_parts): (Vec<_>, Vec<_>) =
        members.into_iter().partition(|list| is_head(list));
    let head = parts.len();
    parts.extend(other_parts);

    let low = positions.iter().copied().fold(DVec3::INFINITY, DVec3::min);
    let mut result = Partition {
        order: Vec::with_capacity(positions.len()),
        start: vec![0],
        head,
        center: Vec::new(),
    };
    for mut list in parts {
        list.sort_by_key(|&i| (morton_code(positions[i] - low), i));
        let sum: DVec3 = list.iter().map(|&i| positions[i]).sum();
        result.center.push(sum / list.len().max(1) as f64);
        result.order.extend(list);
        result.start.push(result.order.len() as u32);
    }
    result
}
