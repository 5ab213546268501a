//! A stress case: a seed and a number go in; an avatar, a pose, a camera and options come out.
//! Nothing else decides about it, so that a number replays it anywhere, except on devices that
//! can't draw triangles.

use super::{
    adversarial, body::below, bound::BoundScene, category::Category, draft::Draft, small::Small,
};
use effigy_core::{
    avatar::{Avatar, Filter, Pose, facing},
    frame::Skip,
    random::Random,
    reference::{self, Culled, project::Gaussian},
    scene::{Camera, Posed, Supersampling},
};
use effigy_render::vulkan::{RendererOptions, probe::Probe, raster::RasterMethod};
use glam::DAffine3;
use serde::Serialize;

/// Makes the seed of a case's options differ from that of the rest ("options!").
const OPTIONS_SEED: u64 = 0x6f70_7469_6f6e_7321;
/// Makes the seed of a case's filter differ from that of the rest ("filters!").
const FILTER_SEED: u64 = 0x6669_6c74_6572_7321;
/// Makes the seed of a case's size differ from that of the rest ("smallish").
const SMALL_SEED: u64 = 0x736d_616c_6c69_7368;
/// The last of so many rounds of categories is drawn small; the others as large as they are shown,
/// so that their cases stay what they were before anything else was.
const SMALL_ROUNDS: u64 = 4;
/// The last of so many rounds of categories is drawn with random filters; the others with that of
/// 3DGS, so that their cases stay what they were before there were filters.
const FILTER_ROUNDS: u64 = 3;
/// Makes the seed of a case's cones differ from that of the rest ("facing!").
const FACING_SEED: u64 = 0x6661_6369_6e67_2121;
/// In the last of so many rounds of categories Gaussians are drawn from random cones; in the others
/// from everywhere, so that their cases stay what they were before there were cones.
const FACING_ROUNDS: u64 = 5;
/// Moves of the camera that are tried to keep Gaussians off the edges of culling.
const MAX_MOVES: usize = 100;

/// The ways of rasterizing, which cases take turns with at random.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rasterizer {
    /// Quads, blended far to near.
    Quads,
    /// Quads tested against the saturation depth, where an avatar is large enough for it.
    TestedQuads,
    /// Tiles by the kernel whose subgroups work together; where a device can't, by the next.
    Cooperative,
    /// Tiles by the kernel whose workgroups share a batch.
    Shared,
}

impl Rasterizer {
    /// Every rasterizer.
    pub const ALL: [Self; 4] = [
        Self::Quads,
        Self::TestedQuads,
        Self::Cooperative,
        Self::Shared,
    ];

    /// That of a case's options.
    pub fn of(options: &RendererOptions) -> Self {
        match options.method {
            Some(RasterMethod::Quads) if options.skip.contains(Skip::DEPTH) => Self::TestedQuads,
            Some(RasterMethod::Quads) => Self::Quads,
            Some(RasterMethod::CooperativeTiles) => Self::Cooperative,
            _ => Self::Shared,
        }
    }

    /// Name in output for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Quads => "quads",
            Self::TestedQuads => "quads, tested",
            Self::Cooperative => "tiles, cooperative",
            Self::Shared => "tiles, shared",
        }
    }

    /// Sets the options that choose it.
    pub fn choose(self, options: &mut RendererOptions) {
        options.skip.set(Skip::DEPTH, self == Self::TestedQuads);
        options.method = Some(match self {
            Self::Quads | Self::TestedQuads => RasterMethod::Quads,
            Self::Cooperative => RasterMethod::CooperativeTiles,
            Self::Shared => RasterMethod::SharedTiles,
        });
    }
}

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
    let mut options = RendererOptions {
        exact: below(random, 4) > 0,
        skip,
        supersampling: Supersampling::OFF,
        ..RendererOptions::new(size)
    };
    Rasterizer::ALL[below(random, Rasterizer::ALL.len())].choose(&mut options);
    options
}

/// A random filter, more often than not compensated; the variances at the ends of the range and
/// those that others use are as likely as all others.
fn filter(random: &mut Random) -> Filter {
    let [least, most] = [*Filter::VARIANCES.start(), *Filter::VARIANCES.end()];
    let variances = [least, Filter::DEFAULT.variance, most];
    Filter {
        variance: match variances.get(below(random, 2 * variances.len())) {
            Some(&variance) => variance,
            None => random.range(least.ln(), most.ln()).exp().clamp(least, most),
        },
        compensated: below(random, 4) > 0,
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
            let mut case = Self::on_the_near_plane(random, options_random, number);
            case.choose_filter(seed);
            case.choose_facing(seed);
            return case;
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
        case.choose_size(seed);
        case.choose_filter(seed);
        case.choose_facing(seed);
        case.keep_off_culling_edges();
        case
    }

    /// Draws it small in rounds that are.
    fn choose_size(&mut self, seed: u64) {
        if (self.number / Category::ROUND) % SMALL_ROUNDS == SMALL_ROUNDS - 1 {
            let random = &mut Random::new(seed ^ SMALL_SEED, self.number);
            let small = Small::random(random, &self.avatar, &self.posed, &self.camera);
            self.options.supersampling = small.supersampling;
            self.camera = small.camera;
            self.avatar.levels = small.levels;
            self.note += &small.note;
        }
    }

    /// Sets the avatar's filter in rounds that have one, and in every second of these cases another
    /// that the renderer overrides it with.
    fn choose_filter(&mut self, seed: u64) {
        if (self.number / Category::ROUND) % FILTER_ROUNDS != FILTER_ROUNDS - 1 {
            return;
        }
        let random = &mut Random::new(seed ^ FILTER_SEED, self.number);
        self.avatar.filter = filter(random);
        if below(random, 2) == 0 {
            self.options.filter = Some(filter(random));
        }
        let filter = self.scene().filter();
        self.note += &format!("; low-pass of {filter} px²");
    }

    /// Gives each Gaussian, its levels' too, a random cone in rounds that have them; of eight one is
    /// drawn from everywhere and one from nowhere.
    fn choose_facing(&mut self, seed: u64) {
        if (self.number / Category::ROUND) % FACING_ROUNDS != FACING_ROUNDS - 1 {
            return;
        }
        let random = &mut Random::new(seed ^ FACING_SEED, self.number);
        let levels = self.avatar.levels.iter_mut();
        let sets = levels.map(|level| &mut level.gaussians);
        for gaussians in std::iter::once(&mut self.avatar.gaussians).chain(sets) {
            let code = |_| match below(random, 8) {
                0 => facing::EVERYWHERE,
                1 => facing::NOWHERE,
                _ => std::array::from_fn(|_| below(random, 256) as u8),
            };
            gaussians.facing = (0..gaussians.len()).map(code).collect();
        }
        self.note += "; random cones";
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

    /// What its image is bound by.
    pub fn scene(&self) -> BoundScene<'_> {
        BoundScene {
            avatar: &self.avatar,
            posed: &self.posed,
            camera: &self.camera,
            options: &self.options,
            cached_by: None,
        }
    }

    /// The case as a device can draw it: by a method that it can run, and without what needs
    /// triangles if it can't draw any.
    pub fn for_device(mut self, probe: &Probe) -> Self {
        let options = &mut self.options;
        if !probe.draws_triangles() {
            options.supersampling = Supersampling::OFF;
            options.skip -= Skip::DEPTH;
        }
        let can = |method: &RasterMethod| probe.lacks_for(*method).is_none();
        if options.method.is_some_and(|method| !can(&method)) {
            let others = [RasterMethod::SharedTiles, RasterMethod::Quads];
            options.method = others.into_iter().find(can);
        }
        self
    }

    /// Moves the near plane and the image slightly until f32 and the stored model's rounding can't
    /// change whether a Gaussian is culled. Otherwise either image would be right.
    fn keep_off_culling_edges(&mut self) {
        let (_, _, stored) = reference::stored(&self.avatar, &self.posed);
        let exact = gaussians(&self.avatar, &self.posed);
        let filter = self.scene().filter();
        for _ in 0..MAX_MOVES {
            let camera = self.camera;
            let moved = |near: f64, by: f64| Camera {
                near: camera.near * near,
                center: camera.center + by,
                ..camera
            };
            let tolerance = 0.02 + 1e-5 * f64::from(camera.size[0].max(camera.size[1]));
            let cameras = [moved(1.0 - 2e-5, tolerance), moved(1.0 + 2e-5, -tolerance)];
            let mut pairs = exact.iter().zip(&stored);
            if !pairs.any(|(exact, stored)| is_on_culling_edge(exact, stored, &cameras, filter)) {
                return;
            }
            self.camera = moved(1.0 + 1.3e-4, 0.17 * tolerance);
        }
        self.note += "; a Gaussian is on the edge of being culled";
    }
}

/// Whether cameras that differ slightly, or a Gaussian and its stored form, disagree about drawing
/// a Gaussian that would be visible.
fn is_on_culling_edge(
    exact: &Gaussian,
    stored: &Gaussian,
    cameras: &[Camera; 2],
    filter: Filter,
) -> bool {
    let mut is_drawn = false;
    let mut is_culled = false;
    for camera in cameras {
        for gaussian in [exact, stored] {
            match reference::project::project(gaussian, camera, filter, 0) {
                Ok(_) => is_drawn = true,
                Err(Culled::Behind | Culled::Invalid) => is_culled = true,
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
