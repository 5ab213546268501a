//! The skinned mesh with flesh and cloth settled on it.
//!
//! Flesh: delta mush. The skinned mesh is smoothed, which takes out the creases and the collapse of
//! linear blend skinning. Then every vertex gets back its displacement from the smoothed rest
//! shape, in the frame of the smoothed posed one, which keeps volume and detail.
//!
//! Cloth, on top of that: edges keep their length, so that sleeves and trouser legs that a bending
//! joint shortens form folds, and cloth stays outside the flesh beneath it. Position-based: a fixed
//! number of rounds from the mushed shape, without history, so that a pose has one shape.

use crate::bake::surface::Material;
use crate::ground_truth::mesh::SheetMesh;
use effigy_math::noise::fractal_noise;
use glam::{DMat3, DVec3};
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rayon::prelude::*;

/// Rounds of smoothing: over about 4 cm of a mesh with edges of 1.5 cm.
const SMOOTHING_ROUNDS: usize = 12;
/// Rounds in which cloth finds its shape.
const CLOTH_ROUNDS: usize = 24;
/// The share of an edge's excess length that a round takes out: cloth hardly stretches.
const STRETCH_STIFFNESS: f64 = 0.8;
/// The share of an edge's missing length that a round restores: cloth gives way a little where it
/// is pressed together.
const COMPRESSION_STIFFNESS: f64 = 0.5;
/// The share of the way to the neighbours' mean that a round goes: cloth resists sharp bends.
const BENDING_STIFFNESS: f64 = 0.08;
/// The share of the way back to the mushed shape that a round goes: cloth hangs on the body.
const ATTACHMENT: f64 = 0.03;
/// Damps the correction of edges, since a vertex is moved by all its edges at once.
const EDGE_DAMPING: f64 = 1.8;
/// Cloth keeps this share of its rest distance from the flesh.
const CLEARANCE: f64 = 0.5;
/// Unevenness of cloth, which decides where folds begin, metres.
const UNEVENNESS: f64 = 0.0012;

/// The part of the settling that depends on the rest pose alone.
pub struct Settling {
    /// Displacement of each vertex from the smoothed rest shape, in the frame of that shape.
    detail: Vec<DVec3>,
    cloth: Vec<ClothVertex>,
}

struct ClothVertex {
    vertex: u32,
    /// Rest lengths of the edges to its neighbours.
    lengths: Vec<f64>,
    /// The vertex of the flesh beneath.
    flesh: u32,
    /// The rest distance from it along its normal.
    gap: f64,
    /// How far the cloth's own unevenness lifts it.
    lift: f64,
}

fn is_cloth(material: Material) -> bool {
    matches!(material, Material::Shirt | Material::Trousers)
}

impl Settling {
    /// Measures the mesh's rest pose.
    pub fn new(mesh: &SheetMesh) -> Self {
        let smooth = mesh.smoothed(&mesh.rest, SMOOTHING_ROUNDS);
        let frames = vertex_frames(mesh, &smooth);
        let detail = (0..smooth.len())
            .map(|v| frames[v].transpose() * (mesh.rest[v] - smooth[v]))
            .collect();
        Self {
            detail,
            cloth: cloth_vertices(mesh),
        }
    }

    /// The settled shape of a skinned one.
    pub fn settle(&self, mesh: &SheetMesh, skinned: &[DVec3]) -> Vec<DVec3> {
        let smooth = mesh.smoothed(skinned, SMOOTHING_ROUNDS);
        let frames = vertex_frames(mesh, &smooth);
        let mut shape: Vec<DVec3> = (0..smooth.len())
            .into_par_iter()
            .map(|v| smooth[v] + frames[v] * self.detail[v])
            .collect();
        let normals = mesh.normals(&shape);
        let mushed: Vec<DVec3> = self
            .cloth
            .iter()
            .map(|cloth| shape[cloth.vertex as usize])
            .collect();
        for cloth in &self.cloth {
            let v = cloth.vertex as usize;
            shape[v] += normals[v] * cloth.lift;
        }
        for _ in 0..CLOTH_ROUNDS {
            let moved: Vec<DVec3> = self
                .cloth
                .par_iter()
                .zip(&mushed)
                .map(|(cloth, mushed)| cloth.relaxed(mesh, *mushed, &shape, &normals))
                .collect();
            for (cloth, moved) in self.cloth.iter().zip(moved) {
                shape[cloth.vertex as usize] = moved;
            }
        }
        shape
    }
}

fn cloth_vertices(mesh: &SheetMesh) -> Vec<ClothVertex> {
    let flesh: Vec<u32> = (0..mesh.rest.len() as u32)
        .filter(|&v| mesh.material[v as usize] == Material::Skin)
        .collect();
    let points: Vec<[f64; 3]> = flesh
        .iter()
        .map(|&v| mesh.rest[v as usize].to_array())
        .collect();
    let tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(&points);
    let normals = mesh.normals(&mesh.rest);
    let cloth = |v: usize| {
        let p = mesh.rest[v];
        let nearest = tree.nearest_one::<SquaredEuclidean>(&p.to_array());
        let flesh = flesh[nearest.item as usize];
        let gap = (p - mesh.rest[flesh as usize]).dot(normals[flesh as usize]);
        ClothVertex {
            vertex: v as u32,
            lengths: mesh.neighbours[v]
                .iter()
                .map(|&n| p.distance(mesh.rest[n as usize]))
                .collect(),
            flesh,
            gap: gap.max(0.0),
            lift: UNEVENNESS * fractal_noise(84, p * DVec3::new(14.0, 30.0, 14.0)),
        }
    };
    (0..mesh.rest.len())
        .filter(|&v| is_cloth(mesh.material[v]))
        .map(cloth)
        .collect()
}

impl ClothVertex {
    /// The position after one round. `mushed`: the position to hang on. `normals` are those of the
    /// mushed shape.
    fn relaxed(
        &self,
        mesh: &SheetMesh,
        mushed: DVec3,
        shape: &[DVec3],
        normals: &[DVec3],
    ) -> DVec3 {
        let p = shape[self.vertex as usize];
        let neighbours = &mesh.neighbours[self.vertex as usize];
        let mut correction = DVec3::ZERO;
        let mut sum = DVec3::ZERO;
        for (&n, rest) in neighbours.iter().zip(&self.lengths) {
            let edge = shape[n as usize] - p;
            let length = edge.length().max(1e-9);
            let stiffness = if length > *rest {
                STRETCH_STIFFNESS
            } else {
                COMPRESSION_STIFFNESS
            };
            // Each end takes half.
            correction += edge * (0.5 * (length - rest) / length * stiffness);
            sum += shape[n as usize];
        }
        let count = neighbours.len().max(1) as f64;
        let relaxed =
            p + correction * (EDGE_DAMPING / count) + (sum / count - p) * BENDING_STIFFNESS;
        let relaxed = relaxed.lerp(mushed, ATTACHMENT);
        let foot = shape[self.flesh as usize];
        let normal = normals[self.flesh as usize];
        let clearance = (relaxed - foot).dot(normal) - CLEARANCE * self.gap;
        if clearance < 0.0 {
            relaxed - normal * clearance
        } else {
            relaxed
        }
    }
}

/// A frame at each vertex of a shape: the normal, the direction of the first edge in the tangent
/// plane, and their cross product.
fn vertex_frames(mesh: &SheetMesh, positions: &[DVec3]) -> Vec<DMat3> {
    let normals = mesh.normals(positions);
    let frame = |v: usize| {
        let normal = normals[v];
        let edge = mesh.neighbours[v]
            .first()
            .map_or(DVec3::X, |&n| positions[n as usize] - positions[v]);
        let tangent = edge
            .reject_from_normalized(normal)
            .normalize_or(normal.any_orthonormal_vector());
        DMat3::from_cols(normal, tangent, normal.cross(tangent))
    };
    (0..positions.len()).into_par_iter().map(frame).collect()
}
