//! What the files of a folder are, a line each.

use super::{
    checkpoint::CheckpointSummary,
    text::{line, thousands},
};
use crate::files;
use anyhow::Context;
use effigy_core::{avatar::Avatar, io::file::FileContent};
use effigy_formats::{
    content::Content,
    open::{self, CaptureOptions, OpenOptions},
};
use serde::Serialize;
use std::{
    fmt,
    path::{Path, PathBuf},
};

/// Files of a folder and of those in it that are listed; the rest is counted.
const LISTED: usize = 1000;
/// Folders below the one that was named.
const DEPTH: usize = 3;

/// The files that Effigy reads, in the order of their names.
#[derive(Serialize)]
pub struct FolderSummary {
    kind: &'static str,
    files: Vec<ListedFile>,
    /// Files that are something else, or that were not looked at.
    others: usize,
}

/// A file.
#[derive(Serialize)]
struct ListedFile {
    #[serde(skip)]
    path: PathBuf,
    name: String,
    kind: &'static str,
    bytes: u64,
    /// What it contains, or what is wrong with it.
    content: String,
    /// Whether something is wrong.
    broken: bool,
}

impl FolderSummary {
    pub fn new(folder: &Path) -> anyhow::Result<Self> {
        let mut paths = vec![];
        list(folder, DEPTH, &mut paths)
            .with_context(|| format!("cannot read {}", folder.display()))?;
        paths.sort();
        let looked_at = &paths[..paths.len().min(LISTED)];
        let files: Vec<ListedFile> = looked_at
            .iter()
            .filter_map(|path| ListedFile::new(path, folder))
            .collect();
        Ok(Self {
            kind: "folder",
            others: paths.len() - files.len(),
            files,
        })
    }

    /// The files that are listed.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.files.iter().map(|file| file.path.as_path())
    }
}

/// The files of a folder and of those in it; links to folders are not followed.
fn list(folder: &Path, depth: usize, paths: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?;
        let kind = entry.file_type()?;
        if kind.is_file() {
            paths.push(entry.path());
        } else if kind.is_dir() && depth > 0 {
            // What can't be read is not listed.
            let _ = list(&entry.path(), depth - 1, paths);
        }
    }
    Ok(())
}

impl ListedFile {
    /// None: it is nothing that Effigy reads.
    fn new(path: &Path, folder: &Path) -> Option<Self> {
        let content = open::content(path);
        let read = match content.kind() {
            Some(kind) => Read {
                kind,
                content: foreign(path, content),
            },
            None => own(path)?,
        };
        Some(Self {
            path: path.to_owned(),
            name: path
                .strip_prefix(folder)
                .unwrap_or(path)
                .display()
                .to_string(),
            kind: read.kind,
            bytes: path.metadata().map_or(0, |data| data.len()),
            broken: read.content.is_err(),
            content: read.content.unwrap_or_else(|error| error),
        })
    }
}

/// What a file was found to be.
struct Read {
    kind: &'static str,
    content: Result<String, String>,
}

/// A file of another program.
fn foreign(path: &Path, content: Content) -> Result<String, String> {
    // Errors name the file, which the list does already.
    let short = |error: &dyn fmt::Display| {
        let text = error.to_string();
        let name = format!("{}: ", path.display());
        text.strip_prefix(&name).unwrap_or(&text).to_owned()
    };
    if content.is_motion() {
        let read = open::capture(path, &CaptureOptions::default());
        return read
            .map(|captured| {
                let capture = &captured.capture;
                format!(
                    "{} joints, {} frames at {:.2} per second",
                    capture.joints.len(),
                    thousands(capture.frames()),
                    capture.rate
                )
            })
            .map_err(|error| short(&error));
    }
    if content == Content::Checkpoint {
        let read = open::checkpoint(path, &Default::default(), |checkpoint| {
            CheckpointSummary::new(&checkpoint).brief()
        });
        return read.map_err(|error| short(&error));
    }
    let read = open::avatar(path, &OpenOptions::default());
    let describe = |avatar: &Avatar| {
        if avatar.is_static() {
            format!("{} Gaussians", thousands(avatar.gaussians.len()))
        } else {
            files::describe(avatar)
        }
    };
    read.map(|imported| describe(&imported.avatar))
        .map_err(|error| short(&error))
}

/// A file of Effigy's own; None: it is none.
fn own(path: &Path) -> Option<Read> {
    let named = |ending: &str| path.extension().is_some_and(|own| own == ending);
    match FileContent::read(path) {
        Ok(FileContent::Avatar(avatar)) => Some(Read {
            kind: "avatar",
            content: Ok(files::describe(&avatar)),
        }),
        Ok(FileContent::Clip(clip)) => Some(Read {
            kind: "motion",
            content: Ok(format!(
                "{} joints, {} frames at {:.2} per second",
                clip.joint.len(),
                thousands(clip.frames()),
                clip.rate
            )),
        }),
        Err(error) if named("avatar") || named("motion") => Some(Read {
            kind: if named("avatar") { "avatar" } else { "motion" },
            content: Err(open::unknown(path, error).to_string()),
        }),
        Err(_) => None,
    }
}

impl fmt::Display for FolderSummary {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let found = format!(
            "{} that Effigy reads, {} others",
            self.files.len(),
            self.others
        );
        line(f, "files", found)?;
        let width = self.files.iter().map(|file| file.name.chars().count());
        let width = width.max().unwrap_or(0).min(48);
        for ListedFile {
            name,
            kind,
            content,
            broken,
            ..
        } in &self.files
        {
            let mark = if *broken { "broken: " } else { "" };
            writeln!(f, "{name:<width$}  {kind:<18} {mark}{content}")?;
        }
        Ok(())
    }
}
