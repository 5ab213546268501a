//! A device for tests, and frames drawn with it.

use super::{Sizes, avatar, pose};
use effigy::{
    avatar::Avatar,
    frame::{Camera, Detail, Extent, Method, Posed, options::draws_triangles},
    reference,
    vulkan::{Gpu, GpuOptions, Renderer, RendererOptions, commands::FrameReport, instance::validation_messages, renderer::Stages},
};
use std::sync::Arc;

/// The device that the environment chooses. Without any, tests pass by default with a printed reason, and fail where
/// `EFFIGY_REQUIRE_GPU` is set, as CI does.
pub fn gpu() -> Option<Arc<Gpu>> {
    open(GpuOptions::headless(None))
}

/// The same where that device draws triangles, and their tests are for it.
pub fn drawing() -> Option<Arc<Gpu>> {
    gpu().filter(|gpu| {
        if !gpu.probe.draws_triangles() {
            println!("skipped: {} does not survive drawing triangles", gpu.probe.name);
        }
        gpu.probe.draws_triangles()
    })
}

/// The ways to draw that are for a device.
pub fn methods(device: &str) -> Vec<Method> {
    if draws_triangles(device) {
        return Method::ALL.to_vec();
    }
    println!("skipped in part: {device} does not survive drawing triangles");
    vec![Method::Tiles]
}

/// Options for each of those ways.
pub fn each_way(device: &str, size: [u32; 2]) -> Vec<RendererOptions> {
    methods(device).into_iter().map(|method| RendererOptions { method: Some(method), ..options(size) }).collect()
}

pub fn open(options: GpuOptions) -> Option<Arc<Gpu>> {
    match Gpu::new(&options) {
        Ok(gpu) => Some(gpu),
        Err(error) if std::env::var_os("EFFIGY_REQUIRE_GPU").is_some() => panic!("a device is required: {error}"),
        Err(error) => {
            println!("skipped: {error}");
            None
        }
    }
}

/// One frame on the device and in the reference.
pub struct Frame {
    /// As the device has it: its oracle starts from the same numbers, but for the nodes' weights.
    pub avatar: Avatar,
    pub posed: Posed,
    pub camera: Camera,
    pub gpu: Stages,
    pub report: FrameReport,
    pub picture: effigy::frame::Picture,
    /// Of every 2^`level`-th Gaussian.
    pub oracle: reference::Stages,
    pub level: u32,
}

/// Sees a whole posed avatar from the front left.
pub fn camera(avatar: &Avatar, posed: &Posed, size: [u32; 2]) -> Camera {
    let [min, max] = Extent::new(avatar).bounds(&posed.joints);
    Camera::orbit((min + max) / 2.0, 0.5, 0.1, 1.3 * (max - min).length(), 0.7, size)
}

/// Draws a seeded avatar in a seeded pose.
pub fn frame(gpu: &Arc<Gpu>, seed: u64, sizes: Sizes, options: RendererOptions) -> Frame {
    frame_of(gpu, avatar(seed, sizes), seed, options)
}

/// Draws an avatar in a seeded pose.
pub fn frame_of(gpu: &Arc<Gpu>, avatar: Avatar, seed: u64, options: RendererOptions) -> Frame {
    let posed = Posed::new(&avatar, &pose(seed + 1, &avatar));
    let camera = camera(&avatar, &posed, options.size);
    draw(gpu, avatar, posed, camera, options)
}

/// Draws any frame.
pub fn draw(gpu: &Arc<Gpu>, avatar: Avatar, posed: Posed, camera: Camera, options: RendererOptions) -> Frame {
    draw_after(gpu, avatar, posed, &[], camera, options)
}

/// Draws any frame after those of some other cameras.
pub fn draw_after(gpu: &Arc<Gpu>, avatar: Avatar, posed: Posed, before: &[Camera], camera: Camera, options: RendererOptions) -> Frame {
    let mut renderer = Renderer::new(gpu, &avatar, options).unwrap();
    before.iter().chain([&camera]).for_each(|camera| renderer.draw(&posed, camera, None).unwrap());
    let picture = renderer.picture().unwrap();
    let stages = renderer.stages().unwrap();
    let avatar = avatar.compact();
    let level = options.detail.least;
    let oracle = reference::Stages::thinned(&avatar, &posed, &camera, level);
    Frame { report: renderer.report().clone(), gpu: stages, picture, oracle, level, avatar, posed, camera }
}

pub fn options(size: [u32; 2]) -> RendererOptions {
    RendererOptions::new(size)
}

/// The same at a level of detail.
pub fn at_level(options: RendererOptions, level: u32) -> RendererOptions {
    RendererOptions { detail: Detail::FULL.at_least(level), ..options }
}

/// To be called at the end of every test that uses a device.
pub fn assert_valid() {
    assert_eq!(validation_messages(), 0, "the validation layer complained, see above");
}

/// Compares two arrays, and names the worst element where one is further off than allowed.
pub fn assert_close(what: &str, got: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(got.len(), expected.len(), "{what}: lengths differ");
    let error = |k: usize| (got[k] - expected[k]).abs();
    let Some(worst) = (0..got.len()).max_by(|&a, &b| error(a).total_cmp(&error(b))) else { return };
    assert!(
        error(worst) <= tolerance,
        "{what}: element {worst} of {} is {}, expected {}, which is {} off; {tolerance} is allowed",
        got.len(),
        got[worst],
        expected[worst],
        error(worst)
    );
}
