//! The feet in; shoes out: the surface at a fixed distance around each foot, which closes the gaps between the toes, with a rim and a
//! flat sole.

use super::body::Body;
use super::outfit::is_foot;
use super::surface::{Material, Sheet, Vertex};
use glam::{DVec2, DVec3, IVec3};
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use std::collections::HashMap;
use std::num::NonZero;

/// Height of the shoe's opening, metres.
pub const COLLAR: f64 = 0.088;
/// Height up to which the shoe is sole.
pub const SOLE: f64 = 0.030;
const CELL: f64 = 0.004;
/// Distance from the foot.
const GAP: f64 = 0.0085;
/// How much further the sole's rim stands out.
const RIM: f64 = 0.0035;

struct Foot<'a> {
    body: &'a Body,
    points: Vec<(DVec3, u32)>,
    tree: ImmutableKdTree<f64, 3>,
}

/// A shoe a foot.
pub fn sheets(body: &Body) -> Vec<Sheet> {
    [1.0, -1.0].iter().filter_map(|side| Foot::new(body, *side)).map(|foot| foot.shoe()).collect()
}

impl<'a> Foot<'a> {
    /// None where the mesh has no foot on that side.
    fn new(body: &'a Body, side: f64) -> Option<Self> {
        let mut points = Vec::new();
        for triangle in body.obj.group("body") {
            let corners = triangle.map(|corner| (body.obj.positions[corner.vertex as usize], corner.vertex));
            if corners.iter().all(|(p, _)| p.x * side > 0.0 && p.y < COLLAR + 0.06) && corners.iter().any(|(_, v)| in_foot(body, *v)) {
                let [a, b, c] = corners.map(|(p, _)| p);
                points.extend(corners);
                points.extend([(a + b) / 2.0, (b + c) / 2.0, (c + a) / 2.0, (a + b + c) / 3.0].map(|p| (p, corners[0].1)));
            }
        }
        if points.is_empty() {
            return None;
        }
        let tree = ImmutableKdTree::new_from_slice(&points.iter().map(|(p, _)| p.to_array()).collect::<Vec<_>>());
        Some(Self { body, points, tree })
    }

    /// Below 0 inside the shoe.
    fn field(&self, p: DVec3) -> f64 {
        let distance = self.tree.nearest_one::<SquaredEuclidean>(&p.to_array()).distance.sqrt();
        let sole = p.y < SOLE - 0.004;
        (distance - GAP - if sole { RIM } else { 0.0 }).max(-p.y)
    }

    fn shoe(&self) -> Sheet {
        let min = self.points.iter().fold(DVec3::INFINITY, |m, (p, _)| m.min(*p)) - 4.0 * CELL - GAP;
        let max = self.points.iter().fold(DVec3::NEG_INFINITY, |m, (p, _)| m.max(*p)) + 4.0 * CELL + GAP;
        let size = ((max - min) / CELL).ceil().as_ivec3();
        let at = |c: IVec3| min + c.as_dvec3() * CELL;
        let index = |c: IVec3| ((c.z * size.y + c.y) * size.x + c.x) as usize;
        let mut field = vec![0.0; (size.x * size.y * size.z) as usize];
        let cells = || (0..size.z).flat_map(move |z| (0..size.y).flat_map(move |y| (0..size.x).map(move |x| IVec3::new(x, y, z))));
        cells().for_each(|c| field[index(c)] = self.field(at(c)));
        let mut sheet = Sheet { material: Material::Shoe, vertices: Vec::new(), triangles: Vec::new(), uv: Vec::new() };
        let mut vertex = HashMap::new();
        for cell in cells().filter(|c| (*c + 1).cmplt(size).all()) {
            if let Some(p) = crossing(cell, &|c| field[index(c)]) {
                vertex.insert(cell, sheet.vertices.len() as u32);
                sheet.vertices.push(self.vertex(min + p * CELL));
            }
        }
        for cell in cells().filter(|c| (*c + 1).cmplt(size).all() && c.cmpge(IVec3::ONE).all()) {
            quads(cell, &|c| field[index(c)], &mut |corners| {
                let found = corners.map(|c| vertex.get(&c).copied());
                if let [Some(a), Some(b), Some(c), Some(d)] = found {
                    sheet.triangles.extend([[a, b, c], [a, c, d]]);
                    sheet.uv.extend([[DVec2::ZERO; 3]; 2]);
                }
            });
        }
        sheet.smooth(3);
        sheet
    }

    /// Skin weights are the distance-weighted mean of the nearest points' of the foot.
    fn vertex(&self, position: DVec3) -> Vertex {
        let near = self.tree.nearest_n::<SquaredEuclidean>(&position.to_array(), NonZero::new(12).expect("12 is not 0"));
        let mut weights: Vec<(u8, f64)> = Vec::new();
        for neighbour in &near {
            let share = 1.0 / (neighbour.distance + 1e-4);
            for &(joint, weight) in &self.body.weights[self.points[neighbour.item as usize].1 as usize] {
                match weights.iter_mut().find(|(other, _)| *other == joint) {
                    Some((_, sum)) => *sum += share * weight,
                    None => weights.push((joint, share * weight)),
                }
            }
        }
        let sum: f64 = weights.iter().map(|(_, weight)| weight).sum();
        weights.iter_mut().for_each(|(_, weight)| *weight /= sum);
        weights.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        Vertex { position, normal: DVec3::Y, weights, expression: [DVec3::ZERO; 10] }
    }
}

fn in_foot(body: &Body, vertex: u32) -> bool {
    body.weights[vertex as usize].iter().filter(|(joint, _)| is_foot(*joint)).map(|(_, weight)| weight).sum::<f64>() > 0.1
}

/// Where a surface crosses a cell, the mean over its crossed edges, in cells: surface nets.
fn crossing(cell: IVec3, field: &dyn Fn(IVec3) -> f64) -> Option<DVec3> {
    let corner = |k: i32| IVec3::new(k & 1, k >> 1 & 1, k >> 2);
    let (mut sum, mut count) = (DVec3::ZERO, 0.0);
    for a in 0..8 {
        for b in [a | 1, a | 2, a | 4].into_iter().filter(|b| *b != a) {
            let (fa, fb) = (field(cell + corner(a)), field(cell + corner(b)));
            if (fa < 0.0) != (fb < 0.0) {
                sum += corner(a).as_dvec3().lerp(corner(b).as_dvec3(), fa / (fa - fb));
                count += 1.0;
            }
        }
    }
    (count > 0.0).then(|| cell.as_dvec3() + sum / count)
}

/// The faces around the three edges that start at a cell's lowest corner, seen anticlockwise from outside.
fn quads(cell: IVec3, field: &dyn Fn(IVec3) -> f64, emit: &mut dyn FnMut([IVec3; 4])) {
    for axis in 0..3 {
        let [u, v, w] = [IVec3::AXES[axis], IVec3::AXES[(axis + 1) % 3], IVec3::AXES[(axis + 2) % 3]];
        let (here, there) = (field(cell) < 0.0, field(cell + u) < 0.0);
        let around = [cell - v - w, cell - w, cell, cell - v];
        match (here, there) {
            (true, false) => emit(around),
            (false, true) => emit([around[3], around[2], around[1], around[0]]),
            _ => {}
        }
    }
}
