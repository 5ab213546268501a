//! Which Gaussians a level merges: pairs of near ones, round after round.
//!
//! Each round matches Gaussians of one part with near ones, cheapest pairs first, until a quarter
//! of all are merged away. A merged Gaussian has the moments of its mixture, weighed by mass:
//! opacity times area. Its mass is the sum of theirs and is carried along, so that opacity, which
//! can't exceed 1, loses none in later rounds. A pair costs what it adds to the variance of
//! positions, in the canonical pose and others, of colours and of normals, weighed by how much of
//! the pair images show (Ward's criterion).

use effigy_math::matrix::eigen;
use glam::{DMat3, DVec3};
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rayon::prelude::*;
use std::num::NonZero;

/// Neighbours that a Gaussian may be merged with.
const NEIGHBOURS: usize = 9;
/// Share of all Gaussians that a round merges away.
const ROUND: f64 = 0.25;
/// How much of the mean a Gaussian counts at least, however little images show of it.
const LEAST_SEEN: f64 = 0.02;

/// A difference of 1 in a channel of the colour counts as much as one of position of this share of
/// the avatar's height.
const COLOR: f64 = 0.02;
/// And normals at right angles as much as this.
const NORMAL: f64 = 0.004;

/// A Gaussian, or several that were merged.
#[derive(Clone, Debug)]
pub struct Blob {
    /// Opacity times area, m².
    pub mass: f64,
    /// Pixels of images that it contributed.
    pub seen: f64,
    /// Centre in canonical space, metres.
    pub mean: DVec3,
    /// Covariance in canonical space, m².
    pub covariance: DMat3,
    /// Display-referred RGB.
    pub color: DVec3,
    /// Centres in some poses, metres.
    pub posed: Vec<DVec3>,
    /// The Gaussians that it was merged from.
    pub members: Vec<u32>,
}

/// The area of an ellipsoid's sides with these standard deviations along its axes, m², up to a
/// factor: that of a flat disc is the product of its two long ones.
pub fn area(deviations: DVec3) -> f64 {
    let DVec3 { x, y, z } = deviations;
    x * y + x * z + y * z
}

/// Axes and variances of a covariance; the axes are the columns of a rotation.
pub struct CovarianceAxes {
    /// Columns.
    pub rotation: DMat3,
    /// Variance along each, m².
    pub variance: DVec3,
}

impl CovarianceAxes {
    /// The eigenvectors and eigenvalues of a covariance, largest first.
    pub fn new(covariance: DMat3) -> Self {
        let scale = covariance.x_axis.x + covariance.y_axis.y + covariance.z_axis.z;
        let scale = if scale > 0.0 { scale } else { 1.0 };
        let found = eigen(&(covariance / scale).to_cols_array(), 3);
        let [x, y] = [0, 1].map(|k| DVec3::from_slice(&found.vectors[k]).normalize());
        Self {
            rotation: DMat3::from_cols(x, y, x.cross(y)),
            variance: DVec3::from_slice(&found.values).max(DVec3::ZERO) * scale,
        }
    }
}

impl Blob {
    /// The direction in which it is thinnest.
    fn normal(&self) -> DVec3 {
        CovarianceAxes::new(self.covariance).rotation.z_axis
    }

    /// The mixture of two.
    fn with(&self, other: &Self) -> Self {
        let mass = self.mass + other.mass;
        let [a, b] = if mass > 0.0 {
            [self.mass / mass, other.mass / mass]
        } else {
            [0.5; 2]
        };
        let between = self.mean - other.mean;
        let outer = DMat3::from_cols(
            between * between.x,
            between * between.y,
            between * between.z,
        );
        Self {
            mass,
            seen: self.seen + other.seen,
            mean: a * self.mean + b * other.mean,
            covariance: a * self.covariance + b * other.covariance + a * b * outer,
            color: a * self.color + b * other.color,
            posed: self
                .posed
                .iter()
                .zip(&other.posed)
                .map(|(p, q)| a * p + b * q)
                .collect(),
            members: [&self.members[..], &other.members].concat(),
        }
    }
}

/// A pair that may be merged, by indices into the blobs of its part.
struct MergePair {
    cost: f64,
    part: usize,
    blobs: [u32; 2],
}

/// Blobs of each part.
pub struct MergeTree {
    parts: Vec<Vec<Blob>>,
    /// Metres.
    height: f64,
    /// Added to what images show of a blob, for each m² of mass.
    unseen: f64,
}

impl MergeTree {
    /// Before the first merge. `height`: of the avatar, metres.
    pub fn new(parts: Vec<Vec<Blob>>, height: f64) -> Self {
        let sum = |of: fn(&Blob) -> f64| parts.iter().flatten().map(of).sum::<f64>();
        let mass = sum(|blob| blob.mass);
        let seen = sum(|blob| blob.seen);
        let unseen = if mass > 0.0 {
            LEAST_SEEN * seen.max(1.0) / mass
        } else {
            0.0
        };
        Self {
            parts,
            height,
            unseen,
        }
    }

    /// The blobs of each part.
    pub fn parts(&self) -> &[Vec<Blob>] {
        &self.parts
    }

    /// Number of blobs.
    pub fn count(&self) -> usize {
        self.parts.iter().map(Vec::len).sum()
    }

    /// Merges until at most `count` blobs are left, or one a part.
    pub fn merge_to(&mut self, count: usize) {
        loop {
            let now = self.count();
            let most = ((ROUND * now as f64) as usize).max(1);
            let merged = self.round(most.min(now.saturating_sub(count)));
            if merged == 0 {
                return;
            }
        }
    }

    /// Merges at most `most` pairs, the cheapest first; returns how many.
    fn round(&mut self, most: usize) -> usize {
        if most == 0 {
            return 0;
        }
        let mut pairs: Vec<MergePair> = (0..self.parts.len())
            .into_par_iter()
            .flat_map_iter(|part| self.pairs(part))
            .collect();
        pairs.sort_by(|a, b| {
            a.cost
                .total_cmp(&b.cost)
                .then((a.part, a.blobs).cmp(&(b.part, b.blobs)))
        });
        let mut free: Vec<Vec<bool>> = self.parts.iter().map(|b| vec![true; b.len()]).collect();
        let mut chosen: Vec<Vec<[u32; 2]>> = vec![vec![]; self.parts.len()];
        let mut merged = 0;
        for MergePair { part, blobs, .. } in pairs {
            if merged == most {
                break;
            }
            if blobs.iter().all(|&at| free[part][at as usize]) {
                for at in blobs {
                    free[part][at as usize] = false;
                }
                chosen[part].push(blobs);
                merged += 1;
            }
        }
        self.parts
            .par_iter_mut()
            .zip(&chosen)
            .for_each(|(blobs, chosen)| merge_pairs(blobs, chosen));
        merged
    }

    /// The pairs of near blobs in a part.
    fn pairs(&self, part: usize) -> Vec<MergePair> {
        let blobs = &self.parts[part];
        let points: Vec<[f64; 3]> = blobs.iter().map(|blob| blob.mean.to_array()).collect();
        if points.len() < 2 {
            return vec![];
        }
        let tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(&points);
        let normals: Vec<DVec3> = blobs.iter().map(Blob::normal).collect();
        let count = NonZero::new(NEIGHBOURS).unwrap_or(NonZero::<usize>::MIN);
        let mut pairs = Vec::new();
        for (a, point) in points.iter().enumerate() {
            for near in tree.nearest_n::<SquaredEuclidean>(point, count) {
                let b = near.item as usize;
                if a != b {
                    // Of a pair that both find, one is enough; sorting puts equal ones together.
                    let blobs = [a.min(b) as u32, a.max(b) as u32];
                    let cost = self.cost(part, [a, b], &normals);
                    pairs.push(MergePair { cost, part, blobs });
                }
            }
        }
        pairs
    }

    fn cost(&self, part: usize, [a, b]: [usize; 2], normals: &[DVec3]) -> f64 {
        let [p, q] = [a, b].map(|at| &self.parts[part][at]);
        let posed = p.posed.iter().zip(&q.posed);
        let distance = p.mean.distance_squared(q.mean)
            + posed.map(|(p, q)| p.distance_squared(*q)).sum::<f64>();
        let turned = 1.0 - normals[a].dot(normals[b]).powi(2);
        let difference = distance / (1.0 + p.posed.len() as f64)
            + (self.height * COLOR).powi(2) * p.color.distance_squared(q.color)
            + (self.height * NORMAL).powi(2) * turned;
        let [v, w] = [p, q].map(|blob| blob.seen + self.unseen * blob.mass);
        if v + w > 0.0 {
            v * w / (v + w) * difference
        } else {
            0.0
        }
    }
}

/// Replaces the first of each pair by both, and removes the second.
fn merge_pairs(blobs: &mut Vec<Blob>, pairs: &[[u32; 2]]) {
    let mut gone = vec![false; blobs.len()];
    for &[a, b] in pairs {
        blobs[a as usize] = blobs[a as usize].with(&blobs[b as usize]);
        gone[b as usize] = true;
    }
    let mut at = 0;
    blobs.retain(|_| {
        at += 1;
        !gone[at - 1]
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_core::random::Random;

    fn blob(random: &mut Random, at: u32, center: DVec3) -> Blob {
        let axes = DMat3::from_diagonal(0.01 * DVec3::new(1.0, 0.6, 0.05));
        let turn = DMat3::from_quat(glam::DQuat::from_scaled_axis(random.direction()));
        let axes = turn * axes;
        let mean = center + 0.3 * random.direction();
        Blob {
            mass: random.range(0.5, 2.0),
            seen: random.uniform(),
            mean,
            covariance: axes * axes.transpose(),
            color: DVec3::splat(random.uniform()),
            posed: vec![mean + DVec3::Y],
            members: vec![at],
        }
    }

    fn hierarchy(random: &mut Random) -> MergeTree {
        let mut at = 0;
        let mut part = |count: usize| -> Vec<Blob> {
            let center = random.direction();
            (0..count)
                .map(|_| {
                    at += 1;
                    blob(random, at - 1, center)
                })
                .collect()
        };
        MergeTree::new([300, 0, 120, 1].map(&mut part).into(), 2.0)
    }

    /// Mass, mean, covariance around the origin and mean colour of a part.
    fn moments(blobs: &[Blob]) -> (f64, DVec3, DMat3, DVec3) {
        let mut sums = (0.0, DVec3::ZERO, DMat3::ZERO, DVec3::ZERO);
        for blob in blobs {
            let m = blob.mean;
            let outer = DMat3::from_cols(m * m.x, m * m.y, m * m.z);
            sums.0 += blob.mass;
            sums.1 += blob.mass * m;
            sums.2 += blob.mass * (blob.covariance + outer);
            sums.3 += blob.mass * blob.color;
        }
        sums
    }

    #[test]
    fn merging_keeps_each_parts_moments_and_members() {
        let random = &mut Random::new(1, 0);
        let mut hierarchy = hierarchy(random);
        let before: Vec<_> = hierarchy.parts().iter().map(|part| moments(part)).collect();
        for count in [200, 60, 10] {
            hierarchy.merge_to(count);
            assert_eq!(hierarchy.count(), count);
            for (part, before) in hierarchy.parts().iter().zip(&before) {
                let after = moments(part);
                let covariance = (after.2 - before.2).to_cols_array();
                let off = covariance.iter().fold(0.0f64, |max, v| max.max(v.abs()));
                assert!(
                    (after.0 - before.0).abs() < 1e-9 && off < 1e-9,
                    "{count}: {off}"
                );
                assert!(after.1.distance(before.1) < 1e-9 && after.3.distance(before.3) < 1e-9);
            }
        }
        let members = |part: &Vec<Blob>| {
            let mut all: Vec<u32> = part.iter().flat_map(|b| b.members.clone()).collect();
            all.sort_unstable();
            all
        };
        let parts: Vec<Vec<u32>> = hierarchy.parts().iter().map(members).collect();
        let expected: [Vec<u32>; 4] = [(0..300).collect(), vec![], (300..420).collect(), vec![420]];
        assert_eq!(parts, expected);
        // One a part is the end.
        hierarchy.merge_to(1);
        assert_eq!(hierarchy.count(), 3);
    }

    #[test]
    fn a_round_merges_a_quarter_at_most() {
        let mut hierarchy = hierarchy(&mut Random::new(2, 0));
        let before = hierarchy.count();
        let merged = hierarchy.round((ROUND * before as f64) as usize);
        assert!(
            merged > before / 5 && merged <= before / 4,
            "{merged} of {before}"
        );
        assert_eq!(hierarchy.count(), before - merged);
        // No Gaussian is of more than two after one round.
        assert!(
            hierarchy
                .parts()
                .iter()
                .flatten()
                .all(|b| b.members.len() <= 2)
        );
    }

    #[test]
    fn gaussians_in_one_place_can_be_merged() {
        let random = &mut Random::new(3, 0);
        let mut same: Vec<Blob> = (0..500).map(|at| blob(random, at, DVec3::ZERO)).collect();
        for (at, blob) in same.iter_mut().enumerate() {
            // In a plane, and half of them in a single point.
            blob.mean.y = 0.0;
            if at % 2 == 0 {
                blob.mean = DVec3::ZERO;
            }
            blob.seen = 0.0;
        }
        let mut hierarchy = MergeTree::new(vec![same], 1.0);
        hierarchy.merge_to(5);
        assert_eq!(hierarchy.count(), 5);
    }

    #[test]
    fn axes_are_those_of_the_covariance() {
        let random = &mut Random::new(4, 0);
        for deviations in [
            DVec3::new(0.02, 0.01, 1e-5),
            DVec3::splat(0.01),
            DVec3::new(0.01, 0.0, 0.0),
        ] {
            let turn = DMat3::from_quat(glam::DQuat::from_scaled_axis(random.direction()));
            let axes = turn * DMat3::from_diagonal(deviations);
            let covariance = axes * axes.transpose();
            let found = CovarianceAxes::new(covariance);
            let again =
                found.rotation * DMat3::from_diagonal(found.variance) * found.rotation.transpose();
            let off = (again - covariance).to_cols_array();
            assert!(off.iter().all(|v| v.abs() < 1e-12), "{off:?}");
            assert!((found.rotation.determinant() - 1.0).abs() < 1e-9);
            assert!(found.variance.x >= found.variance.y && found.variance.y >= found.variance.z);
        }
        let none = CovarianceAxes::new(DMat3::ZERO);
        assert!(none.variance == DVec3::ZERO && none.rotation.is_finite());
    }
}
