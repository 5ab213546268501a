//! Frames in; a dataset's folder out. The header is written last: without it there is no dataset.

use super::{Attribute, Error, FORMAT, Frame, Header, Shot, VERSION, frame_name};
use crate::avatar::file::{FileError, replace};
use crate::avatar::{Avatar, Clip};
use safetensors::{Dtype, tensor::TensorView};
use std::path::{Path, PathBuf};

/// Of so many blocks of time, one is held out.
const BLOCKS: usize = 5;

/// Which moments of some clips become frames: `count` of them, evenly spaced over all. Every fifth block of `block` seconds of each clip is
/// held out.
pub fn plan(clips: &[Clip], count: usize, block: f64) -> Vec<(usize, Shot)> {
    let whole: f64 = clips.iter().map(Clip::duration).sum();
    let step = (whole / count.max(1) as f64).max(1e-9);
    let mut shots = Vec::with_capacity(count);
    let mut begun = 0.0;
    for (c, clip) in clips.iter().enumerate() {
        let end = begun + clip.duration();
        while shots.len() < count && step * (shots.len() as f64 + 0.5) <= end {
            let seconds = step * (shots.len() as f64 + 0.5) - begun;
            let held = (seconds / block.max(1e-3)) as usize % BLOCKS == BLOCKS / 2;
            shots.push((c, Shot { clip: clip.name.clone(), seconds, held }));
        }
        begun = end;
    }
    shots
}

/// A dataset in the making.
pub struct Writer {
    folder: PathBuf,
    header: Header,
}

impl Writer {
    /// Begins a dataset of an avatar; `poses` has a frame for each of `frames`.
    ///
    /// # Errors
    /// When the folder or a file in it cannot be written.
    pub fn new(folder: &Path, avatar: &Avatar, poses: &Clip, frames: Vec<Shot>) -> Result<Self, Error> {
        std::fs::create_dir_all(folder).map_err(|cause| Error::Write { file: folder.into(), cause })?;
        let old = folder.join("dataset.json");
        if old.exists() {
            std::fs::remove_file(&old).map_err(|cause| Error::Write { file: old, cause })?;
        }
        avatar.write(&folder.join("neutral.avatar"))?;
        poses.write(&folder.join("poses.motion"))?;
        let name = folder.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let (gaussians, credit) = (avatar.gaussians.len(), format!("{} {}", avatar.credit, poses.credit));
        Ok(Self { folder: folder.into(), header: Header { format: FORMAT.into(), version: VERSION, name, credit, gaussians, frames } })
    }

    /// # Errors
    /// When the file cannot be written.
    pub fn frame(&self, number: usize, frame: &Frame) -> Result<(), Error> {
        let path = self.folder.join(frame_name(number));
        let columns: [&[u8]; 4] = [
            bytemuck::cast_slice(&frame.rotation),
            bytemuck::cast_slice(&frame.log_scale),
            bytemuck::cast_slice(&frame.color),
            bytemuck::cast_slice(&frame.offset),
        ];
        let refused = |error: safetensors::SafeTensorError| Error::Write { file: path.clone(), cause: std::io::Error::other(error) };
        let mut views = Vec::new();
        for (attribute, bytes) in Attribute::ALL.into_iter().zip(columns) {
            let shape = vec![self.header.gaussians, attribute.width()];
            views.push((attribute.name(), TensorView::new(Dtype::F16, shape, bytes).map_err(refused)?));
        }
        let bytes = safetensors::serialize(views, None).map_err(refused)?;
        Ok(replace(&path, &bytes)?)
    }

    /// # Errors
    /// When the header cannot be written.
    pub fn finish(self) -> Result<(), Error> {
        let path = self.folder.join("dataset.json");
        let text = serde_json::to_string_pretty(&self.header).expect("strings and numbers always have a JSON form");
        replace(&path, text.as_bytes()).map_err(|error: FileError| error.into())
    }
}
