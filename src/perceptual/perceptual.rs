//! ST-LPIPS and LPIPS: the distance between two pictures, and its gradient with respect to the
//! first.

use crate::{
    blur,
    check::{self, KnownDistance},
    error::PerceptualError,
    head::{self, SCALE, SHIFT},
    maps::Maps,
    network::{LAYERS, Network, NetworkStep},
    planes::{Graded, Planes},
    pool,
    reference::{self, Differential},
    thin,
    weights::{self, Weights},
};
use rayon::prelude::*;
use std::path::Path;

/// A network with its weights.
#[derive(Clone, Debug)]
pub struct Perceptual {
    network: Network,
    weights: Weights,
    /// What is known of its distances; None for LPIPS and for weights that were made here.
    known: Option<KnownDistance>,
}

/// What a network sees of a target: worked out once, and compared with many pictures.
#[derive(Clone, Debug)]
pub struct TargetFeatures {
    network: Network,
    /// Width and height of the picture, px.
    size: [usize; 2],
    /// Of each layer, with a length of 1 at each pixel.
    units: Vec<Maps>,
}

impl TargetFeatures {
    /// Width and height of the picture that they are of, px.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Bytes that they take.
    pub fn bytes(&self) -> usize {
        self.units.iter().map(|maps| 4 * maps.data.len()).sum()
    }
}

/// What the steps of a network wrote, the picture as the network takes it first. Steps that rectify
/// change what the one before wrote.
struct ForwardTrace {
    written: Vec<Maps>,
}

impl Perceptual {
    /// Reads the weights of a network from the folder that `tools/fetch_perceptual.sh` fills, and
    /// in which the user puts torchvision's file for LPIPS.
    ///
    /// # Errors
    /// When a file is missing, can't be read or is another one: a name, a shape or the sum of all
    /// magnitudes is not what it should be. Of torchvision's the sum is not known.
    pub fn read(network: Network, folder: &Path) -> Result<Self, PerceptualError> {
        if let Some(file) = network.missing(folder) {
            return Err(PerceptualError::Missing {
                measure: network.title(),
                file: folder.join(file.name),
                origin: file.origin,
            });
        }
        Ok(Self {
            network,
            weights: weights::read(network, network.files(), folder)?,
            known: check::published(network),
        })
    }

    /// A network with random weights, the same for a seed on every machine: for tests without a
    /// file. Its distances mean nothing.
    pub fn random(network: Network, seed: u64) -> Self {
        Self {
            network,
            weights: weights::random(network, seed),
            known: None,
        }
    }

    /// Its weights.
    pub fn weights(&self) -> &Weights {
        &self.weights
    }

    /// Which network it is.
    pub fn network(&self) -> Network {
        self.network
    }

    /// The smallest side of a picture that a network takes, px.
    pub const fn smallest_side(network: Network) -> u32 {
        network.smallest_side()
    }

    /// Whether this machine works out what it should: the distance of two built-in pictures and a
    /// derivative of it, against numbers that another program found or, for LPIPS and random
    /// weights, against this package's in f64. To be called once before distances are relied on.
    /// Takes 20 ms to 4 s.
    ///
    /// # Errors
    /// When one of the two is wrong, with both numbers.
    pub fn check(&self) -> Result<(), PerceptualError> {
        let known = self
            .known
            .unwrap_or_else(|| check::worked_out(self.network, &self.weights));
        check::compare(self.network, &known, |image, target| {
            self.value_and_gradient(image, &self.features(target))
        })
    }

    /// The distance of an image from a target, and its derivative along a direction, in f64 on one
    /// thread by another way: what the rest is held against. Takes a hundred times as long.
    ///
    /// # Panics
    /// When the sizes differ, or are too small for the network.
    pub fn differential(&self, image: &Planes, along: &Planes, target: &Planes) -> Differential {
        reference::differential(self.network, &self.weights, [image, along, target])
    }

    /// What the network sees of a target.
    ///
    /// # Panics
    /// When a side is smaller than [`Self::smallest_side`], or numbers are missing.
    pub fn features(&self, image: &Planes) -> TargetFeatures {
        let mut units = Vec::with_capacity(LAYERS);
        self.run(image, false, &mut |_, maps| units.push(head::unit(maps)));
        TargetFeatures {
            network: self.network,
            size: image.size,
            units,
        }
    }

    /// The distance of a picture from a target.
    ///
    /// # Panics
    /// When the target was seen by another network or has another size, and as [`Self::features`].
    pub fn value(&self, image: &Planes, target: &TargetFeatures) -> f64 {
        self.assert_fits(image, target);
        let mut value = 0.0;
        self.run(image, false, &mut |layer, maps| {
            let weights = &self.weights.heads[layer];
            value += head::distance(maps, &target.units[layer], weights, false).value;
        });
        value
    }

    /// The distance of a picture from a target, and its gradient with respect to the picture.
    ///
    /// Where several pixels under a window are the greatest, the first takes the gradient.
    ///
    /// # Panics
    /// As [`Self::value`].
    pub fn value_and_gradient(&self, image: &Planes, target: &TargetFeatures) -> Graded {
        self.assert_fits(image, target);
        let mut value = 0.0;
        let mut gradients = Vec::with_capacity(LAYERS);
        let trace = self.run(image, true, &mut |layer, maps| {
            let weights = &self.weights.heads[layer];
            let found = head::distance(maps, &target.units[layer], weights, true);
            value += found.value;
            gradients.extend(found.gradient);
        });
        let mut gradient = self.backward(&trace, gradients);
        // Of colours of 0 to 1, not of what the network takes.
        for (numbers, scale) in gradient
            .data
            .chunks_exact_mut(image.size[0] * image.size[1])
            .zip(SCALE)
        {
            numbers.iter_mut().for_each(|number| *number *= 2.0 / scale);
        }
        Graded {
            value,
            gradient: Planes {
                size: image.size,
                data: gradient.data,
            },
        }
    }

    fn assert_fits(&self, image: &Planes, target: &TargetFeatures) {
        assert_eq!(
            self.network, target.network,
            "another network saw the target"
        );
        assert_eq!(image.size, target.size, "the target has another size");
    }

    /// Goes through the network and shows the features of each layer. `keep`: what was written is
    /// kept.
    fn run(&self, image: &Planes, keep: bool, show: &mut dyn FnMut(usize, &Maps)) -> ForwardTrace {
        let smallest = self.network.smallest_side() as usize;
        assert!(
            image.size.iter().all(|&side| side >= smallest),
            "{:?} px are too few: a side has at least {smallest}",
            image.size
        );
        assert!(
            image.is_whole(),
            "a picture of {:?} px lacks numbers",
            image.size
        );
        let mut maps = Maps {
            channels: 3,
            size: image.size,
            data: image.data.clone(),
        };
        let plane = maps.plane();
        let colors = maps.data.chunks_exact_mut(plane).zip(SHIFT).zip(SCALE);
        for ((numbers, shift), scale) in colors {
            for number in numbers {
                *number = (2.0 * *number - 1.0 - shift) / scale;
            }
        }
        let mut trace = ForwardTrace {
            written: Vec::new(),
        };
        let mut convolutions = self.weights.convolutions.iter();
        for (layer, steps) in self.network.layers().iter().enumerate() {
            for (at, step) in steps.iter().enumerate() {
                let next = match step {
                    NetworkStep::Convolve(_) => {
                        let rectify = steps.get(at + 1) == Some(&NetworkStep::Rectify);
                        let convolution = convolutions.next();
                        convolution.map(|convolution| convolution.forward(&maps, rectify))
                    }
                    NetworkStep::Rectify => {
                        // A convolution has done it already, where it came before.
                        if !matches!(
                            steps.get(at.wrapping_sub(1)),
                            Some(NetworkStep::Convolve(_))
                        ) {
                            maps.data
                                .par_iter_mut()
                                .for_each(|number| *number = number.max(0.0));
                        }
                        None
                    }
                    NetworkStep::Pool(window) => Some(pool::forward(&maps, *window)),
                    NetworkStep::Thin(step) => Some(thin::forward(&maps, *step)),
                    NetworkStep::Blur => Some(blur::forward(&maps)),
                };
                if let Some(next) = next {
                    let read = std::mem::replace(&mut maps, next);
                    if keep {
                        trace.written.push(read);
                    }
                }
            }
            show(layer, &maps);
        }
        if keep {
            trace.written.push(maps);
        }
        trace
    }

    /// The gradient with respect to what the network takes, from those with respect to the features
    /// of each layer.
    fn backward(&self, trace: &ForwardTrace, mut gradients: Vec<Maps>) -> Maps {
        let mut written = trace.written.iter().rev();
        let mut convolutions = self.weights.convolutions.iter().rev();
        let mut gradient: Option<Maps> = None;
        let mut output = written.next();
        for steps in self.network.layers().iter().rev() {
            // What comes from further down, and what this layer's features are compared with.
            let own = gradients.pop();
            gradient = match (gradient, own) {
                (Some(mut sum), Some(own)) => {
                    let numbers = sum.data.par_iter_mut().zip(&own.data);
                    numbers.for_each(|(sum, own)| *sum += own);
                    Some(sum)
                }
                (sum, own) => sum.or(own),
            };
            for step in steps.iter().rev() {
                let (Some(mut current), Some(maps)) = (gradient.take(), output) else {
                    unreachable!("a step without what it wrote");
                };
                if *step == NetworkStep::Rectify {
                    let numbers = current.data.par_iter_mut().zip(&maps.data);
                    numbers.for_each(|(gradient, &number)| {
                        *gradient = if number > 0.0 { *gradient } else { 0.0 };
                    });
                    gradient = Some(current);
                    continue;
                }
                let Some(input) = written.next() else {
                    unreachable!("a step without what it read");
                };
                gradient = match step {
                    NetworkStep::Convolve(_) => convolutions
                        .next()
                        .map(|convolution| convolution.backward(&current, input.size)),
                    NetworkStep::Pool(window) => {
                        Some(pool::backward(&current, input, maps, *window))
                    }
                    NetworkStep::Thin(step) => Some(thin::backward(&current, input.size, *step)),
                    NetworkStep::Blur => Some(blur::backward(&current, input.size)),
                    NetworkStep::Rectify => None,
                };
                output = Some(input);
            }
        }
        gradient.unwrap_or_else(|| unreachable!("networks have steps"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthetic::{direction, picture};
    use serde::Deserialize;

    const ALL: [Network; 4] = [
        Network::Alex,
        Network::Vgg,
        Network::LpipsAlex,
        Network::LpipsVgg,
    ];

    /// What tests/data/perceptual/make.py found.
    #[derive(Deserialize)]
    struct RecordedRows {
        rows: Vec<RecordedRow>,
    }

    #[derive(Deserialize)]
    struct RecordedRow {
        network: String,
        weights: String,
        size: [usize; 2],
        direction: String,
        value: f64,
        slope: f64,
    }

    fn dot(a: &Planes, b: &Planes) -> f64 {
        let pairs = a.data.iter().zip(&b.data);
        pairs.map(|(a, b)| f64::from(*a) * f64::from(*b)).sum()
    }

    fn length(a: &Planes) -> f64 {
        dot(a, a).sqrt()
    }

    fn minus(a: &Planes, b: &Planes) -> Planes {
        let data = a.data.iter().zip(&b.data).map(|(a, b)| a - b).collect();
        Planes { size: a.size, data }
    }

    #[test]
    fn values_and_slopes_are_those_of_another_program() {
        let text = include_str!("../../tests/data/perceptual/values.json");
        let found: RecordedRows =
            serde_json::from_str(text).expect("values.json is what make.py writes");
        for network in ALL {
            let perceptual = Perceptual::random(network, 5);
            let rows = found
                .rows
                .iter()
                .filter(|row| row.network == network.name());
            let mut compared = 0;
            for row in rows.filter(|row| row.weights == "random 5") {
                let image = picture(0, row.size);
                let target = picture(1, row.size);
                let along = match row.direction.as_str() {
                    "towards" => minus(&target, &image),
                    _ => direction(row.size),
                };
                let features = perceptual.features(&target);
                let graded = perceptual.value_and_gradient(&image, &features);
                let slope = dot(&graded.gradient, &along);
                // Of what a derivative along most directions of this length is.
                let usual =
                    length(&graded.gradient) * length(&along) / (image.data.len() as f64).sqrt();
                let exact = perceptual.differential(&image, &along, &target);
                let name = format!("{} {:?} {}", row.network, row.size, row.direction);
                println!(
                    "{name}: {} {} {slope} {} {usual}",
                    graded.value, row.value, row.slope
                );
                assert!(
                    (exact.value / row.value - 1.0).abs() < 1e-9,
                    "{name}: {exact:?}"
                );
                assert!(
                    (exact.slope - row.slope).abs() < 1e-6 * usual,
                    "{name}: {exact:?}"
                );
                assert!((graded.value / row.value - 1.0).abs() < 1e-5, "{name}");
                assert!((slope - row.slope).abs() < 1e-3 * usual, "{name}: {slope}");
                assert_eq!(perceptual.value(&image, &features), graded.value);
                compared += 1;
            }
            assert_eq!(compared, 4);
        }
    }

    #[test]
    fn the_gradient_is_what_central_differences_in_f64_find() {
        for (network, size) in [
            (Network::Alex, [24, 27]),
            (Network::Vgg, [20, 18]),
            (Network::LpipsAlex, [37, 42]),
            (Network::LpipsVgg, [21, 18]),
        ] {
            let perceptual = Perceptual::random(network, 11);
            let (image, target) = (picture(0, size), picture(1, size));
            let features = perceptual.features(&target);
            let gradient = perceptual.value_and_gradient(&image, &features).gradient;
            for seed in 0..2 {
                let mut along = direction(size);
                along.data.rotate_left(100 * seed);
                // Small, for few numbers pass 0 on the way; f32 holds both ends exactly.
                let step = 1.0 / 65536.0;
                let at = |sign: f32| {
                    let pairs = image.data.iter().zip(&along.data);
                    let data = pairs.map(|(n, d)| n + sign * step * d).collect();
                    let moved = Planes { size, data };
                    let exact = perceptual.differential(&moved, &along, &target);
                    (moved, exact.value)
                };
                let ((ahead, more), (behind, less)) = (at(1.0), at(-1.0));
                let found = more - less;
                let expected = dot(&gradient, &minus(&ahead, &behind));
                let usual = length(&gradient) * length(&along) * 2.0 * f64::from(step)
                    / (image.data.len() as f64).sqrt();
                println!("{network:?}: {found} {expected} {usual}");
                assert!(
                    (found - expected).abs() < 3e-3 * usual,
                    "{network:?}: {found}, {expected}"
                );
            }
        }
    }

    #[test]
    fn the_same_bits_come_out_for_any_number_of_threads() {
        // Large enough that convolutions have more than one band of rows.
        for (network, size) in [(Network::Alex, [50, 41]), (Network::LpipsAlex, [131, 145])] {
            let perceptual = Perceptual::random(network, 2);
            let graded = |threads| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
                pool.expect("threads").install(|| {
                    let features = perceptual.features(&picture(1, size));
                    perceptual.value_and_gradient(&picture(0, size), &features)
                })
            };
            let one = graded(1);
            assert!(one.value > 0.0 && one.gradient.data.iter().all(|n| n.is_finite()));
            for threads in [2, 3, 7] {
                assert_eq!(graded(threads), one, "{threads} threads");
            }
        }
    }

    #[test]
    fn a_picture_is_at_no_distance_from_itself_and_black_ones_have_a_gradient() {
        for network in ALL {
            let perceptual = Perceptual::random(network, 3);
            let side = network.smallest_side() as usize;
            let image = picture(0, [side; 2]);
            let graded = perceptual.value_and_gradient(&image, &perceptual.features(&image));
            assert!(graded.value.abs() < 1e-10, "{}", graded.value);
            let black = Planes::black([side, side + 3]);
            let target = perceptual.features(&picture(1, black.size));
            let graded = perceptual.value_and_gradient(&black, &target);
            assert!(graded.value > 0.0 && length(&graded.gradient) > 0.0);
            assert!(graded.gradient.data.iter().all(|n| n.is_finite()));
        }
    }

    #[test]
    fn the_check_passes_with_random_weights() {
        for network in ALL {
            let checked = Perceptual::random(network, 7).check();
            assert!(checked.is_ok(), "{checked:?}");
        }
    }

    #[test]
    #[should_panic(expected = "too few")]
    fn small_pictures_are_refused() {
        let side = Network::Alex.smallest_side() as usize;
        Perceptual::random(Network::Alex, 1).features(&Planes::black([side - 1, 40]));
    }
}
