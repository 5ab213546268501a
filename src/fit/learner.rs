//! All parts' networks and what they learn from; an epoch of steps at a time.

use super::inputs::Seen;
use super::network::{Network, Scratch, Sizes, Step, Target, WIDTH, start};
use crate::avatar::{Activation, Avatar, Layer, Networks};
use crate::bake::math::{Random, hash};
use half::f16;
use rayon::prelude::*;

/// Frames of a step.
const BATCH: usize = 32;
/// Deviation of the noise on poses while they are learnt from, radians: poses nearby look alike.
const NOISE: f32 = 0.03;
const RATE: f32 = 2e-3;
/// The rate falls to this share of it along half a cosine.
const LAST: f32 = 0.02;
const DECAY: f32 = 0.05;

/// Networks that learn. Inside, inputs have mean 0 and the part's gains ([`Seen::gains`]); the avatar's networks have those folded in.
#[derive(Clone, Debug, PartialEq)]
pub struct Learner {
    pub networks: Vec<Network>,
    pub targets: Vec<Target>,
    /// What each part's target was divided by, so that its loss is about 1.
    pub scales: Vec<f32>,
    gains: Vec<Vec<f32>>,
}

/// Which steps an epoch is, of how many.
#[derive(Clone, Copy, Debug)]
pub struct Epoch {
    pub seed: u64,
    pub stage: usize,
    pub number: usize,
    pub of: usize,
}

impl Learner {
    pub fn new(avatar: &Avatar, seen: &Seen, basis: usize, seed: u64) -> Self {
        let sizes: Sizes = [seen.width, WIDTH, WIDTH, WIDTH, 2 * basis];
        let parts = avatar.parts.len();
        Self {
            networks: (0..parts).map(|part| Network::new(sizes, seed, part as u64)).collect(),
            targets: vec![Target::default(); parts],
            scales: vec![1.0; parts],
            gains: (0..parts).map(|part| seen.gains(avatar, part)).collect(),
        }
    }

    /// The networks of an avatar, to be trained on.
    pub fn of(avatar: &Avatar, seen: &Seen) -> Self {
        let mut learner = Self::new(avatar, seen, avatar.basis_len(), 0);
        for (part, network) in learner.networks.iter_mut().enumerate() {
            for (l, layer) in avatar.networks.layers.iter().enumerate() {
                let at = start(&network.sizes, l);
                let count = layer.input * layer.output;
                let weights = layer.weight.halves();
                let numbers = weights[part * count..][..count].iter().chain(&layer.bias[part * layer.output..][..layer.output]);
                network.weights[at..at + count + layer.output].iter_mut().zip(numbers).for_each(|(w, n)| *w = n.to_f32());
            }
            let (width, hidden) = (network.sizes[0], network.sizes[1]);
            for neuron in 0..hidden {
                for k in 0..width {
                    let (gain, weight) = (learner.gains[part][k], network.weights[neuron * width + k]);
                    network.weights[width * hidden + neuron] += weight * seen.mean[k] * f32::from(u8::from(gain > 0.0));
                    network.weights[neuron * width + k] = if gain > 0.0 { weight / gain } else { 0.0 };
                }
            }
        }
        learner
    }

    /// Sets what a part learns from, divided so that its energy over the training frames is about 1.
    pub fn aim(&mut self, part: usize, mut target: Target, training: &[usize]) {
        let mean = training.iter().map(|&f| target.energy[f]).sum::<f32>() / training.len().max(1) as f32;
        let scale = mean.max(1e-20);
        for numbers in [&mut target.form, &mut target.pull, &mut target.energy] {
            numbers.iter_mut().for_each(|x| *x /= scale);
        }
        (self.targets[part], self.scales[part]) = (target, scale);
    }

    /// Some epochs of steps for every part.
    pub fn train(&mut self, seen: &Seen, training: &[usize], epochs: std::ops::Range<usize>, plan: Epoch) {
        let gains = &self.gains;
        self.networks.par_iter_mut().zip(&self.targets).enumerate().for_each(|(part, (network, target))| {
            let mut scratch = Scratch::new(&network.sizes, BATCH);
            let mut inputs = vec![0.0; BATCH * seen.width];
            for number in epochs.clone() {
                let epoch = Epoch { number, ..plan };
                let turn = number as f32 / plan.of.max(1) as f32;
                let rate = RATE * (LAST + (1.0 - LAST) * 0.5 * (1.0 + (std::f32::consts::PI * turn).cos()));
                let mut random = Random::new(epoch.seed, hash(((epoch.stage as u64) << 40) + ((part as u64) << 20) + number as u64));
                let mut order: Vec<u32> = training.iter().map(|&frame| frame as u32).collect();
                (1..order.len()).rev().for_each(|i| order.swap(i, (random.bits() % (i as u64 + 1)) as usize));
                for batch in order.chunks(BATCH) {
                    for (row, &frame) in batch.iter().enumerate() {
                        see(&mut inputs[row * seen.width..][..seen.width], seen, &gains[part], frame as usize, &mut random);
                    }
                    network.learn(&inputs[..batch.len() * seen.width], batch, target, Step { rate, decay: DECAY }, &mut scratch);
                }
            }
        });
    }

    /// Layers with means and gains folded in, as the avatar stores them.
    pub fn stored(&self, seen: &Seen) -> Networks {
        let folded: Vec<Vec<f16>> = (0..self.networks.len()).into_par_iter().map(|part| self.folded(part, seen)).collect();
        let sizes = self.networks.first().map_or([0; 5], |network| network.sizes);
        let layer = |l: usize| {
            let (input, output, at) = (sizes[l], sizes[l + 1], start(&sizes, l));
            let weights = folded.iter().flat_map(|all| all[at..at + input * output].iter().copied());
            let biases = folded.iter().flat_map(|all| all[at + input * output..][..output].iter().copied());
            Layer { input, output, weight: weights.collect(), bias: biases.collect() }
        };
        Networks { activation: Activation::LeakyRelu, layers: (0..4).map(layer).collect() }
    }

    fn folded(&self, part: usize, seen: &Seen) -> Vec<f16> {
        let (network, gains) = (&self.networks[part], &self.gains[part]);
        let (width, hidden) = (network.sizes[0], network.sizes[1]);
        let mut weights = network.weights.clone();
        for neuron in 0..hidden {
            for k in 0..width {
                let weight = &mut weights[neuron * width + k];
                *weight *= gains[k];
                let shift = *weight * seen.mean[k];
                weights[width * hidden + neuron] -= shift;
            }
        }
        weights.iter().map(|&w| f16::from_f32(w)).collect()
    }

    /// What a part's stored network says of every frame's projected inputs; shape F, E.
    pub fn features(&self, part: usize, seen: &Seen) -> Vec<f32> {
        let sizes = self.networks[part].sizes;
        let stored = Network::of(sizes, self.folded(part, seen).iter().map(|w| w.to_f32()).collect());
        let frames = seen.projected.len() / seen.width.max(1);
        stored.forward(&seen.projected, frames, &mut Scratch::new(&sizes, frames)).to_vec()
    }

    /// The loss of all parts over some frames, as a share of what there is to learn.
    pub fn loss(&self, seen: &Seen, groups: [&[usize]; 2]) -> [f64; 2] {
        let part = |part: usize| {
            let e = self.features(part, seen);
            let (target, width) = (&self.targets[part], self.networks[part].sizes[4]);
            let scale = f64::from(self.scales[part]);
            groups.map(|frames| {
                let loss: f64 = frames.iter().map(|&f| f64::from(target.loss(f, &e[f * width..][..width]))).sum();
                let energy: f64 = frames.iter().map(|&f| f64::from(target.energy[f])).sum();
                [scale * loss, scale * energy]
            })
        };
        let sums: Vec<[[f64; 2]; 2]> = (0..self.networks.len()).into_par_iter().map(part).collect();
        let total = |group: usize, which: usize| sums.iter().map(|sum| sum[group][which]).sum::<f64>();
        [0, 1].map(|group| if total(group, 1) > 0.0 { total(group, 0) / total(group, 1) } else { 0.0 })
    }
}

/// A frame as a part sees it while it learns: projected or not, by chance, so that it knows both; with noise on the pose.
fn see(out: &mut [f32], seen: &Seen, gains: &[f32], frame: usize, random: &mut Random) {
    let from = if random.bits() & 1 == 0 { &seen.projected } else { &seen.raw };
    let row = &from[frame * seen.width..][..seen.width];
    for (k, out) in out.iter_mut().enumerate() {
        let noise = if k < seen.poses { NOISE * (random.normal() as f32) } else { 0.0 };
        *out = (row[k] + noise - seen.mean[k]) * gains[k];
    }
}
