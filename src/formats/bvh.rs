//! Biovision motion capture files (`.bvh`): a tree of joints with their channels, and one row of
//! numbers a frame.
//!
//! There is no standard beside the first program's habits, so the reader takes what programs write:
//! any white space, names with spaces, several roots, channels in any order or none, a brace on the
//! line of its joint, rows broken over lines, a wrong count of frames, a last row that was cut.

use crate::{
    assumption::Assumption,
    capture::{
        Capture, CaptureJoint, Captured, LocalPose, MAX_FRAMES, MAX_JOINTS, UpAxis, most_poses,
    },
};
use effigy_core::io::file::{FormatError, excerpt};
use glam::{DQuat, DVec3, Vec3};
use std::{borrow::Cow, ops::RangeInclusive};

/// Whether bytes begin as a BVH file does.
pub fn is_bvh(bytes: &[u8]) -> bool {
    let start = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    start
        .trim_ascii_start()
        .get(..9)
        .is_some_and(|word| word.eq_ignore_ascii_case(b"HIERARCHY"))
}

/// Seconds that a frame may take.
const FRAME_TIMES: RangeInclusive<f64> = 1e-6..=1e3;

/// The meaning of one number of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum BvhChannel {
    /// Moves along axis 0, 1 or 2.
    Position(usize),
    /// Turns about axis 0, 1 or 2, degrees; a joint's rotations apply in the file's order, the last
    /// one first.
    Rotation(usize),
}

/// A line of the file.
#[derive(Clone, Copy)]
struct BvhLine<'a> {
    /// Counted from 1.
    number: usize,
    /// Without spaces at its ends.
    text: &'a str,
}

impl BvhLine<'_> {
    fn error(self, found: impl std::fmt::Display, expected: &str) -> FormatError {
        FormatError::container(format!("{found} in line {}", self.number), expected)
    }

    fn number(self, word: Option<&str>) -> Result<f64, FormatError> {
        let number = word.and_then(|word| word.parse::<f64>().ok());
        number.filter(|value| value.is_finite()).ok_or_else(|| {
            let found = word.map_or("the end".into(), |word| format!("`{}`", excerpt(word)));
            self.error(found, "a finite number")
        })
    }
}

/// The text of a file, whose names may be in any encoding. What is no UTF-8 becomes ASCII, which
/// takes no more room. A brace right behind such a byte is the second half of a letter, as in
/// Shift-JIS and GBK.
fn readable(bytes: &[u8]) -> Cow<'_, str> {
    if let Ok(text) = str::from_utf8(bytes) {
        return text.into();
    }
    let mut text = String::with_capacity(bytes.len());
    let mut half = false;
    for chunk in bytes.utf8_chunks() {
        let valid = chunk.valid();
        match valid.strip_prefix(['{', '}']).filter(|_| half) {
            Some(rest) => {
                text.push('?');
                text.push_str(rest);
            }
            None => text.push_str(valid),
        }
        half = !chunk.invalid().is_empty();
        if half {
            text.push('?');
        }
    }
    text.into()
}

/// Reads a file.
///
/// Position channels replace a joint's offset. Joints whose position channels are zero throughout
/// keep it.
///
/// # Errors
/// When the hierarchy is malformed, a number is none, or there is no whole frame.
pub fn from_bytes(bytes: &[u8]) -> Result<Captured, FormatError> {
    let text = readable(bytes);
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    // Old programs end lines by a carriage return alone.
    let end = if text.contains('\n') { '\n' } else { '\r' };
    let mut lines = text.split(end).enumerate().map(|(at, text)| BvhLine {
        number: at + 1,
        text: text.trim(),
    });
    let mut hierarchy = Hierarchy::default();
    loop {
        let Some(line) = lines.next() else {
            let found = "a file without a MOTION section";
            return Err(FormatError::container(found, "one after the HIERARCHY"));
        };
        if line.text.eq_ignore_ascii_case("MOTION") {
            break;
        }
        // A brace may stand on any line, with others.
        for piece in line.text.split_inclusive(['{', '}']) {
            let brace = piece.len() - piece.trim_end_matches(['{', '}']).len();
            let (words, brace) = piece.split_at(piece.len() - brace);
            for text in [words.trim(), brace] {
                hierarchy.read_line(BvhLine { text, ..line })?;
            }
        }
    }
    hierarchy.finish()?;
    let mut lines = lines.filter(|line| !line.text.is_empty());
    let announced = header(lines.next(), "Frames:")?;
    let frame_time = header(lines.next(), "Frame Time:")?;
    if !FRAME_TIMES.contains(&frame_time) {
        let found = format!("a frame time of {frame_time} s");
        return Err(FormatError::container(found, "a millionth to a thousand"));
    }
    let mut frames = FrameReader::new(&hierarchy, most_poses(bytes.len()));
    for line in lines {
        if frames.local.len() == hierarchy.joints.len() {
            frames.reserve(bytes.len() / line.text.len().max(1));
        }
        for word in line.text.split_ascii_whitespace() {
            frames.push(line.number(Some(word))?)?;
        }
    }
    let mut assumptions = Vec::new();
    frames.report(announced, &mut assumptions)?;
    let mut local = frames.local;
    keep_offsets(&hierarchy, &mut local, &mut assumptions);
    leave_out_rest(hierarchy.joints.len(), &mut local, &mut assumptions);
    Ok(Captured {
        capture: Capture {
            joints: hierarchy.joints,
            rate: 1.0 / frame_time,
            local,
            unit: None,
            up: UpAxis::Open,
            model_rest: false,
            expression: vec![],
            expression_len: 0,
        },
        assumptions,
    })
}

/// The number after a word.
fn header(line: Option<BvhLine>, word: &str) -> Result<f64, FormatError> {
    let expected = format!("`{word}` and a number");
    let Some(line) = line else {
        return Err(FormatError::container("the end of the file", expected));
    };
    let start = line.text.get(..word.len());
    if !start.is_some_and(|start| start.eq_ignore_ascii_case(word)) {
        return Err(line.error(format!("`{}`", excerpt(line.text)), &expected));
    }
    line.number(line.text[word.len()..].split_ascii_whitespace().next())
}

/// Gives joints whose position channels are zero throughout their offsets back: some programs write
/// six channels for each joint and fill three of them.
fn keep_offsets(hierarchy: &Hierarchy, local: &mut [LocalPose], assumptions: &mut Vec<Assumption>) {
    let count = hierarchy.joints.len();
    let mut kept = 0;
    for (at, joint) in hierarchy.joints.iter().enumerate() {
        let moves = |channel: &BvhChannel| matches!(channel, BvhChannel::Position(_));
        let own = || local.iter().skip(at).step_by(count);
        if joint.parent.is_some()
            && joint.offset != DVec3::ZERO
            && hierarchy.channels[at].iter().any(moves)
            && own().all(|pose| pose.offset == Vec3::ZERO)
        {
            for pose in local.iter_mut().skip(at).step_by(count) {
                pose.offset = joint.offset.as_vec3();
            }
            kept += 1;
        }
    }
    if kept > 0 {
        assumptions.push(Assumption {
            what: "joints with positions of 0 in every frame",
            taken: format!("{kept}, which keep their offsets"),
            because: "they would all be at one point".into(),
        });
    }
}

/// Puts the second frame in the place of the first one if that is the rest pose, which programs
/// write before the motion.
fn leave_out_rest(joints: usize, local: &mut [LocalPose], assumptions: &mut Vec<Assumption>) {
    let Some((first, rest)) = local.split_at_mut_checked(joints) else {
        return;
    };
    let rests = |pose: &LocalPose| pose.rotation.is_near_identity();
    let Some(second) = rest.get(..joints) else {
        return;
    };
    if first.iter().all(rests) && !second.iter().all(rests) {
        first.copy_from_slice(second);
        assumptions.push(Assumption {
            what: "the first frame",
            taken: "the second in its place".into(),
            because: "it is the rest pose, and the second is not".into(),
        });
    }
}

/// The frames that were read so far.
struct FrameReader<'a> {
    hierarchy: &'a Hierarchy,
    local: Vec<LocalPose>,
    /// Numbers of the frame that is being read.
    row: Vec<f64>,
    width: usize,
    /// Most frames.
    limit: usize,
}

impl<'a> FrameReader<'a> {
    /// `poses`: of single joints, at most.
    fn new(hierarchy: &'a Hierarchy, poses: usize) -> Self {
        Self {
            hierarchy,
            local: vec![],
            row: vec![],
            width: hierarchy.channels.iter().map(Vec::len).sum(),
            limit: (poses / hierarchy.joints.len()).min(MAX_FRAMES),
        }
    }

    /// Takes memory for about as many frames as the file can have, so that it is not copied.
    fn reserve(&mut self, frames: usize) {
        let frames = frames.min(self.limit);
        self.local
            .reserve_exact(frames * self.hierarchy.joints.len());
    }

    fn count(&self) -> usize {
        self.local.len() / self.hierarchy.joints.len()
    }

    fn push(&mut self, value: f64) -> Result<(), FormatError> {
        self.row.push(value);
        if self.row.len() < self.width {
            return Ok(());
        }
        if self.count() == self.limit {
            let found = format!("more than {} frames", self.limit);
            let expected = "at most as many, of so many joints in so small a file";
            return Err(FormatError::container(found, expected));
        }
        let mut values = self.row.drain(..);
        for (joint, channels) in self.hierarchy.joints.iter().zip(&self.hierarchy.channels) {
            let mut rotation = DQuat::IDENTITY;
            let mut offset = joint.offset;
            for (channel, value) in channels.iter().zip(&mut values) {
                match *channel {
                    BvhChannel::Position(axis) => offset[axis] = value,
                    BvhChannel::Rotation(axis) => {
                        rotation *= DQuat::from_axis_angle(DVec3::AXES[axis], value.to_radians());
                    }
                }
            }
            self.local.push(LocalPose::new(rotation, offset));
        }
        Ok(())
    }

    /// Says where the frames are not those that the file announces.
    fn report(&self, announced: f64, assumptions: &mut Vec<Assumption>) -> Result<(), FormatError> {
        let count = self.count();
        if count == 0 {
            let found = format!("{} numbers in the motion", self.row.len());
            let expected = format!("a frame of {} or more", self.width.max(1));
            return Err(FormatError::container(found, expected));
        }
        if count as f64 != announced {
            assumptions.push(Assumption {
                what: "frames",
                taken: count.to_string(),
                because: format!("the file announces {announced}"),
            });
        }
        if !self.row.is_empty() {
            assumptions.push(Assumption {
                what: "the end of the motion",
                taken: format!("{} numbers left out", self.row.len()),
                because: format!("a frame has {}", self.width),
            });
        }
        Ok(())
    }
}

/// The owner of an open brace.
#[derive(Clone, Copy)]
struct Block {
    joint: usize,
    /// Whether it is the end of a chain, which has no channels.
    is_end: bool,
}

/// The part of the tree that was read so far.
#[derive(Default)]
struct Hierarchy {
    /// Ends of chains are joints too, since they say where a bone points.
    joints: Vec<CaptureJoint>,
    /// One list a joint.
    channels: Vec<Vec<BvhChannel>>,
    /// Blocks whose braces are open, the innermost last.
    open: Vec<Block>,
    /// A block that was named and whose brace is to follow.
    announced: Option<Block>,
}

impl Hierarchy {
    fn read_line(&mut self, line: BvhLine) -> Result<(), FormatError> {
        let text = line.text;
        let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
        match word.to_ascii_uppercase().as_str() {
            "" | "HIERARCHY" => {}
            "ROOT" | "JOINT" => self.begin(line, rest.trim(), false)?,
            "END" => self.begin(line, "", true)?,
            "{" => match self.announced.take() {
                Some(block) => self.open.push(block),
                None => return Err(line.error("`{`", "a joint before it")),
            },
            "}" => {
                if self.open.pop().is_none() {
                    return Err(line.error("`}`", "an open brace before it"));
                }
            }
            "OFFSET" => {
                let Some(block) = self.open.last() else {
                    return Err(line.error("OFFSET", "a joint around it"));
                };
                let mut words = rest.split_ascii_whitespace();
                let mut offset = DVec3::ZERO;
                for axis in 0..3 {
                    offset[axis] = line.number(words.next())?;
                }
                self.joints[block.joint].offset = offset;
            }
            "CHANNELS" => self.read_channels(line, rest)?,
            _ => {
                let found = format!("`{}`", excerpt(line.text));
                let expected = "ROOT, JOINT, End Site, OFFSET, CHANNELS, a brace or MOTION";
                return Err(line.error(found, expected));
            }
        }
        Ok(())
    }

    /// A joint or the end of a chain, in the joint whose brace is open.
    fn begin(&mut self, line: BvhLine, name: &str, is_end: bool) -> Result<(), FormatError> {
        let parent = self.open.last();
        if parent.is_some_and(|parent| parent.is_end) || (is_end && parent.is_none()) {
            let found = format!("`{}`", excerpt(line.text));
            return Err(line.error(found, "a joint around it, if any"));
        }
        if self.announced.is_some() {
            return Err(line.error(format!("`{}`", excerpt(line.text)), "`{`"));
        }
        if self.joints.len() == MAX_JOINTS {
            return Err(line.error(format!("more than {MAX_JOINTS} joints"), "at most as many"));
        }
        let parent = parent.map(|block| block.joint);
        let name = match parent {
            Some(parent) if is_end => format!("{} end", self.joints[parent].name),
            _ if name.is_empty() => return Err(line.error("no name", "a joint's name")),
            _ => excerpt(name),
        };
        self.announced = Some(Block {
            joint: self.joints.len(),
            is_end,
        });
        self.channels.push(vec![]);
        self.joints.push(CaptureJoint {
            name,
            parent,
            offset: DVec3::ZERO,
            rest: DQuat::IDENTITY,
        });
        Ok(())
    }

    fn read_channels(&mut self, line: BvhLine, rest: &str) -> Result<(), FormatError> {
        let Some(&Block {
            joint,
            is_end: false,
        }) = self.open.last()
        else {
            return Err(line.error("CHANNELS", "a joint around it"));
        };
        let mut words = rest.split_ascii_whitespace();
        let count = line.number(words.next())?;
        let channels: Vec<BvhChannel> = words
            .map(|word| channel(line, word))
            .collect::<Result<_, _>>()?;
        if channels.len() as f64 != count || !self.channels[joint].is_empty() {
            let found = format!("{} channels", channels.len());
            return Err(line.error(found, &format!("{count}, once a joint")));
        }
        self.channels[joint] = channels;
        Ok(())
    }

    fn finish(&self) -> Result<(), FormatError> {
        let expected = "every brace closed before MOTION";
        if let Some(block) = self.open.last().or(self.announced.as_ref()) {
            let found = format!("`{}` without its end", self.joints[block.joint].name);
            return Err(FormatError::container(found, expected));
        }
        if self.channels.iter().all(Vec::is_empty) {
            return Err(FormatError::container(
                "no joint with channels",
                "at least one",
            ));
        }
        Ok(())
    }
}

fn channel(line: BvhLine, word: &str) -> Result<BvhChannel, FormatError> {
    let lower = word.to_ascii_lowercase();
    let axis = lower.bytes().next().unwrap_or_default().wrapping_sub(b'x');
    match (usize::from(axis), lower.get(1..)) {
        (axis @ 0..3, Some("position")) => Ok(BvhChannel::Position(axis)),
        (axis @ 0..3, Some("rotation")) => Ok(BvhChannel::Rotation(axis)),
        _ => Err(line.error(
            format!("`{}`", excerpt(word)),
            "Xposition to Zposition or Xrotation to Zrotation",
        )),
    }
}
