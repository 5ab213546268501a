//! Writing the files that a command was asked for, with errors that name them.

use anyhow::Context;
use serde::Serialize;
use std::{
    fs,
    path::{Path, PathBuf},
};

/// Writes a file.
pub fn write(path: &Path, bytes: impl AsRef<[u8]>) -> anyhow::Result<()> {
    fs::write(path, bytes).with_context(|| format!("{} can't be written", path.display()))
}

/// Writes a value as indented JSON.
pub fn write_json(path: &Path, value: &impl Serialize) -> anyhow::Result<()> {
    write(path, serde_json::to_string_pretty(value)? + "\n")
}

/// Reads a text file.
pub fn read_text(path: &Path) -> anyhow::Result<String> {
    fs::read_to_string(path).with_context(|| format!("{} can't be read", path.display()))
}

/// Makes a folder and those above it, where they are missing.
pub fn create_folder(path: &Path) -> anyhow::Result<()> {
    fs::create_dir_all(path).with_context(|| format!("{} can't be made", path.display()))
}

/// Whether a file's name ends in `.json`, in any case.
fn is_json(path: &Path) -> bool {
    path.extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("json"))
}

/// Reads the name of a file to write. It must end in `.json`: `--trace body.avatar` would overwrite
/// an avatar.
pub fn json_path(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    if is_json(&path) {
        Ok(path)
    } else {
        Err(format!("`{text}` does not end in .json"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_names_of_json_files_are_taken() {
        assert_eq!(json_path("out/a.JSON"), Ok(PathBuf::from("out/a.JSON")));
        assert!(json_path("body.avatar").is_err_and(|error| error.contains("body.avatar")));
    }
}
