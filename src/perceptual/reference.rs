//! Distances in f64 on one thread, in plain loops, with their derivative along a direction by the
//! rules of derivatives forward: what the rest is held against.

use crate::{
    convolution::Convolution,
    head::{SCALE, SHIFT},
    network::{Network, NetworkStep},
    planes::Planes,
    weights::Weights,
};

/// A distance and its derivative along a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Differential {
    /// The distance.
    pub value: f64,
    /// Its change for a small step along the direction, over the length of the step.
    pub slope: f64,
}

/// Feature maps with their derivatives along the direction.
#[derive(Clone)]
struct Dual {
    channels: usize,
    size: [usize; 2],
    value: Vec<f64>,
    slope: Vec<f64>,
}

impl Dual {
    fn zeros(channels: usize, size: [usize; 2]) -> Self {
        let zeros = vec![0.0; channels * size[0] * size[1]];
        Self {
            channels,
            size,
            value: zeros.clone(),
            slope: zeros,
        }
    }

    fn at(&self, channel: usize, [x, y]: [usize; 2]) -> usize {
        (channel * self.size[1] + y) * self.size[0] + x
    }
}

/// The distance of an image from a target, and its derivative along a direction. `pictures`: the
/// image, the direction and the target.
pub fn differential(network: Network, weights: &Weights, pictures: [&Planes; 3]) -> Differential {
    let [image, along, target] = pictures;
    assert!(image.size == along.size && image.size == target.size);
    let ours = layers(network, weights, image, Some(along));
    let theirs = layers(network, weights, target, None);
    let mut sum = Differential {
        value: 0.0,
        slope: 0.0,
    };
    for ((a, b), head) in ours.iter().zip(&theirs).zip(&weights.heads) {
        let plane = a.size[0] * a.size[1];
        for pixel in 0..plane {
            let of = |k: usize| k * plane + pixel;
            let channels = 0..a.channels;
            let squares = |of_maps: &Dual| -> f64 {
                channels.clone().map(|k| of_maps.value[of(k)].powi(2)).sum()
            };
            let length = squares(a).sqrt();
            let other = squares(b).sqrt() + 1e-10;
            let along: f64 = channels
                .clone()
                .map(|k| a.value[of(k)] * a.slope[of(k)])
                .sum();
            let slope = if length > 0.0 { along / length } else { 0.0 };
            let over = 1.0 / (length + 1e-10);
            for k in channels.clone() {
                let (value, change) = (a.value[of(k)], a.slope[of(k)]);
                let difference = value * over - b.value[of(k)] / other;
                let weight = f64::from(head[k]) / plane as f64;
                sum.value += weight * difference * difference;
                sum.slope +=
                    2.0 * weight * difference * (change * over - value * slope * over * over);
            }
        }
    }
    sum
}

fn layers(
    network: Network,
    weights: &Weights,
    image: &Planes,
    along: Option<&Planes>,
) -> Vec<Dual> {
    let plane = image.size[0] * image.size[1];
    let mut maps = Dual::zeros(3, image.size);
    for i in 0..3 * plane {
        let [shift, scale] = [SHIFT, SCALE].map(|of| f64::from(of[i / plane]));
        maps.value[i] = (2.0 * f64::from(image.data[i]) - 1.0 - shift) / scale;
        maps.slope[i] = along.map_or(0.0, |along| 2.0 * f64::from(along.data[i]) / scale);
    }
    let mut convolutions = weights.convolutions.iter();
    let mut found = Vec::new();
    for steps in network.layers() {
        for step in *steps {
            maps = match step {
                NetworkStep::Convolve(_) => match convolutions.next() {
                    Some(convolution) => convolved(convolution, &maps),
                    None => unreachable!("weights for every convolution"),
                },
                NetworkStep::Rectify => {
                    for i in 0..maps.value.len() {
                        if maps.value[i] <= 0.0 {
                            maps.value[i] = 0.0;
                            maps.slope[i] = 0.0;
                        }
                    }
                    maps
                }
                NetworkStep::Pool(window) => pooled(&maps, *window),
                NetworkStep::Thin(step) => thinned(&maps, *step),
                NetworkStep::Blur => blurred(&maps),
            };
        }
        found.push(maps.clone());
    }
    found
}

fn convolved(convolution: &Convolution, maps: &Dual) -> Dual {
    let shape = convolution.shape;
    let size = maps
        .size
        .map(|side| NetworkStep::Convolve(shape).side(side));
    let mut output = Dual::zeros(shape.to, size);
    let mut weights = convolution.weight.iter();
    for to in 0..shape.to {
        let start = output.at(to, [0, 0]);
        let bias = f64::from(convolution.bias[to]);
        output.value[start..start + size[0] * size[1]].fill(bias);
        for from in 0..shape.from {
            for down in 0..shape.window {
                for across in 0..shape.window {
                    let Some(&weight) = weights.next() else {
                        return output;
                    };
                    let weight = f64::from(weight);
                    // Pixels that are written for which this weight meets the picture.
                    let first = shape.pad.saturating_sub(across).div_ceil(shape.stride);
                    let last = (maps.size[0] + shape.pad - across).div_ceil(shape.stride);
                    let last = last.min(size[0]);
                    for y in 0..size[1] {
                        let row = (shape.stride * y + down).wrapping_sub(shape.pad);
                        if row >= maps.size[1] || first >= last {
                            continue;
                        }
                        let column = shape.stride * first + across - shape.pad;
                        let read = maps.at(from, [column, row]);
                        let write = output.at(to, [first, y]);
                        let count = last - first;
                        for (into, of) in [
                            (&mut output.value, &maps.value),
                            (&mut output.slope, &maps.slope),
                        ] {
                            let into = &mut into[write..write + count];
                            let of = of[read..].iter().step_by(shape.stride);
                            for (into, of) in into.iter_mut().zip(of) {
                                *into += weight * of;
                            }
                        }
                    }
                }
            }
        }
    }
    output
}

fn pooled(maps: &Dual, window: usize) -> Dual {
    let size = maps.size.map(|side| side + 1 - window);
    let mut output = Dual::zeros(maps.channels, size);
    for channel in 0..maps.channels {
        for (y, x) in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (y, x))) {
            let mut best = maps.at(channel, [x, y]);
            for (down, across) in (0..window).flat_map(|y| (0..window).map(move |x| (y, x))) {
                let at = maps.at(channel, [x + across, y + down]);
                if maps.value[at] > maps.value[best] {
                    best = at;
                }
            }
            let at = output.at(channel, [x, y]);
            output.value[at] = maps.value[best];
            output.slope[at] = maps.slope[best];
        }
    }
    output
}

fn thinned(maps: &Dual, step: usize) -> Dual {
    let size = maps.size.map(|side| side.div_ceil(step));
    let mut output = Dual::zeros(maps.channels, size);
    for channel in 0..maps.channels {
        for (y, x) in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (y, x))) {
            let from = maps.at(channel, [step * x, step * y]);
            let at = output.at(channel, [x, y]);
            output.value[at] = maps.value[from];
            output.slope[at] = maps.slope[from];
        }
    }
    output
}

fn blurred(maps: &Dual) -> Dual {
    let size = maps.size.map(|side| side.div_ceil(2) + 1);
    let mut output = Dual::zeros(maps.channels, size);
    let mirrored = |at: usize, length: usize| {
        let at = at.abs_diff(2);
        at.min(2 * (length - 1) - at)
    };
    for channel in 0..maps.channels {
        for (y, x) in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (y, x))) {
            let at = output.at(channel, [x, y]);
            for (down, across) in (0..3).flat_map(|y| (0..3).map(move |x| (y, x))) {
                let share = [1.0, 2.0, 1.0][down] * [1.0, 2.0, 1.0][across] / 16.0;
                let from = [
                    mirrored(2 * x + across, maps.size[0]),
                    mirrored(2 * y + down, maps.size[1]),
                ];
                let from = maps.at(channel, from);
                output.value[at] += share * maps.value[from];
                output.slope[at] += share * maps.slope[from];
            }
        }
    }
    output
}
