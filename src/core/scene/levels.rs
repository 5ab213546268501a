//! Which of an avatar's levels a small image of it is drawn from: the one with the fewest Gaussians
//! of which it was measured that nothing is lost by it.

use crate::avatar::{Avatar, LevelError};

/// A level is drawn where images of it were measured to be at least this near to the truth, dB.
const PSNR: f64 = 31.0;
/// And where its mean colour and coverage were off by no more than this.
const MEAN_ERROR: f64 = 0.01;
/// Hysteresis: an avatar that grows keeps its level up to this many times the height that the level
/// is for.
const HYSTERESIS: f64 = 1.05;

/// A level, as the choice sees it.
#[derive(Clone, Debug, PartialEq)]
pub struct LevelChoice {
    /// Its Gaussians.
    pub gaussians: usize,
    /// Whether networks move it.
    pub correctives: bool,
    /// How far its images are from what they should be.
    measured: Vec<LevelError>,
}

impl LevelChoice {
    /// The levels of an avatar, the finest first.
    pub fn of(avatar: &Avatar) -> Vec<Self> {
        avatar
            .levels
            .iter()
            .map(|level| Self {
                gaussians: level.gaussians.len(),
                correctives: level.correctives,
                measured: level.measured.clone(),
            })
            .collect()
    }

    /// Up to which height an avatar may be drawn from it, px, at so many samples a pixel along each
    /// axis. What was measured at other numbers of samples says nothing of these but what lies
    /// between: a level that covers what it should at few covers too little at more.
    fn tallest(&self, samples: f64) -> f64 {
        self.measured
            .iter()
            .filter(|error| f64::from(error.samples) <= samples)
            .filter(|fewer| {
                self.measured
                    .iter()
                    .filter(|error| error.height == fewer.height)
                    .any(|more| between(fewer, more, samples).is_some_and(|error| error.is_near()))
            })
            .map(|error| error.height)
            .fold(0.0, f64::max)
    }
}

/// How far images are from what they should be.
struct Error {
    /// dB.
    psnr: f64,
    /// Of the mean colour and coverage, as shares.
    means: [f64; 2],
}

impl Error {
    /// Whether nothing is lost by it.
    fn is_near(&self) -> bool {
        self.psnr >= PSNR && self.means.iter().all(|mean| mean.abs() <= MEAN_ERROR)
    }
}

/// The error at a number of samples between those of two measurements of one height; None where it
/// is not between. A sample's low-pass is as wide as its share of a pixel, so that errors are taken
/// to follow that.
fn between(fewer: &LevelError, more: &LevelError, samples: f64) -> Option<Error> {
    let [from, to, at] = [fewer.samples.into(), more.samples.into(), samples].map(f64::recip);
    let share = if from == to {
        0.0
    } else {
        (at - from) / (to - from)
    };
    let is_between = at <= from && at >= to && from >= to;
    let mix = |from: f64, to: f64| (1.0 - share) * from + share * to;
    is_between.then(|| Error {
        psnr: mix(fewer.psnr_db, more.psnr_db),
        means: [
            mix(fewer.color, more.color),
            mix(fewer.coverage, more.coverage),
        ],
    })
}

/// The level to draw an avatar from that is so tall in the image, px, at so many samples a pixel
/// along each axis; 0 is the avatar itself, then its levels follow, the finest first. `before`: as
/// the last frame drew it.
pub fn choose(levels: &[LevelChoice], height: f64, samples: f64, before: usize) -> usize {
    (1..=levels.len())
        .rev()
        .find(|&number| {
            let keeps = if number <= before { HYSTERESIS } else { 1.0 };
            height <= keeps * levels[number - 1].tallest(samples)
        })
        .unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level(gaussians: usize, limits: &[(u32, f64)]) -> LevelChoice {
        LevelChoice {
            gaussians,
            correctives: false,
            measured: limits
                .iter()
                .map(|&(samples, height)| LevelError {
                    height,
                    samples,
                    psnr_db: 40.0,
                    color: 0.0,
                    coverage: 0.0,
                })
                .collect(),
        }
    }

    #[test]
    fn the_coarsest_level_that_was_near_enough_is_drawn() {
        let levels = [
            level(400, &[(2, 100.0), (4, 200.0)]),
            level(100, &[(4, 60.0)]),
            level(25, &[]),
        ];
        let choose = |height, samples| choose(&levels, height, samples, 0);
        assert_eq!(
            [10.0, 60.0, 61.0, 200.0, 201.0].map(|height| choose(height, 4.0)),
            [2, 2, 1, 1, 0]
        );
        assert_eq!(
            [10.0, 100.0, 150.0].map(|height| choose(height, 2.0)),
            [1, 1, 0]
        );
        assert_eq!(choose(10.0, 1.0), 0);
        assert_eq!(super::choose(&[], 10.0, 4.0, 0), 0);
        assert_eq!(choose(f64::NAN, 4.0), 0);
    }

    #[test]
    fn a_level_counts_where_it_was_measured_to_be_near() {
        let error = |height, samples, psnr_db, color, coverage| LevelError {
            height,
            samples,
            psnr_db,
            color,
            coverage,
        };
        let mut avatar = crate::demo::avatar().expect("inside the program");
        let kept: Vec<usize> = (0..10).collect();
        let measured = vec![
            error(30.0, 2, 30.2, 0.038, 0.028),
            error(30.0, 4, 36.7, -0.002, -0.003),
            error(60.0, 2, 32.6, -0.002, -0.003),
            error(60.0, 4, 32.5, -0.017, -0.016),
        ];
        avatar.levels = vec![crate::avatar::Level {
            gaussians: avatar.gaussians.pick(&kept),
            part_start: vec![],
            correctives: false,
            rotation_rows: crate::avatar::Rows::default(),
            scale_rows: crate::avatar::Rows::default(),
            color_rows: crate::avatar::Rows::default(),
            sh: None,
            measured,
        }];
        let levels = LevelChoice::of(&avatar);
        // At 60 px 2.2 samples are within 1 % too, and 3.9 at 30 px.
        let samples = [1.0, 1.9, 2.0, 2.2, 3.9, 4.0, 4.1];
        let tallest = samples.map(|samples| levels[0].tallest(samples));
        assert_eq!(tallest, [0.0, 0.0, 60.0, 60.0, 30.0, 30.0, 0.0]);
    }

    #[test]
    fn a_level_stays_until_it_is_left_behind() {
        let levels = [level(400, &[(4, 200.0)]), level(100, &[(4, 60.0)])];
        let mut before = 0;
        let walk = [59.0, 62.0, 64.0, 62.0, 205.0, 215.0, 205.0].map(|height| {
            before = choose(&levels, height, 4.0, before);
            before
        });
        assert_eq!(walk, [2, 2, 1, 1, 1, 0, 0]);
    }
}
