//! The avatar from evenly spaced points and their looks.

use crate::bake::bases::{Bases, PlacedPoint, retain_rows};
use crate::bake::body::{BakedBody, EXPRESSIONS, blend};
use crate::bake::credits::BODY_CREDIT;
use crate::bake::networks::{BASIS, NetworkPlan, random_networks};
use crate::bake::outfit::Outfit;
use crate::bake::partition::partition;
use crate::bake::sky_light::BakedSky;
use crate::bake::source::rig::{BODY, PointInfluence};
use crate::bake::spacing::Dot;
use crate::bake::stretch::Stretch;
use crate::bake::surface::{Material, Sheet, Site};
use effigy_core::avatar::{Avatar, Bounds, Filter, Gaussians, Inputs, Nodes, Parts, Pose, Rows};
use effigy_core::random::Random;
use effigy_math::color::encode_srgb;
use effigy_math::partition::Partition;
use effigy_math::spacing::{Dart, choose};
use effigy_math::{pca::pca, weights::weight_bytes};
use glam::{DAffine3, DMat3, DQuat, DVec3};
use half::f16;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rayon::prelude::*;
use std::num::NonZero;

/// How much of everything a baked avatar has.
#[derive(Clone, Debug)]
pub struct BakeSizes {
    /// N_g.
    pub gaussians: usize,
    /// N_G: body parts, each with a network.
    pub parts: usize,
    /// N_s: position nodes.
    pub nodes: usize,
    /// Gaussians that keep a corrective, for each of rotation, scale and colour.
    pub rows: usize,
    /// Decides points, networks and bases.
    pub seed: u64,
}

/// Principal components of the poses that the file keeps.
const POSE_COMPONENTS: usize = 20;
/// The networks' features are measured over at most so many poses.
const POSES: usize = 160;

/// A Gaussian to be, in the canonical pose.
struct GaussianPoint {
    placed: PlacedPoint,
    /// Standard deviations, metres.
    scale: DVec3,
    opacity: f64,
    weights: QuantisedWeights,
    /// From the rest pose.
    to_canonical: DMat3,
    /// See [`Outfit::density`].
    density: f64,
}

/// Puts the avatar together. Features, pruning, PCA and the Gaussians' shapes are fitted to
/// `poses`. `sheets`: what the dots are on.
pub fn assemble(
    body: &BakedBody,
    outfit: &Outfit,
    sheets: &[Sheet],
    sky: &BakedSky,
    dots: &[Dot],
    poses: &[Pose],
    sizes: &BakeSizes,
) -> Avatar {
    let to_canonical = body.to_canonical();
    let stretch = Stretch::new(sheets, &body.skeleton, &to_canonical, poses);
    let surroundings = Surroundings {
        outfit,
        sky,
        stretch: &stretch,
        to_canonical: &to_canonical,
    };
    let mut points: Vec<GaussianPoint> = dots
        .par_iter()
        .enumerate()
        .map(|(i, dot)| {
            let random = Random::new(sizes.seed, POINT_STREAM + i as u64);
            gaussian_point(dot, &surroundings, random)
        })
        .collect();
    let positions: Vec<DVec3> = points.iter().map(|point| point.placed.position).collect();
    let parts = assign_parts(&mut points, &positions, dots, sizes.parts);
    let bounds = bounds(&positions);
    let joints: Vec<DVec3> = to_canonical
        .iter()
        .zip(&body.skeleton.rest)
        .map(|(matrix, rest)| matrix.transform_point3(DVec3::from(rest.map(f64::from))))
        .collect();
    let bases = Bases::new(sizes.seed, &joints);
    let node_points = choose_nodes(&points, &parts, sizes.nodes);
    let nearest = nearest_nodes(&points, &node_points);
    let nodes = nodes(&points, &node_points, &bases, bounds);

    let inputs = inputs(poses);
    let network_inputs = network_inputs(&inputs, poses);
    let random = random_networks(&NetworkPlan {
        seed: sizes.seed,
        centers: &parts.center,
        head: parts.head,
        joints: &joints[1..=inputs.joint.len()],
        expression: inputs.expression,
        inputs: &network_inputs,
    });

    // From here on in the order of the parts.
    let ordered: Vec<&GaussianPoint> = parts.order.iter().map(|&i| &points[i]).collect();
    let nearest: Vec<[u16; 3]> = parts.order.iter().map(|&i| nearest[i]).collect();
    let retained = RowRetention {
        points: &ordered,
        covariances: &random.covariances,
        count: sizes.rows.min(points.len()),
    };
    Avatar {
        name: "MakeHuman body, dressed".into(),
        credit: BODY_CREDIT.into(),
        skeleton: body.skeleton.clone(),
        rotation_rows: retained.of(|point| bases.rotation_row(point)),
        scale_rows: retained.of(|point| bases.scale_row(point)),
        color_rows: retained.of(|point| bases.color_row(point)),
        gaussians: gaussians(&ordered, nearest, bounds),
        parts: Parts {
            start: parts.start,
            head: parts.head,
        },
        networks: random.networks,
        nodes,
        inputs,
        sh: None,
        // What it shows of each pixel's area is nearer by 9 dB than with that of 3DGS
        // (docs/experiments/074).
        filter: Filter::SUPERSAMPLED,
        levels: vec![],
    }
}

/// Divides points into parts, and tells each its own.
fn assign_parts(
    points: &mut [GaussianPoint],
    positions: &[DVec3],
    dots: &[Dot],
    count: usize,
) -> Partition {
    let sites: Vec<&Site> = dots.iter().map(|dot| &dot.site).collect();
    let parts = partition(positions, &sites, count);
    for part in 0..parts.center.len() {
        for &i in &parts.order[parts.range(part)] {
            points[i].placed.part = part;
            points[i].placed.head = part < parts.head;
        }
    }
    parts
}

/// Chooses the basis rows that are retained: `count` of each attribute.
struct RowRetention<'a> {
    /// In the order of the parts.
    points: &'a [&'a GaussianPoint],
    /// Of each part's features.
    covariances: &'a [Vec<f64>],
    count: usize,
}

impl RowRetention<'_> {
    /// `row`: a point's row of the attribute.
    fn of<const C: usize>(
        &self,
        row: impl Fn(&PlacedPoint) -> [[f64; BASIS]; C] + Sync,
    ) -> Rows<C> {
        let rows: Vec<_> = self
            .points
            .par_iter()
            .map(|point| row(&point.placed))
            .collect();
        let part: Vec<usize> = self.points.iter().map(|point| point.placed.part).collect();
        retain_rows(&rows, &part, self.covariances, self.count)
    }
}

/// Random numbers of each point begin here; other uses of the seed draw from other streams.
const POINT_STREAM: u64 = 1 << 40;

/// θ_p consists of the body joints but the hips. The expression has no subspace: a blink is so rare
/// that a clamp at 2σ would keep the eyes open.
fn inputs(poses: &[Pose]) -> Inputs {
    let mut inputs = Inputs {
        joint: (1..BODY.len() as u8).collect(),
        expression: EXPRESSIONS.len(),
        pose_space: None,
        expression_space: None,
    };
    let width = 3 * inputs.joint.len();
    let rows: Vec<Vec<f64>> = poses
        .iter()
        .map(|pose| inputs.from_pose(pose)[..width].to_vec())
        .collect();
    inputs.pose_space = Some(pca(&rows, width, POSE_COMPONENTS));
    inputs
}

/// θ_p ⊕ θ_e of some of the poses, evenly spaced.
fn network_inputs(inputs: &Inputs, poses: &[Pose]) -> Vec<Vec<f64>> {
    let stride = poses.len().div_ceil(POSES).max(1);
    poses
        .iter()
        .step_by(stride)
        .map(|pose| inputs.from_pose(pose))
        .collect()
}

/// Everything that the look of a point depends on.
struct Surroundings<'a> {
    outfit: &'a Outfit,
    sky: &'a BakedSky,
    stretch: &'a Stretch<'a>,
    /// Rest to canonical pose, one matrix a joint.
    to_canonical: &'a [DAffine3],
}

fn gaussian_point(dot: &Dot, surroundings: &Surroundings, mut random: Random) -> GaussianPoint {
    let outfit = surroundings.outfit;
    let mut site = dot.site.clone();
    site.footprint = dot.radius;
    let normal = outfit.relief_normal(&site);
    site.position += outfit.relief(&site, site.position) * site.normal;
    let color = shaded_color(outfit, &site, normal, dot.radius, surroundings.sky);
    let is_hair = matches!(site.material, Material::Hair | Material::Lash);
    let flow = if is_hair {
        outfit.face.hair_flow(&site)
    } else {
        normal.any_orthonormal_vector()
    };
    let weights = quantise(&site.weights);
    let matrix = blend(surroundings.to_canonical, &weights.exact());
    let normal = (matrix.matrix3 * normal).normalize_or(normal);
    // The Gaussian's first axis lies along the hair, its third along the normal.
    let first = (matrix.matrix3 * flow)
        .reject_from_normalized(normal)
        .normalize_or(normal.any_orthonormal_vector());
    let lift = if site.material == Material::Hair {
        random.range(-0.0015, 0.0035)
    } else {
        0.0
    };
    let density = outfit.density(&site);
    let mut shape = GaussianShape::new(site.material, density, dot.radius);
    let mut axes = DMat3::from_cols(first, normal.cross(first), normal);
    // Hair lies in many layers, and its Gaussians along its flow.
    if !is_hair {
        let tangents = [axes.x_axis, axes.y_axis];
        let ellipse = surroundings
            .stretch
            .ellipse(dot, tangents, &weights.exact());
        shape.scale.x *= ellipse.length.x;
        shape.scale.y *= ellipse.length.y;
        axes = ellipse.axes(tangents, normal);
    }
    let placed = PlacedPoint {
        position: matrix.transform_point3(site.position + lift * site.normal),
        normal,
        rotation: DQuat::from_mat3(&axes).normalize(),
        color,
        material: site.material,
        expression: site.expression,
        // Known once there are parts.
        part: 0,
        head: false,
    };
    GaussianPoint {
        placed,
        scale: shape.scale,
        opacity: shape.opacity,
        weights,
        to_canonical: matrix.matrix3,
        density,
    }
}

/// Display-referred colour: the light of the sky as the material reflects it.
fn shaded_color(outfit: &Outfit, site: &Site, normal: DVec3, radius: f64, sky: &BakedSky) -> DVec3 {
    let normal = site.material.light_normal().unwrap_or(normal);
    let light = sky.light(site.position, normal);
    encode_srgb(outfit.mean_albedo(site, radius) * site.material.scatter(light))
}

struct GaussianShape {
    /// Standard deviations, metres.
    scale: DVec3,
    opacity: f64,
}

impl GaussianShape {
    /// `radius`: the distance to the nearest other point, metres.
    fn new(material: Material, density: f64, radius: f64) -> Self {
        // Gaps are more visible than blur, except on face and emblem, where points are dense.
        let tangent = if density > 3.0 { 0.94 } else { 1.06 } * radius;
        let thickness = (0.35 * tangent).min(0.0008);
        match material {
            Material::Hair => Self {
                scale: DVec3::new(1.9 * tangent, 0.62 * tangent, thickness),
                opacity: 0.97,
            },
            Material::Lash => Self {
                scale: DVec3::new(0.8 * tangent, 0.35 * tangent, thickness),
                opacity: 0.7,
            },
            _ => Self {
                scale: DVec3::new(tangent, tangent, thickness),
                opacity: 1.0,
            },
        }
    }
}

/// The skin weights of a Gaussian as the file stores them.
#[derive(Clone, Copy, Debug)]
pub struct QuantisedWeights {
    /// The joint of each weight.
    pub joint: [u8; 4],
    /// Sum to 255.
    pub weight: [u8; 4],
}

impl QuantisedWeights {
    /// Joints with weights from 0 to 1.
    fn exact(&self) -> [PointInfluence; 4] {
        std::array::from_fn(|k| PointInfluence {
            joint: self.joint[k],
            weight: f64::from(self.weight[k]) / 255.0,
        })
    }
}

/// The four largest weights as bytes that sum to 255. `weights` fall.
pub fn quantise(weights: &[PointInfluence]) -> QuantisedWeights {
    let largest = &weights[..weights.len().min(4)];
    let sum: f64 = largest.iter().map(|influence| influence.weight).sum();
    let share = |k: usize| {
        largest
            .get(k)
            .map_or(0.0, |influence| influence.weight / sum)
    };
    QuantisedWeights {
        joint: std::array::from_fn(|k| largest.get(k).map_or(0, |influence| influence.joint)),
        weight: weight_bytes(std::array::from_fn(share)),
    }
}

/// The points that become nodes: evenly spaced, closer together on the head, in the order of the
/// parts.
fn choose_nodes(points: &[GaussianPoint], parts: &Partition, count: usize) -> Vec<usize> {
    let dart = |point: &GaussianPoint| Dart {
        position: point.placed.position,
        density: point.density.sqrt() * if point.placed.head { 5.0 } else { 1.0 },
        layer: point.placed.material as u8,
    };
    let darts: Vec<Dart> = points.iter().map(dart).collect();
    let mut chosen = choose(&darts, count.min(points.len())).indices;
    let mut rank = vec![0; points.len()];
    for (position, &i) in parts.order.iter().enumerate() {
        rank[i] = position;
    }
    chosen.sort_unstable_by_key(|&i| rank[i]);
    chosen
}

/// The nodes at some of the points.
fn nodes(points: &[GaussianPoint], chosen: &[usize], bases: &Bases, bounds: Bounds) -> Nodes {
    let own = || chosen.iter().map(|&i| &points[i]);
    Nodes {
        position: own()
            .map(|point| bounds.encode(point.placed.position))
            .collect(),
        part: own().map(|point| point.placed.part as u16).collect(),
        offset: vec![[f16::ZERO; 3]; chosen.len()],
        basis: own()
            .flat_map(|point| bases.node_row(&point.placed, point.to_canonical))
            .collect(),
    }
}

/// The three nearest nodes of each point. Nearness is measured with the mouth open and the layers
/// pulled apart: otherwise a lip would depend on the other lip's nodes, and skin on its shirt's.
fn nearest_nodes(points: &[GaussianPoint], nodes: &[usize]) -> Vec<[u16; 3]> {
    const LAYERS_APART: f64 = 0.03;
    const JAW_OPEN: usize = 0;
    const THREE: NonZero<usize> = NonZero::new(3).expect("3 is not 0");
    let place = |i: usize| {
        let placed = &points[i].placed;
        let p = placed.position + placed.expression[JAW_OPEN];
        let layer = LAYERS_APART * f64::from(placed.material as u8);
        [p.x, p.y, p.z, layer]
    };
    let places: Vec<[f64; 4]> = nodes.iter().map(|&i| place(i)).collect();
    let tree: ImmutableKdTree<f64, 4> = ImmutableKdTree::new_from_slice(&places);
    let find = |i: usize| {
        let found = tree.nearest_n::<SquaredEuclidean>(&place(i), THREE);
        std::array::from_fn(|k| found[k.min(found.len() - 1)].item as u16)
    };
    (0..points.len()).into_par_iter().map(find).collect()
}

fn bounds(positions: &[DVec3]) -> Bounds {
    let positions = || positions.iter().copied();
    let low = positions().fold(DVec3::INFINITY, DVec3::min);
    let high = positions().fold(DVec3::NEG_INFINITY, DVec3::max);
    Bounds {
        min: low.as_vec3().to_array(),
        max: high.as_vec3().to_array(),
    }
}

fn gaussians(points: &[&GaussianPoint], node: Vec<[u16; 3]>, bounds: Bounds) -> Gaussians {
    let half = |v: DVec3| v.to_array().map(f16::from_f64);
    let rotation = |point: &&GaussianPoint| {
        let q = point.placed.rotation;
        [q.w, q.x, q.y, q.z].map(f16::from_f64)
    };
    Gaussians {
        bounds,
        position: points
            .iter()
            .map(|point| bounds.encode(point.placed.position))
            .collect(),
        rotation: points.iter().map(rotation).collect(),
        log_scale: points
            .iter()
            .map(|point| half(DVec3::from(point.scale.to_array().map(f64::ln))))
            .collect(),
        color: points
            .iter()
            .map(|point| half(point.placed.color))
            .collect(),
        opacity: points
            .iter()
            .map(|point| (255.0 * point.opacity).round() as u8)
            .collect(),
        joint: points.iter().map(|point| point.weights.joint).collect(),
        joint_weight: points.iter().map(|point| point.weights.weight).collect(),
        node,
        facing: vec![],
    }
}
