//! `effigy evaluate --video`: truth, candidate and error of every frame that a camera saw, as an
//! animated PNG.

use crate::{output::Output, progress};
use anyhow::{Context, ensure};
use effigy_capture::Capture;
use effigy_core::scene::PixelRect;
use effigy_learn::score::{PictureIndex, Scorer};
use effigy_perceptual::Planes;

/// A capture has no rate.
const FRAMES_A_SECOND: u16 = 10;
/// Around what is compared, 0 to 255.
const GREY: u8 = 64;

/// The views of the first camera that is held out, or of the first where none is, in their order.
pub fn views(capture: &Capture) -> Vec<PictureIndex> {
    let held = capture.cameras.iter().position(|camera| camera.held);
    let camera = held.unwrap_or(0);
    (0..capture.frames.len())
        .filter(|&frame| capture.has(camera, frame))
        .map(|frame| PictureIndex { camera, frame })
        .collect()
}

/// Writes [`views`]. `error`: of a truth and an image. A view that can't be compared is grey.
pub fn write(
    out: &Output,
    scorer: &Scorer,
    error: impl Fn(&Planes, &Planes) -> Planes,
) -> anyhow::Result<()> {
    let mut part = PixelRect::EMPTY;
    let mut views = views(scorer.capture);
    // A picture is held at a time: a clip may be long.
    views.retain(|&view| match scorer.rect(view) {
        Ok(Some(rect)) => {
            part.min = part.min.min(rect.min);
            part.max = part.max.max(rect.max);
            true
        }
        _ => false,
    });
    ensure!(
        !views.is_empty(),
        "{}: no frame of the camera shows anybody",
        out.display()
    );
    let bytes = animation(&views, part, scorer, error)
        .with_context(|| format!("{} can't be made", out.display()))?;
    out.write(&bytes)?;
    let name = &scorer.capture.cameras[views[0].camera].name;
    println!("{}: {} frames of {name}", out.display(), views.len());
    Ok(())
}

/// The animation of a part of the picture.
fn animation(
    views: &[PictureIndex],
    part: PixelRect,
    scorer: &Scorer,
    error: impl Fn(&Planes, &Planes) -> Planes,
) -> Result<Vec<u8>, png::EncodingError> {
    let [width, height] = (part.max - part.min).to_array();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 3 * width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_animated(views.len() as u32, 0)?;
    encoder.set_frame_delay(1, FRAMES_A_SECOND)?;
    let mut writer = encoder.write_header()?;
    let bar = progress::items(views.len() as u64, "frames");
    for &view in views {
        let mut pixels = vec![GREY; 9 * width as usize * height as usize];
        match scorer.compare(view) {
            Ok(Some(own)) => {
                let errors = error(&own.truth, &own.image);
                let corner = own.rect.min - part.min;
                for (column, planes) in (0..).zip([&own.truth, &own.image, &errors]) {
                    let first = [column * width + corner.x, corner.y].map(|v| v as usize);
                    put(&mut pixels, 3 * width as usize, first, planes);
                }
            }
            Ok(None) => {}
            Err(error) => progress::say(&bar, format_args!("{error}")),
        }
        writer.write_image_data(&pixels)?;
        bar.inc(1);
    }
    writer.finish()?;
    bar.finish_and_clear();
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
