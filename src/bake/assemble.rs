//! Evenly spaced points with their looks in; an avatar out.

use super::bases::{self, Bases, Placed};
use super::body::{Body, EXPRESSIONS, blend};
use super::light::Sky;
use super::math::{Random, encode_srgb};
use super::networks::{self, networks};
use super::outfit::Outfit;
use super::partition::{Partition, partition};
use super::pca::pca;
use super::spacing::{Dart, Dot, choose};
use super::surface::{Material, Site};
use crate::avatar::{Avatar, Bounds, Gaussians, Inputs, Nodes, Parts, Pose};
use glam::{DMat3, DQuat, DVec3};
use half::f16;
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rayon::prelude::*;
use std::num::NonZero;

/// How much there is to be of everything.
#[derive(Clone, Debug)]
pub struct Sizes {
    pub gaussians: usize,
    pub parts: usize,
    pub nodes: usize,
    /// Gaussians that keep a corrective, for each of rotation, scale and colour.
    pub rows: usize,
    pub seed: u64,
}

/// Principal components of the poses that the file keeps.
const COMPONENTS: usize = 20;
/// Poses that the networks' features are measured over.
const POSES: usize = 160;

/// A dot in the canonical pose with what its Gaussian needs.
struct Point {
    placed: Placed,
    scale: DVec3,
    opacity: f64,
    joint: [u8; 4],
    joint_weight: [u8; 4],
    /// Rest to canonical pose.
    turn: DMat3,
    density: f64,
}

/// Puts the avatar together; features, pruning and PCA are fitted to `poses`. Also which dot each of its Gaussians is.
pub fn assemble(body: &Body, outfit: &Outfit, sky: &Sky, dots: &[Dot], poses: &[Pose], sizes: &Sizes) -> (Avatar, Vec<usize>) {
    let canonical = body.to_canonical();
    let mut points: Vec<Point> = dots.par_iter().enumerate().map(|(i, dot)| point(dot, i, outfit, sky, &canonical, sizes.seed)).collect();
    let positions: Vec<DVec3> = points.iter().map(|point| point.placed.position).collect();
    let sites: Vec<_> = dots.iter().map(|dot| &dot.site).collect();
    let parts = partition(&positions, &sites, sizes.parts);
    for part in 0..parts.center.len() {
        for &i in &parts.order[parts.start[part] as usize..parts.start[part + 1] as usize] {
            points[i].placed.part = part;
            points[i].placed.head = part < parts.head;
        }
    }
    let nodes = choose_nodes(&points, &parts, sizes.nodes);
    let mut slots: Vec<Option<Point>> = points.into_iter().map(Some).collect();
    let nearest = nearest_nodes(&slots, &nodes);
    let bounds = bounds(&positions);
    let joints: Vec<DVec3> =
        canonical.iter().zip(&body.skeleton.rest).map(|(m, r)| m.transform_point3(DVec3::from(r.map(f64::from)))).collect();
    let field = Bases::new(sizes.seed, &joints);
    let node_rows = nodes.iter().map(|&i| slots[i].as_ref().expect("still in place"));
    let nodes = Nodes {
        position: node_rows.clone().map(|p| bounds.encode(p.placed.position)).collect(),
        part: node_rows.clone().map(|p| p.placed.part as u16).collect(),
        offset: vec![[f16::ZERO; 3]; nodes.len()],
        basis: node_rows.flat_map(|p| field.node(&p.placed, p.turn)).collect(),
    };
    let points: Vec<Point> = parts.order.iter().map(|&i| slots[i].take().expect("each index stands once in the order")).collect();
    let nearest: Vec<[u16; 3]> = parts.order.iter().map(|&i| nearest[i]).collect();
    let inputs = inputs(poses);
    let thetas = thetas(&inputs, poses);
    let plan = networks::Plan {
        seed: sizes.seed,
        centers: &parts.center,
        head: parts.head,
        joints: &joints[1..=inputs.joint.len()],
        expression: inputs.expression,
        inputs: &thetas,
    };
    let (networks, covariance) = networks(&plan);
    let part: Vec<usize> = points.iter().map(|p| p.placed.part).collect();
    let rows = sizes.rows.min(points.len());
    let avatar = Avatar {
        name: "MakeHuman body, dressed".into(),
        credit: super::BODY_CREDIT.into(),
        skeleton: body.skeleton.clone(),
        rotation_rows: bases::keep(&points.par_iter().map(|p| field.rotation(&p.placed)).collect::<Vec<_>>(), &part, &covariance, rows),
        scale_rows: bases::keep(&points.par_iter().map(|p| field.scale(&p.placed)).collect::<Vec<_>>(), &part, &covariance, rows),
        color_rows: bases::keep(&points.par_iter().map(|p| field.color(&p.placed)).collect::<Vec<_>>(), &part, &covariance, rows),
        gaussians: gaussians(&points, nearest, bounds),
        parts: Parts { start: parts.start, head: parts.head },
        networks,
        nodes,
        inputs,
        harmonics: None,
    };
    (avatar, parts.order)
}

/// θ_p is joints 1 to 21. The expression has no subspace: clamping a blink, seldom as it is, to 2σ would keep the eyes open.
fn inputs(poses: &[Pose]) -> Inputs {
    let mut inputs = Inputs { joint: (1..=21).collect(), expression: EXPRESSIONS.len(), pose_space: None, expression_space: None };
    let rows: Vec<Vec<f64>> = poses.iter().map(|pose| inputs.of(pose)).map(|mut row| row.drain(..63).collect()).collect();
    inputs.pose_space = Some(pca(&rows, 63, COMPONENTS));
    inputs
}

/// What enters the networks over the clips.
fn thetas(inputs: &Inputs, poses: &[Pose]) -> Vec<Vec<f64>> {
    let stride = poses.len().div_ceil(POSES).max(1);
    poses.iter().step_by(stride).map(|pose| inputs.of(pose)).collect()
}

fn point(dot: &Dot, index: usize, outfit: &Outfit, sky: &Sky, canonical: &[glam::DAffine3], seed: u64) -> Point {
    let mut random = Random::new(seed, (1 << 40) + index as u64);
    let mut site = dot.site.clone();
    site.footprint = dot.radius;
    let normal = outfit.relief_normal(&site);
    site.position += outfit.relief(&site, site.position) * site.normal;
    let color = outfit.shaded(&site, normal, dot.radius, sky);
    let hair = matches!(site.material, Material::Hair | Material::Lash);
    let flow = if hair { outfit.face.hair_flow(&site) } else { normal.any_orthonormal_vector() };
    let (joint, joint_weight) = quantise(&site.weights);
    let exact: Vec<(u8, f64)> = joint.iter().zip(joint_weight).map(|(&j, w)| (j, f64::from(w) / 255.0)).collect();
    let matrix = blend(canonical, &exact);
    let normal = (matrix.matrix3 * normal).normalize_or(normal);
    let first = (matrix.matrix3 * flow).reject_from_normalized(normal).normalize_or(normal.any_orthonormal_vector());
    let rotation = DQuat::from_mat3(&DMat3::from_cols(first, normal.cross(first), normal)).normalize();
    let lift = if site.material == Material::Hair { random.range(-0.0015, 0.0035) } else { 0.0 };
    let density = outfit.density(&site);
    // Gaps show more than blur does, but on face and print.
    let tangent = if density > 3.0 { 0.94 } else { 1.06 } * dot.radius;
    let thin = (0.35 * tangent).min(0.0008);
    let (scale, opacity) = match site.material {
        Material::Hair => (DVec3::new(1.9 * tangent, 0.62 * tangent, thin), 0.97),
        Material::Lash => (DVec3::new(0.8 * tangent, 0.35 * tangent, thin), 0.7),
        _ => (DVec3::new(tangent, tangent, thin), 1.0),
    };
    let position = matrix.transform_point3(site.position + lift * site.normal);
    let placed = Placed { position, normal, rotation, color, material: site.material, expression: site.expression, part: 0, head: false };
    Point { placed, scale, opacity, joint, joint_weight, turn: matrix.matrix3, density }
}

impl Outfit {
    /// Display-referred colour: what the material reflects of the light that the place sees.
    fn shaded(&self, site: &Site, normal: DVec3, radius: f64, sky: &Sky) -> DVec3 {
        let light = sky.light(site.position, site.material.facing().unwrap_or(normal));
        encode_srgb(self.reflects(site, radius) * site.material.scattered(light))
    }

    /// What a Gaussian's material reflects: the mean over its extent, linear.
    pub fn reflects(&self, site: &Site, radius: f64) -> DVec3 {
        let [u, v] = super::math::frame(site.normal);
        let mut at = site.clone();
        let mut albedo = self.albedo(site) * 2.0;
        for (x, y) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
            at.position = site.position + 0.5 * radius * (x * u + y * v);
            albedo += self.albedo(&at);
        }
        albedo / 6.0
    }
}

impl Material {
    /// The normal that light is taken for, where it isn't the surface's: eyes are lit evenly.
    pub fn facing(self) -> Option<DVec3> {
        (self == Self::Eye).then_some(DVec3::new(0.0, 0.25, 0.97))
    }

    /// Light as it leaves the material again.
    pub fn scattered(self, light: DVec3) -> DVec3 {
        match self {
            // Light enters skin and comes out elsewhere: shadows are soft and red.
            Self::Skin => light.lerp(DVec3::new(1.0, 0.80, 0.72) * 0.75, 0.14),
            _ => light.lerp(DVec3::splat(0.7), 0.06),
        }
    }
}

/// The four largest weights as bytes that sum to 255: the largest remainders are rounded up.
pub fn quantise(weights: &[(u8, f64)]) -> ([u8; 4], [u8; 4]) {
    let kept = &weights[..weights.len().min(4)];
    let sum: f64 = kept.iter().map(|(_, weight)| weight).sum();
    let exact: [f64; 4] = std::array::from_fn(|k| kept.get(k).map_or(0.0, |(_, weight)| 255.0 * weight / sum));
    let mut bytes = exact.map(|w| w.floor() as u8);
    let mut order = [0, 1, 2, 3];
    order.sort_by(|&a, &b| exact[b].fract().total_cmp(&exact[a].fract()).then(a.cmp(&b)));
    let missing = 255 - bytes.iter().map(|&b| usize::from(b)).sum::<usize>();
    order.iter().cycle().take(missing).for_each(|&k| bytes[k] += 1);
    (std::array::from_fn(|k| kept.get(k).map_or(0, |(joint, _)| *joint)), bytes)
}

/// Evenly spaced points, closer together on the head, in the order of the parts.
fn choose_nodes(points: &[Point], parts: &Partition, count: usize) -> Vec<usize> {
    let dart = |p: &Point| Dart {
        position: p.placed.position,
        density: p.density.sqrt() * if p.placed.head { 5.0 } else { 1.0 },
        layer: p.placed.material as u8,
    };
    let mut chosen = choose(&points.iter().map(dart).collect::<Vec<_>>(), count.min(points.len())).0;
    let mut rank = vec![0; points.len()];
    parts.order.iter().enumerate().for_each(|(at, &i)| rank[i] = at);
    chosen.sort_unstable_by_key(|&i| rank[i]);
    chosen
}

/// The three nearest nodes of each point. Nearness is measured with the mouth open and the layers pulled apart: otherwise a lip would
/// hang on the other lip's nodes, and skin on its shirt's.
fn nearest_nodes(points: &[Option<Point>], nodes: &[usize]) -> Vec<[u16; 3]> {
    const LAYERS_APART: f64 = 0.03;
    let place = |i: usize| {
        let placed = &points[i].as_ref().expect("still in place").placed;
        let p = placed.position + placed.expression[0];
        [p.x, p.y, p.z, LAYERS_APART * f64::from(placed.material as u8)]
    };
    let places: Vec<[f64; 4]> = nodes.iter().map(|&i| place(i)).collect();
    let tree: ImmutableKdTree<f64, 4> = ImmutableKdTree::new_from_slice(&places);
    let three = NonZero::new(3).expect("3 is not 0");
    let find = |i: usize| {
        let found = tree.nearest_n::<SquaredEuclidean>(&place(i), three);
        std::array::from_fn(|k| found[k.min(found.len() - 1)].item as u16)
    };
    (0..points.len()).into_par_iter().map(find).collect()
}

fn bounds(positions: &[DVec3]) -> Bounds {
    let low = positions.iter().fold(DVec3::INFINITY, |m, p| m.min(*p));
    let high = positions.iter().fold(DVec3::NEG_INFINITY, |m, p| m.max(*p));
    Bounds { min: low.as_vec3().to_array(), max: high.as_vec3().to_array() }
}

fn gaussians(points: &[Point], node: Vec<[u16; 3]>, bounds: Bounds) -> Gaussians {
    let half = |v: DVec3| v.to_array().map(f16::from_f64);
    Gaussians {
        bounds,
        position: points.iter().map(|p| bounds.encode(p.placed.position)).collect(),
        rotation: points
            .iter()
            .map(|p| [p.placed.rotation.w, p.placed.rotation.x, p.placed.rotation.y, p.placed.rotation.z].map(f16::from_f64))
            .collect(),
        log_scale: points.iter().map(|p| half(DVec3::from(p.scale.to_array().map(f64::ln)))).collect(),
        color: points.iter().map(|p| half(p.placed.color)).collect(),
        opacity: points.iter().map(|p| (255.0 * p.opacity).round() as u8).collect(),
        joint: points.iter().map(|p| p.joint).collect(),
        joint_weight: points.iter().map(|p| p.joint_weight).collect(),
        node,
    }
}
