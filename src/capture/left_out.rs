//! What of a capture can't be used, and why.

use crate::limits::THRESHOLD;
use effigy_core::io::file::FormatError;
use std::{collections::BTreeMap, fmt, path::PathBuf};

/// A picture, frame or camera that is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Omission {
    /// The file at fault.
    pub file: PathBuf,
    /// Name of the camera, where the fault is of one.
    pub camera: Option<String>,
    /// Number of the frame, where the fault is of one.
    pub frame: Option<u32>,
    /// What is wrong.
    pub reason: OmissionReason,
}

/// What a look at some masks found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MaskLook {
    /// How many were looked at.
    pub count: usize,
    /// Those that can't be used.
    pub faults: Vec<Omission>,
}

impl MaskLook {
    /// Whether more than half show nothing that a person could be learned from.
    pub fn is_useless(&self) -> bool {
        let blank = |fault: &&Omission| !matches!(fault.reason, OmissionReason::Astray { .. });
        2 * self.faults.iter().filter(blank).count() > self.count
    }
}

impl fmt::Display for MaskLook {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{} looked at, ", self.count)?;
        match self.faults.first() {
            None => write!(f, "all with the person where the pose is"),
            Some(first) => write!(f, "{} of no use; first {first}", self.faults.len()),
        }
    }
}

/// Why something is left out.
#[derive(Clone, Debug, PartialEq)]
pub enum OmissionReason {
    /// `missing_img_files.txt` lists it.
    Listed,
    /// There is a picture and no mask, or a mask and no picture, or neither.
    Missing {
        /// Name of a file in its folder, which has none of the frame.
        other: Option<String>,
    },
    /// No header or no image in the file; what was found and what was expected.
    Unreadable(FormatError),
    /// Width and height differ from the camera's.
    Size {
        /// Of the file, px.
        found: [u32; 2],
        /// Of the camera, px.
        expected: [u32; 2],
    },
    /// A picture of a frame that has no pose.
    NoPose {
        /// Number of poses.
        poses: usize,
    },
    /// The frame's pose is not finite, or far away.
    Pose(FormatError),
    /// The camera's numbers are no camera.
    Camera(FormatError),
    /// No pixel of the mask is of the person, who is in view.
    EmptyMask {
        /// The most that the mask says of any pixel, of 255.
        highest: u8,
    },
    /// Every pixel of the mask is of the person.
    FullMask,
    /// The mask is of all but the person.
    InvertedMask,
    /// Hardly any joint is inside the mask.
    Astray {
        /// Joints inside the mask.
        inside: usize,
        /// Joints inside the picture.
        of: usize,
    },
    /// No joint of the body is in the picture, or in any of the camera's.
    NoBody,
}

impl OmissionReason {
    /// The reason without its numbers, for counting.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Listed => "listed as missing",
            Self::Missing { .. } => "missing",
            Self::Unreadable(_) => "unreadable",
            Self::Size { .. } => "of another size",
            Self::NoPose { .. } => "without a pose",
            Self::Pose(_) => "with a faulty pose",
            Self::Camera(_) => "faulty cameras",
            Self::EmptyMask { .. } => "with an empty mask",
            Self::FullMask => "with a full mask",
            Self::InvertedMask => "with an inverted mask",
            Self::Astray { .. } => "with a pose outside the mask",
            Self::NoBody => "that see nothing of the body",
        }
    }
}

impl fmt::Display for OmissionReason {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Listed => write!(f, "listed as missing"),
            Self::Missing { other: None } => write!(f, "found nothing, expected the file"),
            Self::Missing { other: Some(other) } => write!(
                f,
                "found `{other}` in its folder, expected a PNG or JPEG with the frame's number alone \
                 in its name"
            ),
            Self::Unreadable(fault) | Self::Pose(fault) | Self::Camera(fault) => fault.fmt(f),
            Self::Size { found, expected } => {
                let [w, h] = expected;
                write!(
                    f,
                    "found {} x {} px, expected {w} x {h}",
                    found[0], found[1]
                )
            }
            Self::NoPose { poses } => write!(f, "found a picture, expected one of {poses} poses"),
            Self::EmptyMask { highest: 0 } => {
                write!(f, "found an empty mask, expected the person")
            }
            Self::EmptyMask { highest } => write!(
                f,
                "found numbers up to {highest} of 255 in the mask, expected the person's above \
                 {THRESHOLD}"
            ),
            Self::FullMask => write!(f, "found a mask that is full, expected the person alone"),
            Self::InvertedMask => write!(
                f,
                "found an inverted mask, expected the person's above {THRESHOLD}"
            ),
            Self::Astray { inside, of } => write!(
                f,
                "found {inside} of {of} joints inside the mask, expected most"
            ),
            Self::NoBody => write!(f, "found no joint of the body in view, expected some"),
        }
    }
}

impl fmt::Display for Omission {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}", self.file.display())?;
        if let Some(camera) = &self.camera {
            write!(f, ", camera {camera}")?;
        }
        if let Some(frame) = self.frame {
            write!(f, ", frame {frame}")?;
        }
        write!(f, ": {}", self.reason)
    }
}

/// How often there is each kind of reason, in the order of the kinds' names.
pub fn tally(left_out: &[Omission]) -> BTreeMap<&'static str, usize> {
    let mut counts = BTreeMap::new();
    for entry in left_out {
        *counts.entry(entry.reason.kind()).or_default() += 1;
    }
    counts
}
