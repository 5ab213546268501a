//! `effigy analyse`: a dataset goes in; the paper's tables and curves on it come out, as text, CSV and pictures in a folder.

use super::bake::count;
use super::{fit::check_clips, options};
use crate::avatar::{Avatar, file::replace, motion::Player};
use crate::fit::analyse::components::{Outcome, SETTINGS, outcomes};
use crate::fit::analyse::kept;
use crate::fit::analyse::sweep::{EACH, TOGETHER, Tried, Tries, sweep};
use crate::fit::analyse::timing;
use crate::fit::block::ATTRIBUTES;
use crate::fit::plot::{self, Chart, Line};
use crate::fit::{Dataset, Options};
use anyhow::Context;
use std::io::Cursor;
use std::path::{Path, PathBuf};

#[derive(clap::Args)]
pub struct Args {
    /// The dataset's folder
    dataset: PathBuf,
    /// The folder to write to
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Fit too, once for each line of the tables of features, parts and kept rows; takes the time of about ten fits
    #[arg(long)]
    fits: bool,
    /// Numbers of parts to try
    #[arg(long, value_delimiter = ',', default_value = "8,24,64,128", requires = "fits")]
    parts: Vec<usize>,
    /// Shares of the correctives that are kept, to try: as many of each attribute, and those that pictures show most
    #[arg(long, value_delimiter = ',', default_value = "0.02,0.05,0.1,0.2,0.4", requires = "fits")]
    rows: Vec<f64>,
    /// Fit to this clip alone; repeat for several [default: all]
    #[arg(long, value_name = "NAME", requires = "fits")]
    clip: Vec<String>,
    #[arg(long, default_value = "400", value_parser = count(4, 1_000_000), requires = "fits")]
    epochs: usize,
    /// Held-out frames that are drawn
    #[arg(long, default_value = "16", value_parser = count(1, 100_000), requires = "fits")]
    frames: usize,
    /// Width and height of the pictures, px
    #[arg(long, default_value = "384x512", value_parser = options::size, requires = "fits")]
    size: [u32; 2],
    /// Width and height of the frames that are timed, where there is a GPU, px
    #[arg(long, default_value = "1024x1024", value_parser = options::size, requires = "fits")]
    timed: [u32; 2],
    #[arg(long, default_value = "1", requires = "fits")]
    seed: u64,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let dataset = Dataset::open(&args.dataset)?;
    check_clips(&dataset, &args.dataset, &args.clip)?;
    std::fs::create_dir_all(&args.out).with_context(|| format!("cannot make {}", args.out.display()))?;
    let found: Vec<Outcome> = ATTRIBUTES.into_iter().flat_map(|attribute| outcomes(&dataset, attribute)).collect();
    let mut text = components_table(&found);
    print!("{text}");
    write_curves(&args.out, &found)?;
    if args.fits {
        drop(dataset);
        text += &fits(&args)?;
    }
    replace(&args.out.join("analysis.txt"), text.as_bytes())?;
    Ok(())
}

fn components_table(found: &[Outcome]) -> String {
    let mut text = String::from("L1 of what principal components rebuild\n");
    text += &format!("{:12}", "");
    SETTINGS.iter().for_each(|setting| text += &format!("{:>26}", setting.name));
    text += "\n";
    for row in found.chunks(SETTINGS.len()) {
        text += &format!("{:12}", row[0].attribute);
        row.iter().for_each(|outcome| text += &format!("{:>26.6}", outcome.l1));
        text += "\n";
    }
    text
}

fn write_curves(out: &Path, found: &[Outcome]) -> anyhow::Result<()> {
    let mut csv = String::from("attribute,setting,component,explained\n");
    for outcome in found {
        for (k, share) in outcome.explained.iter().enumerate() {
            csv += &format!("{},{},{},{share:.6}\n", outcome.attribute, outcome.setting.replace(',', ""), k + 1);
        }
    }
    replace(&out.join("components.csv"), csv.as_bytes())?;
    for row in found.chunks(SETTINGS.len()) {
        // The global curve is the longer one's beginning.
        let line = |outcome: &Outcome| Line {
            name: outcome.setting.to_owned(),
            points: outcome.explained.iter().take(16).enumerate().map(|(k, &share)| (k as f64 + 1.0, share)).collect(),
        };
        let lines = row.iter().filter(|outcome| outcome.setting != SETTINGS[1].name).map(line).collect();
        let title = format!("explained variance of the {} attribute", row[0].attribute.replace('_', " "));
        let chart = Chart { title: &title, x: "component", y: "share of the variance, mean over groups", log: true, lines };
        replace(&out.join(format!("explained-{}.svg", row[0].attribute)), plot::svg(&chart)?.as_bytes())?;
    }
    Ok(())
}

fn fits(args: &Args) -> anyhow::Result<String> {
    let tries = Tries {
        options: Options { epochs: args.epochs, seed: args.seed, clips: args.clip.clone(), ..Options::default() },
        parts: args.parts.clone(),
        rows: args.rows.clone(),
        frames: args.frames,
        yaws: vec![25.0, 205.0],
        size: args.size,
    };
    let (tried, shown) = sweep(&args.dataset, &tries, &|what| tracing::info!("{what}"))?;
    let dataset = Dataset::open(&args.dataset)?;
    let (text, csv) = fits_table(&tried, &times(&tried, &dataset, args.timed));
    print!("{text}");
    replace(&args.out.join("fits.csv"), csv.as_bytes())?;
    let swept = |word: &str, name: &str, of: &dyn Fn(&Tried) -> f64| {
        let mut points: Vec<(f64, f64)> = tried.iter().filter(|t| t.what.ends_with(word)).map(|t| (of(t), t.psnr_db)).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        Line { name: name.to_owned(), points }
    };
    let kept = |of: &dyn Fn(&Tried) -> f64| {
        vec![swept(EACH, "as many of each attribute", of), swept(TOGETHER, "those that pictures show most", of)]
    };
    let charts = [
        ("parts", "parts", vec![swept("parts, unpruned", "held-out frames", &|t| t.parts as f64)]),
        ("rows", "rows kept", kept(&|t| t.rows as f64)),
        ("size", "MB, with more and more rows kept", kept(&|t| t.bytes as f64 / 1e6)),
    ];
    for (name, x, lines) in charts.into_iter().filter(|(.., lines)| lines[0].points.len() > 1) {
        let chart = Chart { title: "likeness of held-out frames", x, y: "PSNR inside the mask's box, dB", log: false, lines };
        replace(&args.out.join(format!("{name}.svg")), plot::svg(&chart)?.as_bytes())?;
    }
    let picture = kept::picture(&tried[shown].avatar, &dataset.poses[dataset.len() / 2], 25.0, args.size);
    let mut bytes = Cursor::new(Vec::new());
    picture.over(options::color(options::BACKGROUND).unwrap_or_default()).write_to(&mut bytes, image::ImageFormat::Png)?;
    replace(&args.out.join("kept.png"), bytes.get_ref())?;
    Ok(text)
}

/// What a frame of each takes, ms; none where no device draws it.
fn times(tried: &[Tried], dataset: &Dataset, size: [u32; 2]) -> Vec<Option<f64>> {
    let avatars: Vec<&Avatar> = tried.iter().map(|t| &t.avatar).collect();
    let player = Player::new(dataset.clip.clone(), &dataset.avatar.skeleton);
    match timing::frame_ms(&avatars, &player, size) {
        Ok((device, times)) => {
            tracing::info!("frames of {} × {} px timed on {device}", size[0], size[1]);
            times
        }
        Err(error) => {
            tracing::warn!("no frame was timed: {error}");
            vec![None; tried.len()]
        }
    }
}

/// The tries as a table for people, and as CSV.
fn fits_table(tried: &[Tried], times: &[Option<f64>]) -> (String, String) {
    let mut text = format!(
        "\nheld-out frames\n{:28}{:>7}{:>7}{:>9}{:>9}{:>10}{:>9}{:>9}{:>10}\n",
        "", "parts", "basis", "rows", "MB", "PSNR, dB", "L1", "SSIM", "frame, ms"
    );
    let mut csv = String::from("what,parts,basis,rows,bytes,psnr_db,l1,ssim,frame_ms\n");
    for (t, ms) in tried.iter().zip(times) {
        let Tried { what, parts, basis, rows, bytes, psnr_db, l1, ssim, .. } = t;
        let [ms, csv_ms] = ["–", ""].map(|none| ms.map_or(none.to_owned(), |ms| format!("{ms:.2}")));
        text += &format!("{what:28}{parts:>7}{basis:>7}{rows:>9}{:>9.2}{psnr_db:>10.2}{l1:>9.5}{ssim:>9.4}{ms:>10}\n", *bytes as f64 / 1e6);
        csv += &format!("{},{parts},{basis},{rows},{bytes},{psnr_db:.4},{l1:.6},{ssim:.6},{csv_ms}\n", what.replace(',', ""));
    }
    (text, csv)
}
