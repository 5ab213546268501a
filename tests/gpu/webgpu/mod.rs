//! The WebGPU backend, natively: its stages and images against the reference and against the
//! Vulkan backend.

pub mod people;
pub mod small;

use crate::{
    common::{
        self, Sizes,
        gpu::{
            self,
            Raster::{self, Quads, SharedTiles, TestedQuads},
        },
        wide,
    },
    stages::{
        raster::{avatar_in_bins, check_bins, views_of_bins},
        saturation::{Sampled, sampled_frames},
    },
};
use effigy_core::{
    avatar::{Avatar, Filter, ShCoefficients},
    frame::{AvatarId, Person, RasterMethod, RendererOptions, Skinning, Skip, SortVariant},
    io::{file::Neutral, pack::PackQuality},
    layout::SORT_CULLED,
    reference,
    scene::{Camera, Detail, Posed},
};
use effigy_measure::{error, in_rows};
use effigy_render::webgpu::{Error, Gpu, Renderer};
use glam::DVec3;
use std::sync::{Arc, Mutex, PoisonError};

/// The device that tests of this process share.
pub fn open() -> Arc<Gpu> {
    static SHARED: Mutex<Option<Arc<Gpu>>> = Mutex::new(None);
    let mut shared = SHARED.lock().unwrap_or_else(PoisonError::into_inner);
    let gpu = shared.get_or_insert_with(own);
    gpu.clone()
}

/// A device of a test's own.
fn own() -> Arc<Gpu> {
    Gpu::open(None).unwrap_or_else(|error| panic!("a WebGPU device is needed: {error}"))
}

fn body(seed: u64, gaussians: usize) -> (Avatar, Posed) {
    let avatar = common::avatar(
        seed,
        Sizes {
            gaussians,
            ..Sizes::default()
        },
    );
    let posed = Posed::new(&avatar, &common::pose(seed + 1, &avatar));
    (avatar, posed)
}

/// The demo in the middle of its clip, from the front left.
fn scene(size: [u32; 2]) -> (Avatar, Posed, Camera) {
    let avatar = effigy_demo::avatar().unwrap();
    let player =
        effigy_core::avatar::motion::Player::new(effigy_demo::clip().unwrap(), &avatar.skeleton);
    let posed = Posed::new(&avatar, &player.pose(1.3));
    let camera = gpu::camera(&avatar, &posed, size);
    (avatar, posed, camera)
}

fn images_agree_with_the_reference(raster: Raster) {
    let device = open();
    let options = raster.options(device.name(), [200, 260]);
    for seed in 0..3 {
        let (avatar, posed) = body(seed, 4000);
        let camera = gpu::camera(&avatar, &posed, options.size);
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        assert_eq!(renderer.draw(&posed, &camera), Ok(true));
        let error = error::between(
            &renderer.read_image().unwrap(),
            &reference::render(&avatar.compact(), &posed, &camera),
        );
        assert!(
            error.covered.psnr_db > 50.0,
            "seed {seed}, {options:?}: {:?}",
            error.covered
        );
    }
    device.check().unwrap();
}

fn wide_splats_show_from_far_outside_the_image(raster: Raster) {
    let device = open();
    let (avatar, posed) = wide::avatar();
    let options = raster.options(device.name(), wide::camera(1.0).size);
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    wide::check(|camera| {
        renderer.draw(&posed, camera).unwrap();
        renderer.read_image().unwrap()
    });
    device.check().unwrap();
}

/// The avatar's own filter, and another in its place.
fn filters_draw_the_references_image(raster: Raster) {
    let device = open();
    let filter = Filter {
        variance: 0.1,
        compensated: true,
    };
    let (avatar, posed) = body(1, 4000);
    let filtered = Avatar {
        filter,
        ..avatar.clone()
    };
    let options = raster.options(device.name(), [64, 80]);
    let overridden = RendererOptions {
        filter: Some(filter),
        ..options
    };
    let camera = gpu::camera(&avatar, &posed, options.size);
    let images = [(&filtered, options), (&avatar, overridden)].map(|(avatar, options)| {
        let mut renderer = Renderer::new(&device, avatar, options).unwrap();
        assert_eq!(renderer.draw(&posed, &camera), Ok(true));
        renderer.read_image().unwrap()
    });
    assert_eq!(images[0], images[1]);
    let error = error::between(
        &images[0],
        &reference::render(&filtered.compact(), &posed, &camera),
    );
    assert!(
        error.covered.psnr_db > 42.0,
        "{options:?}: {:?}",
        error.covered
    );
    device.check().unwrap();
}

fn images_agree_with_the_vulkan_backend(raster: Raster) {
    let (device, vulkan) = (open(), gpu::gpu());
    // Where quads are tested against the saturation depth, an avatar is large in the image.
    let size = if raster == TestedQuads {
        [900, 1100]
    } else {
        [512, 512]
    };
    let (avatar, posed, camera) = scene(size);
    let options = raster.options(device.name(), camera.size);
    let mut ours = Renderer::new(&device, &avatar, options).unwrap();
    ours.draw(&posed, &camera).unwrap();
    let mut theirs = effigy_render::vulkan::Renderer::new(&vulkan, &avatar, options).unwrap();
    theirs.draw(&posed, &camera, None).unwrap();
    let [ours, theirs] = [ours.read_image().unwrap(), theirs.read_image().unwrap()];
    let off =
        |(a, b): (&[f32; 4], &[f32; 4])| a.iter().zip(b).any(|(a, b)| (a - b).abs() > 2.0 / 255.0);
    let covered = theirs.pixels.iter().filter(|pixel| pixel[3] > 0.0).count();
    let off = ours
        .pixels
        .iter()
        .zip(&theirs.pixels)
        .filter(|&pair| off(pair))
        .count();
    assert!(
        covered > 10_000 && off as f64 <= 1e-3 * covered as f64,
        "{off} of {covered} pixels differ, {options:?}"
    );
}

/// The images differ from those without the depth test, by as little as Vulkan's may.
fn fragments_behind_the_saturation_depth_are_left_out_within_the_budget() {
    let device = open();
    for size in [[960, 1520], [61, 97]] {
        let (avatar, posed, camera) = scene(size);
        let [(exact, _), (image, samples)] = [Quads, TestedQuads].map(|raster| {
            let options = RendererOptions {
                count: true,
                ..raster.options(device.name(), size)
            };
            let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
            renderer.draw(&posed, &camera).unwrap();
            let image = renderer.read_image().unwrap();
            let counters = renderer.report().counters;
            assert_eq!(counters.fragments, None, "quads' fragments are not counted");
            (image, counters.samples)
        });
        let difference = error::between(&image, &exact);
        // Where Gaussians are small in the image, they would fall between the samples, and no depth
        // is tested.
        let small = size[0] < 100;
        assert!(
            difference.covered.psnr_db > 55.0
                && difference.whole.max_error < 0.05
                && (image == exact) == small
                && samples.is_none() == small,
            "{size:?}, {samples:?} samples: {:?}",
            difference.covered
        );
    }
    device.check().unwrap();
}

fn samples_are_saturated_where_the_references_are() {
    let device = open();
    gpu::require_method(device.name(), RasterMethod::Quads);
    let (avatar, frames) = sampled_frames();
    for (posed, camera, options) in frames {
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        renderer.draw(&posed, &camera).unwrap();
        let found = renderer.saturation_samples().unwrap().unwrap();
        let stages = renderer.stages().unwrap();
        let sampled = Sampled {
            avatar: &avatar,
            posed: &posed,
            camera,
            found,
            keys: &stages.keys,
            order: &stages.order,
        };
        sampled.check();
    }
}

/// Every bin has the splats whose boxes meet it.
fn each_bin_has_the_splats_that_meet_it_nearest_first() {
    let device = open();
    let avatar = avatar_in_bins();
    let mut sides = Vec::new();
    for (distance, posed, camera) in views_of_bins(&avatar) {
        let options = SharedTiles.options(device.name(), camera.size);
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        renderer.draw(&posed, &camera).unwrap();
        let bins = renderer.bin_lists().unwrap().unwrap();
        let order = renderer.stages().unwrap().order;
        let reference = reference::ReferenceFrame::new(&avatar, &posed, &camera);
        check_bins(&bins, &order, &reference, distance);
        sides.push(bins.side);
    }
    assert!(sides.contains(&32) && sides.contains(&64), "{sides:?}");
}

fn stages_are_those_of_the_vulkan_backend() {
    let (device, vulkan) = (open(), gpu::gpu());
    for quality in [None, Some(PackQuality::Small)] {
        stages_agree(&device, &vulkan, quality);
    }
    device.check().unwrap();
}

/// `quality`: of a packed avatar, drawn with one Gaussian in four.
fn stages_agree(
    device: &Arc<Gpu>,
    vulkan: &Arc<effigy_render::vulkan::Gpu>,
    quality: Option<PackQuality>,
) {
    let (avatar, posed) = body(11, 3000);
    let avatar = quality.map_or_else(|| avatar.clone(), |quality| avatar.packed(quality));
    let detail = Detail::FULL.at_least(quality.map_or(0, |_| 2));
    let options = RendererOptions {
        skip: Skip::empty(),
        detail,
        ..gpu::options([300, 300])
    };
    let camera = gpu::camera(&avatar, &posed, options.size);
    let mut ours = Renderer::new(device, &avatar, options).unwrap();
    ours.draw(&posed, &camera).unwrap();
    let mut theirs = effigy_render::vulkan::Renderer::new(vulkan, &avatar, options).unwrap();
    theirs.draw(&posed, &camera, None).unwrap();
    let (ours, theirs) = (ours.stages().unwrap(), theirs.stages().unwrap());
    let close = |what: &str, a: &[f32], b: &[f32], tolerance: f64| {
        let [a, b] = [a, b].map(|all| all.iter().map(|&x| f64::from(x)).collect::<Vec<_>>());
        gpu::assert_close(what, &a, &b, tolerance);
    };
    close("features", &ours.features, &theirs.features, 1e-4);
    close(
        "nodes",
        ours.nodes.as_flattened(),
        theirs.nodes.as_flattened(),
        1e-5,
    );
    assert_eq!(ours.keys.len(), theirs.keys.len());
    for (i, (a, b)) in ours.keys.iter().zip(&theirs.keys).enumerate() {
        assert!(a.abs_diff(*b) <= 1, "key {i} is {a}, expected {b}");
    }
    let drawn = (0..ours.keys.len())
        .filter(|&i| ours.keys[i] != SORT_CULLED && theirs.keys[i] != SORT_CULLED);
    for i in drawn {
        // A step of a coordinate is far below a pixel; colours and opacities are of 8 to 10 bits.
        let place = |words: [u32; 4]| [words[0] & 0xf_ffff, words[1] & 0xf_ffff];
        let color = |words: [u32; 4]| {
            [
                words[0] >> 20 & 1023,
                words[1] >> 20 & 1023,
                words[3] >> 24 << 2 | words[0] >> 30,
                words[3] >> 16 & 255,
            ]
        };
        let (a, b) = (ours.splats[i], theirs.splats[i]);
        let near =
            |a: &[u32], b: &[u32], most| a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) <= most);
        assert!(
            near(&place(a), &place(b), 4) && near(&color(a), &color(b), 1),
            "splat {i} is {a:x?}, expected {b:x?}"
        );
    }
}

fn the_order_is_that_of_a_stable_sort() {
    let device = open();
    // More tiles than each workgroup sums.
    let (avatar, _, camera) = scene([64, 64]);
    let player =
        effigy_core::avatar::motion::Player::new(effigy_demo::clip().unwrap(), &avatar.skeleton);
    for (instances, variant) in [
        (1, SortVariant::PerThread),
        (1, SortVariant::ReduceThenScan),
        (10, SortVariant::PerThread),
        (10, SortVariant::ReduceThenScan),
    ] {
        let poses: Vec<_> = (0..instances)
            .map(|k| Posed::new(&avatar, &player.pose(0.3 * k as f64)).placed(in_rows(k % 3, 3)))
            .collect();
        let options = RendererOptions {
            instances,
            sort: Some(variant),
            skip: Skip::empty(),
            ..gpu::options([64, 64])
        };
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        renderer
            .draw_scene(&Person::copies(&poses.iter().collect::<Vec<_>>()), &camera)
            .unwrap();
        let stages = renderer.stages().unwrap();
        let mut expected: Vec<u32> = (0..stages.keys.len() as u32)
            .filter(|&i| stages.keys[i as usize] != SORT_CULLED)
            .collect();
        expected.sort_by_key(|&i| stages.keys[i as usize]);
        assert!(
            expected.len() > 10_000 * instances,
            "{} of {} instances are drawn",
            expected.len(),
            instances
        );
        assert_eq!(stages.control.visible_count as usize, expected.len());
        assert!(
            stages.order == expected,
            "{instances} instances, {variant:?}"
        );
    }
}

fn only_what_changed_is_drawn_again(raster: Raster) {
    let device = open();
    let (avatar, posed, camera) = scene([320, 320]);
    let avatar = common::faced(avatar);
    // All Gaussians, and every second.
    let level = u32::from(raster == Quads);
    let options = RendererOptions {
        count: true,
        detail: Detail::FULL.at_least(level),
        ..raster.options(device.name(), camera.size)
    };
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    let cameras: Vec<_> = (0..3)
        .map(|k| Camera {
            center: camera.center + f64::from(k) * DVec3::X.truncate(),
            ..camera
        })
        .collect();
    assert_eq!(renderer.draw(&posed, &cameras[0]), Ok(true));
    assert_eq!(
        renderer.draw(&posed, &cameras[0]),
        Ok(false),
        "nothing has changed"
    );
    assert!(renderer.report().skipped.contains(&"raster"));
    for camera in &cameras[1..] {
        assert_eq!(renderer.draw(&posed, camera), Ok(true));
    }
    let image = renderer.read_image().unwrap();
    let counters = renderer.report().counters;
    assert_eq!(
        (counters.cached, counters.networks),
        (counters.gaussians - counters.skipped_by_detail, 0),
        "{:?}",
        Skinning::Cached
    );
    let reasons = counters.reasons.unwrap();
    assert!(reasons.away > 100, "{reasons:?}");
    assert_eq!(
        reasons.outside
            + reasons.away
            + reasons.faint
            + reasons.degenerate
            + counters.drawn
            + counters.skipped_by_detail,
        counters.gaussians,
        "{reasons:?}"
    );
    let reference = reference::ReferenceFrame::at_level(&avatar, &posed, &cameras[2], level)
        .canvas
        .to_image();
    let error = error::between(&image, &reference);
    assert!(
        error.covered.psnr_db > 48.0,
        "{options:?}: {:?}",
        error.covered
    );
}

fn scenes_of_several_leave_out_who_is_not_seen() {
    let device = open();
    let (avatar, posed, camera) = scene([200, 200]);
    let far = posed
        .clone()
        .placed(glam::DAffine3::from_translation(DVec3::new(50.0, 0.0, 0.0)));
    let mut renderer = Renderer::new(
        &device,
        &avatar,
        RendererOptions {
            instances: 3,
            ..gpu::options([200, 200])
        },
    )
    .unwrap();
    renderer
        .draw_scene(&Person::copies(&[&far, &posed]), &camera)
        .unwrap();
    let both = renderer.read_image().unwrap();
    assert_eq!(renderer.report().counters.avatars_culled, 1);
    let mut alone = Renderer::new(&device, &avatar, gpu::options([200, 200])).unwrap();
    alone.draw(&posed, &camera).unwrap();
    assert!(both == alone.read_image().unwrap());
    renderer
        .draw_scene(&Person::copies(&[&far, &far]), &camera)
        .unwrap();
    assert!(
        renderer
            .read_image()
            .unwrap()
            .pixels
            .iter()
            .all(|&pixel| pixel == [0.0; 4]),
        "nobody is in view"
    );
    assert!(matches!(
        renderer.draw_scene(&Person::copies(&[&posed; 4]), &camera),
        Err(Error::Unusable(_))
    ));
}

/// One near, one far and small; then both far, which are fewer Gaussians.
fn avatars_of_different_levels_are_those_of_the_vulkan_backend() {
    let (device, vulkan) = (open(), gpu::gpu());
    let (avatar, posed, camera) = scene([200, 200]);
    let back = camera.view.matrix3.transpose() * DVec3::Z;
    let away = |metres: f64| {
        posed
            .clone()
            .placed(glam::DAffine3::from_translation(metres * back))
    };
    let options = RendererOptions {
        instances: 2,
        detail: Detail::AUTO,
        method: Some(RasterMethod::SharedTiles),
        ..gpu::options([200, 200])
    };
    let mut ours = Renderer::new(&device, &avatar, options).unwrap();
    let mut theirs = effigy_render::vulkan::Renderer::new(&vulkan, &avatar, options).unwrap();
    let mut thinned = vec![];
    for poses in [
        [away(0.0), away(9.0)],
        [away(6.0), away(9.0)],
        [away(0.0), away(9.0)],
    ] {
        ours.draw_scene(&Person::copies(&poses.each_ref()), &camera)
            .unwrap();
        theirs
            .draw_scene(&Person::copies(&poses.each_ref()), &camera, None)
            .unwrap();
        let [ours_seen, theirs_seen] = [ours.read_image().unwrap(), theirs.read_image().unwrap()];
        let error = error::between(&ours_seen, &theirs_seen).covered;
        assert!(error.pixels > 500 && error.psnr_db > 50.0, "{error:?}");
        let counters = [ours.report().counters, theirs.report().counters];
        assert_eq!(counters[0].skipped_by_detail, counters[1].skipped_by_detail);
        thinned.push(counters[0].skipped_by_detail);
    }
    assert!(
        thinned[0] > 0 && thinned[1] > thinned[0] && thinned[2] == thinned[0],
        "{thinned:?}"
    );
}

fn images_of_any_size_follow_a_resize(raster: Raster) {
    let device = open();
    let (avatar, posed) = body(2, 500);
    let options = raster.options(device.name(), [64, 64]);
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    for size in [[1, 1], [7, 300], [640, 3], [200, 200]] {
        renderer.resize(size).unwrap();
        let camera = gpu::camera(&avatar, &posed, size);
        renderer.draw(&posed, &camera).unwrap();
        let error = error::between(
            &renderer.read_image().unwrap(),
            &reference::render(&avatar, &posed, &camera),
        );
        assert!(
            error.whole.psnr_db > 54.0,
            "{size:?}, {options:?}: {:?}",
            error.whole
        );
    }
    let message = renderer.resize([0, 5]).unwrap_err().to_string();
    assert!(message.contains("0 × 5"), "{message}");
}

fn colours_that_follow_the_camera_agree_with_the_reference() {
    let device = open();
    for degree in 1..=3usize {
        let (mut avatar, posed) = body(20 + degree as u64, 1500);
        let functions = (degree + 1).pow(2) - 1;
        let random = &mut common::Random(degree as u64);
        let coefficients = (0..functions * avatar.gaussians.len())
            .map(|_| common::f16s(random.vector(0.2).to_array()))
            .collect();
        avatar.sh = Some(ShCoefficients {
            degree,
            coefficients,
        });
        let camera = gpu::camera(&avatar, &posed, [200, 200]);
        let mut renderer = Renderer::new(&device, &avatar, gpu::options([200, 200])).unwrap();
        renderer.draw(&posed, &camera).unwrap();
        let error = error::between(
            &renderer.read_image().unwrap(),
            &reference::render(&avatar.compact(), &posed, &camera),
        );
        assert!(
            error.covered.psnr_db > 50.0,
            "degree {degree}: {:?}",
            error.covered
        );
    }
}

fn an_avatar_is_drawn_before_its_correctives_are_there(raster: Raster) {
    let device = open();
    let (avatar, posed) = body(31, 2000);
    let small = avatar.packed(PackQuality::Small);
    let lit = Avatar {
        sh: Some(common::harmonics(32, avatar.gaussians.len(), 2)),
        ..avatar.clone()
    };
    let files = [
        (&lit, lit.to_packed_bytes()),
        (&avatar, avatar.to_bytes()),
        (&avatar, avatar.to_packed_bytes()),
        (&small, small.to_packed_bytes()),
    ];
    let options = raster.options(device.name(), [160, 160]);
    for (avatar, file) in files {
        let file = file.unwrap();
        let neutral = neutral(&file);
        let camera = gpu::camera(avatar, &posed, options.size);
        let mut renderer = Renderer::new(&device, &neutral, options).unwrap();
        renderer.draw(&posed, &camera).unwrap();
        let error = error::between(
            &renderer.read_image().unwrap(),
            &reference::render(&neutral.compact(), &posed, &camera),
        );
        assert!(
            error.covered.psnr_db > 50.0,
            "{options:?}: {:?}",
            error.covered
        );
        assert_eq!(renderer.replace_avatar(AvatarId::FIRST, avatar), Ok(true));
        assert_eq!(
            renderer.draw(&posed, &camera),
            Ok(true),
            "the avatar is another"
        );
        let mut whole = Renderer::new(&device, avatar, options).unwrap();
        whole.draw(&posed, &camera).unwrap();
        assert!(
            renderer.read_image().unwrap() == whole.read_image().unwrap(),
            "{options:?}"
        );
        assert_eq!(
            renderer.replace_avatar(
                AvatarId::FIRST,
                &common::avatar(
                    32,
                    Sizes {
                        gaussians: 1999,
                        ..Sizes::default()
                    }
                )
            ),
            Ok(false)
        );
    }
}

/// What as much of a file holds as is needed for that.
pub fn neutral(file: &[u8]) -> Avatar {
    let needs = |bytes: &[u8]| match Avatar::neutral(bytes, file.len()) {
        Ok(Neutral::Needs(bytes)) => bytes,
        other => panic!("{other:?}"),
    };
    let header = needs(&file[..8]);
    assert!(needs(&[]) == 8 && needs(&file[..header - 1]) == header);
    let end = needs(&file[..header]);
    assert!(
        end < file.len() / 2 && needs(&file[..end - 1]) == end,
        "{end} of {} bytes",
        file.len()
    );
    assert!(
        Avatar::neutral(&file[..end], file.len() + 1)
            .is_err_and(|fault| fault.to_string().contains("as the server says"))
    );
    let Ok(Neutral::Avatar(neutral)) = Avatar::neutral(&file[..end], file.len()) else {
        panic!("{end} bytes are enough")
    };
    *neutral
}

/// Where nothing is and nothing was, tiles leave the image as it is: while the avatar crosses it,
/// comes near, leaves it and comes again.
fn only_a_box_around_the_avatar_is_drawn(raster: Raster) {
    let device = open();
    let (avatar, posed) = body(3, 3000);
    let size = [300, 200];
    let bounds = effigy_core::scene::AvatarBounds::new(&avatar).bounds(&posed.joints);
    let draw = |skip| {
        let options = RendererOptions {
            skip,
            ..raster.options(device.name(), size)
        };
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        let views = [
            (90.0, 3.0),
            (0.0, 3.0),
            (0.9, 3.0),
            (0.0, 0.8),
            (0.1, 6.0),
            (90.0, 3.0),
            (0.2, 4.0),
        ];
        views.map(|(left, far)| {
            let target = (bounds[0] + bounds[1]) / 2.0 + DVec3::new(left, 0.0, 0.0);
            let camera = Camera::orbit(
                target,
                0.0,
                0.0,
                far * Camera::framing_distance(bounds, 0.6, size),
                0.6,
                size,
            );
            renderer.draw(&posed, &camera).unwrap();
            let image = renderer.read_image().unwrap();
            renderer.ready();
            (image, renderer.report().counters.damaged)
        })
    };
    let (all, some) = (draw(Skip::empty()), draw(Skip::DAMAGE));
    for (k, ((exact, _), (image, _))) in all.iter().zip(&some).enumerate() {
        assert!(image == exact, "image {k}");
    }
    assert!(
        some.iter().any(|(_, area)| *area < 300 * 200)
            && all.iter().all(|(_, area)| *area == 300 * 200)
    );
    device.check().unwrap();
}

fn what_a_device_refuses_while_it_is_watched_is_the_watchs_error() {
    let device = open();
    let watch = device.watch();
    let usage =
        wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::MAP_WRITE | wgpu::BufferUsages::STORAGE;
    let _ = device.device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: 16,
        usage,
        mapped_at_creation: false,
    });
    assert!(matches!(
        pollster::block_on(watch.end()),
        Err(Error::Refused(_))
    ));
    assert_eq!(
        (device.check(), pollster::block_on(device.watch().end())),
        (Ok(()), Ok(()))
    );
}

/// What only the Vulkan backend has is refused by name.
fn options_of_the_vulkan_backend_are_refused() {
    let device = open();
    let (avatar, _) = body(3, 800);
    let options = gpu::options([64, 64]);
    for (options, named) in [
        (
            RendererOptions {
                method: Some(RasterMethod::CooperativeTiles),
                ..options
            },
            "cooperative",
        ),
        (
            RendererOptions {
                sort: Some(SortVariant::OneSweep),
                ..options
            },
            "OneSweep",
        ),
    ] {
        let error = Renderer::new(&device, &avatar, options).err().unwrap();
        assert!(error.to_string().contains(named), "{error}");
    }
}

fn a_lost_device_says_so_and_another_goes_on() {
    let device = own();
    let (avatar, posed) = body(3, 800);
    let options = gpu::options([120, 120]);
    let camera = gpu::camera(&avatar, &posed, options.size);
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    renderer.draw(&posed, &camera).unwrap();
    let before = renderer.read_image().unwrap();
    device.close();
    assert!(!pollster::block_on(device.lost()).is_empty());
    let lost = renderer
        .draw(
            &posed,
            &Camera {
                focal: 1.01 * camera.focal,
                ..camera
            },
        )
        .and_then(|_| renderer.finish());
    assert!(matches!(lost, Err(Error::DeviceLost(_))), "{lost:?}");
    let again = own();
    let mut renderer = Renderer::new(&again, &avatar, options).unwrap();
    renderer.draw(&posed, &camera).unwrap();
    assert!(renderer.read_image().unwrap() == before);
}

tests! {
    images_agree_with_the_reference[Quads],
    images_agree_with_the_reference[TestedQuads],
    images_agree_with_the_reference[SharedTiles],
    filters_draw_the_references_image[Quads],
    filters_draw_the_references_image[SharedTiles],
    wide_splats_show_from_far_outside_the_image[Quads],
    wide_splats_show_from_far_outside_the_image[TestedQuads],
    wide_splats_show_from_far_outside_the_image[SharedTiles],
    images_agree_with_the_vulkan_backend[Quads],
    images_agree_with_the_vulkan_backend[TestedQuads],
    images_agree_with_the_vulkan_backend[SharedTiles],
    fragments_behind_the_saturation_depth_are_left_out_within_the_budget,
    samples_are_saturated_where_the_references_are,
    each_bin_has_the_splats_that_meet_it_nearest_first,
    stages_are_those_of_the_vulkan_backend,
    the_order_is_that_of_a_stable_sort,
    only_what_changed_is_drawn_again[Quads],
    only_what_changed_is_drawn_again[SharedTiles],
    scenes_of_several_leave_out_who_is_not_seen,
    avatars_of_different_levels_are_those_of_the_vulkan_backend,
    images_of_any_size_follow_a_resize[Quads],
    images_of_any_size_follow_a_resize[TestedQuads],
    images_of_any_size_follow_a_resize[SharedTiles],
    colours_that_follow_the_camera_agree_with_the_reference,
    an_avatar_is_drawn_before_its_correctives_are_there[Quads],
    an_avatar_is_drawn_before_its_correctives_are_there[SharedTiles],
    only_a_box_around_the_avatar_is_drawn[SharedTiles],
    what_a_device_refuses_while_it_is_watched_is_the_watchs_error,
    options_of_the_vulkan_backend_are_refused,
    a_lost_device_says_so_and_another_goes_on,
}
