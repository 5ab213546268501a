//! The skinned mesh in; the mesh as flesh and cloth would lie, out.
//!
//! Flesh: delta mush. The skinned mesh is smoothed, which takes out the creases and the collapse of linear blend skinning, and every
//! vertex gets back its displacement from the smoothed rest shape in the frame of the smoothed posed one, which keeps volume and detail.
//! Cloth, on top of that: sides keep their length, so that sleeves and trouser legs that a bending joint shortens throw folds, and
//! cloth stays outside the flesh beneath it. Position-based: a fixed number of rounds from the mushed shape, no history, so that a pose
//! has one shape.

use super::mesh::Mesh;
use crate::bake::math::rough;
use crate::bake::surface::Material;
use glam::{DMat3, DVec3};
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use rayon::prelude::*;

/// Rounds of smoothing: over about 4 cm of a mesh with sides of 1.5 cm.
const MUSH: usize = 12;
/// Rounds in which cloth finds its shape.
const ROUNDS: usize = 24;
/// Share of a side's wrong length that a round takes out: cloth hardly stretches, and gives way a little where it is pressed together.
const STRETCHED: f64 = 0.8;
const PRESSED: f64 = 0.5;
/// Share of the way to the neighbours' mean that a round goes: cloth resists sharp bends.
const BENDING: f64 = 0.08;
/// Share of the way back to the mushed shape that a round goes: cloth hangs on the body.
const HANGING: f64 = 0.03;
/// Cloth keeps this share of its rest distance from the flesh.
const CLEARANCE: f64 = 0.5;
/// Unevenness of cloth, which decides where folds begin, metres.
const UNEVEN: f64 = 0.0012;

/// What of the settling depends on the rest pose alone.
pub struct Settling {
    /// Displacement of each vertex from the smoothed rest shape, in the frame of that.
    delta: Vec<DVec3>,
    cloth: Vec<Cloth>,
}

/// A vertex of cloth.
struct Cloth {
    vertex: u32,
    /// Rest lengths of the sides to its neighbours.
    length: Vec<f64>,
    /// The vertex of the flesh beneath.
    under: u32,
    /// Rest distance from it along its normal.
    gap: f64,
    /// How far the cloth's own unevenness lifts it.
    lift: f64,
}

fn is_cloth(material: Material) -> bool {
    matches!(material, Material::Shirt | Material::Trousers)
}

impl Settling {
    pub fn new(mesh: &Mesh) -> Self {
        let smooth = mesh.smoothed(&mesh.rest, MUSH);
        let frames = frames(mesh, &smooth);
        let delta = (0..smooth.len()).map(|v| frames[v].transpose() * (mesh.rest[v] - smooth[v])).collect();
        let flesh: Vec<u32> = (0..mesh.rest.len() as u32).filter(|&v| mesh.material[v as usize] == Material::Skin).collect();
        let points: Vec<[f64; 3]> = flesh.iter().map(|&v| mesh.rest[v as usize].to_array()).collect();
        let tree: ImmutableKdTree<f64, 3> = ImmutableKdTree::new_from_slice(&points);
        let normals = mesh.normals(&mesh.rest);
        let cloth = |v: usize| {
            let p = mesh.rest[v];
            let under = flesh[tree.nearest_one::<SquaredEuclidean>(&p.to_array()).item as usize];
            let gap = (p - mesh.rest[under as usize]).dot(normals[under as usize]).max(0.0);
            let length = mesh.neighbours[v].iter().map(|&n| p.distance(mesh.rest[n as usize])).collect();
            Cloth { vertex: v as u32, length, under, gap, lift: UNEVEN * rough(84, p * DVec3::new(14.0, 30.0, 14.0)) }
        };
        Self { delta, cloth: (0..mesh.rest.len()).filter(|&v| is_cloth(mesh.material[v])).map(cloth).collect() }
    }

    /// The settled shape of a skinned one.
    pub fn settle(&self, mesh: &Mesh, skinned: &[DVec3]) -> Vec<DVec3> {
        let smooth = mesh.smoothed(skinned, MUSH);
        let frames = frames(mesh, &smooth);
        let mut shape: Vec<DVec3> = (0..smooth.len()).into_par_iter().map(|v| smooth[v] + frames[v] * self.delta[v]).collect();
        let normals = mesh.normals(&shape);
        let hung: Vec<DVec3> = self.cloth.iter().map(|c| shape[c.vertex as usize]).collect();
        for cloth in &self.cloth {
            let v = cloth.vertex as usize;
            shape[v] += normals[v] * cloth.lift;
        }
        for _ in 0..ROUNDS {
            let next: Vec<DVec3> =
                self.cloth.par_iter().zip(&hung).map(|(cloth, hung)| round(mesh, cloth, *hung, &shape, &normals)).collect();
            self.cloth.iter().zip(next).for_each(|(cloth, next)| shape[cloth.vertex as usize] = next);
        }
        shape
    }
}

/// Where a round takes a vertex of cloth.
fn round(mesh: &Mesh, cloth: &Cloth, hung: DVec3, shape: &[DVec3], normals: &[DVec3]) -> DVec3 {
    let p = shape[cloth.vertex as usize];
    let neighbours = &mesh.neighbours[cloth.vertex as usize];
    let (mut pull, mut mean) = (DVec3::ZERO, DVec3::ZERO);
    for (&n, length) in neighbours.iter().zip(&cloth.length) {
        let side = shape[n as usize] - p;
        let now = side.length().max(1e-9);
        // Each end takes half.
        pull += side * (0.5 * (now - length) / now * if now > *length { STRETCHED } else { PRESSED });
        mean += shape[n as usize];
    }
    let count = neighbours.len().max(1) as f64;
    // Damped: a vertex is moved by all its sides at once.
    let mut q = p + pull * (1.8 / count) + (mean / count - p) * BENDING;
    q = q.lerp(hung, HANGING);
    let (foot, normal) = (shape[cloth.under as usize], normals[cloth.under as usize]);
    let outside = (q - foot).dot(normal) - CLEARANCE * cloth.gap;
    if outside < 0.0 { q - normal * outside } else { q }
}

/// A frame at each vertex: the normal, the direction of the first side in the tangent plane, and the third.
fn frames(mesh: &Mesh, positions: &[DVec3]) -> Vec<DMat3> {
    let normals = mesh.normals(positions);
    let frame = |v: usize| {
        let normal = normals[v];
        let side = mesh.neighbours[v].first().map_or(DVec3::X, |&n| positions[n as usize] - positions[v]);
        let tangent = side.reject_from_normalized(normal).normalize_or(normal.any_orthonormal_vector());
        DMat3::from_cols(normal, tangent, normal.cross(tangent))
    };
    (0..positions.len()).into_par_iter().map(frame).collect()
}
