//! Stage `mlp` (docs/model.md, step 1): the feature vector e of every part from the networks'
//! input.

use crate::avatar::{Activation, Avatar, matrix::Row};
use crate::constants::{FEATURE_MAX, LEAKY_SLOPE};
use crate::each;

/// e_i = MLP_i(θ_p ⊕ θ_e) for each part i; shape N_G, E, where E is `avatar.networks.output()`.
///
/// `input` is θ_p ⊕ θ_e, of length `avatar.inputs.len()`. Parts outside the head see zeros for θ_e.
/// The paper sets "the pose to zero vector" there, which contradicts the reason that it gives, to
/// reduce the expression's influence on the body.
pub fn features(avatar: &Avatar, input: &[f64]) -> Vec<f64> {
    let mut body = input.to_vec();
    body[3 * avatar.inputs.joint.len()..].fill(0.0);
    let parts = each::map(avatar.parts.len(), |part| {
        let sees_expression = part < avatar.parts.head;
        network(avatar, part, if sees_expression { input } else { &body })
    });
    parts.concat()
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
        x = linear(&x, layer.output, |k| Neuron {
            weight: layer.weight.row(part * layer.output + k, layer.input),
            bias: layer.bias[part * layer.output + k].to_f64(),
        });
        if l + 1 < layers.len() {
            for x in &mut x {
                *x = activate(avatar.networks.activation, *x);
            }
        }
    }
    x
}

/// A row of a linear layer.
#[derive(Clone, Copy, Debug)]
pub struct Neuron<'w> {
    /// As many weights as numbers enter.
    pub weight: Row<'w>,
    /// What is added.
    pub bias: f64,
}

/// W x + b of a layer of so many neurons, clamped to ±[`FEATURE_MAX`].
pub fn linear<'w>(x: &[f64], neurons: usize, neuron: impl Fn(usize) -> Neuron<'w>) -> Vec<f64> {
    (0..neurons)
        .map(|k| {
            let Neuron { weight, bias } = neuron(k);
            (bias + weight.dot(x)).clamp(-FEATURE_MAX, FEATURE_MAX)
        })
        .collect()
}

/// The derivative of [`linear`] with respect to x: Wᵀ · `gradient`. With respect to the weights it
/// is `gradient` ⊗ x, and to the biases `gradient`. Clamping is left out: what it cuts off has no
/// meaning.
pub fn linear_backward<'w>(
    gradient: &[f64],
    inputs: usize,
    neuron: impl Fn(usize) -> Neuron<'w>,
) -> Vec<f64> {
    let mut x = vec![0.0; inputs];
    for (k, g) in gradient.iter().enumerate() {
        for (x, w) in x.iter_mut().zip(neuron(k).weight.iter()) {
            *x += g * w;
        }
    }
    x
}

/// The nonlinearity of hidden layers.
pub fn activate(activation: Activation, x: f64) -> f64 {
    match activation {
        Activation::Relu => x.max(0.0),
        Activation::LeakyRelu => x.max(LEAKY_SLOPE * x),
    }
}

/// The derivative of [`activate`], from its result, which has the sign of what entered.
pub fn activate_backward(activation: Activation, y: f64) -> f64 {
    match activation {
        _ if y > 0.0 => 1.0,
        Activation::Relu => 0.0,
        Activation::LeakyRelu => LEAKY_SLOPE,
    }
}
