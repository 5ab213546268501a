//! Moves an avatar as a capture of any other body moves.
//!
//! 1. `humanoid` finds hips, spine, limbs and head in both skeletons, by names (`names`) or by the
//!    tree's shape (`shape`) and what moves (`chain`).
//! 2. `standing` finds the axis that points up, `upright` turns the file's axes, and `align` finds how its joints stand when the avatar is in
//!    its rest pose.
//! 3. `transfer` gives each joint of the avatar the rotation of its counterpart; legs' lengths are
//!    the scale.
//! 4. `feet` holds standing feet in place and soles above the ground.
//! 5. `arms` turns arms out of the trunk, whose thickness `girth` measures.
//! 6. `report` measures what is left between the two, along the limbs that `moving` finds in the motion
//!    alone.

mod align;
mod arms;
mod chain;
mod curl;
mod feet;
mod girth;
mod humanoid;
mod legs;
mod moving;
mod names;
mod part;
mod report;
mod shape;
mod standing;
mod transfer;
mod tree;
mod turn;
mod upright;
mod window;

pub use align::Basis;
pub use girth::{Girth, TrunkSkin};
pub use humanoid::Correction;
pub use report::{ArmsInside, JointGuess, Report, Spread};
pub use turn::shorter;
pub use upright::Unit;

use crate::{assumption::Assumption, capture::Capture};
use align::{Alignment, Bodies};
use arms::{Body, Depths};
use chain::LimbJoints;
use effigy_core::{
    avatar::{Clip, Pose, Skeleton, motion::Player},
    io::file::FormatError,
};
use feet::FootPath;
use glam::{DAffine3, DVec3};
use humanoid::{Humanoid, Leg, NamedPart};
use report::Compared;
use std::ops::Range;
use transfer::Transfer;
use tree::{Tree, positions};
use upright::Upright;

/// How a capture becomes a clip.
#[derive(Clone, Debug, Default)]
pub struct RetargetOptions {
    /// Frames a second; None: the capture's own, at most [`MAX_RATE`].
    pub rate: Option<f64>,
    /// Joints of the capture that are other parts than they seem.
    pub corrections: Vec<Correction>,
    /// Leaves feet where the joints' rotations put them.
    pub keep_feet: bool,
    /// The avatar's thickness: keeps arms out of its trunk. None: they may enter it.
    pub girth: Option<Girth>,
}

/// Frames a second that a clip has at most unless its user says another number: clips are
/// interpolated when they are played.
pub const MAX_RATE: f64 = 60.0;

/// Most rotations, frames × joints of the avatar or of the capture, that a clip is made of.
const MOST_ROTATIONS: f64 = 20e6;
/// Length of a capture's legs, its own units, and metres of the avatar a unit: beyond these numbers
/// are nobody's.
const PLAUSIBLE: std::ops::RangeInclusive<f64> = 1e-4..=1e5;

/// A clip and how it was made.
#[derive(Clone, Debug)]
pub struct Retargeted {
    /// Moves the skeleton; its soles touch y = 0.
    pub clip: Clip,
    /// What was found and measured.
    pub report: Report,
    /// What the capture leaves open.
    pub assumptions: Vec<Assumption>,
}

/// Makes a clip of a capture for a skeleton, whose rest pose stands upright, y up, and faces +z.
/// `name`: the clip's.
///
/// # Errors
/// When no body is found in either.
pub fn retarget(
    capture: &Capture,
    skeleton: &Skeleton,
    name: &str,
    options: &RetargetOptions,
) -> Result<Retargeted, FormatError> {
    let matched = Match::new(capture, skeleton, &options.corrections)?;
    let rate = options.rate.unwrap_or(capture.rate.min(MAX_RATE));
    let Match { source, target, .. } = &matched;
    let transfer = Transfer::new(skeleton, source, target, &matched.alignment, matched.scale);
    let count = matched.count(capture.duration(), rate)?;
    let mut poses: Vec<Pose> = Vec::with_capacity(count);
    let way = matched.way(count, rate, |joints| poses.push(transfer.pose(joints)));
    let legs = &matched.target_legs;
    if options.keep_feet || source.legs.is_none() {
        feet::stand(skeleton, legs, &mut poses);
    } else {
        feet::place(skeleton, legs, &mut poses, &way.contacts, rate);
    }
    let girth = options.girth.as_ref();
    let arms = girth.map(|girth| {
        let body = matched.body(girth);
        let theirs = body.of_captures(&poses, source, &way.world);
        let before = excess(&body.excess(&poses, &theirs));
        body.move_out(&mut poses, &theirs, rate);
        ArmsInside {
            before,
            after: excess(&body.excess(&poses, &theirs)),
        }
    });
    Ok(Retargeted {
        clip: clip(capture, skeleton, name, rate, &poses),
        report: matched.report(&poses, &way, transfer.driven(), arms),
        assumptions: matched.assumptions,
    })
}

/// Measures how well a clip follows a capture, whoever made it. Both begin at the same moment.
///
/// # Errors
/// When no body is found in either.
pub fn compare(
    clip: &Clip,
    capture: &Capture,
    skeleton: &Skeleton,
    corrections: &[Correction],
) -> Result<Report, FormatError> {
    let matched = Match::new(capture, skeleton, corrections)?;
    let seconds = clip.duration().min(capture.duration());
    let count = matched.count(seconds, clip.rate)?;
    let player = Player::new(clip.clone(), skeleton);
    let poses = (0..count).map(|frame| player.pose(frame as f64 / clip.rate));
    let poses: Vec<Pose> = poses.collect();
    let way = matched.way(count, clip.rate, |_| ());
    Ok(matched.report(&poses, &way, player.mapped(), None))
}

/// How much deeper than the capture's arms are, over frames and arms.
fn excess(depths: &Depths) -> Spread {
    let deeper = depths.iter().flatten();
    Spread::of(deeper.map(|depth| depth.max(0.0)))
}

/// A capture's body beside an avatar's.
struct Match<'a> {
    skeleton: &'a Skeleton,
    tree: Tree,
    source: Humanoid,
    target: Humanoid,
    target_legs: [Leg; 2],
    upright: Upright<'a>,
    alignment: Alignment,
    /// Length of the capture's legs, as its arms show it where it has none; the file's unit.
    leg: f64,
    /// Metres of the avatar a unit of the file.
    scale: f64,
    /// The capture's limbs as its motion shows them.
    limbs: Vec<LimbJoints>,
    assumptions: Vec<Assumption>,
}

/// What a capture does, frame by frame.
struct Way {
    /// Positions of its joints, metres of the avatar and y up.
    world: Vec<Vec<DVec3>>,
    tracks: [FootPath; 2],
    contacts: [Vec<Range<usize>>; 2],
    /// Frames a second.
    rate: f64,
}

impl<'a> Match<'a> {
    fn new(
        capture: &'a Capture,
        skeleton: &'a Skeleton,
        corrections: &[Correction],
    ) -> Result<Self, FormatError> {
        let tree = Tree::of_capture(capture);
        let target_tree = Tree::of_skeleton(skeleton);
        let source = Humanoid::find(&tree, Some(capture), corrections)?;
        let target = Humanoid::find(&target_tree, None, &[]).ok();
        let whole = target.and_then(|target| Some((target.legs.clone()?, target)));
        let (target_legs, target) = whole.ok_or_else(|| {
            FormatError::container(
                format!("an avatar of {} joints without a body", target_tree.len()),
                "one with arms, legs and a head, to be moved by motion of another body",
            )
        })?;
        let up = standing::up_axis(capture, &source);
        let mut assumptions = Vec::from_iter(up.assumption);
        let upright = Upright::new(capture, up.axis);
        let bodies = Bodies {
            tree: &tree,
            source: &source,
            target_tree: &target_tree,
            target: &target,
        };
        let alignment = Alignment::new(&bodies, &upright);
        let first = positions(&upright.world(0));
        let own_leg = target.leg_length(&target_tree.rest).unwrap_or_default();
        let leg = source.leg_length(&first).unwrap_or_else(|| {
            assumptions.push(Assumption {
                what: "legs",
                taken: "at rest".into(),
                because: "no thigh, shin and foot of both sides were found".into(),
            });
            own_leg * source.arm_length(&first) / target.arm_length(&target_tree.rest)
        });
        if !(PLAUSIBLE.contains(&leg) && PLAUSIBLE.contains(&(own_leg / leg))) {
            return Err(FormatError::container(
                format!("legs {leg} units long, the avatar's {own_leg} m"),
                "units from a tenth of a millimetre to kilometres",
            ));
        }
        let limbs = moving::limbs(&tree, &source, capture);
        assumptions.extend(limbs.doubts);
        Ok(Self {
            skeleton,
            tree,
            source,
            target,
            target_legs,
            upright,
            alignment,
            leg,
            scale: own_leg / leg,
            limbs: limbs.joints,
            assumptions,
        })
    }

    fn body<'b>(&'b self, girth: &'b Girth) -> Body<'b> {
        Body {
            skeleton: self.skeleton,
            target: &self.target,
            girth,
        }
    }

    /// Frames of so many seconds.
    fn count(&self, seconds: f64, rate: f64) -> Result<usize, FormatError> {
        let count = (seconds * rate + 1e-6).floor() + 1.0;
        let joints = self.tree.len().max(self.skeleton.len()) as f64;
        if count * joints <= MOST_ROTATIONS {
            return Ok(count as usize);
        }
        Err(FormatError::container(
            format!("{count} frames of {joints} joints: {seconds:.0} s at {rate} a second"),
            format!("at most {MOST_ROTATIONS} rotations; fewer frames a second"),
        ))
    }

    /// `each`: is given the capture's joints in each frame, y up and in the file's unit.
    fn way(&self, count: usize, rate: f64, mut each: impl FnMut(&[DAffine3])) -> Way {
        let world: Vec<Vec<DVec3>> = (0..count)
            .map(|frame| {
                let joints = self.upright.world_at(frame as f64 / rate);
                each(&joints);
                let metres = |at: DVec3| self.scale * at;
                positions(&joints).into_iter().map(metres).collect()
            })
            .collect();
        let tracks = tracks(&self.tree, &self.source, &world);
        let grounds = tracks.each_ref().map(FootPath::ground);
        let ground = grounds[0].min(grounds[1]);
        let contacts = |track: &FootPath| track.contacts(rate, ground);
        Way {
            contacts: tracks.each_ref().map(contacts),
            world,
            tracks,
            rate,
        }
    }

    /// `driven`: joints of the avatar that the clip moves.
    fn report(&self, poses: &[Pose], way: &Way, driven: usize, arms: Option<ArmsInside>) -> Report {
        let compared = Compared {
            source: &self.source,
            world: &way.world,
            skeleton: self.skeleton,
            limbs: &self.limbs,
            target: &self.target,
            target_legs: &self.target_legs,
            poses,
            contacts: &way.contacts,
            tracks: &way.tracks,
            rate: way.rate,
        };
        let differences = compared.differences();
        let standing: usize = way.contacts.iter().flatten().map(Range::len).sum();
        let said = self.upright.capture().unit;
        let unit = said.map_or_else(|| upright::unit(self.leg), upright::said_unit);
        let guess = |named: NamedPart| JointGuess {
            part: named.part,
            joint: named.joint.to_owned(),
        };
        Report {
            joints: self
                .source
                .named(&self.tree)
                .into_iter()
                .map(guess)
                .collect(),
            basis: self.alignment.basis,
            up: self.upright.up(),
            unit,
            scale: self.scale / unit.metres,
            driven,
            all: self.skeleton.len(),
            hips: differences.hips,
            positions: differences.positions,
            directions: differences.directions,
            contacts: way.contacts.iter().map(Vec::len).sum(),
            standing: standing as f64 / (2 * poses.len()).max(1) as f64,
            slide: differences.slide,
            source_slide: differences.source_slide,
            sink: differences.sink,
            arms,
        }
    }
}

/// The ways of both feet, metres of the avatar; none where there are no legs.
fn tracks(tree: &Tree, source: &Humanoid, world: &[Vec<DVec3>]) -> [FootPath; 2] {
    let children = tree.children();
    [0, 1].map(|side| {
        let ball = source.legs().get(side).map(|leg| {
            let ball = leg.ball(&children).unwrap_or(leg.foot);
            world.iter().map(|at| at[ball]).collect()
        });
        FootPath {
            ball: ball.unwrap_or_default(),
        }
    })
}

fn clip(capture: &Capture, skeleton: &Skeleton, name: &str, rate: f64, poses: &[Pose]) -> Clip {
    Clip {
        name: name.into(),
        credit: String::new(),
        rate,
        joint: skeleton.name.clone(),
        rotation: poses
            .iter()
            .flat_map(|pose| pose.rotation.iter().map(|turn| turn.as_vec3().to_array()))
            .collect(),
        translation: poses
            .iter()
            .map(|pose| pose.translation.as_vec3().to_array())
            .collect(),
        expression: expression(capture, rate, poses.len()),
        expression_len: capture.expression_len,
    }
}

/// The expressions of the nearest frames of the capture.
fn expression(capture: &Capture, rate: f64, count: usize) -> Vec<f32> {
    let length = capture.expression_len;
    let row = |frame: usize| {
        let at = (frame as f64 / rate * capture.rate).round() as usize;
        let at = at.min(capture.frames() - 1);
        capture.expression[at * length..][..length].iter().copied()
    };
    (0..count).flat_map(row).collect()
}
