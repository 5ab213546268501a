//! Shooting a capture: every frame by every camera.

use crate::bake::Clothed;
use crate::pictures::flaws::{CameraLook, Flaws};
use crate::pictures::rig::{RigOptions, rig};
use crate::pictures::scene::{BodyPart, Studio};
use crate::pictures::template::template;
use effigy_capture::{
    CaptureCamera, CaptureError, CaptureFrame, CaptureWriter, Truth, TruthCamera,
};
use effigy_core::random::{Random, hash};
use glam::DVec3;
use rayon::prelude::*;
use std::path::Path;

/// How a capture is shot.
#[derive(Clone, Debug)]
pub struct PictureOptions {
    /// Number of cameras that see all of the person, at least 1.
    pub cameras: usize,
    /// Number of cameras besides that see head and chest alone, from as near as that allows.
    pub close: usize,
    /// Width and height of the pictures, px.
    pub size: [u32; 2],
    /// Rays a pixel along each side, at least 1.
    pub samples: u32,
    /// Rays traced per vertex for its light.
    pub rays: usize,
    /// What is off.
    pub flaws: Flaws,
    /// Of all random numbers.
    pub seed: u64,
}

/// What was shot.
#[derive(Clone, Copy, Debug, Default)]
pub struct Summary {
    /// Pictures written.
    pub pictures: usize,
    /// The share of their pixels that is the person.
    pub covered: f64,
    /// Held-out cameras.
    pub held: usize,
}

/// Shoots a person in the frames' poses, which are true, into a folder. `frames`: by number, from
/// 0 on. `progress` is called after each frame.
///
/// # Errors
/// When a file can't be written.
pub fn shoot(
    folder: &Path,
    clothed: Clothed,
    frames: &[CaptureFrame],
    options: &PictureOptions,
    progress: &dyn Fn(),
) -> Result<Summary, CaptureError> {
    let PictureOptions { flaws, seed, .. } = *options;
    let mut template = template(&clothed.body);
    template.skeleton = flaws.fitted(&template.skeleton, seed);
    let studio = Studio::new(clothed, options.rays);
    let around = |part: BodyPart, first: usize, cameras: usize| {
        let points: Vec<DVec3> = frames
            .par_iter()
            .flat_map_iter(|frame| studio.outline(&frame.pose, part))
            .collect();
        let rings = RigOptions {
            first,
            cameras,
            size: options.size,
            seed,
        };
        rig(&points, &rings)
    };
    let mut cameras = around(BodyPart::Whole, 0, options.cameras);
    cameras.extend(around(
        BodyPart::HeadAndChest,
        options.cameras,
        options.close,
    ));
    let calibrated: Vec<CaptureCamera> = (0..cameras.len())
        .map(|at| flaws.calibrated(&cameras[at], at, seed))
        .collect();
    let looks: Vec<CameraLook> = (0..cameras.len()).map(|at| flaws.look(at, seed)).collect();
    let writer = CaptureWriter::new(folder, &calibrated, &template)?;
    let mut covered = 0.0;
    for frame in frames {
        let scene = studio.scene(&frame.pose);
        let shoot = |at: usize| {
            let stream = hash(seed ^ hash(u64::from(frame.number) << 16 | at as u64));
            let mut image = scene.picture(&cameras[at].camera, options.samples, stream);
            let share = image.coverage.iter().map(|&c| f64::from(c)).sum::<f64>();
            let share = share / image.coverage.len().max(1) as f64;
            flaws.shoot(&mut image, &looks[at], stream);
            let mut random = Random::new(stream, 0x401);
            let noise = flaws.noise / 255.0;
            let picture = image.encode(|| match noise {
                0.0 => 0.0,
                _ => noise * random.normal(),
            });
            writer.write(at, frame.number, &picture)?;
            Ok(share)
        };
        let shares = (0..cameras.len()).into_par_iter().map(shoot);
        let shares: Vec<f64> = shares.collect::<Result<_, CaptureError>>()?;
        covered += shares.iter().sum::<f64>();
        progress();
    }
    let found: Vec<CaptureFrame> = frames
        .iter()
        .enumerate()
        .map(|(at, frame)| CaptureFrame {
            pose: flaws.tracked(&frame.pose, at, seed),
            ..frame.clone()
        })
        .collect();
    let pictures = frames.len() * cameras.len();
    let held = cameras.iter().filter(|camera| camera.held).count();
    write_truth(folder, cameras, &looks, frames, &flaws)?;
    writer.finish(&found)?;
    Ok(Summary {
        pictures,
        covered: covered / pictures.max(1) as f64,
        held,
    })
}

/// Writes what is true of the pictures, where the capture says something else.
fn write_truth(
    folder: &Path,
    cameras: Vec<CaptureCamera>,
    looks: &[CameraLook],
    frames: &[CaptureFrame],
    flaws: &Flaws,
) -> Result<(), CaptureError> {
    if flaws.is_none() {
        return Truth::remove(folder);
    }
    let own = cameras.into_iter().zip(looks);
    let truth = Truth {
        cameras: own
            .map(|(camera, look)| TruthCamera {
                camera,
                gain: look.gain.to_array(),
                blur: look.blur,
            })
            .collect(),
        poses: frames.iter().map(|frame| frame.pose.clone()).collect(),
    };
    truth.write(folder)
}
