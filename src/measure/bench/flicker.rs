//! The flicker of a case: a renderer and the case's scenes go in; what changes from frame to frame
//! in its images, and in the reference's, comes out.
//!
//! Every frame is drawn, so that what a frame takes over from the one before counts; the
//! reference's images, which take seconds, are of the frames of some pairs.

use super::{
    case::{BenchCase, BenchScene, PosedInstance, TAKE},
    frames::{BenchRenderer, Checked, Progress, Result},
};
use crate::{
    error,
    flicker::{
        Carrying, FlickerReport, ImagePart, PairReport, Residual, ResidualMap, STEPS, Shown,
        SortingResidual, carrying::SurfaceFrame,
    },
    flip,
    report::ErrorReport,
};
use effigy_core::{
    avatar::{Avatar, Filter},
    frame::{
        AvatarId, AvatarTraits, FrameState, PlanInput, RendererOptions, capacity::Capacity,
        people::PlannedPerson,
    },
    reference::{self, Gaussian, Sorting, SurfaceView},
    scene::{AvatarBounds, PixelRect},
};
use std::{
    collections::{BTreeSet, HashMap, VecDeque},
    rc::Rc,
};

/// First frames of the pairs of a take: one late enough that the frames before it are of the same
/// take, and one near the take's end.
const STARTS: [usize; 2] = [2, 9];
/// Pairs of a zoom for each distance between frames, besides those around switches.
const ZOOM_PAIRS: usize = 10;

/// Pixels around what the reference draws: as far as FLIP's filters reach, and then some.
const MARGIN: u32 = 16;
/// Longest side up to which the truth is what the area of each pixel shows, px: larger avatars are
/// drawn as large as they are shown, whatever the frames before showed.
const SMALL: f64 = 440.0;
/// Most times as large as the image that the truth is drawn.
const TRUTH_FACTOR: u32 = 8;
/// Longest side of an avatar that a zoom's truth is not drawn beyond, px.
const TRUTH_SIDE: f64 = 4096.0;
/// Longest side of an avatar beyond which a pixel's surface needs no more than one ray, px.
const SURFACE_SIDE: f64 = 512.0;
/// Frames whose Gaussians are kept: those of a take.
const FRAMES_KEPT: usize = 4;

/// What the reference knows of a case's scenes, each thing computed once for all settings.
pub struct FlickerTruth<'a> {
    case: BenchCase,
    avatar: &'a Avatar,
    bounds: AvatarBounds,
    /// The low-pass of what is drawn as large as it is shown.
    filter: Filter,
    /// Whether to sort every pixel for itself too.
    per_pixel: bool,
    /// Gaussians of the last frames, by index.
    gaussians: VecDeque<(usize, Rc<Vec<Gaussian>>)>,
    /// By index and by how many times the frame's size they are drawn.
    images: HashMap<(usize, u32), Rc<TruthImage>>,
    /// By their indices.
    pairs: HashMap<[usize; 2], Rc<PairTruth>>,
}

/// The reference's image of a frame.
struct TruthImage {
    part: ImagePart,
    /// With every pixel sorted for itself.
    per_pixel: Option<ImagePart>,
}

/// What the reference knows of two frames.
struct PairTruth {
    carrying: Carrying,
    /// How many times their size both are drawn.
    factor: u32,
    reference: ResidualMap,
    summary: Residual,
    sorting: Option<SortingResidual>,
}

impl<'a> FlickerTruth<'a> {
    /// Of an avatar with all its rows. `filter`: the low-pass that it is drawn with if not its own.
    /// `per_pixel`: whether to sort every pixel for itself too, which only large avatars are.
    pub fn new(
        case: BenchCase,
        avatar: &'a Avatar,
        filter: Option<Filter>,
        per_pixel: bool,
    ) -> Self {
        Self {
            case,
            avatar,
            bounds: AvatarBounds::new(avatar).filtered(filter),
            filter: filter.unwrap_or(avatar.filter),
            per_pixel,
            gaussians: VecDeque::new(),
            images: HashMap::new(),
            pairs: HashMap::new(),
        }
    }

    /// Longest side of the boxes around a scene's avatars, px. Infinite where one crosses the near
    /// plane.
    fn side(&self, scene: &BenchScene) -> f64 {
        let side = |instance: &PosedInstance| {
            let sides = self.bounds.sides(&instance.reference.joints, &scene.camera);
            sides.map_or(f64::INFINITY, |sides| sides.max_element())
        };
        scene.instances.iter().map(side).fold(0.0, f64::max)
    }

    /// How many times its size the truth of a scene is drawn.
    fn factor(&self, scene: &BenchScene) -> u32 {
        let side = self.side(scene);
        match self.case {
            BenchCase::Zoom => largest_factor(side, TRUTH_SIDE),
            _ if side <= SMALL => TRUTH_FACTOR,
            _ => 1,
        }
    }

    fn gaussians(&mut self, index: usize, scene: &BenchScene) -> Rc<Vec<Gaussian>> {
        if let Some((_, kept)) = self.gaussians.iter().find(|(own, _)| *own == index) {
            return Rc::clone(kept);
        }
        let poses: Vec<_> = scene.instances.iter().map(|own| &own.reference).collect();
        let made = Rc::new(reference::gaussians_of(self.avatar, &poses, &scene.camera));
        if self.gaussians.len() == FRAMES_KEPT {
            self.gaussians.pop_front();
        }
        self.gaussians.push_back((index, Rc::clone(&made)));
        made
    }

    /// The part of the image that a frame shows something in. The whole image where it may be more.
    fn rect(&self, gaussians: &[Gaussian], scene: &BenchScene) -> PixelRect {
        let camera = &scene.camera;
        let splats = reference::project::splats(gaussians, camera, self.filter, 0);
        let whole = PixelRect::whole(camera.size);
        let drawn = reference::drawn_rect(&splats, 1.0, camera.size);
        let inside = drawn.min.cmpgt(whole.min).all() && drawn.max.cmplt(whole.max).all();
        if drawn.is_empty() || !inside {
            return whole;
        }
        PixelRect {
            min: drawn.min.saturating_sub(glam::UVec2::splat(MARGIN)),
            max: (drawn.max + MARGIN).min(whole.max),
        }
    }

    fn image(&mut self, index: usize, scene: &BenchScene, factor: u32) -> Rc<TruthImage> {
        if let Some(image) = self.images.get(&(index, factor)) {
            return Rc::clone(image);
        }
        let gaussians = self.gaussians(index, scene);
        let rect = self.rect(&gaussians, scene);
        let camera = scene.camera.cropped(rect);
        let part = |image| ImagePart { rect, image };
        let sorted = |sorting| {
            part(reference::render_sorted(
                &gaussians,
                &camera,
                self.filter,
                sorting,
            ))
        };
        let image = if factor > 1 {
            let filter = self.avatar.filter;
            TruthImage {
                part: part(reference::average_of(&gaussians, &camera, factor, filter)),
                per_pixel: None,
            }
        } else {
            TruthImage {
                part: sorted(Sorting::Centers),
                per_pixel: self.per_pixel.then(|| sorted(Sorting::PerPixel)),
            }
        };
        let image = Rc::new(image);
        self.images.insert((index, factor), Rc::clone(&image));
        image
    }

    fn pair(&mut self, pair: &FramePair, scenes: &[BenchScene]) -> Rc<PairTruth> {
        let indices = [pair.from, pair.to];
        if let Some(known) = self.pairs.get(&indices) {
            return Rc::clone(known);
        }
        let gaussians = indices.map(|index| self.gaussians(index, &scenes[index]));
        let frames: [SurfaceFrame; 2] = std::array::from_fn(|k| SurfaceFrame {
            view: SurfaceView {
                gaussians: &gaussians[k],
                camera: &scenes[indices[k]].camera,
                filter: self.avatar.filter,
            },
            rect: self.rect(&gaussians[k], &scenes[indices[k]]),
        });
        let sides = indices.map(|index| self.side(&scenes[index]));
        let samples = largest_factor(sides[0].max(sides[1]), SURFACE_SIDE);
        let carrying = Carrying::new(&frames[0], &frames[1], samples);
        // Both at one factor: the truth has no switches.
        let factor = self
            .factor(&scenes[pair.from])
            .min(self.factor(&scenes[pair.to]));
        let images = indices.map(|index| self.image(index, &scenes[index], factor));
        let reference = carrying.residual(&images[0].part, &images[1].part, true);
        let exact = images[0]
            .per_pixel
            .as_ref()
            .zip(images[1].per_pixel.as_ref());
        let sorting = exact.map(|(earlier, later)| {
            let exact = carrying.residual(earlier, later, true);
            SortingResidual {
                per_pixel: exact.summary(),
                added: reference.added_to(&exact),
            }
        });
        let truth = Rc::new(PairTruth {
            factor,
            summary: reference.summary(),
            reference,
            sorting,
            carrying,
        });
        self.pairs.insert(indices, Rc::clone(&truth));
        truth
    }

    /// The worst error of the reference's images against those that sort every pixel for itself.
    fn sorting(&self) -> Option<ErrorReport> {
        let errors = self.images.values().filter_map(|image| {
            let exact = image.per_pixel.as_ref()?;
            let flip = flip::between(&image.part.image, &exact.image).covered;
            let error = error::between(&image.part.image, &exact.image);
            Some(ErrorReport::new(&error, Some(flip)))
        });
        errors.reduce(ErrorReport::worse)
    }
}

/// The largest factor of 1, 2, 4 and 8 that keeps an avatar's longest side within a limit, px.
fn largest_factor(side: f64, limit: f64) -> u32 {
    [TRUTH_FACTOR, 4, 2]
        .into_iter()
        .find(|&factor| f64::from(factor) * side <= limit)
        .unwrap_or(1)
}

/// How a renderer with these options draws the avatar in each scene: as it plans its frames, from
/// the last scene on.
fn shown(
    avatar: &Avatar,
    bounds: &AvatarBounds,
    scenes: &[BenchScene],
    options: &RendererOptions,
) -> Vec<Shown> {
    let traits = AvatarTraits::new(avatar, bounds.clone());
    let mut state = FrameState::default();
    let mut plan = |scene: &BenchScene| {
        let people = scene.instances.iter().map(|own| PlannedPerson {
            avatar: AvatarId::FIRST,
            traits: &traits,
            posed: &own.drawn,
        });
        let people: Vec<_> = people.collect();
        let plan = state.plan(PlanInput {
            people: &people,
            camera: &scene.camera,
            options,
            capacity: Capacity::unlimited(people.len()),
            always_submit: false,
        });
        Shown {
            samples: plan
                .atlas
                .as_ref()
                .and_then(|atlas| atlas.slots.first())
                .map_or(1.0, |slot| slot.factor),
            gaussians: plan.instances().map(|own| own.gaussians).sum(),
        }
    };
    if let Some(last) = scenes.last() {
        plan(last);
    }
    scenes.iter().map(plan).collect()
}

/// Draws a case's scenes in order and measures what flickers, and the error on the way. `flip`:
/// whether to compute FLIP of the error too; that of the flicker always is.
///
/// # Errors
/// When the device fails.
pub fn measure_flicker(
    renderer: &mut BenchRenderer,
    scenes: &[BenchScene],
    truth: &mut FlickerTruth,
    flip: bool,
    progress: Progress,
) -> Result<(Checked, FlickerReport)> {
    let options = *renderer.options();
    let shown = shown(truth.avatar, &truth.bounds, scenes, &options);
    let pairs = pairs(truth.case, &shown);
    let frames: BTreeSet<usize> = pairs.iter().flat_map(|pair| [pair.from, pair.to]).collect();
    let mut drawn: HashMap<usize, ImagePart> = HashMap::new();
    let mut checked = Checked::default();
    if let Some(last) = scenes.last() {
        renderer.draw(last)?;
    }
    for (index, scene) in scenes.iter().enumerate() {
        progress("drawing for flicker", index, scenes.len());
        renderer.draw(scene)?;
        if !frames.contains(&index) {
            continue;
        }
        let image = renderer.image()?;
        let truth_image = truth.image(index, scene, truth.factor(scene));
        let expected = truth_image.part.whole(image.size);
        checked.add(&image, &expected, flip);
        drawn.insert(index, ImagePart::of(&image, truth_image.part.rect));
    }
    let mut reports = Vec::with_capacity(pairs.len());
    for (done, pair) in pairs.iter().enumerate() {
        progress("carrying frames", done, pairs.len());
        let known = truth.pair(pair, scenes);
        let residual = known
            .carrying
            .residual(&drawn[&pair.from], &drawn[&pair.to], true);
        let side = truth.side(&scenes[pair.from]);
        reports.push(PairReport {
            from: pair.from,
            to: pair.to,
            weight: pair.weight,
            side: side.is_finite().then_some(side),
            shown: [shown[pair.from], shown[pair.to]],
            truth: known.factor,
            compared: known.carrying.compared() as f64 / known.carrying.covered().max(1) as f64,
            drawn: residual.summary(),
            reference: known.summary,
            added: residual.added_to(&known.reference),
            sorting: known.sorting,
        });
    }
    Ok((
        checked,
        FlickerReport::new(&STEPS, reports, truth.sorting()),
    ))
}

/// Two frames to compare.
#[derive(Clone, Copy, Debug, PartialEq)]
struct FramePair {
    /// Index of the earlier frame.
    from: usize,
    /// Index of the later one.
    to: usize,
    /// For how many pairs of the run it stands.
    weight: f64,
}

/// The pairs to compare, by their first frame. `shown`: how each frame draws the avatar.
fn pairs(case: BenchCase, shown: &[Shown]) -> Vec<FramePair> {
    let mut pairs: Vec<FramePair> = STEPS
        .into_iter()
        .flat_map(|step| match case {
            BenchCase::Zoom => zoom_pairs(shown, step),
            _ => take_pairs(shown.len(), step),
        })
        .collect();
    pairs.sort_by_key(|pair| (pair.from, pair.to));
    pairs
}

/// Pairs of every take, from frames that are shared as far as possible: a reference's image takes
/// seconds.
fn take_pairs(frames: usize, step: usize) -> Vec<FramePair> {
    let mut pairs = Vec::new();
    for first in (0..frames).step_by(TAKE) {
        let length = TAKE.min(frames - first);
        let starts = if step == 1 {
            STARTS
        } else {
            [STARTS[0], STARTS[0] + 1]
        };
        let mut starts: Vec<usize> = starts
            .into_iter()
            .filter(|start| start + step < length)
            .collect();
        if starts.is_empty() && step < length {
            starts.push(length - 1 - step);
        }
        pairs.extend(starts.into_iter().map(|start| FramePair {
            from: first + start,
            to: first + start + step,
            weight: 1.0,
        }));
    }
    pairs
}

/// Pairs all along the way, and one around each switch. A switch stands for the pairs of the run
/// that have it between them, the others for all that have none.
fn zoom_pairs(shown: &[Shown], step: usize) -> Vec<FramePair> {
    let Some(all) = shown.len().checked_sub(step).filter(|&all| all > 0) else {
        return Vec::new();
    };
    let switches = |from: usize| {
        shown[from..=from + step]
            .windows(2)
            .any(|two| two[0].switches_to(&two[1]))
    };
    let mut pairs: Vec<FramePair> = Vec::new();
    for at in (1..shown.len()).filter(|&at| shown[at - 1].switches_to(&shown[at])) {
        let from = at.saturating_sub(step.div_ceil(2)).min(all - 1);
        if pairs.iter().all(|pair| pair.from != from) {
            pairs.push(FramePair {
                from,
                to: from + step,
                weight: step as f64,
            });
        }
    }
    let steady: Vec<usize> = (0..all)
        .step_by(all.div_ceil(ZOOM_PAIRS))
        .filter(|&from| !switches(from))
        .collect();
    let switching: f64 = pairs.iter().map(|pair| pair.weight).sum();
    let weight = (all as f64 - switching).max(0.0) / steady.len().max(1) as f64;
    pairs.extend(steady.into_iter().map(|from| FramePair {
        from,
        to: from + step,
        weight,
    }));
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(samples: f64) -> Shown {
        Shown {
            samples,
            gaussians: 100,
        }
    }

    #[test]
    fn takes_are_compared_within_themselves() {
        for frames in [1, 2, 3, 7, 8, 12, 13, 24, 31] {
            let pairs = pairs(BenchCase::Flicker, &vec![shown(1.0); frames]);
            for pair in &pairs {
                assert!(
                    pair.from < pair.to && pair.to < frames,
                    "{pair:?} of {frames}"
                );
                assert_eq!(pair.from / TAKE, pair.to / TAKE, "{pair:?}");
            }
            let has = |step| pairs.iter().any(|pair| pair.to - pair.from == step);
            assert_eq!(
                STEPS.map(has),
                STEPS.map(|step| frames > step),
                "{frames} frames"
            );
        }
        let mut frames: Vec<usize> = pairs(BenchCase::Flicker, &[shown(1.0); 24])
            .iter()
            .flat_map(|pair| [pair.from, pair.to])
            .collect();
        frames.sort_unstable();
        frames.dedup();
        assert_eq!(frames, [2, 3, 9, 10, 14, 15, 21, 22]);
    }

    #[test]
    fn a_zoom_has_a_pair_at_every_switch_and_counts_it_once() {
        let mut run = vec![shown(1.0); 200];
        let level = |samples: f64, gaussians| Shown { samples, gaussians };
        // More and more samples, which are no switch but where they begin; then other levels.
        for (at, own) in run.iter_mut().enumerate().skip(70) {
            *own = level(1.0 + 0.02 * (at - 69) as f64, 100);
        }
        run[120..].fill(level(4.0, 50));
        run[199] = level(4.0, 25);
        let pairs = pairs(BenchCase::Zoom, &run);
        for step in STEPS {
            let own: Vec<&FramePair> = pairs.iter().filter(|p| p.to - p.from == step).collect();
            for at in [70, 120, 199] {
                let around = own.iter().filter(|pair| pair.from < at && pair.to >= at);
                assert_eq!(around.count(), 1, "at {at}, {step} apart");
            }
            let weights: f64 = own.iter().map(|pair| pair.weight).sum();
            assert!((weights - (200 - step) as f64).abs() < 1e-9, "{weights}");
        }
        assert_eq!(super::pairs(BenchCase::Zoom, &run[..1]), []);
    }
}
