//! The teacher: features of its networks, and what its Gaussians look like.
//!
//! With e_a the features of anchor a for the rotations of joints 1 to 21, w the weights of a
//! Gaussian's three anchors and v those of its three nodes (of its training code,
//! `scene/gaussian_model.py`):
//!
//! ```text
//! e  = Σ w_a e_a[..B]                 of a Gaussian
//! dx = offset + Σ_c e'_c B_s[c]       of a node; e' = Σ w_a e_a[B..], by its own anchors
//! x  = position + Σ v_s dx_s          canonical pose, before skinning
//! q  = q₀ + Σ_b e_b B_q[b], and so on for log scale, harmonics and opacity before its sigmoid
//! G  = Σ_j weight_j G_j over all joints; Σ' = (G₃ₓ₃ R diag s)(G₃ₓ₃ R diag s)ᵀ
//! ```
//!
//! Colour is 0.5 + Y₀ sh₀ + Y₁(d) · sh₁, not below 0, for the direction d from the Gaussian to the
//! camera, turned back by G₃ₓ₃ᵀ.

use effigy_core::avatar::{Activation, Facing, Pose};
use effigy_core::constants::{FEATURE_MAX, LEAKY_SLOPE};
use effigy_core::io::file::FormatError;
use effigy_core::reference::project;
use effigy_formats::mmlphuman::{Blend, Checkpoint, NetworkSource};
use effigy_math::matrix::{MatrixView, multiply};
use glam::{DAffine3, DMat3, DVec3};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// √(3 / 4π), of the harmonics of degree 1.
const DEGREE_1: f64 = 0.488_602_511_902_919_9;
/// Rows of a product, so that activations stay in a core's cache.
const BATCH: usize = 256;

/// The features of every anchor for rows of inputs.
pub struct AnchorFeatures {
    /// Features of an anchor.
    pub width: usize,
    /// Number of rows.
    pub rows: usize,
    /// One an anchor, of shape rows, width.
    anchors: Vec<Vec<f32>>,
}

impl AnchorFeatures {
    /// Evaluates every network for rows of inputs, in f32. `done` is called with the number of
    /// networks that are.
    ///
    /// # Errors
    /// When a weight is not finite, or a feature is larger than an avatar's may be.
    pub fn new(
        networks: &NetworkSource,
        inputs: &[f32],
        done: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, FormatError> {
        let rows = inputs.len() / networks.widths[0].max(1);
        let finished = AtomicUsize::new(0);
        let evaluate = |anchor: usize| {
            let features = evaluate(networks, anchor, inputs, rows)?;
            done(finished.fetch_add(1, Ordering::Relaxed) + 1);
            Ok(features)
        };
        Ok(Self {
            width: networks.widths.last().copied().unwrap_or_default(),
            rows,
            anchors: (0..networks.count)
                .into_par_iter()
                .map(evaluate)
                .collect::<Result<_, FormatError>>()?,
        })
    }

    /// One row of features of every anchor, given.
    pub fn of_means(means: &[Vec<f32>]) -> Self {
        Self {
            width: means.first().map_or(0, Vec::len),
            rows: 1,
            anchors: means.to_vec(),
        }
    }

    /// The features of an anchor for a row.
    pub fn of(&self, anchor: usize, row: usize) -> &[f32] {
        &self.anchors[anchor][row * self.width..][..self.width]
    }

    /// The mean features of every anchor over some rows.
    pub fn means(&self, rows: &[usize]) -> Vec<Vec<f32>> {
        let mean = |anchor: usize| {
            let mut sum = vec![0.0f64; self.width];
            for &row in rows {
                for (sum, &e) in sum.iter_mut().zip(self.of(anchor, row)) {
                    *sum += f64::from(e);
                }
            }
            let count = rows.len().max(1) as f64;
            sum.iter().map(|sum| (sum / count) as f32).collect()
        };
        (0..self.anchors.len()).into_par_iter().map(mean).collect()
    }
}

/// The features of one anchor for all rows.
fn evaluate(
    networks: &NetworkSource,
    anchor: usize,
    inputs: &[f32],
    rows: usize,
) -> Result<Vec<f32>, FormatError> {
    let layers = networks.network(anchor)?;
    let slope = match networks.activation {
        Activation::Relu => 0.0,
        Activation::LeakyRelu => LEAKY_SLOPE as f32,
    };
    let width = networks.widths[0];
    let mut features = Vec::with_capacity(rows * networks.widths.last().copied().unwrap_or(0));
    for batch in inputs.chunks(BATCH * width) {
        let count = batch.len() / width;
        let mut x = batch.to_vec();
        for (at, layer) in layers.iter().enumerate() {
            let mut y: Vec<f32> = layer.bias.repeat(count);
            multiply(
                MatrixView::new(&x, count, layer.input),
                MatrixView::new(&layer.weight, layer.output, layer.input).transposed(),
                1.0,
                &mut y,
            );
            if at + 1 < layers.len() {
                for y in &mut y {
                    *y = y.max(slope * *y);
                }
            }
            x = y;
        }
        features.extend(x);
    }
    let limit = FEATURE_MAX as f32;
    let too_large = |feature: &&f32| feature.is_nan() || feature.abs() > limit;
    match features.iter().find(too_large) {
        Some(feature) => Err(FormatError::Tensor {
            tensor: "encoder_feat_params".into(),
            found: format!("weights of network {anchor} that give the feature {feature}"),
            expected: format!("features within ±{limit}, as an avatar has them"),
        }),
        None => Ok(features),
    }
}

/// What Gaussians look like in the canonical pose, before skinning, for one row of inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct TeacherAppearance {
    /// Metres.
    pub position: Vec<DVec3>,
    /// Quaternion w x y z, of any length.
    pub rotation: Vec<[f64; 4]>,
    /// Natural logarithm of metres.
    pub log_scale: Vec<[f64; 3]>,
    /// RGB of the harmonic of degree 0, not clamped.
    pub color: Vec<[f64; 3]>,
    /// RGB of the three harmonics of degree 1; empty where there are none.
    pub harmonics: Vec<[f64; 9]>,
    /// 0 to 1.
    pub opacity: Vec<f64>,
}

/// A checkpoint as a model that is evaluated.
#[derive(Clone, Copy)]
pub struct Teacher<'c, 'p> {
    /// The file.
    pub checkpoint: &'c Checkpoint<'p>,
}

/// Σ of a row's others: features times weights.
fn blended(blend: &Blend, row: usize, features: &dyn Fn(usize) -> Vec<f64>) -> Vec<f64> {
    let mut sum = Vec::new();
    for share in blend.of(row) {
        let own = features(share.index);
        sum.resize(own.len(), 0.0);
        for (sum, e) in sum.iter_mut().zip(own) {
            *sum += f64::from(share.weight) * e;
        }
    }
    sum
}

/// `neutral` plus what features add; `basis` has shape N, features, C.
fn added<const C: usize>(neutral: [f32; C], basis: &[f32], row: usize, e: &[f64]) -> [f64; C] {
    let own = &basis[row * e.len() * C..][..e.len() * C];
    let mut sum = neutral.map(f64::from);
    for (e, along) in e.iter().zip(own.as_chunks::<C>().0) {
        for (sum, &along) in sum.iter_mut().zip(along) {
            *sum += e * f64::from(along);
        }
    }
    sum
}

/// 1 / (1 + e^−x).
pub fn sigmoid(x: f64) -> f64 {
    1.0 / (1.0 + (-x).exp())
}

impl Teacher<'_, '_> {
    /// Displacement of every node for a row of features, metres.
    pub fn displacements(&self, features: &AnchorFeatures, row: usize) -> Vec<DVec3> {
        let Checkpoint {
            nodes,
            basis,
            node_basis,
            ..
        } = self.checkpoint;
        let own = *basis..basis + node_basis;
        let of_anchor = |anchor: usize| {
            let features = &features.of(anchor, row)[own.clone()];
            features.iter().map(|&e| f64::from(e)).collect()
        };
        let displacement = |node: usize| {
            let e = match &nodes.basis {
                Some(_) => blended(&nodes.anchors, node, &of_anchor),
                None => vec![],
            };
            let basis = nodes.basis.as_deref().unwrap_or_default();
            DVec3::from(added(nodes.offset[node], basis, node, &e))
        };
        (0..nodes.offset.len())
            .into_par_iter()
            .map(displacement)
            .collect()
    }

    /// What every Gaussian looks like for a row of features, in f64.
    pub fn look(&self, features: &AnchorFeatures, row: usize) -> TeacherAppearance {
        let Checkpoint {
            gaussians,
            gaussian_anchors,
            gaussian_nodes,
            bases,
            basis,
            color_unit,
            ..
        } = self.checkpoint;
        let moved = self.displacements(features, row);
        let of_anchor = |anchor: usize| {
            let features = &features.of(anchor, row)[..*basis];
            features.iter().map(|&e| f64::from(e)).collect()
        };
        let count = self.checkpoint.len();
        let features_of = |k: usize| match bases {
            Some(_) => blended(gaussian_anchors, k, &of_anchor),
            None => vec![],
        };
        let e: Vec<Vec<f64>> = (0..count).into_par_iter().map(features_of).collect();
        let bases = |k: usize| bases.as_ref().map(|bases| (bases, &e[k][..]));
        let plain = 0..count;
        TeacherAppearance {
            position: plain
                .clone()
                .map(|k| {
                    let shares = gaussian_nodes.of(k);
                    let moves = shares.map(|share| f64::from(share.weight) * moved[share.index]);
                    gaussians.position[k] + moves.sum::<DVec3>()
                })
                .collect(),
            rotation: plain
                .clone()
                .map(|k| match bases(k) {
                    Some((bases, e)) => added(gaussians.rotation[k], &bases.rotation, k, e),
                    None => gaussians.rotation[k].map(f64::from),
                })
                .collect(),
            log_scale: plain
                .clone()
                .map(|k| match bases(k) {
                    Some((bases, e)) => added(gaussians.log_scale[k], &bases.log_scale, k, e),
                    None => gaussians.log_scale[k].map(f64::from),
                })
                .collect(),
            color: plain
                .clone()
                .map(|k| {
                    let coefficient = match bases(k) {
                        Some((bases, e)) => added(gaussians.color[k], &bases.color, k, e),
                        None => gaussians.color[k].map(f64::from),
                    };
                    coefficient.map(|c| 0.5 + color_unit * c)
                })
                .collect(),
            harmonics: (0..gaussians.harmonics.len())
                .map(|k| {
                    let coefficient = match bases(k) {
                        Some((bases, e)) => added(gaussians.harmonics[k], &bases.harmonics, k, e),
                        None => gaussians.harmonics[k].map(f64::from),
                    };
                    coefficient.map(|c| DEGREE_1 * c)
                })
                .collect(),
            opacity: plain
                .map(|k| {
                    let [logit] = match bases(k) {
                        Some((bases, e)) => added([gaussians.opacity[k]], &bases.opacity, k, e),
                        None => [f64::from(gaussians.opacity[k])],
                    };
                    sigmoid(logit)
                })
                .collect(),
        }
    }

    /// Blended joint matrices of every Gaussian in a pose.
    pub fn skinning(&self, pose: &Pose) -> Vec<DAffine3> {
        let joints = self.checkpoint.skeleton.matrices(pose);
        let blend = |weights: &[f32]| {
            let zero = DAffine3::from_mat3_translation(DMat3::ZERO, DVec3::ZERO);
            joints
                .iter()
                .zip(weights)
                .fold(zero, |mut g, (joint, &weight)| {
                    g.matrix3 += f64::from(weight) * joint.matrix3;
                    g.translation += f64::from(weight) * joint.translation;
                    g
                })
        };
        let skin = self.checkpoint.skin.par_chunks_exact(joints.len().max(1));
        skin.map(blend).collect()
    }

    /// The Gaussians of a look in a pose, as a camera at `eye` sees them. Opacity is rounded to 8
    /// bits.
    pub fn posed(
        &self,
        look: &TeacherAppearance,
        pose: &Pose,
        eye: DVec3,
    ) -> Vec<project::Gaussian> {
        let skinning = self.skinning(pose);
        let gaussian = |k: usize| {
            let g = &skinning[k];
            let mean = g.transform_point3(look.position[k]);
            let to_camera = g.matrix3.transpose() * (eye - mean).normalize_or_zero();
            let color = DVec3::from(look.color[k]) + degree_1(look.harmonics.get(k), to_camera);
            project::Gaussian {
                mean,
                axes: g.matrix3
                    * DMat3::from_quat(project::rotation(look.rotation[k], [0.0; 4]))
                    * DMat3::from_diagonal(DVec3::from(look.log_scale[k]).exp()),
                color: color.clamp(DVec3::ZERO, DVec3::ONE),
                opacity: (255.0 * look.opacity[k]).round() as u8,
                facing: Facing::EVERYWHERE,
            }
        };
        (0..look.position.len())
            .into_par_iter()
            .map(gaussian)
            .collect()
    }
}

/// RGB of the harmonics of degree 1 in a direction of any length, which the training code
/// normalises.
fn degree_1(harmonics: Option<&[f64; 9]>, direction: DVec3) -> DVec3 {
    let d = direction.normalize_or_zero();
    harmonics.map_or(DVec3::ZERO, |own| {
        let triple = |at: usize| DVec3::new(own[3 * at], own[3 * at + 1], own[3 * at + 2]);
        d.z * triple(1) - d.y * triple(0) - d.x * triple(2)
    })
}
