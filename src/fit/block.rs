//! The numbers of one part's Gaussians over some frames as a matrix; and what is known of all Gaussians at once: means and spreads.

use super::dataset::{Attribute, Dataset};
use crate::avatar::Avatar;
use rayon::prelude::*;
use std::ops::Range;

/// The attributes that have basis rows.
pub const ATTRIBUTES: [Attribute; 3] = [Attribute::Rotation, Attribute::LogScale, Attribute::Color];
/// How much of the loss each is, and the nodes' displacements beside them: colour is seen most.
const SHARE: [f64; 3] = [0.2, 0.2, 0.6];
const NODE_SHARE: f64 = 0.5;

/// The Gaussians that keep a corrective of their rotation, scale and colour, rising; None where all do.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Kept(pub Option<[Vec<u32>; 3]>);

impl Kept {
    /// Those of a range of Gaussians.
    pub fn within(&self, attribute: usize, range: &Range<usize>) -> Vec<u32> {
        match &self.0 {
            None => (range.start as u32..range.end as u32).collect(),
            Some(lists) => {
                let at = |end: usize| lists[attribute].partition_point(|&k| (k as usize) < end);
                lists[attribute][at(range.start)..at(range.end)].to_vec()
            }
        }
    }
}

/// Means over the training frames, and what each attribute's numbers are multiplied by so that the losses add up.
#[derive(Clone, Debug)]
pub struct Statistics {
    /// Shape N_g, width; rotation, log scale, colour.
    pub mean: [Vec<f32>; 3],
    pub weight: [f32; 3],
    pub node_weight: f32,
}

/// The range of Gaussians of a part.
pub fn range(avatar: &Avatar, part: usize) -> Range<usize> {
    avatar.parts.start[part] as usize..avatar.parts.start[part + 1] as usize
}

impl Statistics {
    /// `moved`: the squared displacements of all nodes over the frames about their means.
    pub fn new(dataset: &Dataset, frames: &[usize], moved: f64) -> Self {
        let count = frames.len().max(1) as f64;
        let parts: Vec<[(Vec<f32>, f64); 3]> = (0..dataset.avatar.parts.len())
            .into_par_iter()
            .map(|part| {
                let range = range(&dataset.avatar, part);
                ATTRIBUTES.map(|attribute| {
                    let width = range.len() * attribute.width();
                    let (mut sum, mut squares) = (vec![0.0f64; width], 0.0);
                    let mut numbers = Vec::with_capacity(width);
                    for &frame in frames {
                        numbers.clear();
                        dataset.numbers(frame, attribute, range.clone(), &mut numbers);
                        sum.iter_mut().zip(&numbers).for_each(|(sum, &x)| *sum += f64::from(x));
                        squares += numbers.iter().map(|&x| f64::from(x).powi(2)).sum::<f64>();
                    }
                    let spread = squares - sum.iter().map(|s| s * s).sum::<f64>() / count;
                    (sum.iter().map(|s| (s / count) as f32).collect(), spread)
                })
            })
            .collect();
        let spread: [f64; 3] = std::array::from_fn(|a| parts.iter().map(|part| part[a].1).sum());
        let weight = |share: f64, spread: f64| if spread > 1e-12 { (share / spread * count).sqrt() as f32 } else { 0.0 };
        Self {
            mean: std::array::from_fn(|a| parts.iter().flat_map(|part| part[a].0.iter().copied()).collect()),
            weight: std::array::from_fn(|a| weight(SHARE[a], spread[a])),
            node_weight: weight(NODE_SHARE, moved),
        }
    }
}

/// The kept numbers of a part over some frames, each multiplied by its attribute's weight.
pub struct Block {
    pub kept: [Vec<u32>; 3],
    /// Where each attribute's columns begin, and their number.
    pub start: [usize; 4],
    /// Shape frames, columns.
    pub x: Vec<f32>,
}

impl Block {
    pub fn load(dataset: &Dataset, statistics: &Statistics, kept: &Kept, part: usize, frames: &[usize]) -> Self {
        let range = range(&dataset.avatar, part);
        let kept: [Vec<u32>; 3] = std::array::from_fn(|a| kept.within(a, &range));
        let mut start = [0; 4];
        (0..3).for_each(|a| start[a + 1] = start[a] + kept[a].len() * ATTRIBUTES[a].width());
        let mut x = Vec::with_capacity(frames.len() * start[3]);
        let mut numbers = Vec::new();
        for &frame in frames {
            for (a, attribute) in ATTRIBUTES.into_iter().enumerate().filter(|(a, _)| !kept[*a].is_empty()) {
                numbers.clear();
                dataset.numbers(frame, attribute, range.clone(), &mut numbers);
                let (width, weight) = (attribute.width(), statistics.weight[a]);
                for &k in &kept[a] {
                    x.extend(numbers[(k as usize - range.start) * width..][..width].iter().map(|x| x * weight));
                }
            }
        }
        Self { kept, start, x }
    }

    pub fn columns(&self) -> usize {
        self.start[3]
    }
}

/// Takes the mean of some rows of a matrix off all of its rows; the mean.
pub fn center(x: &mut [f32], columns: usize, rows: &[usize]) -> Vec<f32> {
    if columns == 0 {
        return Vec::new();
    }
    let mut mean = vec![0.0f64; columns];
    for &row in rows {
        mean.iter_mut().zip(&x[row * columns..][..columns]).for_each(|(m, &x)| *m += f64::from(x));
    }
    let mean: Vec<f32> = mean.iter().map(|m| (m / rows.len().max(1) as f64) as f32).collect();
    x.chunks_exact_mut(columns).for_each(|row| row.iter_mut().zip(&mean).for_each(|(x, m)| *x -= m));
    mean
}
