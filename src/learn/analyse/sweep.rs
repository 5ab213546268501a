//! Fits with one thing changed at a time, and how alike their held-out frames are to the ground
//! truth: local against global features, pruned or not, numbers of parts and of retained rows (the
//! paper's ablations).

use crate::analyse::regroup::regroup;
use crate::dataset::{Dataset, LearnError};
use crate::evaluate::{EvaluationPlan, Rendition, evaluate};
use crate::fit::{Budget, FitOptions, fit, prune};
use crate::math::sampling::evenly_spaced;
use effigy_core::avatar::Avatar;
use effigy_measure::similarity::Similarity;
use serde::Serialize;
use std::path::Path;

/// How the tables call a budget that retains as many rows of each attribute.
pub const EACH: &str = "each alike";
/// How the tables call a budget that retains the rows that images would lose most without.
pub const TOGETHER: &str = "as shown";
/// The share of rows whose avatar illustrates which rows are retained.
const ILLUSTRATED_SHARE: f64 = 0.1;
/// Features of the fits with a single part.
const GLOBAL_BASES: [usize; 2] = [16, 64];

/// The fits to run.
#[derive(Clone, Debug)]
pub struct SweepOptions {
    /// The options of every fit, except for those that it changes.
    pub options: FitOptions,
    /// Numbers of parts.
    pub parts: Vec<usize>,
    /// Retained rows, as shares of all. Each is tried twice: [`EACH`] and [`TOGETHER`].
    pub rows: Vec<f64>,
    /// Held-out frames that are drawn.
    pub frames: usize,
    /// Degrees around the avatar, a camera each.
    pub yaws: Vec<f64>,
    /// Width and height of the images, px.
    pub size: [u32; 2],
}

/// One fit's size, and its mean likeness to held-out frames.
#[derive(Clone, Debug, Serialize)]
pub struct SweepRow {
    /// The change that the table names.
    pub what: String,
    /// N_G.
    pub parts: usize,
    /// N_B.
    pub basis: usize,
    /// Retained rows of all attributes together.
    pub rows: usize,
    /// Of the avatar's tensors.
    pub bytes: usize,
    /// Mean PSNR, dB.
    pub psnr_db: f64,
    /// Mean absolute difference, 0 to 1.
    pub l1: f64,
    /// Mean structural similarity, at most 1.
    pub ssim: f64,
    /// The avatar as it was drawn.
    #[serde(skip)]
    pub avatar: Avatar,
}

/// The result of a sweep.
pub struct AblationSweep {
    /// In the order of the table.
    pub rows: Vec<SweepRow>,
    /// The row whose avatar illustrates which rows are retained: a tenth of all, or all if that was
    /// not tried.
    pub illustrated: usize,
}

/// Runs all fits. `announce` is called with the name of each one that begins.
///
/// # Errors
/// When the dataset cannot be read again.
pub fn sweep(
    folder: &Path,
    options: &SweepOptions,
    announce: &(dyn Fn(&str) + Sync),
) -> Result<AblationSweep, LearnError> {
    let dataset = Dataset::open(folder)?;
    let unpruned = FitOptions {
        budget: None,
        ..options.options.clone()
    };
    let fit_unpruned = |dataset: &Dataset, basis: usize, what: &str| {
        announce(what);
        let options = FitOptions {
            basis,
            ..unpruned.clone()
        };
        fit(dataset, &options, &|_, _| ()).map(|fitted| fitted.avatar)
    };
    let learned = Rendition::Learned;
    let basis = unpruned.basis;

    let local = fit_unpruned(&dataset, basis, "local features")?;
    let what = String::from("no correctives");
    let neutral = judge(&dataset, &local, options, Rendition::Neutral, what);
    let what = format!("local {basis}, unpruned");
    let whole = judge(&dataset, &local, options, learned, what);
    let mut rows = vec![neutral, whole];
    let mut illustrated = 1;

    let count = dataset.avatar.gaussians.len();
    for &share in &options.rows {
        let retained = (share * count as f64).round() as usize;
        for (budget, how) in [
            (Budget::Rows(retained), EACH),
            (Budget::Contribution(3 * retained), TOGETHER),
        ] {
            let what = format!("{:.0} % of rows, {how}", 100.0 * share);
            announce(&what);
            let budgeted = FitOptions {
                budget: Some(budget),
                ..options.options.clone()
            };
            let pruned = prune(&dataset, &local, &budgeted, &|_, _| ())?.avatar;
            if share == ILLUSTRATED_SHARE {
                illustrated = rows.len();
            }
            rows.push(judge(&dataset, &pruned, options, learned, what));
        }
    }
    for basis in GLOBAL_BASES {
        let dataset = regroup(Dataset::open(folder)?, 1);
        let avatar = fit_unpruned(&dataset, basis, "global features")?;
        let what = format!("global {basis}, unpruned");
        rows.push(judge(&dataset, &avatar, options, learned, what));
    }
    for &parts in &options.parts {
        let dataset = regroup(Dataset::open(folder)?, parts);
        let avatar = fit_unpruned(&dataset, basis, &format!("{parts} parts"))?;
        let what = format!("{parts} parts, unpruned");
        rows.push(judge(&dataset, &avatar, options, learned, what));
    }
    Ok(AblationSweep { rows, illustrated })
}

/// Judges an avatar on held-out frames of the clips that it was fitted to.
fn judge(
    dataset: &Dataset,
    avatar: &Avatar,
    options: &SweepOptions,
    rendition: Rendition,
    what: String,
) -> SweepRow {
    let clips = &options.options.clips;
    let is_judged = |&f: &usize| {
        let shot = &dataset.header.frames[f];
        shot.held && (clips.is_empty() || clips.contains(&shot.clip))
    };
    let held_out: Vec<usize> = (0..dataset.len()).filter(is_judged).collect();
    let plan = EvaluationPlan {
        frames: evenly_spaced(&held_out, options.frames),
        yaws: options.yaws.clone(),
        size: options.size,
    };
    let scores = evaluate(dataset, avatar, &[rendition], &plan, &|_| ());
    let images: usize = scores.iter().map(|score| score.images).sum();
    let mean = |number: &dyn Fn(&Similarity) -> f64| {
        scores
            .iter()
            .map(|score| score.images as f64 * number(&score.mean))
            .sum::<f64>()
            / images.max(1) as f64
    };
    let drawn = rendition.apply(avatar);
    SweepRow {
        what,
        parts: avatar.parts.len(),
        basis: avatar.basis_len(),
        rows: drawn.rotation_rows.gaussian.len()
            + drawn.scale_rows.gaussian.len()
            + drawn.color_rows.gaussian.len(),
        bytes: drawn.tensors().iter().map(|tensor| tensor.bytes).sum(),
        psnr_db: mean(&|similarity| similarity.psnr_db),
        l1: mean(&|similarity| similarity.l1),
        ssim: mean(&|similarity| similarity.ssim),
        avatar: drawn,
    }
}
