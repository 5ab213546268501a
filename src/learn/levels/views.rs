//! What a level should look like: images of the whole avatar from many sides and in many poses,
//! drawn much larger than needed and averaged.

use effigy_core::avatar::{Avatar, Pose};
use effigy_core::random::Random;
use effigy_core::scene::{AvatarBounds, Camera, FrameImage, Posed};
use effigy_math::splatter::{Blended, ImageSplat, Projection, placed, shapes};
use effigy_measure::viewpoint::FOV;
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Heights at which levels are fitted and measured are multiples of this, px.
pub const UNIT: usize = 10;
/// What images should show is drawn at this many times their size along each axis.
const SUPERSAMPLING: usize = 8;
/// And at most this many units tall: of taller ones fewer samples tell as much.
const TALLEST: usize = 192;
/// Images that are drawn side by side: more would take more memory.
const BATCH: usize = 8;
/// Radians above and below the horizon that cameras look from.
const PITCHES: [f64; 2] = [-0.35, 0.7];

/// A pose seen by a camera.
#[derive(Clone, Debug)]
pub struct LevelView {
    /// Which of the poses it is.
    pub pose: usize,
    /// The pose, evaluated.
    pub posed: Posed,
    /// For an avatar of [`UNIT`] pixels.
    pub camera: Camera,
}

impl LevelView {
    /// The camera for an avatar of so many units.
    pub fn camera_at(&self, units: usize) -> Camera {
        self.camera
            .stretched(self.camera.size.map(|side| side * units as u32))
    }
}

/// A view and what it should show.
pub struct LevelTarget {
    /// The view.
    pub view: LevelView,
    /// The avatar, `largest` units tall.
    truth: FrameImage,
    largest: usize,
}

impl LevelTarget {
    /// What an image of the avatar should be at a size. `units` divides that of the largest image.
    pub fn truth(&self, units: usize) -> FrameImage {
        self.truth.averaged((self.largest / units) as u32)
    }
}

/// Height of an avatar in its canonical pose, metres.
pub fn height(avatar: &Avatar) -> f64 {
    let bounds = AvatarBounds::new(avatar);
    let rest = Pose::rest(avatar.skeleton.len(), 0);
    let [min, max] = bounds.bounds(&avatar.skeleton.matrices(&rest));
    (max.y - min.y).max(1e-6)
}

/// Views of poses, `sides` of each, from directions that `seed` decides.
pub fn views(avatar: &Avatar, poses: &[Pose], sides: usize, seed: u64) -> Vec<LevelView> {
    let bounds = AvatarBounds::new(avatar);
    let height = height(avatar);
    let view = |index: usize| {
        let posed = Posed::new(avatar, &poses[index / sides]);
        let mut random = Random::new(seed, index as u64);
        let yaw = TAU * (random.uniform() + (index % sides) as f64) / sides as f64;
        let pitch = random.range(PITCHES[0], PITCHES[1]);
        let corners = bounds.bounds(&posed.joints);
        let camera = Camera {
            near: bounds.framing(&posed.joints).near,
            ..camera(corners, height, yaw, pitch)
        };
        LevelView {
            pose: index / sides,
            posed,
            camera,
        }
    };
    (0..poses.len() * sides).map(view).collect()
}

/// The camera whose image holds a box, in which a body of `height` metres is [`UNIT`] pixels tall.
fn camera(bounds: [DVec3; 2], height: f64, yaw: f64, pitch: f64) -> Camera {
    let middle = (bounds[0] + bounds[1]) / 2.0;
    let distance = Camera::framing_distance(bounds, FOV, [2, 3]);
    let mut camera = Camera::orbit(middle, yaw, pitch, distance, FOV, [1, 1]);
    camera.focal = DVec2::splat(UNIT as f64 * distance / height);
    camera.center = DVec2::ZERO;
    let mut low = DVec2::INFINITY;
    let mut high = DVec2::NEG_INFINITY;
    for corner in 0..8 {
        let corner = DVec3::new(
            bounds[corner & 1].x,
            bounds[corner >> 1 & 1].y,
            bounds[corner >> 2].z,
        );
        let at = camera.project(camera.view.transform_point3(corner));
        low = low.min(at);
        high = high.max(at);
    }
    let size = (high - low).ceil() + 2.0;
    camera.center = 0.5 * (size - (high + low));
    camera.size = [size.x as u32, size.y as u32];
    camera
}

/// The splats of a whole avatar in a view, with the avatar's own filter.
pub fn whole_splats(avatar: &Avatar, view: &LevelView, units: usize) -> Vec<Option<ImageSplat>> {
    let camera = view.camera_at(units);
    let projection = Projection::new(&camera, avatar.filter);
    let opacity = |k: usize| f32::from(avatar.gaussians.opacity[k]) / 255.0;
    shapes(avatar)
        .par_iter()
        .zip(&placed(avatar, &view.posed, &camera))
        .enumerate()
        .map(|(k, (shape, placed))| projection.splat_of(shape, placed, opacity(k)))
        .collect()
}

/// Draws what each view should show, `largest` units tall, and adds to `seen` how many pixels each
/// Gaussian contributes. `progress` is called with the number of images done.
pub fn targets(
    avatar: &Avatar,
    views: &[LevelView],
    largest: usize,
    seen: &mut [f64],
    progress: &mut dyn FnMut(usize),
) -> Vec<LevelTarget> {
    let supersampling = SUPERSAMPLING.min(TALLEST / largest).max(1);
    let mut all = Vec::with_capacity(views.len());
    for batch in views.chunks(BATCH) {
        let draw = |view: &LevelView| {
            let units = largest * supersampling;
            let splats = whole_splats(avatar, view, units);
            let mut own = vec![0.0; splats.len()];
            let size = view.camera_at(units).size;
            let blended = Blended::new(&splats, size, |k, sum, _| own[k] = sum);
            let truth = blended.image.averaged(supersampling as u32);
            let target = LevelTarget {
                view: view.clone(),
                truth,
                largest,
            };
            (target, own)
        };
        let drawn: Vec<(LevelTarget, Vec<f32>)> = batch.par_iter().map(draw).collect();
        for (target, own) in drawn {
            for (sum, own) in seen.iter_mut().zip(own) {
                *sum += f64::from(own);
            }
            all.push(target);
            progress(all.len());
        }
    }
    all
}
