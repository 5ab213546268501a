//! How well an avatar follows a capture, in numbers.

use super::{
    align::Basis,
    chain::LimbJoints,
    feet::{FootPath, Soles},
    humanoid::{Humanoid, Leg},
    tree,
    upright::Unit,
};
use effigy_core::avatar::{Pose, Skeleton};
use glam::DVec3;
use std::ops::Range;

/// A number over a clip.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// The mean.
    pub mean: f64,
    /// The largest.
    pub max: f64,
}

impl Spread {
    /// Of these numbers; zeros if there are none.
    pub fn of(values: impl Iterator<Item = f64>) -> Self {
        let mut sum = Sum::default();
        values.for_each(|value| sum.add(value));
        sum.spread()
    }
}

/// A spread of the numbers so far.
#[derive(Default)]
struct Sum {
    count: f64,
    sum: f64,
    max: f64,
}

impl Sum {
    fn add(&mut self, value: f64) {
        self.count += 1.0;
        self.sum += value;
        self.max = self.max.max(value);
    }

    fn spread(&self) -> Spread {
        Spread {
            mean: self.sum / self.count.max(1.0),
            max: self.max,
        }
    }
}

/// What was found in a capture, and how well the avatar follows it. The capture counts in the
/// avatar's metres: scaled so that legs are as long.
#[derive(Clone, Debug)]
pub struct Report {
    /// Parts and the joints that were taken for them.
    pub joints: Vec<JointGuess>,
    /// What aligns both bodies.
    pub basis: Basis,
    /// The file's axis that points up.
    pub up: DVec3,
    /// The unit of the file: said by it, else guessed from the legs.
    pub unit: Unit,
    /// Metres of the avatar a metre of the capture's body.
    pub scale: f64,
    /// The avatar's joints that move, of all.
    pub driven: usize,
    /// Joints of the avatar.
    pub all: usize,
    /// Between the heights of the hips over the lower ankle, metres.
    pub hips: Spread,
    /// Between positions of elbows, wrists, knees, ankles and head, each from the hips, metres.
    pub positions: Spread,
    /// Between the directions of upper arms, forearms, thighs and shins, degrees. The capture's are
    /// those that its motion shows, whatever was taken for them.
    pub directions: Spread,
    /// Contacts of both feet with the ground.
    pub contacts: usize,
    /// Share of all frames and feet that stand.
    pub standing: f64,
    /// Speed of the avatar's ball over the ground in contacts, metres a second.
    pub slide: Spread,
    /// Speed of the capture's ball over the ground in contacts, metres of the avatar a second.
    pub source_slide: Spread,
    /// How deep the avatar's soles are under the ground, metres.
    pub sink: Spread,
    /// None: the avatar's thickness is not known.
    pub arms: Option<ArmsInside>,
}

/// How much deeper the avatar's arms are inside its trunk than the capture's are inside a trunk like
/// it, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmsInside {
    /// With the capture's rotations.
    pub before: Spread,
    /// In the clip.
    pub after: Spread,
}

/// A part and the joint that was taken for it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JointGuess {
    /// Its name in Effigy's own rigs.
    pub part: String,
    /// The joint's name in the file.
    pub joint: String,
}

/// Frames of both bodies, side by side.
pub struct Compared<'a> {
    /// The capture's body.
    pub source: &'a Humanoid,
    /// Its limbs as its motion shows them.
    pub limbs: &'a [LimbJoints],
    /// Its joints, metres of the avatar and y up, a list a frame.
    pub world: &'a [Vec<DVec3>],
    /// The avatar.
    pub skeleton: &'a Skeleton,
    /// Its body.
    pub target: &'a Humanoid,
    /// Its legs.
    pub target_legs: &'a [Leg; 2],
    /// Its poses.
    pub poses: &'a [Pose],
    /// Where each foot stands.
    pub contacts: &'a [Vec<Range<usize>>; 2],
    /// The ways of the capture's feet.
    pub tracks: &'a [FootPath; 2],
    /// Frames a second.
    pub rate: f64,
}

/// The differences between two bodies.
pub struct Differences {
    /// See [`Report::hips`].
    pub hips: Spread,
    /// See [`Report::positions`].
    pub positions: Spread,
    /// See [`Report::directions`].
    pub directions: Spread,
    /// See [`Report::slide`].
    pub slide: Spread,
    /// See [`Report::source_slide`].
    pub source_slide: Spread,
    /// See [`Report::sink`].
    pub sink: Spread,
}

/// A bone, as joints of both bodies.
struct Pair {
    source: [usize; 2],
    target: [usize; 2],
}

/// The long bones of the capture's limbs and of the avatar's.
fn bones(source: &[LimbJoints], target: &Humanoid) -> Vec<Pair> {
    let arms = target.arms.iter();
    let arms = arms.map(|arm| [arm.upper, arm.forearm, arm.hand]);
    let legs = target.legs().iter();
    let legs = legs.map(|leg| [leg.thigh, leg.shin, leg.foot]);
    let limbs = source.iter().zip(arms.chain(legs));
    let bones = limbs.flat_map(|(source, target)| {
        [0, 1].map(|at| Pair {
            source: [source[at], source[at + 1]],
            target: [target[at], target[at + 1]],
        })
    });
    bones.collect()
}

/// Height of the hips over the lower ankle: soles are of different heights. None: no legs.
fn hips_height(humanoid: &Humanoid, at: &[DVec3]) -> Option<f64> {
    let [left, right] = humanoid.legs.as_ref()?.each_ref().map(|leg| at[leg.foot].y);
    Some(humanoid.middle_of_hips(at).y - left.min(right))
}

impl Compared<'_> {
    /// Compares them.
    pub fn differences(&self) -> Differences {
        let soles = Soles::new(self.skeleton, self.target_legs);
        let bones = bones(self.limbs, self.target);
        let mut hips = Sum::default();
        let mut positions = Sum::default();
        let mut directions = Sum::default();
        let mut sink = Sum::default();
        let mut balls: [Vec<DVec3>; 2] = Default::default();
        for (pose, theirs) in self.poses.iter().zip(self.world) {
            let joints = self.skeleton.joints(pose);
            let own = tree::positions(&joints);
            let heights = hips_height(self.target, &own).zip(hips_height(self.source, theirs));
            if let Some((own, theirs)) = heights {
                hips.add((own - theirs).abs());
            }
            let from_hips = |humanoid: &Humanoid, at: &[DVec3], joint: usize| {
                at[joint] - humanoid.middle_of_hips(at)
            };
            let heads = [self.source.head, self.target.head];
            let limbs = bones.iter().map(|bone| [bone.source[1], bone.target[1]]);
            for [source, target] in limbs.chain([heads]) {
                let source = from_hips(self.source, theirs, source);
                positions.add(source.distance(from_hips(self.target, &own, target)));
            }
            for bone in &bones {
                let along =
                    |at: &[DVec3], [from, to]: [usize; 2]| (at[to] - at[from]).try_normalize();
                // A bone without length points nowhere.
                let both = along(theirs, bone.source).zip(along(&own, bone.target));
                if let Some((source, target)) = both {
                    directions.add(source.angle_between(target).to_degrees());
                }
            }
            for (foot, balls) in balls.iter_mut().enumerate() {
                balls.push(soles.ball(foot, &joints));
                sink.add((-soles.lowest(foot, &joints)).max(0.0));
            }
        }
        Differences {
            hips: hips.spread(),
            positions: positions.spread(),
            directions: directions.spread(),
            slide: self.slide([&balls[0], &balls[1]]),
            source_slide: self.slide([&self.tracks[0].ball, &self.tracks[1].ball]),
            sink: sink.spread(),
        }
    }

    /// Speeds over the ground during contacts.
    fn slide(&self, balls: [&[DVec3]; 2]) -> Spread {
        let each = balls.into_iter().zip(self.contacts);
        Spread::of(each.flat_map(|(ball, contacts)| {
            contacts.iter().flat_map(move |contact| {
                let frames = &ball[contact.clone()];
                let step = |pair: &[DVec3]| (pair[1] - pair[0]).with_y(0.0).length() * self.rate;
                frames.windows(2).map(step)
            })
        }))
    }
}
