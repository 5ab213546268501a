//! Opening of a capture's folder: which of its pictures can be used.

use crate::{
    calibration::{CaptureCalibration, CaptureCamera, Named},
    capture::{Capture, CaptureFrame},
    decode::PictureFiles,
    error::{CaptureError, fault, read_bytes},
    header::{self, Head, PixelSize},
    layouts::{self, FolderLayout},
    left_out::{MaskLook, Omission, OmissionReason},
    limits,
    mask::MaskRule,
    poses::{self, CapturePoses, Hands},
    split::Split,
    template, units,
};
use effigy_core::io::file::{FileError, FormatError, excerpt};
use rayon::prelude::*;
use std::{
    collections::{BTreeMap, HashMap, HashSet},
    fs,
    path::{Path, PathBuf},
};

/// Pictures that are known not to be there.
const MISSING: &str = "missing_img_files.txt";

/// How to open a capture.
#[derive(Clone, Debug, Default)]
pub struct CaptureOpenOptions {
    /// The body model's file; None: `template.npz` in the folder.
    pub template: Option<PathBuf>,
}

impl Capture {
    /// Name of the layout of a folder; None where it is no capture.
    pub fn layout(folder: &Path) -> Option<&'static str> {
        layouts::of(folder).map(|layout| layout.name)
    }

    /// Opens a capture: reads cameras, poses and body model, the sizes of all pictures and masks, and
    /// some masks. What can't be used is in [`Self::left_out`].
    ///
    /// # Errors
    /// When the folder has no layout that is known, or its calibration, poses or body model can't
    /// be read or are not in metres; when no frame is left.
    pub fn read(folder: &Path) -> Result<Self, CaptureError> {
        Self::read_with(folder, &CaptureOpenOptions::default())
    }

    /// Opens a capture like [`Self::read`].
    ///
    /// # Errors
    /// Those of [`Self::read`].
    pub fn read_with(folder: &Path, options: &CaptureOpenOptions) -> Result<Self, CaptureError> {
        let layout = layouts::of(folder).ok_or_else(|| CaptureError::Layout {
            folder: folder.into(),
            expected: layouts::known_by(),
        })?;
        let calibration_file = folder.join(layout.calibration);
        let text = read_bytes(&calibration_file, limits::TEXT)?;
        let calibration = CaptureCalibration::parse(&calibration_file, &text)?;
        let split = Split::read(folder)?;
        split.expect_names(
            folder,
            calibration.cameras.iter().map(|camera| &camera.name[..]),
        )?;

        let template_file = match &options.template {
            Some(file) => file.clone(),
            None => folder.join(template::FILE),
        };
        let archive = template::read(&template_file)?;
        let poses = CapturePoses::read(folder, archive.parent.len())?;
        let model = archive.model(&template_file, &poses.betas)?;
        let mut template = model.template;
        template.expression = poses.expression();

        let mut left_out = Vec::new();
        let search = Search {
            folder,
            layout,
            listed: listed(folder)?,
            poses: poses.frames,
        };
        let views: Vec<CameraFiles> = calibration
            .cameras
            .into_iter()
            .filter_map(|named| search.view(named, &mut left_out))
            .collect();
        let (frames, files) = frames(folder, &poses, &model.hands, &split, &views, &mut left_out);
        let cameras: Vec<CaptureCamera> = views
            .into_iter()
            .map(|view| CaptureCamera {
                held: split.cameras.contains(&view.camera.name),
                ..view.camera
            })
            .collect();
        let capture = Self {
            folder: folder.into(),
            rules: vec![MaskRule::default(); cameras.len()],
            cameras,
            frames,
            template,
            left_out,
            assumptions: poses.assumptions(&model.hands),
            masks: MaskLook::default(),
            files,
        };
        let mut capture = capture.unless_empty()?;
        if let Some(found) = units::fault(&capture) {
            let file = match found.of_poses {
                true => folder.join(poses::FILE),
                false => calibration_file,
            };
            return Err(fault(&file, found.error));
        }
        capture.look_at_masks();
        Ok(capture)
    }
}

/// The frames that have a picture and a usable pose, and the files of each by each camera, frame
/// after frame.
fn frames(
    folder: &Path,
    poses: &CapturePoses,
    hands: &Hands,
    split: &Split,
    views: &[CameraFiles],
    left_out: &mut Vec<Omission>,
) -> (Vec<CaptureFrame>, Vec<Option<PictureFiles>>) {
    let mut frames = Vec::new();
    let mut files = Vec::new();
    for number in 0..poses.frames as u32 {
        let row: Vec<Option<PictureFiles>> = views
            .iter()
            .map(|view| view.files.get(&number).cloned())
            .collect();
        if row.iter().all(Option::is_none) {
            continue;
        }
        match poses.pose(number as usize, hands) {
            Ok(pose) => {
                files.extend(row);
                frames.push(CaptureFrame {
                    number,
                    pose,
                    held: split.frames.contains(&number),
                });
            }
            Err(fault) => left_out.push(Omission {
                file: folder.join(poses::FILE),
                camera: None,
                frame: Some(number),
                reason: OmissionReason::Pose(fault),
            }),
        }
    }
    (frames, files)
}

/// A camera with its files.
struct CameraFiles {
    camera: CaptureCamera,
    /// By number of the frame.
    files: BTreeMap<u32, PictureFiles>,
}

/// Files that the capture says are missing, with `/` and without the folder's own path.
fn listed(folder: &Path) -> Result<HashSet<String>, CaptureError> {
    let file = folder.join(MISSING);
    if !file.exists() {
        return Ok(HashSet::new());
    }
    let text = read_bytes(&file, limits::TEXT)?;
    let lines = String::from_utf8_lossy(&text);
    // On Windows or elsewhere, from the folder or from above it.
    let paths = lines.lines().map(|line| line.trim().replace('\\', "/"));
    Ok(paths.filter(|line| !line.is_empty()).collect())
}

/// The pictures of a folder by number.
#[derive(Default)]
struct Numbered {
    files: BTreeMap<u32, PathBuf>,
    /// Name of another file in the folder.
    other: Option<String>,
}

impl Numbered {
    /// Empty where the folder does not exist. Where no name is a frame's number alone, the only
    /// number in a name counts.
    fn read(folder: &Path, number: fn(&str) -> Option<u32>) -> Result<Self, CaptureError> {
        let unreadable = |cause| FileError::Read {
            file: folder.into(),
            cause,
        };
        if !folder.is_dir() {
            return Ok(Self::default());
        }
        let mut paths = Vec::new();
        for entry in fs::read_dir(folder).map_err(unreadable)? {
            paths.push(entry.map_err(unreadable)?.path());
        }
        // Which of two of one number is taken must not be chance.
        paths.sort();
        let plain = Self::named(&paths, number);
        if !plain.files.is_empty() {
            return Ok(plain);
        }
        let loose = Self::named(&paths, layouts::only_number);
        let is_unique = loose.files.len() == paths.iter().filter(|path| is_picture(path)).count();
        Ok(if is_unique { loose } else { plain })
    }

    fn named(paths: &[PathBuf], number: fn(&str) -> Option<u32>) -> Self {
        let mut found = Self::default();
        for path in paths {
            let stem = path.file_stem().unwrap_or_default().to_string_lossy();
            match number(&stem).filter(|_| is_picture(path)) {
                Some(number) if found.files.len() < limits::FRAMES => {
                    found.files.entry(number).or_insert_with(|| path.clone());
                }
                _ if found.other.is_none() && path.is_file() => {
                    let name = path.file_name().unwrap_or_default().to_string_lossy();
                    found.other = Some(excerpt(&name));
                }
                _ => {}
            }
        }
        found
    }

    /// The reason for a frame without a file.
    fn missing(&self) -> OmissionReason {
        OmissionReason::Missing {
            other: self.other.clone().filter(|_| self.files.is_empty()),
        }
    }
}

/// Whether a file's ending is that of a picture.
fn is_picture(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    ["png", "jpg", "jpeg"].contains(&&*ending.to_ascii_lowercase())
}

/// Where a capture's pictures are searched for.
struct Search<'a> {
    folder: &'a Path,
    layout: &'a FolderLayout,
    /// See [`listed`].
    listed: HashSet<String>,
    /// Number of poses.
    poses: usize,
}

/// A camera's files, and why some can't be used.
struct Sorted {
    files: BTreeMap<u32, PictureFiles>,
    left_out: Vec<(PathBuf, u32, OmissionReason)>,
}

impl Search<'_> {
    /// Finds a camera's files. None: the camera can't be used, for the reason in `left_out`.
    fn view(&self, named: Named, left_out: &mut Vec<Omission>) -> Option<CameraFiles> {
        let Named { name, entry } = named;
        let found = self.pictures(&name).and_then(|(pictures, masks)| {
            let headers: Vec<HeaderPair> = pictures
                .files
                .par_iter()
                .map(|(number, picture)| {
                    HeaderPair::read(*number, picture, masks.files.get(number))
                })
                .collect();
            let size = entry.size().or_else(|| commonest(&headers));
            // Without any picture, any size will do.
            let camera = entry.camera(&name, size.unwrap_or([1, 1]))?;
            let sorted = self.sort(&name, camera.camera.size, &headers, &pictures, &masks);
            Ok((camera, sorted))
        });
        let leave_out = |file, frame, reason| Omission {
            file,
            camera: Some(name.clone()),
            frame,
            reason,
        };
        match found {
            Ok((camera, sorted)) => {
                let all = sorted.left_out.into_iter();
                left_out.extend(
                    all.map(|(file, number, reason)| leave_out(file, Some(number), reason)),
                );
                Some(CameraFiles {
                    camera,
                    files: sorted.files,
                })
            }
            Err(fault) => {
                let calibration = self.folder.join(self.layout.calibration);
                left_out.push(leave_out(calibration, None, OmissionReason::Camera(fault)));
                None
            }
        }
    }

    /// The pictures and masks of a camera.
    fn pictures(&self, camera: &str) -> Result<(Numbered, Numbered), FormatError> {
        let read = |below: String| {
            Numbered::read(&self.folder.join(below), self.layout.number)
                .map_err(|error| FormatError::container(error, "its pictures"))
        };
        Ok((
            read((self.layout.pictures)(camera))?,
            read((self.layout.masks)(camera))?,
        ))
    }

    /// Sorts a camera's pictures, and those that are missing, by whether they can be used. `size`:
    /// of the camera.
    fn sort(
        &self,
        camera: &str,
        size: PixelSize,
        headers: &[HeaderPair],
        pictures: &Numbered,
        masks: &Numbered,
    ) -> Sorted {
        let mut files = BTreeMap::new();
        let mut left_out = Vec::new();
        for header in headers {
            let number = header.number;
            let picture = &pictures.files[&number];
            let mask = masks.files.get(&number);
            match header.fault(size, self.poses, masks) {
                _ if self.is_listed(picture) => {
                    left_out.push((picture.clone(), number, OmissionReason::Listed));
                }
                None => {
                    let mask = mask.unwrap_or(picture).clone();
                    let picture = picture.clone();
                    files.insert(number, PictureFiles { picture, mask });
                }
                Some(HeaderFault { of_mask, reason }) => {
                    let file = match mask {
                        Some(mask) if of_mask => mask.clone(),
                        None if of_mask => {
                            like(picture, &self.folder.join((self.layout.masks)(camera)))
                        }
                        _ => picture.clone(),
                    };
                    left_out.push((file, number, reason));
                }
            }
        }
        let folder = self.folder.join((self.layout.pictures)(camera));
        // Missing pictures, up to the last pose.
        let missing = (0..self.poses as u32).filter(|number| !pictures.files.contains_key(number));
        left_out.extend(missing.map(|number| {
            let file = folder.join(format!("{number:08}.png"));
            let reason = if self.is_listed(&file) || self.is_listed(&file.with_extension("jpg")) {
                OmissionReason::Listed
            } else {
                pictures.missing()
            };
            (file, number, reason)
        }));
        Sorted { files, left_out }
    }

    /// Whether the list of missing files has a file.
    fn is_listed(&self, file: &Path) -> bool {
        let path = file.strip_prefix(self.folder).unwrap_or(file);
        let path = path.to_string_lossy().replace('\\', "/");
        let parts: Vec<&str> = path.split('/').collect();
        // Lists name pictures with or without the first folder.
        let mut tails = (0..parts.len().saturating_sub(1)).map(|from| parts[from..].join("/"));
        tails.any(|tail| self.listed.contains(&tail))
    }
}

/// The path of a missing mask.
fn like(picture: &Path, masks: &Path) -> PathBuf {
    masks.join(picture.file_name().unwrap_or_default())
}

/// The headers of a picture and its mask.
struct HeaderPair {
    number: u32,
    picture: Result<Head, FormatError>,
    /// None: there is no mask.
    mask: Option<Result<Head, FormatError>>,
}

/// What is wrong with a picture or its mask.
struct HeaderFault {
    of_mask: bool,
    reason: OmissionReason,
}

impl HeaderPair {
    fn read(number: u32, picture: &Path, mask: Option<&PathBuf>) -> Self {
        Self {
            number,
            picture: header::read(picture),
            mask: mask.map(|mask| header::read(mask)),
        }
    }

    /// What is wrong, if it is. `masks`: of the camera.
    fn fault(&self, expected: PixelSize, poses: usize, masks: &Numbered) -> Option<HeaderFault> {
        if self.number as usize >= poses {
            return Some(HeaderFault {
                of_mask: false,
                reason: OmissionReason::NoPose { poses },
            });
        }
        let of = |found: &Result<Head, FormatError>| match found {
            Err(fault) => Some(OmissionReason::Unreadable(fault.clone())),
            Ok(Head { size, .. }) if *size != expected => Some(OmissionReason::Size {
                found: *size,
                expected,
            }),
            Ok(_) => None,
        };
        if let Some(reason) = of(&self.picture) {
            return Some(HeaderFault {
                of_mask: false,
                reason,
            });
        }
        let has_alpha = self.picture.as_ref().is_ok_and(|head| head.has_alpha);
        let reason = match &self.mask {
            // Where some masks are missing, their pictures have none either.
            None if has_alpha && masks.files.is_empty() => None,
            None => Some(masks.missing()),
            Some(mask) => of(mask),
        };
        reason.map(|reason| HeaderFault {
            of_mask: true,
            reason,
        })
    }
}

/// The size that most pictures have.
fn commonest(headers: &[HeaderPair]) -> Option<PixelSize> {
    let mut counts: HashMap<PixelSize, usize> = HashMap::new();
    for head in headers
        .iter()
        .filter_map(|header| header.picture.as_ref().ok())
    {
        *counts.entry(head.size).or_default() += 1;
    }
    counts
        .into_iter()
        .max_by_key(|&(size, count)| (count, size))
        .map(|(size, _)| size)
}
