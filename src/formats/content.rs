//! What a file is, told by its content.

use crate::{
    bvh, mmlphuman, npz, pickle,
    splats::{self, SplatFormat},
    webavatar,
};
use std::path::Path;

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Gaussians of a static scene.
    Splats(SplatFormat),
    /// The paper's model.
    Model,
    /// The training checkpoint of mmlphuman, from which an avatar is distilled.
    Checkpoint,
    /// The paper's poses.
    Poses,
    /// Motion of any body.
    Capture(CaptureFormat),
    /// Effigy's own, or nothing that is known.
    Other,
}

/// A format of motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CaptureFormat {
    /// Biovision's text.
    Bvh,
    /// glTF without splats, VRM among it.
    Gltf,
    /// Autodesk's, in text or binary.
    Fbx,
    /// Parameters of the SMPL family: NumPy's files, pickles and PyTorch's files.
    Smpl,
}

impl Content {
    /// What a file of these bytes is. `name`: the file's, for content that tells nothing.
    pub fn of(bytes: &[u8], name: &Path) -> Self {
        let named = || SplatFormat::of_name(name).map(Self::Splats);
        Self::known(bytes).or_else(named).unwrap_or(Self::Other)
    }

    /// None: the bytes tell nothing.
    fn known(bytes: &[u8]) -> Option<Self> {
        if npz::is_zip(bytes) {
            return Some(Self::of_zip(bytes));
        }
        let start = &bytes[..bytes.len().min(SplatFormat::START)];
        if bvh::is_bvh(start) {
            return Some(Self::Capture(CaptureFormat::Bvh));
        }
        if is_fbx(start) {
            return Some(Self::Capture(CaptureFormat::Fbx));
        }
        if start.starts_with(b"\x93NUMPY") || pickle::is_pickle(start) {
            return Some(Self::Capture(CaptureFormat::Smpl));
        }
        if start.trim_ascii_start().starts_with(b"[") {
            return Some(Self::Poses);
        }
        match SplatFormat::of(start, bytes.len() as u64)? {
            SplatFormat::Glb | SplatFormat::Gltf if !names_splats(bytes) => {
                Some(Self::Capture(CaptureFormat::Gltf))
            }
            format => Some(Self::Splats(format)),
        }
    }

    fn of_zip(bytes: &[u8]) -> Self {
        if splats::is_sog(bytes) {
            Self::Splats(SplatFormat::Sog)
        } else if npz::lists(bytes, webavatar::POSITIONS) {
            Self::Model
        } else if mmlphuman::is_checkpoint(bytes) {
            Self::Checkpoint
        } else {
            Self::Capture(CaptureFormat::Smpl)
        }
    }

    /// What it is, in a word or two; None: of no known kind, or Effigy's own.
    pub fn kind(self) -> Option<&'static str> {
        Some(match self {
            Self::Splats(format) => match format {
                SplatFormat::Ply => "splats, .ply",
                SplatFormat::Splat => "splats, .splat",
                SplatFormat::Spz => "splats, .spz",
                SplatFormat::Sog | SplatFormat::SogMeta => "splats, SOG",
                SplatFormat::Ksplat => "splats, .ksplat",
                SplatFormat::Glb | SplatFormat::Gltf => "splats, glTF",
            },
            Self::Model => "the paper's model",
            Self::Checkpoint => "mmlphuman's checkpoint",
            Self::Poses => "the paper's poses",
            Self::Capture(CaptureFormat::Bvh) => "motion, BVH",
            Self::Capture(CaptureFormat::Gltf) => "motion, glTF",
            Self::Capture(CaptureFormat::Fbx) => "motion, FBX",
            Self::Capture(CaptureFormat::Smpl) => "motion, SMPL",
            Self::Other => return None,
        })
    }

    /// Whether it is an avatar of another program.
    pub fn is_avatar(self) -> bool {
        matches!(self, Self::Splats(_) | Self::Model)
    }

    /// Whether it is motion of another program, of a body that an avatar need not have.
    pub fn is_motion(self) -> bool {
        matches!(self, Self::Capture(_) | Self::Poses)
    }
}

/// The extension of glTF without which it has no splats.
const SPLATS_EXTENSION: &[u8] = b"KHR_gaussian_splatting";
/// Bytes of a glTF that are searched for it.
const LONGEST_DOCUMENT: usize = 4 << 20;

/// Whether a glTF's document names the extension of splats.
fn names_splats(bytes: &[u8]) -> bool {
    let document = &bytes[..bytes.len().min(LONGEST_DOCUMENT)];
    let mut words = document.windows(SPLATS_EXTENSION.len());
    words.any(|word| word == SPLATS_EXTENSION)
}

/// Whether bytes begin as an FBX does.
fn is_fbx(start: &[u8]) -> bool {
    start.starts_with(b"Kaydara FBX Binary") || start.starts_with(b"; FBX")
}
