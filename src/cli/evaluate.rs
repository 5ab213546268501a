//! `effigy evaluate`: an avatar, or another program's pictures, against what a capture's cameras
//! saw.

use crate::{
    assets, evaluate_video, files,
    options::{self, DeviceArgs, count, named},
    output::{JSON, Output, OutputFolder, PNG},
    picture, progress,
    source::PoseProjection,
};
use anyhow::{bail, ensure};
use effigy_capture::Capture;
use effigy_core::{avatar::Avatar, scene::FrameImage};
use effigy_learn::score::{
    AS_GIVEN, Ground, Means, PictureIndex, Region, ScoreReport, ScoredImages, ScoredView, Scorer,
    ViewChoice, ViewScore, choose,
};
use effigy_perceptual::{Network, Perceptual, Planes};
use effigy_render::vulkan::Gpu;
use effigy_train::{
    recipe::Preset,
    refit::{REFITTED, refit},
};
use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

/// An error of so much, 0 to 1, is white in maps of errors.
const WHITE: f32 = 0.3;

#[derive(clap::Args, Debug)]
#[command(allow_missing_positional = true)]
pub struct Args {
    /// Learned avatar
    #[arg(required_unless_present = "pictures")]
    avatar: Option<PathBuf>,
    /// Capture: a folder of pictures, masks, cameras and poses
    capture: PathBuf,
    /// Frames of each kind, held out or not, 1 to 100000
    #[arg(long, value_name = "N", default_value = "12", value_parser = count(1, 100_000))]
    frames: usize,
    /// Also write truth, avatar and error of each picture to this folder, side by side
    #[arg(long, value_name = "DIR")]
    images: Option<OutputFolder>,
    /// Also write the result as JSON
    #[arg(long, value_name = "FILE", value_parser = JSON.parser())]
    json: Option<Output>,
    /// Score these pictures of another program in place of an avatar's; the folder
    /// has CAMERA/00000000.png, as large as the capture's and without a lens's distortion, with
    /// alpha or over --background
    #[arg(long, value_name = "DIR", conflicts_with = "avatar")]
    pictures: Option<PathBuf>,
    /// Also write every frame of the first held-out camera as an animated PNG: truth,
    /// avatar, error
    #[arg(long, value_name = "FILE", value_parser = PNG.parser())]
    video: Option<Output>,
    /// Cameras of each kind, held out or not, 1 to 1000
    #[arg(long, value_name = "N", default_value = "4", value_parser = count(1, 1000))]
    cameras: usize,
    /// Also compare pictures that training saw
    #[arg(long)]
    training: bool,
    /// `truth` puts the picture's own background under the avatar, a colour of six
    /// hexadecimal digits lies under both
    #[arg(long, value_name = "truth|RRGGBB", default_value = "truth", value_parser = ground)]
    background: Ground,
    /// Fit the poses of the compared frames to their pictures first, those of cameras
    /// that are not held out, with the avatar as it is. Its numbers can't be set beside those of
    /// poses as given
    #[arg(long, requires = "avatar")]
    refit: bool,
    /// Whether the networks see the nearest pose that the avatar was trained for, within 2σ along
    /// each principal component of its training poses; off: the pose itself
    #[arg(long, value_enum, default_value_t = PoseProjection::On)]
    project: PoseProjection,
    /// ST-LPIPS by its network, alex or vgg, or LPIPS [default: alex, or none without
    /// its weights]
    #[arg(long, value_parser = named(LOSS_NAMES, LOSSES))]
    perceptual: Option<Loss>,
    /// Folder that tools/fetch_perceptual.sh filled
    #[arg(long, value_name = "DIR", env = "EFFIGY_ASSETS", default_value_os_t = assets::folder())]
    weights: PathBuf,
    #[command(flatten)]
    device: DeviceArgs,
}

/// A perceptual distance by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Loss {
    Of(Network),
    None,
}

const LOSS_NAMES: [&str; 5] = ["alex", "vgg", "lpips-alex", "lpips-vgg", "none"];
const LOSSES: [Loss; 5] = [
    Loss::Of(Network::Alex),
    Loss::Of(Network::Vgg),
    Loss::Of(Network::LpipsAlex),
    Loss::Of(Network::LpipsVgg),
    Loss::None,
];

fn ground(text: &str) -> Result<Ground, String> {
    if text == "truth" {
        return Ok(Ground::Truth);
    }
    Ok(Ground::Color(options::color(text)?))
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let args = &args;
    let mut capture = Capture::read(&args.capture)?;
    files::print_assumptions(&args.capture, &capture.assumptions);
    if !capture.masks.faults.is_empty() {
        eprintln!("masks: {}", capture.masks);
    }
    let avatar = match &args.avatar {
        Some(path) => Some(args.project.apply(fitting(path, &capture)?)),
        None => None,
    };
    let candidate = match (&avatar, &args.pictures) {
        (Some(avatar), _) => ScoredImages::Avatar(avatar),
        (None, Some(folder)) => ScoredImages::Pictures(folder),
        (None, None) => bail!("neither an avatar nor --pictures: there is nothing to evaluate"),
    };
    let perceptual = perceptual(args)?;
    let is_held = capture.cameras.iter().any(|camera| camera.held)
        || capture.frames.iter().any(|frame| frame.held);
    if !is_held {
        eprintln!("nothing is held out: all pictures count as training's (split.json names some)");
    }
    let views = choose(
        &capture,
        &ViewChoice {
            cameras: args.cameras,
            frames: args.frames,
            training: args.training || !is_held,
        },
    );
    ensure!(
        !views.is_empty(),
        "{}: no picture of a held-out camera or frame; --training compares the others",
        args.capture.display()
    );
    if let Some(folder) = &args.images {
        files::create_folder(folder)?;
    }
    let poses = match &avatar {
        Some(avatar) if args.refit => {
            capture = refitted(capture, avatar, &views, args)?;
            REFITTED
        }
        _ => AS_GIVEN,
    };
    let poses = match args.project {
        PoseProjection::On => poses.into(),
        PoseProjection::Off => format!("{poses}, not projected"),
    };
    let scorer =
        Scorer::new(&capture, candidate, args.background, perceptual.as_ref()).with_poses(poses);
    let scores = scores(&scorer, &views, args)?;
    let left_out = views.len() - scores.len();
    let report = ScoreReport::new(scorer.protocol(), scores);
    print!("{}", table(&report));
    if left_out > 0 {
        println!("{left_out} of {} pictures are left out", views.len());
    }
    if let Some(out) = &args.json {
        out.write_json(&report)?;
    }
    if let Some(path) = &args.video {
        evaluate_video::write(path, &scorer, errors)?;
    }
    Ok(())
}

/// Compares every view that the candidate has, and writes its images if they were asked for.
fn scores(scorer: &Scorer, views: &[PictureIndex], args: &Args) -> anyhow::Result<Vec<ViewScore>> {
    let bar = progress::items(views.len() as u64, "pictures");
    let mut scores = Vec::new();
    for &view in views {
        // Another program may not have drawn all of them.
        match scorer.compare(view) {
            Ok(Some(compared)) => {
                let score = scorer.named(view, &compared);
                if let Some(folder) = &args.images {
                    write_image(folder, &score, &compared)?;
                }
                scores.push(score);
            }
            Ok(None) => {}
            Err(error) => progress::say(&bar, format_args!("{error}")),
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    ensure!(
        !scores.is_empty(),
        "no picture could be compared: {} are left out",
        views.len()
    );
    Ok(scores)
}

/// The capture with poses of the frames of some views that fit their pictures.
fn refitted(
    capture: Capture,
    avatar: &Avatar,
    views: &[PictureIndex],
    args: &Args,
) -> anyhow::Result<Capture> {
    let mut frames: Vec<usize> = views.iter().map(|view| view.frame).collect();
    if args.video.is_some() {
        frames.extend(
            evaluate_video::views(&capture)
                .iter()
                .map(|view| view.frame),
        );
    }
    frames.sort_unstable();
    frames.dedup();
    let gpu = Gpu::new(&args.device.gpu())?;
    let capture = Arc::new(capture);
    let data = Preset::Quick.recipe().data;
    let bar = progress::items(frames.len() as u64, "poses");
    let poses = refit(&gpu, avatar, &capture, &frames, &data, |done| {
        bar.set_position(done as u64);
    })?;
    bar.finish_and_clear();
    let mut capture = Arc::unwrap_or_clone(capture);
    let left = poses.iter().filter(|pose| pose.is_none()).count();
    if left > 0 {
        eprintln!(
            "{left} of {} frames have no picture of a camera that is not held out: their poses are \
             as given",
            frames.len()
        );
    }
    for (&frame, pose) in frames.iter().zip(poses) {
        if let Some(pose) = pose {
            capture.frames[frame].pose = pose;
        }
    }
    Ok(capture)
}

/// Reads an avatar and refuses one with another skeleton.
fn fitting(path: &Path, capture: &Capture) -> anyhow::Result<Avatar> {
    let avatar = Avatar::read(path)?;
    let own = &capture.template.skeleton;
    ensure!(
        avatar.skeleton.name == own.name && avatar.skeleton.parent == own.parent,
        "{}: found a skeleton of {} joints from {}, expected the capture's: {} from {}",
        path.display(),
        avatar.skeleton.len(),
        avatar.skeleton.name.first().map_or("", String::as_str),
        own.len(),
        own.name.first().map_or("", String::as_str)
    );
    Ok(avatar)
}

/// The network that was asked for, checked.
fn perceptual(args: &Args) -> anyhow::Result<Option<Perceptual>> {
    let network = match args.perceptual {
        Some(Loss::None) => return Ok(None),
        Some(Loss::Of(network)) => network,
        None => Network::Alex,
    };
    if args.perceptual.is_none() && network.missing(&args.weights).is_some() {
        eprintln!(
            "without ST-LPIPS: {} lacks its weights, which tools/fetch_perceptual.sh gets",
            args.weights.display()
        );
        return Ok(None);
    }
    let perceptual = Perceptual::read(network, &args.weights)?;
    perceptual.check()?;
    Ok(Some(perceptual))
}

/// Truth, candidate and error side by side.
fn write_image(folder: &Path, score: &ViewScore, compared: &ScoredView) -> anyhow::Result<()> {
    let row = [
        image(&compared.truth),
        image(&compared.image),
        image(&errors(&compared.truth, &compared.image)),
    ];
    let path = folder.join(format!("{}-{:08}.png", score.camera, score.frame));
    picture::write(
        &side_by_side(&row).over([0.0; 3]),
        &Output::new(path, "png"),
    )
}

/// Images of one size in a row, as one image.
fn side_by_side(images: &[FrameImage; 3]) -> FrameImage {
    let [width, height] = images[0].size;
    let mut pixels = Vec::with_capacity(images.len() * (width * height) as usize);
    for y in 0..height {
        for image in images {
            pixels.extend_from_slice(&image.pixels[(y * width) as usize..][..width as usize]);
        }
    }
    FrameImage {
        size: [width * images.len() as u32, height],
        pixels,
    }
}

fn image(planes: &Planes) -> FrameImage {
    let mut image = FrameImage::empty(planes.size.map(|side| side as u32));
    let plane = image.pixels.len();
    for (at, pixel) in image.pixels.iter_mut().enumerate() {
        let color = |channel: usize| planes.data[channel * plane + at];
        *pixel = [color(0), color(1), color(2), 1.0];
    }
    image
}

/// The largest error of a pixel's channels: black, red, yellow, and white from [`WHITE`].
fn errors(truth: &Planes, image: &Planes) -> Planes {
    let plane = truth.size[0] * truth.size[1];
    let mut errors = Planes::black(truth.size);
    for at in 0..plane {
        let error = |channel: usize| {
            let at = channel * plane + at;
            (truth.data[at] - image.data[at]).abs()
        };
        let error = error(0).max(error(1)).max(error(2)) / WHITE;
        for channel in 0..3 {
            errors.data[channel * plane + at] = (3.0 * error - channel as f32).clamp(0.0, 1.0);
        }
    }
    errors
}

/// The protocol, then a line for each group and region.
fn table(report: &ScoreReport) -> String {
    let protocol = &report.protocol;
    let perceptual = protocol.perceptual.as_deref().unwrap_or("ST-LPIPS");
    let mut text = format!(
        "inside {}; behind the person: {}; poses {}\n{:28}{:8}{:>9}{:>10}{:>9}{:>10}{:>18}\n",
        protocol.area,
        protocol.background,
        protocol.poses,
        "group",
        "region",
        "pictures",
        "PSNR, dB",
        "SSIM",
        "L1",
        perceptual
    );
    for group in &report.groups {
        text += &line(group.name, "whole", &group.whole);
        for region in Region::ALL {
            if let Some(means) = group.regions.get(&region) {
                text += &line("", region.name(), means);
            }
        }
    }
    text
}

fn line(group: &str, region: &str, means: &Means) -> String {
    let distance = means.st_lpips.or(means.lpips);
    let distance = distance.map_or("-".into(), |d| format!("{d:.4}"));
    format!(
        "{group:28}{region:8}{:>9}{:>10.2}{:>9.4}{:>10.5}{distance:>18}\n",
        means.pictures, means.psnr_db, means.ssim, means.l1
    )
}
