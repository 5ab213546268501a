//! `effigy dataset`: makes a folder with the look of every Gaussian of the baked body in the frames
//! of some clips.

use crate::{
    bake::BodySource,
    options::{self, count},
    progress,
};
use effigy_core::{
    avatar::{Clip, Skeleton},
    random::Random,
};
use effigy_learn::{
    bake,
    dataset::{DatasetWriter, Shot, plan_frames},
    ground_truth::GroundTruth,
};
use std::{
    path::{Path, PathBuf},
    time::Instant,
};

/// Expression components of a pose in a dataset.
const EXPRESSION: usize = 10;

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Clips of the baked body, which `effigy bake motion` makes
    #[arg(required = true)]
    motion: Vec<PathBuf>,
    /// Folder to write; by custom its name ends in .dataset
    #[arg(short, long, value_name = "DIR")]
    out: PathBuf,
    #[command(flatten)]
    body: BodySource,
    /// Frames, 2 to 100000, evenly spaced over the clips
    #[arg(long, value_name = "N", default_value = "300", value_parser = count(2, 100_000))]
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
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let start = Instant::now();
    let assets = args.body.assets();
    let sizes = args.body.sizes(0)?;
    let clips = args
        .motion
        .iter()
        .map(|path| clip_by_file_name(path))
        .collect::<anyhow::Result<Vec<_>>>()?;
    let dressed = bake::dressed(&assets, args.body.shape(), &clips, &sizes, &|step| {
        tracing::info!("{step}")
    })?;
    let truth = GroundTruth::new(&dressed, args.rays);
    let shots = plan_frames(&clips, args.frames, args.block);
    let mut poses = poses(&clips, &shots, &dressed.avatar.skeleton);
    make_faces(&mut poses, &shots, args.faces, args.body.seed);
    let bar = progress::steps(shots.len() as u64);
    let writer = DatasetWriter::new(
        &args.out,
        &dressed.avatar,
        &poses,
        shots.iter().map(|(_, shot)| shot.clone()).collect(),
    )?;
    for frame in 0..shots.len() {
        writer.write_frame(frame, &truth.frame(&poses.frame(frame)))?;
        bar.inc(1);
    }
    writer.finish()?;
    bar.finish_and_clear();
    let held = shots.iter().filter(|(_, shot)| shot.held).count();
    println!(
        "{}: {} frames of {} Gaussians, {held} of them held out; {:.0} s",
        args.out.display(),
        shots.len(),
        dressed.avatar.gaussians.len(),
        start.elapsed().as_secs_f64()
    );
    Ok(())
}

/// Gives a share of the training frames a random expression: each component is 0 or, with a
/// probability of 0.4, uniform up to 1.
fn make_faces(poses: &mut Clip, shots: &[(usize, Shot)], share: f64, seed: u64) {
    let faces = poses.expression.chunks_exact_mut(poses.expression_len);
    for (frame, (face, (_, shot))) in faces.zip(shots).enumerate() {
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

/// A clip, named after its file: a dataset names the clip of each frame.
fn clip_by_file_name(path: &Path) -> anyhow::Result<Clip> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    Ok(Clip {
        name: name.into_owned(),
        ..Clip::read(path)?
    })
}

/// The poses of the frames, as one clip with the skeleton's joints.
fn poses(clips: &[Clip], shots: &[(usize, Shot)], skeleton: &Skeleton) -> Clip {
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
    for (clip, shot) in shots {
        let clip = &clips[*clip];
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
