//! The avatar without networks: the mean of its correctives over some poses is in its Gaussians.

use super::assemble::no_rows;
use effigy_core::avatar::{Avatar, Inputs, Networks, Nodes};
use effigy_core::constants::F16_MAX;
use effigy_core::reference::{
    basis::corrective,
    mlp,
    nodes::{self, displacement},
};
use glam::DVec3;
use half::f16;
use rayon::prelude::*;

/// A Gaussian's correctives, summed over poses.
#[derive(Clone, Copy, Default)]
struct CorrectiveSums {
    position: DVec3,
    rotation: [f64; 4],
    log_scale: [f64; 3],
    color: [f64; 3],
}

/// Stills an avatar at the mean over network inputs, of which there is at least one. Positions
/// stay in the avatar's bounds.
pub fn still(avatar: &Avatar, inputs: &[Vec<f64>]) -> Avatar {
    let mut sums = vec![CorrectiveSums::default(); avatar.gaussians.len()];
    let inputs = if avatar.networks.layers.is_empty() {
        &[]
    } else {
        inputs
    };
    for input in inputs {
        let features = mlp::features(avatar, input);
        let nodes = nodes::nodes(avatar, &features);
        sums.par_iter_mut().enumerate().for_each(|(k, sums)| {
            let e = mlp::of_gaussian(avatar, &features, k);
            sums.position += displacement(avatar.node_weights(k), avatar.gaussians.node[k], &nodes);
            add(&mut sums.rotation, corrective(&avatar.rotation_rows, k, e));
            add(&mut sums.log_scale, corrective(&avatar.scale_rows, k, e));
            add(&mut sums.color, corrective(&avatar.color_rows, k, e));
        });
    }
    let share = 1.0 / inputs.len().max(1) as f64;
    let mut gaussians = avatar.gaussians.clone();
    for (k, sums) in sums.iter().enumerate() {
        let position = avatar.position(k) + share * sums.position;
        gaussians.position[k] = gaussians.bounds.encode(position);
        gaussians.rotation[k] = plus(gaussians.rotation[k], share, sums.rotation);
        gaussians.log_scale[k] = plus(gaussians.log_scale[k], share, sums.log_scale);
        gaussians.color[k] = plus(gaussians.color[k], share, sums.color);
        gaussians.node[k] = [0; 3];
    }
    Avatar {
        gaussians,
        networks: Networks {
            layers: vec![],
            ..avatar.networks.clone()
        },
        rotation_rows: no_rows(&avatar.rotation_rows),
        scale_rows: no_rows(&avatar.scale_rows),
        color_rows: no_rows(&avatar.color_rows),
        nodes: Nodes::still(),
        inputs: Inputs::none(),
        ..avatar.clone()
    }
}

fn add<const C: usize>(sum: &mut [f64; C], numbers: [f64; C]) {
    for (sum, number) in sum.iter_mut().zip(numbers) {
        *sum += number;
    }
}

fn plus<const C: usize>(numbers: [f16; C], share: f64, sums: [f64; C]) -> [f16; C] {
    std::array::from_fn(|c| {
        f16::from_f64((numbers[c].to_f64() + share * sums[c]).clamp(-F16_MAX, F16_MAX))
    })
}
