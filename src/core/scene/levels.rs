//! Which of an avatar's levels a small image of it is drawn from, and with how many samples: the level
//! with the fewest Gaussians of which it was measured that nothing is lost by it.
//!
//! A level has a size at which its mean colour and coverage are right. Drawn smaller it is too fat, for
//! each Gaussian is enlarged by the low-pass; drawn larger it is too thin, since the low-pass no longer
//! closes what is open between Gaussians. So as an avatar shrinks, samples make up for it, until a
//! coarser level takes over where both are right.

use crate::avatar::{Avatar, LevelError};

/// A level is drawn where images of it were measured to be at least this near to the truth, dB, of an
/// avatar of [`BASE_HEIGHT`] or less; of larger ones [`DOUBLING`] more for each doubling.
const PSNR: f64 = 32.0;
/// px.
const BASE_HEIGHT: f64 = 60.0;
/// dB.
const DOUBLING: f64 = 3.0;
/// And where neither mean colour nor coverage were less than they should be by more than this.
const MEAN_ERROR: f64 = 0.01;
/// Hysteresis: an avatar that grows keeps its level up to this many times the height that the level
/// is for.
const HYSTERESIS: f64 = 1.05;
/// How often the range is halved in which a level's number of samples is looked for.
const HALVINGS: usize = 20;

/// A level, as the choice sees it.
#[derive(Clone, Debug, PartialEq)]
pub struct LevelChoice {
    /// Its Gaussians.
    pub gaussians: usize,
    /// Whether networks move it.
    pub correctives: bool,
    /// How far its images are from what they should be.
    measured: Vec<MeasuredHeight>,
}

/// What was measured at a height.
#[derive(Clone, Debug, PartialEq)]
struct MeasuredHeight {
    /// px.
    height: f64,
    /// By samples, the fewest first.
    errors: Vec<LevelError>,
}

/// What is drawn of an avatar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LevelAndSamples {
    /// 0 is the avatar itself, then its levels follow, the finest first.
    pub level: usize,
    /// Samples a pixel along each axis.
    pub samples: f64,
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
                measured: by_height(&level.measured),
            })
            .collect()
    }

    /// How far images of so tall an avatar, px, with so many samples are from what they should be.
    /// Between what was measured, errors follow the logarithm of the height and the width of a sample.
    /// Avatars smaller than that are as the smallest; None for larger ones, and for more or fewer
    /// samples, of which nothing is known.
    fn error(&self, height: f64, samples: f64) -> Option<Error> {
        let above = self.measured.iter().find(|own| own.height >= height)?;
        let below = self.measured.iter().rfind(|own| own.height <= height);
        let own = above.error(samples)?;
        let Some(below) = below.filter(|below| below.height < above.height) else {
            return Some(own);
        };
        let share = (height / below.height).ln() / (above.height / below.height).ln();
        Some(below.error(samples)?.towards(own, share))
    }

    /// With how many samples, at most `most`, the mean of so tall an avatar, px, is nearest to right.
    /// None where nothing was measured.
    fn samples(&self, height: f64, most: f64) -> Option<f64> {
        let measured = self.measured.iter().find(|own| own.height >= height)?;
        let fewest = f64::from(measured.errors.first()?.samples);
        let most = most.min(f64::from(measured.errors.last()?.samples));
        let excess = |samples| Some(self.error(height, samples)?.means.iter().sum::<f64>());
        if excess(most)? >= 0.0 {
            return Some(most);
        }
        // The fewer samples, the fatter it is.
        let [mut thin, mut fat] = [most, fewest];
        if excess(fat)? <= 0.0 {
            return Some(fat);
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (thin + fat);
            if excess(middle)? <= 0.0 {
                thin = middle;
            } else {
                fat = middle;
            }
        }
        Some(fat)
    }

    /// Whether nothing is lost by it where so tall an avatar, px, is drawn with so many samples.
    fn is_near(&self, height: f64, samples: f64) -> bool {
        let least = PSNR + DOUBLING * (height / BASE_HEIGHT).max(1.0).log2();
        self.error(height, samples)
            .is_some_and(|error| error.is_near(least))
    }
}

/// What was measured, by height and by samples.
fn by_height(measured: &[LevelError]) -> Vec<MeasuredHeight> {
    let mut all = measured.to_vec();
    all.sort_by(|a, b| {
        a.height
            .total_cmp(&b.height)
            .then(a.samples.cmp(&b.samples))
    });
    all.chunk_by(|a, b| a.height == b.height)
        .map(|errors| MeasuredHeight {
            height: errors[0].height,
            errors: errors.to_vec(),
        })
        .collect()
}

impl MeasuredHeight {
    fn error(&self, samples: f64) -> Option<Error> {
        let more = self
            .errors
            .iter()
            .find(|own| f64::from(own.samples) >= samples)?;
        let fewer = self
            .errors
            .iter()
            .rfind(|own| f64::from(own.samples) <= samples)?;
        let [from, to] = [fewer, more].map(Error::of);
        if fewer.samples == more.samples {
            return Some(from);
        }
        let [few, many] = [fewer, more].map(|own| f64::from(own.samples).recip());
        Some(from.towards(to, (few - samples.recip()) / (few - many)))
    }
}

/// How far images are from what they should be.
#[derive(Clone, Copy, Debug)]
struct Error {
    /// dB.
    psnr: f64,
    /// Of the mean colour and coverage, as shares; above 0 where there is too much.
    means: [f64; 2],
}

impl Error {
    fn of(measured: &LevelError) -> Self {
        Self {
            psnr: measured.psnr_db,
            means: [measured.color, measured.coverage],
        }
    }

    /// This error, a share of the way towards another.
    fn towards(self, other: Self, share: f64) -> Self {
        let mix = |from: f64, to: f64| (1.0 - share) * from + share * to;
        Self {
            psnr: mix(self.psnr, other.psnr),
            means: std::array::from_fn(|k| mix(self.means[k], other.means[k])),
        }
    }

    /// Whether nothing is lost by it. What is too fat would be fatter with more Gaussians.
    fn is_near(self, psnr: f64) -> bool {
        let least = self.means[0].min(self.means[1]);
        least >= -MEAN_ERROR && (self.psnr >= psnr || least > MEAN_ERROR)
    }
}

/// What is drawn of an avatar that is so tall in the image, px, with at most so many samples a pixel:
/// the coarsest level by which nothing is lost. `before`: the level that the last frame drew.
pub fn choose(levels: &[LevelChoice], height: f64, most: f64, before: usize) -> LevelAndSamples {
    coarsest(levels, height, before, |level, height| {
        level.samples(height, most)
    })
    .unwrap_or(LevelAndSamples {
        level: 0,
        samples: most,
    })
}

/// [`choose`] where so many samples are given.
pub fn choose_with(levels: &[LevelChoice], height: f64, samples: f64, before: usize) -> usize {
    coarsest(levels, height, before, |_, _| Some(samples)).map_or(0, |found| found.level)
}

/// `samples`: those of a level at a height, px.
fn coarsest(
    levels: &[LevelChoice],
    height: f64,
    before: usize,
    samples: impl Fn(&LevelChoice, f64) -> Option<f64>,
) -> Option<LevelAndSamples> {
    (1..=levels.len()).rev().find_map(|level| {
        let keeps = if level <= before { HYSTERESIS } else { 1.0 };
        let own = &levels[level - 1];
        let samples = samples(own, height / keeps)?;
        own.is_near(height / keeps, samples)
            .then_some(LevelAndSamples { level, samples })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A level that is right where it is drawn so tall, px, and is measured up to so large an avatar.
    fn level(gaussians: usize, right: f64, tallest: f64) -> LevelChoice {
        let error = |height: f64, samples: u32| {
            // By a tenth of a doubling in size the mean changes by 0.3 %.
            let color = 0.03 * (right / (height * f64::from(samples))).log2();
            LevelError {
                height,
                samples,
                psnr_db: 40.0 - 200.0 * color.abs(),
                color,
                coverage: color,
            }
        };
        let measured: Vec<_> = [20.0, 30.0, 40.0, 60.0, 80.0, 120.0, 240.0]
            .into_iter()
            .filter(|&height| height <= tallest)
            .flat_map(|height| [error(height, 4), error(height, 2)])
            .collect();
        LevelChoice {
            gaussians,
            correctives: false,
            measured: by_height(&measured),
        }
    }

    fn body() -> [LevelChoice; 3] {
        [
            level(50_000, 480.0, 240.0),
            level(12_500, 240.0, 120.0),
            level(3_125, 120.0, 60.0),
        ]
    }

    #[test]
    fn the_coarsest_level_that_is_near_enough_is_drawn() {
        let levels = body();
        let choose = |height, most| choose(&levels, height, most, 0).level;
        assert_eq!(
            [5.0, 20.0, 60.0, 61.0, 120.0, 121.0, 240.0, 241.0].map(|height| choose(height, 4.0)),
            [3, 3, 3, 2, 2, 1, 1, 0]
        );
        // Of fewer than two samples nothing is known.
        assert_eq!(choose(60.0, 1.9), 0);
        assert_eq!(super::choose(&[], 10.0, 4.0, 0).samples, 4.0);
        assert_eq!(
            [f64::NAN, f64::INFINITY].map(|height| choose(height, 4.0)),
            [0, 0]
        );
    }

    /// Samples make up for the size, so that the mean has no steps where the level changes.
    #[test]
    fn means_are_right_at_every_size() {
        let levels = body();
        let mut height = 30.0;
        while height < 240.0 {
            let chosen = choose(&levels, height, 4.0, 0);
            let error = levels[chosen.level - 1]
                .error(height, chosen.samples)
                .expect("it was measured");
            assert!(
                (2.0..=4.0).contains(&chosen.samples),
                "{height} px: {chosen:?}"
            );
            assert!(
                error.means[0].abs() < 4e-3,
                "{height} px, {chosen:?}: {error:?}"
            );
            height *= 1.01;
        }
        // Smaller ones are too fat with any level: least so with the coarsest and most samples.
        assert_eq!(
            choose(&levels, 10.0, 4.0, 0),
            LevelAndSamples {
                level: 3,
                samples: 4.0
            }
        );
    }

    #[test]
    fn where_samples_are_given_the_level_follows_them() {
        let levels = body();
        let at = |samples| choose_with(&levels, 60.0, samples, 0);
        assert_eq!([4.0, 2.6, 2.4, 2.0, 1.5].map(at), [2, 2, 3, 3, 0]);
    }

    #[test]
    fn a_larger_avatar_has_to_be_nearer() {
        let level = |psnr_db| LevelChoice {
            measured: by_height(&[60.0, 120.0].map(|height| LevelError {
                height,
                samples: 4,
                psnr_db,
                color: 0.0,
                coverage: 0.0,
            })),
            ..level(10, 1.0, 0.0)
        };
        let near = |psnr| [60.0, 85.0, 120.0].map(|height| level(psnr).is_near(height, 4.0));
        assert_eq!(near(31.0), [false; 3]);
        assert_eq!(near(34.0), [true, true, false]);
        assert_eq!(near(36.0), [true; 3]);
    }

    #[test]
    fn a_level_stays_until_it_is_left_behind() {
        let levels = body();
        let mut before = 0;
        let walk = [59.0, 62.0, 64.0, 62.0, 122.0, 130.0, 122.0].map(|height| {
            before = choose(&levels, height, 4.0, before).level;
            before
        });
        assert_eq!(walk, [3, 3, 2, 2, 2, 1, 1]);
    }
}
