//! Joints that follow each other, and which of them are a limb's by how they move.
//!
//! An upper arm or a thigh is long and turns against the trunk. Collar bones are short and hardly turn.
//! Joints that never bend, as twist joints, divide no bone.

use super::tree::{positions, spread};
use crate::capture::Capture;
use glam::DVec3;

/// Length of a limb's bones beside the longer of the two.
pub const LONG: f64 = 0.7;
/// Length of a forearm beside the upper arm's; a shin is hardly longer.
const SECOND: f64 = 0.9;
/// How far a bone turns in a tenth of the frames at least, radians.
const TURNS: f64 = 0.26;
/// How far two bones in a line bend against each other in all but a tenth of the frames, radians.
const STRAIGHT: f64 = 0.14;

/// Three joints of a limb: shoulder, elbow and wrist, or hip, knee and ankle.
pub type LimbJoints = [usize; 3];

/// Joints from a trunk to the end of a limb, and where they are.
pub struct Chain {
    /// Without the trunk.
    pub joints: Vec<usize>,
    /// A list for each frame, in the trunk's axes.
    at: Vec<Vec<DVec3>>,
}

impl Chain {
    /// Joints below a trunk that follow each other.
    pub fn new(capture: &Capture, trunk: usize, joints: Vec<usize>) -> Self {
        let frames = spread(capture.frames()).map(|frame| {
            let world = capture.world(frame);
            let inner = world[trunk].inverse();
            let at = positions(&world);
            let place = |&joint: &usize| inner.transform_point3(at[joint]);
            joints.iter().map(place).collect()
        });
        let at = frames.collect();
        Self { joints, at }
    }

    /// From one joint to another in each frame.
    fn ways(&self, from: usize, to: usize) -> impl Iterator<Item = DVec3> + Clone {
        self.at.iter().map(move |at| at[to] - at[from])
    }

    /// The mean of the distances of two joints.
    pub fn length(&self, from: usize, to: usize) -> f64 {
        self.ways(from, to).map(DVec3::length).sum::<f64>() / self.at.len().max(1) as f64
    }

    /// How far what is between two joints turns against the trunk, radians.
    fn turn(&self, from: usize, to: usize) -> f64 {
        let ways = self.ways(from, to).filter_map(DVec3::try_normalize);
        let Some(mean) = ways.clone().sum::<DVec3>().try_normalize() else {
            return 0.0;
        };
        nine_tenths(ways.map(|way| way.angle_between(mean)).collect())
    }

    /// Whether it turns as far as a limb does.
    pub fn turns(&self, from: usize, to: usize) -> bool {
        self.turn(from, to) > TURNS
    }

    /// The last joint of those that are in a line with a bone that begins at a joint.
    pub fn line(&self, from: usize) -> usize {
        let mut end = from + 1;
        while end + 1 < self.joints.len() {
            let bends = self.ways(from, end).zip(self.ways(end, end + 1));
            let bends = bends
                .map(|(a, b)| a.angle_between(b))
                .filter(|bend| bend.is_finite());
            if nine_tenths(bends.collect()) > STRAIGHT {
                break;
            }
            end += 1;
        }
        end
    }

    /// The places in the chain of the limb's joints, if the motion shows them: of bones that are alike
    /// and turn the two longest. `first`: where the limb begins by its lengths, beyond which the end of
    /// the chain is no bone of it.
    pub fn shown(&self, first: usize) -> Option<LimbJoints> {
        let last = self.joints.len().checked_sub(1)?;
        let mut shown = None;
        let mut longest = 0.0;
        let mut from = 0;
        loop {
            let middle = self.line(from).min(last);
            if middle == last {
                return shown;
            }
            let far = self.line(middle);
            let own = self.length(from, middle);
            let length = |end: usize| self.length(middle, end);
            // A hand that never bends is in line with the forearm.
            let unlike = |end: &usize| (length(*end) / (SECOND * own)).ln().abs();
            let inner = far.min(last - 1).max(middle + 1);
            let end = (middle + 1..=inner).min_by(|a, b| unlike(a).total_cmp(&unlike(b)))?;
            let whole = if far < last { far } else { end };
            let turn = self.turn(from, middle);
            if (end < last || (from <= first && shown.is_none()))
                && own >= LONG * length(whole)
                && length(end) >= LONG * own
                && turn > TURNS.max(self.turn(middle, far) / 2.0)
                && own + length(end) > longest
            {
                longest = own + length(end);
                shown = Some([from, middle, end]);
            }
            from = middle;
        }
    }
}

/// What all but a tenth of some numbers are under.
fn nine_tenths(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let at = values.len() * 9 / 10;
    values
        .get(at.min(values.len().saturating_sub(1)))
        .copied()
        .unwrap_or_default()
}
