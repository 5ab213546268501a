//! One part's network while it learns: a forward pass over a batch, the loss's gradient back
//! through it, and Adam's step.
//!
//! The loss is the squared error of the part's rows and nodes. With x = neutral + B e,
//! ‖x − truth‖² = eᵀ M e − 2 eᵀ c + rest, where M = Bᵀ B and c = Bᵀ (truth − neutral). So a batch
//! costs no more than its features, however many Gaussians the part has.

use effigy_core::{constants, random::Random};
use effigy_math::matrix::{MatrixView, multiply};

/// Neurons of each hidden layer.
pub const WIDTH: usize = 64;
/// Layers with weights.
pub const LAYERS: usize = 4;
const LEAKY_SLOPE: f32 = constants::LEAKY_SLOPE as f32;

/// Widths from the inputs over three hidden layers to the features.
pub type LayerWidths = [usize; LAYERS + 1];

/// A network with Adam's moments.
#[derive(Clone, Debug, PartialEq)]
pub struct StudentNetwork {
    /// The width of every layer.
    pub widths: LayerWidths,
    /// Layer by layer: weights, shape (output, input), then biases.
    pub weights: Vec<f32>,
    /// Running mean of the gradient, one number a weight.
    pub first_moment: Vec<f32>,
    /// Running mean of the squared gradient, one number a weight.
    pub second_moment: Vec<f32>,
    /// Steps taken since the moments were zero.
    pub steps: u32,
}

/// A part's loss as a quadratic function of its features e: eᵀ M e − 2 eᵀ c + energy. E features, F
/// frames.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct QuadraticLoss {
    /// M, shape E, E; of all frames.
    pub quadratic: Vec<f32>,
    /// c of each frame; shape F, E.
    pub linear: Vec<f32>,
    /// ‖truth − neutral‖² of each frame: the loss where all features are 0.
    pub energy: Vec<f32>,
}

impl QuadraticLoss {
    /// The loss of one frame's features.
    pub fn loss(&self, frame: usize, features: &[f32]) -> f32 {
        let n = features.len();
        let linear = &self.linear[frame * n..][..n];
        // Row i of M times the features.
        let quadratic = |i: usize| {
            self.quadratic[i * n..][..n]
                .iter()
                .zip(features)
                .map(|(m, e)| m * e)
                .sum::<f32>()
        };
        self.energy[frame]
            + (0..n)
                .map(|i| features[i] * (quadratic(i) - 2.0 * linear[i]))
                .sum::<f32>()
    }
}

/// The size of one optimiser step.
#[derive(Clone, Copy, Debug)]
pub struct StepSize {
    /// The learning rate.
    pub rate: f32,
    /// The share of each weight that a step of rate 1 takes away.
    pub decay: f32,
}

/// Memory for a forward and a backward pass over one batch.
pub struct Scratch {
    /// Outputs of each layer, after its activation; shape batch, outputs.
    activations: [Vec<f32>; LAYERS],
    /// The loss's gradient by each weight.
    weight_gradients: Vec<f32>,
    /// The loss's gradient by the outputs of the layer at hand; shape batch, outputs.
    output_gradients: Vec<f32>,
    /// The loss's gradient by the inputs of the layer at hand; shape batch, inputs.
    input_gradients: Vec<f32>,
}

impl Scratch {
    /// For batches of at most `batch` rows.
    pub fn new(widths: &LayerWidths, batch: usize) -> Self {
        let widest = widths.iter().copied().max().unwrap_or(0) * batch;
        Self {
            activations: std::array::from_fn(|l| vec![0.0; batch * widths[l + 1]]),
            weight_gradients: vec![0.0; weight_count(widths)],
            output_gradients: vec![0.0; widest],
            input_gradients: vec![0.0; widest],
        }
    }
}

/// Weights and biases of all layers.
pub fn weight_count(widths: &LayerWidths) -> usize {
    layer_start(widths, LAYERS)
}

/// Where a layer's weights begin; its biases follow its weights.
pub fn layer_start(widths: &LayerWidths, layer: usize) -> usize {
    widths
        .windows(2)
        .take(layer)
        .map(|pair| (pair[0] + 1) * pair[1])
        .sum()
}

/// The inputs of a layer: the network's own, or the activations of the layer before.
fn layer_inputs<'a>(
    layer: usize,
    network_inputs: &'a [f32],
    activations: &'a [Vec<f32>],
    length: usize,
) -> &'a [f32] {
    match layer {
        0 => network_inputs,
        _ => &activations[layer - 1][..length],
    }
}

impl StudentNetwork {
    /// A network with He's random weights. `part` gives each part of an avatar weights of its own.
    pub fn random(widths: LayerWidths, seed: u64, part: u64) -> Self {
        // Other uses of the seed draw from other streams.
        const STREAM: u64 = 7000;
        let mut random = Random::new(seed, STREAM + part);
        let mut weights = Vec::with_capacity(weight_count(&widths));
        for pair in widths.windows(2) {
            let deviation = (2.0 / pair[0] as f64).sqrt();
            weights.extend((0..pair[0] * pair[1]).map(|_| (deviation * random.normal()) as f32));
            weights.extend(std::iter::repeat_n(0.0, pair[1]));
        }
        // Features begin small: near the neutral look.
        for weight in &mut weights[layer_start(&widths, LAYERS - 1)..] {
            *weight *= 0.3;
        }
        Self::with_weights(widths, weights)
    }

    /// A network of given weights, with no step taken.
    pub fn with_weights(widths: LayerWidths, weights: Vec<f32>) -> Self {
        let count = weights.len();
        Self {
            widths,
            weights,
            first_moment: vec![0.0; count],
            second_moment: vec![0.0; count],
            steps: 0,
        }
    }

    /// Forgets Adam's moments; the weights stay.
    pub fn reset_moments(&mut self) {
        self.first_moment.fill(0.0);
        self.second_moment.fill(0.0);
        self.steps = 0;
    }

    /// Features of a batch of inputs; shape batch, E.
    pub fn forward<'a>(&self, inputs: &[f32], batch: usize, scratch: &'a mut Scratch) -> &'a [f32] {
        for l in 0..LAYERS {
            let input = self.widths[l];
            let output = self.widths[l + 1];
            let start = layer_start(&self.widths, l);
            let (weight, bias) =
                self.weights[start..start + (input + 1) * output].split_at(input * output);
            let (before, after) = scratch.activations.split_at_mut(l);
            let x = layer_inputs(l, inputs, before, batch * input);
            let y = &mut after[0][..batch * output];
            for row in y.chunks_exact_mut(output) {
                row.copy_from_slice(bias);
            }
            multiply(
                MatrixView::new(x, batch, input),
                MatrixView::new(weight, output, input).transposed(),
                1.0,
                y,
            );
            if l < LAYERS - 1 {
                for y in y {
                    *y = y.max(LEAKY_SLOPE * *y);
                }
            }
        }
        &scratch.activations[LAYERS - 1][..batch * self.widths[LAYERS]]
    }

    /// One step down the mean loss of a batch. `frames` are the frames that the rows of `inputs`
    /// are of. Returns the batch's summed loss before the step.
    pub fn learn(
        &mut self,
        inputs: &[f32],
        frames: &[u32],
        target: &QuadraticLoss,
        step: StepSize,
        scratch: &mut Scratch,
    ) -> f32 {
        self.forward(inputs, frames.len(), scratch);
        let loss = self.differentiate_loss(frames, target, scratch);
        self.backward(inputs, frames.len(), scratch);
        self.adam_step(&scratch.weight_gradients, step);
        loss
    }

    /// The gradient of the mean loss by the features, into `output_gradients`: 2 (M e − c) / batch.
    /// Returns the summed loss.
    fn differentiate_loss(
        &self,
        frames: &[u32],
        target: &QuadraticLoss,
        scratch: &mut Scratch,
    ) -> f32 {
        let batch = frames.len();
        let width = self.widths[LAYERS];
        let features = &scratch.activations[LAYERS - 1][..batch * width];
        let gradients = &mut scratch.output_gradients[..batch * width];
        multiply(
            MatrixView::new(features, batch, width),
            MatrixView::new(&target.quadratic, width, width),
            0.0,
            gradients,
        );
        let mut loss = 0.0;
        for (row, &frame) in frames.iter().enumerate() {
            let frame = frame as usize;
            loss += target.energy[frame];
            for k in 0..width {
                let i = row * width + k;
                let linear = target.linear[frame * width + k];
                loss += features[i] * (gradients[i] - 2.0 * linear);
                gradients[i] = 2.0 * (gradients[i] - linear) / batch as f32;
            }
        }
        loss
    }

    /// Back-propagation: from `output_gradients` of the last layer to `weight_gradients` of all.
    fn backward(&self, inputs: &[f32], batch: usize, scratch: &mut Scratch) {
        let Scratch {
            activations,
            weight_gradients,
            output_gradients,
            input_gradients,
        } = scratch;
        for l in (0..LAYERS).rev() {
            let input = self.widths[l];
            let output = self.widths[l + 1];
            let start = layer_start(&self.widths, l);
            let x = layer_inputs(l, inputs, activations, batch * input);
            let by_output = &output_gradients[..batch * output];
            let (by_weight, by_bias) =
                weight_gradients[start..start + (input + 1) * output].split_at_mut(input * output);
            multiply(
                MatrixView::new(by_output, batch, output).transposed(),
                MatrixView::new(x, batch, input),
                0.0,
                by_weight,
            );
            by_bias.fill(0.0);
            for row in by_output.chunks_exact(output) {
                for (sum, gradient) in by_bias.iter_mut().zip(row) {
                    *sum += gradient;
                }
            }
            if l > 0 {
                let by_input = &mut input_gradients[..batch * input];
                multiply(
                    MatrixView::new(by_output, batch, output),
                    MatrixView::new(&self.weights[start..start + input * output], output, input),
                    0.0,
                    by_input,
                );
                // Activations have the sign of what went into the leaky ReLU.
                for (gradient, &activation) in by_input.iter_mut().zip(x) {
                    *gradient *= if activation > 0.0 { 1.0 } else { LEAKY_SLOPE };
                }
                std::mem::swap(output_gradients, input_gradients);
            }
        }
    }

    /// A step by Kingma and Ba's Adam, with decay apart from the gradient (Loshchilov and Hutter).
    fn adam_step(&mut self, gradients: &[f32], step: StepSize) {
        const BETA: [f32; 2] = [0.9, 0.99];
        self.steps += 1;
        let correction = BETA.map(|beta| 1.0 / (1.0 - beta.powi(self.steps as i32)));
        let keep = 1.0 - step.rate * step.decay;
        for (i, &g) in gradients.iter().enumerate() {
            let first = BETA[0] * self.first_moment[i] + (1.0 - BETA[0]) * g;
            let second = BETA[1] * self.second_moment[i] + (1.0 - BETA[1]) * g * g;
            let change = first * correction[0] / ((second * correction[1]).sqrt() + 1e-8);
            self.first_moment[i] = first;
            self.second_moment[i] = second;
            self.weights[i] = self.weights[i] * keep - step.rate * change;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BATCH: [u32; 6] = [0, 1, 2, 3, 4, 5];

    struct Setting {
        network: StudentNetwork,
        inputs: Vec<f32>,
        target: QuadraticLoss,
    }

    fn setting() -> Setting {
        let widths = [5, 8, 8, 8, 4];
        let mut random = Random::new(3, 4);
        let mut draw = |n: usize| (0..n).map(|_| random.normal() as f32).collect::<Vec<_>>();
        let inputs = draw(6 * 5);
        let root = draw(16);
        let mut quadratic = vec![0.0; 16];
        let root = MatrixView::new(&root, 4, 4);
        multiply(root, root.transposed(), 0.0, &mut quadratic);
        let target = QuadraticLoss {
            quadratic,
            linear: draw(6 * 4),
            energy: vec![30.0; 6],
        };
        Setting {
            network: StudentNetwork::random(widths, 1, 2),
            inputs,
            target,
        }
    }

    #[test]
    fn gradient_agrees_with_differences() {
        let Setting {
            network,
            inputs,
            target,
        } = setting();
        let mut scratch = Scratch::new(&network.widths, 6);
        let loss = |network: &StudentNetwork, scratch: &mut Scratch| -> f64 {
            let e = network.forward(&inputs, 6, scratch).to_vec();
            (0..6)
                .map(|f| f64::from(target.loss(f, &e[f * 4..][..4])))
                .sum::<f64>()
                / 6.0
        };
        let mut stepped = network.clone();
        let step = StepSize {
            rate: 1e-3,
            decay: 0.0,
        };
        stepped.learn(&inputs, &BATCH, &target, step, &mut scratch);
        let gradient = scratch.weight_gradients.clone();
        for at in (0..network.weights.len()).step_by(7) {
            let shifted = |by: f32, scratch: &mut Scratch| {
                let mut network = network.clone();
                network.weights[at] += by;
                loss(&network, scratch)
            };
            let expected = (shifted(2e-3, &mut scratch) - shifted(-2e-3, &mut scratch)) / 4e-3;
            let got = f64::from(gradient[at]);
            assert!(
                (expected - got).abs() < 0.02 * got.abs().max(0.3),
                "weight {at}: {got}, differences say {expected}"
            );
        }
    }

    #[test]
    fn steps_approach_the_least_loss() {
        let Setting {
            mut network,
            inputs,
            target,
        } = setting();
        let mut scratch = Scratch::new(&network.widths, 6);
        let step = StepSize {
            rate: 3e-3,
            decay: 0.0,
        };
        let losses: Vec<f32> = (0..1500)
            .map(|_| network.learn(&inputs, &BATCH, &target, step, &mut scratch))
            .collect();
        // The least is where M e = c.
        let quadratic: Vec<f64> = target.quadratic.iter().map(|&m| f64::from(m)).collect();
        let inverse = effigy_math::matrix::inverse(&quadratic, 4, 1e-12);
        let linear = |f: usize, i: usize| f64::from(target.linear[f * 4 + i]);
        let saved = |f: usize| {
            (0..16)
                .map(|k| linear(f, k / 4) * inverse[k] * linear(f, k % 4))
                .sum::<f64>()
        };
        let least: f64 = (0..6).map(|f| f64::from(target.energy[f]) - saved(f)).sum();
        let first = f64::from(losses[0]);
        let last = f64::from(losses[1499]);
        assert!(
            last < least + 0.05 * (first - least),
            "{first} fell to {last}, the least is {least}"
        );
    }
}
