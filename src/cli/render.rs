//! `effigy render`: pictures to PNG files, by the GPU or by the reference.

use super::{
    options::{self, Quality, View},
    source::{self, Source},
    through::Through,
};
#[cfg(feature = "webgpu")]
use crate::webgpu;
use crate::{
    avatar::{Avatar, import::cameras, motion::Player},
    frame::{Camera, Extent, Picture, Posed},
    measure::{bench::Backend, in_a_row, upright},
    reference,
    vulkan::{Gpu, Renderer, RendererOptions},
};
use anyhow::{Context, ensure};
use indicatif::{ProgressBar, ProgressStyle};
use std::{
    fs,
    path::{Path, PathBuf},
};

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// File to write; with --frames or --cameras a number goes before the ending
    #[arg(short, long, default_value = "effigy.png")]
    out: PathBuf,
    /// Width and height, px [default: 1024x1024, or each camera's own of --cameras]
    #[arg(long, value_parser = options::size)]
    size: Option<[u32; 2]>,
    /// Seconds into the clip
    #[arg(long, default_value_t = 0.0, conflicts_with = "frames")]
    time: f64,
    /// Clip frames to render, the second not included: 0..30
    #[arg(long, value_name = "A..B", value_parser = frames)]
    frames: Option<std::ops::Range<usize>>,
    /// Render a picture from each of these cameras, a cameras.json as 3DGS writes it
    #[arg(long, value_name = "FILE", conflicts_with = "frames")]
    cameras: Option<PathBuf>,
    #[command(flatten)]
    view: View,
    /// Copies of the avatar, in a row a metre apart, each further on in the clip
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=64))]
    count: u16,
    /// Colour behind the avatar, or `none` for a transparent picture
    #[arg(long, default_value = options::BACKGROUND, value_parser = background)]
    background: Background,
    /// Draw with the f64 reference on the CPU instead of the GPU
    #[arg(long)]
    reference: bool,
    /// What to draw through
    #[arg(long, value_enum, default_value_t = Through::Vulkan)]
    backend: Through,
    #[command(flatten)]
    quality: Quality,
}

/// What pictures are written over.
#[derive(Clone, Copy, Debug)]
enum Background {
    None,
    Color([f32; 3]),
}

fn background(text: &str) -> Result<Background, String> {
    if text == "none" { Ok(Background::None) } else { options::color(text).map(Background::Color) }
}

fn frames(text: &str) -> Result<std::ops::Range<usize>, String> {
    let range = text.split_once("..").and_then(|(start, end)| Some(start.parse().ok()?..end.parse().ok()?));
    range
        .filter(|range| !range.is_empty())
        .ok_or_else(|| format!("`{text}` is no range of frames: write first..last+1, for instance 0..30"))
}

/// Any of those that can draw.
/// The most that the reference is asked for: at 32 bytes each, 4 GB.
const REFERENCE_PIXELS: u64 = 1 << 27;

enum Painter<'a> {
    /// With the size of its picture.
    Gpu(Box<Renderer>, [u32; 2]),
    #[cfg(feature = "webgpu")]
    WebGpu(Box<webgpu::Renderer>, [u32; 2]),
    Reference(&'a Avatar),
}

impl Painter<'_> {
    fn paint(&mut self, poses: &[&Posed], camera: &Camera) -> anyhow::Result<Picture> {
        match self {
            Self::Reference(avatar) => {
                let [width, height] = camera.size;
                let pixels = u64::from(width) * u64::from(height);
                ensure!(pixels <= REFERENCE_PIXELS, "the reference draws at most {REFERENCE_PIXELS} pixels, not {width} x {height}");
                Ok(reference::render_scene(avatar, poses, camera))
            }
            Self::Gpu(renderer, size) => {
                if camera.size != *size {
                    renderer.resize(camera.size)?;
                    *size = camera.size;
                }
                renderer.draw_scene(poses, camera, None)?;
                Ok(renderer.picture()?)
            }
            #[cfg(feature = "webgpu")]
            Self::WebGpu(renderer, size) => {
                if camera.size != *size {
                    renderer.resize(camera.size)?;
                    *size = camera.size;
                }
                renderer.draw_scene(poses, camera)?;
                Ok(renderer.picture()?)
            }
        }
    }
}

pub fn run(args: Args) -> anyhow::Result<()> {
    ensure!(args.time.is_finite(), "a time of {} s is in no clip", args.time);
    let (avatar, clips) = args.source.load()?;
    let player = Player::new(clips.into_iter().next().context("there is no clip")?, &avatar.skeleton);
    let size = args.size.unwrap_or([1024, 1024]);
    let mut painter = if args.reference { Painter::Reference(&avatar) } else { painter(&args, &avatar, size)? };
    let extent = Extent::new(&avatar);
    let mut paint = |seconds: f64, camera: Option<&Camera>, out: &Path| -> anyhow::Result<()> {
        let poses = row(&avatar, &player, seconds, args.count.into());
        let around = || {
            let boxes = poses.iter().map(|posed| upright(extent.bounds(&posed.joints)));
            let all = boxes.reduce(|[low, high], [min, max]| [low.min(min), high.max(max)]);
            args.view.camera(all.unwrap_or_default(), size)
        };
        let camera = camera.map_or_else(around, |camera| Ok(cameras::scaled(camera, args.size.unwrap_or(camera.size))))?;
        write(&painter.paint(&poses.iter().collect::<Vec<_>>(), &camera)?, args.background, out)
    };
    if let Some(path) = &args.cameras {
        let cameras = source::cameras(path, &avatar)?;
        for (number, camera) in cameras.iter().enumerate() {
            paint(args.time, Some(camera), &numbered(&args.out, number))?;
        }
        println!("wrote {} to {}", numbered(&args.out, 0).display(), numbered(&args.out, cameras.len() - 1).display());
        return Ok(());
    }
    let Some(frames) = args.frames else {
        paint(args.time, None, &args.out)?;
        println!("wrote {}", args.out.display());
        return Ok(());
    };
    let clip = player.clip();
    ensure!(
        frames.end <= clip.frames(),
        "frames {}..{} were asked for; the clip `{}` has {}",
        frames.start,
        frames.end,
        clip.name,
        clip.frames()
    );
    let bar = progress(frames.len() as u64, "frames");
    for frame in frames.clone() {
        paint(frame as f64 / clip.rate, None, &numbered(&args.out, frame))?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    println!("wrote {} to {}", numbered(&args.out, frames.start).display(), numbered(&args.out, frames.end - 1).display());
    Ok(())
}

fn painter<'a>(args: &Args, avatar: &Avatar, size: [u32; 2]) -> anyhow::Result<Painter<'a>> {
    let options = RendererOptions { actors: args.count.into(), ..args.quality.renderer(size) };
    let gpu = args.quality.gpu();
    Ok(match args.backend.try_into()? {
        Backend::Vulkan => {
            let gpu = Gpu::new(&gpu)?;
            println!("drawing with {}", gpu.probe.name);
            Painter::Gpu(Box::new(Renderer::new(&gpu, avatar, options)?), size)
        }
        #[cfg(feature = "webgpu")]
        Backend::WebGpu => {
            let gpu = webgpu::Gpu::open(gpu.device.as_deref())?;
            println!("drawing with {} through WebGPU", gpu.name());
            Painter::WebGpu(Box::new(webgpu::Renderer::new(&gpu, avatar, options)?), size)
        }
    })
}

/// Copies of an avatar, spread over the clip from a time on.
fn row(avatar: &Avatar, player: &Player, seconds: f64, count: usize) -> Vec<Posed> {
    let duration = player.clip().duration();
    let pose = |number: usize| {
        let at = seconds + duration * number as f64 / count as f64;
        let at = if number > 0 && duration > 0.0 { at % duration } else { at };
        Posed::new(avatar, &player.pose(at)).placed(in_a_row(number, count))
    };
    (0..count).map(pose).collect()
}

/// Renders a turn of the avatar around itself while it moves, for a machine without a display. Says where the pictures are.
pub fn turntable(source: &Source, folder: &Path) -> anyhow::Result<()> {
    const PICTURES: usize = 24;
    let size = [720, 960];
    let (avatar, clips) = source.load()?;
    let player = Player::new(clips.into_iter().next().context("there is no clip")?, &avatar.skeleton);
    let gpu = Gpu::new(&crate::vulkan::GpuOptions::headless(None))?;
    println!("drawing a turntable with {}", gpu.probe.name);
    let mut renderer = Renderer::new(&gpu, &avatar, RendererOptions::new(size))?;
    fs::create_dir_all(folder).with_context(|| format!("{} can't be made", folder.display()))?;
    let background = Background::Color(options::color(options::BACKGROUND).map_err(anyhow::Error::msg)?);
    let extent = Extent::new(&avatar);
    let bar = progress(PICTURES as u64, "pictures");
    for at in 0..PICTURES {
        let turn = at as f64 / PICTURES as f64;
        let posed = Posed::new(&avatar, &player.pose(turn * player.clip().duration().min(6.0)));
        let bounds = upright(extent.bounds(&posed.joints));
        let camera = Camera::around(bounds, turn * std::f64::consts::TAU, 0.09, 35f64.to_radians(), size);
        renderer.draw(&posed, &camera, None)?;
        write(&renderer.picture()?, background, &folder.join(format!("{at:02}.png")))?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    println!("wrote {PICTURES} pictures to {}", folder.display());
    Ok(())
}

fn write(picture: &Picture, background: Background, out: &Path) -> anyhow::Result<()> {
    let image = match background {
        Background::None => picture.transparent(),
        Background::Color(color) => picture.over(color),
    };
    image.save_with_format(out, image::ImageFormat::Png).with_context(|| format!("{} can't be written", out.display()))
}

/// `walk.png` and 7 give `walk-0007.png`.
fn numbered(out: &Path, frame: usize) -> PathBuf {
    let stem = out.file_stem().unwrap_or_default().to_string_lossy();
    let ending = out.extension().map_or("png".into(), |ending| ending.to_string_lossy());
    out.with_file_name(format!("{stem}-{frame:04}.{ending}"))
}

/// A bar that shows how far a long job is.
pub fn progress(length: u64, unit: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(&format!("{{bar:40}} {{pos}}/{{len}} {unit}, {{eta}} left {{msg}}"));
    ProgressBar::new(length).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_numbered_before_the_ending() {
        assert_eq!(numbered(Path::new("out/walk.png"), 7), Path::new("out/walk-0007.png"));
        assert_eq!(frames("3..5"), Ok(3..5));
        assert!(frames("5..5").is_err() && frames("x").is_err());
    }
}
