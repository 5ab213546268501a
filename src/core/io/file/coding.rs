//! Codes: numbers in fewer bits than version 1 of the format has. Files use them only where they
//! are exact; [`crate::io::pack`] rounds avatars so that they are.

use super::sets::SetArrays;
use crate::avatar::{Avatar, Gaussians, Matrix, ShCoefficients, harmonics::functions_of, limits};
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
    pub fn candidates(gaussians: &Gaussians) -> [Self; 2] {
        let scales = LogScales::from_gaussians(gaussians);
        let max_code = gaussians
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

/// Encoding of spherical harmonics as codes: a coefficient is a multiple n of `step`, and its code
/// 2 n, or −2 n − 1 where n is below 0. Small coefficients then have small codes, and 0 is 0.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct HarmonicCodes {
    /// Difference between neighbouring coefficients.
    pub step: f64,
}

impl HarmonicCodes {
    /// The finest that a file may have. Coefficients are off by half of it at most, about what
    /// colours in bytes are.
    pub const FINE: Self = Self { step: 1.0 / 256.0 };
    /// For small files.
    pub const COARSE: Self = Self { step: 1.0 / 64.0 };
    /// Smallest and largest `step`.
    pub const RANGE: [f64; 2] = [1.0 / 256.0, 1.0];

    /// The nearest code; None where the coefficient is beyond the largest.
    pub fn encode(&self, coefficient: f16) -> Option<u16> {
        let multiple = (coefficient.to_f64() / self.step).round();
        let code = if multiple < 0.0 {
            -2.0 * multiple - 1.0
        } else {
            2.0 * multiple
        };
        (code <= f64::from(u16::MAX)).then_some(code as u16)
    }

    /// The coefficient of a code.
    pub fn decode(&self, code: u16) -> f16 {
        let half = f64::from(code >> 1);
        let multiple = if code & 1 == 1 { -half - 1.0 } else { half };
        f16::from_f64(multiple * self.step)
    }

    /// The nearest coefficient that has a code; the same where it is beyond the largest.
    pub fn round(&self, coefficient: f16) -> f16 {
        self.encode(coefficient)
            .map_or(coefficient, |code| self.decode(code))
    }

    fn is_exact(&self, coefficients: &[[f16; 3]]) -> bool {
        let exact = |c: &f16| self.encode(*c).is_some_and(|code| self.decode(code) == *c);
        coefficients.iter().flatten().all(exact)
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
pub fn rotations(gaussians: &Gaussians) -> Vec<u32> {
    gaussians
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
    gaussians: &Gaussians,
    codes: Option<LogScaleCodes>,
) -> Vec<[T; 3]> {
    let Some(codes) = codes else {
        return vec![];
    };
    let code = |s: f16| T::try_from(codes.encode(s)).unwrap_or_else(|_| T::zeroed());
    let log_scales = gaussians.log_scale.iter();
    log_scales.map(|&s| s.map(code)).collect()
}

/// Codes of all colours.
pub fn colors(gaussians: &Gaussians) -> Vec<[u8; 3]> {
    let colors = gaussians.color.iter();
    colors.map(|c| c.map(color_code)).collect()
}

fn color_code(color: f16) -> u8 {
    (color.to_f64().clamp(0.0, 1.0) * 255.0).round() as u8
}

/// The colour component of a code.
pub fn color(code: u8) -> f16 {
    f16::from_f64(f64::from(code) / 255.0)
}

/// Codes of all colours of an avatar with spherical harmonics; empty without an encoding.
pub fn constant_harmonics(gaussians: &Gaussians, codes: Option<HarmonicCodes>) -> Vec<[u16; 3]> {
    let Some(codes) = codes else {
        return vec![];
    };
    let code = |c: f16| codes.encode(c).unwrap_or(u16::MAX);
    gaussians.color.iter().map(|c| c.map(code)).collect()
}

/// Coefficients of the spherical harmonics, one function after the other: shape functions, 3, N_g.
/// Empty where there are none, or of a degree that no file may have.
pub fn harmonics(sh: Option<&ShCoefficients>) -> Vec<f16> {
    let Some(sh) = sh else {
        return vec![];
    };
    if !(1..=limits::HARMONICS).contains(&sh.degree) {
        return vec![];
    }
    let functions = sh.functions();
    let mut planes = Vec::with_capacity(3 * sh.coefficients.len());
    for function in 0..functions {
        for channel in 0..3 {
            let rows = sh.coefficients.chunks_exact(functions);
            planes.extend(rows.map(|row| row[function][channel]));
        }
    }
    planes
}

/// Codes of [`harmonics`]; empty without an encoding.
pub fn harmonic_codes(sh: Option<&ShCoefficients>, codes: Option<HarmonicCodes>) -> Vec<u16> {
    let Some(codes) = codes else {
        return vec![];
    };
    let code = |c: f16| codes.encode(c).unwrap_or(u16::MAX);
    harmonics(sh).into_iter().map(code).collect()
}

/// The spherical harmonics whose coefficients [`harmonics`] arranged. `coefficient`: one of them,
/// by its index there.
pub fn from_planes(
    degree: usize,
    gaussians: usize,
    coefficient: impl Fn(usize) -> f16,
) -> ShCoefficients {
    let functions = functions_of(degree);
    let row = |at: usize| {
        let [gaussian, function] = [at / functions, at % functions];
        std::array::from_fn(|channel| coefficient((3 * function + channel) * gaussians + gaussian))
    };
    ShCoefficients {
        degree,
        coefficients: (0..gaussians * functions).map(row).collect(),
    }
}

/// The coarsest encoding of spherical harmonics that is exact in every set; None if no encoding is.
pub fn exact_harmonics(avatar: &Avatar) -> Option<HarmonicCodes> {
    [HarmonicCodes::COARSE, HarmonicCodes::FINE]
        .into_iter()
        .find(|codes| {
            SetArrays::all(avatar).all(|set| {
                set.sh.is_some_and(|sh| codes.is_exact(&sh.coefficients))
                    && codes.is_exact(&set.gaussians.color)
            })
        })
}

/// Colours of the Gaussians that have a basis row of colour, which codes would round.
pub fn row_colors(set: SetArrays) -> Vec<[f16; 3]> {
    set.color_rows
        .gaussian
        .iter()
        .filter_map(|&gaussian| set.gaussians.color.get(gaussian as usize))
        .copied()
        .collect()
}

/// Joint weights except each Gaussian's last.
pub fn joint_weights(gaussians: &Gaussians) -> Vec<[u8; 3]> {
    gaussians
        .joint_weight
        .iter()
        .map(|&[a, b, c, _]| [a, b, c])
        .collect()
}

/// The arrays that codes represent exactly in every set of Gaussians. Bases and networks are
/// included where they are bytes.
pub fn exact_codes(avatar: &Avatar) -> Vec<Coded> {
    let all = |exact: fn(SetArrays) -> bool| SetArrays::all(avatar).all(exact);
    let neutral = [
        (Coded::Rotation, all(has_coded_rotations)),
        (Coded::Color, all(has_coded_colors)),
        (Coded::JointWeight, all(has_coded_weights)),
    ];
    neutral
        .into_iter()
        .filter_map(|(what, exact)| exact.then_some(what))
        .chain(matrices(avatar))
        .collect()
}

fn has_coded_rotations(set: SetArrays) -> bool {
    let mut rotations = set.gaussians.rotation.iter();
    rotations.all(|&q| rotation(encode_quaternion(q.map(f64::from)).0) == q)
}

fn has_coded_colors(set: SetArrays) -> bool {
    let has_row = |gaussian: usize| {
        let rows = &set.color_rows.gaussian;
        rows.binary_search(&(gaussian as u32)).is_ok()
    };
    let mut colors = set.gaussians.color.iter().enumerate();
    colors.all(|(at, c)| has_row(at) || c.iter().all(|&c| color(color_code(c)) == c))
}

fn has_coded_weights(set: SetArrays) -> bool {
    let mut weights = set.gaussians.joint_weight.iter();
    weights.all(|w| w.iter().map(|&w| u32::from(w)).sum::<u32>() == 255)
}

/// The encodings of log scales of each set, of as many bits as few that are exact in all of them;
/// None if no encoding is.
pub fn exact_log_scales(avatar: &Avatar) -> Option<Vec<LogScaleCodes>> {
    let candidates: Vec<[LogScaleCodes; 2]> = SetArrays::all(avatar)
        .map(|set| LogScaleCodes::candidates(set.gaussians))
        .collect();
    let of_kind =
        |kind: usize| -> Vec<LogScaleCodes> { candidates.iter().map(|both| both[kind]).collect() };
    [of_kind(1), of_kind(0)].into_iter().find(|all| {
        SetArrays::all(avatar).zip(all).all(|(set, codes)| {
            let mut log_scales = set.gaussians.log_scale.iter().flatten();
            log_scales.all(|&s| codes.decode(codes.encode(s)) == s)
        })
    })
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
