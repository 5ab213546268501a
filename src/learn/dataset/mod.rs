//! A dataset: the look of every Gaussian of an avatar in each of some poses. `effigy dataset` makes
//! one from the baked body. You can make one from a larger model, since it is a folder of files in
//! open formats.
//!
//! ```text
//! NAME.dataset/
//!   dataset.json              what it is; for each frame its clip, its time and whether it is
//!                             held out
//!   neutral.avatar            skeleton, parts, nodes, skin weights, opacity, positions; its
//!                             correctives are ignored
//!   poses.motion              a motion file of the avatar's joints: the pose of frame k is its
//!                             frame k
//!   frame-00000.safetensors   tensors of frame 0, dtype F16, N_g rows in the avatar's order:
//!                               rotation   N_g, 4   quaternion w x y z, canonical pose, before
//!                                                   skinning
//!                               log_scale  N_g, 3   natural logarithm of metres
//!                               color      N_g, 3   display-referred RGB, 0 to 1
//!                               offset     N_g, 3   metres, added to the canonical position before
//!                                                   skinning (model.md, step 4)
//!   frame-00001.safetensors   …
//! ```

mod check;
mod format;
mod write;

use effigy_core::avatar::{Avatar, Clip, Pose};
use format::{AVATAR_FILE, POSES_FILE};
pub use format::{Attribute, DatasetHeader, FrameAttributes, LearnError, Shot, frame_name};
use glam::DVec3;
use half::{f16, slice::HalfFloatSliceExt};
use std::ops::Range;
use std::path::Path;
pub use write::{DatasetWriter, plan_frames};

/// An opened dataset. Its frames are memory-mapped, not read.
pub struct Dataset {
    /// The document `dataset.json`.
    pub header: DatasetHeader,
    /// The dataset's avatar; after [`Dataset::regrouped`] with its Gaussians in another order.
    pub avatar: Avatar,
    /// The poses as in the file.
    pub clip: Clip,
    /// The pose of each frame, in the skeleton's order of joints.
    pub poses: Vec<Pose>,
    frames: Vec<check::MappedFrame>,
    /// The file's row of each Gaussian; `None` where the order is the file's.
    order: Option<Vec<u32>>,
}

impl Dataset {
    /// Opens a dataset and checks all of it against the rules above.
    ///
    /// # Errors
    /// When a file is missing or breaks a rule; the error names the file and the frame.
    pub fn open(folder: &Path) -> Result<Self, LearnError> {
        let header = check::read_header(folder)?;
        let avatar = Avatar::read(&folder.join(AVATAR_FILE))?;
        let clip = Clip::read(&folder.join(POSES_FILE))?;
        check::check_agreement(folder, &header, &avatar, &clip)?;
        let frames = check::map_frames(folder, &header)?;
        let map = clip.map_to(&avatar.skeleton);
        let pose = |frame| {
            let pose: Pose = clip.frame(frame);
            Pose {
                rotation: map
                    .iter()
                    .map(|joint| joint.map_or(DVec3::ZERO, |joint| pose.rotation[joint]))
                    .collect(),
                ..pose
            }
        };
        let poses = (0..clip.frames()).map(pose).collect();
        Ok(Self {
            header,
            avatar,
            clip,
            poses,
            frames,
            order: None,
        })
    }

    /// The number of frames, F.
    pub fn len(&self) -> usize {
        self.frames.len()
    }

    /// Whether there are no frames; never so for a dataset that was opened.
    pub fn is_empty(&self) -> bool {
        self.frames.is_empty()
    }

    /// Frames to fit to: those not held out, of the named clips, or of all where none is named.
    pub fn training(&self, clips: &[String]) -> Vec<usize> {
        let wanted = |shot: &Shot| !shot.held && (clips.is_empty() || clips.contains(&shot.clip));
        (0..self.len())
            .filter(|&frame| wanted(&self.header.frames[frame]))
            .collect()
    }

    /// The names of the clips, in the order of their first frames.
    pub fn clips(&self) -> Vec<String> {
        let mut names: Vec<String> = Vec::new();
        for shot in &self.header.frames {
            if !names.contains(&shot.clip) {
                names.push(shot.clip.clone());
            }
        }
        names
    }

    /// The dataset of an avatar whose Gaussians are the old one's in another order; `order` has the
    /// old index of each.
    pub fn regrouped(mut self, avatar: Avatar, order: &[u32]) -> Self {
        self.order = Some(match self.order.take() {
            Some(before) => order.iter().map(|&k| before[k as usize]).collect(),
            None => order.to_vec(),
        });
        self.avatar = avatar;
        self
    }

    /// Appends an attribute of some Gaussians of a frame to `out`, Gaussian by Gaussian.
    pub fn append_numbers(
        &self,
        frame: usize,
        attribute: Attribute,
        gaussians: Range<usize>,
        out: &mut Vec<f32>,
    ) {
        let mapped = &self.frames[frame];
        match &self.order {
            None => append_halves(mapped.rows(attribute, gaussians), out),
            Some(order) => {
                for &row in &order[gaussians] {
                    let row = row as usize;
                    append_halves(mapped.rows(attribute, row..row + 1), out);
                }
            }
        }
    }

    /// All attributes of a frame.
    pub fn frame(&self, frame: usize) -> FrameAttributes {
        FrameAttributes {
            rotation: self.rows(frame, Attribute::Rotation),
            log_scale: self.rows(frame, Attribute::LogScale),
            color: self.rows(frame, Attribute::Color),
            offset: self.rows(frame, Attribute::Offset),
        }
    }

    /// An attribute of all Gaussians of a frame; C is its width.
    fn rows<const C: usize>(&self, frame: usize, attribute: Attribute) -> Vec<[f16; C]> {
        let mut numbers = Vec::new();
        let all = 0..self.avatar.gaussians.len();
        self.append_numbers(frame, attribute, all, &mut numbers);
        let rows = numbers.as_chunks::<C>().0.iter();
        rows.map(|row| row.map(f16::from_f32)).collect()
    }
}

/// Appends little-endian f16 at any alignment as f32.
fn append_halves(bytes: &[u8], out: &mut Vec<f32>) {
    let start = out.len();
    out.resize(start + bytes.len() / 2, 0.0);
    match bytemuck::try_cast_slice::<u8, f16>(bytes) {
        Ok(halves) => halves.convert_to_f32_slice(&mut out[start..]),
        Err(_) => {
            bytemuck::pod_collect_to_vec::<u8, f16>(bytes).convert_to_f32_slice(&mut out[start..])
        }
    }
}
