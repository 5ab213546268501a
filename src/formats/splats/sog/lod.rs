//! `lod-meta.json` of a streamed SOG: a tree whose leaves have their splats at several levels, 0 the
//! finest, each a range of the splats of a SOG beside it.

use super::{
    LOD_META,
    document::wrong,
    read::{in_folder, in_plain_archive},
    zipped::Zipped,
};
use crate::{
    assumption::Assumption,
    splats::beside::{Beside, Inner},
    zip_file::is_zip,
};
use effigy_core::{
    avatar::limits,
    io::{
        file::{FormatError, excerpt},
        splats::{Found, Splats, check_count},
        text,
    },
};
use serde::Deserialize;
use std::{
    collections::{BTreeMap, BTreeSet},
    ops::Range,
};

/// Longest document, bytes, and its objects, at most: each takes more memory than its text.
const MAX: u64 = 16 << 20;
/// Levels of detail, at most: the tree is walked for each.
const LEVELS: usize = 64;
const OBJECTS: usize = 200_000;
/// Longest SOG of a part, bytes.
const MAX_PART: u64 = 256 << 20;

#[derive(Deserialize)]
struct LodDocument {
    filenames: Vec<String>,
    /// A SOG of what is around the scene.
    #[serde(default)]
    environment: Option<String>,
    tree: LodNode,
}

#[derive(Deserialize)]
struct LodNode {
    #[serde(default)]
    children: Vec<LodNode>,
    /// By level.
    #[serde(default)]
    lods: BTreeMap<u32, SplatRange>,
}

/// Splats of a file.
#[derive(Clone, Copy, Deserialize)]
struct SplatRange {
    file: usize,
    offset: usize,
    count: usize,
}

impl LodNode {
    /// Adds the levels that leaves have, until there are more than [`LEVELS`].
    fn levels(&self, levels: &mut BTreeSet<u32>) {
        levels.extend(self.lods.keys());
        for child in &self.children {
            if levels.len() <= LEVELS {
                child.levels(levels);
            }
        }
    }

    /// What each leaf has at a level, or at the finest below.
    fn runs(&self, level: u32, runs: &mut Vec<SplatRange>) {
        runs.extend(self.lods.range(level..).next().map(|(_, run)| *run));
        for child in &self.children {
            child.runs(level, runs);
        }
    }
}

/// Reads a `.sog`, whose files may be in a folder, and which may have levels of detail.
///
/// # Errors
/// When the bytes are no zip or hold no SOG.
pub fn in_archive(bytes: &[u8]) -> Result<Found, FormatError> {
    let zip = Zipped::new(bytes)?;
    match zip.folder_of(LOD_META) {
        None => Ok(in_plain_archive(bytes)?.into()),
        Some(folder) => {
            let mut files = zip.files(&folder);
            let meta = files.file(LOD_META, MAX)?;
            read(&meta, &mut files)
        }
    }
}

/// The finest level that an avatar holds beside `more` splats, and its runs.
fn finest(document: &LodDocument, more: usize) -> Result<(u32, Vec<SplatRange>), FormatError> {
    let mut levels = BTreeSet::from([0]);
    document.tree.levels(&mut levels);
    if levels.len() > LEVELS {
        let found = format!("more than {LEVELS} levels of detail");
        return Err(wrong("tree", found, "fewer"));
    }
    let mut fault = None;
    for level in levels {
        let mut runs = vec![];
        document.tree.runs(level, &mut runs);
        let counts = runs.iter().map(|run| run.count as u64);
        let count = counts.fold(more as u64, u64::saturating_add);
        match check_count(count) {
            Ok(()) => return Ok((level, runs)),
            Err(found) => fault = Some(found),
        }
    }
    Err(fault.unwrap_or_else(|| wrong("tree", "no levels", "some")))
}

/// Reads the finest level that an avatar holds. `files` has the SOGs.
///
/// # Errors
/// When the document or a SOG breaks a rule, or no level is small enough.
pub fn read(meta: &[u8], files: &mut dyn Beside) -> Result<Found, FormatError> {
    let document = parse(meta)?;
    let around = match &document.environment {
        Some(name) => Some(part(name, files)?),
        None => None,
    };
    let (level, runs) = finest(&document, around.as_ref().map_or(0, Splats::len))?;
    let mut of_file: BTreeMap<&str, Vec<Range<usize>>> = BTreeMap::new();
    for SplatRange {
        file,
        offset,
        count,
    } in runs
    {
        let names = &document.filenames;
        let name = names.get(file).ok_or_else(|| {
            wrong(
                "tree",
                format!("file {file}"),
                format!("one of {}", names.len()),
            )
        })?;
        let end = offset.saturating_add(count);
        of_file.entry(name).or_default().push(offset..end);
    }
    let mut all: Option<Splats> = None;
    let mut add = |splats: Splats| {
        all = Some(match all.take() {
            None => splats,
            Some(before) => before.joined(splats),
        });
    };
    for (name, mut ranges) in of_file {
        let splats = part(name, files)?;
        ranges.sort_by_key(|range| range.start);
        if ranges.iter().any(|range| range.end > splats.len()) {
            let found = format!("splats beyond the {} of `{}`", splats.len(), excerpt(name));
            return Err(wrong("tree", found, "those that it has"));
        }
        let whole = ranges.iter().map(Range::len).sum::<usize>() == splats.len();
        if whole {
            add(splats);
        } else {
            ranges.into_iter().for_each(|range| add(splats.part(range)));
        }
    }
    if let Some(around) = around {
        add(around);
    }
    let splats = all.ok_or_else(|| wrong("tree", "no splats", "some"))?;
    let taken = Assumption {
        what: "level of detail",
        taken: level.to_string(),
        because: match level {
            0 => "it is the finest".into(),
            _ => format!("finer ones have more than {} splats", limits::GAUSSIANS),
        },
    };
    Ok(Found {
        splats,
        assumptions: vec![taken],
    })
}

fn parse(meta: &[u8]) -> Result<LodDocument, FormatError> {
    let objects = meta.iter().filter(|byte| **byte == b'{').count();
    if meta.len() as u64 > MAX || objects > OBJECTS {
        return Err(FormatError::container(
            format!(
                "a lod-meta.json of {} bytes and {objects} objects",
                meta.len()
            ),
            format!("at most {MAX} and {OBJECTS}"),
        ));
    }
    serde_json::from_slice(&text::utf8(meta)).map_err(|error| {
        FormatError::container(
            format!("a lod-meta.json that can't be read: {error}"),
            "that of a streamed SOG, or one of its meta.json",
        )
    })
}

/// A SOG beside the document: a `meta.json` in a folder, or a zip.
fn part(name: &str, files: &mut dyn Beside) -> Result<Splats, FormatError> {
    let bytes = files.file(name, MAX_PART).map_err(|_| {
        FormatError::container(
            format!("a lod-meta.json without its file `{}`", excerpt(name)),
            "the whole folder of a streamed SOG, or one of its meta.json",
        )
    })?;
    if is_zip(&bytes) {
        return in_plain_archive(&bytes);
    }
    let folder = name.rsplit_once('/').map_or("", |(folder, _)| folder);
    let mut inner = Inner {
        beside: files,
        folder,
    };
    in_folder(&bytes, &mut inner)
}
