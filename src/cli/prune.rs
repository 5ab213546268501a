//! `effigy prune`: keep the correctives of an avatar that are worth most, without learning again.

use crate::{
    budget::BudgetArgs,
    output::WriteAvatar,
    source::{CaptureArgs, PoseProjection, Source},
};
use anyhow::ensure;
use effigy_core::avatar::Avatar;
use effigy_learn::prune::prune;
use std::{path::PathBuf, time::Instant};

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Avatar: an .avatar file, the paper's .npz, or mmlphuman's checkpoint
    avatar: PathBuf,
    #[command(flatten)]
    out: WriteAvatar,
    /// Clip in whose poses correctives are weighed; repeat for several [default: random poses of
    /// those that the avatar was trained for]
    #[arg(long, value_name = "FILE")]
    motion: Vec<PathBuf>,
    #[command(flatten)]
    budget: BudgetArgs,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let start = Instant::now();
    let out = args.out.file()?;
    let source = Source {
        avatar: Some(args.avatar.clone()),
        motion: args.motion.clone(),
        capture: CaptureArgs::default(),
        up: None,
        project: PoseProjection::On,
    };
    let avatar = source.read(&args.avatar)?.avatar;
    ensure!(
        rows(&avatar).iter().sum::<usize>() > 0,
        "{}: found no correctives, so that there is nothing to prune",
        args.avatar.display()
    );
    let players = if args.motion.is_empty() {
        vec![]
    } else {
        source.players(&avatar)?
    };
    let budget = args.budget.budget(avatar.gaussians.len());
    let pruned = prune(&avatar, &players, budget);
    pruned.write(out)?;
    let [rotation, scale, color] = rows(&pruned);
    let before: usize = rows(&avatar).iter().sum();
    let megabytes = out.metadata().map_or(0.0, |file| file.len() as f64 / 1e6);
    println!(
        "{}: {} Gaussians, {rotation} rows of rotation, {scale} of scale, {color} of colour, of {before}; {megabytes:.1} MB; {:.0} s",
        out.display(),
        pruned.gaussians.len(),
        start.elapsed().as_secs_f64()
    );
    Ok(())
}

/// Rows of rotation, scale and colour.
fn rows(avatar: &Avatar) -> [usize; 3] {
    [
        avatar.rotation_rows.gaussian.len(),
        avatar.scale_rows.gaussian.len(),
        avatar.color_rows.gaussian.len(),
    ]
}
