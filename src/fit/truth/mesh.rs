//! The sheets of a dressed body in; one triangle mesh with its neighbourhoods out, and what skinning makes of it in a pose.

use crate::bake::Dressed;
use crate::bake::body::blend;
use crate::bake::rig::Influences;
use crate::bake::surface::Material;
use glam::{DAffine3, DMat3, DVec3};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// All sheets as one mesh, in the rest pose; lengths in metres.
pub struct Mesh {
    pub rest: Vec<DVec3>,
    pub weights: Vec<Influences>,
    pub expression: Vec<[DVec3; 10]>,
    pub material: Vec<Material>,
    pub triangles: Vec<[u32; 3]>,
    /// Triangles that can be seen: those that stop light.
    pub shown: Vec<usize>,
    /// Each pair of vertices that a side joins, once.
    pub edges: Vec<(u32, u32)>,
    /// Vertices joined to each.
    pub neighbours: Vec<Vec<u32>>,
    /// Triangles around each vertex.
    pub around: Vec<Vec<u32>>,
    /// The first vertex and the first triangle of each sheet.
    pub starts: Vec<(usize, usize)>,
}

impl Mesh {
    pub fn new(dressed: &Dressed) -> Self {
        let mut mesh = Self {
            rest: Vec::new(),
            weights: Vec::new(),
            expression: Vec::new(),
            material: Vec::new(),
            triangles: Vec::new(),
            shown: Vec::new(),
            edges: Vec::new(),
            neighbours: Vec::new(),
            around: Vec::new(),
            starts: Vec::new(),
        };
        for sheet in &dressed.sheets {
            let first = mesh.rest.len();
            mesh.starts.push((first, mesh.triangles.len()));
            for vertex in &sheet.vertices {
                mesh.rest.push(vertex.position);
                mesh.weights.push(vertex.weights.clone());
                mesh.expression.push(vertex.expression);
                mesh.material.push(sheet.material);
            }
            for (t, triangle) in sheet.triangles.iter().enumerate() {
                if dressed.outfit.shows(&sheet.site(t, [1.0 / 3.0; 3])) {
                    mesh.shown.push(mesh.triangles.len());
                }
                mesh.triangles.push(triangle.map(|v| v + first as u32));
            }
        }
        mesh.join();
        mesh
    }

    fn join(&mut self) {
        let mut edges = BTreeSet::new();
        self.around = vec![Vec::new(); self.rest.len()];
        for (t, triangle) in self.triangles.iter().enumerate() {
            for k in 0..3 {
                let (a, b) = (triangle[k], triangle[(k + 1) % 3]);
                edges.insert((a.min(b), a.max(b)));
                self.around[triangle[k] as usize].push(t as u32);
            }
        }
        self.edges = edges.into_iter().collect();
        self.neighbours = vec![Vec::new(); self.rest.len()];
        for &(a, b) in &self.edges {
            self.neighbours[a as usize].push(b);
            self.neighbours[b as usize].push(a);
        }
    }

    /// Where linear blend skinning puts each vertex, and the matrix that turns what moves with it. `joints`: rest to posed, one a joint.
    pub fn skinned(&self, joints: &[DAffine3]) -> (Vec<DVec3>, Vec<DMat3>) {
        let place = |(rest, weights): (&DVec3, &Influences)| {
            let matrix = blend(joints, weights);
            (matrix.transform_point3(*rest), matrix.matrix3)
        };
        self.rest.par_iter().zip(&self.weights).map(place).unzip()
    }

    /// Area-weighted unit normals.
    pub fn normals(&self, positions: &[DVec3]) -> Vec<DVec3> {
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| positions[v as usize]);
            (b - a).cross(c - a)
        };
        let areas: Vec<DVec3> = self.triangles.par_iter().map(area).collect();
        let normal = |list: &Vec<u32>| list.iter().map(|&t| areas[t as usize]).sum::<DVec3>().normalize_or(DVec3::Y);
        self.around.par_iter().map(normal).collect()
    }

    /// Each vertex halfway to the mean of its neighbours, `times` over.
    pub fn smoothed(&self, positions: &[DVec3], times: usize) -> Vec<DVec3> {
        let mut now = positions.to_vec();
        for _ in 0..times {
            now = now
                .par_iter()
                .zip(&self.neighbours)
                .map(|(p, list)| match list.len() {
                    0 => *p,
                    count => p.lerp(list.iter().map(|&n| now[n as usize]).sum::<DVec3>() / count as f64, 0.5),
                })
                .collect();
        }
        now
    }

    /// How the surface around each vertex is stretched and turned from one shape to another: the mean over its triangles of the
    /// matrices that take the sides of one to those of the other, and the unit normal to the unit normal.
    pub fn gradients(&self, from: &[DVec3], to: &[DVec3]) -> Vec<DMat3> {
        let frame = |positions: &[DVec3], t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| positions[v as usize]);
            let normal = (b - a).cross(c - a);
            (DMat3::from_cols(b - a, c - a, normal.normalize_or_zero()), normal.length())
        };
        let gradient = |t: &[u32; 3]| {
            let ((before, area), (after, _)) = (frame(from, t), frame(to, t));
            // Slivers say nothing about their surroundings.
            if area < 1e-9 { (DMat3::ZERO, 0.0) } else { (after * before.inverse(), area) }
        };
        let each: Vec<(DMat3, f64)> = self.triangles.par_iter().map(gradient).collect();
        let mean = |list: &Vec<u32>| {
            let (sum, area) =
                list.iter().map(|&t| each[t as usize]).fold((DMat3::ZERO, 0.0), |(sum, area), (g, a)| (sum + g * a, area + a));
            if area > 0.0 { sum * (1.0 / area) } else { DMat3::IDENTITY }
        };
        self.around.par_iter().map(mean).collect()
    }
}
