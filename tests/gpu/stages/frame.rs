//! Whole frames on the device against the reference, as images.

use crate::common::{
    self, Sizes,
    gpu::{
        self,
        Raster::{self, CooperativeTiles, Quads, SharedTiles, TestedQuads},
    },
    wide,
};
use effigy_core::{
    avatar::{Avatar, Filter},
    frame::AvatarId,
    scene::{Camera, Posed},
};
use effigy_lab::stress::Rasterizer;
use effigy_measure::error;
use effigy_render::vulkan::{Error, Gpu, GpuOptions, PreparedAvatar, Renderer, RendererOptions};
use std::sync::Arc;

fn compare(exact: bool, psnr: f64, within: f64) {
    let device = gpu::gpu();
    compare_on(&device, exact, psnr, within);
}

fn compare_on(device: &Arc<Gpu>, exact: bool, psnr: f64, within: f64) {
    for seed in 0..3 {
        let options = RendererOptions {
            exact,
            ..gpu::options([320, 400])
        };
        let frame = gpu::frame(device, seed, Sizes::default(), options);
        let error = error::between(&frame.image, &frame.reference.canvas.to_image());
        println!(
            "seed {seed}: {:?} drawn {}",
            error.covered, frame.report.counters.drawn
        );
        assert!(
            error.covered.pixels > 5000,
            "the avatar is hardly in the image"
        );
        assert!(
            error.covered.psnr_db >= psnr,
            "seed {seed}, exact {exact}: {:?}, at least {psnr} dB expected",
            error.covered
        );
        assert!(
            error.covered.within_tolerance >= within,
            "seed {seed}, exact {exact}: {:?}",
            error.covered
        );
    }
}

fn eight_bit_images_agree_with_the_reference() {
    compare(false, 48.0, 0.995);
}

fn floating_point_images_agree_with_the_reference() {
    compare(true, 54.0, 0.999);
}

fn a_baseline_device_draws_within_the_error_budget() {
    let device = gpu::open(GpuOptions {
        baseline: true,
        ..gpu::headless()
    });
    assert_eq!(
        (device.probe.timestamp_bits, device.probe.subgroup_sizes),
        (0, None)
    );
    compare_on(&device, false, 48.0, 0.995);
    compare_on(&device, true, 54.0, 0.999);
}

/// A small body, so that most Gaussians are under a pixel, by every rasterizer.
fn filters_draw_the_references_image() {
    let device = gpu::gpu();
    let [fine, default] = [
        Filter {
            variance: 0.1,
            compensated: true,
        },
        Filter::DEFAULT,
    ];
    for rasterizer in Rasterizer::ALL {
        let mut options = gpu::options([64, 80]);
        rasterizer.choose(&mut options);
        let lacks = |method| device.probe.lacks_for(method).is_some();
        if options.method.is_some_and(lacks) {
            continue;
        }
        let own = |filter| {
            let avatar = Avatar {
                filter,
                ..common::avatar(1, Sizes::default())
            };
            gpu::frame_of(&device, avatar, 1, options)
        };
        let overridden = |own, by| {
            let avatar = Avatar {
                filter: own,
                ..common::avatar(1, Sizes::default())
            };
            let options = RendererOptions {
                filter: Some(by),
                ..options
            };
            gpu::frame_of(&device, avatar, 1, options)
        };
        let frame = own(fine);
        let error = error::between(&frame.image, &frame.reference.canvas.to_image());
        println!("{}: {:?}", rasterizer.name(), error.covered);
        assert!(
            error.covered.pixels > 500 && error.covered.psnr_db >= 42.0,
            "{}: {:?}",
            rasterizer.name(),
            error.covered
        );
        assert_eq!(overridden(default, fine).image, frame.image);
        let plain = overridden(fine, default);
        assert!(
            error::between(&frame.image, &plain.image).covered.psnr_db < 32.0,
            "the filter shows"
        );
    }
}

fn an_image_is_read_after_a_frame_and_not_before() {
    let device = gpu::gpu();
    let avatar = common::avatar(4, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(4, &avatar));
    let camera = Camera::orbit(glam::DVec3::Y, 0.0, 0.0, 3.0, 0.7, [32, 32]);
    let mut renderer = Renderer::new(&device, &avatar, gpu::options([32, 32])).unwrap();
    assert!(matches!(renderer.read_image(), Err(Error::NothingDrawn)));
    renderer.draw(&posed, &camera, None).unwrap();
    assert_eq!(renderer.read_image().unwrap().size, [32, 32]);
    renderer.resize([48, 32]).unwrap();
    assert!(matches!(renderer.read_image(), Err(Error::NothingDrawn)));
}

/// Another avatar of the same size takes its place without new kernels, cached poses included; of
/// one that needs other buffers it is said, and nothing changes.
fn an_avatar_takes_the_place_of_another() {
    let device = gpu::gpu();
    let options = gpu::options([160, 200]);
    let [first, second] = [7, 8].map(|seed| common::avatar(seed, Sizes::default()));
    let other = common::avatar(
        8,
        Sizes {
            rows: 299,
            ..Sizes::default()
        },
    );
    let posed = Posed::new(&first, &common::pose(7, &first));
    let near = gpu::camera(&first, &posed, [160, 200]);
    let far = Camera {
        focal: 0.9 * near.focal,
        ..near
    };
    let mut renderer = Renderer::new(&device, &first, options).unwrap();
    // The second frame stores the pose, the third draws what is stored.
    for camera in [&near, &far, &near] {
        renderer.draw(&posed, camera, None).unwrap();
    }
    let shown = renderer.read_image().unwrap();
    let prepare = |avatar| PreparedAvatar::new(avatar).unwrap();
    assert!(
        !renderer
            .replace_avatar(AvatarId::FIRST, &prepare(&other))
            .unwrap()
    );
    assert_eq!(renderer.read_image().unwrap(), shown);
    assert!(
        renderer
            .replace_avatar(AvatarId::FIRST, &prepare(&second))
            .unwrap()
    );
    assert!(matches!(renderer.read_image(), Err(Error::NothingDrawn)));
    let posed = Posed::new(&second, &common::pose(7, &second));
    let mut own = Renderer::new(&device, &second, options).unwrap();
    for camera in [&near, &far, &near] {
        for renderer in [&mut renderer, &mut own] {
            renderer.draw(&posed, camera, None).unwrap();
        }
        let found = renderer.read_image().unwrap();
        assert_eq!(found, own.read_image().unwrap());
        assert!(error::between(&found, &shown).covered.psnr_db < 40.0);
    }
}

fn wide_splats_show_from_far_outside_the_image(raster: Raster) {
    let device = gpu::gpu();
    let (avatar, posed) = wide::avatar();
    let options = raster.options(&device.probe.name, wide::camera(1.0).size);
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    wide::check(|camera| {
        renderer.draw(&posed, camera, None).unwrap();
        renderer.read_image().unwrap()
    });
}

tests! {
    an_avatar_takes_the_place_of_another,
    an_image_is_read_after_a_frame_and_not_before,
    eight_bit_images_agree_with_the_reference: smoke,
    filters_draw_the_references_image,
    floating_point_images_agree_with_the_reference,
    a_baseline_device_draws_within_the_error_budget,
    wide_splats_show_from_far_outside_the_image[Quads],
    wide_splats_show_from_far_outside_the_image[TestedQuads],
    wide_splats_show_from_far_outside_the_image[CooperativeTiles],
    wide_splats_show_from_far_outside_the_image[SharedTiles],
}
