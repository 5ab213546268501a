//! What every layout's reader gives, and the errors that they share.

use crate::assumption::Assumption;
use effigy_core::{
    io::file::{FileError, FormatError, excerpt},
    scene::Camera,
};
use std::path::{Path, PathBuf};

/// What can be read.
pub const KNOWN: &str = "cameras.json as 3DGS or mmlphuman writes it, transforms.json with `frames`, or COLMAP's \
     cameras.txt and images.txt";

/// The cameras of a file, at least one, and what was taken where it leaves something open.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenedCameras {
    /// In the world of [`super::read`].
    pub cameras: Vec<Camera>,
    /// One for each decision, however many cameras it concerns.
    pub assumptions: Vec<Assumption>,
}

/// JSON that can't be parsed, or has another shape.
pub fn not_json(error: &serde_json::Error) -> FormatError {
    FormatError::container(excerpt(&error.to_string()), KNOWN)
}

/// A file's bytes.
pub fn bytes(path: &Path) -> Result<Vec<u8>, FileError> {
    std::fs::read(path).map_err(|cause| FileError::Read {
        file: path.into(),
        cause,
    })
}

/// What is wrong with a file's content.
pub fn content(path: impl Into<PathBuf>, fault: FormatError) -> FileError {
    FileError::Content {
        file: path.into(),
        fault,
    }
}

/// Whether coefficients of a lens distort: those that add up to next to nothing don't.
pub fn distorts<'a>(coefficients: impl IntoIterator<Item = &'a f64>) -> bool {
    let sum: f64 = coefficients.into_iter().map(|k| k.abs()).sum();
    sum >= 1e-4
}

/// That lenses distort, which pictures that are drawn don't. None: none does.
pub fn distortion(distorts: bool) -> Option<Assumption> {
    distorts.then(|| Assumption {
        what: "distortion of the lens",
        taken: "left out".into(),
        because: "images are drawn as a pinhole sees them".into(),
    })
}
