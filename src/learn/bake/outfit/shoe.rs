//! Shoes: the surface at a fixed distance around each foot, which closes the gaps between the toes,
//! with a rim and a flat sole.

use crate::bake::body::BakedBody;
use crate::bake::joints::is_foot;
use crate::bake::source::rig::{self, Influences};
use crate::bake::surface::{Material, Sheet, SheetVertex};
use glam::{DVec2, DVec3, IVec3};
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use std::collections::HashMap;
use std::num::NonZero;

/// Height of the shoe's opening, metres.
pub const COLLAR: f64 = 0.088;
/// Height up to which the shoe is sole.
pub const SOLE: f64 = 0.030;
/// Size of the grid's cells that the surface is found in, metres.
const CELL: f64 = 0.004;
/// Distance of the shoe from the foot, metres.
const GAP: f64 = 0.0085;
/// How much further the sole's rim stands out, metres.
const RIM: f64 = 0.0035;
/// Joints whose weights sum to less than this share don't make a vertex part of a foot.
const FOOT_SHARE: f64 = 0.1;

/// A point of a foot's surface.
struct FootPoint {
    position: DVec3,
    /// The vertex whose skin weights it has.
    vertex: u32,
}

struct Foot<'a> {
    body: &'a BakedBody,
    points: Vec<FootPoint>,
    /// Of the points.
    tree: ImmutableKdTree<f64, 3>,
}

/// One shoe for each foot.
pub fn sheets(body: &BakedBody) -> Vec<Sheet> {
    [1.0, -1.0]
        .iter()
        .filter_map(|side| Foot::new(body, *side))
        .map(|foot| foot.shoe())
        .collect()
}

impl<'a> Foot<'a> {
    /// `side`: 1 left, -1 right. `None` if the mesh has no foot on that side.
    fn new(body: &'a BakedBody, side: f64) -> Option<Self> {
        let mut points = Vec::new();
        for triangle in body.obj.group("body") {
            let vertices = triangle.map(|corner| corner.vertex);
            let corners = vertices.map(|v| body.obj.positions[v as usize]);
            let near = |p: &DVec3| p.x * side > 0.0 && p.y < COLLAR + 0.06;
            if !corners.iter().all(near) || !vertices.iter().any(|&v| is_in_foot(body, v)) {
                continue;
            }
            let mut add = |position: DVec3, vertex: u32| {
                points.push(FootPoint { position, vertex });
            };
            let [a, b, c] = corners;
            add(a, vertices[0]);
            add(b, vertices[1]);
            add(c, vertices[2]);
            // Points between them: triangles are larger than cells.
            for between in [
                (a + b) / 2.0,
                (b + c) / 2.0,
                (c + a) / 2.0,
                (a + b + c) / 3.0,
            ] {
                add(between, vertices[0]);
            }
        }
        if points.is_empty() {
            return None;
        }
        let positions: Vec<[f64; 3]> = points.iter().map(|p| p.position.to_array()).collect();
        let tree = ImmutableKdTree::new_from_slice(&positions);
        Some(Self { body, points, tree })
    }

    /// The signed distance from the shoe's surface, about: below 0 inside.
    fn field(&self, p: DVec3) -> f64 {
        let distance = self
            .tree
            .nearest_one::<SquaredEuclidean>(&p.to_array())
            .distance
            .sqrt();
        let rim = if p.y < SOLE - 0.004 { RIM } else { 0.0 };
        (distance - GAP - rim).max(-p.y)
    }

    /// The field's zero surface on a grid, by surface nets.
    fn shoe(&self) -> Sheet {
        let positions = || self.points.iter().map(|point| point.position);
        let min = positions().fold(DVec3::INFINITY, DVec3::min) - 4.0 * CELL - GAP;
        let max = positions().fold(DVec3::NEG_INFINITY, DVec3::max) + 4.0 * CELL + GAP;
        let grid = ShoeGrid {
            size: ((max - min) / CELL).ceil().as_ivec3(),
        };
        let mut values = vec![0.0; grid.len()];
        for cell in grid.cells() {
            values[grid.index(cell)] = self.field(min + cell.as_dvec3() * CELL);
        }
        let field = |cell: IVec3| values[grid.index(cell)];
        let mut sheet = Sheet {
            material: Material::Shoe,
            vertices: Vec::new(),
            triangles: Vec::new(),
            uv: Vec::new(),
        };
        // The sheet's vertex in each cell that the surface crosses.
        let mut vertex = HashMap::new();
        for cell in grid.cells().filter(|cell| grid.has_upper_corner(*cell)) {
            if let Some(p) = surface_point(cell, &field) {
                vertex.insert(cell, sheet.vertices.len() as u32);
                sheet.vertices.push(self.vertex(min + p * CELL));
            }
        }
        for cell in grid.cells() {
            if !grid.has_upper_corner(cell) || !cell.cmpge(IVec3::ONE).all() {
                continue;
            }
            for cells in faces(cell, &field) {
                let corners = cells.map(|cell| vertex.get(&cell).copied());
                if let [Some(a), Some(b), Some(c), Some(d)] = corners {
                    sheet.triangles.extend([[a, b, c], [a, c, d]]);
                    sheet.uv.extend([[DVec2::ZERO; 3]; 2]);
                }
            }
        }
        sheet.smooth(3);
        sheet
    }

    /// Skin weights are the distance-weighted mean of the nearest points of the foot.
    fn vertex(&self, position: DVec3) -> SheetVertex {
        const NEAREST: NonZero<usize> = NonZero::new(12).expect("12 is not 0");
        let near = self
            .tree
            .nearest_n::<SquaredEuclidean>(&position.to_array(), NEAREST);
        let mut weights = Influences::new();
        for neighbour in &near {
            let share = 1.0 / (neighbour.distance + 1e-4);
            let source = self.points[neighbour.item as usize].vertex;
            for influence in &self.body.weights[source as usize] {
                rig::add_weight(&mut weights, influence.joint, share * influence.weight);
            }
        }
        let sum: f64 = weights.iter().map(|influence| influence.weight).sum();
        for influence in &mut weights {
            influence.weight /= sum;
        }
        rig::sort_by_weight(&mut weights);
        SheetVertex {
            position,
            normal: DVec3::Y,
            weights,
            expression: [DVec3::ZERO; 10],
        }
    }
}

fn is_in_foot(body: &BakedBody, vertex: u32) -> bool {
    body.weights[vertex as usize]
        .iter()
        .filter(|influence| is_foot(influence.joint))
        .map(|influence| influence.weight)
        .sum::<f64>()
        > FOOT_SHARE
}

/// Corners of cells in a box.
struct ShoeGrid {
    /// Corners along each axis.
    size: IVec3,
}

impl ShoeGrid {
    fn len(&self) -> usize {
        (self.size.x * self.size.y * self.size.z) as usize
    }

    fn index(&self, c: IVec3) -> usize {
        ((c.z * self.size.y + c.y) * self.size.x + c.x) as usize
    }

    /// All corners, x first; a cell is named by its lowest corner.
    fn cells(&self) -> impl Iterator<Item = IVec3> {
        let size = self.size;
        (0..size.x * size.y * size.z)
            .map(move |i| IVec3::new(i % size.x, i / size.x % size.y, i / (size.x * size.y)))
    }

    /// Whether all of a cell's corners are in the grid.
    fn has_upper_corner(&self, cell: IVec3) -> bool {
        (cell + 1).cmplt(self.size).all()
    }
}

/// The point of a field's zero surface in a cell: the mean over the edges that it crosses, in
/// cells. `None` if it crosses none.
fn surface_point(cell: IVec3, field: &dyn Fn(IVec3) -> f64) -> Option<DVec3> {
    let corner = |k: i32| IVec3::new(k & 1, k >> 1 & 1, k >> 2);
    let mut sum = DVec3::ZERO;
    let mut count = 0.0;
    for a in 0..8 {
        // Edges go to corners with one coordinate more.
        for b in [a | 1, a | 2, a | 4] {
            if b == a {
                continue;
            }
            let at_a = field(cell + corner(a));
            let at_b = field(cell + corner(b));
            if (at_a < 0.0) != (at_b < 0.0) {
                let share = at_a / (at_a - at_b);
                sum += corner(a).as_dvec3().lerp(corner(b).as_dvec3(), share);
                count += 1.0;
            }
        }
    }
    (count > 0.0).then(|| cell.as_dvec3() + sum / count)
}

/// The faces of a field's zero surface around the three edges that start at a cell's lowest corner.
/// Each joins four cells, anticlockwise seen from outside.
fn faces(cell: IVec3, field: &dyn Fn(IVec3) -> f64) -> Vec<[IVec3; 4]> {
    let mut faces = Vec::new();
    for axis in 0..3 {
        let along = IVec3::AXES[axis];
        let v = IVec3::AXES[(axis + 1) % 3];
        let w = IVec3::AXES[(axis + 2) % 3];
        let around = [cell - v - w, cell - w, cell, cell - v];
        let starts_inside = field(cell) < 0.0;
        let ends_inside = field(cell + along) < 0.0;
        if starts_inside && !ends_inside {
            faces.push(around);
        } else if !starts_inside && ends_inside {
            faces.push([around[3], around[2], around[1], around[0]]);
        }
    }
    faces
}
