//! Triangle sheets (skin, each garment, hair), and points on them with everything that a Gaussian
//! inherits.

use crate::bake::body::BakedBody;
use crate::bake::source::obj::Corner;
use crate::bake::source::rig::{self, Influences};
use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// A sheet's material.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Material {
    /// The body's own surface.
    Skin,
    /// Both eyeballs.
    Eye,
    /// Eyelashes.
    Lash,
    /// Both rows of teeth.
    Teeth,
    /// The scalp's hair.
    Hair,
    /// A short-sleeved cotton shirt.
    Shirt,
    /// Denim trousers.
    Trousers,
    /// A leather belt.
    Belt,
    /// Canvas shoes.
    Shoe,
}

impl Material {
    /// The normal that light is taken for, where it isn't the surface's: eyes are lit evenly.
    pub fn light_normal(self) -> Option<DVec3> {
        (self == Self::Eye).then_some(DVec3::new(0.0, 0.25, 0.97))
    }

    /// Arriving light as it leaves the material again, linear RGB.
    pub fn scatter(self, light: DVec3) -> DVec3 {
        match self {
            // Light enters skin and comes out elsewhere: shadows are soft and red.
            Self::Skin => light.lerp(DVec3::new(1.0, 0.80, 0.72) * 0.75, 0.14),
            _ => light.lerp(DVec3::splat(0.7), 0.06),
        }
    }
}

/// A vertex in the rest pose, metres.
#[derive(Clone, Debug)]
pub struct SheetVertex {
    /// Metres.
    pub position: DVec3,
    /// Unit vector.
    pub normal: DVec3,
    /// Skin weights.
    pub weights: Influences,
    /// Displacement at full strength of each expression.
    pub expression: [DVec3; 10],
}

/// Triangles of one material; `uv` has a coordinate a corner.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// Of all its triangles.
    pub material: Material,
    /// In the rest pose.
    pub vertices: Vec<SheetVertex>,
    /// Vertices of each triangle, anticlockwise from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Texture coordinates of each triangle's corners.
    pub uv: Vec<[DVec2; 3]>,
}

/// A point of a sheet.
#[derive(Clone, Debug)]
pub struct Site {
    /// Of all its triangles.
    pub material: Material,
    /// Metres.
    pub position: DVec3,
    /// Unit vector.
    pub normal: DVec3,
    /// Texture coordinates.
    pub uv: DVec2,
    /// The largest first; they sum to 1.
    pub weights: Influences,
    /// Displacement at full strength of each expression, metres.
    pub expression: [DVec3; 10],
    /// The radius of the Gaussian at the point: finer lines are blurred to this, metres.
    pub footprint: f64,
}

impl Site {
    /// How much of the point the joints of a set move, 0 to 1.
    pub fn share(&self, joints: impl Fn(u8) -> bool) -> f64 {
        self.weights
            .iter()
            .filter(|influence| joints(influence.joint))
            .map(|influence| influence.weight)
            .sum()
    }
}

impl Sheet {
    /// A sheet of one of the mesh's groups.
    pub fn from_group(body: &BakedBody, group: &str, material: Material) -> Self {
        Self::from_triangles(body, body.obj.group(group).iter().copied(), material)
    }

    /// A sheet of some of the mesh's faces, with vertex normals.
    pub fn from_triangles(
        body: &BakedBody,
        faces: impl Iterator<Item = [Corner; 3]>,
        material: Material,
    ) -> Self {
        let mut sheet = Self {
            material,
            vertices: Vec::new(),
            triangles: Vec::new(),
            uv: Vec::new(),
        };
        // The sheet's vertex of each of the mesh's.
        let mut index = HashMap::new();
        for face in faces {
            for corner in face {
                let v = corner.vertex as usize;
                index.entry(corner.vertex).or_insert_with(|| {
                    sheet.vertices.push(SheetVertex {
                        position: body.obj.positions[v],
                        normal: DVec3::ZERO,
                        weights: body.weights[v].clone(),
                        expression: body.expressions[v],
                    });
                    sheet.vertices.len() as u32 - 1
                });
            }
            sheet
                .triangles
                .push(face.map(|corner| index[&corner.vertex]));
            let uv = |corner: Corner| match corner.uv {
                Some(uv) => body.obj.uvs[uv as usize],
                None => DVec2::ZERO,
            };
            sheet.uv.push(face.map(uv));
        }
        sheet.find_normals();
        sheet
    }

    /// Sets area-weighted vertex normals.
    pub fn find_normals(&mut self) {
        for vertex in &mut self.vertices {
            vertex.normal = DVec3::ZERO;
        }
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|v| self.vertices[v as usize].position);
            let area = (b - a).cross(c - a);
            for &v in triangle {
                self.vertices[v as usize].normal += area;
            }
        }
        for vertex in &mut self.vertices {
            vertex.normal = vertex.normal.normalize_or(DVec3::Y);
        }
    }

    /// Moves every vertex halfway to the mean of its neighbours, some times over. Vertices at an
    /// open edge stay.
    pub fn smooth(&mut self, times: usize) {
        let mut neighbours: Vec<Vec<u32>> = vec![Vec::new(); self.vertices.len()];
        // How many triangles each edge has.
        let mut edges: HashMap<(u32, u32), u32> = HashMap::new();
        for t in &self.triangles {
            for k in 0..3 {
                let a = t[k];
                let b = t[(k + 1) % 3];
                neighbours[a as usize].push(b);
                neighbours[b as usize].push(a);
                *edges.entry((a.min(b), a.max(b))).or_default() += 1;
            }
        }
        let mut open = vec![false; self.vertices.len()];
        for (&(a, b), &count) in &edges {
            if count == 1 {
                open[a as usize] = true;
                open[b as usize] = true;
            }
        }
        for _ in 0..times {
            let old: Vec<DVec3> = self.vertices.iter().map(|vertex| vertex.position).collect();
            for (v, list) in neighbours.iter().enumerate() {
                if open[v] || list.is_empty() {
                    continue;
                }
                let mean = list.iter().map(|&n| old[n as usize]).sum::<DVec3>() / list.len() as f64;
                self.vertices[v].position = old[v].lerp(mean, 0.5);
            }
        }
        self.find_normals();
    }

    /// Moves every vertex along its normal by a distance of its own.
    pub fn inflate(&mut self, distance: impl Fn(&SheetVertex) -> f64) {
        for vertex in &mut self.vertices {
            vertex.position += vertex.normal * distance(vertex);
        }
        self.find_normals();
    }

    /// Area of a triangle, m².
    pub fn area(&self, triangle: usize) -> f64 {
        let [a, b, c] = self.triangles[triangle].map(|v| self.vertices[v as usize].position);
        0.5 * (b - a).cross(c - a).length()
    }

    /// The point of a triangle at barycentric coordinates, on the curved surface that the vertex
    /// normals suggest: the point on the plane, moved three quarters of the way to the mean of its
    /// projections onto the vertices' tangent planes.
    pub fn site(&self, triangle: usize, barycentric: [f64; 3]) -> Site {
        let corners = self.triangles[triangle].map(|v| &self.vertices[v as usize]);
        let sum = |at_corner: &dyn Fn(usize) -> DVec3| {
            (0..3).map(|k| at_corner(k) * barycentric[k]).sum::<DVec3>()
        };
        let flat = sum(&|k| corners[k].position);
        let curved = sum(&|k| {
            flat - (flat - corners[k].position).dot(corners[k].normal) * corners[k].normal
        });
        let mut weights: Influences = Vec::with_capacity(8);
        for k in 0..3 {
            for influence in &corners[k].weights {
                let weight = influence.weight * barycentric[k];
                rig::add_weight(&mut weights, influence.joint, weight);
            }
        }
        rig::sort_by_weight(&mut weights);
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
