//! `effigy convert`: writes splats, or an avatar in one pose, as a splat file of another program.

use crate::{
    files::print_assumptions,
    options::{self, FilterArgs, UpArgs},
    output::WriteSplats,
    source::{CaptureArgs, PoseProjection, Source, check_time},
};
use anyhow::{Context, ensure};
use effigy_core::{
    avatar::{Avatar, Filter},
    io::splats::{Splats, Uniform, from_gaussians},
    reference::{mlp, nodes, project},
    scene::Posed,
};
use effigy_formats::{
    open,
    splats::{SplatFormat, write},
};
use std::path::PathBuf;

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Splats, or an avatar to write in one pose
    file: PathBuf,
    #[command(flatten)]
    out: WriteSplats,
    /// Clip that poses an avatar [default: the poses beside an .npz, else the built-in demo clip]
    #[arg(long, value_name = "FILE")]
    motion: Option<PathBuf>,
    #[command(flatten)]
    capture: CaptureArgs,
    /// Time in the clip, seconds
    #[arg(long, alias = "at", value_name = "SECONDS", default_value_t = 0.0, value_parser = options::seconds)]
    time: f64,
    #[command(flatten)]
    up: UpArgs,
    /// Whether the networks see the nearest pose that the avatar was trained for, within 2σ along
    /// each principal component of its training poses; off: the pose itself
    #[arg(long, value_enum, default_value_t = PoseProjection::On)]
    project: PoseProjection,
    #[command(flatten)]
    filter: FilterArgs,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let out = args.out.file()?;
    let format = SplatFormat::of_name(out).unwrap_or(SplatFormat::Ply);
    let mut splats = if open::is_splats(&args.file) {
        ensure!(
            args.motion.is_none(),
            "--motion is for avatars: {} has splats, which stand still",
            args.file.display()
        );
        let found = open::splats(&args.file, args.up.up)?;
        print_assumptions(&args.file, &found.assumptions);
        found.splats
    } else {
        posed_file(&args)?
    };
    splats.filter = args.filter.filter().unwrap_or(splats.filter);
    let count = splats.len();
    if format == SplatFormat::Splat && splats.degree > 0 {
        tracing::warn!("a .splat has no spherical harmonics above degree 0: they are left out");
    }
    let is_kept = match format {
        SplatFormat::Spz => [Filter::DEFAULT, Filter::ANTIALIASED].contains(&splats.filter),
        _ => splats.filter == Filter::DEFAULT,
    };
    if !is_kept {
        tracing::warn!(
            "{} can't say that the splats are drawn with a low-pass of {} px²",
            out.display(),
            splats.filter
        );
    }
    let bytes = write(splats, format).with_context(|| args.file.display().to_string())?;
    out.write(&bytes)?;
    println!(
        "wrote {}: {count} Gaussians, {:.1} MB",
        out.display(),
        bytes.len() as f64 / 1e6
    );
    Ok(())
}

/// The Gaussians of an avatar's file in a pose.
fn posed_file(args: &Args) -> anyhow::Result<Splats> {
    let source = Source {
        avatar: Some(args.file.clone()),
        motion: args.motion.iter().cloned().collect(),
        capture: args.capture.clone(),
        up: args.up.up,
        project: args.project,
    };
    let (avatar, player) = source.load_player()?;
    check_time(&player, args.time);
    posed_splats(&avatar, &Posed::new(&avatar, &player.pose(args.time)), None)
}

/// The Gaussians of an avatar in a pose, without spherical harmonics. An error if one is not
/// finite. `uniform` replaces their shapes.
pub fn posed_splats(
    avatar: &Avatar,
    pose: &Posed,
    uniform: Option<Uniform>,
) -> anyhow::Result<Splats> {
    let features = mlp::features(avatar, &pose.input);
    let gaussians = project::gaussians(avatar, pose, &features, &nodes::nodes(avatar, &features));
    let bad = gaussians
        .iter()
        .position(|g| !(g.mean.is_finite() && g.axes.is_finite() && g.color.is_finite()));
    ensure!(
        bad.is_none(),
        "Gaussian {} of `{}` is not finite in this pose: choose another with --time",
        bad.unwrap_or(0),
        avatar.name
    );
    if avatar.sh.is_some() {
        tracing::warn!(
            "the spherical harmonics of `{}` are left out: colours are written without them",
            avatar.name
        );
    }
    Ok(Splats {
        filter: avatar.filter,
        ..from_gaussians(&gaussians, uniform)
    })
}
