//! The flicker of a case: a renderer and the case's scenes go in; what changes from frame to frame
//! in its images, and in the reference's, comes out.
//!
//! Every frame is drawn, so that what a frame takes over from the one before counts; the
//! reference's images, which take seconds, are of the frames of
//! [`flicker_pairs`](super::flicker_pairs).

use super::{
    backend::Result,
    case::BenchCase,
    check::{CheckResult, covered_pixels},
    flicker_pairs::{FramePair, pairs},
    run::{CaseRenderer, Progress},
    scene::{BenchScene, PosedInstance},
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
    frame::{FrameState, PlanInput, RendererOptions, room::Room},
    reference::{self, Gaussian, Sorting, SurfaceView},
    scene::{AvatarBounds, PartDependencies, PixelRect},
};
use std::{
    collections::{BTreeSet, HashMap, VecDeque},
    rc::Rc,
};

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

/// The flicker of a setting, and its error on the way.
pub struct MeasuredFlicker {
    /// The worst error of the compared frames.
    pub checked: CheckResult,
    /// The flicker.
    pub report: FlickerReport,
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
    let dependencies = PartDependencies::new(avatar);
    let mut state = FrameState::default();
    let mut plan = |scene: &BenchScene| {
        let poses: Vec<_> = scene.instances.iter().map(|own| &own.drawn).collect();
        let plan = state.plan(PlanInput {
            poses: &poses,
            camera: &scene.camera,
            bounds,
            dependencies: &dependencies,
            options,
            room: Room::unlimited(poses.len()),
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

/// Draws a case's scenes in order and measures what flickers. `flip`: whether to compute FLIP of
/// the error too; that of the flicker always is.
///
/// # Errors
/// When the device fails.
pub fn measure_flicker(
    renderer: &mut CaseRenderer,
    scenes: &[BenchScene],
    truth: &mut FlickerTruth,
    flip: bool,
    progress: Progress,
) -> Result<MeasuredFlicker> {
    let options = *renderer.options();
    let shown = shown(truth.avatar, &truth.bounds, scenes, &options);
    let pairs = pairs(truth.case, &shown);
    let frames: BTreeSet<usize> = pairs.iter().flat_map(|pair| [pair.from, pair.to]).collect();
    let mut drawn: HashMap<usize, ImagePart> = HashMap::new();
    let mut checked = CheckResult::default();
    let mut covered = 0;
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
        covered += covered_pixels(&image);
        let truth_image = truth.image(index, scene, truth.factor(scene));
        let expected = truth_image.part.whole(image.size);
        let flip = flip.then(|| flip::between(&image, &expected).covered);
        let error = ErrorReport::new(&error::between(&image, &expected), flip);
        checked.error = Some(checked.error.map_or(error, |worst| worst.worse(error)));
        drawn.insert(index, ImagePart::of(&image, truth_image.part.rect));
    }
    checked.covered = (!frames.is_empty()).then(|| covered as f64 / frames.len() as f64);
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
    Ok(MeasuredFlicker {
        checked,
        report: FlickerReport::new(&STEPS, reports, truth.sorting()),
    })
}
