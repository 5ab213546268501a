//! How much images would lose without each row.
//!
//! A row of a small Gaussian, or of one that is seldom seen, costs less than another of the same
//! variance, and so does one of an attribute that changes images little.
//! [`raster::contributions`] says how visible a Gaussian is in an image. The gain of an attribute
//! is measured by leaving all of it out. Images show whole bodies, so detail that only a close view
//! would show counts for little.

use crate::likeness::camera_at;
use crate::prune::subject::RowSubject;
use effigy_core::avatar::{Avatar, Rows};
use effigy_core::reference::{Canvas, ReferenceFrame, raster};
use effigy_core::scene::{AvatarBounds, Camera, Posed};
use effigy_math::sampling::evenly_spaced;
use half::f16;

/// Poses that are drawn, each from one side.
const DRAWN: usize = 24;
/// Degrees around the avatar.
const YAWS: [f64; 4] = [70.0, 160.0, 250.0, 340.0];
/// Radians above the horizon.
const PITCHES: [f64; 3] = [0.09, 0.6, -0.5];
const SIZE: [u32; 2] = [384, 512];
/// How visible a Gaussian is that no image shows, as a share of the mean.
const UNSEEN: f64 = 0.01;

/// For each row of rotation, scale and colour, the error of images without it: squared differences,
/// summed over pixels and the drawn poses. `gaussians` are the rows' Gaussians;
/// `variances` the rows' variances, of the same shape.
pub fn image_costs(
    subject: &RowSubject,
    avatar: &Avatar,
    gaussians: [&Vec<u32>; 3],
    variances: [Vec<f64>; 3],
) -> [Vec<f64>; 3] {
    let without: [Avatar; 3] = std::array::from_fn(|attribute| {
        without_attribute(avatar, &subject.mean[attribute], attribute)
    });
    // How much all images show of each Gaussian, and what they lose without each attribute.
    let mut visibility = vec![0.0; avatar.gaussians.len()];
    let mut losses = [0.0; 3];
    for view in views(subject, avatar) {
        let whole = ReferenceFrame::new(avatar, &view.posed, &view.camera);
        let shown = raster::contributions(&whole.splats, &whole.order, &view.camera);
        for (visibility, shown) in visibility.iter_mut().zip(shown) {
            *visibility += shown;
        }
        for (loss, avatar) in losses.iter_mut().zip(&without) {
            let reduced = ReferenceFrame::new(avatar, &view.posed, &view.camera);
            *loss += squared_difference(&whole.canvas, &reduced.canvas);
        }
    }
    let min_visibility = UNSEEN * visibility.iter().sum::<f64>() / visibility.len().max(1) as f64;
    let mut costs = variances;
    for a in 0..3 {
        for (cost, &k) in costs[a].iter_mut().zip(gaussians[a]) {
            *cost *= visibility[k as usize].max(min_visibility);
        }
        // The rows of an attribute together cost what images lose without it.
        let all: f64 = costs[a].iter().sum();
        let scale = if all > 0.0 { losses[a] / all } else { 0.0 };
        for cost in &mut costs[a] {
            *cost *= scale;
        }
    }
    costs
}

/// A pose and a camera.
struct ContributionView {
    posed: Posed,
    camera: Camera,
}

/// Some poses, seen from all sides in turn.
fn views(subject: &RowSubject, avatar: &Avatar) -> impl Iterator<Item = ContributionView> {
    let bounds = AvatarBounds::new(avatar);
    let all: Vec<usize> = (0..subject.poses.len()).collect();
    evenly_spaced(&all, DRAWN)
        .into_iter()
        .enumerate()
        .map(move |(i, pose)| {
            let yaw = YAWS[i % YAWS.len()];
            let pitch = PITCHES[i % PITCHES.len()];
            let posed = Posed::new(avatar, subject.poses[pose]);
            let camera = camera_at(&bounds, &posed, yaw, pitch, SIZE);
            ContributionView { posed, camera }
        })
}

/// An avatar without the rows of one attribute. Its Gaussians have their mean instead, as pruned
/// ones do.
fn without_attribute(avatar: &Avatar, mean: &[f32], attribute: usize) -> Avatar {
    fn set_means<const C: usize>(numbers: &mut [[f16; C]], means: &[f32]) {
        for (own, mean) in numbers.iter_mut().zip(means.as_chunks::<C>().0) {
            *own = mean.map(f16::from_f32);
        }
    }
    let mut avatar = avatar.clone();
    match attribute {
        0 => {
            avatar.rotation_rows = Rows::default();
            set_means(&mut avatar.gaussians.rotation, mean);
        }
        1 => {
            avatar.scale_rows = Rows::default();
            set_means(&mut avatar.gaussians.log_scale, mean);
        }
        _ => {
            avatar.color_rows = Rows::default();
            set_means(&mut avatar.gaussians.color, mean);
        }
    }
    avatar
}

/// Squared differences of two canvases' colours, summed.
fn squared_difference(a: &Canvas, b: &Canvas) -> f64 {
    a.pixels
        .iter()
        .zip(&b.pixels)
        .flat_map(|(a, b)| (0..3).map(|c| (a[c] - b[c]).powi(2)))
        .sum()
}
