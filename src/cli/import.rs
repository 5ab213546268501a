//! `effigy import`: makes an avatar file, and motion files, from those of another program.

use crate::{
    files, options, progress,
    source::{POSES_RATE, print_assumptions},
};
use anyhow::Context;
use clap::ValueEnum;
use effigy_core::avatar::{Activation, Avatar, Clip};
use effigy_formats::{
    open::{self, OpenOptions},
    webavatar::{self, ColorCode},
};
use effigy_learn::math::pca::pca;
use std::path::PathBuf;

/// Principal components of the training poses that the paper's avatars have.
const POSE_COMPONENTS: usize = 20;

#[derive(clap::Args, Debug)]
pub struct Args {
    /// The paper's model, a .npz file
    file: PathBuf,
    /// Avatar file to write
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
    /// Poses that the avatar was trained for, as the paper's _poses.json; repeat for several.
    /// Networks then see the nearest such pose
    #[arg(long, value_name = "FILE")]
    trained: Vec<PathBuf>,
    /// Poses to write as a clip, as the paper's _poses.json
    #[arg(long, value_name = "FILE", requires = "motion_out")]
    poses: Option<PathBuf>,
    /// Motion file to write
    #[arg(long, value_name = "FILE", requires = "poses")]
    motion_out: Option<PathBuf>,
    /// Frames a second of the poses
    #[arg(long, value_name = "N", default_value_t = POSES_RATE, value_parser = options::rate)]
    fps: f64,
    /// Nonlinearity of the networks' hidden layers
    #[arg(long, value_enum, default_value_t)]
    activation: ActivationArg,
    /// What the file's colours count in
    #[arg(long, value_enum, default_value_t)]
    color_code: ColorArg,
}

/// [`Activation`] as an argument.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum ActivationArg {
    /// max(0.01 x, x)
    #[default]
    Leaky,
    /// max(0, x)
    Relu,
}

/// [`ColorCode`] as an argument.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum ColorArg {
    /// Spherical harmonics of degree 0: RGB = 0.5 + 0.282 times the number
    #[default]
    Harmonic,
    /// RGB = 0.5 + the number
    Offset,
}

impl From<ActivationArg> for Activation {
    fn from(argument: ActivationArg) -> Self {
        match argument {
            ActivationArg::Leaky => Self::LeakyRelu,
            ActivationArg::Relu => Self::Relu,
        }
    }
}

impl From<ColorArg> for ColorCode {
    fn from(argument: ColorArg) -> Self {
        match argument {
            ColorArg::Harmonic => Self::Harmonic,
            ColorArg::Offset => Self::Offset,
        }
    }
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let options = OpenOptions {
        webavatar: webavatar::Options {
            activation: args.activation.into(),
            color: args.color_code.into(),
        },
        ..OpenOptions::default()
    };
    let bar = progress::items(0, "file");
    bar.set_message(format!("reading {}", args.file.display()));
    let mut imported = open::avatar(&args.file, &options)?;
    bar.finish_and_clear();
    print_assumptions(&args.file, &imported.assumptions);
    let avatar = &mut imported.avatar;
    if !args.trained.is_empty() {
        project_onto(avatar, &args.trained, args.fps)?;
    }
    if let (Some(poses), Some(out)) = (&args.poses, &args.motion_out) {
        let clip = open::clip(poses, &avatar.skeleton, args.fps)?;
        clip.write(out)?;
        println!(
            "{}: {} frames, {:.1} s",
            out.display(),
            clip.frames(),
            clip.duration()
        );
    }
    avatar.write(&args.out)?;
    println!("{}: {}", args.out.display(), files::describe(avatar));
    Ok(())
}

/// Gives an avatar the principal components of these poses.
fn project_onto(avatar: &mut Avatar, files: &[PathBuf], rate: f64) -> anyhow::Result<()> {
    let read = |path: &PathBuf| open::clip(path, &avatar.skeleton, rate);
    let clips: Vec<Clip> = files.iter().map(read).collect::<Result<_, _>>()?;
    let inputs = |clip: &Clip| -> Vec<Vec<f64>> {
        let pose = |frame| avatar.inputs.unprojected(&clip.frame(frame));
        (0..clip.frames()).map(pose).collect()
    };
    let width = 3 * avatar.inputs.joint.len();
    let rows: Vec<Vec<f64>> = clips
        .iter()
        .flat_map(inputs)
        .map(|mut row| {
            row.truncate(width);
            row
        })
        .collect();
    let space = pca(&rows, width, POSE_COMPONENTS);
    println!(
        "{} training poses, {} principal components",
        rows.len(),
        space.sigma.len()
    );
    avatar.inputs.pose_space = Some(space);
    avatar.check().context("of the training poses")?;
    Ok(())
}
