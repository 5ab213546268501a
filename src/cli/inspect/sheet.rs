//! Pictures of a folder's files on one sheet.

use crate::{
    output::Output,
    picture, progress,
    thumbnail::{SIZE, Thumbnails},
};
use anyhow::ensure;
use image::{RgbaImage, imageops};
use std::path::Path;

/// Pictures of a row.
const COLUMNS: u32 = 8;
/// Pictures of a sheet.
const MOST: usize = 96;
/// Each picture is made smaller by this.
const REDUCTION: u32 = 2;
/// Where a file can't be drawn, RGBA.
const EMPTY: [u8; 4] = [64, 64, 64, 255];

/// Writes a sheet of files' pictures in their order. What can't be drawn leaves its place empty, and
/// is said to.
pub fn write(thumbnails: &Thumbnails, files: &[&Path], out: &Output) -> anyhow::Result<()> {
    ensure!(!files.is_empty(), "there is nothing to draw for --png");
    let drawn = &files[..files.len().min(MOST)];
    if drawn.len() < files.len() {
        eprintln!("the picture has the first {MOST} files of {}", files.len());
    }
    let side = SIZE.map(|side| side / REDUCTION);
    let count = drawn.len() as u32;
    let size = [count.min(COLUMNS), count.div_ceil(COLUMNS)];
    let size = [size[0] * side[0], size[1] * side[1]];
    let mut sheet = RgbaImage::from_pixel(size[0], size[1], image::Rgba(EMPTY));
    let bar = progress::items(drawn.len() as u64, "pictures");
    for (at, file) in (0..).zip(drawn) {
        match thumbnails.of(file) {
            Ok(picture) => {
                let picture = imageops::thumbnail(&picture, side[0], side[1]);
                let corner = [at % COLUMNS * side[0], at / COLUMNS * side[1]];
                imageops::replace(&mut sheet, &picture, corner[0].into(), corner[1].into());
            }
            Err(error) => progress::say(&bar, format_args!("{error:#}")),
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    picture::write(&sheet, out)
}
