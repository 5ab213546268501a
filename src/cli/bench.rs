//! `effigy bench`: time, error, memory and bytes of an avatar in motion.

use super::{
    options::{self, Quality},
    render::progress,
    source::{self, Source},
};
use crate::{
    avatar::{import::cameras, motion::Player},
    measure::bench::{self, Case, Report},
    vulkan::Gpu,
};
use anyhow::{Context, ensure};
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// Width and height, px [default: 2048x2048, or the first camera's of --cameras]
    #[arg(long, value_parser = options::size)]
    size: Option<[u32; 2]>,
    /// Frames to time, spread over the clip
    #[arg(long, default_value_t = 32)]
    frames: usize,
    /// Views around the avatar, used in turn
    #[arg(long, default_value_t = 4)]
    views: usize,
    /// Use these cameras in turn, a cameras.json as 3DGS writes it, from top to bottom as it says
    #[arg(long, value_name = "FILE", conflicts_with = "views")]
    cameras: Option<PathBuf>,
    /// Frames to compare with the f64 reference, each of which takes seconds
    #[arg(long, default_value_t = 4)]
    check: usize,
    /// Write the result as JSON too
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    #[command(flatten)]
    quality: Quality,
}

pub fn run(args: Args) -> anyhow::Result<()> {
    ensure!(args.frames > 0 && args.views > 0, "nothing to measure: give --frames and --views of at least 1");
    let (avatar, clips) = args.source.load()?;
    let player = Player::new(clips.into_iter().next().context("there is no clip")?, &avatar.skeleton);
    let cameras = args.cameras.as_ref().map_or(Ok(vec![]), |path| source::cameras(path, &avatar))?;
    let size = args.size.or(cameras.first().map(|camera| camera.size)).unwrap_or([2048, 2048]);
    let cameras: Vec<_> = cameras.iter().map(|camera| cameras::scaled(camera, size)).collect();
    let gpu = Gpu::new(&args.quality.gpu())?;
    let bar = progress(0, "frames");
    let mut show = |what: &'static str, done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
        bar.set_message(what);
    };
    let case = Case { frames: args.frames, views: args.views, checked: args.check };
    let report = bench::run(&gpu, &avatar, &player, args.quality.renderer(size), (case, &cameras), &mut show)?;
    bar.finish_and_clear();
    print(&report);
    if let Some(path) = args.json {
        let text = serde_json::to_string_pretty(&report)?;
        std::fs::write(&path, text + "\n").with_context(|| format!("{} can't be written", path.display()))?;
        println!("wrote {}", path.display());
    }
    Ok(())
}

fn print(report: &Report) {
    let mb = |bytes: u64| bytes as f64 / 1e6;
    println!("device   {} ({})", report.device, report.driver);
    println!("avatar   {}, {} Gaussians, {} drawn", report.avatar, report.gaussians, report.drawn);
    println!("picture  {} × {}, {}", report.size[0], report.size[1], report.color);
    println!("frame    {:.3} ms median, {:.3} ms p95, over {} frames", report.frame_ms.median, report.frame_ms.p95, report.frames);
    if let Some(gpu) = report.gpu_ms {
        println!("GPU      {:.3} ms median, {:.3} ms p95", gpu.median, gpu.p95);
    }
    for stage in &report.stages {
        println!("  {:9} {:9.3} ms  {:7.2} MB counted", stage.name, stage.ms, mb(stage.bytes));
    }
    println!("bytes    {:.2} MB a frame, counted", mb(report.bytes_per_frame));
    println!("memory   {:.1} MB of the device's, {:.1} MB in use", mb(report.gpu_memory_bytes), mb(report.gpu_memory_used_bytes));
    let Some(((psnr, max), within)) = report.psnr_db.zip(report.max_error).zip(report.within_tolerance) else { return };
    println!("error    {psnr:.2} dB, {max:.4} at most, {:.3} % of covered pixels within 4/255", 100.0 * within);
    if let Some((psnr, max)) = report.psnr_db_whole_picture.zip(report.max_error_whole_picture) {
        println!("         {psnr:.2} dB, {max:.4} at most over whole pictures");
    }
    println!("         worst of {} frames against the f64 reference", report.checked_frames);
}
