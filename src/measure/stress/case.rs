//! A stress case: a seed and a number go in, an avatar, a pose, a camera and options come out. Nothing else decides about it, so a
//! number replays it anywhere, but for devices that draw no triangles.

use super::{
    body::{self, Sizes, below, vector},
    family::Family,
    hostile,
};
use crate::{
    avatar::{Avatar, Pose},
    bake::math::Random,
    frame::{Camera, Extent, Posed, Skip},
    reference::{self, Culled, splats::Gaussian},
    vulkan::{
        RendererOptions,
        probe::Probe,
        raster::{ColorFormat, Method},
        sort::KeyBits,
    },
};
use glam::{DAffine3, DMat3, DQuat, DVec3};

/// A frame that is hard to draw.
pub struct Case {
    pub number: u64,
    pub family: Family,
    /// What was done to it, in words.
    pub note: String,
    pub avatar: Avatar,
    pub pose: Pose,
    /// Where the posed avatar is put, after the skeleton.
    pub placed: DAffine3,
    pub posed: Posed,
    pub camera: Camera,
    pub options: RendererOptions,
}

/// A case before its camera: what the families change.
pub struct Draft {
    pub sizes: Sizes,
    pub avatar: Avatar,
    pub pose: Pose,
    pub placed: DAffine3,
    /// Of the picture, px.
    pub size: [u32; 2],
    /// Vertical field of view, radians.
    pub fov: f64,
    /// From the avatar's middle, as a share of the distance that shows all of it.
    pub distance: f64,
    /// Metres in the avatar's own scale.
    pub near: f64,
    pub note: String,
}

impl Draft {
    fn new(random: &mut Random) -> Self {
        let sizes = Sizes::any(random);
        Self::of(random, sizes)
    }

    /// An avatar of some sizes, bent a little, all of it in a picture of some 100 px.
    pub fn of(random: &mut Random, sizes: Sizes) -> Self {
        let avatar = body::avatar(random, &sizes);
        let pose = Pose {
            rotation: (0..sizes.joints).map(|_| vector(random, 0.4)).collect(),
            translation: vector(random, 0.2),
            expression: (0..sizes.expression).map(|_| random.normal()).collect(),
        };
        let size = [0; 2].map(|_| random.range(4.0, 8.0).exp2() as u32);
        let (placed, note) = (DAffine3::IDENTITY, String::new());
        Self { sizes, avatar, pose, placed, size, fov: random.range(0.4, 1.2), distance: random.range(0.6, 1.3), near: Camera::NEAR, note }
    }

    /// How much the placement enlarges lengths.
    fn scale(&self) -> f64 {
        self.placed.matrix3.determinant().abs().cbrt()
    }

    pub fn posed(&self) -> Posed {
        let mut posed = Posed::new(&self.avatar, &self.pose);
        posed.joints.iter_mut().for_each(|joint| *joint = self.placed * *joint);
        posed
    }

    /// Looks at the middle of the avatar from anywhere.
    fn camera(&self, random: &mut Random, posed: &Posed) -> Camera {
        let [min, max] = Extent::new(&self.avatar).bounds(&posed.joints);
        let (yaw, pitch) = (random.range(-3.2, 3.2), random.range(-1.4, 1.4));
        let distance = self.distance * Camera::framing_distance([min, max], self.fov, self.size);
        Camera { near: self.near * self.scale(), ..Camera::orbit((min + max) / 2.0, yaw, pitch, distance, self.fov, self.size) }
    }
}

/// Turned, scaled and moved anywhere.
pub fn placement(random: &mut Random) -> DAffine3 {
    let turn = DQuat::from_axis_angle(random.direction(), random.range(0.0, 6.3));
    let scale = 10f64.powf(random.range(-3.0, 3.0));
    let mirror = if random.uniform() < 0.1 { -1.0 } else { 1.0 };
    let matrix = DMat3::from_quat(turn) * DMat3::from_diagonal(DVec3::new(mirror * scale, scale, scale));
    DAffine3::from_mat3_translation(matrix, random.direction() * random.range(0.0, 1000.0))
}

fn options(random: &mut Random, size: [u32; 2]) -> RendererOptions {
    let skip = match below(random, 4) {
        0 => Skip::all(),
        1 | 2 => Skip::empty(),
        _ => Skip::from_bits_truncate(random.bits() as u32),
    };
    RendererOptions {
        color: Some(if below(random, 4) == 0 { ColorFormat::Rgba8 } else { ColorFormat::Rgba16F }),
        method: Some(Method::ALL[below(random, Method::ALL.len())]),
        key_bits: [KeyBits::Sixteen, KeyBits::TwentyFour, KeyBits::TwentyFour, KeyBits::ThirtyTwo][below(random, 4)],
        skip,
        ..RendererOptions::new(size)
    }
}

impl Case {
    /// `large` allows pictures of 8192 × 8192 px, which take a second or more.
    pub fn new(seed: u64, number: u64, large: bool) -> Self {
        let (random, family) = (&mut Random::new(seed, number), Family::of(number));
        let options_random = &mut Random::new(seed ^ 0x6f70_7469_6f6e_7321, number);
        if family == Family::NearPlane {
            return hostile::near_plane(random, number, options(options_random, [64; 2]));
        }
        let mut draft = Draft::new(random);
        hostile::apply(random, &mut draft, family, large);
        let posed = draft.posed();
        let mut camera = draft.camera(random, &posed);
        if family == Family::Inside || (family == Family::Mixed && random.uniform() < 0.2) {
            let gaussians = gaussians(&draft.avatar, &posed);
            camera = hostile::inside(random, &gaussians, camera);
        }
        let options = options(options_random, camera.size);
        let mut case =
            Self { number, family, note: draft.note, avatar: draft.avatar, pose: draft.pose, placed: draft.placed, posed, camera, options };
        case.settle();
        case
    }

    /// As a device can draw it: by tiles where it does not survive drawing triangles.
    pub fn on(mut self, probe: &Probe) -> Self {
        if !probe.draws_triangles() {
            self.options.method = Some(Method::Tiles);
        }
        self
    }

    /// Moves the near plane and the picture by a hair until no Gaussian's centre is so close to where it would be culled that f32 can't
    /// tell, nor the rounding of the stored model: either picture would be right.
    fn settle(&mut self) {
        let (_, _, stored) = reference::stored(&self.avatar, &self.posed);
        let gaussians: Vec<_> = gaussians(&self.avatar, &self.posed).into_iter().zip(stored).collect();
        for _ in 0..100 {
            let camera = self.camera;
            let moved = |near: f64, by: f64| Camera { near: camera.near * near, center: camera.center + by, ..camera };
            let tolerance = 0.02 + 1e-5 * camera.guard();
            let cameras = [moved(1.0 - 2e-5, tolerance), moved(1.0 + 2e-5, -tolerance)];
            if gaussians.iter().all(|pair| !hangs(pair, &cameras)) {
                return;
            }
            self.camera = moved(1.0 + 1.3e-4, 0.17 * tolerance);
        }
        self.note += "; a Gaussian is culled or not by a hair";
    }
}

/// Whether cameras that differ by a hair, or a Gaussian and the same as it is stored, disagree about drawing what would be seen.
fn hangs((exact, stored): &(Gaussian, Gaussian), cameras: &[Camera; 2]) -> bool {
    let verdict = |gaussian, camera| match reference::splats::project(gaussian, camera, 0) {
        Ok(_) => None,
        Err(reason) => Some(matches!(reason, Culled::Behind | Culled::Guard | Culled::Invalid)),
    };
    let verdicts = [(exact, 0), (exact, 1), (stored, 0), (stored, 1)].map(|(gaussian, camera)| verdict(gaussian, &cameras[camera]));
    verdicts.contains(&None) && verdicts.contains(&Some(true))
}

fn gaussians(avatar: &Avatar, posed: &Posed) -> Vec<Gaussian> {
    let features = reference::features::features(avatar, &posed.input);
    reference::splats::gaussians(avatar, posed, &features, &reference::nodes::nodes(avatar, &features))
}
