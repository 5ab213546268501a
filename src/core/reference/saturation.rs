//! Stage `saturation`: behind which splat hardly anything shows, at samples for four pixels each.

use super::{
    project::{Culled, Splat},
    raster::DrawnSplat,
};
use crate::scene::Camera;
use glam::DVec2;

/// From a sample to the four pixels around it, px.
const AROUND: [DVec2; 4] = [
    DVec2::new(-0.5, -0.5),
    DVec2::new(0.5, -0.5),
    DVec2::new(-0.5, 0.5),
    DVec2::new(0.5, 0.5),
];

/// The splat with which each sample is saturated: after it, less than `threshold` of what lies
/// behind shows. None where no splat does that. `order`: far to near. Samples lie where four pixels
/// meet, at (2 i + 1, 2 j + 1) px, row by row from the top left, also beyond the image's edge. A
/// splat has its least opacity at the four pixels, so that at none of them more shows.
pub fn saturating(
    splats: &[Result<Splat, Culled>],
    order: &[u32],
    camera: &Camera,
    threshold: f64,
) -> Vec<Option<u32>> {
    let [width, height] = camera.size.map(|side| side.div_ceil(2) as usize);
    let mut light = vec![1.0; width * height];
    let mut found = vec![None; width * height];
    for &k in order.iter().rev() {
        let Ok(splat) = &splats[k as usize] else {
            continue;
        };
        let ellipse = DrawnSplat::new(splat, camera);
        // Sample i lies at 2 i + 1.
        let first = |axis: usize| ((splat.center[axis] - splat.radius[axis] - 1.0) / 2.0).ceil();
        let last = |axis: usize| ((splat.center[axis] + splat.radius[axis] - 1.0) / 2.0).floor();
        // The casts saturate at 0.
        let end = |axis: usize, count: usize| ((last(axis) + 1.0) as usize).min(count);
        for y in first(1) as usize..end(1, height) {
            for x in first(0) as usize..end(0, width) {
                let at = DVec2::new(2.0 * x as f64 + 1.0, 2.0 * y as f64 + 1.0);
                let sample = y * width + x;
                if light[sample] < threshold {
                    continue;
                }
                // None where it does not show at one of them.
                let least = AROUND
                    .map(|step| ellipse.visible_alpha_at(at + step))
                    .into_iter()
                    .try_fold(1.0, |least: f64, alpha| Some(least.min(alpha?)));
                if let Some(alpha) = least {
                    light[sample] *= 1.0 - alpha;
                    if light[sample] < threshold {
                        found[sample] = Some(k);
                    }
                }
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn splat(center: DVec2, opacity: f64) -> Result<Splat, Culled> {
        Ok(Splat {
            center,
            depth: 1.0,
            covariance: [4.0, 0.0, 4.0],
            determinant: 16.0,
            radius: DVec2::splat(6.0),
            opacity,
            color: DVec3::ONE,
        })
    }

    #[test]
    fn a_sample_is_saturated_by_the_splat_that_takes_its_last_light() {
        let camera = Camera::look_at(DVec3::Z, DVec3::ZERO, 0.6, [16, 9]);
        let at = DVec2::new(5.0, 3.0);
        // Far to near. At the centre two of 0.9 leave 0.01, a third 0.001.
        let splats = [0.9, 0.9, 0.9].map(|opacity| splat(at, opacity));
        let found = saturating(&splats, &[0, 1, 2], &camera, 0.005);
        assert_eq!(found.len(), 8 * 5);
        assert_eq!(found[8 + 2], Some(0), "the sample at (5, 3)");
        assert_eq!(found[8 + 7], None, "the sample at (15, 3)");
        let found = saturating(&splats, &[0, 1, 2], &camera, 0.5);
        assert_eq!(found[8 + 2], Some(2));
    }
}
