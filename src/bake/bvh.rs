//! Biovision motion capture (`.bvh`) in; a tree of joints with their channels, and one row of numbers a frame, out.

use super::text::{Error, Line};
use glam::{DQuat, DVec3};
use std::path::Path;

/// What one number of a frame does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// Moves along axis 0, 1 or 2.
    Position(usize),
    /// Turns about axis 0, 1 or 2, degrees; a joint's rotations apply in the file's order, the last one first.
    Rotation(usize),
}

#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    pub name: String,
    pub parent: Option<usize>,
    /// From the parent, the file's unit.
    pub offset: DVec3,
    pub channels: Vec<Channel>,
    /// Where the joint's numbers begin in a frame.
    pub start: usize,
}

/// A clip as its file has it. A parent stands before its children.
#[derive(Clone, Debug, PartialEq)]
pub struct Bvh {
    pub joints: Vec<Joint>,
    /// Seconds.
    pub frame_time: f64,
    /// Numbers a frame.
    pub width: usize,
    /// Shape frames, `width`.
    pub values: Vec<f64>,
}

impl Bvh {
    pub fn parse(file: &Path, text: &str) -> Result<Self, Error> {
        let mut lines = Line::all(file, text);
        let mut hierarchy = Hierarchy::default();
        let end =
            Error::Content { file: file.to_path_buf(), found: "no MOTION section".into(), expected: "one after the HIERARCHY".into() };
        loop {
            let Some(line) = lines.next() else { return Err(end) };
            if line.text.starts_with("MOTION") {
                break;
            }
            hierarchy.line(line)?;
        }
        let width = hierarchy.width;
        let mut header = |name: &str| -> Result<f64, Error> {
            let missing =
                Error::Content { file: file.to_path_buf(), found: "the end of the file".into(), expected: format!("\"{name} number\"") };
            let line = lines.next().ok_or(missing)?;
            let value = line.text.strip_prefix(name).ok_or_else(|| line.error(line.text, format!("\"{name} number\"")))?;
            line.real(&mut value.split_whitespace(), "a number")
        };
        let (frames, frame_time) = (header("Frames:")?, header("Frame Time:")?);
        let mut values = Vec::new();
        for line in lines {
            let row = line.words().map(|word| line.real(&mut std::iter::once(word), "a number")).collect::<Result<Vec<f64>, _>>()?;
            if row.len() != width {
                return Err(line.error(format!("{} numbers", row.len()), format!("{width}, one a channel")));
            }
            values.extend(row);
        }
        let found = values.len().checked_div(width).unwrap_or(0);
        if found == 0 || found as f64 != frames || frame_time <= 0.0 {
            let expected = "as many as the file announces, at least one, and a frame time above 0".into();
            let found = format!("{found} frames of {frame_time} s where {frames} are announced");
            return Err(Error::Content { file: file.to_path_buf(), found, expected });
        }
        Ok(Self { joints: hierarchy.joints, frame_time, width, values })
    }

    pub fn frames(&self) -> usize {
        self.values.len() / self.width
    }

    /// Rotation of a joint relative to its parent.
    pub fn rotation(&self, frame: usize, joint: usize) -> DQuat {
        let joint = &self.joints[joint];
        let values = &self.values[frame * self.width + joint.start..];
        joint.channels.iter().zip(values).fold(DQuat::IDENTITY, |turn, (channel, value)| match channel {
            Channel::Rotation(axis) => turn * DQuat::from_axis_angle(DVec3::AXES[*axis], value.to_radians()),
            Channel::Position(_) => turn,
        })
    }

    /// Position of a joint relative to its parent: its position channels where it has them, else its offset.
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

#[derive(Default)]
struct Hierarchy {
    joints: Vec<Joint>,
    /// Joints whose braces are open; None for an end site.
    open: Vec<Option<usize>>,
    next: Option<Option<usize>>,
    width: usize,
}

impl Hierarchy {
    fn line(&mut self, line: Line) -> Result<(), Error> {
        let mut words = line.words();
        match words.next() {
            Some("HIERARCHY") => {}
            Some(word @ ("ROOT" | "JOINT")) => {
                let parent = self.open.last().copied().flatten();
                if (word == "ROOT") != self.joints.is_empty() || (word == "JOINT" && parent.is_none()) {
                    return Err(line.error(word, "one ROOT, and every JOINT inside it"));
                }
                let name = words.next().ok_or_else(|| line.error("no name", "a joint's name"))?.to_owned();
                self.next = Some(Some(self.joints.len()));
                self.joints.push(Joint { name, parent, offset: DVec3::ZERO, channels: Vec::new(), start: self.width });
            }
            Some("End") => self.next = Some(None),
            Some("{") => self.open.push(self.next.take().ok_or_else(|| line.error("{", "a joint before it"))?),
            Some("}") => self.open.pop().map(|_| ()).ok_or_else(|| line.error("}", "an open brace before it"))?,
            Some("OFFSET") => {
                let offset = line.point(&mut words)?.into();
                match self.open.last() {
                    Some(&Some(joint)) => self.joints[joint].offset = offset,
                    Some(None) => {}
                    None => return Err(line.error("OFFSET", "a joint around it")),
                }
            }
            Some("CHANNELS") => self.channels(line, words)?,
            other => return Err(line.error(other.unwrap_or_default(), "ROOT, JOINT, End Site, OFFSET, CHANNELS, a brace or MOTION")),
        }
        Ok(())
    }

    fn channels<'a>(&mut self, line: Line<'a>, mut words: impl Iterator<Item = &'a str>) -> Result<(), Error> {
        let &Some(joint) = self.open.last().unwrap_or(&None) else { return Err(line.error("CHANNELS", "a joint around it")) };
        let count: usize = line.number(words.next(), "the number of channels")?;
        let channels = words.map(|word| channel(line, word)).collect::<Result<Vec<_>, _>>()?;
        if channels.len() != count || !self.joints[joint].channels.is_empty() {
            return Err(line.error(format!("{} channels", channels.len()), format!("{count}, once a joint")));
        }
        self.joints[joint].start = self.width;
        self.width += count;
        self.joints[joint].channels = channels;
        Ok(())
    }
}

fn channel(line: Line, word: &str) -> Result<Channel, Error> {
    let axis = word.bytes().next().and_then(|first| b"XYZ".iter().position(|&axis| axis == first));
    match (axis, word.get(1..)) {
        (Some(axis), Some("position")) => Ok(Channel::Position(axis)),
        (Some(axis), Some("rotation")) => Ok(Channel::Rotation(axis)),
        _ => Err(line.error(format!("\"{word}\""), "Xposition to Zposition or Xrotation to Zrotation")),
    }
}
