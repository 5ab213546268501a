//! `effigy dataset`: clips go in; a folder with what every Gaussian of the baked body looks like in each of their frames comes out.

use super::bake::{Body, bar, count};
use super::fit::share;
use crate::avatar::Clip;
use crate::bake::{self, math::Random};
use crate::fit::dataset::{Shot, Writer, plan};
use crate::fit::truth::Truth;
use std::path::PathBuf;
use std::time::Instant;

#[derive(clap::Args)]
pub struct Args {
    /// Clips of the baked body, as `effigy bake motion` makes them
    #[arg(required = true)]
    motion: Vec<PathBuf>,
    /// The folder to write; by custom its name ends in .dataset
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    #[command(flatten)]
    body: Body,
    /// Frames, evenly spaced over the clips
    #[arg(long, default_value = "300", value_parser = count(2, 100_000))]
    frames: usize,
    /// Seconds of a block; of each clip every fifth block is held out
    #[arg(long, value_name = "SECONDS", default_value = "1")]
    block: f64,
    /// The share of the frames that make a face of their own in place of the clip's, held-out ones aside: clips show few expressions
    #[arg(long, value_name = "SHARE", default_value = "0", value_parser = share)]
    faces: f64,
    /// Directions around each vertex that are asked for light
    #[arg(long, default_value = "192", value_parser = count(16, 10_000))]
    rays: usize,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let start = Instant::now();
    let (assets, sizes) = (args.body.assets(), args.body.sizes(0)?);
    let clips = args.motion.iter().map(|path| named(path)).collect::<anyhow::Result<Vec<_>>>()?;
    let dressed = bake::dressed(&assets, args.body.shape, &clips, &sizes, &|step| tracing::info!("{step}"))?;
    let truth = Truth::new(&dressed, args.rays);
    let shots = plan(&clips, args.frames, args.block);
    let mut poses = poses(&clips, &shots, &dressed.avatar.skeleton);
    make_faces(&mut poses, &shots, args.faces, args.body.seed);
    let bar = bar(shots.len() as u64)?;
    let writer = Writer::new(&args.out, &dressed.avatar, &poses, shots.iter().map(|(_, shot)| shot.clone()).collect())?;
    for frame in 0..shots.len() {
        writer.frame(frame, &truth.frame(&poses.frame(frame)))?;
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

/// Gives so many of the frames that are not held out an expression of random strengths, of some components each.
fn make_faces(poses: &mut Clip, shots: &[(usize, Shot)], share: f64, seed: u64) {
    let faces = poses.expression.chunks_exact_mut(poses.expression_len);
    for (frame, (face, _)) in faces.zip(shots).enumerate().filter(|(_, (_, (_, shot)))| !shot.held) {
        let mut random = Random::new(seed, frame as u64);
        if random.uniform() < share {
            face.iter_mut().for_each(|strength| *strength = if random.uniform() < 0.4 { random.uniform() as f32 } else { 0.0 });
        }
    }
}

/// A clip under its file's name, by which frames say where they are from.
fn named(path: &std::path::Path) -> anyhow::Result<Clip> {
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    Ok(Clip { name, ..Clip::read(path)? })
}

/// The frames' poses as a clip of the skeleton's joints.
fn poses(clips: &[Clip], shots: &[(usize, Shot)], skeleton: &crate::avatar::Skeleton) -> Clip {
    let mut all = Clip { name: "poses".into(), expression_len: 10, ..Clip::still(skeleton) };
    all.credit = clips.first().map(|clip| clip.credit.clone()).unwrap_or_default();
    all.rotation.clear();
    all.translation.clear();
    for (clip, shot) in shots {
        let (clip, map) = (&clips[*clip], clips[*clip].map_to(skeleton));
        let pose = clip.sample(shot.seconds);
        let turn = |joint: &Option<usize>| joint.map_or([0.0; 3], |joint| pose.rotation[joint].as_vec3().to_array());
        all.rotation.extend(map.iter().map(turn));
        all.translation.push(pose.translation.as_vec3().to_array());
        all.expression.extend((0..10).map(|e| pose.expression.get(e).copied().unwrap_or(0.0) as f32));
    }
    all
}
