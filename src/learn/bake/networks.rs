//! One small random network a part, for as long as none are learned.
//!
//! Networks of neighbouring parts are alike: each weight is a mixture of four drawn ones, and the
//! mixture drifts over the body, so that features hardly jump where parts meet. A part depends most
//! on the joints near it. Over the clips' poses every feature has mean 0 and deviation 1. In head
//! parts the nodes' first features are the expression itself, carried through the hidden layers by
//! pairs of neurons: leaky(x) − leaky(−x) = 1.01 x.

use effigy_core::avatar::{Activation, NetworkLayer, Networks};
use effigy_core::constants::LEAKY_SLOPE;
use effigy_core::random::Random;
use effigy_math::noise::noise;
use glam::DVec3;
use half::f16;
use rayon::prelude::*;
use std::ops::Range;

/// N_B.
pub const BASIS: usize = 16;
/// Features that nodes and attributes share: a fold then moves and shades together.
pub const SHARED: usize = 8;
/// Neurons of each hidden layer.
const WIDTH: usize = 64;
const LAYERS: usize = 4;
/// How many drawn networks each part's is a mixture of.
const MIXTURE: usize = 4;
/// How far a joint is felt, metres.
const INFLUENCE_RADIUS: f64 = 0.28;

/// The parts, joints and poses that networks are drawn for.
pub struct NetworkPlan<'a> {
    /// Equal seeds give equal networks.
    pub seed: u64,
    /// The centre of each part, canonical pose.
    pub centers: &'a [DVec3],
    /// Parts before this one see the expression.
    pub head: usize,
    /// The joints that θ_p consists of, canonical pose.
    pub joints: &'a [DVec3],
    /// The length of θ_e.
    pub expression: usize,
    /// θ_p ⊕ θ_e of the clips' poses, projected.
    pub inputs: &'a [Vec<f64>],
}

/// The networks of all parts.
pub struct RandomNetworks {
    /// All layers, with the parts one after another.
    pub networks: Networks,
    /// For each part the covariance of its features over the poses, shape 2 N_B, 2 N_B.
    pub covariances: Vec<Vec<f64>>,
}

/// The network of one part.
struct PartNetwork {
    layers: Vec<LinearLayer>,
    covariance: Vec<f64>,
}

/// A linear layer of one part.
struct LinearLayer {
    input: usize,
    /// Shape output, input.
    weight: Vec<f64>,
    bias: Vec<f64>,
}

/// The inputs and outputs of a layer.
#[derive(Clone, Copy)]
struct LayerSize {
    input: usize,
    output: usize,
}

/// Draws the networks of a plan.
pub fn random_networks(plan: &NetworkPlan) -> RandomNetworks {
    let widths = [
        3 * plan.joints.len() + plan.expression,
        WIDTH,
        WIDTH,
        WIDTH,
        2 * BASIS,
    ];
    let sizes: [LayerSize; LAYERS] = std::array::from_fn(|l| LayerSize {
        input: widths[l],
        output: widths[l + 1],
    });
    let parts: Vec<PartNetwork> = (0..plan.centers.len())
        .into_par_iter()
        .map(|part| part_network(plan, part, &sizes))
        .collect();
    let layer = |l: usize| {
        let own = || parts.iter().map(|part| &part.layers[l]);
        let half = |&number: &f64| f16::from_f64(number);
        NetworkLayer {
            input: sizes[l].input,
            output: sizes[l].output,
            weight: own()
                .flat_map(|layer| layer.weight.iter().map(half))
                .collect(),
            bias: own()
                .flat_map(|layer| layer.bias.iter().map(half))
                .collect(),
        }
    };
    RandomNetworks {
        networks: Networks {
            activation: Activation::LeakyRelu,
            layers: (0..LAYERS).map(layer).collect(),
        },
        covariances: parts.into_iter().map(|part| part.covariance).collect(),
    }
}

impl LinearLayer {
    fn apply(&self, x: &[f64]) -> Vec<f64> {
        self.weight
            .chunks_exact(self.input)
            .zip(&self.bias)
            .map(|(row, bias)| bias + row.iter().zip(x).map(|(w, x)| w * x).sum::<f64>())
            .collect()
    }

    fn row_mut(&mut self, row: usize) -> &mut [f64] {
        &mut self.weight[row * self.input..][..self.input]
    }

    /// Rounds to f16, as the avatar stores it.
    fn round(&mut self) {
        for number in self.weight.iter_mut().chain(&mut self.bias) {
            *number = f16::from_f64(*number).to_f64();
        }
    }
}

fn part_network(plan: &NetworkPlan, part: usize, sizes: &[LayerSize; LAYERS]) -> PartNetwork {
    let center = plan.centers[part];
    let is_head = part < plan.head;
    let mixture = mixture(plan.seed, center);
    let mut layers: Vec<LinearLayer> = sizes
        .iter()
        .enumerate()
        .map(|(l, &size)| mixed_layer(plan.seed, l, size, &mixture))
        .collect();
    // Nearer joints count more; the expression not at all.
    for (k, weight) in layers[0].weight.iter_mut().enumerate() {
        let input = k % sizes[0].input;
        *weight *= match plan.joints.get(input / 3) {
            Some(joint) => {
                let near = (-(joint.distance(center) / INFLUENCE_RADIUS).powi(2)).exp();
                2.5 * (0.06 + near)
            }
            None => 0.0,
        };
    }
    if is_head {
        carry_expression(&mut layers, plan);
    }
    for layer in &mut layers {
        layer.round();
    }
    let hidden: Vec<Vec<f64>> = plan
        .inputs
        .iter()
        .map(|input| {
            let mut x = input.clone();
            if !is_head {
                let body = x.len() - plan.expression;
                x[body..].fill(0.0);
            }
            for layer in &layers[..LAYERS - 1] {
                x = layer.apply(&x).into_iter().map(leaky_relu).collect();
            }
            x
        })
        .collect();
    let expression = if is_head {
        BASIS..BASIS + plan.expression.min(BASIS)
    } else {
        0..0
    };
    normalise(&mut layers[LAYERS - 1], &hidden, expression);
    let covariance = covariance(&layers[LAYERS - 1], &hidden);
    PartNetwork { layers, covariance }
}

fn leaky_relu(x: f64) -> f64 {
    x.max(LEAKY_SLOPE * x)
}

/// The shares of the drawn networks at a place; a unit vector.
fn mixture(seed: u64, center: DVec3) -> [f64; MIXTURE] {
    let shares: [f64; MIXTURE] = std::array::from_fn(|m| {
        let base = if m == 0 { 0.6 } else { 0.0 };
        noise(seed + 500 + m as u64, center * 2.2) + base
    });
    let length = shares.iter().map(|m| m * m).sum::<f64>().sqrt().max(1e-9);
    shares.map(|m| m / length)
}

/// A layer with weights of deviation √(2 / inputs), mixed from drawn ones that all parts have in
/// common.
fn mixed_layer(seed: u64, layer: usize, size: LayerSize, mixture: &[f64; MIXTURE]) -> LinearLayer {
    // Other uses of the seed draw from other streams.
    const STREAM: usize = 1000;
    let mut random: Vec<Random> = (0..MIXTURE)
        .map(|m| Random::new(seed, (STREAM + layer * MIXTURE + m) as u64))
        .collect();
    let mut draw = |deviation: f64| {
        deviation
            * mixture
                .iter()
                .zip(&mut random)
                .map(|(share, random)| share * random.normal())
                .sum::<f64>()
    };
    let deviation = (2.0 / size.input as f64).sqrt();
    LinearLayer {
        input: size.input,
        weight: (0..size.input * size.output)
            .map(|_| draw(deviation))
            .collect(),
        bias: (0..size.output).map(|_| draw(0.2)).collect(),
    }
}

/// Reserves two neurons of each hidden layer for each expression number, and a feature of the nodes
/// in the last layer.
fn carry_expression(layers: &mut [LinearLayer], plan: &NetworkPlan) {
    let body = 3 * plan.joints.len();
    for (l, layer) in layers.iter_mut().enumerate() {
        for number in 0..plan.expression.min(BASIS) {
            let rows: &[(usize, f64)] = if l == LAYERS - 1 {
                &[(BASIS + number, 1.0)]
            } else {
                &[(2 * number, 1.0), (2 * number + 1, -1.0)]
            };
            for &(row, sign) in rows {
                let weights = layer.row_mut(row);
                weights.fill(0.0);
                if l == 0 {
                    weights[body + number] = sign;
                } else {
                    // A number x is (h₀ − h₁) / 1.01 of its pair of neurons.
                    weights[2 * number] = sign / (1.0 + LEAKY_SLOPE);
                    weights[2 * number + 1] = -sign / (1.0 + LEAKY_SLOPE);
                }
                layer.bias[row] = 0.0;
            }
        }
    }
}

/// Scales and shifts the outputs, except those of the expression, to mean 0 and deviation 1. Then
/// lets the shared features of the attributes equal the nodes'.
fn normalise(layer: &mut LinearLayer, hidden: &[Vec<f64>], expression: Range<usize>) {
    let outputs: Vec<Vec<f64>> = hidden.iter().map(|h| layer.apply(h)).collect();
    let number = outputs.len().max(1) as f64;
    for row in 0..2 * BASIS {
        if expression.contains(&row) {
            continue;
        }
        let mean = outputs.iter().map(|o| o[row]).sum::<f64>() / number;
        let variance = outputs.iter().map(|o| (o[row] - mean).powi(2)).sum::<f64>() / number;
        let scale = 1.0 / variance.sqrt().max(0.02);
        for weight in layer.row_mut(row) {
            *weight *= scale;
        }
        layer.bias[row] = (layer.bias[row] - mean) * scale;
    }
    let (attributes, nodes) = layer.weight.split_at_mut(BASIS * layer.input);
    attributes[..SHARED * layer.input].copy_from_slice(&nodes[..SHARED * layer.input]);
    let (attributes, nodes) = layer.bias.split_at_mut(BASIS);
    attributes[..SHARED].copy_from_slice(&nodes[..SHARED]);
    layer.round();
}

/// The covariance of a layer's outputs, shape outputs, outputs.
fn covariance(layer: &LinearLayer, hidden: &[Vec<f64>]) -> Vec<f64> {
    let outputs: Vec<Vec<f64>> = hidden.iter().map(|h| layer.apply(h)).collect();
    let number = outputs.len().max(1) as f64;
    let width = 2 * BASIS;
    let mean: Vec<f64> = (0..width)
        .map(|k| outputs.iter().map(|o| o[k]).sum::<f64>() / number)
        .collect();
    let entry = |i: usize, j: usize| {
        outputs
            .iter()
            .map(|o| (o[i] - mean[i]) * (o[j] - mean[j]))
            .sum::<f64>()
            / number
    };
    (0..width * width)
        .map(|k| entry(k / width, k % width))
        .collect()
}
