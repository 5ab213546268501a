//! A stress case: a seed and a number go in; an avatar, a pose, a camera and options come out.
//! Nothing else decides about it, so that a number replays it anywhere, except on devices that
//! can't draw triangles.

use super::{adversarial, body::below, category::Category, draft::Draft};
use effigy::vulkan::{
    RendererOptions,
    probe::Probe,
    raster::{ColorFormat, RasterMethod},
    sort::KeyBits,
};
use effigy_core::{
    avatar::{Avatar, Pose},
    frame::Skip,
    random::Random,
    reference::{self, Culled, project::Gaussian},
    scene::{Camera, Posed},
};
use glam::DAffine3;

/// Makes the seed of a case's options differ from that of the rest ("options!").
const OPTIONS_SEED: u64 = 0x6f70_7469_6f6e_7321;
/// Moves of the camera that are tried to keep Gaussians off the edges of culling.
const MAX_MOVES: usize = 100;

/// A frame that is hard to draw.
pub struct StressCase {
    /// Number of the case.
    pub number: u64,
    /// Its category.
    pub category: Category,
    /// What was done to it, in words.
    pub note: String,
    /// The avatar to draw.
    pub avatar: Avatar,
    /// Its pose.
    pub pose: Pose,
    /// Moves the posed avatar.
    pub placed: DAffine3,
    /// The posed avatar in its place.
    pub posed: Posed,
    /// Where it is seen from.
    pub camera: Camera,
    /// How to draw it.
    pub options: RendererOptions,
}

/// Random options.
fn options(random: &mut Random, size: [u32; 2]) -> RendererOptions {
    let skip = match below(random, 4) {
        0 => Skip::all(),
        1 | 2 => Skip::empty(),
        _ => Skip::from_bits_truncate(random.bits() as u32),
    };
    RendererOptions {
        color: Some(if below(random, 4) == 0 {
            ColorFormat::Rgba8
        } else {
            ColorFormat::Rgba16F
        }),
        method: Some(RasterMethod::ALL[below(random, RasterMethod::ALL.len())]),
        key_bits: Some(
            [
                KeyBits::Sixteen,
                KeyBits::TwentyFour,
                KeyBits::TwentyFour,
                KeyBits::ThirtyTwo,
            ][below(random, 4)],
        ),
        skip,
        ..RendererOptions::new(size)
    }
}

impl StressCase {
    /// The case of a seed and a number. `large` allows images of 8192 × 8192 px, which take a
    /// second or more.
    pub fn new(seed: u64, number: u64, large: bool) -> Self {
        let random = &mut Random::new(seed, number);
        let options_random = &mut Random::new(seed ^ OPTIONS_SEED, number);
        let category = Category::of_case(number);
        if category == Category::NearPlane {
            return Self::on_the_near_plane(random, options_random, number);
        }
        let mut draft = Draft::new(random);
        adversarial::apply(random, &mut draft, category, large);
        let posed = draft.posed();
        let mut camera = draft.camera(random, &posed);
        let is_inside =
            category == Category::Inside || (category == Category::Mixed && random.uniform() < 0.2);
        if is_inside {
            let gaussians = gaussians(&draft.avatar, &posed);
            camera = adversarial::inside(random, &gaussians, camera);
        }
        let mut case = Self {
            number,
            category,
            note: draft.note,
            avatar: draft.avatar,
            pose: draft.pose,
            placed: draft.placed,
            posed,
            camera,
            options: options(options_random, camera.size),
        };
        case.keep_off_culling_edges();
        case
    }

    fn on_the_near_plane(random: &mut Random, options_random: &mut Random, number: u64) -> Self {
        let options = options(options_random, [64; 2]);
        let scene = adversarial::near_plane(random, options.size);
        Self {
            number,
            category: Category::NearPlane,
            note: scene.note,
            posed: Posed::new(&scene.avatar, &scene.pose),
            avatar: scene.avatar,
            pose: scene.pose,
            placed: DAffine3::IDENTITY,
            camera: scene.camera,
            options,
        }
    }

    /// The case as a device can draw it: by tiles if it can't draw triangles.
    pub fn for_device(mut self, probe: &Probe) -> Self {
        if !probe.draws_triangles() {
            self.options.method = Some(RasterMethod::Tiles);
        }
        self
    }

    /// Moves the near plane and the image slightly until f32 and the stored model's rounding can't
    /// change whether a Gaussian is culled. Otherwise either image would be right.
    fn keep_off_culling_edges(&mut self) {
        let (_, _, stored) = reference::stored(&self.avatar, &self.posed);
        let exact = gaussians(&self.avatar, &self.posed);
        for _ in 0..MAX_MOVES {
            let camera = self.camera;
            let moved = |near: f64, by: f64| Camera {
                near: camera.near * near,
                center: camera.center + by,
                ..camera
            };
            let tolerance = 0.02 + 1e-5 * camera.guard();
            let cameras = [moved(1.0 - 2e-5, tolerance), moved(1.0 + 2e-5, -tolerance)];
            let mut pairs = exact.iter().zip(&stored);
            if !pairs.any(|(exact, stored)| is_on_culling_edge(exact, stored, &cameras)) {
                return;
            }
            self.camera = moved(1.0 + 1.3e-4, 0.17 * tolerance);
        }
        self.note += "; a Gaussian is on the edge of being culled";
    }
}

/// Whether cameras that differ slightly, or a Gaussian and its stored form, disagree about drawing
/// a Gaussian that would be visible.
fn is_on_culling_edge(exact: &Gaussian, stored: &Gaussian, cameras: &[Camera; 2]) -> bool {
    let mut is_drawn = false;
    let mut is_culled = false;
    for camera in cameras {
        for gaussian in [exact, stored] {
            match reference::project::project(gaussian, camera, 0) {
                Ok(_) => is_drawn = true,
                Err(Culled::Behind | Culled::Guard | Culled::Invalid) => is_culled = true,
                // Too faint or too small to be seen, either way.
                Err(_) => {}
            }
        }
    }
    is_drawn && is_culled
}

/// The Gaussians of a posed avatar, by the reference.
fn gaussians(avatar: &Avatar, posed: &Posed) -> Vec<Gaussian> {
    let features = reference::mlp::features(avatar, &posed.input);
    let nodes = reference::nodes::nodes(avatar, &features);
    reference::project::gaussians(avatar, posed, &features, &nodes)
}
