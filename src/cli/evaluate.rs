//! `effigy evaluate`: a learned avatar and a dataset go in; how alike their pictures are comes out as a table.

use super::bake::{bar, count};
use super::{fit::fits, options};
use crate::avatar::{Avatar, file::replace};
use crate::fit::Dataset;
use crate::fit::analyse::kept::beside;
use crate::fit::evaluate::{Plan, Score, Way, camera, scores, some, truth};
use crate::frame::{Extent, Posed};
use crate::reference;
use anyhow::Context;
use std::path::{Path, PathBuf};

#[derive(clap::Args)]
pub struct Args {
    /// The learned avatar
    avatar: PathBuf,
    /// The dataset's folder
    dataset: PathBuf,
    /// Width and height of the pictures, px
    #[arg(long, default_value = "384x512", value_parser = options::size)]
    size: [u32; 2],
    /// Degrees around the avatar, a camera each; pruning looks from other sides than the default's
    #[arg(long, value_delimiter = ',', default_value = "25,205", allow_negative_numbers = true)]
    yaw: Vec<f64>,
    /// Frames of each clip that are drawn, of those held out and of the others
    #[arg(long, default_value = "12", value_parser = count(1, 100_000))]
    frames: usize,
    /// Write a picture of each drawn frame to this folder: without correctives, with them, and the truth, side by side
    #[arg(long, value_name = "DIR")]
    pictures: Option<PathBuf>,
    /// Write the table as JSON too
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let avatar = Avatar::read(&args.avatar)?;
    let dataset = Dataset::open(&args.dataset)?;
    fits(&avatar, &args.avatar, &dataset)?;
    let mut frames = Vec::new();
    for clip in dataset.clips() {
        for held in [false, true] {
            let own: Vec<usize> =
                (0..dataset.len()).filter(|&f| dataset.header.frames[f].clip == clip && dataset.header.frames[f].held == held).collect();
            frames.extend(some(&own, args.frames));
        }
    }
    if let Some(folder) = &args.pictures {
        pictures(&dataset, &avatar, &frames, &args, folder)?;
    }
    let bar = bar(frames.len() as u64)?;
    let plan = Plan { frames, yaws: args.yaw.clone(), size: args.size };
    let scores = scores(&dataset, &avatar, &Way::ALL, &plan, &|done| bar.set_position(done as u64));
    bar.finish_and_clear();
    print!("{}", table(&scores));
    if let Some(path) = &args.json {
        replace(path, serde_json::to_string_pretty(&scores)?.as_bytes())?;
    }
    Ok(())
}

fn pictures(dataset: &Dataset, avatar: &Avatar, frames: &[usize], args: &Args, folder: &Path) -> anyhow::Result<()> {
    std::fs::create_dir_all(folder).with_context(|| format!("cannot make {}", folder.display()))?;
    let neutral = Way::Neutral.avatar(avatar);
    let extent = Extent::new(&dataset.avatar);
    let background = options::color(options::BACKGROUND).map_err(anyhow::Error::msg)?;
    for &frame in frames {
        let posed = Posed::new(avatar, &dataset.poses[frame]);
        for &yaw in &args.yaw {
            let camera = camera(&extent, &posed, yaw, args.size);
            let row = [
                reference::render(&neutral, &posed, &camera),
                reference::render(avatar, &posed, &camera),
                truth(dataset, frame, &posed, &camera),
            ];
            let path = folder.join(format!("frame-{frame:05}-{yaw}.png"));
            beside(&row).over(background).save(&path).with_context(|| format!("{} can't be written", path.display()))?;
        }
    }
    Ok(())
}

/// A line a group and way.
fn table(scores: &[Score]) -> String {
    let mut text = format!("{:16}{:10}{:24}{:>9}{:>10}{:>10}{:>9}\n", "clip", "frames", "drawn", "pictures", "L1", "PSNR, dB", "SSIM");
    for s in scores {
        let held = if s.held { "held out" } else { "training" };
        let (l1, psnr, ssim) = (s.mean.l1, s.mean.psnr_db, s.mean.ssim);
        text += &format!("{:16}{held:10}{:24}{:>9}{l1:>10.5}{psnr:>10.2}{ssim:>9.4}\n", s.clip, s.way, s.pictures);
    }
    text
}
