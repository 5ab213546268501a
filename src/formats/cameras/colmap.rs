//! COLMAP's text files: `cameras.txt` says how cameras see, `images.txt` where each image was taken.

use super::opened::{KNOWN, OpenedCameras, content, distortion, distorts};
use crate::source::Source;
use effigy_core::io::{
    cameras::{PlacedCamera, cameras_of},
    file::{FileError, FormatError, excerpt},
    text,
};
use glam::{DAffine3, DMat3, DQuat, DVec3};
use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
};

/// Where a model's text files are in a folder.
const FOLDERS: [&str; 3] = ["", "sparse/0", "sparse"];

/// A model of COLMAP that is a pinhole, with or without distortion.
struct ColmapModel {
    name: &'static str,
    /// It has a focal length for each axis.
    two_focals: bool,
    /// Numbers of its distortion, which come last.
    distortion: usize,
}

const MODELS: [ColmapModel; 6] = [
    ColmapModel {
        name: "SIMPLE_PINHOLE",
        two_focals: false,
        distortion: 0,
    },
    ColmapModel {
        name: "PINHOLE",
        two_focals: true,
        distortion: 0,
    },
    ColmapModel {
        name: "SIMPLE_RADIAL",
        two_focals: false,
        distortion: 1,
    },
    ColmapModel {
        name: "RADIAL",
        two_focals: false,
        distortion: 2,
    },
    ColmapModel {
        name: "OPENCV",
        two_focals: true,
        distortion: 4,
    },
    ColmapModel {
        name: "FULL_OPENCV",
        two_focals: true,
        distortion: 8,
    },
];

/// Other models of COLMAP: their images are none of a pinhole.
const OTHERS: [&str; 5] = [
    "OPENCV_FISHEYE",
    "FOV",
    "SIMPLE_RADIAL_FISHEYE",
    "RADIAL_FISHEYE",
    "THIN_PRISM_FISHEYE",
];

/// How a camera sees.
struct Lens {
    size: [f64; 2],
    focal: [f64; 2],
    center: [f64; 2],
    distorts: bool,
}

/// Where an image was taken.
struct ImagePose<'a> {
    /// World to camera.
    rotation: DQuat,
    translation: DVec3,
    camera: &'a str,
    name: String,
}

/// Reads the cameras of all images, in the order of their names. `source`: one of the two files.
/// `world`: see [`super::read`].
///
/// # Errors
/// When the other file is missing, or one is not as COLMAP writes it, or a camera is no pinhole.
pub fn read(source: Source, world: DAffine3) -> Result<OpenedCameras, FormatError> {
    let own = utf8(source.bytes, source.name)?;
    let is_lenses = lists_cameras(own);
    let (found, other) = if is_lenses {
        (
            "how COLMAP's cameras see, and not where they are",
            "images.txt",
        )
    } else if source.name.ends_with("images.txt") || shots(own).is_ok_and(|shots| !shots.is_empty())
    {
        (
            "where COLMAP's images were taken, and not how its cameras see",
            "cameras.txt",
        )
    } else {
        return Err(FormatError::container("other text", KNOWN));
    };
    let beside = source.beside.file(other, u64::MAX);
    let beside = beside.map_err(|_| FormatError::container(found, format!("{other} beside it")))?;
    let beside = text::utf8(&beside);
    let beside = utf8(&beside, Path::new(other))?;
    let (lenses_of, shots_of) = if is_lenses {
        (own, beside)
    } else {
        (beside, own)
    };
    let lenses = lenses(lenses_of)?;
    let mut shots = shots(shots_of)?;
    shots.sort_by(|a, b| a.name.cmp(&b.name));
    opened(&lenses, &shots, world)
}

/// The `images.txt` of a folder that has a model in text, or of one in it.
pub fn images_in(path: &Path) -> Result<PathBuf, FileError> {
    let folders = || FOLDERS.iter().map(|folder| path.join(folder));
    let has = |folder: &Path, ending: &str| {
        ["cameras", "images"]
            .iter()
            .all(|name| folder.join(format!("{name}.{ending}")).is_file())
    };
    if let Some(found) = folders().find(|folder| has(folder, "txt")) {
        return Ok(found.join("images.txt"));
    }
    let found = if folders().any(|folder| has(&folder, "bin")) {
        "a folder with COLMAP's binary files"
    } else {
        "a folder"
    };
    let expected =
        "cameras.txt and images.txt in it, which `colmap model_converter --output_type TXT` writes";
    Err(content(path, FormatError::container(found, expected)))
}

/// A file's text.
fn utf8<'a>(bytes: &'a [u8], name: &Path) -> Result<&'a str, FormatError> {
    std::str::from_utf8(bytes).map_err(|_| {
        let is_binary = name.extension().is_some_and(|ending| ending == "bin");
        let expected = if is_binary {
            "COLMAP's text files, which `colmap model_converter --output_type TXT` writes"
        } else {
            KNOWN
        };
        FormatError::container("no text", expected)
    })
}

/// Whether a text begins as `cameras.txt` does: with a model's name behind a number.
fn lists_cameras(text: &str) -> bool {
    let line = text.lines().find(|line| !is_comment(line));
    let model = line.and_then(|line| line.split_whitespace().nth(1));
    model.is_some_and(|model| {
        MODELS.iter().any(|known| known.name == model) || OTHERS.contains(&model)
    })
}

fn is_comment(line: &str) -> bool {
    let line = line.trim_start_matches('\u{feff}').trim_start();
    line.is_empty() || line.starts_with('#')
}

/// Reads `cameras.txt`: `ID MODEL WIDTH HEIGHT NUMBERS…` by their ids.
fn lenses(text: &str) -> Result<BTreeMap<&str, Lens>, FormatError> {
    let mut lenses = BTreeMap::new();
    for line in text.lines().filter(|line| !is_comment(line)) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let broken =
            |expected: &str| FormatError::container(format!("`{}`", excerpt(line)), expected);
        let [id, name, numbers @ ..] = words.as_slice() else {
            return Err(broken("ID MODEL WIDTH HEIGHT and the model's numbers"));
        };
        let Some(model) = MODELS.iter().find(|model| model.name == *name) else {
            let names: Vec<_> = MODELS.iter().map(|model| model.name).collect();
            let names = names.join(", ");
            return Err(if OTHERS.contains(name) {
                let how = "`colmap image_undistorter` makes it of this one";
                FormatError::container(
                    format!("a camera of the model {name}"),
                    format!("{names}: {how}"),
                )
            } else {
                broken(&format!("a model of {names}; or {KNOWN}"))
            });
        };
        let numbers: Option<Vec<f64>> = numbers.iter().map(|word| word.parse().ok()).collect();
        let focals = 1 + usize::from(model.two_focals);
        let expected = 4 + focals + model.distortion;
        let Some(numbers) = numbers.filter(|numbers| numbers.len() == expected) else {
            return Err(broken(&format!("{expected} numbers behind {name}")));
        };
        let (seen, distortion) = numbers.split_at(4 + focals);
        let lens = Lens {
            size: [seen[0], seen[1]],
            focal: [seen[2], seen[1 + focals]],
            center: [seen[2 + focals], seen[3 + focals]],
            distorts: distorts(distortion),
        };
        lenses.insert(*id, lens);
    }
    Ok(lenses)
}

/// Reads `images.txt`: `ID QW QX QY QZ TX TY TZ CAMERA_ID NAME`, and below each a line of points,
/// which is empty where there are none; some programs leave empty lines out.
fn shots(text: &str) -> Result<Vec<ImagePose<'_>>, FormatError> {
    let mut shots = vec![];
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        if is_comment(line) {
            continue;
        }
        shots.push(shot(line).ok_or_else(|| {
            FormatError::container(
                format!("`{}`", excerpt(line)),
                format!("ID QW QX QY QZ TX TY TZ CAMERA_ID NAME of an image; or {KNOWN}"),
            )
        })?);
        lines.next_if(|line| is_points(line));
    }
    Ok(shots)
}

/// Whether a line is one of points, three numbers each.
fn is_points(line: &str) -> bool {
    let words = line.split_whitespace();
    words.clone().count().is_multiple_of(3) && words.clone().all(|word| word.parse::<f64>().is_ok())
}

fn shot(line: &str) -> Option<ImagePose<'_>> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let [_, placed @ .., _, _] = words.get(..10)? else {
        return None;
    };
    let numbers: Vec<f64> = placed
        .iter()
        .map(|word| word.parse().ok())
        .collect::<Option<_>>()?;
    let [w, x, y, z, tx, ty, tz] = numbers.try_into().ok()?;
    let rotation = DQuat::from_xyzw(x, y, z, w);
    let length = rotation.length();
    (length.is_finite() && length > 1e-6).then(|| ImagePose {
        rotation: rotation.normalize(),
        translation: DVec3::new(tx, ty, tz),
        camera: words[8],
        name: words[9..].join(" "),
    })
}

fn opened(
    lenses: &BTreeMap<&str, Lens>,
    shots: &[ImagePose],
    world: DAffine3,
) -> Result<OpenedCameras, FormatError> {
    let mut distorts = false;
    let mut placed = Vec::with_capacity(shots.len());
    for shot in shots {
        let lens = lenses.get(shot.camera).ok_or_else(|| {
            let known: Vec<_> = lenses.keys().copied().collect();
            FormatError::container(
                format!("camera {} of the image `{}`", shot.camera, shot.name),
                format!("one of cameras.txt: {}", excerpt(&known.join(", "))),
            )
        })?;
        distorts |= lens.distorts;
        let to_world = shot.rotation.inverse();
        placed.push(PlacedCamera {
            size: lens.size,
            focal: lens.focal,
            center: lens.center,
            rotation: DMat3::from_quat(to_world),
            position: -(to_world * shot.translation),
        });
    }
    Ok(OpenedCameras {
        cameras: cameras_of(&placed, world)?,
        assumptions: distortion(distorts).into_iter().collect(),
    })
}
