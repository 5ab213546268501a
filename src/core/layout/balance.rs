//! How the GPU's model holds the bases of nodes and the features that they are multiplied by, so
//! that bases lose less where they are rounded to bytes.
//!
//! A node's basis has one step, by the largest of its numbers. A function with small numbers and
//! large features then keeps few bits: on the baked body nodes were off by up to 0.24 mm, which is
//! enough to swap Gaussians. So where all functions of a part do not reach about as far, those that
//! reach least are enlarged by a power of two, and the neurons that compute their features are
//! reduced by it.

use crate::avatar::{Avatar, Matrix, NetworkLayer};
use half::f16;

/// Powers of two that a function is enlarged by at most: more makes nothing better, since a node
/// that others move further has its step from them, and leaves weights fewer bits.
const MOST: f64 = 5.0;

/// How an avatar is balanced: by how much each basis function of its nodes is enlarged.
pub struct Balance<'a> {
    avatar: &'a Avatar,
    /// The layer that computes features.
    last: &'a NetworkLayer,
    /// Shape N_G, N_B.
    factors: Vec<f64>,
}

impl<'a> Balance<'a> {
    /// None where nothing is to be changed: nodes share their features with attributes, or bases or
    /// weights are bytes already, which the GPU's model holds as they are.
    pub fn new(avatar: &'a Avatar) -> Option<Self> {
        let basis = avatar.basis_len();
        let shared = avatar.node_feature_start() == 0;
        let last = avatar.networks.layers.last()?;
        if basis == 0 || shared || last.weight.is_bytes() || avatar.nodes.basis.is_bytes() {
            return None;
        }
        let mut reach = vec![0.0_f64; avatar.parts.len() * basis];
        for (row, &part) in avatar.nodes.basis.rows(3 * basis).zip(&avatar.nodes.part) {
            let reach = &mut reach[usize::from(part) * basis..][..basis];
            for (at, number) in row.iter().enumerate() {
                reach[at % basis] = reach[at % basis].max(number.abs());
            }
        }
        Some(Self {
            avatar,
            last,
            factors: reach.chunks_exact(basis).flat_map(factors).collect(),
        })
    }

    /// The bases of the avatar's nodes, enlarged.
    pub fn bases(&self) -> Matrix {
        let basis = self.avatar.basis_len();
        let nodes = &self.avatar.nodes;
        let rows = nodes.basis.rows(3 * basis).zip(&nodes.part);
        rows.flat_map(|(row, &part)| {
            let factors = &self.factors[usize::from(part) * basis..][..basis];
            let pairs = row.iter().zip(factors.iter().cycle());
            pairs.map(|(number, factor)| f16::from_f64(factor * number))
        })
        .collect()
    }

    /// The last layer of the avatar's networks, with the nodes' features reduced. A weight or bias
    /// that comes under 6e-5 is off by up to 3e-8.
    pub fn last_layer(&self) -> NetworkLayer {
        let basis = self.avatar.basis_len();
        let start = self.avatar.node_feature_start();
        let mut layer = self.last.clone();
        let weights = layer.weight.halves_mut();
        for (at, &factor) in self.factors.iter().enumerate() {
            let neuron = at / basis * layer.output + start + at % basis;
            let own = &mut weights[neuron * layer.input..][..layer.input];
            for number in own.iter_mut().chain([&mut layer.bias[neuron]]) {
                *number = f16::from_f64(number.to_f64() / factor);
            }
        }
        layer
    }
}

/// What each function of a part is enlarged by, from how far each reaches.
fn factors(reach: &[f64]) -> impl Iterator<Item = f64> {
    let largest = reach.iter().copied().fold(0.0, f64::max);
    reach.iter().map(move |&own| {
        if own > 0.0 {
            (largest / own).log2().floor().min(MOST).exp2()
        } else {
            1.0
        }
    })
}

impl Avatar {
    /// This avatar with the networks and bases that the GPU's model holds, before bases are rounded
    /// to bytes. It moves the same, but for a rounding of weights, and for features that exceed
    /// ±[`FEATURE_MAX`](crate::constants::FEATURE_MAX).
    pub fn balanced(mut self) -> Self {
        let Some(balance) = Balance::new(&self) else {
            return self;
        };
        let (bases, layer) = (balance.bases(), balance.last_layer());
        self.nodes.basis = bases;
        self.networks.layers.pop();
        self.networks.layers.push(layer);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::avatar::Pose;
    use crate::layout::compact;
    use crate::reference::{mlp, nodes};
    use crate::scene::Posed;
    use glam::DVec3;

    /// The demo with functions that reach unequally far, as those of the body do.
    fn unequal() -> Avatar {
        let mut avatar = crate::demo::avatar().unwrap();
        let basis = avatar.basis_len();
        assert_ne!(avatar.node_feature_start(), 0, "nodes have no features");
        for row in avatar.nodes.basis.halves_mut().chunks_exact_mut(basis) {
            for (function, number) in row.iter_mut().enumerate() {
                let factor = f64::from(function as u32 % 3 * 2).exp2();
                *number = f16::from_f64(number.to_f64() / factor);
            }
        }
        avatar
    }

    fn displacements(avatar: &Avatar) -> Vec<DVec3> {
        let mut pose = Pose::rest(avatar.skeleton.len(), avatar.inputs.expression);
        for (joint, rotation) in pose.rotation.iter_mut().enumerate() {
            *rotation = DVec3::new(0.3, -0.2, 0.1) * (joint % 3) as f64;
        }
        let posed = Posed::new(avatar, &pose);
        nodes::nodes(avatar, &mlp::features(avatar, &posed.input))
    }

    fn furthest(a: &[DVec3], b: &[DVec3]) -> f64 {
        let distances = a.iter().zip(b).map(|(a, b)| a.distance(*b));
        distances.fold(0.0, f64::max)
    }

    #[test]
    fn a_balanced_avatar_moves_the_same_and_rounds_to_less() {
        let avatar = unequal();
        let exact = displacements(&avatar);
        let moved = furthest(&exact, &vec![DVec3::ZERO; exact.len()]);
        let same = furthest(&exact, &displacements(&avatar.clone().balanced()));
        assert!(same < 1e-5 * moved, "{same} m of {moved}");
        let mut unbalanced = avatar.clone();
        unbalanced.nodes.basis = compact::matrix_of(compact::node_rows(
            &avatar.nodes.basis,
            3 * avatar.basis_len(),
        ));
        let before = furthest(&exact, &displacements(&unbalanced));
        let after = furthest(&exact, &displacements(&avatar.compact()));
        assert!(after < 0.6 * before, "{before} m became {after}");
    }

    #[test]
    fn what_is_bytes_stays_as_it_is() {
        let mut bases = unequal();
        bases.nodes.basis = bases.nodes.basis.bytes(3 * bases.basis_len());
        assert!(Balance::new(&bases).is_none());
        let mut weights = unequal();
        for layer in &mut weights.networks.layers {
            layer.weight = layer.weight.bytes(layer.input);
        }
        assert!(Balance::new(&weights).is_none());
    }
}
