//! Choosing a few of many.

use glam::DVec3;
use rayon::prelude::*;

/// At most `count` of a list's entries, evenly spaced.
pub fn evenly_spaced<T: Clone>(list: &[T], count: usize) -> Vec<T> {
    let count = count.min(list.len());
    (0..count)
        .map(|k| list[(2 * k + 1) * list.len() / (2 * count)].clone())
        .collect()
}

/// At most `count` of the points, each as far as possible from those chosen before it. The first
/// point is always chosen. No two are nearer to each other than any point is to its nearest chosen
/// one: a Poisson-disk set.
pub fn farthest_points(points: &[DVec3], count: usize) -> Vec<DVec3> {
    let Some(&first) = points.first() else {
        return Vec::new();
    };
    let mut chosen = vec![first];
    // Squared distance of each point from the nearest chosen one.
    let mut distance: Vec<f64> = points
        .par_iter()
        .map(|p| p.distance_squared(first))
        .collect();
    while chosen.len() < count.min(points.len()) {
        let next = points[index_of_largest(&distance)];
        distance
            .par_iter_mut()
            .zip(points)
            .for_each(|(d, p)| *d = d.min(p.distance_squared(next)));
        chosen.push(next);
    }
    chosen
}

/// The first index of the largest number, which is not below 0.
fn index_of_largest(numbers: &[f64]) -> usize {
    numbers
        .par_iter()
        .enumerate()
        .map(|(index, &number)| (number, index))
        .reduce(
            || (-1.0, 0),
            |a, b| {
                if b.0 > a.0 || b.0 == a.0 && b.1 < a.1 {
                    b
                } else {
                    a
                }
            },
        )
        .1
}

/// The position along a Morton curve of cells of 1 mm. `p`: metres, no coordinate below 0.
pub fn morton_code(p: DVec3) -> u64 {
    const BITS: u32 = 12;
    let spread = |v: f64| {
        (0..BITS)
            .map(|bit| ((v * 1e3) as u64 >> bit & 1) << (3 * bit))
            .sum::<u64>()
    };
    spread(p.x) | spread(p.y) << 1 | spread(p.z) << 2
}
