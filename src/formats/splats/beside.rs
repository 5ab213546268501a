//! Files that a file refers to by name: beside it in a folder, or in the same archive.

use crate::zip_file::ZipFile;
use effigy_core::io::file::{FormatError, excerpt};
use std::{
    fs::File,
    io::Read,
    path::{Path, PathBuf},
};

/// Where a file finds those that it refers to.
pub trait Beside {
    /// Reads a file of at most `most` bytes.
    ///
    /// # Errors
    /// When there is no such file, it is longer, or the name leads elsewhere.
    fn file(&mut self, name: &str, most: u64) -> Result<Vec<u8>, FormatError>;
}

/// No file at all.
#[derive(Clone, Copy, Debug)]
pub struct Nothing;

impl Beside for Nothing {
    fn file(&mut self, name: &str, _: u64) -> Result<Vec<u8>, FormatError> {
        Err(missing(name, "no files beside this one"))
    }
}

/// The files of a folder and of folders in it.
#[derive(Clone, Debug)]
pub struct Folder(PathBuf);

impl Folder {
    /// The folder that a file is in.
    pub fn of(file: &Path) -> Self {
        Self(file.parent().unwrap_or(Path::new("")).to_owned())
    }
}

impl Beside for Folder {
    fn file(&mut self, name: &str, most: u64) -> Result<Vec<u8>, FormatError> {
        if !name.split('/').all(is_plain) {
            return Err(missing(name, "a name that leads elsewhere"));
        }
        let unreadable = |error: std::io::Error| missing(name, &error.to_string());
        let path = self.0.join(name);
        // A pipe or device could make a reader wait for ever.
        if !path.metadata().map_err(unreadable)?.is_file() {
            return Err(missing(name, "a folder or device"));
        }
        let file = File::open(path).map_err(unreadable)?;
        limited(file, most).map_err(|found| missing(name, &found))
    }
}

/// The files of a zip, from a folder in it.
pub struct Archive<'a> {
    zip: ZipFile<'a>,
    folder: String,
    /// Bytes that may still be unpacked.
    left: u64,
}

impl<'a> Archive<'a> {
    /// `folder`: its path in the zip, empty for the root; `left`: bytes that may be unpacked.
    pub fn new(zip: ZipFile<'a>, folder: &str, left: u64) -> Self {
        let folder = folder.trim_end_matches('/').to_owned();
        Self { zip, folder, left }
    }
}

impl Beside for Archive<'_> {
    fn file(&mut self, name: &str, most: u64) -> Result<Vec<u8>, FormatError> {
        let path = joined(&self.folder, name);
        let entry = self.zip.by_name(&path);
        let entry = entry.map_err(|error| missing(name, &error.to_string()))?;
        // An entry that says less than it has would pass by what was counted beforehand.
        let most = most.min(self.left).min(entry.size());
        let bytes = limited(entry, most).map_err(|found| missing(name, &found))?;
        self.left -= bytes.len() as u64;
        Ok(bytes)
    }
}

/// The files of a folder among those beside a file.
pub struct Inner<'a> {
    /// All of them.
    pub beside: &'a mut dyn Beside,
    /// The folder's path from there, empty for the same.
    pub folder: &'a str,
}

impl Beside for Inner<'_> {
    fn file(&mut self, name: &str, most: u64) -> Result<Vec<u8>, FormatError> {
        self.beside.file(&joined(self.folder, name), most)
    }
}

/// The path of a file in a folder.
fn joined(folder: &str, name: &str) -> String {
    if folder.is_empty() {
        name.to_owned()
    } else {
        format!("{folder}/{name}")
    }
}

/// Whether a name, of a file or a folder, stays in its folder on every system.
fn is_plain(name: &str) -> bool {
    !name.is_empty() && !name.starts_with('.') && !name.contains(['/', '\\', ':', '\0'])
}

/// Reads at most `most` bytes; more are an error.
///
/// # Errors
/// What was found instead, when the reader fails or has more.
pub fn limited(reader: impl Read, most: u64) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let read = reader.take(most.saturating_add(1)).read_to_end(&mut bytes);
    read.map_err(|error| error.to_string())?;
    if bytes.len() as u64 > most {
        return Err(format!("more than {most} bytes"));
    }
    Ok(bytes)
}

/// A file that is referred to can't be read.
pub fn missing(name: &str, found: &str) -> FormatError {
    FormatError::container(
        format!("{found} for `{}`", excerpt(name)),
        "a file of that name, of a plausible size",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stay_in_their_folder() {
        for name in [
            "",
            "..",
            "../a",
            "/etc/passwd",
            "a/b",
            "a\\b",
            "C:a",
            ".git",
            "a\0",
        ] {
            assert!(!is_plain(name), "{name}");
        }
        assert!(is_plain("means_l.webp") && is_plain("scene 1.bin"));
    }
}
