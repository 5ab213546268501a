//! Fits with one thing changed at a time, and how alike held-out frames are to the truth: local against global features, pruned or not,
//! numbers of parts and of kept rows (the paper's ablations).

use super::regroup::regroup;
use crate::avatar::Avatar;
use crate::fit::Budget;
use crate::fit::dataset::{Dataset, Error};
use crate::fit::evaluate::{Plan, Way, scores, some};
use crate::fit::run::{Options, fit, prune};
use serde::Serialize;
use std::path::Path;

/// The two ways to choose the rows that are kept, as the tables call them: by variance, as many of each attribute, and by what pictures
/// would lose.
pub const EACH: &str = "each alike";
pub const TOGETHER: &str = "as shown";

/// What to try.
#[derive(Clone, Debug)]
pub struct Tries {
    pub options: Options,
    /// Numbers of parts.
    pub parts: Vec<usize>,
    /// Kept rows, shares of all; each is tried twice, as many rows of each attribute and the rows that pictures show most.
    pub rows: Vec<f64>,
    /// Held-out frames that are drawn.
    pub frames: usize,
    pub yaws: Vec<f64>,
    pub size: [u32; 2],
}

/// What a try came to.
#[derive(Clone, Debug, Serialize)]
pub struct Tried {
    pub what: String,
    pub parts: usize,
    pub basis: usize,
    /// Kept rows of all attributes together.
    pub rows: usize,
    /// Of the avatar's tensors.
    pub bytes: usize,
    /// Over held-out frames: mean PSNR, dB, L1 and SSIM.
    pub psnr_db: f64,
    pub l1: f64,
    pub ssim: f64,
    /// The avatar as it was drawn.
    #[serde(skip)]
    pub avatar: Avatar,
}

/// Judges an avatar on held-out frames of the clips that it was fitted to.
fn judge(dataset: &Dataset, avatar: &Avatar, tries: &Tries, way: Way, what: String) -> Tried {
    let wanted = |f: usize| {
        let shot = &dataset.header.frames[f];
        shot.held && (tries.options.clips.is_empty() || tries.options.clips.contains(&shot.clip))
    };
    let held: Vec<usize> = (0..dataset.len()).filter(|&f| wanted(f)).collect();
    let plan = Plan { frames: some(&held, tries.frames), yaws: tries.yaws.clone(), size: tries.size };
    let scores = scores(dataset, avatar, &[way], &plan, &|_| ());
    let pictures: usize = scores.iter().map(|s| s.pictures).sum();
    let mean = |of: &dyn Fn(&crate::measure::similarity::Similarity) -> f64| {
        scores.iter().map(|s| s.pictures as f64 * of(&s.mean)).sum::<f64>() / pictures.max(1) as f64
    };
    let drawn = way.avatar(avatar);
    Tried {
        what,
        parts: avatar.parts.len(),
        basis: avatar.basis_len(),
        rows: drawn.rotation_rows.gaussian.len() + drawn.scale_rows.gaussian.len() + drawn.color_rows.gaussian.len(),
        bytes: drawn.tensors().iter().map(|tensor| tensor.bytes).sum(),
        psnr_db: mean(&|s| s.psnr_db),
        l1: mean(&|s| s.l1),
        ssim: mean(&|s| s.ssim),
        avatar: drawn,
    }
}

/// All tries, each told to `hear` when it begins; and which of them shows what is kept: a tenth of the rows, or all where that is not tried.
///
/// # Errors
/// When the dataset cannot be read again.
pub fn sweep(folder: &Path, tries: &Tries, hear: &(dyn Fn(&str) + Sync)) -> Result<(Vec<Tried>, usize), Error> {
    let dataset = Dataset::open(folder)?;
    let mut tried = Vec::new();
    let whole = Options { budget: None, ..tries.options.clone() };
    let fitted = |dataset: &Dataset, options: &Options, what: &str| {
        hear(what);
        fit(dataset, options, &|_, _| ())
    };
    let local = fitted(&dataset, &whole, "local features")?.avatar;
    tried.push(judge(&dataset, &local, tries, Way::Neutral, "no correctives".into()));
    tried.push(judge(&dataset, &local, tries, Way::Learned, format!("local {}, unpruned", whole.basis)));
    let count = dataset.avatar.gaussians.len();
    let mut shown = tried.len() - 1;
    for &share in &tries.rows {
        let rows = (share * count as f64).round() as usize;
        for (budget, how) in [(Budget::Rows(rows), EACH), (Budget::Shown(3 * rows), TOGETHER)] {
            let what = format!("{:.0} % of rows, {how}", 100.0 * share);
            hear(&what);
            let pruned = prune(&dataset, &local, &Options { budget: Some(budget), ..tries.options.clone() }, &|_, _| ())?.avatar;
            if share == 0.1 {
                shown = tried.len();
            }
            tried.push(judge(&dataset, &pruned, tries, Way::Learned, what));
        }
    }
    for basis in [16, 64] {
        let dataset = regroup(Dataset::open(folder)?, 1);
        let global = fitted(&dataset, &Options { basis, ..whole.clone() }, "global features")?.avatar;
        tried.push(judge(&dataset, &global, tries, Way::Learned, format!("global {basis}, unpruned")));
    }
    for &parts in &tries.parts {
        let dataset = regroup(Dataset::open(folder)?, parts);
        let avatar = fitted(&dataset, &whole, &format!("{parts} parts"))?.avatar;
        tried.push(judge(&dataset, &avatar, tries, Way::Learned, format!("{parts} parts, unpruned")));
    }
    Ok((tried, shown))
}
