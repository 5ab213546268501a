//! Different people in one scene: avatars of any sizes, who come and go, sorted together as the
//! reference sorts them.

use crate::common::{
    self, Random, Sizes, f16s,
    gpu::{
        self,
        Raster::{self, CooperativeTiles, Quads, SharedTiles},
    },
};
use effigy_core::{
    avatar::{Activation, Avatar, Filter, ShCoefficients},
    frame::{AvatarId, Person, RendererOptions},
    reference,
    scene::{Camera, FrameImage, Posed, Supersampling},
};
use effigy_measure::error;
use effigy_render::vulkan::{Error, Gpu, PreparedAvatar, Renderer};
use glam::{DAffine3, DVec3};
use std::sync::Arc;

pub const SIZE: [u32; 2] = [240, 280];

pub fn camera(yaw: f64) -> Camera {
    Camera::orbit(DVec3::new(0.0, 1.0, 0.0), yaw, 0.05, 4.5, 0.7, SIZE)
}

/// Four that have nothing in common: of the usual sizes; larger in everything, with cones and another
/// low-pass; with spherical harmonics; and without features, with levels.
pub fn cast() -> [Avatar; 4] {
    let usual = common::avatar(3, Sizes::default());
    let mut large = common::faced(common::avatar(
        5,
        Sizes {
            gaussians: 5000,
            parts: 40,
            nodes: 700,
            basis: 24,
            rows: 900,
            hidden: 96,
            split_features: true,
            activation: Activation::LeakyRelu,
            ..Sizes::default()
        },
    ));
    large.filter = Filter {
        variance: 0.1,
        compensated: true,
    };
    let mut lit = common::avatar(
        4,
        Sizes {
            gaussians: 1500,
            parts: 3,
            joints: 20,
            expression: 0,
            ..Sizes::default()
        },
    );
    let random = &mut Random(7);
    let coefficients = (0..15 * lit.gaussians.len())
        .map(|_| f16s(random.vector(0.2).to_array()))
        .collect();
    lit.sh = Some(ShCoefficients {
        degree: 3,
        coefficients,
    });
    let small = common::with_near_levels(common::avatar(
        6,
        Sizes {
            gaussians: 1001,
            nodes: 20,
            rows: 0,
            ..Sizes::default()
        },
    ));
    [usual, large, lit, small]
}

pub fn posed(avatar: &Avatar, seed: u64, place: DVec3) -> Posed {
    let mut pose = common::pose(seed, avatar);
    pose.translation = DVec3::ZERO;
    Posed::new(avatar, &pose).placed(DAffine3::from_translation(place))
}

/// Everybody near the middle, so that they reach through each other.
pub fn poses(cast: &[Avatar]) -> Vec<Posed> {
    let places = [[0.0, 0.0], [0.15, 0.1], [-0.2, -0.1], [0.1, -0.15]];
    let everybody = cast.iter().zip(places).enumerate();
    everybody
        .map(|(seed, (avatar, [x, z]))| posed(avatar, seed as u64, DVec3::new(x, 0.0, z)))
        .collect()
}

fn options(gpu: &Gpu, raster: Raster) -> RendererOptions {
    RendererOptions {
        instances: 5,
        ..raster.options(&gpu.probe.name, SIZE)
    }
}

/// A renderer that was made with the first, and holds the others too.
fn renderer(
    gpu: &Arc<Gpu>,
    cast: &[Avatar],
    options: RendererOptions,
) -> (Renderer, Vec<AvatarId>) {
    let mut renderer = Renderer::new(gpu, &cast[0], options).unwrap();
    let mut ids = vec![AvatarId::FIRST];
    for avatar in &cast[1..] {
        let prepared = PreparedAvatar::new(avatar).unwrap();
        ids.push(renderer.add_avatar(&prepared).unwrap());
    }
    (renderer, ids)
}

pub fn people<'a>(ids: &[AvatarId], poses: &'a [Posed]) -> Vec<Person<'a>> {
    let people = ids.iter().zip(poses);
    people
        .map(|(&avatar, posed)| Person { avatar, posed })
        .collect()
}

pub fn expected(cast: &[Avatar], poses: &[Posed], camera: &Camera, small: bool) -> FrameImage {
    let people = cast.iter().zip(poses);
    let people: Vec<_> = people
        .map(|(avatar, posed)| reference::Person { avatar, posed })
        .collect();
    let supersampling = if small {
        Supersampling::BySize
    } else {
        Supersampling::OFF
    };
    reference::render_shown(&people, camera, supersampling, None)
}

fn draw(renderer: &mut Renderer, people: &[Person], camera: &Camera) -> FrameImage {
    renderer.draw_scene(people, camera, None).unwrap();
    renderer.read_image().unwrap()
}

/// In whatever order they were added, while the camera moves and while they do.
fn different_people_are_those_of_the_reference(raster: Raster) {
    let gpu = gpu::drawing();
    let cast = cast();
    let options = options(&gpu, raster);
    let mut orders = [cast.clone(), cast];
    orders[1].reverse();
    for cast in orders {
        let (mut renderer, ids) = renderer(&gpu, &cast, options);
        let still = poses(&cast);
        let mut moved = still.clone();
        moved[1] = posed(&cast[1], 9, DVec3::new(0.2, 0.0, 0.1));
        for (frame, (poses, yaw)) in [(&still, 0.4), (&still, 0.5), (&still, 0.6), (&moved, 2.0)]
            .into_iter()
            .enumerate()
        {
            let camera = camera(yaw);
            let image = draw(&mut renderer, &people(&ids, poses), &camera);
            let error = error::between(&image, &expected(&cast, poses, &camera, false)).covered;
            assert!(
                error.pixels > 5000 && error.psnr_db >= 47.0,
                "frame {frame}: {error:?}"
            );
        }
        let counters = renderer.report().counters;
        let all: usize = cast.iter().map(|avatar| avatar.gaussians.len()).sum();
        assert_eq!([counters.avatars, counters.gaussians], [4, all as u64]);
    }
}

/// Small ones, each drawn from levels of its own if it has any.
fn small_people_are_those_of_the_reference(raster: Raster) {
    let gpu = gpu::drawing();
    let cast = cast();
    let options = RendererOptions {
        supersampling: Supersampling::BySize,
        ..options(&gpu, raster)
    };
    let (mut renderer, ids) = renderer(&gpu, &cast, options);
    let camera = Camera::orbit(DVec3::Y, 0.3, 0.05, 14.0, 0.7, SIZE);
    for apart in [0.1, 1.2] {
        let everybody = cast.iter().enumerate();
        let poses: Vec<_> = everybody
            .map(|(at, avatar)| {
                let place = DVec3::new(apart * (at as f64 - 1.5), 0.0, 0.0);
                posed(avatar, at as u64, place)
            })
            .collect();
        let image = draw(&mut renderer, &people(&ids, &poses), &camera);
        let error = error::between(&image, &expected(&cast, &poses, &camera, true)).covered;
        assert!(
            error.pixels > 300 && error.psnr_db >= 45.0,
            "{apart} m apart: {error:?}"
        );
    }
}

/// Whoever comes, goes or takes another's place: each frame shows who is there, and buffers grow with
/// whoever is larger, around the same image.
fn people_come_and_go(raster: Raster) {
    let gpu = gpu::drawing();
    let cast = cast();
    let options = options(&gpu, raster);
    let camera = camera(0.4);
    let poses = poses(&cast);
    // The smallest first.
    let mut renderer = Renderer::new(&gpu, &cast[3], options).unwrap();
    let image = renderer.raster().image().raw();
    let mut held = vec![(3, AvatarId::FIRST)];
    let add = |renderer: &mut Renderer, of: usize| {
        let prepared = PreparedAvatar::new(&cast[of]).unwrap();
        (of, renderer.add_avatar(&prepared).unwrap())
    };
    for step in 0..7 {
        match step {
            1 => held.push(add(&mut renderer, 1)),
            2 => held.insert(0, add(&mut renderer, 2)),
            3 => {
                let (_, gone) = held.remove(1);
                assert!(renderer.remove_avatar(gone).unwrap());
                assert!(!renderer.remove_avatar(gone).unwrap());
                let person = Person {
                    avatar: gone,
                    posed: &poses[3],
                };
                let error = renderer.draw_scene(&[person], &camera, None).unwrap_err();
                assert!(matches!(error, Error::Unusable(_)), "{error}");
            }
            4 => held.push(add(&mut renderer, 0)),
            5 => held.swap(0, 1),
            // Two of one.
            6 => held.push(held[0]),
            _ => {}
        }
        let ids: Vec<_> = held.iter().map(|own| own.1).collect();
        let shown: Vec<_> = held.iter().map(|own| poses[own.0].clone()).collect();
        let looks: Vec<_> = held.iter().map(|own| cast[own.0].clone()).collect();
        let image = draw(&mut renderer, &people(&ids, &shown), &camera);
        let error = error::between(&image, &expected(&looks, &shown, &camera, false)).covered;
        assert!(
            error.pixels > 500 && error.psnr_db >= 47.0,
            "step {step}: {error:?}"
        );
    }
    assert_eq!(renderer.raster().image().raw(), image);
    // Everybody goes, and somebody larger comes.
    let mut renderer = Renderer::new(&gpu, &cast[3], options).unwrap();
    let first = Person {
        avatar: AvatarId::FIRST,
        posed: &poses[3],
    };
    draw(&mut renderer, &[first], &camera);
    assert!(renderer.remove_avatar(AvatarId::FIRST).unwrap());
    draw(&mut renderer, &[], &camera);
    let (_, avatar) = add(&mut renderer, 1);
    let person = Person {
        avatar,
        posed: &poses[1],
    };
    let alone = draw(&mut renderer, &[person], &camera);
    let expected = expected(&cast[1..2], &poses[1..2], &camera, false);
    let error = error::between(&alone, &expected).covered;
    assert!(error.pixels > 500 && error.psnr_db >= 47.0, "{error:?}");
}

tests! {
    different_people_are_those_of_the_reference[Quads],
    different_people_are_those_of_the_reference[CooperativeTiles],
    different_people_are_those_of_the_reference[SharedTiles],
    small_people_are_those_of_the_reference[Quads],
    small_people_are_those_of_the_reference[CooperativeTiles],
    people_come_and_go[Quads],
    people_come_and_go[CooperativeTiles],
    people_come_and_go[SharedTiles],
}
