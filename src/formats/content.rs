//! What a file is, told by its content.

use crate::{
    bvh, mmlphuman, pickle,
    source::{START, Source},
    splats::{self, Nothing, SplatFormat},
    webavatar,
    zip_file::{self, is_zip},
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
    /// What a file of these bytes is, or what is in it if it is packed. `name`: the file's, for
    /// content that tells nothing.
    pub fn of(bytes: &[u8], name: &Path) -> Self {
        let mut beside = Nothing;
        let source = Source::new(bytes, name, &mut beside);
        let inside = source.start(|source| Ok(Self::of_unpacked(source.bytes, source.name)));
        inside.unwrap_or_else(|_| Self::of_unpacked(&[], name))
    }

    /// As [`Self::of`], of a file that is packed in nothing.
    pub(crate) fn of_unpacked(bytes: &[u8], name: &Path) -> Self {
        let named = || SplatFormat::of_name(name).map(Self::Splats);
        Self::known(bytes).or_else(named).unwrap_or(Self::Other)
    }

    /// None: the bytes tell nothing.
    fn known(bytes: &[u8]) -> Option<Self> {
        if is_zip(bytes) {
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
        if splats::is_text_from(start, b'[') {
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
        let members = zip_file::members(bytes).unwrap_or_default();
        let positions = format!("{}.npy", webavatar::POSITIONS);
        if splats::is_sog(&members) {
            Self::Splats(SplatFormat::Sog)
        } else if members.iter().any(|member| member.name == positions) {
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
                SplatFormat::Sog | SplatFormat::SogMeta | SplatFormat::SogLod => "splats, SOG",
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

/// The extensions of glTF without which it has no splats.
const SPLATS_EXTENSIONS: [&[u8]; 2] = [
    b"KHR_gaussian_splatting",
    b"KHR_spz_gaussian_splats_compression",
];

/// Whether a glTF's document names an extension of splats.
fn names_splats(bytes: &[u8]) -> bool {
    let document = &bytes[..bytes.len().min(START)];
    SPLATS_EXTENSIONS.iter().any(|name| {
        let mut words = document.windows(name.len());
        words.any(|word| word == *name)
    })
}

/// Whether bytes begin as an FBX does.
fn is_fbx(start: &[u8]) -> bool {
    start.starts_with(b"Kaydara FBX Binary") || start.starts_with(b"; FBX")
}
