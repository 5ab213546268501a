//! `effigy evaluate`: compares images of a learned avatar with those of its dataset or of a
//! capture, as a table.

use crate::{
    evaluate_capture::{self, CaptureArgs, Job},
    files, fit,
    options::{self, count},
    output::{JSON, Output, OutputFolder},
    picture, progress,
};
use anyhow::ensure;
use effigy_core::{
    avatar::Avatar,
    reference,
    scene::{AvatarBounds, Posed},
};
use effigy_learn::{
    Dataset,
    evaluate::{
        EvaluationPlan, Rendition, Score, camera_at, evaluate, ground_truth_image, side_by_side,
    },
    math::sampling::evenly_spaced,
};
use std::path::{Path, PathBuf};

/// A dataset has this file.
const DATASET: &str = "dataset.json";

#[derive(clap::Args, Debug)]
#[command(allow_missing_positional = true)]
pub struct Args {
    /// Learned avatar
    #[arg(required_unless_present = "pictures")]
    avatar: Option<PathBuf>,
    /// Dataset: a folder that `effigy dataset` wrote; or a capture: a folder of pictures, masks,
    /// cameras and poses
    #[arg(value_name = "DATASET|CAPTURE")]
    dataset: PathBuf,
    /// Of a dataset: width and height of the image, pixels
    #[arg(long, value_name = "WxH", default_value = "384x512", value_parser = options::size)]
    size: [u32; 2],
    /// Of a dataset: angles around the avatar, degrees, separated by commas, one camera each;
    /// pruning looks from other sides than these defaults
    #[arg(
        long,
        value_name = "DEGREES",
        value_delimiter = ',',
        default_value = "25,205",
        allow_negative_numbers = true
    )]
    yaw: Vec<f64>,
    /// Frames to draw of each clip or capture, 1 to 100000, of those held out and of the others
    #[arg(long, value_name = "N", default_value = "12", value_parser = count(1, 100_000))]
    frames: usize,
    /// Also write an image of each drawn frame to this folder, side by side: of a dataset without
    /// correctives, with them, and the ground truth; of a capture truth, avatar and error
    #[arg(long, value_name = "DIR")]
    images: Option<OutputFolder>,
    /// Also write the result as JSON
    #[arg(long, value_name = "FILE", value_parser = JSON.parser())]
    json: Option<Output>,
    #[command(flatten)]
    of_capture: CaptureArgs,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let (path, is_dataset) = (&args.avatar, args.dataset.join(DATASET).exists());
    let Some(path) = path.as_ref().filter(|_| is_dataset) else {
        ensure!(
            !is_dataset,
            "--pictures scores pictures of a capture; {} is a dataset",
            args.dataset.display()
        );
        let job = Job {
            avatar: args.avatar.as_deref(),
            capture: &args.dataset,
            frames: args.frames,
            images: args.images.as_deref(),
            json: args.json.as_ref(),
        };
        return evaluate_capture::run(&args.of_capture, &job);
    };
    let avatar = Avatar::read(path)?;
    let dataset = Dataset::open(&args.dataset)?;
    fit::check_body(&avatar, path, &dataset)?;
    let frames = frames(&dataset, args.frames);
    if let Some(folder) = &args.images {
        write_images(&dataset, &avatar, &frames, &args, folder)?;
    }
    let bar = progress::items(frames.len() as u64, "frames");
    let plan = EvaluationPlan {
        frames,
        yaws: args.yaw.clone(),
        size: args.size,
    };
    let scores = evaluate(&dataset, &avatar, &Rendition::ALL, &plan, &|done| {
        bar.set_position(done as u64)
    });
    bar.finish_and_clear();
    print!("{}", table(&scores));
    if let Some(out) = &args.json {
        out.write_json(&scores)?;
    }
    Ok(())
}

/// `count` frames of each clip's training frames, and of its held-out ones.
fn frames(dataset: &Dataset, count: usize) -> Vec<usize> {
    let mut frames = Vec::new();
    for clip in dataset.clips() {
        for held in [false, true] {
            let group: Vec<usize> = (0..dataset.len())
                .filter(|&frame| {
                    let shot = &dataset.header.frames[frame];
                    shot.clip == clip && shot.held == held
                })
                .collect();
            frames.extend(evenly_spaced(&group, count));
        }
    }
    frames
}

fn write_images(
    dataset: &Dataset,
    avatar: &Avatar,
    frames: &[usize],
    args: &Args,
    folder: &Path,
) -> anyhow::Result<()> {
    files::create_folder(folder)?;
    let neutral = Rendition::Neutral.apply(avatar);
    let avatar_bounds = AvatarBounds::new(&dataset.avatar);
    let background = options::color(options::BACKGROUND).map_err(anyhow::Error::msg)?;
    for &frame in frames {
        let posed = Posed::new(avatar, &dataset.poses[frame]);
        for &yaw in &args.yaw {
            let camera = camera_at(&avatar_bounds, &posed, yaw, args.size);
            let row = [
                reference::render(&neutral, &posed, &camera),
                reference::render(avatar, &posed, &camera),
                ground_truth_image(dataset, frame, &posed, &camera),
            ];
            let path = folder.join(format!("frame-{frame:05}-{yaw}.png"));
            picture::write(
                &side_by_side(&row).over(background),
                &Output::new(path, "png"),
            )?;
        }
    }
    Ok(())
}

/// A line per clip, group of frames and way of drawing.
fn table(scores: &[Score]) -> String {
    let mut text = format!(
        "{:16}{:10}{:24}{:>9}{:>10}{:>10}{:>9}\n",
        "clip", "frames", "drawn", "images", "L1", "PSNR, dB", "SSIM"
    );
    for score in scores {
        let group = if score.held { "held out" } else { "training" };
        text += &format!(
            "{:16}{group:10}{:24}{:>9}{:>10.5}{:>10.2}{:>9.4}\n",
            score.clip,
            score.rendition,
            score.images,
            score.mean.l1,
            score.mean.psnr_db,
            score.mean.ssim
        );
    }
    text
}
