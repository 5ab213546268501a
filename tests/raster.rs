//! The `raster` stage: the draw order that it uses, and pictures of few Gaussians whose every pixel the reference knows.

mod common;

use common::{Sizes, gpu};
use effigy::{
    frame::{Camera, Posed},
    measure::error,
    vulkan::{Renderer, RendererOptions, sort::KeyBits},
};
use glam::DVec3;
use half::f16;

#[test]
fn the_order_is_the_references_but_for_depths_closer_than_a_key() {
    let Some(device) = gpu::gpu() else { return };
    for key_bits in [KeyBits::Sixteen, KeyBits::ThirtyTwo] {
        // Without displacements of nodes, which the device rounds.
        let mut avatar = common::avatar(5, Sizes::default());
        avatar.nodes.basis.fill(f16::ZERO);
        avatar.nodes.offset.fill([f16::ZERO; 3]);
        let posed = Posed::new(&avatar, &common::pose(6, &avatar));
        let camera = gpu::camera(&avatar, &posed, [200, 200]);
        let frame = gpu::draw(&device, avatar, posed, camera, RendererOptions { key_bits, ..gpu::options([200, 200]) });
        let depth = |at: u32| frame.oracle.splats[at as usize].as_ref().map(|splat| splat.depth).unwrap_or(f64::NAN);
        // 16 bits over the avatar's depth, 3 m at most, or f32's resolution there.
        let step = if key_bits == KeyBits::Sixteen { 3.0 / 65535.0 } else { 2e-6 };
        for pair in frame.gpu.order.windows(2) {
            assert!(
                depth(pair[0]) >= depth(pair[1]) - step,
                "{} at {} m is drawn before {} at {} m",
                pair[0],
                depth(pair[0]),
                pair[1],
                depth(pair[1])
            );
            assert!(depth(pair[0]) != depth(pair[1]) || pair[0] < pair[1], "equal depths of {} and {} changed order", pair[0], pair[1]);
        }
        assert_eq!(frame.gpu.order.len(), frame.oracle.order.len());
    }
    gpu::assert_valid();
}

#[test]
fn few_gaussians_agree_pixel_by_pixel() {
    let Some(device) = gpu::gpu() else { return };
    for seed in 0..6 {
        let sizes = Sizes { gaussians: 1 + seed as usize * 3, parts: 1, nodes: 1, rows: 1, ..Sizes::default() };
        let avatar = common::avatar(seed, sizes);
        let posed = Posed::new(&avatar, &common::pose(seed, &avatar));
        let target = effigy::reference::Stages::new(&avatar, &posed, &gpu::camera(&avatar, &posed, [64, 64])).gaussians[0].mean;
        let camera = Camera::orbit(target, 0.2, 0.1, 0.3, 0.6, [240, 160]);
        let frame = gpu::draw(&device, avatar, posed, camera, gpu::options([240, 160]));
        let error = error::between(&frame.picture, &frame.oracle.canvas.to_picture());
        assert!(error.covered.pixels > 100, "seed {seed}: nothing in the picture");
        assert!(error.covered.max_error < 4.0 / 255.0 && error.covered.psnr_db > 54.0, "seed {seed}: {:?}", error.covered);
    }
    gpu::assert_valid();
}

#[test]
fn nothing_in_view_is_an_empty_picture() {
    let Some(device) = gpu::gpu() else { return };
    let avatar = common::avatar(1, Sizes::default());
    let posed = Posed::new(&avatar, &common::pose(1, &avatar));
    let away = Camera::look_at(DVec3::new(0.0, 1.0, 5.0), DVec3::new(0.0, 1.0, 9.0), 0.7, [50, 40]);
    let frame = gpu::draw(&device, avatar, posed, away, gpu::options([50, 40]));
    assert_eq!(frame.gpu.control.survivors, 0);
    assert!(frame.picture.pixels.iter().all(|&pixel| pixel == [0.0; 4]));
    gpu::assert_valid();
}

#[test]
fn pictures_of_any_size_follow_a_resize() {
    let Some(device) = gpu::gpu() else { return };
    let avatar = common::avatar(2, Sizes { gaussians: 500, ..Sizes::default() });
    let posed = Posed::new(&avatar, &common::pose(2, &avatar));
    let mut renderer = Renderer::new(&device, &avatar, gpu::options([64, 64])).unwrap();
    for size in [[1, 1], [7, 300], [640, 3], [200, 200]] {
        renderer.resize(size).unwrap();
        let camera = gpu::camera(&avatar, &posed, size);
        renderer.draw(&posed, &camera, None).unwrap();
        let oracle = effigy::reference::render(&avatar, &posed, &camera);
        let error = error::between(&renderer.picture().unwrap(), &oracle);
        assert!(error.whole.psnr_db > 54.0, "{size:?}: {:?}", error.whole);
    }
    let message = renderer.resize([0, 5]).unwrap_err().to_string();
    assert!(message.contains("0 × 5"), "{message}");
    assert_eq!(renderer.raster().image().size, [200, 200], "the old picture stays");
    gpu::assert_valid();
}

#[test]
fn two_runs_give_the_same_bits() {
    let Some(device) = gpu::gpu() else { return };
    let [first, second] = [0, 1].map(|_| gpu::frame(&device, 9, Sizes::default(), gpu::options([160, 160])));
    assert!(first.picture == second.picture, "two runs differ");
    gpu::assert_valid();
}
