//! One part's network while it learns: batches of inputs in, features out; the loss's gradient back, and Adam's step.
//!
//! The loss is what the part's rows and nodes are off by: with x = neutral + B e, ‖x − truth‖² = eᵀ M e − 2 eᵀ c + rest with M = Bᵀ B and
//! c = Bᵀ (truth − neutral), so that a batch costs no more than its features, however many Gaussians the part has.

use super::matrix::{View, product};
use crate::bake::math::Random;

/// Neurons of each hidden layer.
pub const WIDTH: usize = 64;
const LEAK: f32 = 0.01;

/// Inputs, three hidden layers, features.
pub type Sizes = [usize; 5];

/// Weights (output, input, then biases) layer by layer, and Adam's moments of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Network {
    pub sizes: Sizes,
    pub weights: Vec<f32>,
    pub first: Vec<f32>,
    pub second: Vec<f32>,
    /// Steps taken since the moments were zero.
    pub steps: u32,
}

/// What a part learns from: shapes with E features, F frames.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Target {
    /// M, shape E, E.
    pub form: Vec<f32>,
    /// c of each frame; shape F, E.
    pub pull: Vec<f32>,
    /// ‖truth − neutral‖² of each frame.
    pub energy: Vec<f32>,
}

impl Target {
    /// The loss of one frame's features.
    pub fn loss(&self, frame: usize, e: &[f32]) -> f32 {
        let n = e.len();
        let pull = &self.pull[frame * n..][..n];
        let bend = |i: usize| self.form[i * n..][..n].iter().zip(e).map(|(m, e)| m * e).sum::<f32>();
        self.energy[frame] + (0..n).map(|i| e[i] * (bend(i) - 2.0 * pull[i])).sum::<f32>()
    }
}

/// How a step is taken.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    pub rate: f32,
    /// Share of each weight that a step of rate 1 takes away.
    pub decay: f32,
}

/// What a forward pass leaves for the backward one; sized for a batch.
pub struct Scratch {
    /// Outputs of each layer, after the activation.
    layers: [Vec<f32>; 4],
    gradient: Vec<f32>,
    back: [Vec<f32>; 2],
}

impl Scratch {
    pub fn new(sizes: &Sizes, batch: usize) -> Self {
        let widest = sizes.iter().copied().max().unwrap_or(0) * batch;
        Self {
            layers: std::array::from_fn(|l| vec![0.0; batch * sizes[l + 1]]),
            gradient: vec![0.0; count(sizes)],
            back: [vec![0.0; widest], vec![0.0; widest]],
        }
    }
}

/// Numbers of a network.
pub fn count(sizes: &Sizes) -> usize {
    sizes.windows(2).map(|pair| (pair[0] + 1) * pair[1]).sum()
}

/// Where a layer's weights begin.
pub fn start(sizes: &Sizes, layer: usize) -> usize {
    sizes.windows(2).take(layer).map(|pair| (pair[0] + 1) * pair[1]).sum()
}

impl Network {
    /// He's weights from a seed and the part's number.
    pub fn new(sizes: Sizes, seed: u64, part: u64) -> Self {
        let mut random = Random::new(seed, 7000 + part);
        let mut weights = Vec::with_capacity(count(&sizes));
        for pair in sizes.windows(2) {
            let deviation = (2.0 / pair[0] as f64).sqrt();
            weights.extend((0..pair[0] * pair[1]).map(|_| (deviation * random.normal()) as f32));
            weights.extend(std::iter::repeat_n(0.0, pair[1]));
        }
        // Features begin small: the neutral look.
        let last = start(&sizes, 3);
        weights[last..].iter_mut().for_each(|w| *w *= 0.3);
        Self::of(sizes, weights)
    }

    /// One of given weights that no step was taken from.
    pub fn of(sizes: Sizes, weights: Vec<f32>) -> Self {
        let count = weights.len();
        Self { sizes, weights, first: vec![0.0; count], second: vec![0.0; count], steps: 0 }
    }

    /// Begins a new course of steps.
    pub fn rest(&mut self) {
        self.first.fill(0.0);
        self.second.fill(0.0);
        self.steps = 0;
    }

    /// Features of a batch of inputs, shape batch, E.
    pub fn forward<'a>(&self, inputs: &[f32], batch: usize, scratch: &'a mut Scratch) -> &'a [f32] {
        for l in 0..4 {
            let (input, output) = (self.sizes[l], self.sizes[l + 1]);
            let at = start(&self.sizes, l);
            let (weight, bias) = self.weights[at..at + (input + 1) * output].split_at(input * output);
            let (before, after) = scratch.layers.split_at_mut(l);
            let x = if l == 0 { inputs } else { &before[l - 1][..batch * input] };
            let y = &mut after[0][..batch * output];
            y.chunks_exact_mut(output).for_each(|row| row.copy_from_slice(bias));
            product(View::new(x, batch, input), View::new(weight, output, input).transposed(), 1.0, y);
            if l < 3 {
                y.iter_mut().for_each(|y| *y = y.max(LEAK * *y));
            }
        }
        &scratch.layers[3][..batch * self.sizes[4]]
    }

    /// A step down the mean loss of a batch, whose frames are `frames`; the batch's summed loss.
    pub fn learn(&mut self, inputs: &[f32], frames: &[u32], target: &Target, step: Step, scratch: &mut Scratch) -> f32 {
        let (batch, features) = (frames.len(), self.sizes[4]);
        self.forward(inputs, batch, scratch);
        let Scratch { layers, gradient, back: [now, next] } = scratch;
        let e = &layers[3][..batch * features];
        let slope = &mut now[..batch * features];
        product(View::new(e, batch, features), View::new(&target.form, features, features), 0.0, slope);
        let mut loss = 0.0;
        for (row, &frame) in frames.iter().enumerate() {
            let frame = frame as usize;
            loss += target.energy[frame];
            for k in 0..features {
                let (pull, i) = (target.pull[frame * features + k], row * features + k);
                loss += e[i] * (slope[i] - 2.0 * pull);
                slope[i] = 2.0 * (slope[i] - pull) / batch as f32;
            }
        }
        for l in (0..4).rev() {
            let (input, output) = (self.sizes[l], self.sizes[l + 1]);
            let at = start(&self.sizes, l);
            let slope = &now[..batch * output];
            let x = if l == 0 { inputs } else { &layers[l - 1][..batch * input] };
            let (weight, bias) = gradient[at..at + (input + 1) * output].split_at_mut(input * output);
            product(View::new(slope, batch, output).transposed(), View::new(x, batch, input), 0.0, weight);
            bias.fill(0.0);
            slope.chunks_exact(output).for_each(|row| bias.iter_mut().zip(row).for_each(|(b, s)| *b += s));
            if l > 0 {
                let below = &mut next[..batch * input];
                product(View::new(slope, batch, output), View::new(&self.weights[at..at + input * output], output, input), 0.0, below);
                below.iter_mut().zip(x).for_each(|(s, &x)| *s *= if x > 0.0 { 1.0 } else { LEAK });
                std::mem::swap(now, next);
            }
        }
        self.adam(gradient, step);
        loss
    }

    /// Kingma and Ba's step, with the decay beside it (Loshchilov and Hutter).
    fn adam(&mut self, gradient: &[f32], step: Step) {
        const BETA: [f32; 2] = [0.9, 0.99];
        self.steps += 1;
        let correct = BETA.map(|beta| 1.0 / (1.0 - beta.powi(self.steps as i32)));
        let keep = 1.0 - step.rate * step.decay;
        for (i, &g) in gradient.iter().enumerate() {
            self.first[i] = BETA[0] * self.first[i] + (1.0 - BETA[0]) * g;
            self.second[i] = BETA[1] * self.second[i] + (1.0 - BETA[1]) * g * g;
            let change = self.first[i] * correct[0] / ((self.second[i] * correct[1]).sqrt() + 1e-8);
            self.weights[i] = self.weights[i] * keep - step.rate * change;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn setting() -> (Network, Vec<f32>, Target) {
        let sizes = [5, 8, 8, 8, 4];
        let mut random = Random::new(3, 4);
        let mut draw = |n: usize| (0..n).map(|_| random.normal() as f32).collect::<Vec<_>>();
        let (inputs, root) = (draw(6 * 5), draw(16));
        let mut form = vec![0.0; 16];
        product(View::new(&root, 4, 4), View::new(&root, 4, 4).transposed(), 0.0, &mut form);
        let target = Target { form, pull: draw(6 * 4), energy: vec![30.0; 6] };
        (Network::new(sizes, 1, 2), inputs, target)
    }

    #[test]
    fn a_step_goes_down_the_slope_that_differences_show() {
        let (network, inputs, target) = setting();
        let mut scratch = Scratch::new(&network.sizes, 6);
        let loss = |network: &Network, scratch: &mut Scratch| -> f64 {
            let e = network.forward(&inputs, 6, scratch).to_vec();
            (0..6).map(|f| f64::from(target.loss(f, &e[f * 4..][..4]))).sum::<f64>() / 6.0
        };
        let mut stepped = network.clone();
        stepped.learn(&inputs, &[0, 1, 2, 3, 4, 5], &target, Step { rate: 1e-3, decay: 0.0 }, &mut scratch);
        let gradient = scratch.gradient.clone();
        for at in (0..network.weights.len()).step_by(7) {
            let shifted = |by: f32, scratch: &mut Scratch| {
                let mut network = network.clone();
                network.weights[at] += by;
                loss(&network, scratch)
            };
            let got = (shifted(2e-3, &mut scratch) - shifted(-2e-3, &mut scratch)) / 4e-3;
            let told = f64::from(gradient[at]);
            assert!((got - told).abs() < 0.02 * told.abs().max(0.3), "weight {at}: {told}, differences say {got}");
        }
    }

    #[test]
    fn steps_reach_the_least_loss() {
        let (mut network, inputs, target) = setting();
        let mut scratch = Scratch::new(&network.sizes, 6);
        let mut learn = || network.learn(&inputs, &[0, 1, 2, 3, 4, 5], &target, Step { rate: 3e-3, decay: 0.0 }, &mut scratch);
        let losses: Vec<f32> = (0..1500).map(|_| learn()).collect();
        let (first, last) = (losses[0], losses[1499]);
        // The least is where M e = c.
        let form: Vec<f64> = target.form.iter().map(|&m| f64::from(m)).collect();
        let inverse = super::super::matrix::inverse(&form, 4, 1e-12);
        let pull = |f: usize, i: usize| f64::from(target.pull[f * 4 + i]);
        let saved = |f: usize| (0..16).map(|k| pull(f, k / 4) * inverse[k] * pull(f, k % 4)).sum::<f64>();
        let least: f64 = (0..6).map(|f| f64::from(target.energy[f]) - saved(f)).sum();
        assert!(f64::from(last) < least + 0.05 * (f64::from(first) - least), "{first} fell to {last}, the least is {least}");
    }
}
