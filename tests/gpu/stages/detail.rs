//! Levels of detail: which level an avatar is drawn at, the image of each against the
//! reference's, and how near these are to what all Gaussians make.

use crate::common::{self, Random, Sizes, gpu};
use effigy_core::{
    avatar::{Avatar, ShCoefficients, motion::Player},
    frame::{
        Person,
        RasterMethod::{self, CooperativeTiles, Quads},
        RendererOptions,
    },
    reference::{self, raster, sort},
    scene::{AvatarBounds, Camera, Detail, FrameImage, Posed},
};
use effigy_measure::error;
use effigy_render::vulkan::Renderer;
use glam::{DAffine3, DVec3};
use half::f16;

const SIZE: [u32; 2] = [240, 200];

/// The demo in the middle of its clip, and a camera that sees it so many pixels tall.
fn distant(tall: f64, size: [u32; 2]) -> (Avatar, Posed, Camera) {
    let avatar = effigy_demo::avatar().unwrap();
    let posed = Posed::new(
        &avatar,
        &Player::new(effigy_demo::clip().unwrap(), &avatar.skeleton).pose(1.3),
    );
    let [min, max] = AvatarBounds::new(&avatar).bounds(&posed.joints);
    let distance = 0.5 * f64::from(size[1]) / 0.35f64.tan() * (max.y - min.y) / tall;
    let camera = Camera::orbit((min + max) / 2.0, 0.5, 0.1, distance, 0.7, size);
    (avatar, posed, camera)
}

fn each_level_agrees_with_the_reference(method: RasterMethod) {
    let device = gpu::gpu();
    for level in 1..4 {
        let options = gpu::with_method(&device.probe.name, method, SIZE);
        let options = gpu::at_level(options, level);
        let frame = gpu::frame(&device, u64::from(level), Sizes::default(), options);
        let error = error::between(&frame.image, &frame.reference.canvas.to_image()).covered;
        assert!(
            error.pixels > 2000 && error.psnr_db >= 50.0,
            "level {level}, {:?}: {error:?}",
            options.method
        );
        let counters = frame.report.counters;
        assert_eq!(
            (counters.gaussians - counters.skipped_by_detail) as usize,
            frame.reference.splats.len(),
            "level {level}"
        );
        assert!(
            counters.drawn <= counters.gaussians - counters.skipped_by_detail && counters.drawn > 0
        );
    }
}

/// With `--detail auto`: the smaller, the fewer Gaussians, and never further from what
/// each pixel's area would show on average than the image of all of them, which is too fat at a
/// distance.
fn small_avatars_stay_within_the_budget() {
    for (tall, level, psnr) in [
        (120.0, 0, f64::INFINITY),
        (80.0, 1, 34.0),
        (60.0, 2, 29.0),
        (40.0, 3, 26.0),
    ] {
        let (avatar, posed, camera) = distant(tall, [140, 140]);
        let avatar_bounds = AvatarBounds::new(&avatar);
        assert_eq!(
            Detail::AUTO.level(avatar_bounds.gaussians(), 0, || avatar_bounds
                .pixels(&posed.joints, &camera)),
            level,
            "{tall} px tall"
        );
        let draw = |camera: &Camera, level| {
            reference::ReferenceFrame::at_level(&avatar, &posed, camera, level)
                .canvas
                .to_image()
        };
        let (full, thin) = (draw(&camera, 0), draw(&camera, level));
        let area = draw(&camera.stretched(camera.size.map(|side| 8 * side)), 0).averaged(8);
        let between = |a: &FrameImage, b: &FrameImage| error::between(a, b).covered.psnr_db;
        let (off, from_area, full_from_area) = (
            between(&thin, &full),
            between(&thin, &area),
            between(&full, &area),
        );
        println!(
            "{tall} px tall, level {level}: {off:.1} dB from all, {from_area:.1} from the average, all {full_from_area:.1}"
        );
        assert!(
            off >= psnr,
            "{tall} px tall: {off} dB from all Gaussians, {psnr} expected"
        );
        assert!(
            from_area >= full_from_area,
            "{tall} px tall: {from_area} dB from each pixel's average, {full_from_area} with all Gaussians"
        );
    }
}

/// Away and back: every frame is that of a renderer that knows no other, also where the camera
/// alone moves and a body comes from the pose cache.
fn levels_change_as_the_camera_goes_away() {
    let device = gpu::gpu();
    let options = RendererOptions {
        detail: Detail::AUTO,
        ..gpu::options(SIZE)
    };
    let (avatar, posed, _) = distant(100.0, SIZE);
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    let mut drawn = vec![];
    for tall in [
        150.0, 149.0, 148.0, 80.0, 79.0, 78.0, 40.0, 39.0, 60.0, 150.0, 151.0,
    ] {
        let (_, _, camera) = distant(tall, SIZE);
        renderer.draw(&posed, &camera, None).unwrap();
        let image = renderer.read_image().unwrap();
        let mut fresh = Renderer::new(&device, &avatar, options).unwrap();
        fresh.draw(&posed, &camera, None).unwrap();
        // The pose cache is rounded.
        let error = error::between(&image, &fresh.read_image().unwrap()).covered;
        assert!(error.psnr_db > 45.0, "{tall} px tall: {error:?}");
        let counters = renderer.report().counters;
        drawn.push((
            counters.gaussians - counters.skipped_by_detail,
            counters.cached > 0,
        ));
    }
    let all = avatar.gaussians.len() as u64;
    let levels: Vec<_> = drawn
        .iter()
        .map(|&(drawn, cached)| (all / drawn, cached))
        .collect();
    // The first still frame fills the pose cache, those after it draw from it.
    let expected = [
        (1, false),
        (1, false),
        (1, true),
        (2, false),
        (2, false),
        (2, true),
        (8, false),
        (8, false),
        (4, false),
        (1, false),
        (1, false),
    ];
    assert_eq!(levels, expected);
}

/// One that stands near, and two that stand further away, sorted together; with colours that change
/// with the view.
fn avatars_of_different_levels_are_sorted_together() {
    let device = gpu::gpu();
    let mut avatar = common::avatar(
        4,
        Sizes {
            gaussians: 5001,
            ..Sizes::default()
        },
    );
    let random = &mut Random(7);
    let coefficients = (0..3 * avatar.gaussians.len())
        .map(|_| random.vector(0.2).to_array().map(f16::from_f64))
        .collect();
    avatar.sh = Some(ShCoefficients {
        degree: 1,
        coefficients,
    });
    let camera = Camera::orbit(DVec3::new(0.0, 0.9, 0.0), 0.3, 0.1, 2.4, 0.9, SIZE);
    let back = camera.view.matrix3.transpose() * DVec3::Z;
    let pose = |seed, place| {
        Posed::new(&avatar, &common::pose(seed, &avatar)).placed(DAffine3::from_translation(place))
    };
    let poses = [
        pose(1, DVec3::ZERO),
        pose(2, 17.0 * back + 3.0 * DVec3::X),
        pose(3, 31.0 * back - 5.0 * DVec3::X),
    ];
    let avatar_bounds = AvatarBounds::new(&avatar);
    let levels = poses.each_ref().map(|posed| {
        Detail::AUTO.level(avatar.gaussians.len(), 0, || {
            avatar_bounds.pixels(&posed.joints, &camera)
        })
    });
    assert!(levels[0] < levels[1] && levels[1] < levels[2], "{levels:?}");
    let options = RendererOptions {
        detail: Detail::AUTO,
        instances: 3,
        ..gpu::options(SIZE)
    };
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    renderer
        .draw_scene(&Person::copies(&poses.each_ref()), &camera, None)
        .unwrap();
    let image = renderer.read_image().unwrap();
    let splats: Vec<_> = poses
        .iter()
        .zip(levels)
        .flat_map(|(p, level)| {
            reference::ReferenceFrame::at_level(&avatar, p, &camera, level).splats
        })
        .collect();
    let reference = raster::raster(&splats, &sort::order(&splats), &camera).to_image();
    let error = error::between(&image, &reference).covered;
    assert!(
        error.pixels > 2000 && error.psnr_db >= 48.0,
        "{levels:?}: {error:?}"
    );
    let counters = renderer.report().counters;
    assert_eq!(
        (counters.gaussians - counters.skipped_by_detail) as usize,
        splats.len()
    );
}

tests! {
    each_level_agrees_with_the_reference[Quads],
    each_level_agrees_with_the_reference[CooperativeTiles],
    small_avatars_stay_within_the_budget: no_device,
    levels_change_as_the_camera_goes_away,
    avatars_of_different_levels_are_sorted_together,
}
