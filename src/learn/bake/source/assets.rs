//! The folder of source files.

use std::path::PathBuf;

/// The folder of source files.
#[derive(Clone, Debug)]
pub struct Assets {
    root: PathBuf,
}

impl Assets {
    /// The folder that `tools/fetch_assets.sh` fills if it is given none.
    pub const DEFAULT: &str = "target/assets";

    /// Reads nothing yet.
    pub fn new(root: impl Into<PathBuf>) -> Self {
        Self { root: root.into() }
    }

    /// The path of a source file.
    pub fn path(&self, name: &str) -> PathBuf {
        self.root.join(name)
    }
}
