//! Basis rows of nodes, rotation, scale and colour, for as long as none are learned.
//!
//! Each basis function is a wave over the body, of a length that suits what it moves. Cloth moves
//! most, and most near joints that bend. The waves of the shared features displace nodes, tilt
//! Gaussians and shade colours together, like folds do. In head parts the first features are the
//! expression, and their nodes' rows the real displacements of the face.

use crate::bake::networks::{BASIS, SHARED};
use crate::bake::sky::KEY;
use crate::bake::surface::Material;
use effigy_core::avatar::Rows;
use effigy_core::random::Random;
use glam::{DMat3, DQuat, DVec3};
use half::f16;
use std::f64::consts::TAU;
use std::ops::Range;

/// Joints whose bending folds cloth: hips, knees, spine, shoulders, elbows.
const BENDING_JOINTS: [usize; 11] = [1, 2, 3, 4, 5, 6, 9, 16, 17, 18, 19];
/// How far around a bending joint cloth folds, metres.
const BENDING_RADIUS: f64 = 0.13;
/// Displacement of a node by one feature of deviation 1, metres, for the liveliest place.
const NODE_AMPLITUDE: f64 = 0.0026;
/// Tilt of a Gaussian, radians.
const ROTATION_AMPLITUDE: f64 = 0.09;
/// Change of a log scale.
const SCALE_AMPLITUDE: f64 = 0.08;
/// Change of a colour, as a share of it.
const COLOR_AMPLITUDE: f64 = 0.10;

/// A Gaussian or node in the canonical pose.
#[derive(Clone, Debug)]
pub struct PlacedPoint {
    /// Metres.
    pub position: DVec3,
    /// Unit vector.
    pub normal: DVec3,
    /// Of the Gaussian's axes.
    pub rotation: DQuat,
    /// Display-referred.
    pub color: DVec3,
    /// Decides how lively the point is.
    pub material: Material,
    /// Displacements at full strength of each expression.
    pub expression: [DVec3; 10],
    /// The index of its part.
    pub part: usize,
    /// Whether the part sees the expression.
    pub head: bool,
}

/// A plane wave.
struct Wave {
    /// Radians a metre along each axis.
    vector: DVec3,
    /// Radians.
    phase: f64,
}

impl Wave {
    fn angle(&self, p: DVec3) -> f64 {
        self.vector.dot(p) + self.phase
    }

    /// From -1 to 1.
    fn height(&self, p: DVec3) -> f64 {
        self.angle(p).sin()
    }

    /// The direction of ascent, times the cosine of the phase.
    fn slope(&self, p: DVec3) -> DVec3 {
        self.vector.normalize_or(DVec3::Y) * self.angle(p).cos()
    }
}

/// The waves of one bake.
pub struct Bases {
    /// The nodes' waves, then the attributes'; of the latter the shared ones are not used.
    waves: Vec<Wave>,
    /// Joints that bend, canonical pose.
    bending_joints: Vec<DVec3>,
}

impl Bases {
    /// `joints`: the skeleton's, canonical pose.
    pub fn new(seed: u64, joints: &[DVec3]) -> Self {
        // Other uses of the seed draw from other streams.
        const STREAM: u64 = 2000;
        let mut random = Random::new(seed, STREAM);
        let mut wave = || {
            let length = random.range(0.055, 0.15);
            // Folds run around limbs and waist: waves lie mostly along the body's height.
            let direction =
                (random.direction() + DVec3::Y * random.range(-1.0, 1.0)).normalize_or(DVec3::Y);
            Wave {
                vector: direction * TAU / length,
                phase: random.range(0.0, TAU),
            }
        };
        Self {
            waves: (0..2 * BASIS).map(|_| wave()).collect(),
            bending_joints: BENDING_JOINTS
                .iter()
                .filter_map(|&j| joints.get(j).copied())
                .collect(),
        }
    }

    /// How much a place moves beyond its joints, 0 to 1.
    fn liveliness(&self, at: &PlacedPoint) -> f64 {
        let nearness =
            |joint: &DVec3| (-(joint.distance(at.position) / BENDING_RADIUS).powi(2)).exp();
        let near = self.bending_joints.iter().map(nearness).fold(0.0, f64::max);
        let material = match at.material {
            Material::Shirt | Material::Trousers => 1.0,
            Material::Hair => 0.3,
            Material::Skin => 0.18,
            _ => 0.08,
        };
        material * (0.12 + 0.88 * near)
    }

    /// The part of an amplitude that each feature has at a place, so that all together reach it.
    fn amplitude(&self, whole: f64, at: &PlacedPoint) -> f64 {
        whole * self.liveliness(at) / (0.5 * BASIS as f64).sqrt()
    }

    /// The wave of an attribute's feature; the first are shared with the nodes.
    fn attribute_wave(&self, k: usize) -> &Wave {
        &self.waves[if k < SHARED { k } else { BASIS + k }]
    }

    /// The attributes' features that have waves: in head parts not the expression's.
    fn attribute_features(&self, at: &PlacedPoint) -> Range<usize> {
        if at.head { SHARED..BASIS } else { 0..BASIS }
    }

    /// A node's row, metres a unit of feature: shape 3, N_B. `to_canonical`: from the rest pose.
    pub fn node_row(&self, at: &PlacedPoint, to_canonical: DMat3) -> Vec<f16> {
        let amplitude = self.amplitude(NODE_AMPLITUDE, at);
        let expressions = if at.head {
            at.expression.len().min(BASIS)
        } else {
            0
        };
        let column = |k: usize| {
            if k < expressions {
                to_canonical * at.expression[k]
            } else {
                at.normal * amplitude * self.waves[k].height(at.position)
            }
        };
        let columns: Vec<DVec3> = (0..BASIS).map(column).collect();
        (0..3)
            .flat_map(|c| columns.iter().map(move |column| f16::from_f64(column[c])))
            .collect()
    }

    /// Tilts about the surface's tangents, as first-order changes of the quaternion w x y z: shape
    /// 4, N_B.
    pub fn rotation_row(&self, at: &PlacedPoint) -> [[f64; BASIS]; 4] {
        let amplitude = self.amplitude(ROTATION_AMPLITUDE, at);
        let mut row = [[0.0; BASIS]; 4];
        for k in self.attribute_features(at) {
            let slope = self.attribute_wave(k).slope(at.position);
            let tilt = at.normal.cross(slope) * amplitude;
            let change =
                DQuat::from_xyzw(0.5 * tilt.x, 0.5 * tilt.y, 0.5 * tilt.z, 0.0) * at.rotation;
            row[0][k] = change.w;
            row[1][k] = change.x;
            row[2][k] = change.y;
            row[3][k] = change.z;
        }
        row
    }

    /// Changes of the log scale: stretched along the surface, little across it; shape 3, N_B.
    pub fn scale_row(&self, at: &PlacedPoint) -> [[f64; BASIS]; 3] {
        let amplitude = self.amplitude(SCALE_AMPLITUDE, at);
        let mut row = [[0.0; BASIS]; 3];
        for k in self.attribute_features(at) {
            let wave = self.attribute_wave(k);
            let height = wave.height(at.position);
            row[0][k] = amplitude * height;
            row[1][k] = amplitude * wave.height(at.position + DVec3::splat(0.02));
            row[2][k] = 0.3 * amplitude * height;
        }
        row
    }

    /// Shading of the folds: brighter where they face the key light; shape 3, N_B.
    pub fn color_row(&self, at: &PlacedPoint) -> [[f64; BASIS]; 3] {
        let amplitude = self.amplitude(COLOR_AMPLITUDE, at);
        let mut row = [[0.0; BASIS]; 3];
        for k in self.attribute_features(at) {
            let facing = -self.attribute_wave(k).slope(at.position).dot(KEY);
            for (c, row) in row.iter_mut().enumerate() {
                row[k] = amplitude * facing * at.color[c];
            }
        }
        row
    }
}

/// Retains the `count` rows whose attribute varies most over the poses (model.md, step 2). Each is
/// weakened by the variance of the first row that is left out, so that nothing jumps where rows
/// end. `part`: of each row; `covariances`: of each part's features, shape 2 N_B, 2 N_B.
pub fn retain_rows<const C: usize>(
    all: &[[[f64; BASIS]; C]],
    part: &[usize],
    covariances: &[Vec<f64>],
    count: usize,
) -> Rows<C> {
    let variance: Vec<f64> = all
        .iter()
        .zip(part)
        .map(|(row, &part)| {
            let covariance = &covariances[part];
            row.iter().map(|b| component_variance(b, covariance)).sum()
        })
        .collect();
    let mut order: Vec<usize> = (0..all.len()).collect();
    order.sort_by(|&a, &b| variance[b].total_cmp(&variance[a]).then(a.cmp(&b)));
    let floor = order.get(count).map_or(0.0, |&i| variance[i]);
    order.truncate(count);
    order.sort_unstable();
    let mut basis: Vec<f16> = Vec::with_capacity(order.len() * C * BASIS);
    for &i in &order {
        let share = if variance[i] > 0.0 {
            (1.0 - floor / variance[i]).max(0.0).sqrt()
        } else {
            0.0
        };
        let numbers = all[i].iter().flatten();
        basis.extend(numbers.map(|value| f16::from_f64(share * value)));
    }
    Rows {
        gaussian: order.iter().map(|&i| i as u32).collect(),
        basis: basis.into(),
    }
}

/// The variance of one component of a corrective: bᵀ Σ b over the attributes' features.
fn component_variance(b: &[f64; BASIS], covariance: &[f64]) -> f64 {
    (0..BASIS * BASIS)
        .map(|k| (k / BASIS, k % BASIS))
        .map(|(i, j)| b[i] * b[j] * covariance[i * 2 * BASIS + j])
        .sum()
}
