//! A dataset in; the same with its Gaussians in another number of parts, out.

use crate::avatar::{Avatar, Parts};
use crate::bake::partition::seeds;
use crate::fit::block::range;
use crate::fit::dataset::Dataset;
use glam::DVec3;
use kiddo::{ImmutableKdTree, SquaredEuclidean};

/// `count` parts, one for all included, around seeds that are as far from each other as can be. Parts most of whose Gaussians saw the
/// expression see it; one part for all does.
pub fn regroup(dataset: Dataset, count: usize) -> Dataset {
    let old = &dataset.avatar;
    let positions: Vec<DVec3> = (0..old.gaussians.len()).map(|k| old.position(k)).collect();
    let seeds = seeds(&positions, count);
    let tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(&seeds.iter().map(|s| s.to_array()).collect::<Vec<_>>());
    let nearest = |p: DVec3| tree.nearest_one::<SquaredEuclidean>(&p.to_array()).item as usize;
    let mut members: Vec<Vec<u32>> = vec![Vec::new(); seeds.len()];
    let heads = range(old, 0).start..old.parts.start[old.parts.head] as usize;
    positions.iter().enumerate().for_each(|(k, &p)| members[nearest(p)].push(k as u32));
    let is_head = |list: &Vec<u32>| count == 1 || 2 * list.iter().filter(|&&k| heads.contains(&(k as usize))).count() > list.len();
    let mut order: Vec<usize> = (0..seeds.len()).collect();
    order.sort_by_key(|&part| (!is_head(&members[part]), part));
    let mut parts = Parts { start: vec![0], head: order.iter().filter(|&&part| is_head(&members[part])).count() };
    let mut place = vec![0; seeds.len()];
    let mut gaussians: Vec<u32> = Vec::with_capacity(positions.len());
    for (at, &part) in order.iter().enumerate() {
        place[part] = at;
        gaussians.extend(&members[part]);
        parts.start.push(gaussians.len() as u32);
    }
    let mut avatar = reordered(old, &gaussians);
    avatar.nodes.part = (0..old.nodes.len()).map(|node| place[nearest(old.node_position(node))] as u16).collect();
    avatar.parts = parts;
    dataset.regrouped(avatar, &gaussians)
}

/// The avatar with its Gaussians in another order.
fn reordered(old: &Avatar, order: &[u32]) -> Avatar {
    fn pick<T: Copy>(list: &[T], order: &[u32]) -> Vec<T> {
        order.iter().map(|&k| list[k as usize]).collect()
    }
    let mut new = old.clone();
    let (from, to) = (&old.gaussians, &mut new.gaussians);
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
