//! The numbers of an avatar as the GPU's model keeps them: an [`Avatar`] goes in, the nearest one whose Gaussians fit 32 bytes and whose
//! correctives, of attributes and of nodes, fit a byte a number comes out.
//!
//! What is rounded, and by how much at most: quaternions (30 bits: 0.0007 a component), log scales (10 bits over the avatar's own range,
//! 1/256 for up to 8 octaves and a half), colours (8 bits, kept whole where a corrective is added), correctives (8 bits of the largest in
//! their row), and the weights of nodes ([`node_shares`]: 0.016). Networks, positions, joints, opacities
//! and the nodes' offsets stay as they are.

use crate::{
    avatar::{
        Avatar, Matrix, Rows,
        matrix::{self, Row as Numbers},
    },
    frame::LOG_SCALE_MAX,
};
use half::f16;

/// Steps of a quaternion's three smaller components in 1: none of them is above √½, which is 509 of the 511 steps that fit.
pub const QUATERNION_STEPS: f64 = 720.0;
/// Steps of a node's share in 1.
pub const NODE_STEPS: f64 = 31.0;
/// The smallest log scale, a tenth of a micrometre; smaller ones are drawn like it.
const LOG_SCALE_MIN: f64 = -16.0;
/// Largest code of a log scale.
const LOG_SCALE_CODES: f64 = 1023.0;

/// Log scales as 10-bit codes: `min + step · code`. Both are short enough in binary that f16 holds every one of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LogScales {
    pub min: f64,
    pub step: f64,
}

impl LogScales {
    /// The finest codes that reach from the smallest to the largest.
    pub fn of(avatar: &Avatar) -> Self {
        let all = avatar.gaussians.log_scale.iter().flatten().map(|s| clamp(s.to_f64()));
        let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), s| (low.min(s), high.max(s)));
        let (low, high) = if low <= high { (low, high) } else { (0.0, 0.0) };
        // Of two that are as near the upper: the smallest has the first code, and keeps it where it was rounded to that before.
        let first = |step: f64| (low / step + 0.5).floor() * step;
        let mut step = 1.0 / 128.0;
        while (high - first(step)) / step > LOG_SCALE_CODES {
            step *= 2.0;
        }
        Self { min: first(step), step }
    }

    pub fn encode(self, log_scale: f64) -> u32 {
        ((clamp(log_scale) - self.min) / self.step).round().clamp(0.0, LOG_SCALE_CODES) as u32
    }

    pub fn decode(self, code: u32) -> f64 {
        self.min + self.step * f64::from(code)
    }
}

/// NaN is the smallest.
fn clamp(log_scale: f64) -> f64 {
    if log_scale.is_nan() { LOG_SCALE_MIN } else { log_scale.clamp(LOG_SCALE_MIN, LOG_SCALE_MAX) }
}

/// A quaternion in 32 bits: which component is the largest (2 bits, the highest), and the others in [`QUATERNION_STEPS`], 10 bits each.
/// It comes out of length 1 and with the largest positive: the sign to get there is the second number.
pub fn encode_quaternion(q: [f64; 4]) -> (u32, f64) {
    let length = q.iter().map(|v| v * v).sum::<f64>().sqrt();
    let unit = if length > 0.0 { q.map(|v| v / length) } else { [1.0, 0.0, 0.0, 0.0] };
    let largest = (0..4).max_by(|&a, &b| unit[a].abs().total_cmp(&unit[b].abs())).unwrap_or(0);
    // f16 may have made others as large as the one that was: of these, the one by which the same f16 come out.
    let tied = |&k: &usize| k != largest && unit[k].abs() > unit[largest].abs() - 3e-3;
    let same = |(word, _): &(u32, f64)| decode_quaternion(*word).map(|v| f16::from_f64(v).to_f64()) == q;
    let first = encode_by(largest, unit);
    if (0..4).any(|k| tied(&k)) && !same(&first) {
        return (0..4).filter(tied).map(|k| encode_by(k, unit)).find(same).unwrap_or(first);
    }
    first
}

/// By the component that is left out.
fn encode_by(largest: usize, unit: [f64; 4]) -> (u32, f64) {
    let sign = if unit[largest] < 0.0 { -1.0 } else { 1.0 };
    let code = |v: f64| (sign * v * QUATERNION_STEPS + 512.0).round().clamp(1.0, 1023.0) as u32;
    let others = (0..4).filter(|&k| k != largest).enumerate();
    (others.fold((largest as u32) << 30, |word, (at, k)| word | code(unit[k]) << (10 * at)), sign)
}

pub fn decode_quaternion(word: u32) -> [f64; 4] {
    let mut others = (0..3).map(|at| (f64::from(word >> (10 * at) & 1023) - 512.0) / QUATERNION_STEPS);
    let largest = word as usize >> 30;
    let mut q: [f64; 4] = std::array::from_fn(|k| if k == largest { 0.0 } else { others.next().unwrap_or_default() });
    q[largest] = (1.0 - q.iter().map(|v| v * v).sum::<f64>()).max(0.0).sqrt();
    q
}

/// A Gaussian's nodes, those that count most first, and the shares that say how much: the first's of what is above a third, and the
/// second's of what is above half of the rest, in [`NODE_STEPS`].
pub fn node_shares(avatar: &Avatar, gaussian: usize) -> ([u16; 3], [u32; 2]) {
    let (order, shares) = coded_weights(avatar, gaussian);
    (order.map(|k| avatar.gaussians.node[gaussian][k]), shares)
}

/// The weights that those shares stand for, in the order of [`Avatar::node_weights`].
pub fn stored_node_weights(avatar: &Avatar, gaussian: usize) -> [f64; 3] {
    let (order, [first, second]) = coded_weights(avatar, gaussian);
    let first = (1.0 + 2.0 * f64::from(first) / NODE_STEPS) / 3.0;
    let second = (1.0 - first) * (0.5 + 0.5 * f64::from(second) / NODE_STEPS);
    let mut weights = [0.0; 3];
    order.into_iter().zip([first, second, 1.0 - first - second]).for_each(|(k, weight)| weights[k] = weight);
    weights
}

/// Which node counts most, which next and which least, and the shares.
fn coded_weights(avatar: &Avatar, gaussian: usize) -> ([usize; 3], [u32; 2]) {
    let weights = avatar.node_weights(gaussian);
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| weights[b].total_cmp(&weights[a]));
    let [a, b, c] = order.map(|k| weights[k]);
    let code = |share: f64| (share * NODE_STEPS).round().clamp(0.0, NODE_STEPS) as u32;
    let second = if b + c > 0.0 { 2.0 * b / (b + c) - 1.0 } else { 0.0 };
    (order, [code((3.0 * a - 1.0) / 2.0), code(second)])
}

/// What one step of a row's bytes is worth: a number of four significant bits, so that f16 holds each of its multiples by up to 127.
pub fn row_scale(values: impl Iterator<Item = f64>) -> f64 {
    /// The largest of which 127 fit f16.
    const MOST: f64 = 512.0;
    let least = values.fold(0.0, |most: f64, v| most.max(v.abs())) / 127.0;
    if least <= 0.0 {
        return 0.0;
    }
    let step = (least.log2().floor() - 3.0).max(-24.0).exp2();
    ((least / step).ceil() * step).min(MOST)
}

impl Avatar {
    /// The avatar that the GPU draws in this one's place, but for the weights of its nodes.
    pub fn compact(&self) -> Self {
        let mut compact = self.clone();
        let scales = LogScales::of(self);
        let g = &mut compact.gaussians;
        let turned: Vec<(u32, f64)> = g.rotation.iter().map(|q| encode_quaternion(q.map(f64::from))).collect();
        g.rotation.iter_mut().zip(&turned).for_each(|(q, (word, _))| *q = decode_quaternion(*word).map(f16::from_f64));
        g.log_scale.iter_mut().flatten().for_each(|s| *s = f16::from_f64(scales.decode(scales.encode(s.to_f64()))));
        let kept = |gaussian: usize| self.color_rows.gaussian.binary_search(&(gaussian as u32)).is_ok();
        if self.harmonics.is_none() {
            let plain = g.color.iter_mut().enumerate().filter(|(gaussian, _)| !kept(*gaussian));
            plain.flat_map(|(_, color)| color).for_each(|c| *c = f16::from_f64((c.to_f64().clamp(0.0, 1.0) * 255.0).round() / 255.0));
        }
        compact.rotation_rows = rounded(&self.rotation_rows, rotation_rows(self));
        compact.scale_rows = rounded(&self.scale_rows, rows(&self.scale_rows, self.basis_len()));
        compact.color_rows = rounded(&self.color_rows, rows(&self.color_rows, self.basis_len()));
        compact.nodes.basis = matrix_of(node_rows(self));
        compact
    }
}

/// A row of a corrective in bytes.
pub struct Row {
    /// Its Gaussian or node.
    pub of: u32,
    /// What one step is worth, exact in f16.
    pub scale: f64,
    /// Shape C, N_B.
    pub codes: Vec<i8>,
}

impl Row {
    /// A row divided by a number. What has steps already keeps them, and its codes.
    fn of(of: u32, row: Numbers, divisor: f64) -> Self {
        if let Numbers::Bytes { codes, step } = row {
            let codes = codes.iter().map(|code| if divisor < 0.0 { -code } else { *code });
            let scale = (step.to_f64() / divisor.abs()).min(matrix::STEP_MAX);
            return Self { of, scale: f16::from_f64(scale).to_f64(), codes: codes.collect() };
        }
        // Shrunk as a whole, a row that f16 can't hold keeps its direction.
        let largest = row.iter().fold(0.0, |most: f64, v| most.max((v / divisor).abs()));
        let divisor = divisor * (largest / f16::MAX.to_f64()).max(1.0);
        let scale = row_scale(row.iter().map(|v| v / divisor));
        Self { of, scale, codes: row.iter().map(|v| matrix::code(v / divisor, scale)).collect() }
    }
}

/// The rows of log scales and of colours.
pub fn rows<const C: usize>(rows: &Rows<C>, basis: usize) -> impl Iterator<Item = Row> {
    divided(rows, basis, |_| 1.0)
}

/// A row for each node.
pub fn node_rows(avatar: &Avatar) -> impl Iterator<Item = Row> {
    avatar.nodes.basis.rows(3 * avatar.basis_len()).enumerate().map(|(node, row)| Row::of(node as u32, row, 1.0))
}

/// The rows of quaternions, divided by what [`encode_quaternion`] divides the quaternion by, which changes nothing after normalisation. A
/// corrective of one of nearly no length may become more than f16 holds.
pub fn rotation_rows(avatar: &Avatar) -> impl Iterator<Item = Row> {
    divided(&avatar.rotation_rows, avatar.basis_len(), |gaussian| {
        let q = avatar.gaussians.rotation[gaussian as usize].map(f64::from);
        let length = q.iter().map(|v| v * v).sum::<f64>().sqrt();
        // As far from 1 as f16 makes what is 1.
        let unit = length == 0.0 || (length - 1.0).abs() < 1e-3 && avatar.rotation_rows.basis.is_bytes();
        encode_quaternion(q).1 * if unit { 1.0 } else { length }
    })
}

fn divided<const C: usize>(rows: &Rows<C>, basis: usize, divisor: impl Fn(u32) -> f64) -> impl Iterator<Item = Row> {
    rows.gaussian.iter().zip(rows.basis.rows(C * basis)).map(move |(&gaussian, row)| Row::of(gaussian, row, divisor(gaussian)))
}

fn rounded<const C: usize>(from: &Rows<C>, rows: impl Iterator<Item = Row>) -> Rows<C> {
    Rows { gaussian: from.gaussian.clone(), basis: matrix_of(rows) }
}

/// The rows as a matrix.
pub fn matrix_of(rows: impl Iterator<Item = Row>) -> Matrix {
    let (mut codes, mut steps) = (vec![], vec![]);
    for row in rows {
        codes.extend(row.codes);
        steps.push(f16::from_f64(row.scale));
    }
    Matrix::Bytes { codes, steps }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{bake::math::Random, demo};

    #[test]
    fn quaternions_keep_their_direction_to_a_thousandth() {
        let random = &mut Random::new(1, 0);
        for _ in 0..10_000 {
            let q: [f64; 4] = std::array::from_fn(|_| random.normal());
            let length = q.iter().map(|v| v * v).sum::<f64>().sqrt();
            let (word, sign) = encode_quaternion(q);
            let back = decode_quaternion(word);
            assert!((back.iter().map(|v| v * v).sum::<f64>() - 1.0).abs() < 1e-12);
            let off = q.iter().zip(back).map(|(a, b)| (sign * a / length - b).powi(2)).sum::<f64>().sqrt();
            assert!(off < 2e-3, "{q:?} comes back as {back:?}");
        }
        for axis in 0..4 {
            let q: [f64; 4] = std::array::from_fn(|k| if k == axis { -1.0 } else { 0.0 });
            assert_eq!(decode_quaternion(encode_quaternion(q).0).map(f64::abs), q.map(f64::abs));
        }
    }

    #[test]
    fn log_scales_that_were_rounded_once_keep_their_codes() {
        let mut avatar = demo::avatar().unwrap();
        // On a code, and halfway between two.
        for low in [-8.0, -7.99609375] {
            avatar.gaussians.log_scale[0] = [f16::from_f64(low); 3];
            assert_eq!(LogScales::of(&avatar.compact()), LogScales::of(&avatar), "the smallest is {low}");
        }
    }

    #[test]
    fn rounding_is_as_small_as_said_and_f16_holds_it() {
        let avatar = demo::avatar().unwrap();
        let compact = avatar.compact();
        for (a, b) in avatar.gaussians.log_scale.iter().flatten().zip(compact.gaussians.log_scale.iter().flatten()) {
            assert!((a.to_f64() - b.to_f64()).abs() <= 1.0 / 256.0 + 1e-9, "{a} became {b}");
        }
        for (a, b) in avatar.gaussians.color.iter().flatten().zip(compact.gaussians.color.iter().flatten()) {
            assert!((a.to_f64().clamp(0.0, 1.0) - b.to_f64()).abs() <= 0.5 / 255.0 + 2.5e-4, "{a} became {b}");
        }
        let length = 3 * avatar.basis_len();
        for (a, b) in avatar.scale_rows.basis.rows(length).zip(compact.scale_rows.basis.rows(length)) {
            let most = a.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
            assert!(a.iter().zip(b.iter()).all(|(a, b)| (a - b).abs() <= most / 220.0), "{a:?} became {b:?}");
        }
        let again = compact.compact();
        assert_eq!([again.scale_rows, again.color_rows], [compact.scale_rows, compact.color_rows]);
        assert_eq!(again.nodes, compact.nodes);
        assert_eq!(again.rotation_rows.gaussian, compact.rotation_rows.gaussian);
        assert_eq!(again.gaussians.log_scale, compact.gaussians.log_scale);
        assert_eq!(again.gaussians.color, compact.gaussians.color);
    }

    #[test]
    fn weights_of_nodes_are_as_near_as_said() {
        let avatar = demo::avatar().unwrap();
        for gaussian in 0..avatar.gaussians.len() {
            for (coded, exact) in stored_node_weights(&avatar, gaussian).into_iter().zip(avatar.node_weights(gaussian)) {
                assert!((coded - exact).abs() < 0.0165, "Gaussian {gaussian}: {exact} became {coded}");
            }
        }
    }

    #[test]
    fn the_smallest_and_the_largest_numbers_survive() {
        for value in [6e-8, 1e-6, 3.7e-3, 1.0, 77.0, 65504.0] {
            let scale = row_scale([value, -value / 3.0].into_iter());
            for k in -127..=127 {
                let exact = f64::from(k) * scale;
                assert_eq!(f16::from_f64(exact).to_f64(), exact, "{k} steps of {scale}");
            }
            let back = scale * f64::from(matrix::code(value, scale));
            // Or half of the smallest step that there is.
            assert!((back - value).abs() <= (0.01 * value).max(0.5 * 2f64.powi(-24)), "{value} became {back}");
        }
        assert_eq!((row_scale([0.0].into_iter()), matrix::code(0.0, 0.0)), (0.0, 0));
        let mut avatar = demo::avatar().unwrap();
        avatar.gaussians.log_scale[0] = [f16::MIN, f16::MAX, f16::from_f64(-5.0)];
        let scales = LogScales::of(&avatar);
        assert_eq!(scales, LogScales { min: -16.0, step: 1.0 / 32.0 });
        assert_eq!([-16.0, 9.0, -5.0].map(|s| scales.decode(scales.encode(s))), [-16.0, 9.0, -5.0]);
    }
}
