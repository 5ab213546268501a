//! Which format a file has, by its content.

use super::{antimatter, ksplat, spz};
use effigy_core::io::ply;
use std::path::Path;

/// Keys of a streamed SOG's document.
const LOD_KEYS: [&str; 2] = ["lodLevels", "filenames"];
/// Keys that a SOG's document has and no glTF, and keys of which every glTF has one.
const SOG_KEYS: [&str; 4] = ["means", "quats", "sh0", "codebook"];
const GLTF_KEYS: [&str; 6] = [
    "asset",
    "accessors",
    "bufferViews",
    "buffers",
    "extensionsUsed",
    "meshes",
];

/// A format of splats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SplatFormat {
    /// A `.ply`, plain or compressed.
    Ply,
    /// antimatter15's `.splat`.
    Splat,
    /// A `.spz`.
    Spz,
    /// A zip with a `meta.json`.
    Sog,
    /// The `meta.json` of a SOG in a folder.
    SogMeta,
    /// The `lod-meta.json` of a streamed SOG.
    SogLod,
    /// mkkellogg's `.ksplat`.
    Ksplat,
    /// glTF in one file.
    Glb,
    /// glTF's document.
    Gltf,
}

impl SplatFormat {
    /// Bytes of a file's start that [`Self::of`] looks at, at most.
    pub const START: usize = 4096;

    /// The format of a file of `length` bytes that begins with `start`, without a byte order mark. A zip is told apart by what
    /// is in it: that it is a [`Self::Sog`] is for the caller to find out.
    pub fn of(start: &[u8], length: u64) -> Option<Self> {
        if ply::starts_ply(start) {
            return Some(Self::Ply);
        }
        if start.starts_with(b"glTF") {
            return Some(Self::Glb);
        }
        if start.starts_with(spz::MAGIC) || start.starts_with(&[0x1f, 0x8b]) {
            return Some(Self::Spz);
        }
        if is_text_from(start, b'{') {
            let has = |words: &[&str]| {
                let text = String::from_utf8_lossy(start);
                words
                    .iter()
                    .any(|word| text.contains(&format!("\"{word}\"")))
            };
            return if has(&LOD_KEYS) {
                Some(Self::SogLod)
            } else if has(&SOG_KEYS) {
                Some(Self::SogMeta)
            } else if has(&GLTF_KEYS) {
                Some(Self::Gltf)
            } else {
                None
            };
        }
        if ksplat::is_ksplat(start, length) {
            return Some(Self::Ksplat);
        }
        antimatter::is_splat(start, length).then_some(Self::Splat)
    }

    /// The format that a file's name promises, to say what is wrong with a file of no known content.
    pub fn of_name(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_string_lossy().to_ascii_lowercase();
        Some(match ending.as_str() {
            "ply" => Self::Ply,
            "splat" => Self::Splat,
            "spz" => Self::Spz,
            "sog" => Self::Sog,
            "ksplat" => Self::Ksplat,
            "glb" => Self::Glb,
            "gltf" => Self::Gltf,
            _ => return None,
        })
    }
}

/// Whether bytes begin as JSON does that begins with a bracket: as text, which splats are not.
pub fn is_text_from(start: &[u8], bracket: u8) -> bool {
    let head = &start[..start.len().min(64)];
    let text = match std::str::from_utf8(head) {
        Ok(text) => text,
        // A character that the end cuts.
        Err(error) if error.error_len().is_none() => {
            std::str::from_utf8(&head[..error.valid_up_to()]).unwrap_or_default()
        }
        Err(_) => return false,
    };
    let is_control = |c: char| c.is_control() && !c.is_whitespace();
    start.trim_ascii_start().first() == Some(&bracket) && !text.contains(is_control)
}
