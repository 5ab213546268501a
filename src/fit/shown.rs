//! An unpruned avatar, its training frames and its rows' variances in; what pictures of those frames would lose with each row, out.
//!
//! A row of a Gaussian that is seldom seen, or is small, costs less than another of the same variance, and so does one of an attribute that
//! changes the picture little: in the training clips of the demo all correctives of rotation and scale together are worth 0.3 dB, those of
//! colour 10. How much a picture shows of a Gaussian is [`raster::shown`]; what an attribute is worth is measured by leaving all of it out.
//! Pictures are of whole bodies: what only a closer view would show counts for what it is there.

use super::dataset::Dataset;
use super::evaluate::{camera_at, some};
use super::solve::Ground;
use crate::avatar::{Avatar, Rows};
use crate::frame::{Camera, Extent, Posed};
use crate::reference::{Canvas, Stages, raster};
use half::f16;

/// Training frames that are drawn, each from one side.
const FRAMES: usize = 24;
/// Degrees around the avatar: sides other than those that `effigy evaluate` looks from unless told.
const YAWS: [f64; 4] = [70.0, 160.0, 250.0, 340.0];
/// Radians above the horizon.
const PITCHES: [f64; 3] = [0.09, 0.6, -0.5];
const SIZE: [u32; 2] = [384, 512];
/// What counts as seen of a Gaussian that no picture shows, as a share of the mean.
const UNSEEN: f64 = 0.01;

/// What a picture is off by where rows are left out: for each row of rotation, scale and colour, squared differences summed over pixels and
/// the drawn frames. Same shape as `variances`; `rows` are their Gaussians.
pub fn costs(ground: &Ground, avatar: &Avatar, rows: [&Vec<u32>; 3], variances: [Vec<f64>; 3]) -> [Vec<f64>; 3] {
    let without: [Avatar; 3] = std::array::from_fn(|attribute| without(avatar, &ground.statistics.mean[attribute], attribute));
    let mut seen = vec![0.0; avatar.gaussians.len()];
    let mut lost = [0.0; 3];
    for (posed, camera) in views(ground.dataset, &ground.training, avatar) {
        let whole = Stages::new(avatar, &posed, &camera);
        let shown = raster::shown(&whole.splats, &whole.order, &camera);
        seen.iter_mut().zip(shown).for_each(|(seen, shown)| *seen += shown);
        for (lost, avatar) in lost.iter_mut().zip(&without) {
            *lost += difference(&whole.canvas, &Stages::new(avatar, &posed, &camera).canvas);
        }
    }
    let least = UNSEEN * seen.iter().sum::<f64>() / seen.len().max(1) as f64;
    let mut costs = variances;
    for ((costs, rows), lost) in costs.iter_mut().zip(rows).zip(lost) {
        costs.iter_mut().zip(rows).for_each(|(cost, &k)| *cost *= seen[k as usize].max(least));
        let all: f64 = costs.iter().sum();
        let scale = if all > 0.0 { lost / all } else { 0.0 };
        costs.iter_mut().for_each(|cost| *cost *= scale);
    }
    costs
}

/// Poses of training frames, and cameras around them.
fn views(dataset: &Dataset, training: &[usize], avatar: &Avatar) -> impl Iterator<Item = (Posed, Camera)> {
    let extent = Extent::new(&dataset.avatar);
    let sides = YAWS.into_iter().cycle().zip(PITCHES.into_iter().cycle());
    some(training, FRAMES).into_iter().zip(sides).map(move |(frame, (yaw, pitch))| {
        let posed = Posed::new(avatar, &dataset.poses[frame]);
        let camera = camera_at(&extent, &posed, yaw, pitch, SIZE);
        (posed, camera)
    })
}

/// An avatar without the rows of one attribute: its Gaussians have their means instead, as pruned ones do.
fn without(avatar: &Avatar, mean: &[f32], attribute: usize) -> Avatar {
    fn means<const C: usize>(of: &mut [[f16; C]], mean: &[f32]) {
        of.iter_mut().zip(mean.chunks_exact(C)).for_each(|(own, mean)| *own = std::array::from_fn(|c| f16::from_f32(mean[c])));
    }
    let mut avatar = avatar.clone();
    let Avatar { gaussians, rotation_rows, scale_rows, color_rows, .. } = &mut avatar;
    match attribute {
        0 => {
            *rotation_rows = Rows::default();
            means(&mut gaussians.rotation, mean);
        }
        1 => {
            *scale_rows = Rows::default();
            means(&mut gaussians.log_scale, mean);
        }
        _ => {
            *color_rows = Rows::default();
            means(&mut gaussians.color, mean);
        }
    }
    avatar
}

/// Squared differences of the colours of two canvases, summed.
fn difference(a: &Canvas, b: &Canvas) -> f64 {
    a.pixels.iter().zip(&b.pixels).flat_map(|(a, b)| (0..3).map(|c| (a[c] - b[c]).powi(2))).sum()
}
