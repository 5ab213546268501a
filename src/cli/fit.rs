//! `effigy fit` and `effigy prune`: learn an avatar whose look follows the pose from a dataset, and
//! write the learning curves beside it.

use crate::{
    options::{self, count},
    output::{self, AVATAR, Output},
    progress,
};
use anyhow::{Context, ensure};
use effigy_core::avatar::{Avatar, limits};
use effigy_learn::{self, Budget, Dataset, FitOptions, Fitted, fit::loss_curve};
use std::{
    path::{Path, PathBuf},
    time::{Duration, Instant},
};

/// Fewest frames that a fit is made from.
pub const MIN_FRAMES: usize = 8;

/// Arguments of both commands.
#[derive(clap::Args, Debug)]
struct TrainingArgs {
    /// Avatar file to write; the learning curves go beside it, .loss.svg and .loss.csv
    #[arg(short, long, value_name = "FILE", value_parser = AVATAR.parser())]
    out: Output,
    /// Corrective rows to keep, of rotation, scale and colour together, 0 or more: those without
    /// which images of the training frames would lose most [default: a tenth of all]
    #[arg(long, value_name = "N", value_parser = count(0, 3 * limits::GAUSSIANS))]
    keep: Option<usize>,
    /// Keep instead the correctives of this many Gaussians, 0 or more, for each of rotation, scale
    /// and colour: those that vary most, as in the paper
    #[arg(long, value_name = "N", value_parser = count(0, limits::GAUSSIANS), conflicts_with = "keep")]
    rows: Option<usize>,
    /// Keep instead as many of each as hold this share of the correctives' variance, 0 to 1
    #[arg(long, value_name = "SHARE", value_parser = options::share, conflicts_with_all = ["keep", "rows"])]
    variance: Option<f64>,
    /// Learn from this clip alone, by its name in the dataset; repeat for several [default: all]
    #[arg(long, value_name = "NAME")]
    clip: Vec<String>,
    /// Epochs: times that the networks see every training frame, 4 to 1000000
    #[arg(long, value_name = "N", default_value = "400", value_parser = count(4, 1_000_000))]
    epochs: usize,
    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value = "1")]
    seed: u64,
    /// Time between checkpoints, seconds, 0 to 1000000; an interrupted run continues from the last
    #[arg(long, value_name = "SECONDS", default_value = "30", value_parser = checkpoint)]
    checkpoint: f64,
}

#[derive(clap::Args, Debug)]
pub struct FitArgs {
    /// Dataset: a folder that `effigy dataset` wrote
    dataset: PathBuf,
    #[command(flatten)]
    training: TrainingArgs,
    /// Keep every corrective
    #[arg(long, conflicts_with_all = ["keep", "rows", "variance"])]
    unpruned: bool,
    /// Basis functions of each part, a multiple of 4 from 4 to 32, for attributes and for nodes
    #[arg(long, value_name = "N", default_value = "16", value_parser = count(4, limits::BASIS))]
    basis: usize,
    /// Weight of the term that keeps correctives small before pruning, 0 to 1000
    #[arg(long, value_name = "WEIGHT", default_value = "1", value_parser = constraint)]
    constraint: f32,
}

#[derive(clap::Args, Debug)]
pub struct PruneArgs {
    /// Learned avatar
    avatar: PathBuf,
    /// Dataset that it was learned from: a folder that `effigy dataset` wrote
    dataset: PathBuf,
    #[command(flatten)]
    training: TrainingArgs,
}

/// A time between checkpoints, seconds.
pub fn checkpoint(text: &str) -> Result<f64, String> {
    options::number(text, 0.0, 1e6, "number of seconds")
}

fn constraint(text: &str) -> Result<f32, String> {
    options::number(text, 0.0, 1e3, "weight").map(|weight| weight as f32)
}

impl TrainingArgs {
    /// The options for an avatar of so many Gaussians.
    fn options(&self, gaussians: usize) -> FitOptions {
        let budget = match (self.rows, self.variance) {
            (Some(rows), _) => Budget::Rows(rows),
            (None, Some(share)) => Budget::Variance(share),
            (None, None) => Budget::Contribution(self.keep.unwrap_or(3 * gaussians / 10)),
        };
        let checkpoint = Duration::from_secs_f64(self.checkpoint);
        FitOptions {
            epochs: self.epochs,
            seed: self.seed,
            clips: self.clip.clone(),
            budget: Some(budget),
            checkpoint: Some(effigy_learn::CheckpointOptions {
                path: self.out.beside("checkpoint").to_path_buf(),
                interval: checkpoint,
            }),
            ..FitOptions::default()
        }
    }

    /// The learning curves.
    fn curves(&self) -> [Output; 2] {
        ["loss.csv", "loss.svg"].map(|rest| self.out.beside(rest))
    }
}

/// Refuses clips that the dataset does not have, and too few training frames. `folder`: of the
/// dataset.
pub fn check_clips(dataset: &Dataset, folder: &Path, clips: &[String]) -> anyhow::Result<()> {
    let known = dataset.clips();
    if let Some(clip) = clips.iter().find(|clip| !known.contains(clip)) {
        anyhow::bail!(
            "{}: found no clip `{clip}`, it has {}",
            folder.display(),
            known.join(", ")
        );
    }
    let frames = dataset.training(clips).len();
    ensure!(
        frames >= MIN_FRAMES,
        "{}: found {frames} training frames, expected at least {MIN_FRAMES}",
        folder.display()
    );
    Ok(())
}

pub fn run(args: FitArgs) -> anyhow::Result<()> {
    let start = Instant::now();
    output::check(&args.training.curves())?;
    ensure!(
        args.basis.is_multiple_of(4),
        "--basis {} is not a multiple of 4",
        args.basis
    );
    let dataset = Dataset::open(&args.dataset)?;
    check_clips(&dataset, &args.dataset, &args.training.clip)?;
    let mut options = args.training.options(dataset.avatar.gaussians.len());
    options.basis = args.basis;
    options.constraint = args.constraint;
    if args.unpruned {
        options.budget = None;
    }
    let fitted = with_progress(options.epochs, |progress| {
        effigy_learn::fit(&dataset, &options, progress)
    })?;
    write(&args.training, fitted, start)
}

pub fn run_prune(args: PruneArgs) -> anyhow::Result<()> {
    let start = Instant::now();
    output::check(&args.training.curves())?;
    let avatar = Avatar::read(&args.avatar)?;
    let dataset = Dataset::open(&args.dataset)?;
    check_clips(&dataset, &args.dataset, &args.training.clip)?;
    check_body(&avatar, &args.avatar, &dataset)?;
    let is_learned =
        avatar.networks.output() == 2 * avatar.basis_len() && avatar.networks.layers.len() == 4;
    ensure!(
        is_learned,
        "{}: found other networks than those of `effigy fit`",
        args.avatar.display()
    );
    let options = args.training.options(avatar.gaussians.len());
    let fitted = with_progress(options.epochs / 4, |progress| {
        effigy_learn::prune(&dataset, &avatar, &options, progress)
    })?;
    write(&args.training, fitted, start)
}

/// Learns for a number of epochs, with a progress bar.
fn with_progress(
    epochs: usize,
    run: impl FnOnce(effigy_learn::fit::FitProgress) -> Result<Fitted, effigy_learn::LearnError>,
) -> anyhow::Result<Fitted> {
    let bar = progress::items(epochs as u64, "epochs");
    let fitted = run(&|done: usize, what: &str| {
        bar.set_position(done as u64);
        bar.set_message(what.to_owned());
    })?;
    bar.finish_and_clear();
    Ok(fitted)
}

/// Refuses an avatar, read from `path`, that does not have the dataset's body.
pub fn check_body(avatar: &Avatar, path: &Path, dataset: &Dataset) -> anyhow::Result<()> {
    let own = &dataset.avatar;
    ensure!(
        avatar.skeleton.name == own.skeleton.name,
        "{}: found another skeleton, expected the dataset's: {} joints from {}",
        path.display(),
        own.skeleton.len(),
        own.skeleton.name.first().map_or("", String::as_str)
    );
    let same = avatar.gaussians.position == own.gaussians.position && avatar.parts == own.parts;
    ensure!(
        same,
        "{}: found {} Gaussians in {} parts, expected the dataset's own {} in {}",
        path.display(),
        avatar.gaussians.len(),
        avatar.parts.len(),
        own.gaussians.len(),
        own.parts.len()
    );
    Ok(())
}

/// Writes the avatar and its curves, removes the checkpoint, and prints what was made.
fn write(training: &TrainingArgs, fitted: Fitted, start: Instant) -> anyhow::Result<()> {
    let Fitted { avatar, curve } = fitted;
    avatar.write(&training.out)?;
    let [csv, svg] = training.curves();
    csv.write(loss_curve::csv(&curve))?;
    svg.write(loss_curve::svg(&curve)?)?;
    let checkpoint = training.out.beside("checkpoint");
    if checkpoint.exists() {
        std::fs::remove_file(&checkpoint)
            .with_context(|| format!("{} can't be removed", checkpoint.display()))?;
    }
    let left = curve.last().map_or(0.0, |point| 100.0 * point.training);
    let megabytes = training
        .out
        .metadata()
        .map_or(0.0, |file| file.len() as f64 / 1e6);
    println!(
        "{}: {} Gaussians, {} rows of rotation, {} of scale, {} of colour; {left:.1} % of the training frames' variance left; {megabytes:.1} MB; {:.0} s",
        training.out.display(),
        avatar.gaussians.len(),
        avatar.rotation_rows.gaussian.len(),
        avatar.scale_rows.gaussian.len(),
        avatar.color_rows.gaussian.len(),
        start.elapsed().as_secs_f64()
    );
    Ok(())
}
