//! A capture's cameras, frames and pictures.

use crate::{
    calibration::CaptureCamera,
    decode::PictureFiles,
    error::{CaptureError, fault},
    left_out::{MaskLook, Omission},
    mask::MaskRule,
    picture::{FaultyFile, Picture},
    template::Template,
};
use effigy_core::avatar::Pose;
use effigy_formats::assumption::Assumption;
use std::path::PathBuf;

/// A capture, opened.
#[derive(Clone, Debug)]
pub struct Capture {
    /// Where it is.
    pub folder: PathBuf,
    /// Cameras that can be used, in the calibration's order.
    pub cameras: Vec<CaptureCamera>,
    /// Frames that have a pose and at least one picture, by number.
    pub frames: Vec<CaptureFrame>,
    /// The body model.
    pub template: Template,
    /// What can't be used, and why.
    pub left_out: Vec<Omission>,
    /// What its files leave open, and what was taken.
    pub assumptions: Vec<Assumption>,
    /// What a look at some masks found.
    pub masks: MaskLook,
    /// What the numbers in each camera's masks mean.
    pub(crate) rules: Vec<MaskRule>,
    /// The files of each camera's picture of each frame: shape frames, cameras.
    pub(crate) files: Vec<Option<PictureFiles>>,
}

/// A moment of a capture.
#[derive(Clone, Debug, PartialEq)]
pub struct CaptureFrame {
    /// Number in the pictures' names, and row of the poses.
    pub number: u32,
    /// Of [`Capture::template`].
    pub pose: Pose,
    /// Held out from training.
    pub held: bool,
}

impl Capture {
    pub(crate) fn unless_empty(self) -> Result<Self, CaptureError> {
        if self.frames.is_empty() {
            return Err(CaptureError::Empty {
                folder: self.folder,
                left_out: self.left_out,
            });
        }
        Ok(self)
    }

    /// Whether there is a picture of a frame by a camera, both by index.
    pub fn has(&self, camera: usize, frame: usize) -> bool {
        self.files_of(camera, frame).is_some()
    }

    /// Pictures that can be used.
    pub fn pictures(&self) -> usize {
        self.files.iter().flatten().count()
    }

    pub(crate) fn files_of(&self, camera: usize, frame: usize) -> Option<&PictureFiles> {
        if camera >= self.cameras.len() {
            return None;
        }
        self.files
            .get(frame * self.cameras.len() + camera)?
            .as_ref()
    }

    /// Decodes a picture and its mask, without the lens's distortion. Indices into
    /// [`Self::cameras`] and [`Self::frames`].
    ///
    /// # Errors
    /// When there is none, or a file is cut or has changed its size since.
    pub fn picture(&self, camera: usize, frame: usize) -> Result<Picture, CaptureError> {
        let Some(files) = self.files_of(camera, frame) else {
            return Err(CaptureError::NoPicture { camera, frame });
        };
        Picture::read(files, &self.cameras[camera], self.rules[camera]).map_err(|found| match found
        {
            FaultyFile::Picture(found) => fault(&files.picture, found),
            FaultyFile::Mask(found) => fault(&files.mask, found),
        })
    }

    /// The capture without what [`Self::check`] found, which is then in [`Self::left_out`].
    ///
    /// # Errors
    /// When no frame is left.
    pub fn without(mut self, found: Vec<Omission>) -> Result<Self, CaptureError> {
        let count = self.cameras.len();
        for fault in &found {
            let camera = fault.camera.as_ref();
            for (at, frame) in self.frames.iter().enumerate() {
                if fault.frame.is_some_and(|number| number != frame.number) {
                    continue;
                }
                for (k, own) in self.cameras.iter().enumerate() {
                    if camera.is_none_or(|name| *name == own.name) {
                        self.files[at * count + k] = None;
                    }
                }
            }
        }
        self.left_out.extend(found);
        let seen: Vec<bool> = self
            .files
            .chunks(count.max(1))
            .map(|row| row.iter().any(Option::is_some))
            .collect();
        let rows: Vec<Vec<Option<PictureFiles>>> = self
            .files
            .chunks(count.max(1))
            .zip(&seen)
            .filter(|(_, seen)| **seen)
            .map(|(row, _)| row.to_vec())
            .collect();
        self.files = rows.concat();
        let mut seen = seen.into_iter();
        self.frames.retain(|_| seen.next().unwrap_or(false));
        self.unless_empty()
    }
}
