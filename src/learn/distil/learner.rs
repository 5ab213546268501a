//! All parts' networks with their targets, trained some epochs at a time.

use crate::distil::inputs::NetworkInputs;
use crate::distil::network::{
    LAYERS, LayerWidths, QuadraticLoss, Scratch, StepSize, StudentNetwork, WIDTH, layer_start,
};
use effigy_core::avatar::{Activation, Avatar, NetworkLayer, Networks};
use effigy_core::random::{Random, hash};
use effigy_math::covariance::RunningCovariance;
use half::f16;
use rayon::prelude::*;
use std::ops::Range;

/// Frames of a step.
const BATCH: usize = 32;
/// Learning rate at the start of a stage.
const RATE: f32 = 2e-3;
/// The share of [`RATE`] that is left at the end of a stage.
const FINAL_RATE: f32 = 0.02;
/// Weight decay, see [`StepSize::decay`].
const DECAY: f32 = 0.05;

/// Networks while they learn. Their inputs have mean 0 and the part's gains
/// ([`NetworkInputs::gains`]); the avatar's networks have both folded into the first layer.
#[derive(Clone, Debug, PartialEq)]
pub struct Learner {
    /// One a part.
    pub networks: Vec<StudentNetwork>,
    /// One a part.
    pub targets: Vec<QuadraticLoss>,
    /// The number that each part's target was divided by, so that its loss is about 1 at first.
    pub scales: Vec<f32>,
    gains: Vec<Vec<f32>>,
}

/// The settings of all epochs of a stage.
#[derive(Clone, Copy, Debug)]
pub struct StageSchedule {
    /// The fit's seed.
    pub seed: u64,
    /// The stage's number, for random numbers of its own.
    pub stage: usize,
    /// Epochs of the whole stage, over which the learning rate falls.
    pub epochs: usize,
}

impl StageSchedule {
    /// The learning rate of an epoch: half a cosine from [`RATE`] to its share [`FINAL_RATE`].
    fn rate(&self, epoch: usize) -> f32 {
        let progress = epoch as f32 / self.epochs.max(1) as f32;
        RATE * (FINAL_RATE
            + (1.0 - FINAL_RATE) * 0.5 * (1.0 + (std::f32::consts::PI * progress).cos()))
    }
}

impl Learner {
    /// Networks of random weights for the parts of an avatar, with nothing to learn yet. `basis`:
    /// features of the attributes, and as many of the nodes.
    pub fn new(avatar: &Avatar, inputs: &NetworkInputs, basis: usize, seed: u64) -> Self {
        let widths: LayerWidths = [inputs.width, WIDTH, WIDTH, WIDTH, 2 * basis];
        let parts = avatar.parts.len();
        Self {
            networks: (0..parts)
                .map(|part| StudentNetwork::random(widths, seed, part as u64))
                .collect(),
            targets: vec![QuadraticLoss::default(); parts],
            scales: vec![1.0; parts],
            gains: (0..parts).map(|part| inputs.gains(avatar, part)).collect(),
        }
    }

    /// Sets a part's target, divided so that its energy over the training frames has mean 1.
    pub fn set_target(&mut self, part: usize, mut target: QuadraticLoss, training: &[usize]) {
        let mean =
            training.iter().map(|&f| target.energy[f]).sum::<f32>() / training.len().max(1) as f32;
        let scale = mean.max(1e-20);
        for numbers in [
            &mut target.quadratic,
            &mut target.linear,
            &mut target.energy,
        ] {
            for x in numbers {
                *x /= scale;
            }
        }
        self.targets[part] = target;
        self.scales[part] = scale;
    }

    /// Trains every part for a range of a stage's epochs. Parts run in parallel; results do not
    /// depend on how many threads there are.
    pub fn train(
        &mut self,
        inputs: &NetworkInputs,
        training: &[usize],
        epochs: Range<usize>,
        schedule: StageSchedule,
    ) {
        let targets = &self.targets;
        let gains = &self.gains;
        self.networks
            .par_iter_mut()
            .enumerate()
            .for_each(|(part, network)| {
                let mut training = PartTraining {
                    part,
                    network,
                    target: &targets[part],
                    gains: &gains[part],
                    inputs,
                    frames: training,
                };
                training.train(epochs.clone(), schedule);
            });
    }

    /// All networks as the avatar stores them, with means and gains folded into the first layer.
    pub fn to_networks(&self, inputs: &NetworkInputs) -> Networks {
        let folded: Vec<Vec<f16>> = (0..self.networks.len())
            .into_par_iter()
            .map(|part| self.folded_weights(part, inputs))
            .collect();
        let widths = self
            .networks
            .first()
            .map_or([0; LAYERS + 1], |network| network.widths);
        let layer = |l: usize| {
            let input = widths[l];
            let output = widths[l + 1];
            let start = layer_start(&widths, l);
            let weights = folded
                .iter()
                .flat_map(|all| all[start..start + input * output].iter().copied());
            let biases = folded
                .iter()
                .flat_map(|all| all[start + input * output..][..output].iter().copied());
            NetworkLayer {
                input,
                output,
                weight: weights.collect(),
                bias: biases.collect(),
            }
        };
        Networks {
            activation: Activation::LeakyRelu,
            layers: (0..LAYERS).map(layer).collect(),
        }
    }

    /// A part's weights for inputs as they come, without gains and means.
    fn folded_weights(&self, part: usize, inputs: &NetworkInputs) -> Vec<f16> {
        let network = &self.networks[part];
        let gains = &self.gains[part];
        let width = network.widths[0];
        let hidden = network.widths[1];
        let mut weights = network.weights.clone();
        for neuron in 0..hidden {
            for k in 0..width {
                let weight = &mut weights[neuron * width + k];
                *weight *= gains[k];
                let shift = *weight * inputs.mean[k];
                weights[width * hidden + neuron] -= shift;
            }
        }
        weights.iter().map(|&w| f16::from_f32(w)).collect()
    }

    /// The features that a part's stored network gives for every frame's projected inputs; shape F,
    /// E. Weights are rounded to f16, as in the avatar.
    pub fn features(&self, part: usize, inputs: &NetworkInputs) -> Vec<f32> {
        let widths = self.networks[part].widths;
        let weights = self.folded_weights(part, inputs);
        let stored =
            StudentNetwork::with_weights(widths, weights.iter().map(|w| w.to_f32()).collect());
        let frames = inputs.projected.len() / inputs.width.max(1);
        let mut scratch = Scratch::new(&widths, frames);
        stored
            .forward(&inputs.projected, frames, &mut scratch)
            .to_vec()
    }

    /// Of each part the covariance of its attributes' features over some frames; shape N_B, N_B,
    /// where nodes have features of their own.
    pub fn feature_covariances(&self, inputs: &NetworkInputs, frames: &[usize]) -> Vec<Vec<f64>> {
        let covariance = |part: usize| {
            let features = self.features(part, inputs);
            let width = self.networks[part].widths[LAYERS];
            let mut running = RunningCovariance::new(width / 2);
            for &frame in frames {
                running.add(&features[frame * width..][..width / 2]);
            }
            running.covariance()
        };
        (0..self.networks.len())
            .into_par_iter()
            .map(covariance)
            .collect()
    }

    /// For each group of frames, the share of the targets' energy that all parts together leave
    /// unexplained.
    pub fn unexplained<const N: usize>(
        &self,
        inputs: &NetworkInputs,
        groups: [&[usize]; N],
    ) -> [f64; N] {
        #[derive(Clone, Copy)]
        struct FeatureSums {
            loss: f64,
            energy: f64,
        }
        let part_sums = |part: usize| {
            let features = self.features(part, inputs);
            let target = &self.targets[part];
            let width = self.networks[part].widths[LAYERS];
            let scale = f64::from(self.scales[part]);
            groups.map(|frames| {
                let loss: f64 = frames
                    .iter()
                    .map(|&f| f64::from(target.loss(f, &features[f * width..][..width])))
                    .sum();
                let energy: f64 = frames.iter().map(|&f| f64::from(target.energy[f])).sum();
                FeatureSums {
                    loss: scale * loss,
                    energy: scale * energy,
                }
            })
        };
        let sums: Vec<[FeatureSums; N]> = (0..self.networks.len())
            .into_par_iter()
            .map(part_sums)
            .collect();
        std::array::from_fn(|group| {
            let loss: f64 = sums.iter().map(|part| part[group].loss).sum();
            let energy: f64 = sums.iter().map(|part| part[group].energy).sum();
            if energy > 0.0 { loss / energy } else { 0.0 }
        })
    }
}

/// One part with everything that its training needs.
struct PartTraining<'a> {
    part: usize,
    network: &'a mut StudentNetwork,
    target: &'a QuadraticLoss,
    gains: &'a [f32],
    inputs: &'a NetworkInputs,
    /// The frames to train on.
    frames: &'a [usize],
}

impl PartTraining<'_> {
    fn train(&mut self, epochs: Range<usize>, schedule: StageSchedule) {
        let width = self.inputs.width;
        let mut scratch = Scratch::new(&self.network.widths, BATCH);
        let mut batch_inputs = vec![0.0; BATCH * width];
        for epoch in epochs {
            // Every epoch of every part has a stream of its own, so that a resumed fit draws the
            // same numbers.
            let stream =
                ((schedule.stage as u64) << 40) + ((self.part as u64) << 20) + epoch as u64;
            let mut random = Random::new(schedule.seed, hash(stream));
            let step = StepSize {
                rate: schedule.rate(epoch),
                decay: DECAY,
            };
            for batch in self.shuffled_frames(&mut random).chunks(BATCH) {
                for (row, &frame) in batch.iter().enumerate() {
                    let out = &mut batch_inputs[row * width..][..width];
                    self.sample_inputs(out, frame as usize, &mut random);
                }
                self.network.learn(
                    &batch_inputs[..batch.len() * width],
                    batch,
                    self.target,
                    step,
                    &mut scratch,
                );
            }
        }
    }

    fn shuffled_frames(&self, random: &mut Random) -> Vec<u32> {
        let mut order: Vec<u32> = self.frames.iter().map(|&frame| frame as u32).collect();
        for i in (1..order.len()).rev() {
            order.swap(i, (random.bits() % (i as u64 + 1)) as usize);
        }
        order
    }

    /// A frame's inputs for training: projected or not, by chance, so that the network knows both.
    fn sample_inputs(&self, out: &mut [f32], frame: usize, random: &mut Random) {
        let inputs = self.inputs;
        let from = if random.bits() & 1 == 0 {
            &inputs.projected
        } else {
            &inputs.raw
        };
        let row = &from[frame * inputs.width..][..inputs.width];
        for (k, out) in out.iter_mut().enumerate() {
            *out = (row[k] - inputs.mean[k]) * self.gains[k];
        }
    }
}
