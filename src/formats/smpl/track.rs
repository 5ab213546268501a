//! A person's motion as a file has it, and as a capture.

use super::{
    body::{self, Family},
    fields::Table,
    timeline::{Slot, Timeline},
};
use crate::{
    assumption::Assumption,
    capture::{Capture, Captured, LocalPose, UpAxis, check_size, checked_rate},
    smpl_joints::SMPL_X,
};
use effigy_core::io::file::FormatError;
use glam::{DMat3, DQuat, DVec3};
use std::{ops::Range, rc::Rc};

/// Frames a second where neither the file nor its format says.
const RATE: f64 = 30.0;
/// How far a matrix may be from a rotation.
const MATRIX_SLACK: f64 = 1e-2;

/// Rotations of consecutive joints.
pub struct ChainRotations {
    /// Axis-angle in radians, or matrices in rows.
    pub table: Rc<Table>,
    pub matrices: bool,
    /// Which rotation of a row is the first joint's.
    pub first: usize,
    /// Of SMPL-X.
    pub joints: Range<usize>,
}

/// What a file's translation is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The model's origin: the pelvis is at its place at rest beside it.
    Origin,
    /// The middle between the hip joints.
    Hips,
}

/// A person's motion.
pub struct Track {
    pub family: Family,
    /// In the order of their joints, which no two share.
    pub parts: Vec<ChainRotations>,
    /// Width 3, metres.
    pub translation: Option<Table>,
    pub anchor: Anchor,
    pub expression: Option<Table>,
    /// Where frames are not one after another.
    pub timeline: Option<Timeline>,
    pub rate: Option<f64>,
    pub up: UpAxis,
    pub assumptions: Vec<Assumption>,
}

impl ChainRotations {
    /// Axis-angle rotations of some of a row's joints.
    pub fn axes(table: impl Into<Rc<Table>>, first: usize, joints: Range<usize>) -> Self {
        Self {
            table: table.into(),
            matrices: false,
            first,
            joints,
        }
    }

    /// The rotation of one of its joints. None: the numbers are no rotation.
    fn rotation(&self, frame: usize, joint: usize) -> Option<DQuat> {
        let at = self.first + joint - self.joints.start;
        let row = self.table.row(frame);
        if !self.matrices {
            let &[x, y, z] = row.get(3 * at..)?.first_chunk()?;
            return Some(DQuat::from_scaled_axis(DVec3::new(
                x.into(),
                y.into(),
                z.into(),
            )));
        }
        let rows: &[f32; 9] = row.get(9 * at..)?.first_chunk()?;
        let matrix = DMat3::from_cols_array(&rows.map(f64::from)).transpose();
        let turns = (matrix * matrix.transpose()).abs_diff_eq(DMat3::IDENTITY, MATRIX_SLACK)
            && matrix.determinant() > 0.0;
        turns.then(|| DQuat::from_mat3(&matrix).normalize())
    }
}

/// The error of a file with fewer people.
pub fn no_such_person(person: usize, people: usize) -> FormatError {
    FormatError::container(
        format!("{people} people"),
        format!("at least {}, of whom one was asked for", person + 1),
    )
}

impl Track {
    /// The motion of one of the people whom its arrays count first.
    pub fn of_person(mut self, person: usize) -> Result<Self, FormatError> {
        let tables = self.parts.iter().map(|part| &*part.table);
        let people = tables.map(|table| table.people).max().unwrap_or(1);
        if person >= people {
            return Err(no_such_person(person, people));
        }
        if people == 1 {
            return Ok(self);
        }
        let parts = self.parts.iter().map(|part| &*part.table);
        let others = self.translation.iter().chain(&self.expression);
        if let Some(odd) = parts
            .chain(others)
            .find(|table| table.people != 1 && table.people != people)
        {
            return Err(FormatError::container(
                format!("an array of {} people beside one of {people}", odd.people),
                "as many people in each",
            ));
        }
        for part in &mut self.parts {
            part.table = Rc::new(part.table.of_person(person));
        }
        for table in [&mut self.translation, &mut self.expression] {
            *table = table.take().map(|table| table.of_person(person));
        }
        self.assumptions.push(Assumption {
            what: "person",
            taken: format!("{} of {people}", person + 1),
            because: "arrays have people before frames".into(),
        });
        Ok(self)
    }

    /// The motion of a skeleton of an average body. `rate`: frames a second; None: as the file
    /// says. `size`: bytes of the file, unpacked.
    pub fn into_capture(mut self, rate: Option<f64>, size: usize) -> Result<Captured, FormatError> {
        let rate = self.rate(rate)?;
        let given = self.parts.iter().map(|part| part.table.rows()).max();
        let given = given.unwrap_or_default();
        let tables = self.parts.iter().map(|part| &*part.table);
        let tables = tables.chain(&self.translation).chain(&self.expression);
        let numbered = self.timeline.iter().map(|timeline| timeline.rows);
        let rows = tables.map(Table::rows).filter(|rows| *rows != 1);
        if let Some(rows) = rows.chain(numbered).find(|rows| *rows != given) {
            return Err(FormatError::container(
                format!("arrays of {given} and of {rows} frames"),
                "as many of each",
            ));
        }
        let frames = match &self.timeline {
            Some(timeline) => timeline.slots.len(),
            None => given,
        };
        let kept: Vec<usize> = self
            .parts
            .iter()
            .flat_map(|part| part.joints.clone())
            .collect();
        check_size(frames, kept.len(), size)?;
        let expression_len = self.expression.as_ref().map_or(0, |table| table.width);
        let mut capture = Capture {
            joints: body::joints(self.family, |joint| kept.contains(&joint)),
            rate,
            local: Vec::with_capacity(frames * kept.len()),
            unit: Some(1.0),
            up: self.up,
            model_rest: true,
            expression: Vec::with_capacity(frames * expression_len),
            expression_len,
        };
        let said = |assumption: &Assumption| assumption.what == "place";
        if self.translation.is_none() && !self.assumptions.iter().any(said) {
            self.assumptions.push(Assumption {
                what: "place",
                taken: "the same in each frame".into(),
                because: "the file has none in metres".into(),
            });
        }
        for frame in 0..frames {
            let slot = match &self.timeline {
                Some(timeline) => timeline.slots[frame],
                None => Slot {
                    before: frame,
                    after: frame,
                    share: 0.0,
                },
            };
            self.pose(slot, &mut capture)?;
        }
        if let Some(timeline) = &self.timeline
            && timeline.filled + timeline.left_out > 0
        {
            self.assumptions.push(Assumption {
                what: "frames without the person",
                taken: format!(
                    "{} filled in, {} of another time left out",
                    timeline.filled, timeline.left_out
                ),
                because: "the person was not seen in each frame".into(),
            });
        }
        self.assumptions.push(Assumption {
            what: "rest pose",
            taken: "a T-pose of an average body".into(),
            because: "the file has no skeleton".into(),
        });
        Ok(Captured {
            capture,
            assumptions: self.assumptions,
        })
    }

    fn rate(&mut self, said: Option<f64>) -> Result<f64, FormatError> {
        // What the file or its format says goes before what the user says for files that don't.
        let rate = self.rate.or(said);
        if rate.is_none() {
            self.assumptions.push(Assumption {
                what: "frames a second",
                taken: RATE.to_string(),
                because: "the file does not say".into(),
            });
        }
        checked_rate(rate.unwrap_or(RATE))
    }

    fn pose(&self, slot: Slot, capture: &mut Capture) -> Result<(), FormatError> {
        let mix = |a: f32, b: f32| f64::from(a) + slot.share * f64::from(b - a);
        let translation = self.translation.as_ref().map_or(DVec3::ZERO, |table| {
            let [a, b] = [slot.before, slot.after].map(|frame| table.row(frame));
            DVec3::new(mix(a[0], b[0]), mix(a[1], b[1]), mix(a[2], b[2]))
        });
        for part in &self.parts {
            for joint in part.joints.clone() {
                let at = |frame: usize| {
                    part.rotation(frame, joint).ok_or_else(|| {
                        let name = SMPL_X[joint].name;
                        FormatError::container(
                            format!("frame {frame} of {name}, which is no rotation"),
                            "matrices that turn",
                        )
                    })
                };
                let mut rotation = at(slot.before)?;
                if slot.share > 0.0 {
                    rotation = rotation.slerp(at(slot.after)?, slot.share);
                }
                let offset = match joint {
                    0 if self.anchor == Anchor::Hips => {
                        translation - rotation * body::between_hips()
                    }
                    0 => translation + body::offset(0, self.family),
                    _ => body::offset(joint, self.family),
                };
                capture.local.push(LocalPose::new(rotation, offset));
            }
        }
        if let Some(table) = &self.expression {
            let [a, b] = [slot.before, slot.after].map(|frame| table.row(frame));
            let mixed = a.iter().zip(b).map(|(&a, &b)| mix(a, b) as f32);
            capture.expression.extend(mixed);
        }
        Ok(())
    }
}
