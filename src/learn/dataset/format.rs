//! The contents of a dataset's files, and the errors of reading and writing them.

use effigy_core::io::file::FileError;
use half::f16;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// `format` of [`DatasetHeader`].
pub const FORMAT: &str = "effigy.dataset";
/// The version that is written, and the only one read.
pub const VERSION: u64 = 1;
/// The header's file.
pub const HEADER_FILE: &str = "dataset.json";
/// The avatar's file.
pub const AVATAR_FILE: &str = "neutral.avatar";
/// The file of the frames' poses.
pub const POSES_FILE: &str = "poses.motion";

/// Why a dataset, or a file made from it, was not read or written.
#[derive(Debug, thiserror::Error)]
pub enum LearnError {
    /// An avatar or motion file of the dataset.
    #[error(transparent)]
    File(#[from] FileError),
    /// A file cannot be read.
    #[error("cannot read {}: {cause}", .file.display())]
    Read {
        /// The file's path.
        file: PathBuf,
        /// The system's error.
        cause: std::io::Error,
    },
    /// A file or folder cannot be written.
    #[error("cannot write {}: {cause}", .file.display())]
    Write {
        /// The path.
        file: PathBuf,
        /// The system's error.
        cause: std::io::Error,
    },
    /// A file breaks a rule.
    #[error("{}: found {found}, expected {expected}", .file.display())]
    Content {
        /// The file's path.
        file: PathBuf,
        /// The text or number that is there.
        found: String,
        /// The text or number that should be there.
        expected: String,
    },
    /// A file breaks a rule at one frame.
    #[error("{}, frame {frame}: found {found}, expected {expected}", .file.display())]
    Frame {
        /// The file's path.
        file: PathBuf,
        /// Counted from 0.
        frame: usize,
        /// The text or number that is there.
        found: String,
        /// The text or number that should be there.
        expected: String,
    },
}

/// The document `dataset.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DatasetHeader {
    /// "effigy.dataset".
    pub format: String,
    /// The version of the format: 1.
    pub version: u64,
    /// The dataset's name.
    pub name: String,
    /// Source and licence, free text.
    #[serde(default)]
    pub credit: String,
    /// N_g.
    pub gaussians: usize,
    /// One a frame, in order.
    pub frames: Vec<Shot>,
}

/// A frame's clip and time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shot {
    /// The clip that it is from. `poses.motion` may have another expression there than the clip
    /// (`effigy dataset --faces`).
    pub clip: String,
    /// Into the clip.
    pub seconds: f64,
    /// Held out from the fit, to be evaluated on.
    #[serde(default)]
    pub held: bool,
}

/// The attributes of every Gaussian in one frame; see the table in [`crate::dataset`].
#[derive(Clone, Debug, PartialEq)]
pub struct FrameAttributes {
    /// Quaternions w x y z.
    pub rotation: Vec<[f16; 4]>,
    /// Natural logarithms of metres.
    pub log_scale: Vec<[f16; 3]>,
    /// Display-referred RGB, 0 to 1.
    pub color: Vec<[f16; 3]>,
    /// Metres, canonical space.
    pub offset: Vec<[f16; 3]>,
}

/// A tensor of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Attribute {
    /// [`FrameAttributes::rotation`].
    Rotation,
    /// [`FrameAttributes::log_scale`].
    LogScale,
    /// [`FrameAttributes::color`].
    Color,
    /// [`FrameAttributes::offset`].
    Offset,
}

impl Attribute {
    /// In the order of a frame's columns.
    pub const ALL: [Self; 4] = [Self::Rotation, Self::LogScale, Self::Color, Self::Offset];

    /// The tensor's name in the file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rotation => "rotation",
            Self::LogScale => "log_scale",
            Self::Color => "color",
            Self::Offset => "offset",
        }
    }

    /// Numbers a Gaussian.
    pub fn width(self) -> usize {
        match self {
            Self::Rotation => 4,
            Self::LogScale | Self::Color | Self::Offset => 3,
        }
    }
}

/// The name of a frame's file.
pub fn frame_name(frame: usize) -> String {
    format!("frame-{frame:05}.safetensors")
}
