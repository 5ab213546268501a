//! Stage `mlp` (docs/model.md, step 1): the feature vector e of every part from the networks'
//! input.

use crate::avatar::{Activation, Avatar, Layer};
use crate::constants::{FEATURE_MAX, LEAKY_SLOPE};
use rayon::prelude::*;

/// e_i = MLP_i(θ_p ⊕ θ_e) for each part i; shape N_G, E, where E is `avatar.networks.output()`.
///
/// `input` is θ_p ⊕ θ_e, of length `avatar.inputs.len()`. Parts outside the head see zeros for θ_e.
/// The paper sets "the pose to zero vector" there, which contradicts the reason that it gives, to
/// reduce the expression's influence on the body.
pub fn features(avatar: &Avatar, input: &[f64]) -> Vec<f64> {
    let mut body = input.to_vec();
    body[3 * avatar.inputs.joint.len()..].fill(0.0);
    (0..avatar.parts.len())
        .into_par_iter()
        .flat_map_iter(|part| {
            let sees_expression = part < avatar.parts.head;
            network(avatar, part, if sees_expression { input } else { &body })
        })
        .collect()
}

/// What the attributes of a Gaussian see of all parts' features: the first N_B of its part's.
pub fn of_gaussian<'f>(avatar: &Avatar, features: &'f [f64], gaussian: usize) -> &'f [f64] {
    let part = avatar.parts.part_of(gaussian);
    &features[part * avatar.networks.output()..][..avatar.basis_len()]
}

/// MLP_i: linear layers with the activation between them, the last one linear. The result of each
/// layer is clamped to ±[`FEATURE_MAX`].
fn network(avatar: &Avatar, part: usize, input: &[f64]) -> Vec<f64> {
    let layers = &avatar.networks.layers;
    let mut x = input.to_vec();
    for (l, layer) in layers.iter().enumerate() {
        x = linear(layer, part, &x);
        if l + 1 < layers.len() {
            for x in &mut x {
                *x = activate(avatar.networks.activation, *x);
            }
        }
    }
    x
}

/// W x + b with one part's weights.
fn linear(layer: &Layer, part: usize, x: &[f64]) -> Vec<f64> {
    let bias = &layer.bias[part * layer.output..][..layer.output];
    let neuron = |k: usize| {
        bias[k].to_f64()
            + layer
                .weight
                .row(part * layer.output + k, layer.input)
                .dot(x)
    };
    (0..layer.output)
        .map(|k| neuron(k).clamp(-FEATURE_MAX, FEATURE_MAX))
        .collect()
}

fn activate(activation: Activation, x: f64) -> f64 {
    match activation {
        Activation::Relu => x.max(0.0),
        Activation::LeakyRelu => x.max(LEAKY_SLOPE * x),
    }
}
