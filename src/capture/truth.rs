//! `truth.json`: what errors were put into a capture, for evaluation alone.

use crate::{
    calibration::{CaptureCalibration, CaptureCamera},
    error::{CaptureError, content, fault, read_bytes, unwritable},
    limits,
};
use effigy_core::{
    avatar::Pose,
    io::file::{excerpt, replace},
};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::{fs, io::ErrorKind, path::Path};

/// The file's name.
const FILE: &str = "truth.json";

/// The true values of a capture that was made with errors.
#[derive(Clone, Debug, PartialEq)]
pub struct Truth {
    /// In the calibration's order.
    pub cameras: Vec<TruthCamera>,
    /// Of each frame by number.
    pub poses: Vec<Pose>,
}

/// A camera as it was.
#[derive(Clone, Debug, PartialEq)]
pub struct TruthCamera {
    /// The camera that the pictures were shot with.
    pub camera: CaptureCamera,
    /// What linear red, green and blue were multiplied with.
    pub gain: [f64; 3],
    /// Standard deviation of the blur, px.
    pub blur: f64,
}

/// The document.
#[derive(Deserialize, Serialize)]
#[serde(rename = "Document")]
struct TruthDocument {
    calibration: CaptureCalibration,
    /// A camera, in the calibration's order.
    gain: Vec<[f64; 3]>,
    blur: Vec<f64>,
    /// Frames, joints, axis-angle.
    poses: Vec<Vec<[f64; 3]>>,
    transl: Vec<[f64; 3]>,
    expression: Vec<Vec<f64>>,
}

impl Truth {
    /// The truth of a capture's folder; None where it has no such file.
    ///
    /// # Errors
    /// When the file can't be read or breaks its format.
    pub fn read(folder: &Path) -> Result<Option<Self>, CaptureError> {
        let file = folder.join(FILE);
        if !file.exists() {
            return Ok(None);
        }
        let bytes = read_bytes(&file, limits::TEXT)?;
        let document: TruthDocument = serde_json::from_slice(&bytes).map_err(|error| {
            content(
                &file,
                excerpt(&error.to_string()),
                "a capture's true values",
            )
        })?;
        let cameras = document.calibration.cameras.len();
        let frames = document.poses.len();
        let counts = [document.gain.len(), document.blur.len()];
        if counts != [cameras; 2]
            || [document.transl.len(), document.expression.len()] != [frames; 2]
        {
            return Err(content(
                &file,
                "lists of several lengths",
                "as many of each",
            ));
        }
        let mut found = Self {
            cameras: vec![],
            poses: vec![],
        };
        let own = document.gain.into_iter().zip(document.blur);
        for (named, (gain, blur)) in document.calibration.cameras.iter().zip(own) {
            let size = named.entry.size().unwrap_or([1, 1]);
            let camera = named
                .entry
                .camera(&named.name, size)
                .map_err(|e| fault(&file, e))?;
            found.cameras.push(TruthCamera { camera, gain, blur });
        }
        let numbers = document.transl.into_iter().zip(document.expression);
        for (rotation, (translation, expression)) in document.poses.into_iter().zip(numbers) {
            found.poses.push(Pose {
                rotation: rotation.into_iter().map(DVec3::from).collect(),
                translation: translation.into(),
                expression,
            });
        }
        Ok(Some(found))
    }

    /// Removes an earlier capture's file from a folder.
    ///
    /// # Errors
    /// When there is one and it can't be removed.
    pub fn remove(folder: &Path) -> Result<(), CaptureError> {
        let file = folder.join(FILE);
        match fs::remove_file(&file) {
            Err(cause) if cause.kind() != ErrorKind::NotFound => Err(unwritable(&file, cause)),
            _ => Ok(()),
        }
    }

    /// Writes the file into a capture's folder.
    ///
    /// # Errors
    /// When it can't be written.
    pub fn write(&self, folder: &Path) -> Result<(), CaptureError> {
        let cameras: Vec<CaptureCamera> =
            self.cameras.iter().map(|own| own.camera.clone()).collect();
        let document = TruthDocument {
            calibration: CaptureCalibration::of(&cameras),
            gain: self.cameras.iter().map(|own| own.gain).collect(),
            blur: self.cameras.iter().map(|own| own.blur).collect(),
            poses: self
                .poses
                .iter()
                .map(|pose| pose.rotation.iter().map(|turn| turn.to_array()).collect())
                .collect(),
            transl: self
                .poses
                .iter()
                .map(|pose| pose.translation.to_array())
                .collect(),
            expression: self
                .poses
                .iter()
                .map(|pose| pose.expression.clone())
                .collect(),
        };
        let file = folder.join(FILE);
        let text = serde_json::to_string(&document)
            .map_err(|error| content(&file, error, "finite numbers"))?;
        Ok(replace(&file, text.as_bytes())?)
    }
}
