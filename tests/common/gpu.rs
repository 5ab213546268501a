//! A device for tests, and frames drawn with it.

use super::{
    Sizes, avatar,
    harness::{self, not_run},
    pose,
};
use effigy_core::{
    avatar::Avatar,
    frame::{RasterMethod, Skip},
    reference,
    scene::{AvatarBounds, Camera, Detail, Orbit, Posed, Supersampling},
};
use effigy_render::{
    quirks::draws_triangles,
    vulkan::{Error, FrameReport, Gpu, GpuOptions, Renderer, RendererOptions, Stages},
};
use std::{
    cell::LazyCell,
    sync::{Arc, Mutex, PoisonError},
};

/// Devices that tests of this process share, by their options.
static SHARED: Mutex<Vec<(String, Arc<Gpu>)>> = Mutex::new(vec![]);

/// Options for the device that the environment chooses, with the program's cache.
pub fn headless() -> GpuOptions {
    effigy_runtime::cache::headless(None)
}

/// The device that the environment chooses, opened once a process.
pub fn gpu() -> Arc<Gpu> {
    open(headless())
}

/// That device, for a test that draws triangles, or compares small avatars: a device that draws
/// none draws them as large as they are shown.
pub fn drawing() -> Arc<Gpu> {
    let device = gpu();
    if !device.probe.draws_triangles() {
        not_run(format!(
            "{} does not survive drawing triangles",
            device.probe.name
        ));
    }
    device
}

/// The ways to draw an image that tests try.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Raster {
    /// Quads, all fragments of which are blended.
    Quads,
    /// Quads that are tested against the saturation depth.
    TestedQuads,
    /// Tiles as desktop GPUs draw them.
    SharedTiles,
    /// Tiles as CPU drivers draw them.
    CooperativeTiles,
}

impl Raster {
    /// Options for it on a device. Ends the test where the device is not for it.
    pub fn options(self, device: &str, size: [u32; 2]) -> RendererOptions {
        let method = match self {
            Self::Quads | Self::TestedQuads => RasterMethod::Quads,
            Self::SharedTiles => RasterMethod::SharedTiles,
            Self::CooperativeTiles => RasterMethod::CooperativeTiles,
        };
        let options = with_method(device, method, size);
        match self {
            Self::Quads => RendererOptions {
                skip: options.skip - Skip::DEPTH,
                ..options
            },
            Self::TestedQuads => RendererOptions {
                skip: options.skip | Skip::DEPTH,
                ..options
            },
            Self::SharedTiles | Self::CooperativeTiles => options,
        }
    }
}

/// Options for a method on a device. Ends the test where the device is not for that method.
pub fn with_method(device: &str, method: RasterMethod, size: [u32; 2]) -> RendererOptions {
    require_method(device, method);
    RendererOptions {
        method: Some(method),
        ..options(size)
    }
}

/// Ends the test where the device is not for the method.
pub fn require_method(device: &str, method: RasterMethod) {
    if method == RasterMethod::Quads && !draws_triangles(device) {
        not_run(format!("{device} does not survive drawing triangles"));
    }
    // WebGPU never has it.
    if method == RasterMethod::CooperativeTiles
        && let Some(missing) = gpu().probe.lacks_for(method)
    {
        not_run(format!("{device} does not have what is needed {missing}"));
    }
}

/// A device with these options, opened once a process. Ends the test where it can draw by no method.
pub fn open(options: GpuOptions) -> Arc<Gpu> {
    harness::assert_device_allowed();
    let gpu = shared(&options).unwrap_or_else(|error| panic!("a Vulkan device is needed: {error}"));
    if RasterMethod::ALL
        .iter()
        .all(|method| gpu.probe.lacks_for(*method).is_some())
    {
        not_run(format!("{} can draw by no method so", gpu.probe.name));
    }
    gpu
}

fn shared(options: &GpuOptions) -> Result<Arc<Gpu>, Error> {
    let key = format!("{options:?}");
    let mut shared = SHARED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, gpu)) = shared.iter().find(|(other, _)| *other == key) {
        return Ok(gpu.clone());
    }
    let gpu = Gpu::new(options)?;
    shared.push((key, gpu.clone()));
    Ok(gpu)
}

/// Opens the device that most tests use.
pub fn try_open() -> Result<(), Error> {
    shared(&headless()).map(drop)
}

/// Destroys the shared devices.
pub fn close() {
    SHARED
        .lock()
        .unwrap_or_else(PoisonError::into_inner)
        .clear();
}

/// One frame on the device and in the reference.
pub struct Frame {
    /// What the device was given, with the filter that it drew with: the reference starts from the
    /// same numbers, but for the nodes' weights.
    pub avatar: Avatar,
    pub posed: Posed,
    pub camera: Camera,
    pub gpu: Stages,
    pub report: FrameReport,
    pub image: effigy_core::scene::FrameImage,
    /// Of every 2^`level`-th Gaussian; worked out when it is first looked at.
    pub reference:
        LazyCell<reference::ReferenceFrame, Box<dyn FnOnce() -> reference::ReferenceFrame>>,
    pub level: u32,
}

/// Sees a whole posed avatar from the front left.
pub fn camera(avatar: &Avatar, posed: &Posed, size: [u32; 2]) -> Camera {
    let [min, max] = AvatarBounds::new(avatar).bounds(&posed.joints);
    Camera::orbit(
        (min + max) / 2.0,
        0.5,
        0.1,
        // A splat alone has no extent.
        1.3 * (max - min).length().max(0.15),
        0.7,
        size,
    )
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
pub fn draw(
    gpu: &Arc<Gpu>,
    avatar: Avatar,
    posed: Posed,
    camera: Camera,
    options: RendererOptions,
) -> Frame {
    draw_after(gpu, avatar, posed, &[], camera, options)
}

/// Draws any frame after those of some other cameras.
pub fn draw_after(
    gpu: &Arc<Gpu>,
    avatar: Avatar,
    posed: Posed,
    before: &[Camera],
    camera: Camera,
    options: RendererOptions,
) -> Frame {
    let mut renderer = Renderer::new(gpu, &avatar, options).unwrap();
    before
        .iter()
        .chain([&camera])
        .for_each(|camera| renderer.draw(&posed, camera, None).unwrap());
    let image = renderer.read_image().unwrap();
    let stages = renderer.stages().unwrap();
    let mut avatar = avatar.compact();
    avatar.filter = options.filter.unwrap_or(avatar.filter);
    let level = options.detail.finest;
    let (held, pose) = (avatar.clone(), posed.clone());
    let reference = LazyCell::new(Box::new(move || {
        reference::ReferenceFrame::at_level(&held, &pose, &camera, level)
    }) as Box<dyn FnOnce() -> _>);
    Frame {
        report: renderer.report().clone(),
        gpu: stages,
        image,
        reference,
        level,
        avatar,
        posed,
        camera,
    }
}

/// A camera turned by `yaw` that has all of an avatar in its image.
pub fn around(avatar: &Avatar, posed: &Posed, yaw: f64, size: [u32; 2]) -> Camera {
    let bounds = AvatarBounds::new(avatar).bounds(&posed.joints);
    let orbit = Orbit {
        yaw,
        pitch: 0.1,
        fov: 0.6,
    };
    Camera::around(bounds, orbit, size)
}

/// The defaults, but everything is drawn as large as it is shown, as the reference draws it.
pub fn options(size: [u32; 2]) -> RendererOptions {
    RendererOptions {
        supersampling: Supersampling::OFF,
        ..RendererOptions::new(size)
    }
}

/// The same at a level of detail.
pub fn at_level(options: RendererOptions, level: u32) -> RendererOptions {
    RendererOptions {
        detail: Detail::FULL.at_least(level),
        ..options
    }
}

/// Compares two arrays, and names the worst element where one is further off than allowed.
pub fn assert_close(what: &str, got: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(got.len(), expected.len(), "{what}: lengths differ");
    let error = |k: usize| (got[k] - expected[k]).abs();
    let Some(worst) = (0..got.len()).max_by(|&a, &b| error(a).total_cmp(&error(b))) else {
        return;
    };
    assert!(
        error(worst) <= tolerance,
        "{what}: element {worst} of {} is {}, expected {}, which is {} off; {tolerance} is allowed",
        got.len(),
        got[worst],
        expected[worst],
        error(worst)
    );
}
