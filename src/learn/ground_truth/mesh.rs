//! All sheets of a dressed body as one triangle mesh with its neighbourhoods, and its skinned shape
//! in a pose.

use crate::bake::body::blend;
use crate::bake::outfit::Outfit;
use crate::bake::source::rig::Influences;
use crate::bake::surface::{Material, Sheet};
use glam::{DAffine3, DMat3, DVec3};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// All sheets as one mesh, in the rest pose; lengths in metres. Lists are indexed by vertex unless
/// they say otherwise.
pub struct SheetMesh {
    /// Positions in the rest pose.
    pub rest: Vec<DVec3>,
    /// Skin weights.
    pub weights: Vec<Influences>,
    /// Displacements at full strength of each expression.
    pub expression: Vec<[DVec3; 10]>,
    /// The material of the vertex's sheet.
    pub material: Vec<Material>,
    /// Vertices of each triangle, anticlockwise from outside.
    pub triangles: Vec<[u32; 3]>,
    /// The indices of the triangles that can be seen: those that stop light.
    pub visible: Vec<usize>,
    /// The vertices that an edge joins to each, in the order of the edges.
    pub neighbours: Vec<Vec<u32>>,
    /// The triangles around each vertex.
    pub triangles_around: Vec<Vec<u32>>,
    /// One a sheet.
    pub sheets: Vec<SheetStart>,
}

/// Where a sheet begins in a [`SheetMesh`].
#[derive(Clone, Copy, Debug)]
pub struct SheetStart {
    /// An index into the lists by vertex.
    pub first_vertex: usize,
    /// An index into [`SheetMesh::triangles`].
    pub first_triangle: usize,
}

/// A mesh after linear blend skinning; lists are indexed by vertex.
pub struct Skinned {
    /// Metres.
    pub positions: Vec<DVec3>,
    /// The matrix that turns whatever moves with the vertex, rest to posed.
    pub turns: Vec<DMat3>,
}

impl SheetMesh {
    /// Joins the sheets of a dressed body.
    pub fn new(sheets: &[Sheet], outfit: &Outfit) -> Self {
        let mut mesh = Self {
            rest: Vec::new(),
            weights: Vec::new(),
            expression: Vec::new(),
            material: Vec::new(),
            triangles: Vec::new(),
            visible: Vec::new(),
            neighbours: Vec::new(),
            triangles_around: Vec::new(),
            sheets: Vec::new(),
        };
        for sheet in sheets {
            let start = SheetStart {
                first_vertex: mesh.rest.len(),
                first_triangle: mesh.triangles.len(),
            };
            mesh.sheets.push(start);
            for vertex in &sheet.vertices {
                mesh.rest.push(vertex.position);
                mesh.weights.push(vertex.weights.clone());
                mesh.expression.push(vertex.expression);
                mesh.material.push(sheet.material);
            }
            for (t, triangle) in sheet.triangles.iter().enumerate() {
                if outfit.shows(&sheet.site(t, [1.0 / 3.0; 3])) {
                    mesh.visible.push(mesh.triangles.len());
                }
                mesh.triangles
                    .push(triangle.map(|v| v + start.first_vertex as u32));
            }
        }
        mesh.find_neighbours();
        mesh
    }

    fn find_neighbours(&mut self) {
        // Each edge once, in a fixed order.
        let mut edges = BTreeSet::new();
        self.triangles_around = vec![Vec::new(); self.rest.len()];
        for (t, triangle) in self.triangles.iter().enumerate() {
            for k in 0..3 {
                let a = triangle[k];
                let b = triangle[(k + 1) % 3];
                edges.insert((a.min(b), a.max(b)));
                self.triangles_around[a as usize].push(t as u32);
            }
        }
        self.neighbours = vec![Vec::new(); self.rest.len()];
        for (a, b) in edges {
            self.neighbours[a as usize].push(b);
            self.neighbours[b as usize].push(a);
        }
    }

    /// The shape by linear blend skinning. `joints`: rest to posed, one a joint.
    pub fn skinned(&self, joints: &[DAffine3]) -> Skinned {
        let matrices: Vec<DAffine3> = self
            .weights
            .par_iter()
            .map(|weights| blend(joints, weights))
            .collect();
        let posed = |(rest, matrix): (&DVec3, &DAffine3)| matrix.transform_point3(*rest);
        Skinned {
            positions: self.rest.par_iter().zip(&matrices).map(posed).collect(),
            turns: matrices.iter().map(|matrix| matrix.matrix3).collect(),
        }
    }

    /// Area-weighted unit normals of a shape.
    pub fn normals(&self, positions: &[DVec3]) -> Vec<DVec3> {
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| positions[v as usize]);
            (b - a).cross(c - a)
        };
        let areas: Vec<DVec3> = self.triangles.par_iter().map(area).collect();
        let normal = |list: &Vec<u32>| {
            list.iter()
                .map(|&t| areas[t as usize])
                .sum::<DVec3>()
                .normalize_or(DVec3::Y)
        };
        self.triangles_around.par_iter().map(normal).collect()
    }

    /// A shape with each vertex moved halfway to the mean of its neighbours, `times` over.
    pub fn smoothed(&self, positions: &[DVec3], times: usize) -> Vec<DVec3> {
        let mut shape = positions.to_vec();
        for _ in 0..times {
            let smooth = |v: usize| {
                let neighbours = &self.neighbours[v];
                if neighbours.is_empty() {
                    return shape[v];
                }
                let sum: DVec3 = neighbours.iter().map(|&n| shape[n as usize]).sum();
                shape[v].lerp(sum / neighbours.len() as f64, 0.5)
            };
            shape = (0..shape.len()).into_par_iter().map(smooth).collect();
        }
        shape
    }

    /// The deformation gradient around each vertex from one shape to another: the area-weighted
    /// mean over its triangles of the matrices that take two edges and the unit normal to theirs.
    pub fn gradients(&self, from: &[DVec3], to: &[DVec3]) -> Vec<DMat3> {
        let gradient = |t: &[u32; 3]| {
            let before = TriangleFrame::new(from, t);
            // Slivers say nothing about their surroundings.
            if before.area < 1e-9 {
                return WeightedGradient::ZERO;
            }
            let after = TriangleFrame::new(to, t);
            WeightedGradient {
                gradient: after.frame * before.frame.inverse(),
                area: before.area,
            }
        };
        let gradients: Vec<WeightedGradient> = self.triangles.par_iter().map(gradient).collect();
        let mean = |list: &Vec<u32>| {
            let mut sum = DMat3::ZERO;
            let mut area = 0.0;
            for &t in list {
                let own = &gradients[t as usize];
                sum += own.gradient * own.area;
                area += own.area;
            }
            if area > 0.0 {
                sum * (1.0 / area)
            } else {
                DMat3::IDENTITY
            }
        };
        self.triangles_around.par_iter().map(mean).collect()
    }
}

/// Two edges of a triangle and its unit normal as columns, with twice its area.
struct TriangleFrame {
    frame: DMat3,
    area: f64,
}

impl TriangleFrame {
    fn new(positions: &[DVec3], triangle: &[u32; 3]) -> Self {
        let [a, b, c] = triangle.map(|v| positions[v as usize]);
        let normal = (b - a).cross(c - a);
        Self {
            frame: DMat3::from_cols(b - a, c - a, normal.normalize_or_zero()),
            area: normal.length(),
        }
    }
}

/// A triangle's deformation gradient and twice its area; 0 and 0 if it counts for nothing.
struct WeightedGradient {
    gradient: DMat3,
    area: f64,
}

impl WeightedGradient {
    const ZERO: Self = Self {
        gradient: DMat3::ZERO,
        area: 0.0,
    };
}
