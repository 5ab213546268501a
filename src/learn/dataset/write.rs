//! Writing a dataset's folder. The header is written last: without it there is no dataset.

use crate::dataset::format::{
    AVATAR_FILE, Attribute, DatasetHeader, FORMAT, FrameAttributes, HEADER_FILE, LearnError,
    POSES_FILE, Shot, VERSION, frame_name,
};
use effigy_core::avatar::{Avatar, Clip};
use effigy_core::io::file::replace;
use safetensors::{Dtype, tensor::TensorView};
use std::path::{Path, PathBuf};

/// One in so many blocks of time is held out, the middle one.
const BLOCKS: usize = 5;

/// Which moments of some clips become frames: `count` of them, evenly spaced over all clips, each
/// with the index of its clip. Every fifth block of `block` seconds of each clip is held out.
pub fn plan_frames(clips: &[Clip], count: usize, block: f64) -> Vec<(usize, Shot)> {
    let whole: f64 = clips.iter().map(Clip::duration).sum();
    let step = (whole / count.max(1) as f64).max(1e-9);
    let mut shots = Vec::with_capacity(count);
    let mut begun = 0.0;
    for (index, clip) in clips.iter().enumerate() {
        let end = begun + clip.duration();
        while shots.len() < count && step * (shots.len() as f64 + 0.5) <= end {
            let seconds = step * (shots.len() as f64 + 0.5) - begun;
            let held = (seconds / block.max(1e-3)) as usize % BLOCKS == BLOCKS / 2;
            let shot = Shot {
                clip: clip.name.clone(),
                seconds,
                held,
            };
            shots.push((index, shot));
        }
        begun = end;
    }
    shots
}

/// A dataset in the making. Write every frame, then [`finish`](Self::finish) it.
pub struct DatasetWriter {
    folder: PathBuf,
    header: DatasetHeader,
}

impl DatasetWriter {
    /// Begins a dataset of an avatar; `poses` has a frame for each of `frames`.
    ///
    /// # Errors
    /// When the folder or a file in it cannot be written.
    pub fn new(
        folder: &Path,
        avatar: &Avatar,
        poses: &Clip,
        frames: Vec<Shot>,
    ) -> Result<Self, LearnError> {
        std::fs::create_dir_all(folder).map_err(|cause| LearnError::Write {
            file: folder.into(),
            cause,
        })?;
        let old = folder.join(HEADER_FILE);
        if old.exists() {
            std::fs::remove_file(&old).map_err(|cause| LearnError::Write { file: old, cause })?;
        }
        avatar.write(&folder.join(AVATAR_FILE))?;
        poses.write(&folder.join(POSES_FILE))?;
        let name = folder
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        Ok(Self {
            folder: folder.into(),
            header: DatasetHeader {
                format: FORMAT.into(),
                version: VERSION,
                name,
                credit: format!("{} {}", avatar.credit, poses.credit),
                gaussians: avatar.gaussians.len(),
                frames,
            },
        })
    }

    /// Writes a frame; frames may come in any order.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write_frame(&self, number: usize, frame: &FrameAttributes) -> Result<(), LearnError> {
        let path = self.folder.join(frame_name(number));
        let columns: [&[u8]; 4] = [
            bytemuck::cast_slice(&frame.rotation),
            bytemuck::cast_slice(&frame.log_scale),
            bytemuck::cast_slice(&frame.color),
            bytemuck::cast_slice(&frame.offset),
        ];
        let refused = |error: safetensors::SafeTensorError| LearnError::Write {
            file: path.clone(),
            cause: std::io::Error::other(error),
        };
        let mut views = Vec::new();
        for (attribute, bytes) in Attribute::ALL.into_iter().zip(columns) {
            let shape = vec![self.header.gaussians, attribute.width()];
            views.push((
                attribute.name(),
                TensorView::new(Dtype::F16, shape, bytes).map_err(refused)?,
            ));
        }
        let bytes = safetensors::serialize(views, None).map_err(refused)?;
        Ok(replace(&path, &bytes)?)
    }

    /// Writes the header, which makes the folder a dataset.
    ///
    /// # Errors
    /// When the header cannot be written.
    pub fn finish(self) -> Result<(), LearnError> {
        let path = self.folder.join(HEADER_FILE);
        let text = serde_json::to_string_pretty(&self.header)
            .expect("strings and numbers always have a JSON form");
        Ok(replace(&path, text.as_bytes())?)
    }
}
