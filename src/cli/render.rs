//! `effigy render`: images of an avatar, drawn by the GPU or by the f64 reference.

use crate::{
    backend::BackendArg,
    files,
    options::{self, CameraArgs, QualityArgs},
    output::{self, IMAGE, Output},
    picture, progress,
    source::{self, Source},
};
use anyhow::ensure;
use effigy::vulkan::{Gpu, Renderer, RendererOptions, cache};
#[cfg(feature = "webgpu")]
use effigy::webgpu;
use effigy_core::{
    avatar::{Avatar, Clip, motion::Player},
    io::cameras,
    reference,
    scene::{AvatarBounds, Camera, FrameImage, Framing, Posed},
};
use effigy_measure::{bench::Backend, in_rows};
use effigy_runtime::slow_start::{self, SlowStart};
use std::{
    f64::consts::TAU,
    ops::Range,
    path::{Path, PathBuf},
};

/// Width and height of an image unless the user or a camera says otherwise, pixels.
const SIZE: [u32; 2] = [1024, 1024];
/// The largest image that the reference draws, pixels: at 32 bytes each, 4 GB.
const REFERENCE_PIXELS: u64 = 1 << 27;

#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// Image to write, a .png, .jpg or .webp (without loss), or - for a .png on the standard
    /// output; with --frames or --cameras a number goes before the ending [default: effigy.png]
    #[arg(short, long, value_name = "FILE", value_parser = IMAGE.parser())]
    out: Option<Output>,
    /// The same without `--out`
    #[arg(hide = true, conflicts_with = "out", value_parser = IMAGE.parser())]
    to: Option<Output>,
    /// Width and height of the image, pixels [default: 1024x1024, or each camera's own of
    /// --cameras]
    #[arg(long, value_name = "WxH", value_parser = options::size)]
    size: Option<[u32; 2]>,
    /// Time in the clip, seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, value_parser = options::seconds, conflicts_with = "frames")]
    time: f64,
    /// Clip frames to render, from A up to B, which is not included: 0..30
    #[arg(long, value_name = "A..B", value_parser = frame_range)]
    frames: Option<Range<usize>>,
    /// Draw from each camera of this file, a cameras.json as 3DGS or mmlphuman writes it
    #[arg(long, value_name = "FILE", conflicts_with = "frames")]
    cameras: Option<PathBuf>,
    /// Copies of the avatar, 1 to 1024, each at another time of the clip: up to 16 in a row a metre
    /// apart, more in rows
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1024))]
    count: u16,
    /// Colour behind the avatar, or `none` for a transparent image
    #[arg(long, value_name = "RRGGBB", default_value = options::BACKGROUND, value_parser = background)]
    background: Background,
    /// Draw with the f64 reference on the CPU instead of the GPU
    #[arg(long)]
    reference: bool,
    /// Graphics API to draw with
    #[arg(long, value_enum, default_value_t = BackendArg::Vulkan)]
    backend: BackendArg,
    #[command(flatten, next_help_heading = "Camera")]
    camera: CameraArgs,
    #[command(flatten, next_help_heading = "Quality")]
    quality: QualityArgs,
}

/// The background of an image.
#[derive(Clone, Copy, Debug)]
enum Background {
    Transparent,
    /// Display-referred RGB, 0 to 1.
    Color([f32; 3]),
}

fn background(text: &str) -> Result<Background, String> {
    if text == "none" {
        Ok(Background::Transparent)
    } else {
        options::color(text).map(Background::Color)
    }
}

/// Reads `A..B`, at least one frame.
fn frame_range(text: &str) -> Result<Range<usize>, String> {
    let range = text
        .split_once("..")
        .and_then(|(start, end)| Some(start.parse().ok()?..end.parse().ok()?));
    range.filter(|range| !range.is_empty()).ok_or_else(|| {
        format!("`{text}` is not a range of frames: write first..last+1, for instance 0..30")
    })
}

/// Draws single images: a renderer of either backend with the size of its image, or the reference.
enum ImageRenderer<'a> {
    Vulkan {
        renderer: Box<Renderer>,
        size: [u32; 2],
        /// Until the first frame is drawn.
        slow_start: Option<SlowStart>,
    },
    #[cfg(feature = "webgpu")]
    WebGpu {
        renderer: Box<webgpu::Renderer>,
        size: [u32; 2],
    },
    Reference {
        avatar: &'a Avatar,
        quality: &'a QualityArgs,
    },
}

impl<'a> ImageRenderer<'a> {
    /// Opens what the arguments name, for images of `size` unless a camera has its own.
    fn open(args: &'a Args, avatar: &'a Avatar, image_size: [u32; 2]) -> anyhow::Result<Self> {
        if args.reference {
            return Ok(Self::Reference {
                avatar,
                quality: &args.quality,
            });
        }
        let options = RendererOptions {
            instances: args.count.into(),
            ..args.quality.renderer(image_size)
        };
        let gpu = args.quality.gpu();
        Ok(match args.backend.try_into()? {
            Backend::Vulkan => {
                let gpu = Gpu::new(&gpu)?;
                println!("drawing with {}", gpu.probe.name);
                let slow_start = slow_start(&gpu);
                Self::Vulkan {
                    renderer: Box::new(Renderer::new(&gpu, avatar, options)?),
                    size: image_size,
                    slow_start,
                }
            }
            #[cfg(feature = "webgpu")]
            Backend::WebGpu => {
                let gpu = webgpu::Gpu::open(gpu.device.as_deref())?;
                println!("drawing with {} through WebGPU", gpu.name());
                let options = match args.quality.keys {
                    Some(_) => options,
                    None => webgpu::options::within_reach(options),
                };
                Self::WebGpu {
                    renderer: Box::new(webgpu::Renderer::new(&gpu, avatar, options)?),
                    size: image_size,
                }
            }
        })
    }

    /// Draws one image of the camera's size.
    fn draw(&mut self, poses: &[&Posed], camera: &Camera) -> anyhow::Result<FrameImage> {
        match self {
            Self::Reference { avatar, quality } => {
                let [width, height] = camera.size;
                let pixels = u64::from(width) * u64::from(height);
                ensure!(
                    pixels <= REFERENCE_PIXELS,
                    "the reference draws at most {REFERENCE_PIXELS} pixels, not {width} x {height}"
                );
                let options = quality.renderer(camera.size);
                Ok(reference::render_shown(
                    avatar,
                    poses,
                    camera,
                    options.supersampling,
                    options.filter,
                ))
            }
            Self::Vulkan {
                renderer,
                size,
                slow_start,
            } => {
                if camera.size != *size {
                    renderer.resize(camera.size)?;
                    *size = camera.size;
                }
                renderer.draw_scene(poses, camera, None)?;
                let image = renderer.read_image()?;
                slow_start.take();
                Ok(image)
            }
            #[cfg(feature = "webgpu")]
            Self::WebGpu { renderer, size } => {
                if camera.size != *size {
                    renderer.resize(camera.size)?;
                    *size = camera.size;
                }
                renderer.draw_scene(poses, camera)?;
                Ok(renderer.read_image()?)
            }
        }
    }
}

/// Everything that the images of one command have in common.
struct Shoot<'a> {
    args: &'a Args,
    out: &'a Output,
    avatar: &'a Avatar,
    bounds: AvatarBounds,
    player: &'a Player,
    renderer: ImageRenderer<'a>,
}

impl Shoot<'_> {
    /// Draws the avatars at a time of the clip and writes the image. Without a camera of its own,
    /// the image is taken by the one that the arguments describe.
    fn draw_image(
        &mut self,
        seconds: f64,
        camera: Option<&Camera>,
        out: &Output,
    ) -> anyhow::Result<()> {
        let poses = row(self.avatar, self.player, seconds, self.args.count.into());
        let camera = match camera {
            Some(camera) => cameras::scaled(camera, self.args.size.unwrap_or(camera.size)),
            None => {
                let framed = poses.iter().map(|posed| self.bounds.framing(&posed.joints));
                let all = framed.reduce(Framing::union).context("no copy to draw")?;
                self.args
                    .camera
                    .camera(all, self.args.size.unwrap_or(SIZE))?
            }
        };
        let poses: Vec<&Posed> = poses.iter().collect();
        let image = self.renderer.draw(&poses, &camera)?;
        write_image(&image, self.args.background, out)
    }

    /// An image of one time from each camera.
    fn draw_cameras(&mut self, cameras: &[Camera]) -> anyhow::Result<()> {
        let out = self.out;
        for (number, camera) in cameras.iter().enumerate() {
            self.draw_image(self.args.time, Some(camera), &out.numbered(number))?;
        }
        print_range(out, 0..cameras.len());
        Ok(())
    }

    /// An image of each frame of a range.
    fn draw_frames(&mut self, frames: Range<usize>) -> anyhow::Result<()> {
        let out = self.out;
        let rate = self.player.clip().rate;
        let bar = progress::items(frames.len() as u64, "frames");
        for frame in frames.clone() {
            self.draw_image(frame as f64 / rate, None, &out.numbered(frame))?;
            bar.inc(1);
        }
        bar.finish_and_clear();
        print_range(out, frames);
        Ok(())
    }
}

pub fn run(mut args: Args) -> anyhow::Result<()> {
    let out = &args
        .out
        .take()
        .or(args.to.take())
        .map_or_else(default_output, Ok)?;
    ensure!(
        out.ending() != "jpg" || !matches!(args.background, Background::Transparent),
        "a .jpg has no transparency: write a .png or .webp, or give --background a colour"
    );
    let (mut avatar, player) = args.source.load_player()?;
    args.quality.filter.apply(&mut avatar);
    // What can't be drawn is refused before a device is opened, which may take seconds.
    if let Some(frames) = &args.frames {
        check_range(frames, player.clip())?;
        output::check_series(out, frames.clone())?;
    }
    let cameras = match &args.cameras {
        Some(path) => Some(source::cameras(path, &avatar)?),
        None => None,
    };
    if let Some(cameras) = &cameras {
        output::check_series(out, 0..cameras.len())?;
    }
    let mut shoot = Shoot {
        args: &args,
        out,
        avatar: &avatar,
        bounds: AvatarBounds::new(&avatar),
        player: &player,
        renderer: ImageRenderer::open(&args, &avatar, args.size.unwrap_or(SIZE))?,
    };
    if let Some(cameras) = &cameras {
        return shoot.draw_cameras(cameras);
    }
    if let Some(frames) = &args.frames {
        return shoot.draw_frames(frames.clone());
    }
    source::check_time(&player, args.time);
    shoot.draw_image(args.time, None, out)?;
    println!("wrote {}", out.display());
    Ok(())
}

/// The file that is written where none is named.
fn default_output() -> anyhow::Result<Output> {
    let out = Output::new("effigy.png".into(), "png");
    output::check([&out])?;
    Ok(out)
}

fn check_range(frames: &Range<usize>, clip: &Clip) -> anyhow::Result<()> {
    ensure!(
        frames.end <= clip.frames(),
        "frames {}..{} were asked for; the clip `{}` has {}",
        frames.start,
        frames.end,
        clip.name,
        clip.frames()
    );
    Ok(())
}

/// `count` copies of an avatar in a row or several, their times spread over the clip from `seconds`
/// on.
fn row(avatar: &Avatar, player: &Player, seconds: f64, count: usize) -> Vec<Posed> {
    let duration = player.clip().duration();
    let pose = |number: usize| {
        let mut time = seconds + duration * number as f64 / count as f64;
        // The first copy keeps the time that was asked for, even past the clip's end.
        if number > 0 && duration > 0.0 {
            time %= duration;
        }
        Posed::new(avatar, &player.pose(time)).placed(in_rows(number, count))
    };
    (0..count).map(pose).collect()
}

/// Renders a turn around the avatar while it moves, for a machine without a display, and prints
/// where the images are.
pub fn turntable(source: &Source, folder: &Path) -> anyhow::Result<()> {
    const IMAGES: usize = 24;
    /// The part of the clip that is shown, seconds at most.
    const SECONDS: f64 = 6.0;
    let size = [720, 960];
    let (avatar, player) = source.load_player()?;
    let gpu = Gpu::new(&effigy::vulkan::GpuOptions::headless(None))?;
    println!("drawing a turntable with {}", gpu.probe.name);
    let mut slow_start = slow_start(&gpu);
    let mut renderer = Renderer::new(&gpu, &avatar, RendererOptions::new(size))?;
    files::create_folder(folder)?;
    let background = background(options::BACKGROUND).map_err(anyhow::Error::msg)?;
    let avatar_bounds = AvatarBounds::new(&avatar);
    let bar = progress::items(IMAGES as u64, "images");
    for number in 0..IMAGES {
        let turn = number as f64 / IMAGES as f64;
        let seconds = turn * player.clip().duration().min(SECONDS);
        let posed = Posed::new(&avatar, &player.pose(seconds));
        let framing = avatar_bounds.framing(&posed.joints);
        let camera = Camera::around(framing, turn * TAU, 0.09, 35f64.to_radians(), size);
        renderer.draw(&posed, &camera, None)?;
        let out = Output::new(folder.join(format!("{number:02}.png")), "png");
        let image = renderer.read_image()?;
        slow_start.take();
        write_image(&image, background, &out)?;
        bar.inc(1);
    }
    bar.finish_and_clear();
    println!("wrote {IMAGES} images to {}", folder.display());
    Ok(())
}

/// Explains a first start, whose wait is for the driver's compiler.
fn slow_start(gpu: &Gpu) -> Option<SlowStart> {
    let sentence = slow_start::compiling(&gpu.probe.name);
    cache::is_first_start().then(|| SlowStart::new(move || eprintln!("{sentence}")))
}

fn write_image(image: &FrameImage, background: Background, out: &Output) -> anyhow::Result<()> {
    let pixels = match background {
        Background::Transparent => image.transparent(),
        Background::Color(color) => image.over(color),
    };
    picture::write(&pixels, out)
}

/// Prints the first and the last file of numbered images.
fn print_range(out: &Output, numbers: Range<usize>) {
    println!(
        "wrote {} to {}",
        out.numbered(numbers.start).display(),
        out.numbered(numbers.end - 1).display()
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frame_ranges_are_not_empty() {
        assert_eq!(frame_range("3..5"), Ok(3..5));
        assert!(frame_range("5..5").is_err() && frame_range("x").is_err());
    }
}
