//! What is learned, as flat arrays in the order that kernels read them, and the way from and to an
//! avatar.

use crate::topology::{CorrectiveRows, Topology};
use effigy_core::avatar::{Avatar, Matrix, ROW_COMPONENTS, Rows as AvatarRows};
use effigy_core::layout::TRAIN_BASIS;
use half::f16;
use std::ops::Range;

/// N_B.
pub const BASIS: usize = TRAIN_BASIS as usize;
/// Numbers of a Gaussian: quaternion (4), log scale (3), logit of the opacity, colour (3), spare.
pub const GAUSSIAN: usize = 12;

/// What is learned, or one number for each of it: derivatives, moments.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters<T> {
    /// Shape N_g, [`GAUSSIAN`].
    pub gaussians: Vec<T>,
    /// Offsets of nodes, shape N_s, 3, metres; from [`ParameterLayout::node_bases`] on their bases, shape
    /// N_s, 3, N_B.
    pub nodes: Vec<T>,
    /// Of each layer the weights of all parts, shape N_G, input, output; then its biases, shape N_G,
    /// output.
    pub networks: Vec<T>,
    /// Basis rows of rotation, scale and colour, each of shape rows, C, N_B.
    pub bases: Vec<T>,
}

/// Where a layer's numbers lie in [`Parameters::networks`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LayerPlace {
    /// Numbers that enter.
    pub input: usize,
    /// Numbers that leave.
    pub output: usize,
    /// Where the weights begin.
    pub weights: usize,
    /// Where the biases begin.
    pub biases: usize,
}

/// Where everything lies in [`Parameters`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParameterLayout {
    /// N_g.
    pub gaussians: usize,
    /// N_s.
    pub nodes: usize,
    /// N_G.
    pub parts: usize,
    /// Where the nodes' bases begin in [`Parameters::nodes`].
    pub node_bases: usize,
    /// The networks' layers.
    pub layers: Vec<LayerPlace>,
    /// Where the rows of rotation, scale and colour begin in [`Parameters::bases`], and where they
    /// end.
    pub bases: [usize; 4],
}

impl ParameterLayout {
    /// The layout for a topology with some basis rows.
    pub fn new(topology: &Topology, rows: &CorrectiveRows) -> Self {
        let nodes = topology.nodes();
        let parts = topology.parts();
        let mut at = 0;
        let mut take = |numbers: usize| {
            let first = at;
            at += numbers;
            first
        };
        let layers = topology
            .widths
            .windows(2)
            .map(|pair| LayerPlace {
                input: pair[0],
                output: pair[1],
                weights: take(parts * pair[0] * pair[1]),
                biases: take(parts * pair[1]),
            })
            .collect();
        let mut bases = [0; 4];
        for (attribute, components) in ROW_COMPONENTS.into_iter().enumerate() {
            let numbers = rows.gaussian[attribute].len() * components * BASIS;
            bases[attribute + 1] = bases[attribute] + numbers;
        }
        Self {
            gaussians: topology.gaussians.len(),
            nodes,
            parts,
            // Where storage buffers may begin: kernels bind both halves by themselves.
            node_bases: (3 * nodes).next_multiple_of(64),
            layers,
            bases,
        }
    }

    /// Numbers of each array, in the order of [`Parameters`].
    pub fn lengths(&self) -> [usize; 4] {
        let networks = self
            .layers
            .last()
            .map_or(0, |layer| layer.biases + self.parts * layer.output);
        [
            self.gaussians * GAUSSIAN,
            self.node_bases + self.nodes * 3 * BASIS,
            networks,
            self.bases[3],
        ]
    }

    /// The numbers of a row of an attribute in [`Parameters::bases`].
    pub fn row(&self, attribute: usize, row: usize) -> Range<usize> {
        let length = ROW_COMPONENTS[attribute] * BASIS;
        let first = self.bases[attribute] + row * length;
        first..first + length
    }

    /// The numbers of a node's basis in [`Parameters::nodes`].
    pub fn node_basis(&self, node: usize) -> Range<usize> {
        let first = self.node_bases + node * 3 * BASIS;
        first..first + 3 * BASIS
    }
}

impl<T: Copy + Default> Parameters<T> {
    /// Zeros.
    pub fn zeros(layout: &ParameterLayout) -> Self {
        let [gaussians, nodes, networks, bases] = layout.lengths();
        Self {
            gaussians: vec![T::default(); gaussians],
            nodes: vec![T::default(); nodes],
            networks: vec![T::default(); networks],
            bases: vec![T::default(); bases],
        }
    }

    /// All arrays.
    pub fn arrays(&self) -> [&[T]; 4] {
        [&self.gaussians, &self.nodes, &self.networks, &self.bases]
    }

    /// All arrays, to be changed.
    pub fn arrays_mut(&mut self) -> [&mut Vec<T>; 4] {
        [
            &mut self.gaussians,
            &mut self.nodes,
            &mut self.networks,
            &mut self.bases,
        ]
    }
}

impl Parameters<f32> {
    /// What an avatar says, for [`CorrectiveRows::of`] it.
    ///
    /// # Panics
    /// Where `Avatar::check` finds a fault.
    pub fn of(avatar: &Avatar, layout: &ParameterLayout) -> Self {
        let mut all = Self::zeros(layout);
        let neutral = &avatar.gaussians;
        for (k, numbers) in all.gaussians.chunks_exact_mut(GAUSSIAN).enumerate() {
            let floats = |v: &[f16], to: &mut [f32]| {
                for (to, v) in to.iter_mut().zip(v) {
                    *to = v.to_f32();
                }
            };
            floats(&neutral.rotation[k], &mut numbers[..4]);
            floats(&neutral.log_scale[k], &mut numbers[4..7]);
            numbers[7] = logit(f64::from(neutral.opacity[k]) / 255.0) as f32;
            floats(&neutral.color[k], &mut numbers[8..11]);
        }
        for node in 0..layout.nodes {
            for (c, offset) in avatar.nodes.offset[node].iter().enumerate() {
                all.nodes[3 * node + c] = offset.to_f32();
            }
            let row = avatar.nodes.basis.row(node, 3 * BASIS);
            copy(row.iter(), &mut all.nodes[layout.node_basis(node)]);
        }
        for (layer, place) in avatar.networks.layers.iter().zip(&layout.layers) {
            for part in 0..layout.parts {
                for neuron in 0..place.output {
                    let row = part * place.output + neuron;
                    let weights = layer.weight.row(row, place.input);
                    for (i, weight) in weights.iter().enumerate() {
                        let at = place.weights + (part * place.input + i) * place.output + neuron;
                        all.networks[at] = weight as f32;
                    }
                    all.networks[place.biases + row] = layer.bias[row].to_f32();
                }
            }
        }
        let rows = [
            &avatar.rotation_rows.basis,
            &avatar.scale_rows.basis,
            &avatar.color_rows.basis,
        ];
        for (attribute, matrix) in rows.into_iter().enumerate() {
            let length = ROW_COMPONENTS[attribute] * BASIS;
            for (at, row) in matrix.rows(length).enumerate() {
                copy(row.iter(), &mut all.bases[layout.row(attribute, at)]);
            }
        }
        all
    }

    /// Puts what was learned into the avatar that the topology is of, rounded to what files hold.
    pub fn put_into(&self, avatar: &mut Avatar, layout: &ParameterLayout, rows: &CorrectiveRows) {
        let half = |v: f32| f16::from_f32(v.clamp(-65504.0, 65504.0));
        let neutral = &mut avatar.gaussians;
        for (k, numbers) in self.gaussians.chunks_exact(GAUSSIAN).enumerate() {
            neutral.rotation[k] = std::array::from_fn(|c| half(numbers[c]));
            neutral.log_scale[k] = std::array::from_fn(|c| half(numbers[4 + c]));
            let opacity = 255.0 * sigmoid(f64::from(numbers[7]));
            neutral.opacity[k] = opacity.round() as u8;
            neutral.color[k] = std::array::from_fn(|c| half(numbers[8 + c].clamp(0.0, 1.0)));
        }
        for node in 0..layout.nodes {
            avatar.nodes.offset[node] = std::array::from_fn(|c| half(self.nodes[3 * node + c]));
        }
        let node_bases = &self.nodes[layout.node_bases..];
        avatar.nodes.basis = node_bases.iter().map(|&v| half(v)).collect();
        for (layer, place) in avatar.networks.layers.iter_mut().zip(&layout.layers) {
            let mut weights = Vec::with_capacity(layout.parts * place.input * place.output);
            for part in 0..layout.parts {
                for neuron in 0..place.output {
                    for i in 0..place.input {
                        let at = place.weights + (part * place.input + i) * place.output + neuron;
                        weights.push(half(self.networks[at]));
                    }
                }
            }
            layer.weight = Matrix::from(weights);
            let biases = &self.networks[place.biases..][..layout.parts * place.output];
            layer.bias = biases.iter().map(|&v| half(v)).collect();
        }
        let basis = |attribute: usize| {
            let all = &self.bases[layout.bases[attribute]..layout.bases[attribute + 1]];
            all.iter().map(|&v| half(v)).collect()
        };
        avatar.rotation_rows = AvatarRows {
            gaussian: rows.gaussian[0].clone(),
            basis: basis(0),
        };
        avatar.scale_rows = AvatarRows {
            gaussian: rows.gaussian[1].clone(),
            basis: basis(1),
        };
        avatar.color_rows = AvatarRows {
            gaussian: rows.gaussian[2].clone(),
            basis: basis(2),
        };
    }

    /// The same numbers in f64.
    pub fn doubles(&self) -> Parameters<f64> {
        let doubles = |v: &[f32]| v.iter().map(|&v| f64::from(v)).collect();
        Parameters {
            gaussians: doubles(&self.gaussians),
            nodes: doubles(&self.nodes),
            networks: doubles(&self.networks),
            bases: doubles(&self.bases),
        }
    }
}

fn copy(from: impl Iterator<Item = f64>, to: &mut [f32]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = from as f32;
    }
}

/// 1 / (1 + e^−x).
pub fn sigmoid(x: f64) -> f64 {
    1.0 / (1.0 + (-x).exp())
}

/// The inverse of [`sigmoid`], for what bytes can hold of opacities.
pub fn logit(opacity: f64) -> f64 {
    let inside = opacity.clamp(0.5 / 255.0, 254.5 / 255.0);
    (inside / (1.0 - inside)).ln()
}
