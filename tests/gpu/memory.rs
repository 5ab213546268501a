//! Memory: hundreds of frames hold what the first ones took, and what only some frames need is
//! taken by those.

use crate::common::{
    self, Sizes,
    gpu::{
        self,
        Raster::{self, CooperativeTiles, Quads, SharedTiles, TestedQuads},
    },
    harness::not_run,
};
use effigy_core::{
    avatar::Pose,
    frame::Skip,
    layout::{BINNING_BLOCK, POSE_CACHE_WORDS, TILING},
    scene::{Camera, Detail, FrameImage, Posed, Supersampling},
};
use effigy_measure::{error, soak::memory::resident_bytes};
use effigy_render::{
    quirks::leaves_loops,
    vulkan::{Gpu, Renderer, RendererOptions},
};
use glam::DVec3;

/// What `read` gives after a warm-up, and after 800 more frames, whose sizes, samples, cutoff and
/// detail change as a governor changes them.
fn before_and_after<T>(device: &std::sync::Arc<Gpu>, read: impl Fn() -> T) -> [T; 2] {
    let avatar = common::avatar(
        11,
        Sizes {
            gaussians: 1000,
            ..Sizes::default()
        },
    );
    let size = [96, 120];
    let options = RendererOptions {
        supersampling: Supersampling::BySize,
        ..gpu::options(size)
    };
    let mut renderer = Renderer::new(device, &avatar, options).unwrap();
    let poses: Vec<_> = (0..20)
        .map(|seed| Posed::new(&avatar, &common::pose(seed, &avatar)))
        .collect();
    let camera = gpu::camera(&avatar, &poses[0], size);
    let mut draw = |frames: usize| {
        for frame in 0..frames {
            let part = if frame / 50 % 2 == 0 { size } else { [48, 60] };
            let odd = frame / 100 % 2 == 1;
            let detail = Detail::FULL.at_least(u32::from(odd));
            renderer.adjust(part, detail).unwrap();
            let mut camera = camera.stretched(part);
            // Nearer and further: the samples follow.
            camera.view.translation.z += 0.2 * (frame % 7) as f64;
            renderer
                .draw(&poses[frame % poses.len()], &camera, None)
                .unwrap();
        }
        renderer.finish().unwrap();
        read()
    };
    draw(400);
    [draw(400), draw(800)]
}

fn the_devices_memory_does_not_grow_with_frames() {
    let device = gpu::gpu();
    let [before, after] = before_and_after(&device, || device.memory());
    assert_eq!(after, before, "the device's memory: in use, and in blocks");
}

/// Bytes of this process that hold code. None where the system does not tell.
fn code_bytes() -> Option<u64> {
    let maps = std::fs::read_to_string("/proc/self/maps").ok()?;
    let bytes = maps.lines().filter_map(|line| {
        let mut words = line.split(' ');
        let (start, end) = words.next()?.split_once('-')?;
        let is_code = words.next()?.contains('x');
        let address = |text| u64::from_str_radix(text, 16).ok();
        is_code.then_some(address(end)? - address(start)?)
    });
    Some(bytes.sum())
}

/// A driver that compiles a kernel again for some frames takes most of their time for it.
fn no_kernel_is_compiled_while_frames_run() {
    let device = gpu::gpu();
    let [Some(before), Some(after)] = before_and_after(&device, code_bytes) else {
        not_run("this system does not tell where a process has code")
    };
    assert_eq!(after, before, "bytes of code after 800 frames and before");
}

fn the_processs_memory_does_not_grow_with_frames() {
    let device = gpu::gpu();
    let [Some(before), Some(after)] = before_and_after(&device, resident_bytes) else {
        not_run("this system does not tell a process's memory")
    };
    let gained = after as i64 - before as i64;
    assert!(
        gained < 8 << 20,
        "the process gained {gained} bytes in 800 frames"
    );
}

/// Poses get a cache with the first frame in which only the camera moved, not before, and all that
/// reads splats reads those beside it then.
fn the_pose_cache_takes_memory_once_it_is_used(raster: Raster) {
    let device = gpu::gpu();
    let gaussians = 5000;
    let avatar = common::avatar(
        4,
        Sizes {
            gaussians,
            ..Sizes::default()
        },
    );
    let size = [200, 240];
    let options = raster.options(&device.probe.name, size);
    let poses = [1, 2, 2, 2, 3, 3].map(|seed| Posed::new(&avatar, &common::pose(seed, &avatar)));
    let camera = |frame: usize| {
        let yaw = 0.3 * frame as f64;
        Camera::orbit(DVec3::Y, yaw, 0.1, 3.0, 0.8, size)
    };
    let images = |skip: Skip| -> Vec<(FrameImage, u64)> {
        let options = RendererOptions { skip, ..options };
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        let mut draw = |frame: usize| {
            renderer.draw(&poses[frame], &camera(frame), None).unwrap();
            (renderer.read_image().unwrap(), device.memory().0)
        };
        (0..poses.len()).map(&mut draw).collect()
    };
    let cached = images(options.skip | Skip::SKINNING);
    let cache = 4 * u64::from(POSE_CACHE_WORDS) * gaussians as u64;
    let before = cached[0].1;
    assert_eq!(cached[1].1, before, "a frame in motion takes memory");
    for (frame, (_, memory)) in cached.iter().enumerate().skip(2) {
        let gained = memory - before;
        assert!(
            (cache..2 * cache).contains(&gained),
            "frame {frame}: {gained} bytes for a cache of {cache}"
        );
    }
    let computed = images(options.skip - Skip::SKINNING);
    assert!(computed.iter().all(|(_, memory)| *memory < before + cache));
    for (frame, (a, b)) in cached.iter().zip(&computed).enumerate() {
        // The first frame of a still pose fills the cache, and draws what it computes itself.
        let is_cached = frame == 3;
        let difference = error::between(&a.0, &b.0).covered;
        assert!(
            a.0 == b.0 || is_cached && difference.psnr_db > 50.0,
            "image {frame}: {difference:?}"
        );
    }
}

/// The tiles' lists have few blocks while frames ask for few, and the most once they don't; the
/// image stays the same.
fn tile_lists_have_what_frames_ask_for() {
    let device = gpu::gpu();
    if leaves_loops(&device.probe.driver) {
        not_run("the lists of so many splats take more rounds of a loop than this driver runs");
    }
    let avatar = common::splats(5, 110_000, 0).to_avatar("scan").unwrap();
    let size = [400, 400];
    let options = CooperativeTiles.options(&device.probe.name, size);
    let options = RendererOptions {
        skip: options.skip - Skip::SKINNING,
        ..options
    };
    let rest = Pose::rest(avatar.skeleton.len(), avatar.inputs.expression);
    let posed = Posed::new(&avatar, &rest);
    let draw = |renderer: &mut Renderer, distance: f64, frame: usize| {
        let camera = Camera::orbit(DVec3::ZERO, 0.1 * frame as f64, 0.0, distance, 0.8, size);
        renderer.draw(&posed, &camera, None).unwrap();
        renderer.finish().unwrap();
    };
    let [near, far] = [2.2, 12.0];
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    let most = device.memory().0;
    (0..3).for_each(|frame| draw(&mut renderer, far, frame));
    let few = device.memory().0;
    let capacity = avatar.gaussians.len() as u32;
    let blocks = TILING.most_blocks(capacity) - TILING.few_blocks(capacity);
    let saved = 4 * u64::from(BINNING_BLOCK) * u64::from(blocks);
    assert!(
        few < most && most - few >= saved,
        "{most} bytes, and {few} where {saved} less would do"
    );
    (0..3).for_each(|frame| draw(&mut renderer, near, frame));
    assert_eq!(device.memory().0, most);
    let image = renderer.read_image().unwrap();
    drop(renderer);
    let mut fresh = Renderer::new(&device, &avatar, options).unwrap();
    draw(&mut fresh, near, 2);
    let difference = error::between(&image, &fresh.read_image().unwrap());
    assert!(difference.covered.psnr_db > 60.0, "{difference:?}");
}

tests! {
    the_devices_memory_does_not_grow_with_frames,
    the_processs_memory_does_not_grow_with_frames: own_process,
    no_kernel_is_compiled_while_frames_run: own_process,
    the_pose_cache_takes_memory_once_it_is_used[Quads]: own_process,
    the_pose_cache_takes_memory_once_it_is_used[TestedQuads]: own_process,
    the_pose_cache_takes_memory_once_it_is_used[CooperativeTiles]: own_process,
    the_pose_cache_takes_memory_once_it_is_used[SharedTiles]: own_process,
    tile_lists_have_what_frames_ask_for: own_process,
}
