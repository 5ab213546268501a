//! Reading of avatars and clips of any kind from a file's bytes, wherever they come from.
//! [`open`](crate::open) reads those of a path.

pub use crate::source::Source;

#[cfg(feature = "fbx")]
use crate::fbx;
use crate::{
    assumption::Assumption,
    bvh,
    capture::{Capture, Captured, Rest},
    content::{CaptureFormat, Content},
    gltf_motion, guess,
    retarget::{self, Girth, Report, RetargetOptions},
    smpl,
    splats::{self, Found, Nothing, SplatFormat},
    webavatar::{self, ForeignAvatar},
};
use effigy_core::{
    avatar::{Avatar, Clip, Skeleton},
    io::{file::FormatError, splats::Up},
};

/// Bytes of a file beside a glTF of motion.
const LONGEST_BESIDE: u64 = 256 << 20;
/// What is read of other programs, for errors.
const KNOWN: &str = "an avatar (.avatar, the paper's .npz), splats (.ply, .splat, .spz, .sog, .ksplat, .glb) or motion \
                     (.motion, .bvh, .fbx, .glb, .vrma, .npz, .pkl)";

impl Source<'_> {
    /// What it is.
    pub fn content(&self) -> Content {
        Content::of(self.bytes, self.name)
    }
}

/// What files of avatars leave open.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OpenOptions {
    /// The axis of a splat file that points up; None: as the file or its format says.
    pub up: Option<Up>,
    /// Of the paper's model.
    pub webavatar: webavatar::Options,
}

/// Reads splats. `up`: the axis that points up; None: as the file or its format says.
///
/// # Errors
/// When the file has no splats, or breaks a rule.
pub fn splats(source: Source, up: Option<Up>) -> Result<Found, FormatError> {
    source.inside(|source| {
        // What is of no known format is refused as the most common one.
        let format = match Content::of_unpacked(source.bytes, source.name) {
            Content::Splats(format) => format,
            _ => SplatFormat::Ply,
        };
        let mut found = splats::read(source.bytes, format, source.beside)?;
        if let Some(up) = up {
            found.splats.up = up;
            found.assumptions.retain(|own| own.what != Up::QUESTION);
        }
        found.assumptions.splice(0..0, source.chosen);
        Ok(found)
    })
}

/// Reads an avatar: Effigy's own, the paper's `.npz` or splats.
///
/// # Errors
/// When the file is none of them, or breaks a rule.
pub fn avatar(source: Source, options: &OpenOptions) -> Result<ForeignAvatar, FormatError> {
    source.inside(|source| unpacked_avatar(source, options))
}

fn unpacked_avatar(source: Source, options: &OpenOptions) -> Result<ForeignAvatar, FormatError> {
    let name = source.stem();
    match Content::of_unpacked(source.bytes, source.name) {
        Content::Splats(_) => {
            let Found {
                splats,
                assumptions,
            } = splats(source, options.up)?;
            Ok(ForeignAvatar {
                avatar: splats.to_avatar(&name)?,
                assumptions,
            })
        }
        Content::Model => webavatar::from_bytes(source.bytes, &name, &options.webavatar),
        Content::Checkpoint => Err(checkpoint_as_avatar()),
        Content::Poses | Content::Capture(_) => {
            let expected = "an avatar or splats; motion goes with --motion";
            Err(FormatError::container("motion", expected))
        }
        Content::Other => Ok(ForeignAvatar {
            avatar: Avatar::from_bytes(source.bytes).map_err(|own| unknown(source.bytes, own))?,
            assumptions: vec![],
        }),
    }
}

/// The error of a checkpoint where an avatar is drawn.
fn checkpoint_as_avatar() -> FormatError {
    FormatError::container(
        "a training checkpoint of mmlphuman",
        "an avatar, such as one that was distilled from it",
    )
}

/// How a motion file becomes a clip.
#[derive(Clone, Debug, Default)]
pub struct ClipOptions {
    /// Which motion of a file.
    pub capture: CaptureOptions,
    /// For motion of other bodies.
    pub retarget: RetargetOptions,
}

/// Which motion of a file of another program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CaptureOptions {
    /// Frames a second of a file that does not say, or whose motion stands at any time; None: as
    /// its format says.
    pub rate: Option<f64>,
    /// The name of an animation, or its number from 0; None: the first.
    pub animation: Option<String>,
    /// Which person of several; those who are seen longer come first.
    pub person: usize,
}

/// A clip, and how it was made of its file.
#[derive(Clone, Debug)]
pub struct OpenedClip {
    /// Moves the avatar.
    pub clip: Clip,
    /// What the file left open.
    pub assumptions: Vec<Assumption>,
    /// How well the avatar follows; None: the file is made for such avatars.
    pub report: Option<Report>,
    /// The motion as its file has it; None: the file is made for such avatars.
    pub capture: Option<Capture>,
}

/// Reads motion of another program: BVH, glTF, VRM, FBX (in builds with the feature `fbx`), SMPL's
/// parameters, or the paper's poses.
///
/// # Errors
/// When the file is of no known kind, or breaks a rule.
pub fn capture(source: Source, options: &CaptureOptions) -> Result<Captured, FormatError> {
    source.inside(|source| unpacked_capture(source, options))
}

fn unpacked_capture(source: Source, options: &CaptureOptions) -> Result<Captured, FormatError> {
    let content = Content::of_unpacked(source.bytes, source.name);
    let Source { bytes, beside, .. } = source;
    match content {
        Content::Capture(CaptureFormat::Gltf) => {
            let options = gltf_motion::Options {
                rate: options.rate,
                animation: options.animation.clone(),
                rest: Rest::Bind,
            };
            let mut beside = |name: &str| beside.file(name, LONGEST_BESIDE).ok();
            gltf_motion::from_bytes(bytes, &options, &mut beside)
        }
        Content::Capture(CaptureFormat::Fbx) => read_fbx(bytes, options),
        Content::Capture(CaptureFormat::Smpl) => {
            let options = smpl::Options {
                rate: options.rate,
                person: options.person,
            };
            smpl::from_bytes(bytes, &options)
        }
        Content::Capture(CaptureFormat::Bvh) => bvh::from_bytes(bytes),
        Content::Poses => webavatar::capture_poses(bytes, options.rate),
        Content::Splats(_) | Content::Model | Content::Checkpoint => {
            let expected = "motion; an avatar stands before --motion";
            Err(FormatError::container("an avatar or splats", expected))
        }
        Content::Other => {
            let own = FormatError::container("a file of no known kind", KNOWN);
            Err(unknown(bytes, own))
        }
    }
}

/// Bytes of a file's start that tell what it seems to be.
const START: usize = 512;

/// The error of a file that is no avatar or motion of Effigy's: what it seems to be, else what
/// Effigy's own reader found.
pub fn unknown(bytes: &[u8], own: FormatError) -> FormatError {
    let mut beside = Nothing;
    let source = Source::new(bytes, "unknown".as_ref(), &mut beside);
    let seems = source.start(|source| {
        let start = &source.bytes[..source.bytes.len().min(START)];
        Ok(guess::seems(start))
    });
    match seems {
        Ok(Some(what)) => FormatError::container(what, KNOWN),
        Ok(None) => own,
        Err(packed) => packed,
    }
}

#[cfg(feature = "fbx")]
fn read_fbx(bytes: &[u8], options: &CaptureOptions) -> Result<Captured, FormatError> {
    let options = fbx::Options {
        rate: options.rate,
        animation: options.animation.clone(),
        rest: Rest::Bind,
    };
    fbx::from_bytes(bytes, &options)
}

#[cfg(not(feature = "fbx"))]
fn read_fbx(_: &[u8], _: &CaptureOptions) -> Result<Captured, FormatError> {
    let expected = "another format, or a program that was built with the feature `fbx`";
    Err(FormatError::container("an FBX file", expected))
}

/// Reads a clip for an avatar: Effigy's own, the poses beside the paper's model
/// where it is that model's, or motion of another body, which is retargeted. `skeleton`: the avatar's. `girth` measures the avatar, where
/// motion of another body needs it and `options` have none.
///
/// # Errors
/// When the file is none of them, or breaks a rule.
pub fn clip(
    source: Source,
    skeleton: &Skeleton,
    girth: impl FnOnce() -> Option<Girth>,
    options: &ClipOptions,
) -> Result<OpenedClip, FormatError> {
    source.inside(|source| unpacked_clip(source, skeleton, girth, options))
}

fn unpacked_clip(
    source: Source,
    skeleton: &Skeleton,
    girth: impl FnOnce() -> Option<Girth>,
    options: &ClipOptions,
) -> Result<OpenedClip, FormatError> {
    let made_for_it = |clip| OpenedClip {
        clip,
        assumptions: vec![],
        report: None,
        capture: None,
    };
    let name = source.stem();
    let content = Content::of_unpacked(source.bytes, source.name);
    if content == Content::Other || content == Content::Model || content == Content::Checkpoint {
        let clip = Clip::from_bytes(source.bytes).map_err(|own| unknown(source.bytes, own));
        return clip.map(made_for_it);
    }
    if content == Content::Poses && webavatar::is_own_skeleton(skeleton) {
        let rate = options.capture.rate.unwrap_or(webavatar::POSES_RATE);
        let clip = webavatar::read_poses(source.bytes, &name, skeleton, rate);
        return clip.map(made_for_it);
    }
    let captured = unpacked_capture(source, &options.capture)?;
    let mut retargeting = options.retarget.clone();
    if retargeting.girth.is_none() {
        retargeting.girth = girth();
    }
    let made = retarget::retarget(&captured.capture, skeleton, &name, &retargeting)?;
    Ok(OpenedClip {
        clip: made.clip,
        assumptions: [captured.assumptions, made.assumptions].concat(),
        report: Some(made.report),
        capture: Some(captured.capture),
    })
}
