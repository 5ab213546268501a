//! Placed points in; parts, head parts first, and the order of points by part and along a curve inside each, out.

use super::surface::Site;
use glam::DVec3;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rayon::prelude::*;

/// Parts and the points' new order.
pub struct Partition {
    /// Old index of each point, by part.
    pub order: Vec<usize>,
    /// Part i is `order[start[i]..start[i + 1]]`.
    pub start: Vec<u32>,
    /// Parts before this one are head parts.
    pub head: usize,
    /// Mean of each part's points.
    pub center: Vec<DVec3>,
}

/// A displacement above which a part must see the expression, metres.
const FELT: f64 = 0.0008;

/// `count` parts: seeds taken one after another as far as can be from those before (so no two are nearer than any point is to a seed:
/// a Poisson-disk set), every point in its nearest seed's part.
pub fn partition(positions: &[DVec3], sites: &[&Site], count: usize) -> Partition {
    let seeds = seeds(positions, count);
    let tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(&seeds.iter().map(|s| s.to_array()).collect::<Vec<_>>());
    let nearest: Vec<usize> = positions.par_iter().map(|p| tree.nearest_one::<SquaredEuclidean>(&p.to_array()).item as usize).collect();
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); seeds.len()];
    nearest.iter().enumerate().for_each(|(i, &part)| members[part].push(i));
    let felt = |i: &usize| sites[*i].expression.iter().any(|d| d.length() > FELT);
    let headed = |i: &&usize| sites[**i].share(super::outfit::is_head) > 0.5;
    let (mut heads, bodies): (Vec<_>, Vec<_>) =
        members.into_iter().partition(|list| list.iter().any(felt) || 2 * list.iter().filter(headed).count() > list.len());
    let head = heads.len();
    heads.extend(bodies);
    let low = positions.iter().fold(DVec3::INFINITY, |m, p| m.min(*p));
    let mut result = Partition { order: Vec::with_capacity(positions.len()), start: vec![0], head, center: Vec::new() };
    for mut list in heads {
        list.sort_by_key(|&i| (morton(positions[i] - low), i));
        result.center.push(list.iter().map(|&i| positions[i]).sum::<DVec3>() / list.len().max(1) as f64);
        result.order.extend(list);
        result.start.push(result.order.len() as u32);
    }
    result
}

/// Seeds of so many parts.
pub fn seeds(positions: &[DVec3], count: usize) -> Vec<DVec3> {
    let Some(first) = positions.first() else { return Vec::new() };
    let mut seeds = vec![*first];
    let mut distance: Vec<f64> = positions.par_iter().map(|p| p.distance_squared(*first)).collect();
    while seeds.len() < count.min(positions.len()) {
        let furthest = distance
            .par_iter()
            .enumerate()
            .map(|(i, d)| (*d, i))
            .reduce(|| (-1.0, 0), |a, b| if b.0 > a.0 || b.0 == a.0 && b.1 < a.1 { b } else { a });
        let seed = positions[furthest.1];
        distance.par_iter_mut().zip(positions).for_each(|(d, p)| *d = d.min(p.distance_squared(seed)));
        seeds.push(seed);
    }
    seeds
}

/// Position along a Morton curve of cells of 1 mm.
fn morton(p: DVec3) -> u64 {
    let spread = |v: f64| (0..12).map(|bit| ((v * 1e3) as u64 >> bit & 1) << (3 * bit)).sum::<u64>();
    spread(p.x) | spread(p.y) << 1 | spread(p.z) << 2
}
