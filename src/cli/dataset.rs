//! `effigy dataset`: shoots a capture of the baked body in the frames of some clips.

use crate::{
    bake::AssetArgs,
    options::{self, count},
    output::{self, OutputFolder},
    progress,
};
use anyhow::ensure;
use effigy_capture::CaptureFrame;
use effigy_core::{
    avatar::{Clip, Skeleton},
    random::Random,
};
use effigy_learn::{
    bake,
    pictures::{self, ClipFrame, Flaws, PictureOptions, plan_frames},
};
use std::{
    path::{Path, PathBuf},
    time::Instant,
};

/// Expression components of a pose.
const EXPRESSION: usize = 10;

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Clips of the baked body, which `effigy bake motion` makes
    #[arg(required = true)]
    motion: Vec<PathBuf>,
    /// Folder to write; by custom its name ends in .capture
    #[arg(short, long, value_name = "DIR")]
    out: OutputFolder,
    #[command(flatten)]
    assets: AssetArgs,
    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value = "1")]
    seed: u64,
    /// Frames, 2 to 100000, evenly spaced over the clips
    #[arg(long, value_name = "N", default_value = "100", value_parser = count(2, 100_000))]
    frames: usize,
    /// Length of a block, seconds; every fifth block of each clip is held out
    #[arg(long, value_name = "SECONDS", default_value = "1")]
    block: f64,
    /// Share of the training frames that get a random expression in place of the clip's, 0 to 1:
    /// clips show few expressions
    #[arg(long, value_name = "SHARE", default_value = "0", value_parser = options::share)]
    faces: f64,
    /// Rays traced per vertex for ambient lighting, 16 to 10000
    #[arg(long, value_name = "N", default_value = "192", value_parser = count(16, 10_000))]
    rays: usize,
    /// What it does anyway; version 0.1 also made data sets without pictures
    #[arg(long, hide = true)]
    pictures: bool,
    #[command(flatten)]
    shooting: Shooting,
}

/// How a capture is shot.
#[derive(clap::Args, Debug)]
#[command(next_help_heading = "Pictures")]
struct Shooting {
    /// Cameras around the person, 1 to 256
    #[arg(long, value_name = "N", default_value = "16", value_parser = count(1, 256))]
    cameras: usize,
    /// Cameras besides, as near as they can be to see head and chest alone
    #[arg(long, value_name = "N", default_value = "0", value_parser = count(0, 256))]
    close: usize,
    /// Width and height of the pictures, 16 to 4096 px
    #[arg(long, value_name = "PX", default_value = "256", value_parser = count(16, 4096))]
    size: usize,
    /// Rays along each side of a pixel, 1 to 16
    #[arg(long, value_name = "N", default_value = "2", value_parser = count(1, 16))]
    samples: usize,
    /// Make it as captures are, with errors of every kind; the options below change single ones,
    /// or add them to a capture without errors
    #[arg(long)]
    as_captured: bool,
    /// Standard deviation of the pictures' noise, of 255 [as captured: 3]
    #[arg(long, value_name = "N", value_parser = amount)]
    noise: Option<f64>,
    /// Standard deviation of the cameras' exposures, stops; a third of it of their white balance
    /// [as captured: 0.12]
    #[arg(long, value_name = "STOPS", value_parser = amount)]
    exposure: Option<f64>,
    /// Standard deviation of the cameras' blur, px [as captured: 0.6]
    #[arg(long, value_name = "PX", value_parser = amount)]
    blur: Option<f64>,
    /// How far the masks' edges are off, px [as captured: 1.5]
    #[arg(long, value_name = "PX", value_parser = amount)]
    mask_noise: Option<f64>,
    /// How far joints are turned away from the true pose, degrees [as captured: 2]
    #[arg(long, value_name = "DEGREES", value_parser = amount)]
    pose_noise: Option<f64>,
    /// How far points are off by the calibration, px [as captured: 1]
    #[arg(long, value_name = "PX", value_parser = amount)]
    calibration_noise: Option<f64>,
    /// How far the body model's joints are from the person's, each in its parent, mm
    /// [as captured: 0]
    #[arg(long, value_name = "MM", value_parser = amount)]
    bone_noise: Option<f64>,
}

/// An amount of an error.
fn amount(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if (0.0..=100.0).contains(&number) => Ok(number),
        _ => Err("a number from 0 to 100".into()),
    }
}

impl Shooting {
    fn flaws(&self) -> Flaws {
        let usual = if self.as_captured {
            Flaws::CAPTURED
        } else {
            Flaws::default()
        };
        Flaws {
            noise: self.noise.unwrap_or(usual.noise),
            exposure: self.exposure.unwrap_or(usual.exposure),
            blur: self.blur.unwrap_or(usual.blur),
            mask: self.mask_noise.unwrap_or(usual.mask),
            pose: self.pose_noise.unwrap_or(usual.pose),
            calibration: self.calibration_noise.unwrap_or(usual.calibration),
            bone: self.bone_noise.unwrap_or(usual.bone),
        }
    }
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let start = Instant::now();
    let clips = args
        .motion
        .iter()
        .map(|path| clip_by_file_name(path))
        .collect::<anyhow::Result<Vec<_>>>()?;
    let shots = plan_frames(&clips, args.frames, args.block);
    // Its pictures would be removed, and may be nowhere else.
    let is_capture = ["calibration.json", "calibration_full.json", "images"];
    let is_capture = is_capture.iter().any(|name| args.out.join(name).exists());
    ensure!(
        !is_capture || output::may_overwrite(),
        "{} has a capture: name another folder, or add --overwrite to remove its pictures",
        args.out.display()
    );
    let clothed = bake::clothed(&args.assets.assets(), args.assets.person())?;
    let skeleton = &clothed.body.skeleton;
    for clip in &clips {
        let known = clip.map_to(skeleton).iter().flatten().count();
        ensure!(known > 0, "{}: found none of the body's joints", clip.name);
    }
    let mut poses = poses(&clips, &shots, skeleton);
    make_faces(&mut poses, &shots, args.faces, args.seed);
    let frames: Vec<CaptureFrame> = shots
        .iter()
        .enumerate()
        .map(|(frame, shot)| CaptureFrame {
            number: frame as u32,
            pose: poses.frame(frame),
            held: shot.held,
        })
        .collect();
    let shooting = &args.shooting;
    let options = PictureOptions {
        cameras: shooting.cameras,
        close: shooting.close,
        size: [shooting.size as u32; 2],
        samples: shooting.samples as u32,
        rays: args.rays,
        flaws: shooting.flaws(),
        seed: args.seed,
    };
    let bar = progress::items(frames.len() as u64, "frames");
    let summary = pictures::shoot(&args.out, clothed, &frames, &options, &|| bar.inc(1))?;
    bar.finish_and_clear();
    let held = frames.iter().filter(|frame| frame.held).count();
    println!(
        "{}: {} pictures of {} frames by {} cameras, {held} frames and {} cameras held out; the \
         person covers {:.1} % of them; {:.0} s",
        args.out.display(),
        summary.pictures,
        frames.len(),
        options.cameras + options.close,
        summary.held,
        100.0 * summary.covered,
        start.elapsed().as_secs_f64()
    );
    Ok(())
}

/// Gives a share of the training frames a random expression: each component is 0 or, with a
/// probability of 0.4, uniform up to 1.
fn make_faces(poses: &mut Clip, shots: &[ClipFrame], share: f64, seed: u64) {
    let faces = poses.expression.chunks_exact_mut(poses.expression_len);
    for (frame, (face, shot)) in faces.zip(shots).enumerate() {
        if shot.held {
            continue;
        }
        let mut random = Random::new(seed, frame as u64);
        if random.uniform() >= share {
            continue;
        }
        for strength in face {
            *strength = if random.uniform() < 0.4 {
                random.uniform() as f32
            } else {
                0.0
            };
        }
    }
}

/// A clip, named after its file.
fn clip_by_file_name(path: &Path) -> anyhow::Result<Clip> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    Ok(Clip {
        name: name.into_owned(),
        ..Clip::read(path)?
    })
}

/// The poses of the frames, as one clip with the skeleton's joints.
fn poses(clips: &[Clip], shots: &[ClipFrame], skeleton: &Skeleton) -> Clip {
    let mut poses = Clip {
        name: "poses".into(),
        expression_len: EXPRESSION,
        ..Clip::still(skeleton)
    };
    poses.credit = clips
        .first()
        .map(|clip| clip.credit.clone())
        .unwrap_or_default();
    poses.rotation.clear();
    poses.translation.clear();
    for shot in shots {
        let clip = &clips[shot.clip];
        let pose = clip.sample(shot.seconds);
        for joint in clip.map_to(skeleton) {
            let rotation = joint.map(|joint| pose.rotation[joint].as_vec3().to_array());
            poses.rotation.push(rotation.unwrap_or_default());
        }
        poses
            .translation
            .push(pose.translation.as_vec3().to_array());
        for component in 0..EXPRESSION {
            let strength = pose.expression.get(component).copied().unwrap_or(0.0);
            poses.expression.push(strength as f32);
        }
    }
    poses
}
