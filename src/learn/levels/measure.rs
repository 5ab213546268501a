//! How far images of a level are from what they should be.

use super::views::{LevelTarget, UNIT, whole_splats};
use effigy_core::avatar::{Avatar, LevelError};
use effigy_core::constants::ALPHA_MIN;
use effigy_core::scene::FrameImage;
use effigy_math::splatter::Blended;
use glam::{DVec4, Vec4};
use rayon::prelude::*;

/// Equal images count as this, dB.
const MOST_DB: f64 = 100.0;

/// Draws an avatar in a target's view, `units` tall with `samples` a pixel along each axis.
pub fn draw(avatar: &Avatar, target: &LevelTarget, units: usize, samples: usize) -> FrameImage {
    let splats = whole_splats(avatar, &target.view, units * samples);
    let size = target.view.camera_at(units * samples).size;
    Blended::new(&splats, size, |_, _, _| ())
        .image
        .averaged(samples as u32)
}

/// The sum of an image's pixels.
fn sum_of(image: &FrameImage) -> Vec4 {
    image.pixels.iter().copied().map(Vec4::from).sum()
}

/// The errors of an avatar's images at a size, which must not be larger than the targets'.
pub fn measure(
    avatar: &Avatar,
    targets: &[LevelTarget],
    units: usize,
    samples: usize,
) -> LevelError {
    struct ViewErrors {
        psnr_db: f64,
        got: Vec4,
        expected: Vec4,
    }
    let compare = |target: &LevelTarget| {
        let image = draw(avatar, target, units, samples);
        let truth = target.truth(units);
        let mut squares = 0.0;
        let mut covered = 0;
        for (&got, &expected) in image.pixels.iter().zip(&truth.pixels) {
            let [got, expected] = [got, expected].map(Vec4::from);
            if f64::from(expected.w) >= ALPHA_MIN {
                squares += f64::from((got - expected).length_squared());
                covered += 1;
            }
        }
        let mean = squares / (4 * covered.max(1)) as f64;
        ViewErrors {
            psnr_db: (-10.0 * mean.log10()).min(MOST_DB),
            got: sum_of(&image),
            expected: sum_of(&truth),
        }
    };
    let all: Vec<ViewErrors> = targets.par_iter().map(compare).collect();
    let sum =
        |of: fn(&ViewErrors) -> Vec4| -> DVec4 { all.iter().map(|one| of(one).as_dvec4()).sum() };
    let expected = sum(|one| one.expected);
    let off = sum(|one| one.got) / expected.max(DVec4::splat(f64::MIN_POSITIVE)) - 1.0;
    let off = off.clamp(DVec4::splat(-1.0), DVec4::ONE);
    let larger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
    LevelError {
        height: (units * UNIT) as f64,
        samples: samples as u32,
        psnr_db: all.iter().map(|one| one.psnr_db).sum::<f64>() / all.len().max(1) as f64,
        color: larger(larger(off.x, off.y), off.z),
        coverage: off.w,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::levels::still::still;
    use crate::levels::views::{self, targets};
    use effigy_core::avatar::{Level, motion::Player};
    use effigy_core::reference;
    use effigy_measure::error;

    fn demo() -> (Avatar, Vec<views::LevelView>) {
        let avatar = effigy_demo::avatar().expect("inside the program");
        let clip = effigy_demo::clip().expect("inside the program");
        let player = Player::new(clip, &avatar.skeleton);
        let views = views::views(&avatar, &[player.pose(0.7)], 2, 9);
        (avatar, views)
    }

    #[test]
    fn images_are_those_of_the_reference() {
        let (mut avatar, views) = demo();
        for filter in [avatar.filter, Level::FILTER] {
            avatar.filter = filter;
            for view in &views {
                let camera = view.camera_at(8);
                let expected = reference::render(&avatar, &view.posed, &camera);
                let splats = whole_splats(&avatar, view, 8);
                let got = Blended::new(&splats, camera.size, |_, _, _| ()).image;
                // Contributions at the cutoff may be there or not, and depths that f32 can't tell
                // apart change places.
                let error = error::between(&got, &expected).covered;
                assert!(error.psnr_db > 60.0, "{error:?} with {filter}");
                assert!(got.pixels.iter().any(|p| p[3] > 0.9));
                // The body is as tall as is asked for, and all of it is in the image.
                let [width, height] = got.size.map(|side| side as usize);
                let rows = (0..height)
                    .filter(|y| got.pixels[y * width..][..width].iter().any(|p| p[3] > 0.1));
                let rows: Vec<usize> = rows.collect();
                assert!((60..=90).contains(&rows.len()), "{} px tall", rows.len());
                assert!(rows[0] > 0 && rows[rows.len() - 1] + 1 < height);
            }
        }
    }

    #[test]
    fn what_equals_the_truth_has_no_error() {
        let (avatar, views) = demo();
        let mut seen = vec![0.0; avatar.gaussians.len()];
        let targets = targets(&avatar, &views, 6, &mut seen, &mut |_| ());
        // Drawn as the truth is.
        let same = measure(&avatar, &targets, 6, 8);
        assert!(
            same.psnr_db == MOST_DB && same.color == 0.0 && same.coverage == 0.0,
            "{same:?}"
        );
        assert_eq!((same.height, same.samples), (60.0, 8));
        let fewer = measure(&avatar, &targets, 6, 2);
        assert!(fewer.psnr_db < 30.0 && fewer.coverage > 0.01, "{fewer:?}");
        // What images show of all Gaussians together is the coverage of the images.
        let covered: f64 = targets
            .iter()
            .map(|target| {
                target
                    .truth(6)
                    .pixels
                    .iter()
                    .map(|p| f64::from(p[3]))
                    .sum::<f64>()
            })
            .sum();
        let all: f64 = seen.iter().sum();
        assert!(
            (all / (64.0 * covered) - 1.0).abs() < 1e-3,
            "{all} of {covered}"
        );
    }

    #[test]
    fn an_avatar_stilled_in_one_pose_looks_the_same_there() {
        let (avatar, views) = demo();
        let still = still(&avatar, &[views[0].posed.input.clone()]);
        assert_eq!(still.check(), Ok(()));
        let mut unused = vec![0.0; avatar.gaussians.len()];
        let targets = targets(&avatar, &views, 6, &mut unused, &mut |_| ());
        let error = measure(&still, &targets, 6, 8);
        assert!(error.psnr_db > 50.0, "{error:?}");
        let neutral = Avatar {
            nodes: effigy_core::avatar::Nodes::still(),
            color_rows: effigy_core::avatar::Rows::default(),
            ..still.clone()
        };
        let mut gaussians = avatar.gaussians.clone();
        gaussians.node.fill([0; 3]);
        let error_without = measure(
            &Avatar {
                gaussians,
                ..neutral
            },
            &targets,
            6,
            8,
        );
        assert!(
            error_without.psnr_db < error.psnr_db - 3.0,
            "{error_without:?}"
        );
    }
}
