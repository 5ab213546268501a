//! Triangle sheets (skin, each garment, hair) in; points on them, with all that a Gaussian inherits, out.

use super::body::Body;
use super::obj::Corner;
use super::rig::Influences;
use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// What a sheet is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Material {
    Skin,
    Eye,
    Lash,
    Teeth,
    Hair,
    Shirt,
    Trousers,
    Belt,
    Shoe,
}

/// A vertex in the rest pose, metres.
#[derive(Clone, Debug)]
pub struct Vertex {
    pub position: DVec3,
    pub normal: DVec3,
    pub weights: Influences,
    /// Displacement at full strength of each expression.
    pub expression: [DVec3; 10],
}

/// Triangles of one material; `uv` has a coordinate a corner.
#[derive(Clone, Debug)]
pub struct Sheet {
    pub material: Material,
    pub vertices: Vec<Vertex>,
    pub triangles: Vec<[u32; 3]>,
    pub uv: Vec<[DVec2; 3]>,
}

/// A point of a sheet.
#[derive(Clone, Debug)]
pub struct Site {
    pub material: Material,
    pub position: DVec3,
    pub normal: DVec3,
    pub uv: DVec2,
    /// The largest first; they sum to 1.
    pub weights: Influences,
    pub expression: [DVec3; 10],
    /// How far the point's colour reaches: finer lines are blurred to this, metres.
    pub footprint: f64,
}

impl Site {
    /// How much of the point the joints of a set move, 0 to 1.
    pub fn share(&self, joints: impl Fn(u8) -> bool) -> f64 {
        self.weights.iter().filter(|(joint, _)| joints(*joint)).map(|(_, weight)| weight).sum()
    }
}

impl Sheet {
    /// The faces of one of the mesh's groups.
    pub fn of_group(body: &Body, group: &str, material: Material) -> Self {
        Self::of_triangles(body, body.obj.group(group).iter().copied(), material)
    }

    /// Some of the mesh's faces, with vertex normals.
    pub fn of_triangles(body: &Body, faces: impl Iterator<Item = [Corner; 3]>, material: Material) -> Self {
        let mut sheet = Self { material, vertices: Vec::new(), triangles: Vec::new(), uv: Vec::new() };
        let mut index = HashMap::new();
        for face in faces {
            sheet.triangles.push(face.map(|corner| {
                *index.entry(corner.vertex).or_insert_with(|| {
                    let v = corner.vertex as usize;
                    sheet.vertices.push(Vertex {
                        position: body.obj.positions[v],
                        normal: DVec3::ZERO,
                        weights: body.weights[v].clone(),
                        expression: body.expressions[v],
                    });
                    sheet.vertices.len() as u32 - 1
                })
            }));
            sheet.uv.push(face.map(|corner| corner.uv.map_or(DVec2::ZERO, |uv| body.obj.uvs[uv as usize])));
        }
        sheet.find_normals();
        sheet
    }

    /// Area-weighted vertex normals.
    pub fn find_normals(&mut self) {
        self.vertices.iter_mut().for_each(|vertex| vertex.normal = DVec3::ZERO);
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|v| self.vertices[v as usize].position);
            let area = (b - a).cross(c - a);
            triangle.iter().for_each(|&v| self.vertices[v as usize].normal += area);
        }
        self.vertices.iter_mut().for_each(|vertex| vertex.normal = vertex.normal.normalize_or(DVec3::Y));
    }

    /// Moves every vertex halfway to the mean of its neighbours, some times over; vertices at an open edge stay.
    pub fn smooth(&mut self, times: usize) {
        let mut neighbours: Vec<Vec<u32>> = vec![Vec::new(); self.vertices.len()];
        let mut sides: HashMap<(u32, u32), u32> = HashMap::new();
        for t in &self.triangles {
            for k in 0..3 {
                let (a, b) = (t[k], t[(k + 1) % 3]);
                neighbours[a as usize].push(b);
                neighbours[b as usize].push(a);
                *sides.entry((a.min(b), a.max(b))).or_default() += 1;
            }
        }
        let mut open = vec![false; self.vertices.len()];
        sides.iter().filter(|(_, count)| **count == 1).for_each(|((a, b), _)| [a, b].iter().for_each(|v| open[**v as usize] = true));
        for _ in 0..times {
            let old: Vec<DVec3> = self.vertices.iter().map(|vertex| vertex.position).collect();
            for (v, list) in neighbours.iter().enumerate().filter(|(v, list)| !open[*v] && !list.is_empty()) {
                let mean = list.iter().map(|&n| old[n as usize]).sum::<DVec3>() / list.len() as f64;
                self.vertices[v].position = old[v].lerp(mean, 0.5);
            }
        }
        self.find_normals();
    }

    /// Moves every vertex along its normal.
    pub fn inflate(&mut self, by: impl Fn(&Vertex) -> f64) {
        self.vertices.iter_mut().for_each(|vertex| vertex.position += vertex.normal * by(vertex));
        self.find_normals();
    }

    /// Area of a triangle, m².
    pub fn area(&self, triangle: usize) -> f64 {
        let [a, b, c] = self.triangles[triangle].map(|v| self.vertices[v as usize].position);
        0.5 * (b - a).cross(c - a).length()
    }

    /// The point of a triangle at barycentric coordinates, on the curved surface that the vertex normals suggest: the point on the
    /// plane, moved three quarters of the way to the mean of its projections onto the vertices' tangent planes.
    pub fn site(&self, triangle: usize, barycentric: [f64; 3]) -> Site {
        let corners = self.triangles[triangle].map(|v| &self.vertices[v as usize]);
        let sum = |of: &dyn Fn(usize) -> DVec3| (0..3).map(|k| of(k) * barycentric[k]).sum::<DVec3>();
        let flat = sum(&|k| corners[k].position);
        let curved = sum(&|k| flat - (flat - corners[k].position).dot(corners[k].normal) * corners[k].normal);
        let mut weights: Influences = Vec::with_capacity(8);
        for k in 0..3 {
            for &(joint, weight) in &corners[k].weights {
                match weights.iter_mut().find(|(other, _)| *other == joint) {
                    Some((_, sum)) => *sum += weight * barycentric[k],
                    None => weights.push((joint, weight * barycentric[k])),
                }
            }
        }
        weights.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
        Site {
            material: self.material,
            position: flat.lerp(curved, 0.75),
            normal: sum(&|k| corners[k].normal).normalize_or(corners[0].normal),
            uv: (0..3).map(|k| self.uv[triangle][k] * barycentric[k]).sum(),
            weights,
            expression: std::array::from_fn(|e| sum(&|k| corners[k].expression[e])),
            footprint: 0.0,
        }
    }
}
