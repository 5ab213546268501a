//! Tests of the times that frames report, against the host's clock. A CPU driver does all of its
//! work between submission and fence, so there the stages must add up to that time.

use crate::common::{gpu, harness::not_run};
use effigy_core::{
    avatar::{Avatar, motion::Player},
    frame::Skip,
    scene::{Camera, Posed},
};
use effigy_render::vulkan::{
    Renderer, RendererOptions,
    raster::RasterMethod::{self, CooperativeTiles, Quads, SharedTiles},
};
use std::time::{Duration, Instant};

/// Least part of the wall time that the stages of some frame must explain. What is missing is the
/// copy of the counts, and the time that the driver's and this thread take to wake up.
const LEAST_OF_WALL: f64 = 0.9;
/// That part on WebGPU, where the wall time has the recording of the frame in it.
const LEAST_OF_WALL_RECORDED: f64 = 0.75;
/// Most of the wall time that the stages of any frame may add up to.
const MOST_OF_WALL: f64 = 1.01;
/// Least part of a frame's sum that the projection of all Gaussians takes on these drivers. Beside
/// quads it is 0.024 to 0.047 on busy cores; booked to another stage it was 0.0002.
const LEAST_OF_PROJECT: f64 = 0.01;
const FRAMES: usize = 6;
const SIZE: [u32; 2] = [640, 640];

tests! {
    stages_add_up_to_the_frame[Quads],
    stages_add_up_to_the_frame[CooperativeTiles],
    stages_add_up_where_nothing_is_skipped,
    #[cfg(feature = "webgpu")]
    stages_add_up_on_webgpu[Quads],
    #[cfg(feature = "webgpu")]
    stages_add_up_on_webgpu[SharedTiles],
}

/// The demo in motion: a pose, and a camera around it.
fn frames(avatar: &Avatar) -> Vec<(Posed, Camera)> {
    let player = Player::new(effigy_demo::clip().unwrap(), &avatar.skeleton);
    (0..FRAMES)
        .map(|frame| {
            let posed = Posed::new(avatar, &player.pose(0.4 * frame as f64));
            let camera = gpu::around(avatar, &posed, 0.3, SIZE);
            (posed, camera)
        })
        .collect()
}

/// A frame's stages, ms, and the time that they should add up to.
struct Timed {
    stages: Vec<(&'static str, f64)>,
    wall: Duration,
}

fn assert_adds_up(frames: &[Timed], least: f64) {
    let mut best: f64 = 0.0;
    for Timed { stages, wall } in frames {
        let sum: f64 = stages.iter().map(|(_, ms)| ms).sum();
        let of_wall = sum / (1e3 * wall.as_secs_f64());
        assert!(
            of_wall <= MOST_OF_WALL,
            "{stages:?} add up to {of_wall:.3} of {wall:?}"
        );
        best = best.max(of_wall);
    }
    assert!(
        best >= least,
        "the stages explain no more than {best:.3} of any frame"
    );
}

/// No stage's time is booked to another. WebGPU's barriers stand where wgpu puts them, so on
/// llvmpipe a border there may lie a stage late, and only the sum is right.
fn assert_projection_is_timed(frames: &[Timed]) {
    for Timed { stages, .. } in frames {
        let sum: f64 = stages.iter().map(|(_, ms)| ms).sum();
        let project = stages.iter().find(|(name, _)| *name == "project");
        let (_, project) = project.expect("a stage that every frame runs");
        assert!(
            *project >= LEAST_OF_PROJECT * sum,
            "the projection takes next to nothing: {stages:?}"
        );
    }
}

fn adds_up(method: RasterMethod, skip: Skip) {
    let device = gpu::gpu();
    if device.probe.timestamp_bits == 0 {
        not_run("no timestamps");
    }
    if !device.probe.is_cpu() {
        not_run("a GPU's work can't be told from the wait for it");
    }
    let avatar = effigy_demo::avatar().unwrap();
    let options = RendererOptions {
        skip,
        ..gpu::with_method(&device.probe.name, method, SIZE)
    };
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    let timed: Vec<Timed> = frames(&avatar)
        .iter()
        .map(|(posed, camera)| {
            renderer.draw(posed, camera, None).unwrap();
            renderer.finish().unwrap();
            let report = renderer.report();
            let host = report.host.expect("the frame was submitted");
            Timed {
                stages: report.stages.clone(),
                wall: host.finished - host.recorded,
            }
        })
        .collect();
    assert_adds_up(&timed, LEAST_OF_WALL);
    assert_projection_is_timed(&timed);
}

/// Drivers defer timestamps for render passes: quads have two, that of the saturation depth and
/// their own.
fn stages_add_up_to_the_frame(method: RasterMethod) {
    adds_up(method, Skip::all());
}

fn stages_add_up_where_nothing_is_skipped() {
    adds_up(CooperativeTiles, Skip::empty());
}

#[cfg(feature = "webgpu")]
fn stages_add_up_on_webgpu(method: RasterMethod) {
    use effigy_render::webgpu::{Gpu, Renderer};

    let device = Gpu::open(None).unwrap();
    if !device.timestamps {
        not_run("no timestamps");
    }
    if !device.is_cpu() {
        not_run("a GPU's work can't be told from the wait for it");
    }
    let avatar = effigy_demo::avatar().unwrap();
    let options = gpu::with_method(device.name(), method, SIZE);
    let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
    let timed: Vec<Timed> = frames(&avatar)
        .iter()
        .map(|(posed, camera)| {
            let began = Instant::now();
            renderer.draw(posed, camera).unwrap();
            renderer.finish().unwrap();
            Timed {
                stages: renderer.report().stages.clone(),
                wall: began.elapsed(),
            }
        })
        .collect();
    assert_adds_up(&timed, LEAST_OF_WALL_RECORDED);
}
