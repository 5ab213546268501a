//! `effigy fit` and `effigy prune`: a dataset goes in; an avatar whose look follows the pose comes out, with the curves of how it learnt.

use super::bake::{bar, count};
use crate::avatar::{Avatar, file::replace, limits};
use crate::fit::{self, Budget, Dataset, Fitted, Options, loss};
use anyhow::{Context, ensure};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What both commands are told.
#[derive(clap::Args)]
struct Common {
    /// The avatar file to write; the curves go beside it, .loss.svg and .loss.csv
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Correctives that are kept, of rotation, scale and colour together: those that pictures of the training frames would lose most
    /// without [default: a tenth of all]
    #[arg(long, value_name = "N", value_parser = count(0, 3 * limits::GAUSSIANS))]
    keep: Option<usize>,
    /// Keep instead those of so many Gaussians for each of rotation, scale and colour, where they vary most, as the paper does
    #[arg(long, value_name = "N", value_parser = count(0, limits::GAUSSIANS), conflicts_with = "keep")]
    rows: Option<usize>,
    /// Keep instead as many of each as hold this share of the correctives' variance, 0 to 1
    #[arg(long, value_name = "SHARE", value_parser = share, conflicts_with_all = ["keep", "rows"])]
    variance: Option<f64>,
    /// Fit to this clip alone, by its name in the dataset; repeat for several [default: all]
    #[arg(long, value_name = "NAME")]
    clip: Vec<String>,
    /// How often the networks see every training frame
    #[arg(long, default_value = "400", value_parser = count(4, 1_000_000))]
    epochs: usize,
    #[arg(long, default_value = "1")]
    seed: u64,
    /// Seconds between checkpoints, from which an interrupted run goes on
    #[arg(long, value_name = "SECONDS", default_value = "30")]
    checkpoint: f64,
}

#[derive(clap::Args)]
pub struct FitArgs {
    /// The dataset's folder
    dataset: PathBuf,
    #[command(flatten)]
    common: Common,
    /// Keep every corrective
    #[arg(long, conflicts_with_all = ["keep", "rows", "variance"])]
    unpruned: bool,
    /// Features a part, each of attributes and nodes
    #[arg(long, default_value = "16", value_parser = count(4, limits::BASIS))]
    basis: usize,
    /// How much correctives are held small before pruning: 0 not at all, 1 as usual
    #[arg(long, value_name = "WEIGHT", default_value = "1")]
    constraint: f32,
}

#[derive(clap::Args)]
pub struct PruneArgs {
    /// The fitted avatar
    avatar: PathBuf,
    /// The folder of the dataset that it was fitted to
    dataset: PathBuf,
    #[command(flatten)]
    common: Common,
}

pub(super) fn share(text: &str) -> Result<f64, String> {
    super::options::number(text, 0.0, 1.0, "share")
}

impl Common {
    fn options(&self, gaussians: usize) -> anyhow::Result<Options> {
        ensure!((0.0..=1e6).contains(&self.checkpoint), "--checkpoint {} is no number of seconds", self.checkpoint);
        let budget = match (self.rows, self.variance) {
            (Some(rows), _) => Budget::Rows(rows),
            (_, Some(share)) => Budget::Variance(share),
            _ => Budget::Shown(self.keep.unwrap_or(3 * gaussians / 10)),
        };
        Ok(Options {
            epochs: self.epochs,
            seed: self.seed,
            clips: self.clip.clone(),
            budget: Some(budget),
            checkpoint: Some((self.beside("checkpoint"), Duration::from_secs_f64(self.checkpoint))),
            ..Options::default()
        })
    }

    /// A file beside the avatar.
    fn beside(&self, ending: &str) -> PathBuf {
        self.out.with_extension(ending)
    }
}

/// Clips that are asked for are in the dataset, and leave something to fit to.
pub(super) fn check_clips(dataset: &Dataset, folder: &Path, clips: &[String]) -> anyhow::Result<()> {
    let known = dataset.clips();
    if let Some(clip) = clips.iter().find(|clip| !known.contains(clip)) {
        anyhow::bail!("{}: found no clip `{clip}`, it has {}", folder.display(), known.join(", "));
    }
    let frames = dataset.training(clips).len();
    ensure!(frames >= 8, "{}: found {frames} training frames, expected at least 8", folder.display());
    Ok(())
}

pub fn run(args: FitArgs) -> anyhow::Result<()> {
    let start = Instant::now();
    ensure!(args.basis.is_multiple_of(4), "--basis {} is no multiple of 4", args.basis);
    ensure!((0.0..=1e3).contains(&args.constraint), "--constraint {} is no weight: write a number from 0 to 1000", args.constraint);
    let dataset = Dataset::open(&args.dataset)?;
    check_clips(&dataset, &args.dataset, &args.common.clip)?;
    let mut options = args.common.options(dataset.avatar.gaussians.len())?;
    options.basis = args.basis;
    options.constraint = args.constraint;
    if args.unpruned {
        options.budget = None;
    }
    let fitted = watched(options.epochs, |hear| fit::fit(&dataset, &options, hear))?;
    write(&args.common, fitted, start)
}

pub fn run_prune(args: PruneArgs) -> anyhow::Result<()> {
    let start = Instant::now();
    let avatar = Avatar::read(&args.avatar)?;
    let dataset = Dataset::open(&args.dataset)?;
    check_clips(&dataset, &args.dataset, &args.common.clip)?;
    fits(&avatar, &args.avatar, &dataset)?;
    let learnt = avatar.networks.output() == 2 * avatar.basis_len() && avatar.networks.layers.len() == 4;
    ensure!(learnt, "{}: found networks of another make, expected those of `effigy fit`", args.avatar.display());
    let options = args.common.options(avatar.gaussians.len())?;
    let fitted = watched(options.epochs / 4, |hear| fit::prune(&dataset, &avatar, &options, hear))?;
    write(&args.common, fitted, start)
}

/// Runs so many epochs under a progress bar.
fn watched(epochs: usize, run: impl FnOnce(fit::run::Hear) -> Result<Fitted, fit::Error>) -> anyhow::Result<Fitted> {
    let bar = bar(epochs as u64)?;
    let fitted = run(&|done: usize, what: &str| {
        bar.set_position(done as u64);
        bar.set_message(what.to_owned());
    })?;
    bar.finish_and_clear();
    Ok(fitted)
}

/// An avatar is of a dataset's body.
pub(super) fn fits(avatar: &Avatar, path: &Path, dataset: &Dataset) -> anyhow::Result<()> {
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

fn write(common: &Common, fitted: Fitted, start: Instant) -> anyhow::Result<()> {
    let Fitted { avatar, curve } = fitted;
    avatar.write(&common.out)?;
    replace(&common.beside("loss.csv"), loss::csv(&curve).as_bytes())?;
    replace(&common.beside("loss.svg"), loss::svg(&curve)?.as_bytes())?;
    let checkpoint = common.beside("checkpoint");
    if checkpoint.exists() {
        std::fs::remove_file(&checkpoint).with_context(|| format!("{} can't be removed", checkpoint.display()))?;
    }
    let rows = [avatar.rotation_rows.gaussian.len(), avatar.scale_rows.gaussian.len(), avatar.color_rows.gaussian.len()];
    let last = curve.last().map_or(0.0, |point| 100.0 * point.training);
    println!(
        "{}: {} Gaussians, {} rows of rotation, {} of scale, {} of colour; {last:.1} % of the training frames' spread left; {:.1} MB; {:.0} s",
        common.out.display(),
        avatar.gaussians.len(),
        rows[0],
        rows[1],
        rows[2],
        std::fs::metadata(&common.out).map(|file| file.len() as f64 / 1e6).unwrap_or_default(),
        start.elapsed().as_secs_f64()
    );
    Ok(())
}
