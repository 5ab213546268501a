//! The documents in the files' headers.

use super::coding::{Coded, HarmonicCodes, LogScaleCodes};
use super::deflate::ByteArrangement;
use crate::avatar::{Activation, Filter, LevelError, harmonics::functions_of};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The document of an avatar file.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct AvatarHeader {
    /// "effigy.avatar"
    pub format: String,
    /// 1, or 2 where there are codes or deflated tensors, or 3 where there is a filter, or 4 where
    /// there are spherical harmonics or no networks, or 5 where there is a facing.
    pub version: u64,
    /// Name of the avatar.
    pub name: String,
    /// Source and licence, free text.
    #[serde(default)]
    pub credit: String,
    /// "metre", the unit of every length.
    pub units: String,
    /// "y": the axis that points up; the avatar faces +z.
    pub up: String,
    /// "srgb": colours are display-referred, sRGB-encoded, and blended so.
    pub color_space: String,
    /// Number of Gaussians, N_g.
    pub gaussians: usize,
    /// Number of parts, N_G.
    pub parts: usize,
    /// The first this many parts see the expression.
    pub head_parts: usize,
    /// Number of nodes, N_s.
    pub nodes: usize,
    /// Basis functions of a part, N_B; 0 without networks.
    pub basis: usize,
    /// Number of Gaussians with a corrective of their rotation.
    pub rotation_rows: usize,
    /// Number of Gaussians with a corrective of their scale.
    pub scale_rows: usize,
    /// Number of Gaussians with a corrective of their colour.
    pub color_rows: usize,
    /// Lower and upper corner of the box that positions are coordinates in: `min + q / 65535 · (max
    /// − min)`.
    pub bounds: [[f32; 3]; 2],
    /// "relu" or "leaky_relu" (slope 0.01), after every layer but the last.
    pub activation: Activation,
    /// Widths of the networks: input, hidden layers (multiples of 4), output (N_B or 2 N_B). None
    /// without networks, from version 4 on.
    pub widths: Vec<usize>,
    /// Names of the joints, all different.
    pub joints: Vec<String>,
    /// Parent of each joint, an earlier joint; null only for joint 0.
    pub parents: Vec<Option<u8>>,
    /// Joints whose rotations enter the networks, in this order; 3 numbers each.
    pub inputs: Vec<u8>,
    /// Length of the expression, which follows them in the input.
    pub expression: usize,
    /// Principal components of the pose; absent or null without such a space.
    pub pose_components: Option<usize>,
    /// Principal components of the expression; absent or null without such a space.
    pub expression_components: Option<usize>,
    /// Arrays that are stored as codes; none in version 1.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub coded: Vec<Coded>,
    /// Encoding of log scales; absent where they are f16.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub log_scales: Option<LogScaleCodes>,
    /// The tensors that are deflated, and how their bytes are arranged; none in version 1.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub deflated: BTreeMap<String, ByteArrangement>,
    /// The low-pass that the avatar was learned with; absent where that is [`Filter::DEFAULT`], and
    /// in versions 1 and 2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub filter: Option<Filter>,
    /// Spherical harmonics, from version 4 on; absent where colours don't depend on the view.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub harmonics: Option<HarmonicsHeader>,
    /// Whether there are directions from which Gaussians are drawn, from version 5 on.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub facing: bool,
    /// Levels of detail, each with fewer Gaussians than the one before; absent without any.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub levels: Vec<LevelHeader>,
}

/// What an avatar's document says of its spherical harmonics, and of those of its levels.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct HarmonicsHeader {
    /// Highest degree: 1 to 3.
    pub degree: usize,
    /// Encoding of the coefficients, those of degree 0 (`color`) among them; absent where they are
    /// f16.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub codes: Option<HarmonicCodes>,
}

/// What an avatar's document says of a level. Its arrays are stored as the avatar's are.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct LevelHeader {
    /// Number of Gaussians.
    pub gaussians: usize,
    /// Whether networks move them. Where not, they name no nodes and have no correctives.
    pub correctives: bool,
    /// Number of Gaussians with a corrective of their rotation.
    #[serde(default)]
    pub rotation_rows: usize,
    /// Number of Gaussians with a corrective of their scale.
    #[serde(default)]
    pub scale_rows: usize,
    /// Number of Gaussians with a corrective of their colour.
    #[serde(default)]
    pub color_rows: usize,
    /// Encoding of log scales, of as many bits as the avatar's; absent where they are f16.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub log_scales: Option<LogScaleCodes>,
    /// Errors of images of this level.
    #[serde(default)]
    pub measured: Vec<LevelError>,
}

/// What a document says of a set.
#[derive(Clone, Copy)]
pub struct SetCounts {
    /// Number of Gaussians.
    pub gaussians: usize,
    /// Number of them that name nodes: all or none.
    pub with_nodes: usize,
    /// Number of Gaussians with a corrective of their rotation.
    pub rotation_rows: usize,
    /// Number of Gaussians with a corrective of their scale.
    pub scale_rows: usize,
    /// Number of Gaussians with a corrective of their colour.
    pub color_rows: usize,
    /// Encoding of log scales; None where they are f16.
    pub log_scales: Option<LogScaleCodes>,
}

impl SetCounts {
    fn of_level(level: &LevelHeader) -> Self {
        Self {
            gaussians: level.gaussians,
            with_nodes: if level.correctives {
                level.gaussians
            } else {
                0
            },
            rotation_rows: level.rotation_rows,
            scale_rows: level.scale_rows,
            color_rows: level.color_rows,
            log_scales: level.log_scales,
        }
    }
}

/// The document of a motion file.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct ClipHeader {
    /// "effigy.motion"
    pub format: String,
    /// 1.
    pub version: u64,
    /// Name of the clip.
    pub name: String,
    /// Source and licence, free text.
    #[serde(default)]
    pub credit: String,
    /// "metre", the unit of the translation.
    pub units: String,
    /// "y"
    pub up: String,
    /// Frames a second.
    pub rate: f64,
    /// Number of frames.
    pub frames: usize,
    /// Names of the joints, all different.
    pub joints: Vec<String>,
    /// Length of the expression.
    pub expression: usize,
}

impl AvatarHeader {
    /// Number of sets.
    pub fn sets(&self) -> usize {
        1 + self.levels.len()
    }

    /// What the document says of a set.
    ///
    /// # Panics
    /// When there is no such set.
    pub fn set(&self, set: usize) -> SetCounts {
        match set.checked_sub(1) {
            None => SetCounts {
                gaussians: self.gaussians,
                with_nodes: self.gaussians,
                rotation_rows: self.rotation_rows,
                scale_rows: self.scale_rows,
                color_rows: self.color_rows,
                log_scales: self.log_scales,
            },
            Some(level) => SetCounts::of_level(&self.levels[level]),
        }
    }

    /// Length of θ_p.
    pub fn pose_len(&self) -> usize {
        3 * self.inputs.len()
    }

    /// Number of tensors that hold codes of something: 0 or 1.
    pub fn coded(&self, what: Coded) -> usize {
        usize::from(self.coded.contains(&what))
    }

    /// Number of tensors that hold something without codes: 0 or 1.
    pub fn plain(&self, what: Coded) -> usize {
        1 - self.coded(what)
    }

    /// Number of tensors that hold log scales as codes of so many bits: 0 or 1.
    pub fn log_scales_of(&self, bits: u32) -> usize {
        usize::from(self.log_scales.is_some_and(|codes| codes.bits == bits))
    }

    /// Functions of the spherical harmonics from degree 1 up: 0 without any.
    pub fn harmonic_functions(&self) -> usize {
        self.harmonics
            .map_or(0, |harmonics| functions_of(harmonics.degree))
    }

    /// Encoding of the spherical harmonics; None where they are f16 or there are none.
    pub fn harmonic_codes(&self) -> Option<HarmonicCodes> {
        self.harmonics.and_then(|harmonics| harmonics.codes)
    }

    /// Number of tensors that hold spherical harmonics in f16: 0 or 1.
    pub fn plain_harmonics(&self) -> usize {
        usize::from(
            self.harmonics
                .is_some_and(|harmonics| harmonics.codes.is_none()),
        )
    }

    /// Number of tensors that hold spherical harmonics as codes: 0 or 1.
    pub fn coded_harmonics(&self) -> usize {
        usize::from(self.harmonic_codes().is_some())
    }

    /// Number of tensors that hold colours in f16: 0 or 1.
    pub fn plain_colors(&self) -> usize {
        self.plain(Coded::Color) * (1 - self.coded_harmonics())
    }

    /// Whether there are neither networks nor what they move. Their part is 0 everywhere.
    pub fn is_without_networks(&self) -> bool {
        self.widths.is_empty() && self.basis == 0
    }

    /// Number of layers of a network.
    pub fn layers(&self) -> usize {
        self.widths.len().saturating_sub(1)
    }
}
