//! Writing the files that a command was asked for, with errors that name them.

use anyhow::Context;
use effigy_core::avatar::Avatar;
use effigy_formats::assumption::Assumption;
use serde::Serialize;
use std::{
    fs, io,
    path::{Path, PathBuf},
};

/// Writes a file. It appears at once and whole, beside or in place of an older one, whenever the
/// program is stopped.
pub fn write(path: &Path, bytes: impl AsRef<[u8]>) -> anyhow::Result<()> {
    replace(path, bytes.as_ref()).with_context(|| format!("{} can't be written", path.display()))
}

fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    // What is no file, as /dev/stdout, can't be replaced; a link stays one.
    if fs::symlink_metadata(path).is_ok_and(|found| !found.is_file()) {
        return fs::write(path, bytes);
    }
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}.part", std::process::id()));
    let part = path.with_file_name(name);
    let written = fs::write(&part, bytes).and_then(|()| fs::rename(&part, path));
    if written.is_err() {
        // It may not be there at all.
        let _ = fs::remove_file(&part);
    }
    written
}

/// Writes a value as indented JSON.
pub fn write_json(path: &Path, value: &impl Serialize) -> anyhow::Result<()> {
    write(path, serde_json::to_string_pretty(value)? + "\n")
}

/// What an avatar that was written has, in a line.
pub fn describe(avatar: &Avatar) -> String {
    if avatar.is_static() {
        let harmonics = match &avatar.sh {
            Some(sh) => format!("spherical harmonics of degree {}", sh.degree),
            None => "no spherical harmonics".into(),
        };
        return format!("{} Gaussians, {harmonics}", avatar.gaussians.len());
    }
    let parts = &avatar.parts;
    let rows = [
        avatar.rotation_rows.gaussian.len(),
        avatar.scale_rows.gaussian.len(),
        avatar.color_rows.gaussian.len(),
    ];
    format!(
        "{} Gaussians, {} parts ({} of the head), {} nodes, {} + {} + {} corrective rows, \
         {} joints",
        avatar.gaussians.len(),
        parts.len(),
        parts.head,
        avatar.nodes.len(),
        rows[0],
        rows[1],
        rows[2],
        avatar.skeleton.len(),
    )
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

/// A chart to write.
#[derive(Clone, Debug)]
pub enum ChartFile {
    Svg(PathBuf),
    Png(PathBuf),
}

/// Reads the name of a chart; its ending chooses the format.
pub fn chart(text: &str) -> Result<ChartFile, String> {
    let path = PathBuf::from(text);
    let ending = path
        .extension()
        .unwrap_or_default()
        .to_string_lossy()
        .to_ascii_lowercase();
    match ending.as_str() {
        "svg" => Ok(ChartFile::Svg(path)),
        "png" => Ok(ChartFile::Png(path)),
        _ => Err(format!("`{text}` ends in neither .svg nor .png")),
    }
}

/// Says what a file left open, and who can say otherwise.
pub fn print_assumptions(file: &Path, assumptions: &[Assumption]) {
    if assumptions.is_empty() {
        return;
    }
    eprintln!("{} leaves some things open; taken:", file.display());
    for assumption in assumptions {
        eprintln!("  {assumption}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_and_nothing_is_left_beside_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.json");
        for text in ["first", "second, and longer"] {
            write(&path, text).unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), text);
        }
        let error = write(&folder.path().join("none/a.json"), "x").unwrap_err();
        assert!(error.to_string().contains("none/a.json"), "{error}");
        // A folder can't be written to.
        assert!(write(folder.path(), "x").is_err());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_written_through() {
        let folder = tempfile::tempdir().unwrap();
        let [file, link] = ["file", "link"].map(|name| folder.path().join(name));
        fs::write(&file, "old").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        write(&link, "new").unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "new");
    }

    #[test]
    fn only_names_of_json_files_are_taken() {
        assert_eq!(json_path("out/a.JSON"), Ok(PathBuf::from("out/a.JSON")));
        assert!(json_path("body.avatar").is_err_and(|error| error.contains("body.avatar")));
    }
}
