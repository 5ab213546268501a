//! `effigy capture`: has RenderDoc capture one frame, drawn without a window.

use crate::{
    advice::Advised,
    options::{self, CameraArgs, QualityArgs},
    source::{Source, check_time},
};
use anyhow::Context;
use effigy_core::scene::{AvatarBounds, Posed};
use effigy_render::vulkan::{Gpu, Offscreen, Presentation, Recording, Renderer};
use effigy_runtime::capture::RenderDoc;
use std::{ffi::CString, path::PathBuf};

#[derive(clap::Args, Debug)]
#[command(after_help = "\
RenderDoc must be attached: launch `effigy capture` from qrenderdoc, run `renderdoccmd capture \
effigy capture`, or set ENABLE_VULKAN_RENDERDOC_CAPTURE=1 where RenderDoc is installed. In `effigy \
view` the key C captures the frame on screen.")]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// Width and height of the image, pixels
    #[arg(long, value_name = "WxH", value_parser = options::size, default_value = "1024x1024")]
    size: [u32; 2],
    /// Time in the clip, seconds
    #[arg(long, value_name = "SECONDS", default_value_t = 0.0, value_parser = options::seconds)]
    time: f64,
    /// Frames to draw first, so that what follows is typical
    #[arg(long, value_name = "N", default_value_t = 3)]
    warm_up: u32,
    /// Start of the capture's file name; RenderDoc appends a number and .rdc
    #[arg(short, long, value_name = "NAME", default_value = "effigy")]
    out: PathBuf,
    #[command(flatten, next_help_heading = "Camera")]
    camera: CameraArgs,
    #[command(flatten, next_help_heading = "Quality")]
    quality: QualityArgs,
}

fn not_attached() -> Advised {
    Advised::new(
        "RenderDoc is not attached",
        "start the program from RenderDoc (Launch Application in qrenderdoc, or `renderdoccmd capture effigy capture`), or set ENABLE_VULKAN_RENDERDOC_CAPTURE=1 where RenderDoc is installed",
    )
}

pub fn run(args: Args) -> anyhow::Result<()> {
    // RenderDoc's layer attaches when the device is opened.
    let gpu = Gpu::new(&args.quality.gpu())?;
    let renderdoc = RenderDoc::attached().ok_or_else(not_attached)?;
    let (avatar, player) = args.source.load_player()?;
    check_time(&player, args.time);
    let mut renderer = Renderer::new(&gpu, &avatar, args.quality.renderer(args.size))?;
    let mut screen = Offscreen::new(&gpu, args.size)?;
    // SAFETY: nothing uses the screen yet, every frame leaves the image in that layout, and each is
    // waited for.
    unsafe { screen.connect(renderer.raster()) }?;
    let avatar_bounds = AvatarBounds::new(&avatar);
    let background = options::color(options::BACKGROUND).map_err(anyhow::Error::msg)?;
    let mut draw = |seconds: f64| -> anyhow::Result<()> {
        let posed = Posed::new(&avatar, &player.pose(seconds));
        let framing = avatar_bounds.framing(&posed.joints);
        let camera = args.camera.camera(framing, args.size)?;
        let mut record = |commands: Recording, is_shown: bool| {
            if !is_shown {
                screen.record(commands, args.size, background);
            }
        };
        // SAFETY: the frame is waited for below.
        let presentation = unsafe { Presentation::new(None, &mut record) };
        let presentation = presentation.in_one_pass(screen.one_pass(background));
        renderer.draw(&posed, &camera, Some(presentation))?;
        Ok(renderer.finish()?)
    };
    // Each of these has a pose of its own, so that the captured frame skips no stage.
    for frame in (1..=args.warm_up).rev() {
        draw(args.time + f64::from(frame) / 30.0)?;
    }
    let name = CString::new(args.out.to_string_lossy().into_owned())
        .context("the name of the capture has a zero byte in it")?;
    renderdoc.set_path(&name);
    let ((), file) = renderdoc.capture_call(|| draw(args.time))?;
    let file = file.ok_or_else(|| {
        Advised::new(
            "RenderDoc is attached but has captured nothing",
            "RenderDoc may not know this device: its log says more",
        )
    })?;
    println!(
        "captured a frame of {} on {}: {}",
        avatar.name,
        gpu.probe.name,
        file.display()
    );
    Ok(())
}
