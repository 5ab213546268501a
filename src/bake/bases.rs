//! Points of the body and the spread of their features in; basis rows of nodes, rotation, scale and colour out, until a trainer learns them.
//!
//! Each basis function is a wave over the body, of a length that suits what it moves; cloth moves most, and most near joints that bend.
//! The shared features' waves displace nodes, tilt Gaussians and shade colours together, as folds do. In head parts the first features
//! are the expression, and their nodes' rows the real displacements of the face.

use super::math::Random;
use super::networks::{BASIS, SHARED};
use super::surface::Material;
use crate::avatar::Rows;
use glam::{DQuat, DVec3};
use half::f16;

/// A Gaussian or node in the canonical pose.
#[derive(Clone, Debug)]
pub struct Placed {
    pub position: DVec3,
    pub normal: DVec3,
    pub rotation: DQuat,
    /// Display-referred.
    pub color: DVec3,
    pub material: Material,
    pub expression: [DVec3; 10],
    pub part: usize,
    /// Whether the part sees the expression.
    pub head: bool,
}

/// The waves of one bake.
pub struct Bases {
    wave: Vec<(DVec3, f64)>,
    /// Joints that bend, canonical pose.
    bends: Vec<DVec3>,
}

/// Joints whose bending folds cloth: hips, knees, spine, shoulders, elbows.
const BENDS: [usize; 11] = [1, 2, 3, 4, 5, 6, 9, 16, 17, 18, 19];
/// Where the light that the colours are baked under mostly comes from.
const KEY: DVec3 = DVec3::new(-0.45, 0.62, 0.64);

impl Bases {
    /// `joints` are the skeleton's, canonical pose.
    pub fn new(seed: u64, joints: &[DVec3]) -> Self {
        let mut random = Random::new(seed, 2000);
        let wave = (0..2 * BASIS).map(|_| {
            let length = random.range(0.055, 0.15);
            // Folds run around limbs and waist: waves lie mostly along the body's height.
            let direction = (random.direction() + DVec3::Y * random.range(-1.0, 1.0)).normalize_or(DVec3::Y);
            (direction * std::f64::consts::TAU / length, random.range(0.0, std::f64::consts::TAU))
        });
        Self { wave: wave.collect(), bends: BENDS.iter().filter_map(|&j| joints.get(j).copied()).collect() }
    }

    /// How much a place moves beyond its joints, 0 to 1.
    fn liveliness(&self, at: &Placed) -> f64 {
        let near = self.bends.iter().map(|joint| (-(joint.distance(at.position) / 0.13).powi(2)).exp()).fold(0.0, f64::max);
        let cloth = match at.material {
            Material::Shirt | Material::Trousers => 1.0,
            Material::Hair => 0.3,
            Material::Skin => 0.18,
            _ => 0.08,
        };
        cloth * (0.12 + 0.88 * near)
    }

    /// Height and slope of the wave of a feature; nodes' waves come first, attributes share the first of them.
    fn wave(&self, index: usize, p: DVec3) -> (f64, DVec3) {
        let (k, phase) = self.wave[index];
        let angle = k.dot(p) + phase;
        (angle.sin(), k.normalize_or(DVec3::Y) * angle.cos())
    }

    fn attribute_wave(&self, k: usize, p: DVec3) -> (f64, DVec3) {
        self.wave(if k < SHARED { k } else { BASIS + k }, p)
    }

    /// A node's row, metres a unit of feature: shape 3, N_B. `turn` is rest to canonical pose.
    pub fn node(&self, at: &Placed, turn: glam::DMat3) -> Vec<f16> {
        const AMPLITUDE: f64 = 0.0026;
        let amplitude = AMPLITUDE * self.liveliness(at) / (0.5 * BASIS as f64).sqrt();
        let carried = if at.head { at.expression.len().min(BASIS) } else { 0 };
        let column = |k: usize| if k < carried { turn * at.expression[k] } else { at.normal * amplitude * self.wave(k, at.position).0 };
        let columns: Vec<DVec3> = (0..BASIS).map(column).collect();
        (0..3).flat_map(|c| columns.iter().map(move |column| f16::from_f64(column[c]))).collect()
    }

    /// Tilts about the surface's tangents, as first-order changes of the quaternion: shape 4, N_B.
    pub fn rotation(&self, at: &Placed) -> [[f64; BASIS]; 4] {
        let amplitude = 0.09 * self.liveliness(at) / (0.5 * BASIS as f64).sqrt();
        let mut rows = [[0.0; BASIS]; 4];
        for k in self.features(at) {
            let tilt = at.normal.cross(self.attribute_wave(k, at.position).1) * amplitude;
            let change = DQuat::from_xyzw(0.5 * tilt.x, 0.5 * tilt.y, 0.5 * tilt.z, 0.0) * at.rotation;
            for (row, value) in rows.iter_mut().zip([change.w, change.x, change.y, change.z]) {
                row[k] = value;
            }
        }
        rows
    }

    /// Log scale: stretched along the surface, not across it; shape 3, N_B.
    pub fn scale(&self, at: &Placed) -> [[f64; BASIS]; 3] {
        let amplitude = 0.08 * self.liveliness(at) / (0.5 * BASIS as f64).sqrt();
        let mut rows = [[0.0; BASIS]; 3];
        for k in self.features(at) {
            let height = self.attribute_wave(k, at.position).0;
            rows[0][k] = amplitude * height;
            rows[1][k] = amplitude * self.attribute_wave(k, at.position + DVec3::splat(0.02)).0;
            rows[2][k] = 0.3 * amplitude * height;
        }
        rows
    }

    /// Shading of the folds: brighter where they face the light; shape 3, N_B.
    pub fn color(&self, at: &Placed) -> [[f64; BASIS]; 3] {
        let amplitude = 0.10 * self.liveliness(at) / (0.5 * BASIS as f64).sqrt();
        let mut rows = [[0.0; BASIS]; 3];
        for k in self.features(at) {
            let facing = -self.attribute_wave(k, at.position).1.dot(KEY);
            (0..3).for_each(|c| rows[c][k] = amplitude * facing * at.color[c]);
        }
        rows
    }

    /// The features that waves answer to: in head parts those of the expression are left out.
    fn features(&self, at: &Placed) -> std::ops::Range<usize> {
        if at.head { SHARED..BASIS } else { 0..BASIS }
    }
}

/// Keeps the rows whose attribute varies most over the poses (model.md, step 2). What the last kept row has is taken off the others'
/// variance, so that nothing jumps where rows end. `covariance` is each part's, shape 2 N_B, 2 N_B.
pub fn keep<const C: usize>(all: &[[[f64; BASIS]; C]], part: &[usize], covariance: &[Vec<f64>], count: usize) -> Rows<C> {
    let variance: Vec<f64> =
        all.iter().zip(part).map(|(rows, &part)| rows.iter().map(|row| spread(row, &covariance[part])).sum()).collect();
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by(|&a, &b| variance[b].total_cmp(&variance[a]).then(a.cmp(&b)));
    let floor = order.get(count).map_or(0.0, |&i| variance[i]);
    order.truncate(count);
    order.sort_unstable();
    let faded = |&i: &usize| {
        let share = if variance[i] > 0.0 { (1.0 - floor / variance[i]).max(0.0).sqrt() } else { 0.0 };
        all[i].iter().flatten().map(move |value| f16::from_f64(share * value)).collect::<Vec<_>>()
    };
    Rows { basis: order.iter().flat_map(faded).collect(), gaussian: order.iter().map(|&i| i as u32).collect() }
}

/// bᵀ Σ b over the attribute features.
fn spread(row: &[f64; BASIS], covariance: &[f64]) -> f64 {
    (0..BASIS * BASIS).map(|k| (k / BASIS, k % BASIS)).map(|(i, j)| row[i] * row[j] * covariance[i * 2 * BASIS + j]).sum()
}
