//! Measures an avatar of your own: the time of each stage, and the error against the f64 reference.
//!
//! `cargo run --release -p effigy --example measure -- [AVATAR.avatar [CLIP.motion]]`

use effigy::{
    Avatar, Camera, Clip, Gpu, GpuOptions, Orbit, Player, Posed, Renderer, RendererOptions,
    reference,
};
use effigy_measure::error;
use std::{env, error::Error, path::Path, time::Instant};

const SIZE: [u32; 2] = [512, 768];
const FRAMES: usize = 8;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let avatar = match arguments.next() {
        Some(path) => Avatar::read(Path::new(&path))?,
        None => effigy_demo::avatar()?,
    };
    let clip = match arguments.next() {
        Some(path) => Clip::read(Path::new(&path))?,
        None => effigy_demo::clip()?,
    };
    let player = Player::new(clip, &avatar.skeleton);
    let duration = player.clip().duration();
    let gpu = Gpu::new(&GpuOptions::new())?;
    let mut renderer = Renderer::new(&gpu, &avatar, RendererOptions::new(SIZE))?;
    println!("{} on {}", avatar.name, gpu.name());

    let mut worst: f64 = f64::INFINITY;
    for frame in 0..FRAMES {
        let posed = Posed::new(
            &avatar,
            &player.pose(duration * frame as f64 / FRAMES as f64),
        );
        let framing = renderer.bounds().framing(&posed.joints);
        let orbit = Orbit {
            yaw: frame as f64,
            ..Orbit::default()
        };
        let camera = Camera::around(framing, orbit, SIZE);
        let began = Instant::now();
        renderer.draw(&posed, &camera)?;
        renderer.finish()?;
        let took = began.elapsed().as_secs_f64() * 1e3;

        // Over the pixels that the avatar covers: an empty background would flatter every figure.
        let exact = reference::render(&avatar, &posed, &camera);
        let metrics = error::between(&renderer.read_image()?, &exact);
        worst = worst.min(metrics.covered.psnr_db);
        // The first frame's time includes compiling what the driver has not cached.
        println!(
            "frame {frame}: {took:.1} ms, {:.1} dB",
            metrics.covered.psnr_db
        );
    }
    for (stage, ms) in &renderer.report().stages {
        println!("  {stage}: {ms:.2} ms");
    }
    println!("worst frame: {worst:.1} dB over {FRAMES} frames");
    Ok(())
}
