//! Which cameras and frames are held out from training.

use crate::{
    error::{CaptureError, content, read_bytes},
    limits,
};
use effigy_core::io::{file::excerpt, text};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The file's name.
pub const FILE: &str = "split.json";

/// What is held out; the document `split.json`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Split {
    /// Names of cameras.
    #[serde(default)]
    pub cameras: Vec<String>,
    /// Numbers of frames.
    #[serde(default)]
    pub frames: Vec<u32>,
}

impl Split {
    /// The split of a folder. Nothing is held out where it has no such file.
    pub fn read(folder: &Path) -> Result<Self, CaptureError> {
        let file = folder.join(FILE);
        if !file.exists() {
            return Ok(Self::default());
        }
        let bytes = read_bytes(&file, limits::TEXT)?;
        serde_json::from_slice(&text::utf8(&bytes)).map_err(|error| {
            let expected = "names in `cameras` and numbers in `frames`";
            content(&file, excerpt(&error.to_string()), expected)
        })
    }

    /// Fails where it names a camera that the calibration lacks.
    pub fn expect_names<'a>(
        &self,
        folder: &Path,
        names: impl Iterator<Item = &'a str> + Clone,
    ) -> Result<(), CaptureError> {
        for held in &self.cameras {
            if !names.clone().any(|name| name == held) {
                let found = format!("camera `{}`", excerpt(held));
                return Err(content(
                    &folder.join(FILE),
                    found,
                    "names of the calibration",
                ));
            }
        }
        Ok(())
    }
}
