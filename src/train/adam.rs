//! Adam's rates and moments.

use serde::{Deserialize, Serialize};

/// Rates of Adam, one for each kind of number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates {
    /// Of quaternions.
    pub rotation: f64,
    /// Of log scales.
    pub log_scale: f64,
    /// Of the opacities' logits.
    pub opacity: f64,
    /// Of colours.
    pub color: f64,
    /// Of the nodes' offsets, metres.
    pub node_offset: f64,
    /// Of the nodes' bases.
    pub node_basis: f64,
    /// Of the networks.
    pub network: f64,
    /// Of the basis rows of rotation, scale and colour.
    pub bases: [f64; 3],
}

impl Rates {
    /// Nothing learns.
    pub const NONE: Self = Self {
        rotation: 0.0,
        log_scale: 0.0,
        opacity: 0.0,
        color: 0.0,
        node_offset: 0.0,
        node_basis: 0.0,
        network: 0.0,
        bases: [0.0; 3],
    };
}

/// Adam's constants.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Adam {
    /// β₁: how much of the first moment is kept.
    pub beta_1: f64,
    /// β₂: how much of the second.
    pub beta_2: f64,
    /// ε.
    pub epsilon: f64,
    /// Weight decay of the networks, apart from the derivative (AdamW).
    pub weight_decay: f64,
}

impl Adam {
    /// The predecessor's.
    pub const DEFAULT: Self = Self {
        beta_1: 0.9,
        beta_2: 0.999,
        epsilon: 1e-15,
        weight_decay: 1e-3,
    };

    /// 1 / (1 − β₁ᵗ) and 1 / (1 − β₂ᵗ) at the t-th step, the first of which is 1.
    pub fn correction(&self, t: u64) -> [f64; 2] {
        let power = i32::try_from(t.max(1)).unwrap_or(i32::MAX);
        [self.beta_1, self.beta_2].map(|beta| 1.0 / (1.0 - beta.powi(power)))
    }
}

/// Adam's moments of items that learn on the host, each of so many numbers and in steps of its own.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Moments {
    width: usize,
    /// Item after item.
    pub first: Vec<f64>,
    /// Item after item.
    pub second: Vec<f64>,
    /// Steps of each item.
    pub updates: Vec<u64>,
}

impl Moments {
    /// Of items that have not learned yet. `width`: numbers of each, at least 1.
    pub fn new(items: usize, width: usize) -> Self {
        Self {
            width,
            first: vec![0.0; items * width],
            second: vec![0.0; items * width],
            updates: vec![0; items],
        }
    }

    /// From arrays of a checkpoint; None where their lengths don't fit each other.
    pub fn from_arrays(first: Vec<f64>, second: Vec<f64>, updates: Vec<u64>) -> Option<Self> {
        let width = first.len() / updates.len().max(1);
        let fits = first.len() == second.len() && first.len() == width * updates.len();
        fits.then_some(Self {
            width,
            first,
            second,
            updates,
        })
    }

    /// Numbers of an item.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Items.
    pub fn items(&self) -> usize {
        self.updates.len()
    }

    /// Steps of an item.
    pub fn updates(&self, item: usize) -> u64 {
        self.updates[item]
    }

    /// Both moments of every number.
    pub fn numbers(&self) -> impl Iterator<Item = f64> {
        self.first.iter().chain(&self.second).copied()
    }

    /// Counts a step of an item. What its numbers go against, a rate of 1 being about a unit each.
    /// `floor`: how much of the item's root mean square is added to each number's own; above 0,
    /// numbers that hardly matter, whose derivatives are noise, hardly move.
    ///
    /// # Panics
    /// When the gradient has not [`Self::width`] numbers.
    pub fn direction(
        &mut self,
        item: usize,
        gradient: &[f64],
        floor: f64,
        adam: &Adam,
    ) -> Vec<f64> {
        assert_eq!(gradient.len(), self.width, "numbers of an item");
        self.updates[item] += 1;
        let correction = adam.correction(self.updates[item]);
        let own = item * self.width..(item + 1) * self.width;
        let first = &mut self.first[own.clone()];
        let second = &mut self.second[own];
        for (of, (m, v)) in gradient.iter().zip(first.iter_mut().zip(second.iter_mut())) {
            *m = adam.beta_1 * *m + (1.0 - adam.beta_1) * of;
            *v = adam.beta_2 * *v + (1.0 - adam.beta_2) * of * of;
        }
        let mean = second.iter().sum::<f64>() / self.width.max(1) as f64;
        let added = floor * (mean * correction[1]).sqrt() + adam.epsilon;
        first
            .iter()
            .zip(second.iter())
            .map(|(m, v)| m * correction[0] / ((v * correction[1]).sqrt() + added))
            .collect()
    }
}
