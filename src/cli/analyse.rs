//! `effigy analyse`: the paper's tables and curves of a dataset, as text, CSV and charts in a
//! folder.

use crate::{
    files, fit,
    options::{self, count},
    output::OutputFolder,
    progress,
};
use effigy_core::{
    avatar::{Avatar, motion::Player},
    io::file::replace,
};
use effigy_learn::{
    Dataset, FitOptions,
    analyse::{
        components::{ComponentResult, SETTINGS, analyse_attribute},
        retained_rows,
        sweep::{AblationSweep, EACH, SweepOptions, SweepRow, TOGETHER, sweep},
        timing,
    },
    plot::{self, Plot, PlotLine},
    train::block::ATTRIBUTES,
};
use std::{
    io::Cursor,
    path::{Path, PathBuf},
};

/// Components that the curves of explained variance show.
const COMPONENTS: usize = 16;
/// Angles around the avatar that held-out frames are compared from, degrees.
const YAWS: [f64; 2] = [25.0, 205.0];

#[derive(clap::Args, Debug)]
pub struct Args {
    /// Dataset: a folder that `effigy dataset` wrote
    dataset: PathBuf,
    /// Folder to write to
    #[arg(short, long, value_name = "DIR")]
    out: OutputFolder,
    /// Also fit, once for each line of the tables of features, parts and basis rows; takes the time
    /// of about ten fits
    #[arg(long = "fit", alias = "fits")]
    is_fitted: bool,
    /// Numbers of parts to try, separated by commas
    #[arg(
        long,
        value_name = "N,N",
        value_delimiter = ',',
        default_value = "8,24,64,128",
        requires = "is_fitted"
    )]
    parts: Vec<usize>,
    /// Shares of the correctives to keep, separated by commas, 0 to 1 each: first as many of each
    /// attribute, then those that images show most
    #[arg(
        long,
        alias = "rows",
        value_name = "SHARE,SHARE",
        value_delimiter = ',',
        default_value = "0.02,0.05,0.1,0.2,0.4",
        requires = "is_fitted"
    )]
    row_shares: Vec<f64>,
    /// Learn from this clip alone, by its name in the dataset; repeat for several [default: all]
    #[arg(long, value_name = "NAME", requires = "is_fitted")]
    clip: Vec<String>,
    /// Epochs: times that the networks see every training frame, 4 to 1000000
    #[arg(long, value_name = "N", default_value = "400", value_parser = count(4, 1_000_000), requires = "is_fitted")]
    epochs: usize,
    /// Held-out frames to draw, 1 to 100000
    #[arg(long, value_name = "N", default_value = "16", value_parser = count(1, 100_000), requires = "is_fitted")]
    frames: usize,
    /// Width and height of the image, pixels
    #[arg(long, value_name = "WxH", default_value = "384x512", value_parser = options::size, requires = "is_fitted")]
    size: [u32; 2],
    /// Width and height of the frames that are timed where there is a GPU, pixels
    #[arg(long, alias = "timed", value_name = "WxH", default_value = "1024x1024", value_parser = options::size, requires = "is_fitted")]
    timing_size: [u32; 2],
    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value = "1", requires = "is_fitted")]
    seed: u64,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let dataset = Dataset::open(&args.dataset)?;
    fit::check_clips(&dataset, &args.dataset, &args.clip)?;
    files::create_folder(&args.out)?;
    let outcomes: Vec<ComponentResult> = ATTRIBUTES
        .into_iter()
        .flat_map(|attribute| analyse_attribute(&dataset, attribute))
        .collect();
    let mut text = components_table(&outcomes);
    print!("{text}");
    write_curves(&args.out, &outcomes)?;
    if args.is_fitted {
        // The fits open the dataset themselves: one copy in memory is enough.
        drop(dataset);
        text += &run_fits(&args)?;
    }
    replace(&args.out.join("analysis.txt"), text.as_bytes())?;
    Ok(())
}

/// A line per attribute and a column per setting. The outcomes of an attribute follow each other.
fn components_table(outcomes: &[ComponentResult]) -> String {
    let mut text = String::from("L1 of what principal components rebuild\n");
    text += &format!("{:12}", "");
    for setting in &SETTINGS {
        text += &format!("{:>26}", setting.name);
    }
    text += "\n";
    for row in outcomes.chunks(SETTINGS.len()) {
        text += &format!("{:12}", row[0].attribute);
        for outcome in row {
            text += &format!("{:>26.6}", outcome.l1);
        }
        text += "\n";
    }
    text
}

/// Writes the explained variance of every component as CSV, and a chart per attribute.
fn write_curves(out: &Path, outcomes: &[ComponentResult]) -> anyhow::Result<()> {
    let mut csv = String::from("attribute,setting,component,explained\n");
    for outcome in outcomes {
        for (index, share) in outcome.explained.iter().enumerate() {
            csv += &format!(
                "{},{},{},{share:.6}\n",
                outcome.attribute,
                outcome.setting.replace(',', ""),
                index + 1
            );
        }
    }
    replace(&out.join("components.csv"), csv.as_bytes())?;
    for row in outcomes.chunks(SETTINGS.len()) {
        let attribute = row[0].attribute;
        // The second setting's curve is the start of the third's.
        let lines = row
            .iter()
            .filter(|outcome| outcome.setting != SETTINGS[1].name)
            .map(explained_variance)
            .collect();
        let title = format!(
            "explained variance of the {} attribute",
            attribute.replace('_', " ")
        );
        let chart = Plot {
            title: &title,
            x: "component",
            y: "share of the variance, mean over groups",
            log: true,
            lines,
        };
        let path = out.join(format!("explained-{attribute}.svg"));
        replace(&path, plot::svg(&chart)?.as_bytes())?;
    }
    Ok(())
}

fn explained_variance(outcome: &ComponentResult) -> PlotLine {
    let shares = outcome.explained.iter().take(COMPONENTS).enumerate();
    PlotLine {
        name: outcome.setting.to_owned(),
        points: shares
            .map(|(index, &share)| (index as f64 + 1.0, share))
            .collect(),
    }
}

/// Fits with every setting, writes tables, charts and an image, and returns the table as text.
fn run_fits(args: &Args) -> anyhow::Result<String> {
    let tries = SweepOptions {
        options: FitOptions {
            epochs: args.epochs,
            seed: args.seed,
            clips: args.clip.clone(),
            ..FitOptions::default()
        },
        parts: args.parts.clone(),
        rows: args.row_shares.clone(),
        frames: args.frames,
        yaws: YAWS.to_vec(),
        size: args.size,
    };
    let bar = progress::open_ended();
    let AblationSweep {
        rows: tried,
        illustrated: shown,
    } = sweep(&args.dataset, &tries, &|step| {
        bar.set_message(step.to_owned())
    })?;
    bar.finish_and_clear();
    let dataset = Dataset::open(&args.dataset)?;
    let times = frame_times(&tried, &dataset, args.timing_size);
    let text = fits_text(&tried, &times);
    print!("{text}");
    let csv = fits_csv(&tried, &times);
    replace(&args.out.join("fits.csv"), csv.as_bytes())?;
    write_charts(&args.out, &tried)?;
    let pose = &dataset.poses[dataset.len() / 2];
    let image = retained_rows::image(&tried[shown].avatar, pose, YAWS[0], args.size);
    let background = options::color(options::BACKGROUND).unwrap_or_default();
    let mut png = Cursor::new(Vec::new());
    image
        .over(background)
        .write_to(&mut png, image::ImageFormat::Png)?;
    replace(&args.out.join("kept.png"), png.get_ref())?;
    Ok(text)
}

/// Writes the likeness of held-out frames against parts, rows and bytes, where there are points.
fn write_charts(out: &Path, tried: &[SweepRow]) -> anyhow::Result<()> {
    let retained = |x: fn(&SweepRow) -> f64| {
        vec![
            curve(tried, EACH, "as many of each attribute", x),
            curve(tried, TOGETHER, "those that images show most", x),
        ]
    };
    let parts = curve(tried, "parts, unpruned", "held-out frames", |tried| {
        tried.parts as f64
    });
    write_chart(out, "parts", "parts", vec![parts])?;
    write_chart(
        out,
        "rows",
        "rows kept",
        retained(|tried| tried.rows as f64),
    )?;
    write_chart(
        out,
        "size",
        "MB, with more and more rows kept",
        retained(|tried| tried.bytes as f64 / 1e6),
    )
}

/// The likeness of those tries whose name ends with `ending`, over `x`.
fn curve(tried: &[SweepRow], ending: &str, name: &str, x: fn(&SweepRow) -> f64) -> PlotLine {
    let mut points: Vec<(f64, f64)> = tried
        .iter()
        .filter(|tried| tried.what.ends_with(ending))
        .map(|tried| (x(tried), tried.psnr_db))
        .collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    PlotLine {
        name: name.to_owned(),
        points,
    }
}

/// Writes `name.svg`, unless its first line is a single point or none.
fn write_chart(out: &Path, name: &str, x: &str, lines: Vec<PlotLine>) -> anyhow::Result<()> {
    if lines[0].points.len() < 2 {
        return Ok(());
    }
    let chart = Plot {
        title: "likeness of held-out frames",
        x,
        y: "PSNR inside the mask's box, dB",
        log: false,
        lines,
    };
    let path = out.join(format!("{name}.svg"));
    Ok(replace(&path, plot::svg(&chart)?.as_bytes())?)
}

/// Milliseconds that a frame of each avatar takes; none where no device draws it.
fn frame_times(tried: &[SweepRow], dataset: &Dataset, size: [u32; 2]) -> Vec<Option<f64>> {
    let avatars: Vec<&Avatar> = tried.iter().map(|tried| &tried.avatar).collect();
    let player = Player::new(dataset.clip.clone(), &dataset.avatar.skeleton);
    match timing::frame_times(&avatars, &player, size) {
        Ok(timing::AvatarFrameTimes {
            device,
            median_ms: times,
        }) => {
            tracing::info!("frames of {} × {} px timed on {device}", size[0], size[1]);
            times
        }
        Err(error) => {
            tracing::warn!("no frame was timed: {error}");
            vec![None; tried.len()]
        }
    }
}

/// The tries as a table for people. `times`: of their frames, milliseconds.
fn fits_text(tried: &[SweepRow], times: &[Option<f64>]) -> String {
    let mut text = format!(
        "\nheld-out frames\n{:28}{:>7}{:>7}{:>9}{:>9}{:>10}{:>9}{:>9}{:>10}\n",
        "", "parts", "basis", "rows", "MB", "PSNR, dB", "L1", "SSIM", "frame, ms"
    );
    for (tried, ms) in tried.iter().zip(times) {
        let ms = ms.map_or("–".to_owned(), |ms| format!("{ms:.2}"));
        text += &format!(
            "{:28}{:>7}{:>7}{:>9}{:>9.2}{:>10.2}{:>9.5}{:>9.4}{ms:>10}\n",
            tried.what,
            tried.parts,
            tried.basis,
            tried.rows,
            tried.bytes as f64 / 1e6,
            tried.psnr_db,
            tried.l1,
            tried.ssim
        );
    }
    text
}

/// The tries as CSV. `times`: of their frames, milliseconds.
fn fits_csv(tried: &[SweepRow], times: &[Option<f64>]) -> String {
    let mut csv = String::from("what,parts,basis,rows,bytes,psnr_db,l1,ssim,frame_ms\n");
    for (tried, ms) in tried.iter().zip(times) {
        let ms = ms.map_or(String::new(), |ms| format!("{ms:.2}"));
        csv += &format!(
            "{},{},{},{},{},{:.4},{:.6},{:.6},{ms}\n",
            tried.what.replace(',', ""),
            tried.parts,
            tried.basis,
            tried.rows,
            tried.bytes,
            tried.psnr_db,
            tried.l1,
            tried.ssim
        );
    }
    csv
}
