//! Draws an avatar to an image file, on a device that Effigy opens.
//!
//! `cargo run --release -p effigy --example picture -- [OUT.png [AVATAR.avatar [CLIP.motion]]]`

use effigy::{
    Avatar, Camera, Clip, Gpu, GpuOptions, Orbit, Player, Posed, Renderer, RendererOptions,
};
use std::{env, error::Error, path::Path};

const SIZE: [u32; 2] = [640, 960];

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let out = arguments.next().unwrap_or("picture.png".into());
    let avatar = match arguments.next() {
        Some(path) => Avatar::read(Path::new(&path))?,
        None => effigy_demo::avatar()?,
    };
    let clip = match arguments.next() {
        Some(path) => Clip::read(Path::new(&path))?,
        None => effigy_demo::clip()?,
    };

    // A pose: joint rotations and an expression, here one second into the clip. The network input
    // and the joint matrices follow from it.
    let player = Player::new(clip, &avatar.skeleton);
    let posed = Posed::new(&avatar, &player.pose(1.0));

    // The renderer uploads the avatar once, and draws any number of poses of it.
    let gpu = Gpu::new(&GpuOptions::new())?;
    let mut renderer = Renderer::new(&gpu, &avatar, RendererOptions::new(SIZE))?;

    // All of the avatar in the image, turned 20° to the side.
    let framing = renderer.bounds().framing(&posed.joints);
    let orbit = Orbit {
        yaw: 0.35,
        ..Orbit::default()
    };
    let camera = Camera::around(framing, orbit, SIZE);
    renderer.draw(&posed, &camera)?;
    let image = renderer.read_image()?;
    image.over([0.85, 0.87, 0.89]).save(&out)?;
    println!("wrote {out}, drawn on {}", gpu.name());
    Ok(())
}
