//! A dataset: for each of some poses, what every Gaussian of an avatar should look like. `effigy dataset` makes one from the baked body;
//! anyone can from a larger model, for it is a folder of files in open formats.
//!
//! ```text
//! NAME.dataset/
//!   dataset.json              [`Header`]: what it is, and of each frame the clip, the time and whether it is held out
//!   neutral.avatar            skeleton, parts, nodes, skin weights, opacity, positions; its correctives are not looked at
//!   poses.motion              a motion file of the avatar's joints: the pose of frame k is its frame k
//!   frame-00000.safetensors   tensors of frame 0, dtype F16, N_g rows in the avatar's order:
//!                               rotation   N_g, 4   quaternion w x y z, canonical pose, before skinning
//!                               log_scale  N_g, 3   natural logarithm of metres
//!                               color      N_g, 3   display-referred RGB, 0 to 1
//!                               offset     N_g, 3   metres, added to the canonical position before skinning (model.md, step 4)
//!   frame-00001.safetensors   …
//! ```

mod check;
mod write;

use crate::avatar::{Avatar, Clip, Pose, file::FileError};
use glam::DVec3;
use half::{f16, slice::HalfFloatSliceExt};
use memmap2::Mmap;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
pub use write::{Writer, plan};

/// `format` of [`Header`].
pub const FORMAT: &str = "effigy.dataset";
/// The version that is written, and the only one read.
pub const VERSION: u64 = 1;

/// Why a dataset or what is made of it was not read or written.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    #[error(transparent)]
    File(#[from] FileError),
    #[error("cannot read {}: {cause}", .file.display())]
    Read { file: PathBuf, cause: std::io::Error },
    #[error("cannot write {}: {cause}", .file.display())]
    Write { file: PathBuf, cause: std::io::Error },
    #[error("{}: found {found}, expected {expected}", .file.display())]
    Content { file: PathBuf, found: String, expected: String },
    #[error("{}, frame {frame}: found {found}, expected {expected}", .file.display())]
    Frame { file: PathBuf, frame: usize, found: String, expected: String },
}

/// The document `dataset.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// "effigy.dataset"
    pub format: String,
    pub version: u64,
    pub name: String,
    /// Source and licence, free text.
    #[serde(default)]
    pub credit: String,
    /// N_g.
    pub gaussians: usize,
    /// One a frame, in order.
    pub frames: Vec<Shot>,
}

/// What is known of a frame besides its pose.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shot {
    /// The clip that it is from; `poses.motion` may have another expression there than the clip (`effigy dataset --faces`).
    pub clip: String,
    /// Into the clip.
    pub seconds: f64,
    /// Kept from the fit, to be evaluated on.
    #[serde(default)]
    pub held: bool,
}

/// The attributes of every Gaussian in one frame; see the table above.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    pub rotation: Vec<[f16; 4]>,
    pub log_scale: Vec<[f16; 3]>,
    pub color: Vec<[f16; 3]>,
    pub offset: Vec<[f16; 3]>,
}

/// A tensor of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Attribute {
    Rotation,
    LogScale,
    Color,
    Offset,
}

impl Attribute {
    pub const ALL: [Self; 4] = [Self::Rotation, Self::LogScale, Self::Color, Self::Offset];

    pub fn name(self) -> &'static str {
        ["rotation", "log_scale", "color", "offset"][self as usize]
    }

    /// Numbers a Gaussian.
    pub fn width(self) -> usize {
        [4, 3, 3, 3][self as usize]
    }
}

/// An opened dataset: its frames are mapped, not read.
pub struct Dataset {
    pub header: Header,
    /// What stands at its head; with another order of Gaussians after [`Dataset::regrouped`].
    pub avatar: Avatar,
    /// The poses as the file has them.
    pub clip: Clip,
    /// Of each frame, in the skeleton's order of joints.
    pub poses: Vec<Pose>,
    frames: Vec<Mapped>,
    /// The file's row of each Gaussian, where the order is another.
    order: Option<Vec<u32>>,
}

/// A frame's file and where its tensors begin.
struct Mapped {
    bytes: Mmap,
    start: [usize; 4],
}

/// The name of a frame's file.
pub fn frame_name(frame: usize) -> String {
    format!("frame-{frame:05}.safetensors")
}

impl Dataset {
    /// Opens a dataset and holds all of it against the rules above.
    ///
    /// # Errors
    /// When a file is missing or breaks a rule; the sentence names the file and the frame.
    pub fn open(folder: &Path) -> Result<Self, Error> {
        let header = check::header(folder)?;
        let avatar = Avatar::read(&folder.join("neutral.avatar"))?;
        let clip = Clip::read(&folder.join("poses.motion"))?;
        check::agree(folder, &header, &avatar, &clip)?;
        let frames = check::frames(folder, &header)?;
        let map = clip.map_to(&avatar.skeleton);
        let pose = |frame| {
            let pose: Pose = clip.frame(frame);
            Pose { rotation: map.iter().map(|joint| joint.map_or(DVec3::ZERO, |joint| pose.rotation[joint])).collect(), ..pose }
        };
        let poses = (0..clip.frames()).map(pose).collect();
        Ok(Self { header, avatar, clip, poses, frames, order: None })
    }

    /// F.
    pub fn len(&self) -> usize {
        self.frames.len()
    }

    pub fn is_empty(&self) -> bool {
        self.frames.is_empty()
    }

    /// Frames to fit to: those not held out, of the named clips, or of all where none is named.
    pub fn training(&self, clips: &[String]) -> Vec<usize> {
        let wanted = |shot: &Shot| !shot.held && (clips.is_empty() || clips.contains(&shot.clip));
        (0..self.len()).filter(|&frame| wanted(&self.header.frames[frame])).collect()
    }

    /// The names of the clips, in the order in which they first come.
    pub fn clips(&self) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for shot in &self.header.frames {
            if !names.contains(&shot.clip) {
                names.push(shot.clip.clone());
            }
        }
        names
    }

    /// The same frames for an avatar whose Gaussians are the old one's in another order: `order` has the old index of each.
    pub fn regrouped(mut self, avatar: Avatar, order: &[u32]) -> Self {
        self.order = Some(match self.order.take() {
            Some(before) => order.iter().map(|&k| before[k as usize]).collect(),
            None => order.to_vec(),
        });
        self.avatar = avatar;
        self
    }

    /// An attribute of some Gaussians of a frame, appended to `out`.
    pub fn numbers(&self, frame: usize, attribute: Attribute, gaussians: std::ops::Range<usize>, out: &mut Vec<f32>) {
        let (mapped, width) = (&self.frames[frame], attribute.width());
        let rows = |range: std::ops::Range<usize>| {
            &mapped.bytes[mapped.start[attribute as usize] + 2 * width * range.start..][..2 * width * range.len()]
        };
        match &self.order {
            None => convert(rows(gaussians), out),
            Some(order) => order[gaussians].iter().map(|&row| row as usize).for_each(|row| convert(rows(row..row + 1), out)),
        }
    }

    /// Everything of a frame.
    pub fn frame(&self, frame: usize) -> Frame {
        fn rows<const C: usize>(dataset: &Dataset, frame: usize, attribute: Attribute) -> Vec<[f16; C]> {
            let mut numbers = Vec::new();
            dataset.numbers(frame, attribute, 0..dataset.avatar.gaussians.len(), &mut numbers);
            numbers.as_chunks::<C>().0.iter().map(|row| row.map(f16::from_f32)).collect()
        }
        Frame {
            rotation: rows(self, frame, Attribute::Rotation),
            log_scale: rows(self, frame, Attribute::LogScale),
            color: rows(self, frame, Attribute::Color),
            offset: rows(self, frame, Attribute::Offset),
        }
    }
}

/// f16 at any alignment to f32.
fn convert(bytes: &[u8], out: &mut Vec<f32>) {
    let start = out.len();
    out.resize(start + bytes.len() / 2, 0.0);
    match bytemuck::try_cast_slice::<u8, f16>(bytes) {
        Ok(halves) => halves.convert_to_f32_slice(&mut out[start..]),
        Err(_) => bytemuck::pod_collect_to_vec::<u8, f16>(bytes).convert_to_f32_slice(&mut out[start..]),
    }
}
