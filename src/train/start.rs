//! The avatar that a training begins with: Gaussians spread evenly on a template, grey, with small
//! random bases.

use effigy_capture::{Template, VertexInfluence};
use effigy_core::avatar::{
    Activation, Avatar, Bounds, Filter, Gaussians, Inputs, NetworkLayer, Networks, Nodes, Parts,
    Pose, Rows,
};
use effigy_core::layout::TRAIN_BASIS;
use effigy_core::random::Random;
use effigy_math::partition::divide;
use effigy_math::pca::pca;
use effigy_math::spacing::{Dart, choose};
use effigy_math::weights::weight_bytes;
use glam::{DMat3, DQuat, DVec3};
use half::f16;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::num::NonZero;

/// Points thrown for each that is kept.
const DARTS: f64 = 9.0;
/// Basis rows begin as one random row of numbers within ± this.
const BASIS_RANGE: f64 = 0.002;
/// Principal components of the poses and expressions that the file keeps.
const COMPONENTS: usize = 20;
/// Streams of random numbers.
const NETWORK_STREAM: u64 = 1 << 32;
const BASIS_STREAM: u64 = 2 << 32;

/// How much of everything a training begins with.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sizes {
    /// N_g.
    pub gaussians: usize,
    /// N_G: parts, each with a network.
    pub parts: usize,
    /// N_s: position nodes.
    pub nodes: usize,
    /// Neurons of a hidden layer.
    pub hidden: usize,
    /// How many times as dense Gaussians stand on the head.
    pub head_density: f64,
    /// Opacity of every Gaussian.
    pub opacity: f64,
    /// Thickness of a Gaussian across the surface, of its width along it.
    pub thickness: f64,
}

/// A point of the template.
struct Point {
    /// Canonical, metres.
    position: DVec3,
    normal: DVec3,
    /// The largest first.
    influences: Vec<VertexInfluence>,
    on_head: bool,
}

/// The avatar that a training begins with. `poses`: those of the training's frames, whose principal
/// components it keeps.
///
/// # Panics
/// When a size is 0.
pub fn start(
    template: &Template,
    poses: &[Pose],
    sizes: &Sizes,
    filter: Filter,
    seed: u64,
) -> Avatar {
    let points = spread(template, sizes, seed);
    let positions: Vec<DVec3> = points.iter().map(|point| point.position).collect();
    let parts = divide(&positions, sizes.parts, |own| {
        2 * own.iter().filter(|&&k| points[k].on_head).count() > own.len()
    });
    let points: Vec<&Point> = parts.order.iter().map(|&k| &points[k]).collect();
    let positions: Vec<DVec3> = points.iter().map(|point| point.position).collect();
    let part_of = |k: usize| parts.start.partition_point(|&start| start as usize <= k) - 1;
    let bounds = Bounds::around(positions.iter());
    let darts: Vec<Dart> = points
        .iter()
        .map(|point| dart(point.position, point.on_head, sizes))
        .collect();
    let mut chosen = choose(&darts, sizes.nodes.min(points.len())).indices;
    chosen.sort_unstable();
    let node_places: Vec<[f64; 3]> = chosen.iter().map(|&k| positions[k].to_array()).collect();
    let inputs = inputs(template, poses);
    let rows = || (0..points.len() as u32).collect::<Vec<u32>>();
    let shared = shared_row(seed);
    Avatar {
        name: String::new(),
        credit: String::new(),
        skeleton: template.skeleton.clone(),
        gaussians: gaussians(&points, &positions, bounds, &node_places, sizes),
        networks: networks(sizes, parts.start.len() - 1, inputs.len(), seed),
        rotation_rows: Rows {
            gaussian: rows(),
            basis: repeated(&shared, 4 * points.len()).into(),
        },
        scale_rows: Rows {
            gaussian: rows(),
            basis: repeated(&shared, 3 * points.len()).into(),
        },
        color_rows: Rows {
            gaussian: rows(),
            basis: repeated(&shared, 3 * points.len()).into(),
        },
        nodes: Nodes {
            position: chosen
                .iter()
                .map(|&k| bounds.encode(positions[k]))
                .collect(),
            part: chosen.iter().map(|&k| part_of(k) as u16).collect(),
            offset: vec![[f16::ZERO; 3]; chosen.len()],
            basis: repeated(&shared, 3 * chosen.len()).into(),
        },
        parts: Parts {
            start: parts.start,
            head: parts.head,
        },
        inputs,
        sh: None,
        filter,
        levels: vec![],
    }
}

/// Points on the template in its canonical pose, a Poisson-disk set.
fn spread(template: &Template, sizes: &Sizes, seed: u64) -> Vec<Point> {
    let canonical = Pose {
        rotation: template
            .skeleton
            .canonical
            .iter()
            .map(|axis| DVec3::from(axis.map(f64::from)))
            .collect(),
        ..Pose::rest(template.skeleton.len(), 0)
    };
    let vertices = template.posed(&canonical);
    let corners = |triangle: &[u32; 3]| triangle.map(|v| vertices[v as usize]);
    let share = |triangle: &[u32; 3]| {
        let [a, b, c] = corners(triangle);
        0.5 * (b - a).cross(c - a).length()
    };
    let area: f64 = template.triangles.iter().map(share).sum();
    // Denser on the head by thinning out what is thrown elsewhere.
    let most = sizes.head_density.max(1.0);
    let scale = DARTS * most * sizes.gaussians as f64 / area;
    let mut thrown: Vec<(Dart, Point)> = template
        .triangles
        .par_iter()
        .enumerate()
        .flat_map_iter(|(number, triangle)| {
            let mut random = Random::new(seed, number as u64);
            let [a, b, c] = corners(triangle);
            let normal = (b - a).cross(c - a).normalize_or(DVec3::Y);
            let count = (scale * share(triangle) + random.uniform()).floor() as usize;
            let mut own = Vec::new();
            for _ in 0..count {
                let u = random.uniform().sqrt();
                let v = random.uniform();
                let weights = [1.0 - u, u * (1.0 - v), u * v];
                let influences = blended(template, triangle, weights);
                let on_head = head_share(template, &influences) > 0.5;
                let density = if on_head { sizes.head_density } else { 1.0 };
                if random.uniform() * most < density {
                    let position = weights[0] * a + weights[1] * b + weights[2] * c;
                    let point = Point {
                        position,
                        normal,
                        influences,
                        on_head,
                    };
                    own.push((dart(position, on_head, sizes), point));
                }
            }
            own
        })
        .collect();
    let mut random = Random::new(seed, u64::MAX);
    for i in (1..thrown.len()).rev() {
        let other = (random.uniform() * (i + 1) as f64) as usize;
        thrown.swap(i, other);
    }
    let darts: Vec<Dart> = thrown.iter().map(|(dart, _)| *dart).collect();
    let mut kept: Vec<Option<Point>> = thrown.into_iter().map(|(_, point)| Some(point)).collect();
    let chosen = choose(&darts, sizes.gaussians.min(darts.len()));
    chosen
        .indices
        .iter()
        .filter_map(|&at| kept[at].take())
        .collect()
}

fn dart(position: DVec3, on_head: bool, sizes: &Sizes) -> Dart {
    Dart {
        position,
        density: if on_head { sizes.head_density } else { 1.0 },
        layer: 0,
    }
}

/// The joints that move a place of a triangle, the strongest first.
fn blended(template: &Template, triangle: &[u32; 3], weights: [f64; 3]) -> Vec<VertexInfluence> {
    let mut sums: Vec<VertexInfluence> = Vec::new();
    for (&vertex, share) in triangle.iter().zip(weights) {
        for influence in &template.weights[vertex as usize] {
            let weight = influence.weight * share as f32;
            match sums.iter_mut().find(|known| known.joint == influence.joint) {
                Some(known) => known.weight += weight,
                None => sums.push(VertexInfluence {
                    weight,
                    ..*influence
                }),
            }
        }
    }
    sums.sort_by(|a, b| b.weight.total_cmp(&a.weight).then(a.joint.cmp(&b.joint)));
    sums
}

fn head_share(template: &Template, influences: &[VertexInfluence]) -> f32 {
    let is_head = |influence: &&VertexInfluence| template.head_joints.contains(&influence.joint);
    influences.iter().filter(is_head).map(|i| i.weight).sum()
}

fn gaussians(
    points: &[&Point],
    positions: &[DVec3],
    bounds: Bounds,
    nodes: &[[f64; 3]],
    sizes: &Sizes,
) -> Gaussians {
    const THREE: NonZero<usize> = NonZero::new(3).expect("3 is not 0");
    const FOUR: NonZero<usize> = NonZero::new(4).expect("4 is not 0");
    let places: Vec<[f64; 3]> = positions.iter().map(|p| p.to_array()).collect();
    let tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(&places);
    let node_tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(nodes);
    let width = |place: &[f64; 3]| {
        // Itself and its three neighbours.
        let found = tree.nearest_n::<SquaredEuclidean>(place, FOUR);
        let sum: f64 = found.iter().map(|near| near.distance).sum();
        (sum / (found.len().max(2) - 1) as f64).sqrt().max(1e-5)
    };
    let log_scale = |place: &[f64; 3]| {
        let width = width(place);
        [width, width, sizes.thickness * width].map(|s| f16::from_f64(s.ln()))
    };
    let rotation = |point: &&Point| {
        let across = point.normal.any_orthonormal_vector();
        let axes = DMat3::from_cols(across, point.normal.cross(across), point.normal);
        let q = DQuat::from_mat3(&axes).normalize();
        [q.w, q.x, q.y, q.z].map(f16::from_f64)
    };
    let node = |place: &[f64; 3]| {
        let found = node_tree.nearest_n::<SquaredEuclidean>(place, THREE);
        std::array::from_fn(|k| found[k.min(found.len() - 1)].item as u16)
    };
    let weights = |point: &&Point| {
        let own = &point.influences[..point.influences.len().min(4)];
        let sum: f32 = own.iter().map(|influence| influence.weight).sum();
        let share = |k: usize| own.get(k).map_or(0.0, |i| f64::from(i.weight / sum));
        weight_bytes(std::array::from_fn(share))
    };
    Gaussians {
        bounds,
        position: positions.iter().map(|&p| bounds.encode(p)).collect(),
        rotation: points.iter().map(rotation).collect(),
        log_scale: places.par_iter().map(log_scale).collect(),
        color: vec![[f16::from_f64(0.5); 3]; points.len()],
        opacity: vec![(255.0 * sizes.opacity).round() as u8; points.len()],
        joint: points
            .iter()
            .map(|point| {
                std::array::from_fn(|k| point.influences.get(k).map_or(0, |own| own.joint))
            })
            .collect(),
        joint_weight: points.iter().map(weights).collect(),
        node: places.par_iter().map(node).collect(),
        facing: vec![],
    }
}

fn inputs(template: &Template, poses: &[Pose]) -> Inputs {
    let mut inputs = Inputs {
        joint: template.input_joints.clone(),
        expression: template.expression,
        pose_space: None,
        expression_space: None,
    };
    let rows: Vec<Vec<f64>> = poses.iter().map(|pose| inputs.unprojected(pose)).collect();
    let split = 3 * inputs.joint.len();
    let part = |range: std::ops::Range<usize>| {
        let own: Vec<Vec<f64>> = rows.iter().map(|row| row[range.clone()].to_vec()).collect();
        Some(pca(&own, range.len(), COMPONENTS)).filter(|space| !space.sigma.is_empty())
    };
    inputs.pose_space = part(0..split);
    if inputs.expression > 0 {
        inputs.expression_space = part(split..inputs.len());
    }
    inputs
}

/// Networks as PyTorch begins them: uniform within ±1/√n of n inputs.
fn networks(sizes: &Sizes, parts: usize, input: usize, seed: u64) -> Networks {
    let hidden = sizes.hidden;
    let widths = [input, hidden, hidden, hidden, 2 * TRAIN_BASIS as usize];
    let layer = |l: usize| {
        let [input, output] = [widths[l], widths[l + 1]];
        let reach = 1.0 / (input.max(1) as f64).sqrt();
        let mut random = Random::new(seed, NETWORK_STREAM + l as u64);
        let mut numbers = |count: usize| -> Vec<f16> {
            (0..count)
                .map(|_| f16::from_f64(random.range(-reach, reach)))
                .collect()
        };
        NetworkLayer {
            input,
            output,
            weight: numbers(parts * input * output).into(),
            bias: numbers(parts * output),
        }
    };
    Networks {
        activation: Activation::LeakyRelu,
        layers: (0..widths.len() - 1).map(layer).collect(),
    }
}

/// The row of numbers that every basis begins as.
fn shared_row(seed: u64) -> Vec<f16> {
    let mut random = Random::new(seed, BASIS_STREAM);
    (0..TRAIN_BASIS)
        .map(|_| f16::from_f64(random.range(-BASIS_RANGE, BASIS_RANGE)))
        .collect()
}

fn repeated(row: &[f16], times: usize) -> Vec<f16> {
    row.iter()
        .copied()
        .cycle()
        .take(row.len() * times)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_core::avatar::Skeleton;

    /// A tube of two joints, the upper of which is the head.
    fn tube() -> Template {
        const SIDES: u32 = 12;
        const RINGS: u32 = 9;
        let mut vertices = Vec::new();
        let mut weights = Vec::new();
        for ring in 0..RINGS {
            let y = 0.2 * f64::from(ring);
            for side in 0..SIDES {
                let angle = f64::from(side) * std::f64::consts::TAU / f64::from(SIDES);
                vertices.push(DVec3::new(0.2 * angle.cos(), y, 0.2 * angle.sin()));
                let upper = (y as f32 - 0.7).clamp(0.0, 0.2) / 0.2;
                let both = [(0, 1.0 - upper), (1, upper)];
                let own = both.into_iter().filter(|(_, weight)| *weight > 0.0);
                weights.push(
                    own.map(|(joint, weight)| VertexInfluence { joint, weight })
                        .collect(),
                );
            }
        }
        let mut triangles = Vec::new();
        for ring in 0..RINGS - 1 {
            for side in 0..SIDES {
                let next = (side + 1) % SIDES;
                let [a, b] = [ring * SIDES + side, ring * SIDES + next];
                triangles.push([a, a + SIDES, b]);
                triangles.push([b, a + SIDES, b + SIDES]);
            }
        }
        Template {
            skeleton: Skeleton {
                name: vec!["root".into(), "head".into()],
                parent: vec![None, Some(0)],
                rest: vec![[0.0; 3], [0.0, 0.8, 0.0]],
                canonical: vec![[0.0; 3], [0.0, 0.0, 0.3]],
            },
            vertices,
            triangles,
            weights,
            input_joints: vec![1],
            head_joints: vec![1],
            expression: 2,
        }
    }

    fn sizes() -> Sizes {
        Sizes {
            gaussians: 900,
            parts: 6,
            nodes: 80,
            hidden: 8,
            head_density: 3.0,
            opacity: 0.8,
            thickness: 0.3,
        }
    }

    fn poses() -> Vec<Pose> {
        (0..9)
            .map(|k| {
                let mut pose = Pose::rest(2, 2);
                pose.rotation[1].x = 0.1 * f64::from(k);
                pose.expression[0] = f64::from(k % 2);
                pose
            })
            .collect()
    }

    #[test]
    fn gaussians_stand_evenly_on_the_template_and_the_head_comes_first() {
        let avatar = start(&tube(), &poses(), &sizes(), Filter::ANTIALIASED, 3);
        avatar.check().unwrap();
        assert_eq!(avatar.gaussians.len(), 900);
        assert_eq!((avatar.parts.len(), avatar.nodes.len()), (6, 80));
        assert!(
            (1..6).contains(&avatar.parts.head),
            "{} parts of the head",
            avatar.parts.head
        );
        let places: Vec<[f64; 3]> = (0..900).map(|k| avatar.position(k).to_array()).collect();
        let tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(&places);
        let two = NonZero::new(2).unwrap();
        let on_head = |k: usize| avatar.gaussians.joint[k][0] == 1;
        let apart = |head: bool| {
            let own: Vec<f64> = (0..900)
                .filter(|&k| on_head(k) == head)
                .map(|k| {
                    tree.nearest_n::<SquaredEuclidean>(&places[k], two)[1]
                        .distance
                        .sqrt()
                })
                .collect();
            own.iter().sum::<f64>() / own.len() as f64
        };
        // Three times as dense: √3 as near.
        let ratio = apart(false) / apart(true);
        assert!(
            (1.4..2.1).contains(&ratio),
            "{ratio} times as far apart off the head"
        );
        let upper = (0..900).filter(|&k| on_head(k)).count();
        assert!(upper > 500, "{upper} on the head");
        // A Gaussian's third axis is across the surface, which is round.
        for k in (0..900).filter(|&k| !on_head(k)).step_by(37) {
            let [w, x, y, z] = avatar.gaussians.rotation[k].map(f64::from);
            let across = DQuat::from_xyzw(x, y, z, w) * DVec3::Z;
            let [px, _, pz] = places[k];
            let out = DVec3::new(px, 0.0, pz).normalize();
            assert!(across.dot(out).abs() > 0.9, "{across} at {out}");
        }
        let space = avatar.inputs.pose_space.as_ref().unwrap();
        assert_eq!(space.sigma.len(), 1, "one direction varies");
    }

    #[test]
    fn equal_seeds_give_equal_avatars() {
        let make = |seed| start(&tube(), &poses(), &sizes(), Filter::DEFAULT, seed);
        assert!(make(5) == make(5) && make(5) != make(6));
    }

    #[test]
    fn more_parts_and_nodes_than_gaussians_are_as_many_as_there_can_be() {
        let few = Sizes {
            gaussians: 16,
            parts: 40,
            nodes: 50,
            ..sizes()
        };
        let avatar = start(&tube(), &poses(), &few, Filter::DEFAULT, 1);
        avatar.check().unwrap();
        assert!(avatar.parts.len() <= 16 && avatar.nodes.len() <= 16);
        assert_eq!(avatar.networks.layers[0].bias.len(), 8 * avatar.parts.len());
    }
}
