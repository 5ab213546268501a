//! Numbers in fewer bits than version 1 of the format has: what an avatar's arrays are written as where nothing is lost by it, and the
//! way back. What is rounded so that nothing is lost is in [`crate::avatar::pack`].

use crate::avatar::{Avatar, Matrix};
use crate::layout::compact::{LogScales, decode_quaternion, encode_quaternion};
use bytemuck::Pod;
use half::f16;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// What a file of version 2 stores as codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Coded {
    /// Quaternions of length 1 in 32 bits: which component is the largest, the two highest bits, and the others in 720ths plus 512, ten
    /// bits each, in order from the lowest; the largest is positive.
    Rotation,
    /// Colours in bytes, 255 is 1; those of the rows of `color.row` beside them, f16.
    Color,
    /// Three of the weights of the joints, in bytes: the fourth is what is left of 255.
    JointWeight,
    /// Bases in bytes, with a step a row; so the next three.
    RotationBasis,
    ScaleBasis,
    ColorBasis,
    NodeBasis,
    /// All weights of networks in bytes, with a step a neuron.
    Networks,
}

/// Log scales as codes: `min + step · code`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct LogScaleCodes {
    pub min: f64,
    pub step: f64,
    /// 8 or 16.
    pub bits: u32,
}

impl LogScaleCodes {
    /// Largest code of 16 bits: what the renderers keep of it.
    pub const MOST: usize = 1023;
    /// Smallest and largest `min` and `step`.
    pub const RANGE: [[f64; 2]; 2] = [[-100.0, 100.0], [1.0 / 1024.0, 8.0]];

    /// The codes that the renderers keep, and the finest of them that bytes hold.
    pub fn of(avatar: &Avatar) -> [Self; 2] {
        let scales = LogScales::of(avatar);
        let most = avatar.gaussians.log_scale.iter().flatten().map(|s| scales.encode(s.to_f64())).max().unwrap_or_default();
        let mut step = scales.step;
        while f64::from(most) * scales.step > 255.0 * step {
            step *= 2.0;
        }
        [Self { min: scales.min, step: scales.step, bits: 16 }, Self { min: scales.min, step, bits: 8 }]
    }

    pub fn encode(&self, log_scale: f16) -> u16 {
        let most = if self.bits == 8 { 255.0 } else { Self::MOST as f64 };
        ((log_scale.to_f64() - self.min) / self.step).round().clamp(0.0, most) as u16
    }

    pub fn decode(&self, code: u16) -> f16 {
        f16::from_f64(self.min + self.step * f64::from(code))
    }
}

/// The bytes of a tensor: those of the model, or new ones.
pub trait Stored<'a> {
    fn stored(self) -> Cow<'a, [u8]>;
}

impl<'a, T: Pod> Stored<'a> for &'a Vec<T> {
    fn stored(self) -> Cow<'a, [u8]> {
        Cow::Borrowed(bytemuck::cast_slice(self))
    }
}

impl<'a, T: Pod> Stored<'a> for &'a [T] {
    fn stored(self) -> Cow<'a, [u8]> {
        Cow::Borrowed(bytemuck::cast_slice(self))
    }
}

impl<'a, T: Pod> Stored<'a> for Vec<T> {
    fn stored(self) -> Cow<'a, [u8]> {
        Cow::Owned(bytemuck::cast_slice(&self).to_vec())
    }
}

/// The numbers of a matrix of f16, none of another.
pub fn halves(matrix: &Matrix) -> &[f16] {
    if let Matrix::Halves(numbers) = matrix { numbers } else { &[] }
}

/// The codes of a matrix of bytes, none of another.
pub fn codes(matrix: &Matrix) -> &[i8] {
    if let Matrix::Bytes { codes, .. } = matrix { codes } else { &[] }
}

/// The steps of a matrix of bytes, none of another.
pub fn steps(matrix: &Matrix) -> &[f16] {
    if let Matrix::Bytes { steps, .. } = matrix { steps } else { &[] }
}

pub fn rotations(avatar: &Avatar) -> Vec<u32> {
    avatar.gaussians.rotation.iter().map(|&q| encode_quaternion(q.map(f64::from)).0).collect()
}

pub fn rotation(word: u32) -> [f16; 4] {
    decode_quaternion(word).map(f16::from_f64)
}

/// `T`: u8 or u16.
pub fn log_scales<T: Pod + TryFrom<u16>>(avatar: &Avatar, codes: Option<LogScaleCodes>) -> Vec<[T; 3]> {
    let code = |codes: LogScaleCodes, s: f16| T::try_from(codes.encode(s)).unwrap_or_else(|_| T::zeroed());
    codes.map_or_else(Vec::new, |codes| avatar.gaussians.log_scale.iter().map(|&s| s.map(|s| code(codes, s))).collect())
}

pub fn colors(avatar: &Avatar) -> Vec<[u8; 3]> {
    avatar.gaussians.color.iter().map(|c| c.map(color_code)).collect()
}

fn color_code(color: f16) -> u8 {
    (color.to_f64().clamp(0.0, 1.0) * 255.0).round() as u8
}

pub fn color(code: u8) -> f16 {
    f16::from_f64(f64::from(code) / 255.0)
}

/// Colours of the Gaussians that keep a row of colour.
pub fn kept_colors(avatar: &Avatar) -> Vec<[f16; 3]> {
    avatar.color_rows.gaussian.iter().filter_map(|&gaussian| avatar.gaussians.color.get(gaussian as usize)).copied().collect()
}

pub fn joint_weights(avatar: &Avatar) -> Vec<[u8; 3]> {
    avatar.gaussians.joint_weight.iter().map(|&[a, b, c, _]| [a, b, c]).collect()
}

/// What codes hold exactly of an avatar. `True` of bases and networks where they are bytes.
pub fn exact(avatar: &Avatar) -> (Vec<Coded>, Option<LogScaleCodes>) {
    let g = &avatar.gaussians;
    let kept = |gaussian: usize| avatar.color_rows.gaussian.binary_search(&(gaussian as u32)).is_ok();
    let color_is_exact = |(at, c): (usize, &[f16; 3])| kept(at) || c.iter().all(|&c| color(color_code(c)) == c);
    let scale_is_exact = |codes: &LogScaleCodes| g.log_scale.iter().flatten().all(|&s| codes.decode(codes.encode(s)) == s);
    let neutral = [
        (Coded::Rotation, g.rotation.iter().all(|&q| rotation(encode_quaternion(q.map(f64::from)).0) == q)),
        (Coded::Color, g.color.iter().enumerate().all(color_is_exact)),
        (Coded::JointWeight, g.joint_weight.iter().all(|w| w.iter().map(|&w| u32::from(w)).sum::<u32>() == 255)),
    ];
    let coded = neutral.into_iter().filter_map(|(what, exact)| exact.then_some(what)).chain(matrices(avatar)).collect();
    (coded, LogScaleCodes::of(avatar).into_iter().rev().find(scale_is_exact))
}

/// Which bases, and whether networks, are bytes.
pub fn matrices(avatar: &Avatar) -> impl Iterator<Item = Coded> {
    let all = [
        (Coded::RotationBasis, avatar.rotation_rows.basis.is_bytes()),
        (Coded::ScaleBasis, avatar.scale_rows.basis.is_bytes()),
        (Coded::ColorBasis, avatar.color_rows.basis.is_bytes()),
        (Coded::NodeBasis, avatar.nodes.basis.is_bytes()),
        (Coded::Networks, avatar.networks.in_bytes()),
    ];
    all.into_iter().filter_map(|(what, bytes)| bytes.then_some(what))
}
