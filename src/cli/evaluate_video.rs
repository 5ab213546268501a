//! `effigy evaluate --video`: truth, candidate and error of every frame that a camera saw, as an
//! animated PNG.

use crate::progress;
use anyhow::{Context, ensure};
use effigy_capture::Capture;
use effigy_core::{io::file::replace, scene::PixelRect};
use effigy_learn::score::{Compared, Scorer, View};
use effigy_perceptual::Planes;
use std::path::Path;

/// A capture has no rate.
const FRAMES_A_SECOND: u16 = 10;
/// Around what is compared, 0 to 255.
const GREY: u8 = 64;

/// Writes the frames of the first camera that is held out, or of the first where none is, in their
/// order. `error`: of a truth and an image.
pub fn write(
    path: &Path,
    capture: &Capture,
    scorer: &Scorer,
    error: impl Fn(&Planes, &Planes) -> Planes,
) -> anyhow::Result<()> {
    let held = capture.cameras.iter().position(|camera| camera.held);
    let camera = held.unwrap_or(0);
    let frames: Vec<usize> = (0..capture.frames.len())
        .filter(|&frame| capture.has(camera, frame))
        .collect();
    let bar = progress::items(frames.len() as u64, "frames");
    let mut all: Vec<Compared> = Vec::new();
    for frame in frames {
        match scorer.compare(View { camera, frame }) {
            Ok(compared) => all.extend(compared),
            Err(error) => bar.println(error.to_string()),
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    let name = &capture.cameras[camera].name;
    ensure!(
        !all.is_empty(),
        "{}: camera {name} has no frame that can be compared",
        path.display()
    );
    let part = all.iter().fold(PixelRect::EMPTY, |part, own| PixelRect {
        min: part.min.min(own.rect.min),
        max: part.max.max(own.rect.max),
    });
    let bytes = animation(&all, part, error)
        .with_context(|| format!("{} can't be made", path.display()))?;
    replace(path, &bytes)?;
    println!("{}: {} frames of {name}", path.display(), all.len());
    Ok(())
}

/// The animation of a part of the picture.
fn animation(
    all: &[Compared],
    part: PixelRect,
    error: impl Fn(&Planes, &Planes) -> Planes,
) -> Result<Vec<u8>, png::EncodingError> {
    let [width, height] = (part.max - part.min).to_array();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 3 * width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_animated(all.len() as u32, 0)?;
    encoder.set_frame_delay(1, FRAMES_A_SECOND)?;
    let mut writer = encoder.write_header()?;
    for own in all {
        let errors = error(&own.truth, &own.image);
        let mut pixels = vec![GREY; (9 * width * height) as usize];
        let corner = own.rect.min - part.min;
        for (column, planes) in (0..).zip([&own.truth, &own.image, &errors]) {
            let first = [column * width + corner.x, corner.y].map(|v| v as usize);
            put(&mut pixels, 3 * width as usize, first, planes);
        }
        writer.write_image_data(&pixels)?;
    }
    writer.finish()?;
    Ok(bytes)
}

/// Puts planes into RGB rows of so many pixels, from a column and row on.
fn put(pixels: &mut [u8], width: usize, [x, y]: [usize; 2], planes: &Planes) {
    let plane = planes.size[0] * planes.size[1];
    for at in 0..plane {
        let to = (y + at / planes.size[0]) * width + x + at % planes.size[0];
        for channel in 0..3 {
            let value = planes.data[channel * plane + at].clamp(0.0, 1.0);
            pixels[3 * to + channel] = (255.0 * value).round() as u8;
        }
    }
}
