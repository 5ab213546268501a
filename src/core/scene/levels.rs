//! Which of an avatar's levels a small image of it is drawn from, and with how many samples: the
//! level with the fewest Gaussians of which it was measured that nothing is lost by it.
//!
//! A level has a size at which its mean colour and coverage are right. Drawn smaller it is too fat,
//! for each Gaussian is enlarged by the low-pass; drawn larger it is too thin, since the low-pass
//! no longer closes what is open between Gaussians. So as an avatar shrinks, samples make up for
//! it, until a coarser level takes over where both are right.

use crate::avatar::{Avatar, LevelError};

/// A level is drawn where images of it were measured to be at least this near to the truth, dB.
const PSNR: f64 = 38.0;
/// And where neither mean colour nor coverage were less than they should be by more than this: 1 %
/// is the aim, and poses that were not measured come on top.
const MEAN_ERROR: f64 = 0.006;
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

/// What is drawn of an avatar. Of levels 0 is the avatar itself, then its own follow, the finest
/// first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChosenLevel {
    /// The coarsest by which nothing is lost.
    pub near: usize,
    /// The one that is drawn.
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
    /// Between what was measured, errors follow the logarithm of the height and the width of a
    /// sample. Avatars smaller than that are as the smallest; None for larger ones. With fewer
    /// samples than were measured an avatar is as one that is drawn as tall with the fewest; of
    /// more samples nothing is known.
    fn error(&self, height: f64, samples: f64) -> Option<Error> {
        let fewest = self.fewest()?;
        if samples < fewest {
            return self.error(height * samples / fewest, fewest);
        }
        let fewest = self.range(height)?[0];
        if samples < fewest {
            return self.error(height * samples / fewest, fewest);
        }
        let [below, above] = self.around(height)?;
        let own = above.error(samples)?;
        if below.height >= height {
            return Some(own);
        }
        let share = (height / below.height).ln() / (above.height / below.height).ln();
        Some(below.error(samples)?.towards(own, share))
    }

    /// The fewest samples that anything was measured with.
    fn fewest(&self) -> Option<f64> {
        let all = self.measured.iter().flat_map(|own| &own.errors);
        all.map(|own| f64::from(own.samples)).reduce(f64::min)
    }

    /// What was measured next below a height and next above it, px; the same where one is missing
    /// below, or where it was measured.
    fn around(&self, height: f64) -> Option<[&MeasuredHeight; 2]> {
        let above = self.measured.iter().find(|own| own.height >= height)?;
        let below = self.measured.iter().rfind(|own| own.height <= height);
        Some([below.unwrap_or(above), above])
    }

    /// The fewest and the most samples of which something is known at a height, px.
    fn range(&self, height: f64) -> Option<[f64; 2]> {
        let [below, above] = self.around(height)?.map(|own| {
            let samples = |error: Option<&LevelError>| error.map(|own| f64::from(own.samples));
            Some([samples(own.errors.first())?, samples(own.errors.last())?])
        });
        let [below, above] = [below?, above?];
        let fewest = below[0].max(above[0]);
        let most = below[1].min(above[1]);
        (fewest <= most).then_some([fewest, most])
    }

    /// With how many samples, at most `most`, the mean of so tall an avatar, px, is nearest to
    /// right. None where nothing was measured, or with more samples only.
    fn samples(&self, height: f64, most: f64) -> Option<f64> {
        let [fewest, known] = self.range(height)?;
        let most = most.min(known);
        if most < fewest {
            return None;
        }
        let excess = |samples| Some(self.error(height, samples)?.means.iter().sum::<f64>());
        if most <= fewest || excess(most)? >= 0.0 {
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

    /// Whether avatars as small as this, px, were measured.
    fn is_measured_at(&self, height: f64) -> bool {
        self.measured
            .first()
            .is_some_and(|own| own.height <= height)
    }

    /// The tallest avatar of which something is known, px.
    fn tallest(&self) -> f64 {
        self.measured.last().map_or(0.0, |own| own.height)
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

    /// The lesser of both means: what is missing of it where it is below 0.
    fn least_mean(self) -> f64 {
        self.means[0].min(self.means[1])
    }
}

/// What is drawn of an avatar that is so tall in the image, px, with at most so many samples a
/// pixel: the coarsest level by which nothing is lost, or one that is `coarser` by so many.
/// `before`: the level by which nothing was lost in the last frame.
pub fn choose(
    levels: &[LevelChoice],
    height: f64,
    most: f64,
    before: usize,
    coarser: usize,
) -> ChosenLevel {
    let near = coarsest(levels, height, before, |level, height| {
        level.samples(height, most)
    });
    let level = (near + coarser).min(levels.len());
    let samples = match level.checked_sub(1).map(|at| &levels[at]) {
        // Beyond what is known of a level it is drawn as where it is the tallest.
        Some(own) => own.samples(height.min(own.tallest()), most),
        None => None,
    };
    ChosenLevel {
        near,
        level,
        samples: samples.unwrap_or(most),
    }
}

/// [`choose`] where so many samples are given.
pub fn choose_with(
    levels: &[LevelChoice],
    height: f64,
    samples: f64,
    before: usize,
    coarser: usize,
) -> ChosenLevel {
    let near = coarsest(levels, height, before, |_, _| Some(samples));
    ChosenLevel {
        near,
        level: (near + coarser).min(levels.len()),
        samples,
    }
}

/// The coarsest level by which nothing is lost; 0 where there is none. `samples`: those of a level
/// at a height, px.
fn coarsest(
    levels: &[LevelChoice],
    height: f64,
    before: usize,
    samples: impl Fn(&LevelChoice, f64) -> Option<f64>,
) -> usize {
    let error = |own: &LevelChoice, height: f64| own.error(height, samples(own, height)?);
    let is_near = |level: usize| {
        let own = &levels[level - 1];
        // An avatar that grows keeps its level for a while.
        let keeps = if level <= before { HYSTERESIS } else { 1.0 };
        let height = height / keeps;
        let Some(found) = error(own, height) else {
            return false;
        };
        if found.least_mean() < -MEAN_ERROR {
            return false;
        }
        if found.psnr >= PSNR {
            return true;
        }
        // What is too fat would be fatter with more Gaussians, unless it is known that it is not.
        match level.checked_sub(2).map(|finer| &levels[finer]) {
            Some(finer) if finer.is_measured_at(height) => {
                let finer = error(finer, height);
                found.least_mean() > 0.0 && finer.is_some_and(|finer| finer.psnr <= found.psnr)
            }
            _ => found.least_mean() > MEAN_ERROR,
        }
    };
    let found = (1..=levels.len()).rev().find(|&level| is_near(level));
    found.unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A level that is right where it is drawn so tall, px, and is measured up to so large an
    /// avatar.
    fn level(gaussians: usize, right: f64, tallest: f64) -> LevelChoice {
        let error = |height: f64, samples: u32| {
            // By a tenth of a doubling in size the mean changes by 0.3 %.
            let color = 0.03 * (right / (height * f64::from(samples))).log2();
            LevelError {
                height,
                samples,
                psnr_db: 44.0 - 200.0 * color.abs(),
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
        let choose = |height, most| choose(&levels, height, most, 0, 0).level;
        assert_eq!(
            [5.0, 20.0, 60.0, 61.0, 120.0, 121.0, 240.0, 241.0].map(|height| choose(height, 4.0)),
            [3, 3, 3, 2, 2, 1, 1, 0]
        );
        assert_eq!(super::choose(&[], 10.0, 4.0, 0, 0).samples, 4.0);
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
            let chosen = choose(&levels, height, 4.0, 0, 0);
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
            choose(&levels, 10.0, 4.0, 0, 0),
            ChosenLevel {
                near: 3,
                level: 3,
                samples: 4.0
            }
        );
    }

    /// A governor's coarser level has its own samples, and does not change what is near enough.
    #[test]
    fn a_coarser_level_is_drawn_at_its_own_size() {
        let levels = body();
        for (height, near, level, samples) in [
            (110.0, 2, 3, 2.0),
            (61.0, 2, 3, 2.0),
            (180.0, 1, 2, 2.0),
            (50.0, 3, 3, 2.35),
        ] {
            let chosen = choose(&levels, height, 4.0, 0, 1);
            assert_eq!((chosen.near, chosen.level), (near, level), "{height} px");
            assert!(
                (chosen.samples - samples).abs() < 0.06,
                "{height} px: {chosen:?}"
            );
        }
        let large = choose(&levels, 500.0, 1.28, 0, 1);
        assert_eq!((large.near, large.level, large.samples), (0, 1, 1.28));
    }

    /// Where nothing changes the second frame has what the first had.
    #[test]
    fn a_still_avatar_is_drawn_alike() {
        let levels = body();
        for coarser in [0, 1, 5] {
            for step in 0..300 {
                let height = 10.0 * 1.012f64.powi(step);
                let first = choose(&levels, height, 4.0, 0, coarser);
                assert_eq!(choose(&levels, height, 4.0, first.near, coarser), first);
            }
        }
    }

    /// A bad fit that is a little too fat does not pass for a level, and heights may have been
    /// measured with other samples.
    #[test]
    fn what_files_say_is_not_taken_for_more() {
        let error = |height, samples, psnr_db, color| LevelError {
            height,
            samples,
            psnr_db,
            color,
            coverage: color,
        };
        let of = |gaussians, errors: &[LevelError]| LevelChoice {
            gaussians,
            correctives: false,
            measured: by_height(errors),
        };
        let good = of(
            400,
            &[error(60.0, 2, 40.0, 0.02), error(60.0, 4, 40.0, 0.0)],
        );
        let bad = of(
            100,
            &[error(60.0, 2, 20.0, 0.03), error(60.0, 4, 20.0, 0.011)],
        );
        assert_eq!(choose(&[good.clone(), bad], 60.0, 4.0, 0, 0).level, 1);
        let unequal = of(
            100,
            &[
                error(40.0, 4, 40.0, 0.0),
                error(60.0, 2, 40.0, 0.02),
                error(60.0, 4, 40.0, 0.0),
            ],
        );
        assert_eq!(choose(&[unequal], 50.0, 4.0, 0, 0).level, 1);
    }

    #[test]
    fn where_samples_are_given_the_level_follows_them() {
        let levels = body();
        let at = |height, samples| choose_with(&levels, height, samples, 0, 0).level;
        assert_eq!(
            [4.0, 2.6, 2.2, 2.0].map(|samples| at(60.0, samples)),
            [2, 2, 3, 3]
        );
        // Drawn less large than any measurement, the coarsest that fits the size it is drawn with.
        assert_eq!([1.5, 1.1].map(|samples| at(60.0, samples)), [3, 3]);
        assert_eq!([1.6, 1.2].map(|samples| at(100.0, samples)), [2, 3]);
    }

    #[test]
    fn a_level_stays_until_it_is_left_behind() {
        let levels = body();
        let mut before = 0;
        let walk = [59.0, 62.0, 64.0, 62.0, 122.0, 130.0, 122.0].map(|height| {
            before = choose(&levels, height, 4.0, before, 0).near;
            before
        });
        assert_eq!(walk, [3, 3, 2, 2, 2, 1, 1]);
    }
}
