//! A dataset with its Gaussians in another number of parts.

use crate::dataset::Dataset;
use crate::math::sampling::farthest_points;
use crate::train::block::part_range;
use effigy_core::avatar::{Avatar, Parts};
use glam::DVec3;
use kiddo::{ImmutableKdTree, SquaredEuclidean};

/// Divides the Gaussians into `count` parts, around seeds that are as far from each other as can
/// be. A part sees the expression if most of its Gaussians did before; a single part always does.
pub fn regroup(dataset: Dataset, count: usize) -> Dataset {
    let old = &dataset.avatar;
    let positions: Vec<DVec3> = (0..old.gaussians.len()).map(|k| old.position(k)).collect();
    let seeds: Vec<[f64; 3]> = farthest_points(&positions, count)
        .iter()
        .map(|seed| seed.to_array())
        .collect();
    let tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(&seeds);
    let nearest = |p: DVec3| tree.nearest_one::<SquaredEuclidean>(&p.to_array()).item as usize;
    let mut members: Vec<Vec<u32>> = vec![Vec::new(); seeds.len()];
    for (k, &position) in positions.iter().enumerate() {
        members[nearest(position)].push(k as u32);
    }

    let old_heads = part_range(old, 0).start..old.parts.start[old.parts.head] as usize;
    let is_head: Vec<bool> = members
        .iter()
        .map(|list| {
            let of_head = |k: &&u32| old_heads.contains(&(**k as usize));
            count == 1 || 2 * list.iter().filter(of_head).count() > list.len()
        })
        .collect();
    // Head parts come first.
    let mut order: Vec<usize> = (0..seeds.len()).collect();
    order.sort_by_key(|&part| (!is_head[part], part));
    let mut parts = Parts {
        start: vec![0],
        head: is_head.iter().filter(|&&head| head).count(),
    };
    let mut new_index = vec![0; seeds.len()];
    let mut gaussians: Vec<u32> = Vec::with_capacity(positions.len());
    for (index, &part) in order.iter().enumerate() {
        new_index[part] = index;
        gaussians.extend(&members[part]);
        parts.start.push(gaussians.len() as u32);
    }

    let mut avatar = reordered(old, &gaussians);
    avatar.nodes.part = (0..old.nodes.len())
        .map(|node| new_index[nearest(old.node_position(node))] as u16)
        .collect();
    avatar.parts = parts;
    dataset.regrouped(avatar, &gaussians)
}

/// The avatar with its Gaussians in another order; `order` has the old index of each.
fn reordered(old: &Avatar, order: &[u32]) -> Avatar {
    fn pick<T: Copy>(list: &[T], order: &[u32]) -> Vec<T> {
        order.iter().map(|&k| list[k as usize]).collect()
    }
    let mut new = old.clone();
    let from = &old.gaussians;
    let to = &mut new.gaussians;
    to.position = pick(&from.position, order);
    to.rotation = pick(&from.rotation, order);
    to.log_scale = pick(&from.log_scale, order);
    to.color = pick(&from.color, order);
    to.opacity = pick(&from.opacity, order);
    to.joint = pick(&from.joint, order);
    to.joint_weight = pick(&from.joint_weight, order);
    to.node = pick(&from.node, order);
    new
}
