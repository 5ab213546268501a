//! The levels of an avatar, from the finest to the coarsest.

use super::assemble;
use super::fit::{self, FitOptions, ImageSize};
use super::measure::measure;
use super::merge::MergeTree;
use super::still::still;
use super::views::{self, LevelTarget, LevelView, UNIT, height, views};
use effigy_core::avatar::{Avatar, Level, Pose, motion::Player};
use effigy_core::scene::{Camera, Posed};
use effigy_math::{poses, sampling::evenly_spaced, splatter::placed};
use glam::DVec3;

/// A level has one Gaussian for so many of the avatar's. Files and memory grow by 5/6 of what
/// Gaussians take of them.
const ONE_IN: &[usize] = &[2, 4, 16, 64];
/// Fewer for an avatar without networks, whose file has little but its Gaussians: those of a level
/// deflate less, since neighbours are further apart. A file grows by a third at most.
const ONE_IN_STILL: &[usize] = &[6, 24, 96];
/// The height that a level of so many Gaussians is for, px: a quarter of the Gaussians serve half
/// the height, since they are twice as large.
const FOR_HEIGHT: f64 = 120.0;
const FOR_GAUSSIANS: f64 = 50_000.0;
/// Networks move levels that are for this height or more, px. Less tall, images of an avatar whose
/// networks stand still are as near to supersampled ones (docs/experiments/045).
const WITH_CORRECTIVES: f64 = 80.0;

/// Heights of the largest images, in units of [`UNIT`] pixels. All other images are averages of
/// these, of whole pixels.
const LARGEST: [usize; 4] = [6, 12, 24, 48];

/// What a level is for.
struct LevelPlan {
    /// Number of Gaussians.
    gaussians: usize,
    /// Height of the avatar in the image, in units.
    height: f64,
}

impl LevelPlan {
    fn new(gaussians: usize) -> Self {
        let height = FOR_HEIGHT * (gaussians as f64 / FOR_GAUSSIANS).sqrt();
        Self {
            gaussians,
            height: height / UNIT as f64,
        }
    }

    /// The levels of an avatar, from the finest on.
    fn all(avatar: &Avatar) -> Vec<Self> {
        let one_in = if avatar.networks.layers.is_empty() {
            ONE_IN_STILL
        } else {
            ONE_IN
        };
        one_in
            .iter()
            .map(|one_in| Self::new(avatar.gaussians.len() / one_in))
            .filter(|plan| plan.gaussians >= FEWEST)
            .collect()
    }

    fn has_correctives(&self) -> bool {
        self.height * UNIT as f64 >= WITH_CORRECTIVES
    }
}

/// Heights of images, in units.
struct Heights {
    largest: usize,
}

impl Heights {
    /// For levels of which this is the finest.
    fn new(finest: &LevelPlan) -> Self {
        let enough = |largest: &usize| *largest as f64 >= 1.5 * finest.height;
        let largest = LARGEST.into_iter().find(enough);
        Self {
            largest: largest.unwrap_or(LARGEST[LARGEST.len() - 1]),
        }
    }

    /// All that the largest images can be averaged to.
    fn all(&self) -> impl Iterator<Item = usize> {
        (1..=self.largest).filter(|units| self.largest.is_multiple_of(*units))
    }

    /// The nearest of [`Self::all`], by its ratio.
    fn nearest(&self, units: f64) -> usize {
        let ratio = |&at: &usize| (at as f64 / units).ln().abs();
        self.all()
            .min_by(|a, b| ratio(a).total_cmp(&ratio(b)))
            .unwrap_or(self.largest)
    }

    /// Images to fit a level to: a little smaller and a little larger than what it is for, and with
    /// half of the samples twice as large, which shows more.
    fn fitted(&self, plan: &LevelPlan) -> Vec<ImageSize> {
        let size = |units, samples| ImageSize {
            units: self.nearest(units),
            samples,
        };
        vec![
            size(plan.height / 1.5, 4),
            size(plan.height * 1.4, 4),
            size(plan.height * 2.0, 2),
        ]
    }

    /// Heights to measure a level at.
    fn measured(&self, plan: &LevelPlan) -> impl Iterator<Item = usize> {
        let range = self.nearest(plan.height / 3.0)..=self.nearest(plan.height * 2.0);
        self.all().filter(move |units| range.contains(units))
    }
}

/// Samples a pixel along each axis that levels are measured with.
const SAMPLES: [usize; 3] = [1, 2, 4];
/// Poses that tell how far two Gaussians move apart.
const MERGE_POSES: usize = 6;
/// Images that levels are measured by.
const HELD_OUT_IMAGES: usize = 12;
/// Fewest Gaussians that a level may have.
const FEWEST: usize = 64;

/// How levels are made.
#[derive(Clone, Debug)]
pub struct LevelOptions {
    /// Images that levels are fitted to: each pose is seen from as many sides.
    pub images: usize,
    /// Steps of each level's fit; with none, levels are merged only.
    pub steps: usize,
    /// Decides the sides and the order of images.
    pub seed: u64,
}

impl Default for LevelOptions {
    fn default() -> Self {
        Self {
            images: 96,
            steps: 300,
            seed: 1,
        }
    }
}

/// Poses to make levels with.
#[derive(Clone, Debug)]
pub struct LevelPoses {
    /// Levels are fitted to images of these.
    pub training: Vec<Pose>,
    /// And measured in these.
    pub held_out: Vec<Pose>,
}

/// How many poses there are of each kind.
const POSES: [usize; 2] = [24, 3];

impl LevelPoses {
    /// Poses of clips, none of them in both sets; without clips random ones.
    pub fn new(avatar: &Avatar, players: &[Player], seed: u64) -> Self {
        let [training, held_out] = POSES;
        if players.is_empty() {
            return Self {
                training: poses::random(avatar, training, seed),
                held_out: poses::random(avatar, held_out, seed.wrapping_add(1)),
            };
        }
        Self {
            training: poses::from_clips(players, training, 0.25),
            held_out: poses::from_clips(players, held_out, 0.5),
        }
    }

    /// Measures in the poses of another clip.
    pub fn measure_in(&mut self, player: Player) {
        self.held_out = poses::from_clips(&[player], POSES[1], 0.5);
    }
}

/// What is being done.
#[derive(Clone, Copy, Debug)]
pub struct LevelProgress {
    /// For users.
    pub step: &'static str,
    /// Units of work that are done.
    pub done: usize,
    /// Units of work in all.
    pub all: usize,
}

/// Makes the levels of an avatar, whatever levels it has. Levels that would be too small are left
/// out; there may be none.
///
/// # Panics
/// Where [`Avatar::check`] finds a fault.
pub fn levels_of(
    avatar: &Avatar,
    poses: &LevelPoses,
    options: &LevelOptions,
    progress: &mut dyn FnMut(LevelProgress),
) -> Vec<Level> {
    let whole = avatar.gaussians.len();
    let plans = LevelPlan::all(avatar);
    let Some(finest) = plans.first() else {
        return vec![];
    };
    if poses.training.is_empty() || poses.held_out.is_empty() {
        return vec![];
    }
    let sides = options.images.div_ceil(poses.training.len());
    let training = views(avatar, &poses.training, sides, options.seed);
    let held_out = held_out_views(avatar, poses, options);
    let images = training.len() + held_out.len();
    let all = images + plans.len() * options.steps;
    let mut tell = |step, done| progress(LevelProgress { step, done, all });
    let heights = Heights::new(finest);
    let mut seen = vec![0.0; whole];
    let mut draw = |views: &[LevelView], before: usize, seen: &mut [f64]| {
        views::targets(avatar, views, heights.largest, seen, &mut |done| {
            tell("drawing the whole avatar", before + done);
        })
    };
    let training = draw(&training, 0, &mut seen);
    let held_out = draw(&held_out, training.len(), &mut vec![0.0; whole]);
    tell("merging", images);
    let inputs: Vec<Vec<f64>> = poses
        .training
        .iter()
        .map(|pose| avatar.inputs.from_pose(pose))
        .collect();
    let still = still(avatar, &inputs);
    let mut maker = LevelMaker {
        avatar,
        hierarchy: hierarchy(avatar, &still, &poses.training, &seen),
        still,
        training,
        held_out,
        heights,
        options,
    };
    let mut levels: Vec<Level> = Vec::new();
    for (index, plan) in plans.iter().enumerate() {
        maker.hierarchy.merge_to(plan.gaussians);
        // Parts of one Gaussian each can't be merged further.
        let before = levels.last().map_or(whole, |level| level.gaussians.len());
        if maker.hierarchy.count() >= before {
            break;
        }
        let done = images + index * options.steps;
        levels.push(maker.level(plan, &mut |step| tell("fitting", done + step)));
    }
    levels
}

/// Makes levels from Gaussians that are merged further for each.
struct LevelMaker<'a> {
    avatar: &'a Avatar,
    /// Without networks.
    still: Avatar,
    hierarchy: MergeTree,
    training: Vec<LevelTarget>,
    held_out: Vec<LevelTarget>,
    heights: Heights,
    options: &'a LevelOptions,
}

impl LevelMaker<'_> {
    /// A level of the Gaussians as they are merged now, fitted and measured. `progress` is called
    /// with the number of steps done.
    fn level(&self, plan: &LevelPlan, progress: &mut dyn FnMut(usize)) -> Level {
        let avatar = self.avatar;
        let source = if plan.has_correctives() {
            avatar
        } else {
            &self.still
        };
        let whole = avatar.gaussians.len();
        let rows = avatar.color_rows.gaussian.len() * plan.gaussians / whole;
        let merged = assemble::level(source, self.hierarchy.parts(), rows);
        let options = FitOptions {
            steps: self.options.steps,
            sizes: self.heights.fitted(plan),
            seed: self.options.seed,
        };
        let mut level = fit::fit(avatar, &merged, &self.training, &options, progress);
        let drawn = avatar.at_level(&level);
        level.measured = self
            .heights
            .measured(plan)
            .flat_map(|units| SAMPLES.map(|samples| (units, samples)))
            .map(|(units, samples)| measure(&drawn, &self.held_out, units, samples))
            .collect();
        level
    }
}

/// The views that levels are measured in.
fn held_out_views(avatar: &Avatar, poses: &LevelPoses, options: &LevelOptions) -> Vec<LevelView> {
    let sides = HELD_OUT_IMAGES.div_ceil(poses.held_out.len().max(1));
    views(avatar, &poses.held_out, sides, !options.seed)
}

/// The avatar before its first merge. `still`: without networks.
fn hierarchy(avatar: &Avatar, still: &Avatar, poses: &[Pose], seen: &[f64]) -> MergeTree {
    let indices: Vec<usize> = (0..poses.len()).collect();
    // Colours that depend on the view are merged by what all views have in common.
    let unlit = Avatar {
        sh: None,
        ..avatar.clone()
    };
    let camera = Camera::look_at(DVec3::Z, DVec3::ZERO, 1.0, [1, 1]);
    let centers: Vec<Vec<DVec3>> = evenly_spaced(&indices, MERGE_POSES)
        .into_iter()
        .map(|at| {
            placed(&unlit, &Posed::new(avatar, &poses[at]), &camera)
                .iter()
                .map(|placed| placed.mean.as_dvec3())
                .collect()
        })
        .collect();
    MergeTree::new(assemble::blobs(still, seen, &centers), height(avatar))
}
