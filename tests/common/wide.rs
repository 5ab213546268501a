//! A subject before a backdrop of few, wide Gaussians, as trained scenes have them: from some focal
//! length on, all centres of the backdrop are outside the image that it fills.

use super::plain;
use effigy_core::{
    avatar::{Avatar, Filter, Pose},
    io::splats::{Splats, Up},
    reference::{self, Gaussian},
    scene::{Camera, FrameImage, Posed},
};
use effigy_measure::error;
use glam::DVec3;

/// Focal lengths, heights of the image.
pub const FOCAL: [f64; 6] = [0.8, 1.6, 3.2, 6.4, 12.8, 100.0];

/// A camera whose focal length is so many heights of its image.
pub fn camera(focal: f64) -> Camera {
    let fov = 2.0 * (0.5 / focal).atan();
    let mut camera = Camera::look_at(DVec3::new(0.0, 0.0, 2.2), DVec3::ZERO, fov, [96, 96]);
    camera.near = 0.1;
    camera
}

/// The scene as splats.
pub fn splats() -> Splats {
    let mut splats = Splats {
        position: vec![],
        rotation: vec![],
        log_scale: vec![],
        opacity: vec![],
        color: vec![],
        degree: 0,
        harmonics: vec![],
        up: Up::Y,
        filter: Filter::DEFAULT,
    };
    let mut add = |position: [f32; 3], deviation: f32, color: [f32; 3]| {
        splats.position.push(position);
        splats.rotation.push([1.0, 0.0, 0.0, 0.0]);
        splats.log_scale.push([deviation.ln(); 3]);
        splats.opacity.push(2.2);
        splats.color.push(color);
    };
    for k in 0..60 {
        let [turn, rise] = [2.4 * k as f32, k as f32 / 30.0 - 1.0];
        let around = 0.3 * (1.0 - rise * rise).sqrt();
        let at = [around * turn.cos(), 0.3 * rise, around * turn.sin()];
        add(at, 0.02, [rise, -rise, 0.5]);
    }
    for k in 0..9 {
        let [x, y] = [[-3.2, 0.9, 3.1][k % 3], [-2.9, 0.8, 2.8][k / 3]];
        let shade = k as f32 / 8.0 - 0.5;
        add([x, y, -4.0 - 0.13 * k as f32], 2.2, [shade, 0.3, -shade]);
    }
    splats
}

/// The scene as an avatar, and where it stands.
pub fn avatar() -> (Avatar, Posed) {
    let avatar = splats().to_avatar("wide").expect("sound splats");
    let posed = Posed::new(&avatar, &Pose::rest(avatar.skeleton.len(), 0));
    (avatar, posed)
}

/// The scene's Gaussians in the posed world.
pub fn gaussians() -> Vec<Gaussian> {
    let (avatar, posed) = avatar();
    reference::gaussians_of(&avatar, &[&posed], &camera(1.0))
}

/// Holds images of the scene by 3DGS' own rules at every focal length, each drawn twice: from the
/// Gaussians or from the pose cache.
pub fn check(mut draw: impl FnMut(&Camera) -> FrameImage) {
    let gaussians = gaussians();
    for focal in FOCAL {
        let camera = camera(focal);
        let expected = plain::render(&gaussians, &camera, Filter::DEFAULT.variance);
        for _ in 0..2 {
            let error = error::between(&draw(&camera), &expected).covered;
            println!("at {focal}: {error:?}");
            assert!(error.psnr_db > 48.0, "at {focal}: {error:?}");
        }
    }
}
