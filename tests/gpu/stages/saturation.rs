//! The `saturation` stage: the depth behind which nothing shows, against the reference.

use crate::common::{
    self,
    gpu::{
        self,
        Raster::{self, Quads, TestedQuads},
    },
};
use effigy_core::{
    avatar::{Avatar, Pose, motion::Player},
    constants::{ALPHA_MIN, saturation_light},
    frame::{DEPTH_KEYS, Skip},
    io::splats::Splats,
    reference::{ReferenceFrame, saturation},
    scene::{Camera, Posed, Supersampling},
};
use effigy_measure::error;
use effigy_render::vulkan::{Renderer, RendererOptions, raster::RasterMethod};
use glam::{DAffine3, DVec2};

/// A frame of which a device found the saturation depths.
pub struct Sampled<'a> {
    pub avatar: &'a Avatar,
    pub posed: &'a Posed,
    pub camera: Camera,
    /// The word of each sample, row by row.
    pub found: Vec<u32>,
    /// What the depths come from: the key of each splat, and the drawing order.
    pub keys: &'a [u32],
    pub order: &'a [u32],
}

impl Sampled<'_> {
    /// Each sample must have the depth of the splat with which the reference's is saturated. The
    /// device's opacities are rounded, so that is asked for with thresholds a little above and
    /// below.
    pub fn check(self) {
        let reference = ReferenceFrame::new(self.avatar, self.posed, &self.camera);
        let depth = |splat: Option<u32>| {
            splat.map_or(65535.0, |splat| {
                let key = f64::from(self.keys[splat as usize]);
                let depth = 1.0 - key / f64::from(DEPTH_KEYS.largest());
                ((65535.0 * depth).round() + 1.0).min(65535.0)
            })
        };
        let threshold = saturation_light(ALPHA_MIN);
        let [nearest, furthest] = [1.1, 1.0 / 1.1].map(|factor| {
            let threshold = factor * threshold;
            saturation::saturating(&reference.splats, self.order, &self.camera, threshold)
        });
        assert_eq!(self.found.len(), nearest.len());
        let mut saturated = 0;
        let mut wrong = Vec::new();
        for (at, &found) in self.found.iter().enumerate() {
            let [low, high] = [nearest[at], furthest[at]].map(depth);
            // Of halves either may be rounded up.
            if !(low - 1.0..=high + 1.0).contains(&f64::from(found >> 16)) {
                wrong.push((at, found, low, high));
            }
            saturated += usize::from(high < 65535.0);
        }
        // Where a splat of 1/255 or little more counts for one and not the other, a sample may be
        // saturated by a neighbour in the order.
        assert!(
            wrong.len() * 1000 <= saturated && saturated > 1000,
            "{} of {saturated} samples differ: {:?}",
            wrong.len(),
            &wrong[..wrong.len().min(4)]
        );
    }
}

/// The demo in two poses, and options with which each frame finds the saturation depth.
pub fn sampled_frames() -> (
    Avatar,
    impl Iterator<Item = (Posed, Camera, RendererOptions)>,
) {
    let avatar = effigy_demo::avatar().unwrap();
    let player = Player::new(effigy_demo::clip().unwrap(), &avatar.skeleton);
    let frames = [(0.5, 0.3, [861, 1363]), (2.0, 3.4, [960, 1520])];
    let frames = frames.map(|(seconds, yaw, size)| {
        let posed = Posed::new(&avatar, &player.pose(seconds));
        let camera = gpu::around(&avatar, &posed, yaw, size);
        let options = RendererOptions {
            skip: Skip::DEPTH | Skip::FAINT,
            method: Some(RasterMethod::Quads),
            ..gpu::options(size)
        };
        (posed, camera, options)
    });
    (avatar, frames.into_iter())
}

fn samples_are_saturated_where_the_references_are() {
    let device = gpu::drawing();
    let (avatar, frames) = sampled_frames();
    for (posed, camera, options) in frames {
        let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
        renderer.draw(&posed, &camera, None).unwrap();
        renderer.finish().unwrap();
        let found = renderer.raster().saturation_samples().unwrap().unwrap();
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

/// Upright needles, opaque and far thinner than a pixel, at every column of samples, and a white
/// wall behind them that shows between. `layers`: needles one behind the other.
fn fence(layers: usize) -> Splats {
    const SIDE: usize = 64;
    let mut splats = common::splats(1, 0, 0);
    // `place`: px from the image's middle, and metres away; `scale`: px.
    let mut push = |[x, y, depth]: [f64; 3], scale: [f64; 3], color: f32| {
        let metres = depth / SIDE as f64;
        let place = [x * metres, y * metres, depth];
        splats.position.push(place.map(|v| v as f32));
        splats.rotation.push([1.0, 0.0, 0.0, 0.0]);
        splats
            .log_scale
            .push(scale.map(|px| (px * metres).ln() as f32));
        splats.opacity.push(9.0);
        splats.color.push([color; 3]);
    };
    for column in 0..SIDE / 2 {
        let x = 2.0 * column as f64 + 1.0 - SIDE as f64 / 2.0;
        // Not all at one height: the box around their centres has an area.
        let y = if column % 2 == 0 { -8.0 } else { 8.0 };
        for layer in 0..layers {
            push([x, y, 1.0 + 1e-3 * layer as f64], [0.05, 80.0, 0.05], -1.7);
        }
    }
    push([0.0, 0.0, 1.5], [300.0, 300.0, 0.05], 1.7);
    splats
}

/// What shows between samples is drawn, however thin, unless it is less than the threshold.
fn gaps_between_samples_are_not_covered() {
    let device = gpu::gpu();
    let size = [64, 64];
    let camera = Camera {
        view: DAffine3::IDENTITY,
        focal: DVec2::splat(64.0),
        center: DVec2::splat(32.0),
        size,
        near: 0.1,
    };
    // A needle lets a third of the wall through half a pixel beside it, three of them a thirtieth.
    for (layers, shows, lost) in [(1, 0.25..0.45, 0.0..0.01), (3, 0.03..0.07, 0.01..0.05)] {
        let avatar = fence(layers).to_avatar("fence").unwrap();
        let rest = Pose::rest(avatar.skeleton.len(), avatar.inputs.expression);
        let posed = Posed::new(&avatar, &rest);
        let image = |raster: Raster| {
            let options = RendererOptions {
                supersampling: Supersampling::OFF,
                exact: true,
                ..raster.options(&device.probe.name, size)
            };
            let mut renderer = Renderer::new(&device, &avatar, options).unwrap();
            renderer.draw(&posed, &camera, None).unwrap();
            renderer.read_image().unwrap()
        };
        let [whole, tested] = [Quads, TestedQuads].map(image);
        let middle = f64::from(whole.pixels[32 * 64 + 32][0]);
        assert!(
            shows.contains(&middle),
            "{middle} of the wall shows behind {layers}"
        );
        let off = error::between(&tested, &whole).whole.max_error;
        assert!(
            lost.contains(&off),
            "{off} of the wall is lost behind {layers}"
        );
    }
}

tests! {
    gaps_between_samples_are_not_covered,
    samples_are_saturated_where_the_references_are,
}
