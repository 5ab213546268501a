//! An avatar that is equal to another, and loses less where the basis of its nodes is rounded.

use super::{Avatar, Matrix, Networks};
use half::f16;

/// Powers of two between the largest and the smallest change of a feature: a weight is then off by
/// no more than 2⁻²⁵.
const MOST: f64 = 10.0;

impl Avatar {
    /// The same avatar, in which all basis functions of a part's nodes reach about as far.
    ///
    /// A node's basis is rounded to bytes with one step ([`crate::layout::compact`]), by the
    /// largest of its numbers. A function with small numbers and large features then keeps few
    /// bits: on the baked body a node was moved by up to 0.24 mm, which is enough to swap
    /// Gaussians. Here such a function is enlarged by a power of two, and what computes its feature
    /// is reduced by it. Weights under 6e-5 are rounded by up to 3e-8, which is all that differs.
    ///
    /// Nothing changes where nodes share their features with attributes, or where bases or weights
    /// are bytes already.
    pub fn balanced(mut self) -> Self {
        let basis = self.basis_len();
        let start = self.node_feature_start();
        let bytes = |networks: &Networks| {
            let last = networks.layers.last();
            last.is_none_or(|layer| layer.weight.is_bytes())
        };
        let Matrix::Halves(numbers) = &mut self.nodes.basis else {
            return self;
        };
        if basis == 0 || start == 0 || bytes(&self.networks) {
            return self;
        }
        let part_of = |node: usize| usize::from(self.nodes.part[node]);
        let mut reach = vec![0.0_f64; self.parts.len() * basis];
        for (node, row) in numbers.chunks_exact(3 * basis).enumerate() {
            for (at, number) in row.iter().enumerate() {
                let reach = &mut reach[part_of(node) * basis + at % basis];
                *reach = reach.max(number.to_f64().abs());
            }
        }
        let factors: Vec<f64> = reach.chunks_exact(basis).flat_map(factors).collect();
        for (node, row) in numbers.chunks_exact_mut(3 * basis).enumerate() {
            for (at, number) in row.iter_mut().enumerate() {
                let factor = factors[part_of(node) * basis + at % basis];
                *number = f16::from_f64(factor * number.to_f64());
            }
        }
        if let Some(layer) = self.networks.layers.last_mut() {
            let weights = layer.weight.halves_mut();
            for (at, &factor) in factors.iter().enumerate() {
                let neuron = at / basis * layer.output + start + at % basis;
                let own = &mut weights[neuron * layer.input..][..layer.input];
                for number in own.iter_mut().chain([&mut layer.bias[neuron]]) {
                    *number = f16::from_f64(number.to_f64() / factor);
                }
            }
        }
        self
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::avatar::Pose;
    use crate::reference::{mlp, nodes};
    use crate::scene::Posed;
    use glam::DVec3;

    /// The demo with features of their own for nodes, whose functions reach unequally far, as those
    /// of a body do.
    fn unequal() -> (Avatar, Posed) {
        let mut avatar = crate::demo::avatar().unwrap();
        let basis = avatar.basis_len();
        assert_ne!(avatar.node_feature_start(), 0, "nodes have no features");
        for row in avatar.nodes.basis.halves_mut().chunks_exact_mut(basis) {
            for (function, number) in row.iter_mut().enumerate() {
                let factor = f64::from(function as u32 % 4 * 2).exp2();
                *number = f16::from_f64(number.to_f64() / factor);
            }
        }
        let mut pose = Pose::rest(avatar.skeleton.len(), avatar.inputs.expression);
        for (joint, rotation) in pose.rotation.iter_mut().enumerate() {
            *rotation = DVec3::new(0.3, -0.2, 0.1) * (joint % 3) as f64;
        }
        let posed = Posed::new(&avatar, &pose);
        (avatar, posed)
    }

    fn displacements(avatar: &Avatar, posed: &Posed) -> Vec<DVec3> {
        nodes::nodes(avatar, &mlp::features(avatar, &posed.input))
    }

    fn furthest(a: &[DVec3], b: &[DVec3]) -> f64 {
        let distances = a.iter().zip(b).map(|(a, b)| a.distance(*b));
        distances.fold(0.0, f64::max)
    }

    #[test]
    fn a_balanced_avatar_moves_as_before_and_rounds_to_less() {
        let (avatar, posed) = unequal();
        let exact = displacements(&avatar, &posed);
        let moved = furthest(&exact, &vec![DVec3::ZERO; exact.len()]);
        let balanced = avatar.clone().balanced();
        let same = furthest(&exact, &displacements(&balanced, &posed));
        assert!(same < 1e-5 * moved, "{same} m of {moved}");
        let before = furthest(&exact, &displacements(&avatar.compact(), &posed));
        let after = furthest(&exact, &displacements(&balanced.compact(), &posed));
        assert!(after < 0.5 * before, "{before} m became {after}");
    }

    #[test]
    fn nothing_changes_where_bases_or_weights_are_bytes() {
        let (avatar, _) = unequal();
        let mut bytes = avatar.clone();
        bytes.nodes.basis = bytes.nodes.basis.bytes(3 * avatar.basis_len());
        assert!(bytes.clone().balanced() == bytes, "bases are bytes");
        let mut bytes = avatar;
        for layer in &mut bytes.networks.layers {
            layer.weight = layer.weight.bytes(layer.input);
        }
        assert!(bytes.clone().balanced() == bytes, "weights are bytes");
    }
}
