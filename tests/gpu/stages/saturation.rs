//! The `saturation` stage: the depth behind which nothing shows, against the reference.

use crate::common::gpu;
use effigy::vulkan::{
    Renderer, RendererOptions,
    raster::RasterMethod,
    sort::KeyBits::{self, Sixteen, ThirtyTwo},
};
use effigy_core::{
    avatar::{Avatar, motion::Player},
    constants::{ALPHA_MIN, saturation_light},
    frame::Skip,
    reference::{ReferenceFrame, saturation},
    scene::{AvatarBounds, Camera, Posed},
};

/// A frame of which a device found the saturation depths.
pub struct Sampled<'a> {
    pub avatar: &'a Avatar,
    pub posed: &'a Posed,
    pub camera: Camera,
    /// The word of each sample, row by row.
    pub found: Vec<u32>,
    /// What the depths come from: the key of each splat, of so many bits, and the drawing order.
    pub keys: &'a [u32],
    pub key_bits: KeyBits,
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
                let depth = 1.0 - key / f64::from(self.key_bits.largest());
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
pub fn sampled_frames(
    key_bits: KeyBits,
) -> (
    Avatar,
    impl Iterator<Item = (Posed, Camera, RendererOptions)>,
) {
    let avatar = effigy_demo::avatar().unwrap();
    let player = Player::new(effigy_demo::clip().unwrap(), &avatar.skeleton);
    let frames = [(0.5, 0.3, [861, 1363]), (2.0, 3.4, [960, 1520])];
    let frames = frames.map(|(seconds, yaw, size)| {
        let posed = Posed::new(&avatar, &player.pose(seconds));
        let bounds = AvatarBounds::new(&avatar).bounds(&posed.joints);
        let camera = Camera::around(bounds, yaw, 0.1, 0.6, size);
        let options = RendererOptions {
            skip: Skip::DEPTH | Skip::FAINT,
            method: Some(RasterMethod::Quads),
            key_bits: Some(key_bits),
            ..gpu::options(size)
        };
        (posed, camera, options)
    });
    (avatar, frames.into_iter())
}

fn samples_are_saturated_where_the_references_are(key_bits: KeyBits) {
    let device = gpu::drawing();
    let (avatar, frames) = sampled_frames(key_bits);
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
            key_bits,
            order: &stages.order,
        };
        sampled.check();
    }
}

tests! {
    samples_are_saturated_where_the_references_are[Sixteen],
    samples_are_saturated_where_the_references_are[ThirtyTwo],
}
