//! Codes: numbers in fewer bits than version 1 of the format has. Files use them only where they
//! are exact; [`crate::io::pack`] rounds avatars so that they are.

use crate::avatar::{Avatar, Matrix};
use crate::layout::compact::{LogScales, decode_quaternion, encode_quaternion};
use bytemuck::Pod;
use half::f16;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// Arrays that a file of version 2 may store as codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Coded {
    /// Quaternions of length 1 in 32 bits. The two highest bits are the index of the largest
    /// component, which is positive. The others are in 720ths plus 512, ten bits each, in order
    /// from the lowest bits.
    Rotation,
    /// Colours in bytes, of 255; those of the Gaussians of `color.row` also in f16.
    Color,
    /// Three of a Gaussian's four joint weights in bytes; the four sum to 255.
    JointWeight,
    /// Rows of the rotations' basis in bytes, with a step a row.
    RotationBasis,
    /// Rows of the scales' basis in bytes, with a step a row.
    ScaleBasis,
    /// Rows of the colours' basis in bytes, with a step a row.
    ColorBasis,
    /// The nodes' basis in bytes, with a step a node.
    NodeBasis,
    /// All weights of networks in bytes, with a step a neuron.
    Networks,
}

/// Encoding of log scales as codes: `min + step · code`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LogScaleCodes {
    /// Log scale of code 0.
    pub min: f64,
    /// Difference between neighbouring codes.
    pub step: f64,
    /// Bits of a code: 8 or 16.
    pub bits: u32,
}

impl LogScaleCodes {
    /// Largest code of 16 bits: renderers use 10.
    pub const MAX_CODE: usize = 1023;
    /// Smallest and largest `min` and `step`.
    pub const RANGE: [[f64; 2]; 2] = [[-100.0, 100.0], [1.0 / 1024.0, 8.0]];

    /// The encoding that renderers use, and the finest one in bytes with the same code 0.
    pub fn candidates(avatar: &Avatar) -> [Self; 2] {
        let scales = LogScales::from_avatar(avatar);
        let max_code = avatar
            .gaussians
            .log_scale
            .iter()
            .flatten()
            .map(|s| scales.encode(s.to_f64()))
            .max()
            .unwrap_or_default();
        let mut step = scales.step;
        while f64::from(max_code) * scales.step > 255.0 * step {
            step *= 2.0;
        }
        [
            Self {
                min: scales.min,
                step: scales.step,
                bits: 16,
            },
            Self {
                min: scales.min,
                step,
                bits: 8,
            },
        ]
    }

    /// The nearest code.
    pub fn encode(&self, log_scale: f16) -> u16 {
        let max_code = if self.bits == 8 {
            255.0
        } else {
            Self::MAX_CODE as f64
        };
        ((log_scale.to_f64() - self.min) / self.step)
            .round()
            .clamp(0.0, max_code) as u16
    }

    /// The log scale of a code.
    pub fn decode(&self, code: u16) -> f16 {
        f16::from_f64(self.min + self.step * f64::from(code))
    }
}

/// Arrays as a tensor's bytes, borrowed from the model or new.
pub trait StoredBytes<'a> {
    fn stored_bytes(self) -> Cow<'a, [u8]>;
}

impl<'a, T: Pod> StoredBytes<'a> for &'a Vec<T> {
    fn stored_bytes(self) -> Cow<'a, [u8]> {
        Cow::Borrowed(bytemuck::cast_slice(self))
    }
}

impl<'a, T: Pod> StoredBytes<'a> for &'a [T] {
    fn stored_bytes(self) -> Cow<'a, [u8]> {
        Cow::Borrowed(bytemuck::cast_slice(self))
    }
}

impl<'a, T: Pod> StoredBytes<'a> for Vec<T> {
    fn stored_bytes(self) -> Cow<'a, [u8]> {
        Cow::Owned(bytemuck::cast_slice(&self).to_vec())
    }
}

/// The numbers of a matrix of f16; empty for a matrix of bytes.
pub fn halves(matrix: &Matrix) -> &[f16] {
    if let Matrix::Halves(numbers) = matrix {
        numbers
    } else {
        &[]
    }
}

/// The codes of a matrix of bytes; empty for a matrix of f16.
pub fn codes(matrix: &Matrix) -> &[i8] {
    if let Matrix::Bytes { codes, .. } = matrix {
        codes
    } else {
        &[]
    }
}

/// The steps of a matrix of bytes; empty for a matrix of f16.
pub fn steps(matrix: &Matrix) -> &[f16] {
    if let Matrix::Bytes { steps, .. } = matrix {
        steps
    } else {
        &[]
    }
}

/// Codes of all rotations.
pub fn rotations(avatar: &Avatar) -> Vec<u32> {
    avatar
        .gaussians
        .rotation
        .iter()
        .map(|&q| encode_quaternion(q.map(f64::from)).0)
        .collect()
}

/// The quaternion of a code.
pub fn rotation(word: u32) -> [f16; 4] {
    decode_quaternion(word).map(f16::from_f64)
}

/// Codes of all log scales; empty without an encoding. `T`: u8 or u16.
pub fn log_scales<T: Pod + TryFrom<u16>>(
    avatar: &Avatar,
    codes: Option<LogScaleCodes>,
) -> Vec<[T; 3]> {
    let Some(codes) = codes else {
        return vec![];
    };
    let code = |s: f16| T::try_from(codes.encode(s)).unwrap_or_else(|_| T::zeroed());
    let log_scales = avatar.gaussians.log_scale.iter();
    log_scales.map(|&s| s.map(code)).collect()
}

/// Codes of all colours.
pub fn colors(avatar: &Avatar) -> Vec<[u8; 3]> {
    avatar
        .gaussians
        .color
        .iter()
        .map(|c| c.map(color_code))
        .collect()
}

fn color_code(color: f16) -> u8 {
    (color.to_f64().clamp(0.0, 1.0) * 255.0).round() as u8
}

/// The colour component of a code.
pub fn color(code: u8) -> f16 {
    f16::from_f64(f64::from(code) / 255.0)
}

/// Colours of the Gaussians that have a basis row of colour, which codes would round.
pub fn row_colors(avatar: &Avatar) -> Vec<[f16; 3]> {
    avatar
        .color_rows
        .gaussian
        .iter()
        .filter_map(|&gaussian| avatar.gaussians.color.get(gaussian as usize))
        .copied()
        .collect()
}

/// Joint weights except each Gaussian's last.
pub fn joint_weights(avatar: &Avatar) -> Vec<[u8; 3]> {
    avatar
        .gaussians
        .joint_weight
        .iter()
        .map(|&[a, b, c, _]| [a, b, c])
        .collect()
}

/// The arrays of an avatar that codes represent exactly, and the shortest exact encoding of log
/// scales. Bases and networks are included where they are bytes.
pub fn exact_codes(avatar: &Avatar) -> (Vec<Coded>, Option<LogScaleCodes>) {
    let g = &avatar.gaussians;
    let has_row = |gaussian: usize| {
        avatar
            .color_rows
            .gaussian
            .binary_search(&(gaussian as u32))
            .is_ok()
    };
    let color_is_exact =
        |(at, c): (usize, &[f16; 3])| has_row(at) || c.iter().all(|&c| color(color_code(c)) == c);
    let scale_is_exact = |codes: &LogScaleCodes| {
        g.log_scale
            .iter()
            .flatten()
            .all(|&s| codes.decode(codes.encode(s)) == s)
    };
    let neutral = [
        (
            Coded::Rotation,
            g.rotation
                .iter()
                .all(|&q| rotation(encode_quaternion(q.map(f64::from)).0) == q),
        ),
        (Coded::Color, g.color.iter().enumerate().all(color_is_exact)),
        (
            Coded::JointWeight,
            g.joint_weight
                .iter()
                .all(|w| w.iter().map(|&w| u32::from(w)).sum::<u32>() == 255),
        ),
    ];
    let coded = neutral
        .into_iter()
        .filter_map(|(what, exact)| exact.then_some(what))
        .chain(matrices(avatar))
        .collect();
    (
        coded,
        LogScaleCodes::candidates(avatar)
            .into_iter()
            .rev()
            .find(scale_is_exact),
    )
}

/// The bases and networks that are bytes.
pub fn matrices(avatar: &Avatar) -> impl Iterator<Item = Coded> {
    let all = [
        (Coded::RotationBasis, avatar.rotation_rows.basis.is_bytes()),
        (Coded::ScaleBasis, avatar.scale_rows.basis.is_bytes()),
        (Coded::ColorBasis, avatar.color_rows.basis.is_bytes()),
        (Coded::NodeBasis, avatar.nodes.basis.is_bytes()),
        (Coded::Networks, avatar.networks.in_bytes()),
    ];
    all.into_iter()
        .filter_map(|(what, bytes)| bytes.then_some(what))
}
