//! How far apart features are: of a length of 1 at each pixel, squared differences weighted by
//! channel, summed over channels, the mean over pixels.

use crate::maps::Maps;
use rayon::prelude::*;

/// What networks take from colours of -1 to 1, RGB. Then they divide them by [`SCALE`].
pub const SHIFT: [f32; 3] = [-0.030, -0.088, -0.188];
/// What networks divide colours by, RGB.
pub const SCALE: [f32; 3] = [0.458, 0.448, 0.450];
/// Added to lengths.
const EPSILON: f32 = 1e-10;
/// Pixels of a task.
const PIXELS: usize = 256;

/// One over the length of each pixel's features.
fn over_lengths(maps: &Maps) -> Vec<f32> {
    let plane = maps.plane();
    let mut lengths = vec![0.0f32; plane];
    lengths
        .par_chunks_mut(PIXELS)
        .enumerate()
        .for_each(|(task, lengths)| {
            for numbers in maps.data.chunks_exact(plane) {
                for (length, number) in lengths.iter_mut().zip(&numbers[task * PIXELS..]) {
                    *length += number * number;
                }
            }
            for length in lengths {
                *length = 1.0 / (length.sqrt() + EPSILON);
            }
        });
    lengths
}

/// The features with a length of 1 at each pixel, or 0 where there are none.
pub fn unit(maps: &Maps) -> Maps {
    let over = over_lengths(maps);
    let mut unit = maps.clone();
    unit.data
        .par_chunks_exact_mut(over.len())
        .for_each(|numbers| {
            for (number, over) in numbers.iter_mut().zip(&over) {
                *number *= over;
            }
        });
    unit
}

/// A distance and its gradient with respect to the first features.
pub struct Distance {
    /// The distance.
    pub value: f64,
    /// The gradient, where it was asked for.
    pub gradient: Option<Maps>,
}

/// The distance of features from those of a target, which have a length of 1. `weights`: what each
/// channel counts.
pub fn distance(maps: &Maps, target: &Maps, weights: &[f32], with_gradient: bool) -> Distance {
    assert!(maps.size == target.size && maps.channels == target.channels);
    let plane = maps.plane();
    let mean = 1.0 / plane as f32;
    let over = over_lengths(maps);
    // Of each pixel: what it adds to the distance, and its features times the distance's
    // derivative with respect to those of length 1.
    let mut sums = vec![0.0f32; plane];
    let mut along = vec![0.0f32; plane];
    sums.par_chunks_mut(PIXELS)
        .zip(along.par_chunks_mut(PIXELS))
        .enumerate()
        .for_each(|(task, (sums, along))| {
            let start = task * PIXELS;
            let over = &over[start..][..sums.len()];
            let channels = maps.data.chunks_exact(plane);
            let channels = channels.zip(target.data.chunks_exact(plane)).zip(weights);
            for ((ours, theirs), weight) in channels {
                let numbers = ours[start..].iter().zip(&theirs[start..]).zip(over);
                let into = sums.iter_mut().zip(along.iter_mut());
                for (((ours, theirs), over), (sum, along)) in numbers.zip(into) {
                    let difference = weight * (ours * over - theirs);
                    *sum += difference * (ours * over - theirs);
                    *along += difference * ours;
                }
            }
        });
    let value = sums.iter().map(|&sum| f64::from(sum)).sum::<f64>() / plane as f64;
    if !with_gradient {
        return Distance {
            value,
            gradient: None,
        };
    }
    // A length's derivative is a unit vector, undefined where the length is 0. All features are 0
    // there, so the gradient is never read.
    let along: Vec<f32> = along
        .iter()
        .zip(&over)
        .map(|(along, over)| {
            let scaled = along * over * over * over;
            if scaled.is_finite() { scaled } else { 0.0 }
        })
        .collect();
    let mut gradient = Maps::zeros(maps.channels, maps.size);
    gradient
        .data
        .par_chunks_exact_mut(plane)
        .enumerate()
        .for_each(|(channel, into)| {
            let ours = &maps.data[channel * plane..][..plane];
            let theirs = &target.data[channel * plane..][..plane];
            let weight = weights[channel];
            let pixels = ours.iter().zip(theirs).zip(over.iter().zip(&along));
            for (into, ((ours, theirs), (over, along))) in into.iter_mut().zip(pixels) {
                let difference = weight * (ours * over - theirs);
                *into = 2.0 * mean * (difference * over - ours * along);
            }
        });
    Distance {
        value,
        gradient: Some(gradient),
    }
}
