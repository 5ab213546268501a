//! `effigy import`: makes an avatar file, and motion files, from those of another program.

use crate::{
    distil, files,
    options::{self, FilterArgs, UpArgs},
    output::{MOTION, Output, WriteImported},
    progress,
    source::{self, CaptureArgs},
};
use anyhow::{Context, ensure};
use clap::ValueEnum;
use effigy_core::avatar::{Activation, Avatar, Clip};
use effigy_formats::{
    mmlphuman,
    open::{self, ClipOptions, OpenOptions},
    webavatar::{self, ColorCode},
};
use effigy_math::pca::pca;
use std::{
    path::{Path, PathBuf},
    time::Instant,
};

/// Principal components of the training poses that the paper's avatars have.
const POSE_COMPONENTS: usize = 20;

#[derive(clap::Args, Debug)]
pub struct Args {
    /// The paper's model, a .npz file, mmlphuman's checkpoint, a .pth file, splats: .ply, .splat,
    /// .spz, .sog, .ksplat, .glb or .gltf, or motion of any body: .bvh, .fbx, glTF, VRM, SMPL's
    /// parameters, the paper's _poses.json
    file: PathBuf,
    #[command(flatten)]
    out: WriteImported,
    /// Avatar that motion of another body is to move [default: the built-in demo; of `bake motion`
    /// the assets' body]
    #[arg(long, value_name = "FILE")]
    avatar: Option<PathBuf>,
    #[command(flatten)]
    capture: CaptureArgs,
    /// Leave feet where joints put them: neither held in place where they stand in the capture, nor
    /// lifted out of the ground
    #[arg(long)]
    keep_feet: bool,
    /// Poses that the avatar was trained for, motion of any kind; repeat for several.
    /// Networks then see the nearest such pose
    #[arg(long, value_name = "FILE")]
    trained: Vec<PathBuf>,
    /// Poses to write as a clip, motion of any kind
    #[arg(long, value_name = "FILE", requires = "motion_out")]
    poses: Option<PathBuf>,
    /// Motion file to write
    #[arg(long, value_name = "FILE", requires = "poses", value_parser = MOTION.parser())]
    motion_out: Option<Output>,
    /// Frames a second: of poses, whose file does not say [default: 30], or of the clip to make of
    /// motion capture [default: its own, at most 60]
    #[arg(long, value_name = "N", value_parser = options::rate)]
    fps: Option<f64>,
    /// Nonlinearity of the networks' hidden layers [default: leaky; of mmlphuman relu]
    #[arg(long, value_enum)]
    activation: Option<ActivationArg>,
    /// What the file's colours count in
    #[arg(long, value_enum, default_value_t)]
    color_code: ColorArg,
    #[command(flatten)]
    up: UpArgs,
    #[command(flatten)]
    filter: FilterArgs,
    #[command(flatten)]
    distil: distil::DistilArgs,
}

/// [`Activation`] as an argument.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum ActivationArg {
    /// max(0.01 x, x)
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

impl Args {
    fn clip_options(&self) -> anyhow::Result<ClipOptions> {
        let mut options = self.capture.clip_options(self.fps)?;
        options.retarget.rate = self.fps;
        options.retarget.keep_feet = self.keep_feet;
        Ok(options)
    }
}

/// Reads a clip for an avatar and writes it.
fn convert_clip(args: &Args, file: &Path, avatar: &Avatar, out: &Path) -> anyhow::Result<()> {
    let clip = source::clip(file, avatar, &args.clip_options()?)?;
    clip.write(out)?;
    println!(
        "{}: {} frames at {:.4} per second, {:.1} s",
        out.display(),
        clip.frames(),
        clip.rate,
        clip.duration()
    );
    Ok(())
}

/// Refuses options that say nothing of the file, and a name that promises another one.
fn check(args: &Args, out: &Output, is_motion: bool) -> anyhow::Result<()> {
    let ending = if is_motion { "motion" } else { "avatar" };
    ensure!(
        out.ending() == ending,
        "{} does not end in .{ending}, which {} becomes",
        out.display(),
        args.file.display()
    );
    ensure!(
        !args.distil.is_given() || open::is_checkpoint(&args.file),
        "--samples, --epochs, --basis, --keep, --rows, --seed, --reach and --hips are for \
         mmlphuman's checkpoint: {} is none",
        args.file.display()
    );
    if is_motion {
        ensure!(
            args.trained.is_empty()
                && args.poses.is_none()
                && args.filter.filter().is_none()
                && args.up.up.is_none(),
            "--trained, --poses, --filter and --up are for avatars: {} is motion",
            args.file.display()
        );
    } else {
        ensure!(
            args.avatar.is_none() && !args.keep_feet,
            "--avatar and --keep-feet are for motion: {} is none",
            args.file.display()
        );
        ensure!(
            args.up.up.is_none() || open::is_splats(&args.file),
            "--up is for splats: {} has none",
            args.file.display()
        );
        if open::is_splats(&args.file) {
            check_still(args)?;
        }
    }
    Ok(())
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let is_motion = open::is_capture(&args.file);
    let out = args.out.file()?;
    check(&args, out, is_motion)?;
    if is_motion {
        let avatar = source::avatar_to_move(args.avatar.as_deref())?;
        return convert_clip(&args, &args.file, &avatar, out);
    }
    let avatar = &mut if open::is_checkpoint(&args.file) {
        distilled(&args)?
    } else {
        imported(&args)?
    };
    args.filter.apply(avatar);
    if let (Some(poses), Some(out)) = (&args.poses, &args.motion_out) {
        convert_clip(&args, poses, avatar, out)?;
    }
    if avatar.is_static() {
        // All its Gaussians have one joint and no node, which deflates to nothing.
        avatar.write_packed(out)?;
    } else {
        avatar.write(out)?;
    }
    println!("{}: {}", out.display(), files::describe(avatar));
    Ok(())
}

/// Refuses options of learned avatars where a file has splats.
fn check_still(args: &Args) -> anyhow::Result<()> {
    ensure!(
        args.trained.is_empty() && args.poses.is_none() && args.activation.is_none(),
        "--trained, --poses and --activation are for avatars that move: {} has splats, which stand \
         still",
        args.file.display()
    );
    Ok(())
}

/// Distils the avatar of a checkpoint.
fn distilled(args: &Args) -> anyhow::Result<Avatar> {
    let plain = mmlphuman::Options::default();
    let options = args.distil.file_options(mmlphuman::Options {
        activation: args.activation.map_or(plain.activation, Into::into),
        color: args.color_code.into(),
        ..plain
    });
    let job = distil::Job {
        file: &args.file,
        trained: &args.trained,
        clips: &args.clip_options()?,
        options,
    };
    let start = Instant::now();
    let distilled = distil::run(&args.distil, &job)?;
    println!("{}", distil::likeness(&distilled.likeness));
    println!("distilled in {:.0} s", start.elapsed().as_secs_f64());
    Ok(distilled.avatar)
}

/// Reads the paper's model, or another avatar.
fn imported(args: &Args) -> anyhow::Result<Avatar> {
    let plain = webavatar::Options::default();
    let options = OpenOptions {
        webavatar: webavatar::Options {
            activation: args.activation.map_or(plain.activation, Into::into),
            color: args.color_code.into(),
        },
        up: args.up.up,
    };
    let bar = progress::open_ended();
    bar.set_message(format!("reading {}", args.file.display()));
    let mut imported = open::avatar(&args.file, &options)?;
    bar.finish_and_clear();
    files::print_assumptions(&args.file, &imported.assumptions);
    if !args.trained.is_empty() {
        project_onto(&mut imported.avatar, &args.trained, &args.clip_options()?)?;
    }
    Ok(imported.avatar)
}

/// Gives an avatar the principal components of these poses.
fn project_onto(
    avatar: &mut Avatar,
    files: &[PathBuf],
    options: &ClipOptions,
) -> anyhow::Result<()> {
    let read = |path: &PathBuf| source::clip(path, avatar, options);
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
