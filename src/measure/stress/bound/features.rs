//! The networks' features and the nodes' displacements, and how far f32 may take them from the
//! reference's: the error of each sum is the sum of its terms' errors and what adding them rounds.

use super::rounding::F32;
use effigy_core::{
    avatar::{Activation, Avatar, Layer, Rows, matrix::Row},
    constants::{FEATURE_MAX, LEAKY_SLOPE},
    scene::Posed,
};
use glam::DVec3;
use half::f16;

/// Numbers and the error of each.
#[derive(Clone, Debug, Default)]
pub struct Uncertain {
    pub value: Vec<f64>,
    pub error: Vec<f64>,
}

/// A sum and its error.
#[derive(Clone, Copy, Debug, Default)]
pub struct UncertainSum {
    pub value: f64,
    pub error: f64,
}

/// How many roundings a term of a product of so many numbers goes through: the device adds dot
/// products of four to a sum, and multiplies bytes by their steps.
fn roundings(terms: usize) -> f64 {
    terms.div_ceil(4) as f64 + 8.0
}

/// The product of a row with uncertain numbers.
fn dot(row: Row, value: &[f64], error: &[f64]) -> UncertainSum {
    let mut sum = UncertainSum::default();
    let mut size = 0.0;
    for ((weight, x), e) in row.iter().zip(value).zip(error) {
        sum.value += weight * x;
        sum.error += weight.abs() * e;
        size += weight.abs() * (x.abs() + e);
    }
    sum.error += roundings(value.len()) * F32 * size;
    sum
}

/// A layer of one part: clamped, and activated unless it is the last.
fn layer(layer: &Layer, part: usize, x: &Uncertain, activation: Option<Activation>) -> Uncertain {
    let mut out = Uncertain::default();
    for neuron in 0..layer.output {
        let row = part * layer.output + neuron;
        let bias = layer.bias[row].to_f64();
        let sum = dot(layer.weight.row(row, layer.input), &x.value, &x.error);
        let error = sum.error + roundings(layer.input) * F32 * bias.abs();
        let slope = match activation {
            None => 1.0,
            Some(Activation::Relu) => 0.0,
            Some(Activation::LeakyRelu) => LEAKY_SLOPE,
        };
        // Clamping and activation rise with the sum: the interval's ends give the result's.
        let result = |sum: f64| {
            let clamped = sum.clamp(-FEATURE_MAX, FEATURE_MAX);
            clamped.max(slope * clamped)
        };
        let value = result(bias + sum.value);
        let [low, high] = [-error, error].map(|by| result(bias + sum.value + by));
        out.value.push(value);
        out.error
            .push((high - value).max(value - low) + F32 * slope * value.abs());
    }
    out
}

/// The features of every part; shape N_G, E, as [`effigy_core::reference::mlp::features`] has them.
pub fn features(avatar: &Avatar, posed: &Posed) -> Uncertain {
    let layers = &avatar.networks.layers;
    let mut all = Uncertain::default();
    for part in 0..avatar.parts.len() {
        let mut value = posed.input.clone();
        if part >= avatar.parts.head {
            value[3 * avatar.inputs.joint.len()..].fill(0.0);
        }
        let error = value.iter().map(|v| F32 * v.abs()).collect();
        let mut x = Uncertain { value, error };
        for (at, own) in layers.iter().enumerate() {
            let last = at + 1 == layers.len();
            x = layer(own, part, &x, (!last).then_some(avatar.networks.activation));
        }
        all.value.extend(x.value);
        all.error.extend(x.error);
    }
    all
}

/// The displacements of the nodes as f16 have them, and the largest error of each coordinate: a
/// device may round either way, and from anywhere in the interval that the features leave.
pub fn nodes(stored: &Avatar, features: &Uncertain) -> Vec<[UncertainSum; 3]> {
    let basis = stored.basis_len();
    (0..stored.nodes.len())
        .map(|node| {
            let part = usize::from(stored.nodes.part[node]);
            let from = part * stored.networks.output() + stored.node_feature_start();
            let row = stored.nodes.basis.row(node, 3 * basis);
            std::array::from_fn(|k| {
                let offset = f64::from(stored.nodes.offset[node][k]);
                let sum = dot(
                    row.piece(k * basis, basis),
                    &features.value[from..][..basis],
                    &features.error[from..][..basis],
                );
                let exact = offset + sum.value;
                let error = sum.error + roundings(basis) * F32 * offset.abs();
                let value = f16::from_f64(exact).to_f64();
                let clamp = |v: f64| v.clamp(-FEATURE_MAX, FEATURE_MAX);
                let low = half_below(clamp(exact - error));
                let high = -half_below(-clamp(exact + error));
                UncertainSum {
                    value,
                    error: (high - value).max(value - low),
                }
            })
        })
        .collect()
}

/// The largest f16 that is not above a number.
fn half_below(value: f64) -> f64 {
    let nearest = f16::from_f64(value);
    if nearest.to_f64() <= value {
        return nearest.to_f64();
    }
    let bits = nearest.to_bits();
    let below = match bits {
        0 => 0x8001,
        _ if bits & 0x8000 == 0 => bits - 1,
        _ => bits + 1,
    };
    f16::from_bits(below).to_f64()
}

/// The corrective of one Gaussian; zero and exact where it has no row.
pub fn corrective<const C: usize>(
    rows: &Rows<C>,
    gaussian: usize,
    value: &[f64],
    error: &[f64],
) -> [UncertainSum; C] {
    let Ok(at) = rows.gaussian.binary_search(&(gaussian as u32)) else {
        return [UncertainSum::default(); C];
    };
    let row = rows.basis.row(at, C * value.len());
    std::array::from_fn(|c| dot(row.piece(c * value.len(), value.len()), value, error))
}

/// The values of sums.
pub fn values<const C: usize>(sums: [UncertainSum; C]) -> [f64; C] {
    sums.map(|sum| sum.value)
}

/// The length of a vector of errors.
pub fn length<const C: usize>(sums: [UncertainSum; C]) -> f64 {
    sums.iter().map(|sum| sum.error.powi(2)).sum::<f64>().sqrt()
}

/// The errors of three sums.
pub fn errors(sums: [UncertainSum; 3]) -> DVec3 {
    DVec3::from(sums.map(|sum| sum.error))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_are_rounded_down() {
        for (value, below) in [
            (1.0, 1.0),
            (1.0004, 1.0),
            (0.9999, 0.99951171875),
            (-1.0001, -1.0009765625),
            (0.0, 0.0),
            (-1e-9, -5.960464477539063e-8),
        ] {
            assert_eq!(half_below(value), below, "{value}");
        }
    }
}
