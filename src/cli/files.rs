//! Reading files, with errors that name them, and saying what they have.

use anyhow::Context;
use effigy_core::avatar::Avatar;
use effigy_formats::assumption::Assumption;
use std::{fs, path::Path};

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
