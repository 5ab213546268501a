//! The part of `effigy import` that distils an avatar from mmlphuman's checkpoint.

use crate::{
    budget::BudgetArgs,
    files::print_assumptions,
    options::{self, count},
    progress,
};
use anyhow::ensure;
use effigy_core::avatar::{Clip, Pose, Skeleton, limits};
use effigy_formats::{
    mmlphuman::{Checkpoint, Options},
    open::{self, ClipOptions},
};
use effigy_learn::distil::{
    Difference, DistilOptions, Distilled, Likeness, MIN_POSES, SampleOptions, distil,
};
use glam::DVec3;
use std::path::{Path, PathBuf};

/// How to distil, where the user says.
#[derive(clap::Args, Clone, Copy, Debug, Default, PartialEq)]
#[command(
    next_help_heading = "Of mmlphuman's checkpoint, to which an avatar is fitted \
    [defaults: --samples 500 --epochs 100 --basis 16 --seed 1 --reach 0.008 --hips 25]"
)]
pub struct DistilArgs {
    /// Training poses at which the checkpoint is evaluated, 16 to 100000, and half as many between
    /// them
    #[arg(long, value_name = "N", value_parser = count(16, 100_000))]
    samples: Option<usize>,
    /// Epochs: times that the networks see every training frame, 4 to 1000000
    #[arg(long, value_name = "N", value_parser = count(4, 1_000_000))]
    epochs: Option<usize>,
    /// Basis functions of each part, a multiple of 4 from 4 to 32, for attributes and for nodes
    #[arg(long, value_name = "N", value_parser = count(4, limits::BASIS))]
    basis: Option<usize>,
    #[command(flatten)]
    budget: BudgetArgs,
    /// Seed of the random numbers
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// How far a Gaussian may be from where it was placed, 0 to 1 metre
    #[arg(long, value_name = "METRES", value_parser = reach)]
    reach: Option<f64>,
    /// How far outwards both hips turn in the canonical pose, -180 to 180 degrees
    #[arg(long, value_name = "DEGREES", value_parser = hips, allow_hyphen_values = true)]
    hips: Option<f64>,
}

fn reach(text: &str) -> Result<f64, String> {
    options::number(text, 0.0, 1.0, "number of metres")
}

fn hips(text: &str) -> Result<f64, String> {
    options::number(text, -180.0, 180.0, "number of degrees")
}

impl DistilArgs {
    /// Whether the user says anything.
    pub fn is_given(&self) -> bool {
        *self != Self::default()
    }

    /// What the file leaves open. `rest`: what other options say.
    pub fn file_options(&self, rest: Options) -> Options {
        Options {
            reach: self.reach.unwrap_or(rest.reach),
            hips: self.hips.unwrap_or(rest.hips),
            ..rest
        }
    }

    fn options(&self, gaussians: usize) -> DistilOptions {
        let poses = self.samples.unwrap_or(500);
        let seed = self.seed.unwrap_or(1);
        DistilOptions {
            samples: SampleOptions {
                poses,
                between: poses / 2,
                seed,
            },
            basis: self.basis.unwrap_or(16),
            epochs: self.epochs.unwrap_or(100),
            budget: self.budget.budget(gaussians),
            seed,
        }
    }
}

/// What to distil.
pub struct Job<'a> {
    /// The checkpoint.
    pub file: &'a Path,
    /// Files with more training poses.
    pub trained: &'a [PathBuf],
    /// How these are read.
    pub clips: &'a ClipOptions,
    /// What the checkpoint leaves open.
    pub options: Options,
}

/// Distils an avatar.
pub fn run(args: &DistilArgs, job: &Job) -> anyhow::Result<Distilled> {
    let basis = args.basis.unwrap_or(16);
    ensure!(
        basis.is_multiple_of(4),
        "--basis {basis} is not a multiple of 4"
    );
    open::checkpoint(job.file, &job.options, |checkpoint| {
        fit(args, job, &checkpoint)
    })?
}

fn fit(args: &DistilArgs, job: &Job, checkpoint: &Checkpoint) -> anyhow::Result<Distilled> {
    print_assumptions(job.file, &checkpoint.assumptions);
    let mut trained = Vec::new();
    for path in job.trained {
        let clip = open::clip_of(path, &checkpoint.skeleton, job.clips)?.clip;
        trained.extend(poses(&clip, &checkpoint.skeleton));
    }
    let all = checkpoint.poses.len() + trained.len();
    ensure!(
        all >= MIN_POSES,
        "{}: found {all} training poses, expected at least {MIN_POSES}: `effigy import --trained` \
         reads some",
        job.file.display()
    );
    let options = args.options(checkpoint.len());
    let bar = progress::items(options.epochs as u64, "epochs");
    let name = job.file.file_stem().unwrap_or_default().to_string_lossy();
    let distilled = distil(checkpoint, &name, &trained, &options, &|done, what| {
        bar.set_position(done as u64);
        bar.set_message(what.to_owned());
    });
    bar.finish_and_clear();
    distilled.map_err(|error| anyhow::anyhow!("{}: {error}", job.file.display()))
}

/// The poses of a clip, in a skeleton's order of joints.
fn poses(clip: &Clip, skeleton: &Skeleton) -> Vec<Pose> {
    let map = clip.map_to(skeleton);
    let pose = |frame| {
        let pose = clip.frame(frame);
        let rotation = |joint: &Option<usize>| joint.map_or(DVec3::ZERO, |at| pose.rotation[at]);
        Pose {
            rotation: map.iter().map(rotation).collect(),
            ..Pose::rest(0, 0)
        }
    };
    (0..clip.frames()).map(pose).collect()
}

/// How like the checkpoint an avatar is, and what is left out: a line each.
pub fn likeness(likeness: &Likeness) -> String {
    let row = |name: &str, own: &Difference, left: f64| {
        let decibels = |found: Option<f64>| found.map_or("–".into(), |db| format!("{db:.1}"));
        format!(
            "  {name}: {:.2} mm, scale {:.1} %, colour {:.1} of 255, images {} dB ({} from those without view-dependent colour; {} without correctives); {:.1} % of the variance left\n",
            1e3 * own.position,
            100.0 * own.log_scale,
            255.0 * own.color,
            decibels(own.psnr_db),
            decibels(own.diffuse_db),
            decibels(own.neutral_db),
            100.0 * left,
        )
    };
    let [learned, held] = likeness.unexplained;
    let left_out = format!(
        "left out: view-dependent colour (rms {:.1} of 255), opacity that follows the pose (rms {:.1} of 255), {:.1} % of the joints' weights, beyond four a Gaussian",
        255.0 * likeness.harmonics_lost,
        255.0 * likeness.opacity_lost,
        100.0 * likeness.skin_lost
    );
    "root mean square differences from the checkpoint:\n".to_owned()
        + &row("poses that it learned", &likeness.learned, learned)
        + &row("poses that were held out", &likeness.held, held)
        + &left_out
}
