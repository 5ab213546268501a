//! `effigy capture`: has RenderDoc capture one frame, drawn without a window.

use super::{
    options::{self, Quality, View},
    source::Source,
};
use crate::{
    avatar::motion::Player,
    frame::{Extent, Posed},
    measure::{
        capture::{ATTACH, RenderDoc},
        upright,
    },
    vulkan::{Gpu, Renderer, renderer::Presentation, screen::Screen},
};
use anyhow::{Context, bail};
use std::{ffi::CString, path::PathBuf};

#[derive(clap::Args)]
#[command(after_help = "\
RenderDoc must be attached: launch `effigy capture` from qrenderdoc, run `renderdoccmd capture effigy capture`, or set
ENABLE_VULKAN_RENDERDOC_CAPTURE=1 where RenderDoc is installed. In `effigy view` the key C captures what is shown.")]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// Width and height, px
    #[arg(long, value_parser = options::size, default_value = "1024x1024")]
    size: [u32; 2],
    /// Seconds into the clip
    #[arg(long, default_value_t = 0.0)]
    time: f64,
    #[command(flatten)]
    view: View,
    /// Frames to draw before the one that is captured, so that it is one like any other
    #[arg(long, value_name = "N", default_value_t = 3)]
    warm_up: u32,
    /// Beginning of the capture's name; RenderDoc puts a number and .rdc after it
    #[arg(short, long, value_name = "NAME", default_value = "effigy")]
    out: PathBuf,
    #[command(flatten)]
    quality: Quality,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    anyhow::ensure!(args.time.is_finite(), "a time of {} s is in no clip", args.time);
    let gpu = Gpu::new(&args.quality.gpu())?;
    let Some(renderdoc) = RenderDoc::attached() else { bail!(ATTACH) };
    let (avatar, clips) = args.source.load()?;
    let player = Player::new(clips.into_iter().next().context("there is no clip")?, &avatar.skeleton);
    let mut renderer = Renderer::new(&gpu, &avatar, args.quality.renderer(args.size))?;
    let screen = Screen::new(&gpu, args.size)?;
    screen.set_picture(renderer.raster().image());
    let extent = Extent::new(&avatar);
    let background = options::color(options::BACKGROUND).map_err(anyhow::Error::msg)?;
    let mut draw = |seconds: f64| -> anyhow::Result<()> {
        let posed = Posed::new(&avatar, &player.pose(seconds));
        let camera = args.view.camera(upright(extent.bounds(&posed.joints)), args.size)?;
        let mut record = |commands| screen.record(commands, args.size, background);
        renderer.draw(&posed, &camera, Some(Presentation { semaphores: None, record: &mut record }))?;
        Ok(renderer.finish()?)
    };
    // Each in another pose, so that the captured frame runs every stage.
    for frame in (1..=args.warm_up).rev() {
        draw(args.time + f64::from(frame) / 30.0)?;
    }
    let beginning = CString::new(args.out.to_string_lossy().into_owned()).context("the name of the capture has a zero in it")?;
    renderdoc.set_path(&beginning);
    let ((), file) = renderdoc.during(|| draw(args.time))?;
    let file = file.context("RenderDoc is attached but has captured nothing: does it know this device? Its log says more")?;
    println!("captured a frame of {} on {}: {}", avatar.name, gpu.probe.name, file.display());
    Ok(())
}
