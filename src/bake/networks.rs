//! A seed and the clip's inputs in; one small network a part out, until a trainer learns them.
//!
//! Networks of neighbouring parts are alike: each weight is a mixture of four drawn ones, and the mixture drifts over the body, so that
//! features hardly jump where parts meet. A part listens most to the joints near it. Over the clip's poses every feature has mean 0 and
//! deviation 1. In head parts the nodes' first features are the expression itself, carried through the hidden layers by pairs of
//! neurons: leaky(x) − leaky(−x) = 1.01 x.

use super::math::{Random, noise};
use crate::avatar::{Activation, Layer, Networks};
use glam::DVec3;
use half::f16;
use rayon::prelude::*;

/// N_B.
pub const BASIS: usize = 16;
/// Features of nodes and attributes in common: a fold then moves and shades together.
pub const SHARED: usize = 8;
const WIDTH: usize = 64;
const MIXTURE: usize = 4;
const LEAK: f64 = 0.01;

/// What the networks are made for.
pub struct Plan<'a> {
    pub seed: u64,
    /// Centre of each part, canonical pose.
    pub centers: &'a [DVec3],
    /// Parts before this one see the expression.
    pub head: usize,
    /// Joints that θ_p is of, canonical pose.
    pub joints: &'a [DVec3],
    pub expression: usize,
    /// θ_p ⊕ θ_e of the clip's poses, projected.
    pub inputs: &'a [Vec<f64>],
}

/// The networks, and the covariance of each part's features over the poses: shape parts, 2 N_B, 2 N_B.
pub fn networks(plan: &Plan) -> (Networks, Vec<Vec<f64>>) {
    let input = 3 * plan.joints.len() + plan.expression;
    let sizes = [(input, WIDTH), (WIDTH, WIDTH), (WIDTH, WIDTH), (WIDTH, 2 * BASIS)];
    let parts: Vec<(Vec<Matrix>, Vec<f64>)> = (0..plan.centers.len()).into_par_iter().map(|part| network(plan, part, &sizes)).collect();
    let layers = sizes.iter().enumerate().map(|(l, &(input, output))| Layer {
        input,
        output,
        weight: parts.iter().flat_map(|(layers, _)| layers[l].weight.iter().map(|&w| f16::from_f64(w))).collect(),
        bias: parts.iter().flat_map(|(layers, _)| layers[l].bias.iter().map(|&b| f16::from_f64(b))).collect(),
    });
    (
        Networks { activation: Activation::LeakyRelu, layers: layers.collect() },
        parts.into_iter().map(|(_, covariance)| covariance).collect(),
    )
}

/// A linear layer of one part.
struct Matrix {
    input: usize,
    weight: Vec<f64>,
    bias: Vec<f64>,
}

impl Matrix {
    fn apply(&self, x: &[f64]) -> Vec<f64> {
        self.weight
            .chunks_exact(self.input)
            .zip(&self.bias)
            .map(|(row, bias)| bias + row.iter().zip(x).map(|(w, x)| w * x).sum::<f64>())
            .collect()
    }
}

fn round(values: &mut [f64]) {
    values.iter_mut().for_each(|v| *v = f16::from_f64(*v).to_f64());
}

fn network(plan: &Plan, part: usize, sizes: &[(usize, usize)]) -> (Vec<Matrix>, Vec<f64>) {
    let center = plan.centers[part];
    let mixture: [f64; MIXTURE] = std::array::from_fn(|m| noise(plan.seed + 500 + m as u64, center * 2.2) + if m == 0 { 0.6 } else { 0.0 });
    let norm = mixture.iter().map(|m| m * m).sum::<f64>().sqrt().max(1e-9);
    let mut layers: Vec<Matrix> =
        sizes.iter().enumerate().map(|(l, &size)| mixed(plan.seed, l, size, &mixture.map(|m| m / norm))).collect();
    for (k, weight) in layers[0].weight.iter_mut().enumerate() {
        let number = k % sizes[0].0;
        *weight *= match plan.joints.get(number / 3) {
            Some(joint) => 2.5 * (0.06 + (-(joint.distance(center) / 0.28).powi(2)).exp()),
            None => 0.0,
        };
    }
    let head = part < plan.head;
    if head {
        carry_expression(&mut layers, plan);
    }
    layers.iter_mut().for_each(|layer| {
        round(&mut layer.weight);
        round(&mut layer.bias);
    });
    let inputs = plan.inputs.iter().map(|input| masked(input, plan.expression, head));
    let hidden: Vec<Vec<f64>> =
        inputs.map(|x| layers[..3].iter().fold(x, |x, layer| layer.apply(&x).into_iter().map(leaky).collect())).collect();
    let carried = if head { BASIS..BASIS + plan.expression.min(BASIS) } else { 0..0 };
    normalise(&mut layers[3], &hidden, carried);
    let covariance = covariance(&layers[3], &hidden);
    (layers, covariance)
}

fn leaky(x: f64) -> f64 {
    x.max(LEAK * x)
}

fn masked(input: &[f64], expression: usize, head: bool) -> Vec<f64> {
    let body = input.len() - expression;
    input.iter().enumerate().map(|(i, &x)| if head || i < body { x } else { 0.0 }).collect()
}

/// Weights of deviation √(2 / inputs), mixed from drawn ones that all parts have in common.
fn mixed(seed: u64, layer: usize, (input, output): (usize, usize), mixture: &[f64; MIXTURE]) -> Matrix {
    let mut random: Vec<Random> = (0..MIXTURE).map(|m| Random::new(seed, (1000 + layer * MIXTURE + m) as u64)).collect();
    let mut draw = |deviation: f64| deviation * mixture.iter().zip(&mut random).map(|(share, random)| share * random.normal()).sum::<f64>();
    let weight = (0..input * output).map(|_| draw((2.0 / input as f64).sqrt())).collect();
    let bias = (0..output).map(|_| draw(0.2)).collect();
    Matrix { input, weight, bias }
}

/// Reserves two neurons a hidden layer for each expression number.
fn carry_expression(layers: &mut [Matrix], plan: &Plan) {
    let body = 3 * plan.joints.len();
    let count = plan.expression.min(BASIS);
    for (l, layer) in layers.iter_mut().enumerate() {
        let input = layer.input;
        // A number x is (h₀ − h₁) / 1.01 of its pair of neurons, and the first layer's own input.
        let read = |row: &mut [f64], number: usize, sign: f64| {
            row.fill(0.0);
            if l == 0 {
                row[body + number] = sign;
            } else {
                row[2 * number] = sign / (1.0 + LEAK);
                row[2 * number + 1] = -sign / (1.0 + LEAK);
            }
        };
        let last = l == 3;
        for number in 0..count {
            let rows: &[(usize, f64)] = if last { &[(BASIS + number, 1.0)] } else { &[(2 * number, 1.0), (2 * number + 1, -1.0)] };
            for &(row, sign) in rows {
                read(&mut layer.weight[row * input..(row + 1) * input], number, sign);
                layer.bias[row] = 0.0;
            }
        }
    }
}

/// Scales and shifts the outputs, but the carried ones, to mean 0 and deviation 1; then lets the shared attribute features equal the
/// nodes'.
fn normalise(layer: &mut Matrix, hidden: &[Vec<f64>], carried: std::ops::Range<usize>) {
    let outputs: Vec<Vec<f64>> = hidden.iter().map(|h| layer.apply(h)).collect();
    let number = outputs.len().max(1) as f64;
    for row in (0..2 * BASIS).filter(|row| !carried.contains(row)) {
        let mean = outputs.iter().map(|o| o[row]).sum::<f64>() / number;
        let variance = outputs.iter().map(|o| (o[row] - mean).powi(2)).sum::<f64>() / number;
        let scale = 1.0 / variance.sqrt().max(0.02);
        layer.weight[row * layer.input..(row + 1) * layer.input].iter_mut().for_each(|w| *w *= scale);
        layer.bias[row] = (layer.bias[row] - mean) * scale;
    }
    let (attributes, nodes) = layer.weight.split_at_mut(BASIS * layer.input);
    attributes[..SHARED * layer.input].copy_from_slice(&nodes[..SHARED * layer.input]);
    let (attributes, nodes) = layer.bias.split_at_mut(BASIS);
    attributes[..SHARED].copy_from_slice(&nodes[..SHARED]);
    round(&mut layer.weight);
    round(&mut layer.bias);
}

fn covariance(layer: &Matrix, hidden: &[Vec<f64>]) -> Vec<f64> {
    let outputs: Vec<Vec<f64>> = hidden.iter().map(|h| layer.apply(h)).collect();
    let number = outputs.len().max(1) as f64;
    let width = 2 * BASIS;
    let mean: Vec<f64> = (0..width).map(|k| outputs.iter().map(|o| o[k]).sum::<f64>() / number).collect();
    let entry = |i: usize, j: usize| outputs.iter().map(|o| (o[i] - mean[i]) * (o[j] - mean[j])).sum::<f64>() / number;
    (0..width * width).map(|k| entry(k / width, k % width)).collect()
}
