//! Encoding of an avatar's numbers in the GPU's model: a Gaussian takes 32 bytes, and a corrective
//! of an attribute or a node a byte a number.
//!
//! Maximum rounding: quaternions (30 bits: 0.0007 a component), log scales
//! (10 bits over the avatar's own range, 1/256 for up to 8 octaves and a half), colours (8 bits,
//! not rounded where a corrective is added), correctives (8 bits of the largest in their row), and
//! the weights of nodes ([`NodeBits`]: 0.002 with up to 16,384 nodes, 0.016 with 65,536). Networks,
//! positions, joints, opacities and the nodes' offsets are not rounded.

use crate::{
    avatar::{
        Avatar, Gaussians, Matrix, Rows,
        matrix::{self, Row},
    },
    constants::LOG_SCALE_MAX,
    each,
};
use half::f16;

/// Steps in 1 of a quaternion's three smaller components. None of them exceeds √½: 509 of the 511
/// steps that fit.
pub const QUATERNION_STEPS: f64 = 720.0;
/// Bits of a node's index, at least. Fewer would give its shares more bits than they have use for.
pub const NODE_BITS_MIN: u32 = 12;
/// The smallest log scale, a tenth of a micrometre; smaller ones are clamped to it.
const LOG_SCALE_MIN: f64 = -16.0;
/// Largest code of a log scale.
const LOG_SCALE_CODES: f64 = 1023.0;

/// Encoding of log scales as 10-bit codes: `min + step · code`. Every code's value is exact in f16.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LogScales {
    /// Value of code 0.
    pub min: f64,
    /// Difference between neighbouring codes.
    pub step: f64,
}

impl LogScales {
    /// The finest encoding that covers all log scales of an avatar.
    pub fn from_avatar(avatar: &Avatar) -> Self {
        Self::from_gaussians(&avatar.gaussians)
    }

    /// The finest encoding that covers all log scales of some Gaussians.
    pub fn from_gaussians(gaussians: &Gaussians) -> Self {
        let mut low = f64::INFINITY;
        let mut high = f64::NEG_INFINITY;
        for log_scale in gaussians.log_scale.iter().flatten() {
            let log_scale = clamp(log_scale.to_f64());
            low = low.min(log_scale);
            high = high.max(log_scale);
        }
        if low > high {
            low = 0.0;
            high = 0.0;
        }
        // Ties round up, so that a smallest value that was encoded before gets code 0 again.
        let first = |step: f64| (low / step + 0.5).floor() * step;
        let mut step = 1.0 / 128.0;
        while (high - first(step)) / step > LOG_SCALE_CODES {
            step *= 2.0;
        }
        Self {
            min: first(step),
            step,
        }
    }

    /// The nearest code.
    pub fn encode(self, log_scale: f64) -> u32 {
        ((clamp(log_scale) - self.min) / self.step)
            .round()
            .clamp(0.0, LOG_SCALE_CODES) as u32
    }

    /// The log scale of a code.
    pub fn decode(self, code: u32) -> f64 {
        self.min + self.step * f64::from(code)
    }
}

/// Clamps to the range that is drawn; NaN becomes the smallest.
fn clamp(log_scale: f64) -> f64 {
    if log_scale.is_nan() {
        LOG_SCALE_MIN
    } else {
        log_scale.clamp(LOG_SCALE_MIN, LOG_SCALE_MAX)
    }
}

/// Encodes a quaternion in 32 bits: the index of its largest component in the highest 2, the others
/// in [`QUATERNION_STEPS`], 10 bits each. Decoding gives a unit quaternion whose largest component
/// is positive. The second result is the sign that makes it so.
pub fn encode_quaternion(q: [f64; 4]) -> (u32, f64) {
    let length = q.iter().map(|v| v * v).sum::<f64>().sqrt();
    let unit = if length > 0.0 {
        q.map(|v| v / length)
    } else {
        [1.0, 0.0, 0.0, 0.0]
    };
    let largest = (0..4)
        .max_by(|&a, &b| unit[a].abs().total_cmp(&unit[b].abs()))
        .unwrap_or(0);
    let by_largest = encode_by(largest, unit);
    if decodes_to(by_largest.0, q) {
        return by_largest;
    }
    // Rounding to f16 may have made several components equally large. Choose the one by which the
    // stored f16 decode exactly.
    for k in (0..4).filter(|&k| k != largest) {
        let is_as_large = unit[k].abs() > unit[largest].abs() - 3e-3;
        if is_as_large {
            let encoded = encode_by(k, unit);
            if decodes_to(encoded.0, q) {
                return encoded;
            }
        }
    }
    by_largest
}

/// Whether a word gives this quaternion once its components are rounded to f16.
fn decodes_to(word: u32, q: [f64; 4]) -> bool {
    decode_quaternion(word).map(|v| f16::from_f64(v).to_f64()) == q
}

/// Encodes a unit quaternion by the index of the component to leave out.
fn encode_by(largest: usize, unit: [f64; 4]) -> (u32, f64) {
    let sign = if unit[largest] < 0.0 { -1.0 } else { 1.0 };
    let code = |v: f64| {
        (sign * v * QUATERNION_STEPS + 512.0)
            .round()
            .clamp(1.0, 1023.0) as u32
    };
    let mut word = (largest as u32) << 30;
    for (at, k) in (0..4).filter(|&k| k != largest).enumerate() {
        word |= code(unit[k]) << (10 * at);
    }
    (word, sign)
}

/// The unit quaternion, w x y z, of a word of [`encode_quaternion`].
pub fn decode_quaternion(word: u32) -> [f64; 4] {
    let mut others =
        (0..3).map(|at| (f64::from(word >> (10 * at) & 1023) - 512.0) / QUATERNION_STEPS);
    let largest = word as usize >> 30;
    let mut q: [f64; 4] = std::array::from_fn(|k| {
        if k == largest {
            0.0
        } else {
            others.next().unwrap_or_default()
        }
    });
    q[largest] = (1.0 - q.iter().map(|v| v * v).sum::<f64>()).max(0.0).sqrt();
    q
}

/// How the 58 bits are shared out that the GPU's model has for a Gaussian's three nodes and their
/// weights. Neighbouring Gaussians lie so close in depth that rounded weights move one past
/// another, so what indices leave free is for the weights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NodeBits {
    /// Of a node's index: as many as the avatar's nodes need, [`NODE_BITS_MIN`] to 16.
    pub index: u32,
    /// Of the two shares of [`node_shares`].
    pub shares: [u32; 2],
}

impl NodeBits {
    /// For an avatar with so many nodes, up to 65,536.
    pub fn new(nodes: usize) -> Self {
        let index = ((nodes.max(1 << NODE_BITS_MIN) - 1).ilog2() + 1).min(16);
        let spare = 16 - index;
        Self {
            index,
            shares: [5 + 2 * spare, 5 + spare],
        }
    }

    /// The largest code of each share, which stands for 1.
    pub fn steps(self) -> [f64; 2] {
        self.shares.map(|bits| f64::from((1_u32 << bits) - 1))
    }

    /// What a weight is rounded by at most: half a step of each share, times how much of the
    /// weights it shares out, two thirds of 1 and half of that.
    pub fn rounding(self) -> f64 {
        let [first, second] = self.steps();
        1.0 / 3.0 / first + 1.0 / 6.0 / second
    }

    /// Two words, of which the highest 6 bits are left free: the first two nodes and the first
    /// share's bits above the lowest 5, then the third node, these 5, and the second share.
    pub fn pack(self, nodes: [u16; 3], [first, second]: [u32; 2]) -> [u32; 2] {
        let [a, b, c] = nodes.map(u64::from);
        let high = u64::from(first >> 5);
        let low = first & 31;
        [
            // In 64 bits, since nothing may be shifted by 32.
            (a | b << self.index | high << (2 * self.index)) as u32,
            c as u32 | low << self.index | second << (self.index + 5),
        ]
    }
}

/// A Gaussian's nodes by falling weight, and two shares that encode the weights, in
/// [`NodeBits::steps`]: the first weight between a third and 1, and the second between half and all
/// of the rest.
pub fn node_shares(avatar: &Avatar, gaussian: usize) -> ([u16; 3], [u32; 2]) {
    let (order, shares) = coded_weights(avatar, gaussian);
    (order.map(|k| avatar.gaussians.node[gaussian][k]), shares)
}

/// The weights that [`node_shares`] encodes, in the order of [`Avatar::node_weights`].
pub fn stored_node_weights(avatar: &Avatar, gaussian: usize) -> [f64; 3] {
    let (order, [first, second]) = coded_weights(avatar, gaussian);
    let steps = NodeBits::new(avatar.nodes.len()).steps();
    let first = (1.0 + 2.0 * f64::from(first) / steps[0]) / 3.0;
    let second = (1.0 - first) * (0.5 + 0.5 * f64::from(second) / steps[1]);
    let mut weights = [0.0; 3];
    weights[order[0]] = first;
    weights[order[1]] = second;
    weights[order[2]] = 1.0 - first - second;
    weights
}

/// Neutral attributes of a Gaussian that an [`Avatar`] can't hold with the GPU's rounding, since
/// its own are f16 or computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NeutralGaussian {
    /// Weights of its three nodes.
    pub node_weights: [f64; 3],
    /// q₀, w x y z.
    pub rotation: [f64; 4],
    /// c₀.
    pub color: [f64; 3],
}

impl NeutralGaussian {
    /// The numbers of the avatar itself.
    pub fn exact(avatar: &Avatar, gaussian: usize) -> Self {
        Self {
            node_weights: avatar.node_weights(gaussian),
            rotation: avatar.gaussians.rotation[gaussian].map(f64::from),
            color: avatar.gaussians.color[gaussian].map(f64::from),
        }
    }

    /// The avatar's numbers, rounded to what the GPU's model stores.
    pub fn stored(avatar: &Avatar, gaussian: usize) -> Self {
        let exact = Self::exact(avatar, gaussian);
        let (word, _) = encode_quaternion(exact.rotation);
        Self {
            node_weights: stored_node_weights(avatar, gaussian),
            rotation: decode_quaternion(word),
            color: if has_color_code(avatar, gaussian) {
                exact.color.map(color_code)
            } else {
                exact.color
            },
        }
    }
}

/// Whether a Gaussian's colour is stored in bytes: one with a corrective stays f16, and spherical
/// harmonics are added to one that is not rounded.
fn has_color_code(avatar: &Avatar, gaussian: usize) -> bool {
    let rows = &avatar.color_rows.gaussian;
    avatar.sh.is_none() && rows.binary_search(&(gaussian as u32)).is_err()
}

/// A channel rounded to a byte.
fn color_code(channel: f64) -> f64 {
    (channel.clamp(0.0, 1.0) * 255.0).round() / 255.0
}

/// Indices of a Gaussian's nodes by falling weight, and the shares.
fn coded_weights(avatar: &Avatar, gaussian: usize) -> ([usize; 3], [u32; 2]) {
    let weights = avatar.node_weights(gaussian);
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| weights[b].total_cmp(&weights[a]));
    let [a, b, c] = order.map(|k| weights[k]);
    let steps = NodeBits::new(avatar.nodes.len()).steps();
    let code = |share: f64, steps: f64| (share * steps).round().clamp(0.0, steps) as u32;
    let second = if b + c > 0.0 {
        2.0 * b / (b + c) - 1.0
    } else {
        0.0
    };
    let codes = [
        code((3.0 * a - 1.0) / 2.0, steps[0]),
        code(second, steps[1]),
    ];
    (order, codes)
}

/// The step of a row's bytes: a number of four significant bits, whose multiples by up to 127 are
/// exact in f16.
pub fn row_scale(values: impl Iterator<Item = f64>) -> f64 {
    let exact = values.fold(0.0, |max: f64, v| max.max(v.abs())) / f64::from(matrix::CODE_MAX);
    if exact <= 0.0 {
        return 0.0;
    }
    let unit = (exact.log2().floor() - 3.0).max(-24.0).exp2();
    ((exact / unit).ceil() * unit).min(matrix::STEP_MAX)
}

impl Avatar {
    /// This avatar with the rounding of the GPU's model, except what [`NeutralGaussian::stored`]
    /// gives: here f16 rounds it once more.
    pub fn compact(&self) -> Self {
        let mut compact = self.clone().balanced();
        let scales = LogScales::from_avatar(self);
        let g = &mut compact.gaussians;
        for q in &mut g.rotation {
            let (word, _) = encode_quaternion(q.map(f64::from));
            *q = decode_quaternion(word).map(f16::from_f64);
        }
        for s in g.log_scale.iter_mut().flatten() {
            *s = f16::from_f64(scales.decode(scales.encode(s.to_f64())));
        }
        for (gaussian, color) in g.color.iter_mut().enumerate() {
            if has_color_code(self, gaussian) {
                *color = color.map(|c| f16::from_f64(color_code(c.to_f64())));
            }
        }
        compact.rotation_rows = rounded(&self.rotation_rows, rotation_rows(self));
        compact.scale_rows = rounded(&self.scale_rows, rows(&self.scale_rows, self.basis_len()));
        compact.color_rows = rounded(&self.color_rows, rows(&self.color_rows, self.basis_len()));
        let length = 3 * self.basis_len();
        compact.nodes.basis = matrix_of(node_rows(&compact.nodes.basis, length));
        compact
    }
}

/// A corrective's basis row in bytes.
pub struct CodedRow {
    /// Index of the Gaussian or node that it belongs to.
    pub target: u32,
    /// Value of one step, exact in f16.
    pub scale: f64,
    /// Shape C, N_B.
    pub codes: Vec<i8>,
}

impl CodedRow {
    /// Encodes a row divided by a number. A row of bytes keeps its codes.
    fn new(target: u32, row: Row, divisor: f64) -> Self {
        if let Row::Bytes { codes, step } = row {
            let codes = codes
                .iter()
                .map(|code| if divisor < 0.0 { -code } else { *code });
            let scale = (step.to_f64() / divisor.abs()).min(matrix::STEP_MAX);
            return Self {
                target,
                scale: f16::from_f64(scale).to_f64(),
                codes: codes.collect(),
            };
        }
        let mut values: Vec<f64> = row.iter().map(|v| v / divisor).collect();
        let largest = values.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
        // A row that exceeds f16 is scaled down as a whole, which keeps its direction.
        let excess = largest / f16::MAX.to_f64();
        if excess > 1.0 {
            values = row.iter().map(|v| v / (divisor * excess)).collect();
        }
        let scale = row_scale(values.iter().copied());
        Self {
            target,
            scale,
            codes: values.iter().map(|&v| matrix::code(v, scale)).collect(),
        }
    }
}

/// Encodes the rows of log scales or of colours. `basis`: N_B.
pub fn rows<const C: usize>(rows: &Rows<C>, basis: usize) -> Vec<CodedRow> {
    divided(rows, basis, |_| 1.0)
}

/// Encodes the rows of all nodes, of so many numbers each: 3 N_B.
pub fn node_rows(bases: &Matrix, length: usize) -> Vec<CodedRow> {
    each::map(bases.rows(length).len(), |node| {
        CodedRow::new(node as u32, bases.row(node, length), 1.0)
    })
}

/// Encodes the rows of quaternions, divided by what [`encode_quaternion`] divides the quaternion
/// by; normalisation cancels that. The corrective of a very short quaternion may exceed f16.
pub fn rotation_rows(avatar: &Avatar) -> Vec<CodedRow> {
    divided(&avatar.rotation_rows, avatar.basis_len(), |gaussian| {
        let q = avatar.gaussians.rotation[gaussian as usize].map(f64::from);
        let length = q.iter().map(|v| v * v).sum::<f64>().sqrt();
        // Rounding to f16 moves a unit quaternion's length by this much.
        let unit =
            length == 0.0 || (length - 1.0).abs() < 1e-3 && avatar.rotation_rows.basis.is_bytes();
        encode_quaternion(q).1 * if unit { 1.0 } else { length }
    })
}

fn divided<const C: usize>(
    rows: &Rows<C>,
    basis: usize,
    divisor: impl Fn(u32) -> f64 + Sync + Send,
) -> Vec<CodedRow> {
    let length = C * basis;
    let count = rows.gaussian.len().min(rows.basis.rows(length).len());
    each::map(count, |at| {
        let gaussian = rows.gaussian[at];
        CodedRow::new(gaussian, rows.basis.row(at, length), divisor(gaussian))
    })
}

fn rounded<const C: usize>(from: &Rows<C>, rows: Vec<CodedRow>) -> Rows<C> {
    Rows {
        gaussian: from.gaussian.clone(),
        basis: matrix_of(rows),
    }
}

/// Collects encoded rows into a matrix.
pub fn matrix_of(rows: Vec<CodedRow>) -> Matrix {
    let mut codes = vec![];
    let mut steps = vec![];
    for row in rows {
        codes.extend(row.codes);
        steps.push(f16::from_f64(row.scale));
    }
    Matrix::Bytes { codes, steps }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::constants::F16_MAX;
    use crate::random::Random;

    #[test]
    fn quaternions_keep_their_direction_to_a_thousandth() {
        let random = &mut Random::new(1, 0);
        for _ in 0..10_000 {
            let q: [f64; 4] = std::array::from_fn(|_| random.normal());
            let length = q.iter().map(|v| v * v).sum::<f64>().sqrt();
            let (word, sign) = encode_quaternion(q);
            let back = decode_quaternion(word);
            assert!((back.iter().map(|v| v * v).sum::<f64>() - 1.0).abs() < 1e-12);
            let off = q
                .iter()
                .zip(back)
                .map(|(a, b)| (sign * a / length - b).powi(2))
                .sum::<f64>()
                .sqrt();
            assert!(off < 2e-3, "{q:?} comes back as {back:?}");
        }
        for axis in 0..4 {
            let q: [f64; 4] = std::array::from_fn(|k| if k == axis { -1.0 } else { 0.0 });
            assert_eq!(
                decode_quaternion(encode_quaternion(q).0).map(f64::abs),
                q.map(f64::abs)
            );
        }
    }

    #[test]
    fn log_scales_that_were_rounded_once_keep_their_codes() {
        let mut avatar = crate::demo::avatar().unwrap();
        // On a code, and halfway between two.
        for low in [-8.0, -7.99609375] {
            avatar.gaussians.log_scale[0] = [f16::from_f64(low); 3];
            assert_eq!(
                LogScales::from_avatar(&avatar.compact()),
                LogScales::from_avatar(&avatar),
                "the smallest is {low}"
            );
        }
    }

    #[test]
    fn rounding_is_within_its_bounds_and_idempotent() {
        let avatar = crate::demo::avatar().unwrap();
        let compact = avatar.compact();
        for (a, b) in avatar
            .gaussians
            .log_scale
            .iter()
            .flatten()
            .zip(compact.gaussians.log_scale.iter().flatten())
        {
            assert!(
                (a.to_f64() - b.to_f64()).abs() <= 1.0 / 256.0 + 1e-9,
                "{a} became {b}"
            );
        }
        for (a, b) in avatar
            .gaussians
            .color
            .iter()
            .flatten()
            .zip(compact.gaussians.color.iter().flatten())
        {
            assert!(
                (a.to_f64().clamp(0.0, 1.0) - b.to_f64()).abs() <= 0.5 / 255.0 + 2.5e-4,
                "{a} became {b}"
            );
        }
        let length = 3 * avatar.basis_len();
        for (a, b) in avatar
            .scale_rows
            .basis
            .rows(length)
            .zip(compact.scale_rows.basis.rows(length))
        {
            let max = a.iter().fold(0.0, |max: f64, v| max.max(v.abs()));
            assert!(
                a.iter()
                    .zip(b.iter())
                    .all(|(a, b)| (a - b).abs() <= max / 220.0),
                "{a:?} became {b:?}"
            );
        }
        let again = compact.compact();
        assert_eq!(
            [again.scale_rows, again.color_rows],
            [compact.scale_rows, compact.color_rows]
        );
        assert_eq!(again.nodes, compact.nodes);
        assert_eq!(again.rotation_rows.gaussian, compact.rotation_rows.gaussian);
        assert_eq!(again.gaussians.log_scale, compact.gaussians.log_scale);
        assert_eq!(again.gaussians.color, compact.gaussians.color);
    }

    #[test]
    fn node_weights_are_within_their_rounding() {
        let avatar = crate::demo::avatar().unwrap();
        let most = NodeBits::new(avatar.nodes.len()).rounding();
        for gaussian in 0..avatar.gaussians.len() {
            for (coded, exact) in stored_node_weights(&avatar, gaussian)
                .into_iter()
                .zip(avatar.node_weights(gaussian))
            {
                assert!(
                    (coded - exact).abs() < most,
                    "Gaussian {gaussian}: {exact} became {coded}"
                );
            }
        }
    }

    #[test]
    fn nodes_have_the_bits_they_need_and_shares_the_rest() {
        for (nodes, index, shares) in [
            (0, 12, [13, 9]),
            (4096, 12, [13, 9]),
            (4097, 13, [11, 8]),
            (10_000, 14, [9, 7]),
            (16_384, 14, [9, 7]),
            (16_385, 15, [7, 6]),
            (65_536, 16, [5, 5]),
        ] {
            let bits = NodeBits::new(nodes);
            assert_eq!(bits, NodeBits { index, shares }, "{nodes} nodes");
            let last = nodes.saturating_sub(1) as u16;
            let [first, second] = shares.map(|bits| (1 << bits) - 1);
            // Each alone, and all together: no bit is anyone else's, nor one of the log scale's.
            let all = bits.pack([last; 3], [first, second]);
            let alone = [
                bits.pack([last, 0, 0], [0, 0]),
                bits.pack([0, last, 0], [0, 0]),
                bits.pack([0, 0, last], [0, 0]),
                bits.pack([0; 3], [first, 0]),
                bits.pack([0; 3], [0, second]),
            ];
            for k in 0..2 {
                let sum: u64 = alone.iter().map(|words| u64::from(words[k])).sum();
                assert_eq!(sum, u64::from(all[k]), "{nodes} nodes");
            }
            assert_eq!(all[1] >> 26, 0, "{nodes} nodes");
        }
    }

    #[test]
    fn extreme_numbers_are_encoded_within_tolerance() {
        for value in [6e-8, 1e-6, 3.7e-3, 1.0, 77.0, F16_MAX] {
            let scale = row_scale([value, -value / 3.0].into_iter());
            for k in -127..=127 {
                let exact = f64::from(k) * scale;
                assert_eq!(f16::from_f64(exact).to_f64(), exact, "{k} steps of {scale}");
            }
            let back = scale * f64::from(matrix::code(value, scale));
            // Or half of the smallest step that there is.
            assert!(
                (back - value).abs() <= (0.01 * value).max(0.5 * 2f64.powi(-24)),
                "{value} became {back}"
            );
        }
        assert_eq!(
            (row_scale([0.0].into_iter()), matrix::code(0.0, 0.0)),
            (0.0, 0)
        );
        let mut avatar = crate::demo::avatar().unwrap();
        avatar.gaussians.log_scale[0] = [f16::MIN, f16::MAX, f16::from_f64(-5.0)];
        let scales = LogScales::from_avatar(&avatar);
        assert_eq!(
            scales,
            LogScales {
                min: -16.0,
                step: 1.0 / 32.0
            }
        );
        assert_eq!(
            [-16.0, 9.0, -5.0].map(|s| scales.decode(scales.encode(s))),
            [-16.0, 9.0, -5.0]
        );
    }
}
