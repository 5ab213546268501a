//! Crowds: more avatars than the renderer has room for as a whole.

use crate::common::{
    self, Sizes,
    gpu::{
        self,
        Raster::{self, CooperativeTiles, Quads, SharedTiles},
    },
};
use effigy_core::{
    avatar::Avatar,
    frame::{Person, RendererOptions},
    scene::{Camera, Posed, Supersampling},
};
use effigy_measure::error;
use effigy_render::vulkan::{Gpu, Renderer};
use glam::{DAffine3, DVec3};

const SIZE: [u32; 2] = [720, 630];
/// Gaussians that there is room for: one whole avatar, or two halves, or a half and two quarters.
const ROOM: u32 = 3010;
const AVATARS: usize = 10;

fn avatar() -> Avatar {
    common::with_near_levels(common::avatar(
        4,
        Sizes {
            gaussians: 3001,
            ..Sizes::default()
        },
    ))
}

/// From 10 m away, a little more to the side in each frame.
fn camera(frame: usize) -> Camera {
    let yaw = 0.3 + 0.01 * frame as f64;
    Camera::orbit(DVec3::new(0.0, 0.9, 0.0), yaw, 0.1, 10.0, 0.7, SIZE)
}

/// Each in a pose of its own, in a row.
fn posed(avatar: &Avatar, number: usize) -> Posed {
    let place = DVec3::new(number as f64 - 4.5, 0.0, 0.0);
    Posed::new(avatar, &common::pose(number as u64, avatar))
        .placed(DAffine3::from_translation(place))
}

fn options(gpu: &Gpu, raster: Raster) -> RendererOptions {
    RendererOptions {
        instances: AVATARS,
        gaussians: Some(ROOM),
        supersampling: Supersampling::BySize,
        count: true,
        ..raster.options(&gpu.probe.name, SIZE)
    }
}

/// Avatars come and go, which takes pose caches and places in the pose buffer from others; each
/// frame is as if there had been none before it, and draws no more than there is room for.
fn a_crowd_leaves_nothing_behind(raster: Raster) {
    let avatar = avatar();
    let poses: Vec<Posed> = (0..AVATARS).map(|number| posed(&avatar, number)).collect();
    let away = DAffine3::from_translation(DVec3::new(0.0, 0.0, 400.0));
    let gone: Vec<Posed> = poses
        .iter()
        .map(|posed| posed.clone().placed(away))
        .collect();
    let gpu = gpu::drawing();
    // A renderer for each frame.
    gpu.keep_pipelines();
    let options = options(&gpu, raster);
    let mut renderer = Renderer::new(&gpu, &avatar, options).unwrap();
    let mut cached = vec![];
    let mut networks = vec![];
    for (frame, (turned, there)) in [
        (0, 0..2),
        (1, 0..2),
        (2, 0..2),
        // Others take their places, and then all are there.
        (3, 2..5),
        (4, 1..4),
        (5, 1..4),
        (6, 1..4),
        (6, 0..10),
        (7, 0..10),
        (8, 0..10),
        (8, 7..8),
        (8, 0..1),
    ]
    .into_iter()
    .enumerate()
    {
        let camera = camera(turned);
        let shown: Vec<&Posed> = (0..AVATARS)
            .map(|number| {
                if there.contains(&number) {
                    &poses[number]
                } else {
                    &gone[number]
                }
            })
            .collect();
        renderer
            .draw_scene(&Person::copies(&shown), &camera, None)
            .unwrap();
        let image = renderer.read_image().unwrap();
        let mut fresh = Renderer::new(&gpu, &avatar, options).unwrap();
        fresh
            .draw_scene(&Person::copies(&shown), &camera, None)
            .unwrap();
        let difference = error::between(&image, &fresh.read_image().unwrap());
        assert!(
            difference.covered.pixels > 100 && difference.whole.max_error <= 0.02,
            "frame {frame}: {difference:?}"
        );
        renderer.finish().unwrap();
        let counters = renderer.report().counters;
        assert_eq!(counters.avatars_culled as usize, AVATARS - there.len());
        let drawn = there.len() as u64 * 3001 - counters.skipped_by_detail;
        assert!(drawn <= ROOM.into() && drawn > 0, "{drawn}");
        cached.push(counters.cached > 0);
        networks.push(counters.networks > 0);
    }
    // Caches and networks are used where nothing took their places.
    assert!(
        cached[2] && !cached[3] && cached[6] && cached[9],
        "{cached:?}"
    );
    assert!(networks[0] && !networks[1] && networks[3], "{networks:?}");
}

/// A crowd without room for the coarsest of each avatar is refused.
fn too_little_room_is_refused() {
    let gpu = gpu::drawing();
    let options = RendererOptions {
        gaussians: Some(900),
        ..options(&gpu, Quads)
    };
    let error = match Renderer::new(&gpu, &avatar(), options) {
        Ok(_) => panic!("drawn without room"),
        Err(error) => error.to_string(),
    };
    assert!(error.contains("900") && error.contains("3001"), "{error}");
}

tests! {
    a_crowd_leaves_nothing_behind[Quads],
    a_crowd_leaves_nothing_behind[CooperativeTiles],
    a_crowd_leaves_nothing_behind[SharedTiles],
    too_little_room_is_refused,
}
