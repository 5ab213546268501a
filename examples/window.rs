//! Shows an avatar moving in a window, with the viewer's camera control, panel and keys.
//!
//! `cargo run --release -p effigy --example window -- [--frames N] [AVATAR.avatar [CLIP.motion]]`

use effigy::{Avatar, Clip};
use effigy_app::{Display, RendererOptions, ViewerOptions};
use std::{env, path::Path};

fn main() -> anyhow::Result<()> {
    let mut frames = None;
    let mut files = Vec::new();
    let mut arguments = env::args().skip(1);
    while let Some(argument) = arguments.next() {
        if argument == "--frames" {
            let count = arguments.next().unwrap_or_default();
            frames = Some(count.parse()?);
        } else {
            files.push(argument);
        }
    }
    let avatar = match files.first() {
        Some(path) => Avatar::read(Path::new(path))?,
        None => effigy_demo::avatar()?,
    };
    let clip = match files.get(1) {
        Some(path) => Clip::read(Path::new(path))?,
        None => effigy_demo::clip()?,
    };

    // Fails where there is no display, with the reason.
    let display = Display::open()?;
    let options = ViewerOptions {
        frames,
        ..ViewerOptions::new(RendererOptions::new([1280, 800]))
    };
    display.show(avatar, vec![clip], options)
}
