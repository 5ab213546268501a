//! The networks' features and the nodes' displacements, and how far f32 may take them from the
//! reference's.
//!
//! What a sum rounds is an error of its own, from −1 to 1 times its largest size, and each number
//! of a later layer is a linear form in all errors before it: errors that cancel do so here too.
//! Sums of absolute values would grow with the weights' absolute sums, layer by layer.

use super::rounding::F32;
use effigy_core::{
    avatar::{Activation, Avatar, NetworkLayer, Rows, matrix::Row},
    constants::{FEATURE_MAX, LEAKY_SLOPE},
    scene::Posed,
};
use glam::DVec3;
use half::f16;
use rayon::prelude::*;

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

/// More errors than this are summed up, one a number: the widest networks take too long otherwise.
const ERRORS_MAX: usize = 640;

/// Numbers as linear forms in independent errors between −1 and 1.
struct Forms {
    value: Vec<f64>,
    /// A row of coefficients a number.
    error: Vec<Vec<f64>>,
}

impl Forms {
    /// Numbers that are each rounded once.
    fn rounded(value: Vec<f64>) -> Self {
        let own = value.iter().map(|v| F32 * v.abs()).collect();
        Self::independent(value, own)
    }

    /// Numbers with an error each.
    fn independent(value: Vec<f64>, own: Vec<f64>) -> Self {
        let count = own.len();
        let error = own
            .into_iter()
            .enumerate()
            .map(|(at, error)| {
                let mut row = vec![0.0; count];
                row[at] = error;
                row
            })
            .collect();
        Self { value, error }
    }

    /// Largest error of each number.
    fn largest(&self) -> Vec<f64> {
        let sum = |row: &Vec<f64>| row.iter().map(|error| error.abs()).sum();
        self.error.iter().map(sum).collect()
    }

    fn errors(&self) -> usize {
        self.error.first().map_or(0, Vec::len)
    }

    /// A layer of one part: clamped, and activated unless it is the last.
    fn layer(&self, layer: &NetworkLayer, part: usize, activation: Option<Activation>) -> Self {
        let largest = self.largest();
        let errors = self.errors();
        let slope = match activation {
            None => 1.0,
            Some(Activation::Relu) => 0.0,
            Some(Activation::LeakyRelu) => LEAKY_SLOPE,
        };
        let mut value = Vec::with_capacity(layer.output);
        let mut error = Vec::with_capacity(layer.output);
        for neuron in 0..layer.output {
            let at = part * layer.output + neuron;
            let bias = layer.bias[at].to_f64();
            let mut sum = bias;
            let mut size = bias.abs();
            let mut row = vec![0.0; errors + layer.output];
            for (k, weight) in layer.weight.row(at, layer.input).iter().enumerate() {
                sum += weight * self.value[k];
                size += weight.abs() * (self.value[k].abs() + largest[k]);
                if weight != 0.0 {
                    for (own, before) in row.iter_mut().zip(&self.error[k]) {
                        *own += weight * before;
                    }
                }
            }
            let added = roundings(layer.input) * F32 * size;
            let most = row.iter().map(|error| error.abs()).sum::<f64>() + added;
            // Clamping and activation rise with the sum: the interval's ends give the result's.
            let result = |sum: f64| {
                let clamped = sum.clamp(-FEATURE_MAX, FEATURE_MAX);
                clamped.max(slope * clamped)
            };
            let [low, high] = [sum - most, sum + most];
            let factor = if low >= 0.0 && high <= FEATURE_MAX {
                Some(1.0)
            } else if high <= 0.0 && low >= -FEATURE_MAX {
                Some(slope)
            } else {
                None
            };
            let activated = F32 * slope * result(sum).abs();
            let own = match factor {
                Some(factor) => {
                    for error in &mut row {
                        *error *= factor;
                    }
                    factor * added
                }
                // Not linear in between: an error of its own.
                None => {
                    row.fill(0.0);
                    (result(high) - result(sum)).max(result(sum) - result(low))
                }
            };
            row[errors + neuron] = own + activated;
            value.push(result(sum));
            error.push(row);
        }
        let forms = Self { value, error };
        if forms.errors() <= ERRORS_MAX {
            return forms;
        }
        let own = forms.largest();
        Self::independent(forms.value, own)
    }
}

/// The features of every part; shape N_G, E, as [`effigy_core::reference::mlp::features`] has them.
pub fn features(avatar: &Avatar, posed: &Posed) -> Uncertain {
    let layers = &avatar.networks.layers;
    let parts: Vec<Forms> = (0..avatar.parts.len())
        .into_par_iter()
        .map(|part| {
            let mut input = posed.input.clone();
            if part >= avatar.parts.head {
                input[3 * avatar.inputs.joint.len()..].fill(0.0);
            }
            layers
                .iter()
                .enumerate()
                .fold(Forms::rounded(input), |x, (at, own)| {
                    let last = at + 1 == layers.len();
                    x.layer(own, part, (!last).then_some(avatar.networks.activation))
                })
        })
        .collect();
    let mut all = Uncertain::default();
    for forms in parts {
        all.error.extend(forms.largest());
        all.value.extend(forms.value);
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
                let clamp = |v: f64| v.clamp(-FEATURE_MAX, FEATURE_MAX);
                let value = f16::from_f64(clamp(exact)).to_f64();
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
