//! A level's arrays from what was merged.

use super::merge::{Blob, CovarianceAxes, area};
use effigy_core::avatar::{Avatar, Gaussians, Level, Matrix, Rows, ShCoefficients, matrix::Row};
use effigy_core::reference::{basis::combine, mlp, project};
use effigy_math::weights::weight_bytes;
use glam::{DMat3, DQuat, DVec3};
use half::f16;
use rayon::prelude::*;

/// Smallest standard deviation of a merged Gaussian, metres.
const THINNEST: f64 = 1e-5;

/// Blobs of every part before the first merge. `seen`: pixels that each Gaussian contributed to
/// images; `posed`: its centre in some poses, metres.
pub fn blobs(avatar: &Avatar, seen: &[f64], posed: &[Vec<DVec3>]) -> Vec<Vec<Blob>> {
    let blob = |k: usize| Blob {
        mass: mass(avatar, k),
        seen: seen[k],
        mean: avatar.position(k),
        covariance: covariance(avatar, k),
        color: DVec3::from(avatar.gaussians.color[k].map(f64::from)),
        posed: posed.iter().map(|pose| pose[k]).collect(),
        members: vec![k as u32],
    };
    avatar
        .parts
        .start
        .windows(2)
        .map(|ends| (ends[0] as usize..ends[1] as usize).map(blob).collect())
        .collect()
}

/// A member of a merged Gaussian and its share of the mass.
struct MergedMember {
    gaussian: usize,
    share: f64,
}

/// A merged Gaussian's members.
struct Members {
    /// Opacity times area, m²: the sum of theirs.
    mass: f64,
    all: Vec<MergedMember>,
}

impl Members {
    fn new(avatar: &Avatar, members: &[u32]) -> Self {
        let masses: Vec<f64> = members.iter().map(|&k| mass(avatar, k as usize)).collect();
        let sum: f64 = masses.iter().sum();
        let member = |(&gaussian, mass): (&u32, &f64)| MergedMember {
            gaussian: gaussian as usize,
            share: if sum > 0.0 {
                mass / sum
            } else {
                1.0 / masses.len() as f64
            },
        };
        Self {
            mass: sum,
            all: members.iter().zip(&masses).map(member).collect(),
        }
    }

    /// The mean of something.
    fn mean(&self, of: impl Fn(usize) -> DVec3) -> DVec3 {
        self.all
            .iter()
            .map(|member| member.share * of(member.gaussian))
            .sum()
    }

    /// The mixture's covariance around its mean, m².
    fn covariance(&self, avatar: &Avatar, mean: DVec3) -> DMat3 {
        let mut sum = DMat3::ZERO;
        for member in &self.all {
            let offset = avatar.position(member.gaussian) - mean;
            let outer = DMat3::from_cols(offset * offset.x, offset * offset.y, offset * offset.z);
            sum += member.share * (covariance(avatar, member.gaussian) + outer);
        }
        sum
    }

    /// The four joints that weigh most.
    fn joints(&self, avatar: &Avatar) -> [Weighed<u8>; 4] {
        let gaussians = &avatar.gaussians;
        let pairs = self.all.iter().flat_map(|member| {
            let k = member.gaussian;
            (0..4).map(move |at| Weighed {
                item: gaussians.joint[k][at],
                weight: member.share * f64::from(gaussians.joint_weight[k][at]) / 255.0,
            })
        });
        largest(pairs.collect())
    }

    /// The three nodes that weigh most.
    fn nodes(&self, avatar: &Avatar) -> [u16; 3] {
        let pairs = self.all.iter().flat_map(|member| {
            let k = member.gaussian;
            let weights = avatar.node_weights(k);
            (0..3).map(move |at| Weighed {
                item: avatar.gaussians.node[k][at],
                weight: member.share * weights[at],
            })
        });
        largest(pairs.collect()).map(|node| node.item)
    }
}

/// Standard deviations of a Gaussian along its axes, metres.
fn deviations(avatar: &Avatar, gaussian: usize) -> DVec3 {
    DVec3::from(avatar.gaussians.log_scale[gaussian].map(f64::from)).exp()
}

/// A Gaussian's opacity times its area, m².
fn mass(avatar: &Avatar, gaussian: usize) -> f64 {
    f64::from(avatar.gaussians.opacity[gaussian]) / 255.0 * area(deviations(avatar, gaussian))
}

/// A Gaussian's covariance in canonical space, m².
fn covariance(avatar: &Avatar, gaussian: usize) -> DMat3 {
    let rotation = avatar.gaussians.rotation[gaussian].map(f64::from);
    let rotation = DMat3::from_quat(project::rotation(rotation, [0.0; 4]));
    let axes = rotation * DMat3::from_diagonal(deviations(avatar, gaussian));
    axes * axes.transpose()
}

/// Something and its weight.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Weighed<T> {
    item: T,
    weight: f64,
}

/// The `N` of some items that weigh most, with weights that sum to 1, the heaviest first; too few
/// are filled up with weights of 0.
fn largest<const N: usize, T: Copy + Ord + Default>(mut all: Vec<Weighed<T>>) -> [Weighed<T>; N] {
    all.sort_by_key(|weighed| weighed.item);
    all.dedup_by(|next, kept| {
        let same = next.item == kept.item;
        if same {
            kept.weight += next.weight;
        }
        same
    });
    all.sort_by(|a, b| b.weight.total_cmp(&a.weight).then(a.item.cmp(&b.item)));
    all.truncate(N);
    let sum: f64 = all.iter().map(|weighed| weighed.weight).sum();
    let first = all.first().map_or(T::default(), |first| first.item);
    std::array::from_fn(|at| Weighed {
        item: all.get(at).map_or(first, |weighed| weighed.item),
        weight: match all.get(at) {
            Some(weighed) if sum > 0.0 => weighed.weight / sum,
            _ => f64::from(u8::from(sum <= 0.0 && at == 0)),
        },
    })
}

/// A merged Gaussian's numbers as an avatar stores them.
struct Merged {
    position: [u16; 3],
    rotation: [f16; 4],
    log_scale: [f16; 3],
    color: [f16; 3],
    opacity: u8,
    joint: [u8; 4],
    joint_weight: [u8; 4],
    node: [u16; 3],
    /// Of each function from degree 1 up.
    sh: Vec<[f16; 3]>,
}

fn half<const N: usize>(numbers: [f64; N]) -> [f16; N] {
    numbers.map(f16::from_f64)
}

fn merged(avatar: &Avatar, members: &Members) -> Merged {
    let gaussians = &avatar.gaussians;
    let mean = members.mean(|k| avatar.position(k));
    let axes = CovarianceAxes::new(members.covariance(avatar, mean));
    let deviations = DVec3::from(axes.variance.to_array().map(|v| v.sqrt().max(THINNEST)));
    let rotation = DQuat::from_mat3(&axes.rotation);
    let color = members.mean(|k| DVec3::from(gaussians.color[k].map(f64::from)));
    let joints = members.joints(avatar);
    let sh = avatar.sh.as_ref().map_or(vec![], |sh| {
        let count = sh.functions();
        let function = |f: usize| {
            let mean = members.mean(|k| DVec3::from(sh.coefficients[k * count + f].map(f64::from)));
            half(mean.to_array())
        };
        (0..count).map(function).collect()
    });
    Merged {
        position: gaussians.bounds.encode(mean),
        rotation: half([rotation.w, rotation.x, rotation.y, rotation.z]),
        log_scale: half(deviations.to_array().map(f64::ln)),
        color: half(color.to_array()),
        opacity: (255.0 * (members.mass / area(deviations)).min(1.0)).round() as u8,
        joint: joints.map(|joint| joint.item),
        joint_weight: weight_bytes(joints.map(|joint| joint.weight)),
        node: members.nodes(avatar),
        sh,
    }
}

/// The level of what was merged of each part. `color_rows`: how many correctives of the colour it
/// keeps.
///
/// Correctives of rotation and scale stay behind: images of all Gaussians without them are as near
/// to supersampled ones, to 0.1 dB, at every size that a level is for (docs/experiments/045).
pub fn level(avatar: &Avatar, parts: &[Vec<Blob>], color_rows: usize) -> Level {
    let mut start = vec![0];
    for blobs in parts {
        start.push(start[start.len() - 1] + blobs.len() as u32);
    }
    let blobs: Vec<&Blob> = parts.iter().flatten().collect();
    let members: Vec<Members> = blobs
        .par_iter()
        .map(|blob| Members::new(avatar, &blob.members))
        .collect();
    let all: Vec<Merged> = members
        .par_iter()
        .map(|members| merged(avatar, members))
        .collect();
    let sh = avatar.sh.as_ref().map(|sh| ShCoefficients {
        degree: sh.degree,
        coefficients: all.iter().flat_map(|merged| merged.sh.clone()).collect(),
    });
    Level {
        correctives: !avatar.networks.layers.is_empty(),
        rotation_rows: no_rows(&avatar.rotation_rows),
        scale_rows: no_rows(&avatar.scale_rows),
        color_rows: mean_rows(avatar, &blobs, &members, &start, color_rows),
        gaussians: Gaussians {
            bounds: avatar.gaussians.bounds,
            position: all.iter().map(|merged| merged.position).collect(),
            rotation: all.iter().map(|merged| merged.rotation).collect(),
            log_scale: all.iter().map(|merged| merged.log_scale).collect(),
            color: all.iter().map(|merged| merged.color).collect(),
            opacity: all.iter().map(|merged| merged.opacity).collect(),
            joint: all.iter().map(|merged| merged.joint).collect(),
            joint_weight: all.iter().map(|merged| merged.joint_weight).collect(),
            node: all.iter().map(|merged| merged.node).collect(),
            facing: vec![],
        },
        part_start: start,
        sh,
        measured: vec![],
    }
}

/// No rows, of the same kind.
pub fn no_rows<const C: usize>(rows: &Rows<C>) -> Rows<C> {
    Rows {
        gaussian: vec![],
        basis: rows.basis.pick(&[], 0),
    }
}

/// A basis row of a merged Gaussian, and what images would lose without it.
struct MeanRow {
    gaussian: u32,
    numbers: Vec<f16>,
    cost: f64,
}

/// Rows of colour: the means of the members', where one without a row has zeros. Only the `count`
/// that vary most over typical poses are kept, weighed by how much images show of their Gaussians.
fn mean_rows(
    avatar: &Avatar,
    blobs: &[&Blob],
    members: &[Members],
    start: &[u32],
    count: usize,
) -> Rows<3> {
    let rows = &avatar.color_rows;
    let basis = avatar.basis_len();
    if rows.gaussian.is_empty() || count == 0 {
        return no_rows(rows);
    }
    let features: Vec<Vec<f64>> = avatar
        .inputs
        .typical()
        .iter()
        .map(|input| mlp::features(avatar, input))
        .collect();
    let mean_row = |gaussian: usize| {
        let mut numbers = vec![0.0; 3 * basis];
        let mut any = false;
        for member in &members[gaussian].all {
            if let Ok(row) = rows.gaussian.binary_search(&(member.gaussian as u32)) {
                any = true;
                for (sum, own) in numbers
                    .iter_mut()
                    .zip(rows.basis.row(row, 3 * basis).iter())
                {
                    *sum += member.share * own;
                }
            }
        }
        let part = start.partition_point(|&start| start as usize <= gaussian) - 1;
        let numbers: Vec<f16> = numbers.into_iter().map(f16::from_f64).collect();
        any.then(|| MeanRow {
            gaussian: gaussian as u32,
            cost: blobs[gaussian].seen
                * features
                    .iter()
                    .map(|features| {
                        let e = &features[part * avatar.networks.output()..][..basis];
                        let change: [f64; 3] = combine(Row::Halves(&numbers), e);
                        change.iter().map(|v| v * v).sum::<f64>()
                    })
                    .sum::<f64>(),
            numbers,
        })
    };
    let mut all: Vec<MeanRow> = (0..members.len())
        .into_par_iter()
        .filter_map(mean_row)
        .collect();
    all.sort_by(|a, b| b.cost.total_cmp(&a.cost).then(a.gaussian.cmp(&b.gaussian)));
    all.truncate(count);
    all.sort_by_key(|row| row.gaussian);
    let matrix: Matrix = all.iter().flat_map(|row| &row.numbers).copied().collect();
    Rows {
        gaussian: all.iter().map(|row| row.gaussian).collect(),
        basis: if rows.basis.is_bytes() {
            matrix.bytes(3 * basis)
        } else {
            matrix
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::levels::merge::MergeTree;

    #[test]
    fn the_heaviest_stay_with_a_sum_of_1() {
        let weighed = |item: u8, weight| Weighed { item, weight };
        let all = vec![
            weighed(5, 0.2),
            weighed(3, 0.5),
            weighed(5, 0.2),
            weighed(9, 0.1),
        ];
        let got: [Weighed<u8>; 2] = largest(all.clone());
        assert_eq!([got[0].item, got[1].item], [3, 5]);
        assert!(
            (got[0].weight - 5.0 / 9.0).abs() < 1e-12 && (got[1].weight - 4.0 / 9.0).abs() < 1e-12
        );
        let got: [Weighed<u8>; 4] = largest(all);
        assert_eq!(got[3], weighed(3, 0.0));
        let got: [Weighed<u8>; 2] = largest(vec![weighed(4, 0.0), weighed(2, 0.0)]);
        assert_eq!(got, [weighed(2, 1.0), weighed(4, 0.0)]);
    }

    #[test]
    fn what_is_merged_keeps_its_mass_and_is_a_valid_level() {
        let avatar = effigy_demo::avatar().expect("inside the program");
        let seen = vec![1.0; avatar.gaussians.len()];
        let mut hierarchy = MergeTree::new(blobs(&avatar, &seen, &[]), 1.7);
        let count = avatar.gaussians.len() / 4;
        hierarchy.merge_to(count);
        let level = level(&avatar, hierarchy.parts(), 50);
        assert_eq!(
            (level.gaussians.len(), level.color_rows.gaussian.len()),
            (count, 50)
        );
        for (k, blob) in hierarchy.parts().iter().flatten().enumerate() {
            let deviations = DVec3::from(level.gaussians.log_scale[k].map(f64::from)).exp();
            let opacity = f64::from(level.gaussians.opacity[k]) / 255.0;
            let expected = (blob.mass / area(deviations)).min(1.0);
            assert!(
                (opacity - expected).abs() < 0.01,
                "{opacity}, expected {expected}"
            );
            let step = avatar.gaussians.bounds.step().length();
            let position = avatar.gaussians.bounds.decode(level.gaussians.position[k]);
            assert!(position.distance(blob.mean) <= step);
        }
        let levelled = Avatar {
            levels: vec![level],
            ..avatar
        };
        assert_eq!(levelled.check(), Ok(()));
    }
}
