//! A strip of pictures: an avatar at some sizes as large as it is shown, as a renderer draws it, and
//! as the area of each pixel shows it, enlarged.

use super::{
    backend::{BenchDevice, Result},
    case::BenchCase,
    check::ReferenceImages,
    run::{CaseRenderer, Progress},
    scene,
    task::BenchTask,
};
use crate::setting::RenderSetting;
use effigy_core::{
    constants::ALPHA_MIN,
    frame::RendererOptions,
    scene::{FrameImage, PixelRect, Supersampling},
};
use glam::UVec2;
use image::{Rgb, RgbImage, imageops};

/// Height of each picture, px.
const HEIGHT: u32 = 480;
/// Between pictures, px.
const GAP: u32 = 8;

/// The pictures of some cases, a column each: above as large as shown, in the middle as the setting
/// draws it, below the truth. Cases whose avatar has no height are left out.
///
/// # Errors
/// When the device fails.
pub fn strip(
    gpu: &BenchDevice,
    task: &BenchTask,
    setting: &RenderSetting,
    cases: &[BenchCase],
    progress: Progress,
) -> Result<RgbImage> {
    let mut columns = vec![];
    let sized: Vec<BenchCase> = cases
        .iter()
        .copied()
        .filter(|case| case.tall().is_some() && case.instances() == 1)
        .collect();
    for (done, &case) in sized.iter().enumerate() {
        progress("drawing the strip", done, sized.len());
        columns.push(column(gpu, task, setting, case)?);
    }
    Ok(beside(&columns))
}

/// The three pictures of a case.
fn column(
    gpu: &BenchDevice,
    task: &BenchTask,
    setting: &RenderSetting,
    case: BenchCase,
) -> Result<[RgbImage; 3]> {
    let setting = setting.for_case(case);
    let scenes = scene::scenes(case, &task.scene_inputs(&setting));
    let at = scenes.len() / 2;
    let drawn = |supersampling: Supersampling| -> Result<FrameImage> {
        let setting = RenderSetting {
            options: RendererOptions {
                supersampling,
                ..setting.options
            },
            ..setting
        };
        let avatar = setting.reduce(task.avatar);
        let mut renderer = CaseRenderer::new(gpu, &avatar, &setting, case, false)?;
        renderer.draw(&scenes[at])?;
        renderer.image()
    };
    let once = drawn(Supersampling::OFF)?;
    let as_set = drawn(setting.options.supersampling)?;
    let mut images = ReferenceImages::new(task.avatar);
    let truth = images.image(at, &scenes[at], case, &setting.options);
    let rect = covered(truth);
    Ok([&once, &as_set, truth].map(|image| enlarged(image, rect)))
}

/// A box around the pixels that show something.
fn covered(image: &FrameImage) -> PixelRect {
    let width = image.size[0] as usize;
    let covered = |pixel: &[f32; 4]| f64::from(pixel[3]) >= ALPHA_MIN;
    let mut rect = PixelRect::EMPTY;
    for (at, _) in image.pixels.iter().enumerate().filter(|own| covered(own.1)) {
        let min = UVec2::new((at % width) as u32, (at / width) as u32);
        rect = rect.union(PixelRect { min, max: min + 1 });
    }
    if rect.is_empty() {
        return PixelRect::whole(image.size);
    }
    PixelRect {
        min: rect.min.saturating_sub(UVec2::ONE),
        max: (rect.max + 1).min(image.size.into()),
    }
}

/// A part of an image over white, each pixel a square.
fn enlarged(image: &FrameImage, rect: PixelRect) -> RgbImage {
    let size = rect.max - rect.min;
    let whole = image.over([1.0; 3]);
    let part = RgbImage::from_fn(size.x, size.y, |x, y| {
        let [r, g, b, _] = whole.get_pixel(rect.min.x + x, rect.min.y + y).0;
        Rgb([r, g, b])
    });
    let width = (f64::from(HEIGHT * size.x) / f64::from(size.y)).round() as u32;
    imageops::resize(&part, width.max(1), HEIGHT, imageops::FilterType::Nearest)
}

fn beside(columns: &[[RgbImage; 3]]) -> RgbImage {
    let width = columns.iter().map(|own| own[0].width() + GAP).sum::<u32>();
    let mut strip = RgbImage::from_pixel(width.max(1), 3 * (HEIGHT + GAP), Rgb([255; 3]));
    let mut x = 0;
    for column in columns {
        for (row, picture) in (0..).zip(column) {
            imageops::replace(&mut strip, picture, x.into(), row * i64::from(HEIGHT + GAP));
        }
        x += column[0].width() + GAP;
    }
    strip
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_are_enlarged_around_what_they_show() {
        let mut image = FrameImage::empty([20, 16]);
        for y in 4..8 {
            image.pixels[y * 20 + 10] = [1.0, 0.0, 0.0, 1.0];
        }
        let rect = covered(&image);
        // A pixel of white around it.
        assert_eq!((rect.min, rect.max), (UVec2::new(9, 3), UVec2::new(12, 9)));
        let picture = enlarged(&image, rect);
        assert_eq!(picture.dimensions(), (HEIGHT / 2, HEIGHT));
        assert_eq!(picture.get_pixel(HEIGHT / 4, HEIGHT / 2).0, [255, 0, 0]);
        assert_eq!(picture.get_pixel(1, 1).0, [255; 3]);
        assert_eq!(
            covered(&FrameImage::empty([3, 2])),
            PixelRect::whole([3, 2])
        );
        let strip = beside(&[[picture.clone(), picture.clone(), picture]]);
        assert_eq!(strip.dimensions(), (HEIGHT / 2 + GAP, 3 * (HEIGHT + GAP)));
    }
}
