//! An unpruned avatar, its training frames and its rows' variances in; what pictures of those frames would lose with each row, out.
//!
//! A row of a Gaussian that is seldom seen, or is small, costs less than another of the same variance, and so does one of an attribute that
//! changes the picture little: in the training clips of the demo all correctives of rotation and scale together are worth 0.3 dB, those of
//! colour 10. How much a picture shows of a Gaussian is [`raster::shown`]; what an attribute is worth is measured by leaving all of it out.

use super::dataset::Dataset;
use super::evaluate::{camera, some};
use crate::avatar::{Avatar, Rows};
use crate::frame::{Camera, Extent, Posed};
use crate::reference::{Canvas, Stages, raster};

/// Training frames that are drawn, each from one side.
const FRAMES: usize = 24;
/// Degrees around the avatar: sides other than those `effigy evaluate` looks from.
const YAWS: [f64; 4] = [70.0, 160.0, 250.0, 340.0];
const SIZE: [u32; 2] = [384, 512];

/// What a picture is off by where rows are left out: for each row of rotation, scale and colour, squared differences summed over pixels and
/// the drawn frames. Same shape as `variances`; `rows` are their Gaussians.
pub fn costs(dataset: &Dataset, training: &[usize], avatar: &Avatar, rows: [&Vec<u32>; 3], variances: [Vec<f64>; 3]) -> [Vec<f64>; 3] {
    let extent = Extent::new(&dataset.avatar);
    let without: [Avatar; 3] = std::array::from_fn(|attribute| without(avatar, attribute));
    let mut seen = vec![0.0; avatar.gaussians.len()];
    let mut lost = [0.0; 3];
    for (frame, yaw) in some(training, FRAMES).into_iter().zip(YAWS.into_iter().cycle()) {
        let posed = Posed::new(avatar, &dataset.poses[frame]);
        let camera = camera(&extent, &posed, yaw, SIZE);
        let draw = |avatar: &Avatar, camera: &Camera| Stages::new(avatar, &posed, camera);
        let whole = draw(avatar, &camera);
        let shown = raster::shown(&whole.splats, &whole.order, &camera);
        seen.iter_mut().zip(shown).for_each(|(seen, shown)| *seen += shown);
        for (lost, avatar) in lost.iter_mut().zip(&without) {
            *lost += difference(&whole.canvas, &draw(avatar, &camera).canvas);
        }
    }
    let mut costs = variances;
    for ((costs, rows), lost) in costs.iter_mut().zip(rows).zip(lost) {
        costs.iter_mut().zip(rows).for_each(|(cost, &k)| *cost *= seen[k as usize]);
        let all: f64 = costs.iter().sum();
        let scale = if all > 0.0 { lost / all } else { 0.0 };
        costs.iter_mut().for_each(|cost| *cost *= scale);
    }
    costs
}

/// An avatar without the rows of one attribute.
fn without(avatar: &Avatar, attribute: usize) -> Avatar {
    let mut avatar = avatar.clone();
    match attribute {
        0 => avatar.rotation_rows = Rows::default(),
        1 => avatar.scale_rows = Rows::default(),
        _ => avatar.color_rows = Rows::default(),
    }
    avatar
}

/// Squared differences of two canvases, summed.
fn difference(a: &Canvas, b: &Canvas) -> f64 {
    a.pixels.iter().flatten().zip(b.pixels.iter().flatten()).map(|(a, b)| (a - b).powi(2)).sum()
}
