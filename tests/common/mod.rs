//! Avatars, poses and clips for tests, from a seed: a body about 1.7 m tall of capsules around the
//! bones of a plausible skeleton, with every array as a trained avatar has it. The same seed and
//! sizes give the same bits.

// Every test binary compiles this file and uses a part of it.
#![allow(dead_code)]

mod body;
pub mod gpu;
#[macro_use]
pub mod harness;
pub mod plain;
pub mod wide;

use effigy_core::avatar::{harmonics::functions_of, *};
use effigy_core::io::splats::{Splats, Up};
use glam::{DQuat, DVec3};
use half::f16;
use std::{f64::consts::TAU, ffi::OsString};

/// How large an avatar to make. Symbols as in `effigy_core::avatar`.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    /// N_g.
    pub gaussians: usize,
    /// N_G.
    pub parts: usize,
    /// N_s.
    pub nodes: usize,
    /// N_B, a multiple of 4.
    pub basis: usize,
    /// J.
    pub joints: usize,
    /// Kept rows of each attribute, at most N_g.
    pub rows: usize,
    pub expression: usize,
    /// Nodes have features of their own: e has length 2 N_B.
    pub split_features: bool,
    pub activation: Activation,
    /// Width of the three hidden layers.
    pub hidden: usize,
    /// Components of the pose and the expression space; 0 leaves both out.
    pub subspace: usize,
}

impl Default for Sizes {
    /// Small enough for the f64 reference, with a piece of everything.
    fn default() -> Self {
        Self {
            gaussians: 3000,
            parts: 24,
            nodes: 200,
            basis: 16,
            joints: 55,
            rows: 300,
            expression: 10,
            split_features: false,
            activation: Activation::Relu,
            hidden: 64,
            subspace: 0,
        }
    }
}

impl Sizes {
    /// The paper's sizes.
    pub fn paper() -> Self {
        Self {
            gaussians: 200_000,
            parts: 256,
            nodes: 10_000,
            rows: 20_000,
            subspace: 20,
            ..Self::default()
        }
    }
}

/// SplitMix64: short, and the same everywhere for ever.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in 0..1.
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn range(&mut self, min: f64, max: f64) -> f64 {
        min + (max - min) * self.unit()
    }

    /// Uniform in 0..n.
    pub fn below(&mut self, n: usize) -> usize {
        ((u128::from(self.next()) * n as u128) >> 64) as usize
    }

    /// Close to the normal distribution of mean 0 and deviation 1, within ±3.5.
    pub fn normal(&mut self) -> f64 {
        (0..4).map(|_| self.unit() - 0.5).sum::<f64>() * 3f64.sqrt()
    }

    /// Components within ±`reach`.
    pub fn vector(&mut self, reach: f64) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|_| self.range(-reach, reach)))
    }
}

pub fn f16s<const N: usize>(v: [f64; N]) -> [f16; N] {
    v.map(f16::from_f64)
}

/// Waves over the body: frequency and phase.
fn waves(random: &mut Random, count: usize) -> Vec<(DVec3, f64)> {
    (0..count)
        .map(|_| (random.vector(12.0), random.unit() * TAU))
        .collect()
}

/// A wave's height at a point; its mean square is 1.
fn wave((frequency, phase): &(DVec3, f64), at: DVec3) -> f64 {
    2f64.sqrt() * (frequency.dot(at) + phase).sin()
}

/// The basis at a point: with features near 1, each of the `count` components comes out near
/// `size`.
fn basis(
    waves: &[(DVec3, f64)],
    size: f64,
    basis_len: usize,
    at: DVec3,
) -> impl Iterator<Item = f16> {
    let scale = size / (basis_len as f64).sqrt();
    waves
        .iter()
        .map(move |w| f16::from_f64(scale * wave(w, at)))
}

/// Basis rows of Gaussians chosen at random.
fn rows<const C: usize>(
    random: &mut Random,
    sizes: &Sizes,
    points: &[DVec3],
    size: f64,
) -> Rows<C> {
    let wave_of = waves(random, C * sizes.basis);
    let mut left = sizes.rows.min(points.len());
    let mut rows = Rows {
        gaussian: vec![],
        basis: Matrix::default(),
    };
    for (i, &point) in points.iter().enumerate() {
        if random.below(points.len() - i) < left {
            left -= 1;
            rows.gaussian.push(i as u32);
            rows.basis
                .halves_mut()
                .extend(basis(&wave_of, size, sizes.basis, point));
        }
    }
    rows
}

fn networks(random: &mut Random, sizes: &Sizes, input: usize) -> Networks {
    let output = sizes.basis * if sizes.split_features { 2 } else { 1 };
    let width = [input, sizes.hidden, sizes.hidden, sizes.hidden, output];
    let layer = |(l, w): (usize, &[usize])| {
        // Poses are about a third of a radian: the first layer makes up for it, so that features
        // come out near 1.
        let deviation = (2.0 / w[0] as f64).sqrt() * if l == 0 { 3.0 } else { 1.0 };
        NetworkLayer {
            input: w[0],
            output: w[1],
            weight: (0..sizes.parts * w[0] * w[1])
                .map(|_| f16::from_f64(deviation * random.normal()))
                .collect(),
            bias: (0..sizes.parts * w[1])
                .map(|_| f16::from_f64(0.1 * random.normal()))
                .collect(),
        }
    };
    Networks {
        activation: sizes.activation,
        layers: width.windows(2).enumerate().map(layer).collect(),
    }
}

/// `components` orthonormal directions in D dimensions, at most D.
pub fn subspace(random: &mut Random, dimensions: usize, components: usize) -> Option<Subspace> {
    let mut rows: Vec<Vec<f64>> = vec![];
    for _ in 0..components.min(dimensions) {
        let mut row: Vec<f64> = (0..dimensions).map(|_| random.normal()).collect();
        for other in &rows {
            let along: f64 = row.iter().zip(other).map(|(a, b)| a * b).sum();
            row.iter_mut().zip(other).for_each(|(a, b)| *a -= along * b);
        }
        let length = row.iter().map(|v| v * v).sum::<f64>().sqrt();
        rows.push(row.iter().map(|v| v / length).collect());
    }
    let sigma = (0..rows.len()).map(|k| 0.8 / (1.0 + k as f32)).collect();
    let mean = (0..dimensions)
        .map(|_| 0.1 * random.normal() as f32)
        .collect();
    (!rows.is_empty()).then(|| Subspace {
        mean,
        component: rows.concat().iter().map(|&v| v as f32).collect(),
        sigma,
    })
}

fn gaussians(
    random: &mut Random,
    skeleton: &Skeleton,
    skin: &[(DVec3, DVec3)],
    nodes: &[DVec3],
    bounds: Bounds,
) -> Gaussians {
    let joints = body::canonical_joints(skeleton);
    let position: Vec<[u16; 3]> = skin.iter().map(|(p, _)| bounds.encode(*p)).collect();
    let points: Vec<DVec3> = position.iter().map(|&q| bounds.decode(q)).collect();
    let bound: Vec<_> = points.iter().map(|&p| body::skinning(&joints, p)).collect();
    let shade = waves(random, 3);
    let mut rotate = |normal: DVec3| {
        let q = DQuat::from_rotation_arc(DVec3::Z, normal)
            * DQuat::from_rotation_z(random.unit() * TAU);
        f16s([q.w, q.x, q.y, q.z].map(|v| v * random.range(0.7, 1.3)))
    };
    let rotation = skin.iter().map(|(_, normal)| rotate(*normal)).collect();
    Gaussians {
        bounds,
        node: body::nearest_nodes(&points, nodes),
        joint: bound.iter().map(|b| b.0).collect(),
        joint_weight: bound.iter().map(|b| b.1).collect(),
        rotation,
        log_scale: skin
            .iter()
            .map(|_| f16s([0.004, 0.004, 0.002].map(|v| (v * random.range(1.0, 5.0)).ln())))
            .collect(),
        color: points
            .iter()
            .map(|&p| {
                f16s([0, 1, 2].map(|k| 0.5 + 0.3 * wave(&shade[k], p) + 0.05 * random.normal()))
            })
            .collect(),
        opacity: skin
            .iter()
            .map(|_| [180, 180, 90, 0][random.below(4)] + random.below(76) as u8)
            .collect(),
        position,
        facing: vec![],
    }
}

/// Sorts points by part, the nearest of N_G seeds, head parts first; gives the parts and the part
/// of each point.
fn divide(random: &mut Random, skin: &mut [(DVec3, DVec3)], parts: usize) -> (Parts, Vec<u16>) {
    let mut seed: Vec<DVec3> = (0..parts)
        .map(|_| skin[random.below(skin.len())].0)
        .collect();
    seed.sort_by(|a, b| b.y.total_cmp(&a.y));
    let part = |p: DVec3| {
        (0..parts)
            .min_by(|&a, &b| {
                seed[a]
                    .distance_squared(p)
                    .total_cmp(&seed[b].distance_squared(p))
            })
            .unwrap_or(0)
    };
    skin.sort_by_cached_key(|(p, _)| part(*p));
    let part_of: Vec<u16> = skin.iter().map(|(p, _)| part(*p) as u16).collect();
    let start = (0..=parts)
        .map(|i| part_of.partition_point(|&p| usize::from(p) < i) as u32)
        .collect();
    (
        Parts {
            start,
            head: seed.iter().filter(|p| p.y > 1.45).count(),
        },
        part_of,
    )
}

/// A valid avatar of the given sizes.
pub fn avatar(seed: u64, sizes: Sizes) -> Avatar {
    let random = &mut Random(seed);
    let skeleton = body::skeleton(random, sizes.joints);
    let bounds = Bounds {
        min: [-1.0, -0.1, -0.3],
        max: [1.0, 1.8, 0.3],
    };
    let mut skin = body::skin(random, sizes.gaussians);
    let (parts, part_of) = divide(random, &mut skin, sizes.parts);
    let node_of: Vec<usize> = (0..sizes.nodes).map(|_| random.below(skin.len())).collect();
    let node: Vec<[u16; 3]> = node_of
        .iter()
        .map(|&i| bounds.encode(skin[i].0 + random.vector(0.005)))
        .collect();
    let node_point: Vec<DVec3> = node.iter().map(|&q| bounds.decode(q)).collect();
    let points: Vec<DVec3> = skin.iter().map(|(p, _)| *p).collect();
    let joint: Vec<u8> = if sizes.joints == 1 {
        vec![0]
    } else {
        (1..sizes.joints.min(22)).map(|j| j as u8).collect()
    };
    let inputs = Inputs {
        pose_space: subspace(random, 3 * joint.len(), sizes.subspace),
        expression_space: subspace(random, sizes.expression, sizes.subspace),
        joint,
        expression: sizes.expression,
    };
    let node_waves = waves(random, 3 * sizes.basis);
    Avatar {
        name: format!("test body {seed}"),
        credit: "made by the tests from a seed".into(),
        filter: Filter::DEFAULT,
        gaussians: gaussians(random, &skeleton, &skin, &node_point, bounds),
        networks: networks(random, &sizes, inputs.len()),
        rotation_rows: rows(random, &sizes, &points, 0.1),
        scale_rows: rows(random, &sizes, &points, 0.2),
        color_rows: rows(random, &sizes, &points, 0.1),
        nodes: Nodes {
            part: node_of.iter().map(|&i| part_of[i]).collect(),
            offset: node
                .iter()
                .map(|_| f16s(random.vector(0.002).to_array()))
                .collect(),
            basis: node_point
                .iter()
                .flat_map(|&p| basis(&node_waves, 0.006, sizes.basis, p))
                .collect(),
            position: node,
        },
        skeleton,
        parts,
        inputs,
        sh: None,
        levels: vec![],
    }
}

/// Splats in a box a metre wide: flat ones of some centimetres, with colours that change with the
/// view as those of trained scenes do, the less the higher the degree.
pub fn splats(seed: u64, count: usize, degree: usize) -> Splats {
    let random = &mut Random(seed);
    let mut splats = Splats {
        position: vec![],
        rotation: vec![],
        log_scale: vec![],
        opacity: vec![],
        color: vec![],
        degree,
        harmonics: vec![],
        up: Up::Y,
        filter: Filter::DEFAULT,
    };
    for _ in 0..count {
        let vector = |v: DVec3| v.as_vec3().to_array();
        splats.position.push(vector(random.vector(0.5)));
        let quaternion = std::array::from_fn(|_| random.normal() as f32);
        splats.rotation.push(quaternion);
        let flat = DVec3::new(-3.5, -3.8, -6.0) + random.vector(0.5);
        splats.log_scale.push(vector(flat));
        splats.opacity.push(random.range(-2.0, 4.0) as f32);
        splats.color.push(vector(random.vector(1.5)));
    }
    if degree > 0 {
        let sh = harmonics(seed + 1, count, degree);
        let coefficients = sh.coefficients.into_iter();
        splats.harmonics = coefficients.map(|c| c.map(f32::from)).collect();
    }
    splats
}

/// Spherical harmonics, the smaller the higher their degree.
pub fn harmonics(seed: u64, gaussians: usize, degree: usize) -> ShCoefficients {
    let random = &mut Random(seed);
    let functions = functions_of(degree);
    let mut coefficient = |at: usize| {
        let spread = 0.15 / ((at % functions + 1) as f64).sqrt().floor();
        std::array::from_fn(|_| f16::from_f64(spread * random.normal()))
    };
    ShCoefficients {
        degree,
        coefficients: (0..gaussians * functions).map(&mut coefficient).collect(),
    }
}

/// [`with_levels`], near enough at every height that they are for.
pub fn with_near_levels(avatar: Avatar) -> Avatar {
    let mut avatar = with_levels(avatar);
    for measured in avatar.levels.iter_mut().flat_map(|own| &mut own.measured) {
        measured.psnr_db += 6.0;
    }
    avatar
}

/// An avatar without levels whose Gaussians are each drawn from a cone of directions, some from
/// everywhere or nowhere.
pub fn faced(mut avatar: Avatar) -> Avatar {
    let random = &mut Random(avatar.gaussians.len() as u64);
    let facing = (0..avatar.gaussians.len()).map(|k| match k % 16 {
        0 => facing::EVERYWHERE,
        1 => facing::NOWHERE,
        _ => std::array::from_fn(|_| random.below(256) as u8),
    });
    avatar.gaussians.facing = facing.collect();
    avatar
}

/// The avatar with two levels of detail where it has enough Gaussians: every second Gaussian with
/// its rows, and every fourth without correctives.
pub fn with_levels(mut avatar: Avatar) -> Avatar {
    let measured = |height: f64| {
        [2, 4].map(|samples| LevelError {
            height,
            samples,
            psnr_db: 30.0 + f64::from(samples),
            color: 0.004,
            coverage: 0.0025,
        })
    };
    let level = |every: usize| {
        let keep: Vec<usize> = (0..avatar.gaussians.len()).step_by(every).collect();
        let correctives = every == 2 && !avatar.networks.layers.is_empty();
        let mut level = Level {
            gaussians: avatar.gaussians.pick(&keep),
            part_start: avatar
                .parts
                .start
                .iter()
                .map(|start| start.div_ceil(every as u32))
                .collect(),
            correctives,
            rotation_rows: every_second(&avatar.rotation_rows, correctives),
            scale_rows: every_second(&avatar.scale_rows, correctives),
            color_rows: every_second(&avatar.color_rows, correctives),
            sh: avatar.sh.as_ref().map(|sh| sh.pick(&keep)),
            measured: measured(240.0 / every as f64).into(),
        };
        if !correctives {
            level.gaussians.node.fill([0; 3]);
        }
        level
    };
    avatar.levels = [2, 4]
        .into_iter()
        .filter(|every| avatar.gaussians.len() > 2 * every)
        .map(level)
        .collect();
    avatar
}

/// The rows of every second Gaussian, renumbered; none unless `any`.
fn every_second<const C: usize>(rows: &Rows<C>, any: bool) -> Rows<C> {
    let kept: Vec<usize> = (0..rows.gaussian.len())
        .filter(|&row| any && rows.gaussian[row].is_multiple_of(2))
        .collect();
    let length = rows.basis.len() / rows.gaussian.len().max(1);
    Rows {
        gaussian: kept.iter().map(|&row| rows.gaussian[row] / 2).collect(),
        basis: rows.basis.pick(&kept, length),
    }
}

/// A pose as people take them: every joint bent a little, turned anywhere, near the origin.
pub fn pose(seed: u64, avatar: &Avatar) -> Pose {
    let random = &mut Random(seed);
    let mut rotation: Vec<DVec3> = avatar
        .skeleton
        .rest
        .iter()
        .map(|_| random.vector(0.5))
        .collect();
    rotation[0].y = random.range(-3.0, 3.0);
    let expression = (0..avatar.inputs.expression)
        .map(|_| random.normal())
        .collect();
    Pose {
        rotation,
        translation: random.vector(0.3),
        expression,
    }
}

/// A smooth clip of the avatar's own skeleton, 30 frames a second.
pub fn clip(seed: u64, avatar: &Avatar, frames: usize) -> Clip {
    let random = &mut Random(seed);
    let joints = avatar.skeleton.len();
    let mut track = |reach: f64| {
        let (size, rate, phase) = (
            random.vector(reach),
            random.range(1.0, 6.0),
            random.unit() * TAU,
        );
        move |frame: usize| size * (rate * frame as f64 / 30.0 + phase).sin()
    };
    let rotation: Vec<_> = (0..joints).map(|_| track(0.5)).collect();
    let translation = track(0.2);
    let expression: Vec<_> = (0..avatar.inputs.expression).map(|_| track(1.0)).collect();
    Clip {
        name: format!("test clip {seed}"),
        credit: "made by the tests from a seed".into(),
        rate: 30.0,
        joint: avatar.skeleton.name.clone(),
        rotation: (0..frames)
            .flat_map(|f| rotation.iter().map(move |r| r(f).as_vec3().to_array()))
            .collect(),
        translation: (0..frames)
            .map(|f| translation(f).as_vec3().to_array())
            .collect(),
        expression: (0..frames)
            .flat_map(|f| expression.iter().map(move |e| e(f).x as f32))
            .collect(),
        expression_len: expression.len(),
    }
}

/// The program that tests of commands run: the one that was built with them, or on another machine
/// the one that `EFFIGY_PROGRAM` names.
pub fn program() -> OsString {
    let built = option_env!("CARGO_BIN_EXE_effigy").unwrap_or("not built with these tests");
    std::env::var_os("EFFIGY_PROGRAM").unwrap_or_else(|| built.into())
}

/// The laboratory, which is built with its own tests, or lies beside the program.
pub fn lab() -> OsString {
    match option_env!("CARGO_BIN_EXE_effigy-lab") {
        Some(built) => built.into(),
        None => std::path::Path::new(&program())
            .with_file_name("effigy-lab")
            .into(),
    }
}

/// The folder of the body's source files. Ends the test where it isn't there.
pub fn assets() -> String {
    let folder = std::env::var("EFFIGY_ASSETS")
        .unwrap_or_else(|_| effigy_learn::bake::Assets::DEFAULT.into());
    let absolute = std::path::absolute(&folder).expect("the folder has a name");
    let complete = ["base.obj", "01_01.bvh"]
        .iter()
        .all(|name| absolute.join(name).exists());
    if !complete {
        harness::not_run(format!(
            "no source files in {folder}: run tools/fetch_assets.sh or set EFFIGY_ASSETS"
        ));
    }
    absolute.display().to_string()
}

/// Writes a small avatar and a clip for it, `small.avatar` and `small.motion`, to a folder.
pub fn small_files(folder: &std::path::Path) {
    let avatar = avatar(
        5,
        Sizes {
            gaussians: 800,
            parts: 8,
            nodes: 60,
            rows: 100,
            ..Sizes::default()
        },
    );
    avatar.write(&folder.join("small.avatar")).unwrap();
    clip(6, &avatar, 40)
        .write(&folder.join("small.motion"))
        .unwrap();
}
