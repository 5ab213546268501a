//! Hundreds of frames of new poses at changing sizes, cutoffs and levels hold the memory that the
//! first ones took.

use crate::common::{self, Sizes, gpu, harness::not_run};
use effigy::vulkan::{Gpu, Renderer};
use effigy_core::{
    constants::ALPHA_MIN,
    scene::{Detail, Posed},
};
use effigy_measure::soak::memory::resident_bytes;

/// What `read` gives after a warm-up, and after 800 more frames.
fn before_and_after<T>(device: &std::sync::Arc<Gpu>, read: impl Fn() -> T) -> [T; 2] {
    let avatar = common::avatar(
        11,
        Sizes {
            gaussians: 1000,
            ..Sizes::default()
        },
    );
    let size = [96, 120];
    let mut renderer = Renderer::new(device, &avatar, gpu::options(size)).unwrap();
    let poses: Vec<_> = (0..20)
        .map(|seed| Posed::new(&avatar, &common::pose(seed, &avatar)))
        .collect();
    let camera = gpu::camera(&avatar, &poses[0], size);
    let mut draw = |frames: usize| {
        for frame in 0..frames {
            let part = if frame / 50 % 2 == 0 { size } else { [48, 60] };
            let odd = frame / 100 % 2 == 1;
            let cutoff = if odd { 2.0 * ALPHA_MIN } else { ALPHA_MIN };
            let detail = Detail::FULL.at_least(u32::from(odd));
            renderer.adjust(part, cutoff, detail).unwrap();
            renderer
                .draw(&poses[frame % poses.len()], &camera.stretched(part), None)
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

fn the_processs_memory_does_not_grow_with_frames() {
    let device = gpu::gpu();
    if device.probe.driver.contains("Mesa 22.") {
        not_run(
            "with Mesa 22.3's lavapipe the process gains 0.7 MB a frame, with every way to draw; \
             no later driver does that",
        );
    }
    let [Some(before), Some(after)] = before_and_after(&device, resident_bytes) else {
        not_run("this system does not tell a process's memory")
    };
    let gained = after as i64 - before as i64;
    assert!(
        gained < 8 << 20,
        "the process gained {gained} bytes in 800 frames"
    );
}

tests! {
    the_devices_memory_does_not_grow_with_frames,
    the_processs_memory_does_not_grow_with_frames: own_process,
}
