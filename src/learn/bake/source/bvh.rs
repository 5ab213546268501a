//! Biovision motion capture files (`.bvh`): a tree of joints with their channels, and one row of
//! numbers a frame.

use crate::bake::source::text::{SourceError, TextLine};
use glam::{DQuat, DVec3};
use std::path::Path;

/// The meaning of one number of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// Moves along axis 0, 1 or 2.
    Position(usize),
    /// Turns about axis 0, 1 or 2, degrees; a joint's rotations apply in the file's order, the last
    /// one first.
    Rotation(usize),
}

/// A joint of a capture.
#[derive(Clone, Debug, PartialEq)]
pub struct BvhJoint {
    /// The name in the file.
    pub name: String,
    /// An index into [`Bvh::joints`]; `None` for the root.
    pub parent: Option<usize>,
    /// From the parent, the file's unit.
    pub offset: DVec3,
    /// The meaning of the joint's numbers, in their order.
    pub channels: Vec<Channel>,
    /// Where the joint's numbers begin in a frame.
    pub start: usize,
}

/// A capture as in its file. A parent comes before its children.
#[derive(Clone, Debug, PartialEq)]
pub struct Bvh {
    /// In the file's order.
    pub joints: Vec<BvhJoint>,
    /// Seconds.
    pub frame_time: f64,
    /// Numbers a frame.
    pub width: usize,
    /// Shape frames, `width`.
    pub values: Vec<f64>,
}

impl Bvh {
    /// Reads a file's text; `file` is named in errors.
    ///
    /// # Errors
    /// When a line is malformed, or there are not the frames that the file announces.
    pub fn parse(file: &Path, text: &str) -> Result<Self, SourceError> {
        let mut lines = TextLine::all(file, text);
        let mut hierarchy = Hierarchy::default();
        loop {
            let Some(line) = lines.next() else {
                return Err(SourceError::Content {
                    file: file.to_path_buf(),
                    found: "no MOTION section".into(),
                    expected: "one after the HIERARCHY".into(),
                });
            };
            if line.text.starts_with("MOTION") {
                break;
            }
            hierarchy.read_line(line)?;
        }
        let width = hierarchy.width;
        let mut header = |name: &str| -> Result<f64, SourceError> {
            let missing = SourceError::Content {
                file: file.to_path_buf(),
                found: "the end of the file".into(),
                expected: format!("\"{name} number\""),
            };
            let line = lines.next().ok_or(missing)?;
            let value = line
                .text
                .strip_prefix(name)
                .ok_or_else(|| line.error(line.text, format!("\"{name} number\"")))?;
            line.real(&mut value.split_whitespace(), "a number")
        };
        let frames = header("Frames:")?;
        let frame_time = header("Frame Time:")?;
        let mut values = Vec::new();
        for line in lines {
            let row = line
                .words()
                .map(|word| line.real(&mut std::iter::once(word), "a number"))
                .collect::<Result<Vec<f64>, _>>()?;
            if row.len() != width {
                return Err(line.error(
                    format!("{} numbers", row.len()),
                    format!("{width}, one a channel"),
                ));
            }
            values.extend(row);
        }
        let found = values.len().checked_div(width).unwrap_or(0);
        if found == 0 || found as f64 != frames || frame_time <= 0.0 {
            return Err(SourceError::Content {
                file: file.to_path_buf(),
                found: format!("{found} frames of {frame_time} s where {frames} are announced"),
                expected: "as many as the file announces, at least one, and a frame time above 0"
                    .into(),
            });
        }
        Ok(Self {
            joints: hierarchy.joints,
            frame_time,
            width,
            values,
        })
    }

    /// The number of frames.
    pub fn frames(&self) -> usize {
        self.values.len() / self.width
    }

    /// Rotation of a joint relative to its parent.
    pub fn rotation(&self, frame: usize, joint: usize) -> DQuat {
        let joint = &self.joints[joint];
        let values = &self.values[frame * self.width + joint.start..];
        let mut rotation = DQuat::IDENTITY;
        for (channel, value) in joint.channels.iter().zip(values) {
            if let Channel::Rotation(axis) = channel {
                let turn = DQuat::from_axis_angle(DVec3::AXES[*axis], value.to_radians());
                rotation *= turn;
            }
        }
        rotation
    }

    /// Position of a joint relative to its parent: its position channels, or its offset on axes
    /// without one.
    pub fn position(&self, frame: usize, joint: usize) -> DVec3 {
        let joint = &self.joints[joint];
        let values = &self.values[frame * self.width + joint.start..];
        let mut position = joint.offset;
        for (channel, value) in joint.channels.iter().zip(values) {
            if let Channel::Position(axis) = channel {
                position[*axis] = *value;
            }
        }
        position
    }
}

/// The owner of an open brace.
#[derive(Clone, Copy)]
enum Block {
    /// The joint of this index.
    Joint(usize),
    /// The end of a chain, which has no channels.
    EndSite,
}

/// The part of the tree that was read so far.
#[derive(Default)]
struct Hierarchy {
    joints: Vec<BvhJoint>,
    /// Blocks whose braces are open, the innermost last.
    open: Vec<Block>,
    /// A block that was named and whose brace is to follow.
    announced: Option<Block>,
    /// Numbers a frame so far.
    width: usize,
}

impl Hierarchy {
    fn read_line(&mut self, line: TextLine) -> Result<(), SourceError> {
        let mut words = line.words();
        match words.next() {
            Some("HIERARCHY") => {}
            Some(word @ ("ROOT" | "JOINT")) => self.read_joint(line, word, words.next())?,
            Some("End") => self.announced = Some(Block::EndSite),
            Some("{") => match self.announced.take() {
                Some(block) => self.open.push(block),
                None => return Err(line.error("{", "a joint before it")),
            },
            Some("}") => {
                if self.open.pop().is_none() {
                    return Err(line.error("}", "an open brace before it"));
                }
            }
            Some("OFFSET") => {
                let offset = line.point(&mut words)?.into();
                match self.open.last() {
                    Some(&Block::Joint(joint)) => self.joints[joint].offset = offset,
                    Some(Block::EndSite) => {}
                    None => return Err(line.error("OFFSET", "a joint around it")),
                }
            }
            Some("CHANNELS") => self.read_channels(line, words)?,
            other => {
                return Err(line.error(
                    other.unwrap_or_default(),
                    "ROOT, JOINT, End Site, OFFSET, CHANNELS, a brace or MOTION",
                ));
            }
        }
        Ok(())
    }

    /// `word`: ROOT or JOINT.
    fn read_joint(
        &mut self,
        line: TextLine,
        word: &str,
        name: Option<&str>,
    ) -> Result<(), SourceError> {
        let parent = match self.open.last() {
            Some(&Block::Joint(joint)) => Some(joint),
            Some(Block::EndSite) | None => None,
        };
        let is_root = word == "ROOT";
        if is_root != self.joints.is_empty() || (!is_root && parent.is_none()) {
            return Err(line.error(word, "one ROOT, and every JOINT inside it"));
        }
        let name = name.ok_or_else(|| line.error("no name", "a joint's name"))?;
        self.announced = Some(Block::Joint(self.joints.len()));
        self.joints.push(BvhJoint {
            name: name.to_owned(),
            parent,
            offset: DVec3::ZERO,
            channels: Vec::new(),
            start: self.width,
        });
        Ok(())
    }

    fn read_channels<'a>(
        &mut self,
        line: TextLine<'a>,
        mut words: impl Iterator<Item = &'a str>,
    ) -> Result<(), SourceError> {
        let Some(&Block::Joint(joint)) = self.open.last() else {
            return Err(line.error("CHANNELS", "a joint around it"));
        };
        let count: usize = line.number(words.next(), "the number of channels")?;
        let channels = words
            .map(|word| channel(line, word))
            .collect::<Result<Vec<_>, _>>()?;
        if channels.len() != count || !self.joints[joint].channels.is_empty() {
            return Err(line.error(
                format!("{} channels", channels.len()),
                format!("{count}, once a joint"),
            ));
        }
        self.joints[joint].start = self.width;
        self.width += count;
        self.joints[joint].channels = channels;
        Ok(())
    }
}

fn channel(line: TextLine, word: &str) -> Result<Channel, SourceError> {
    let axis = word
        .bytes()
        .next()
        .and_then(|first| b"XYZ".iter().position(|&axis| axis == first));
    match (axis, word.get(1..)) {
        (Some(axis), Some("position")) => Ok(Channel::Position(axis)),
        (Some(axis), Some("rotation")) => Ok(Channel::Rotation(axis)),
        _ => Err(line.error(
            format!("\"{word}\""),
            "Xposition to Zposition or Xrotation to Zrotation",
        )),
    }
}
