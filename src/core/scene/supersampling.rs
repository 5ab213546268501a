//! Supersampling of what is small: an avatar under some size is drawn larger than it is shown, and
//! averaged. The errors of small images are at silhouettes and in coverage, which no filter of
//! single Gaussians repairs (docs/experiments/046).

use crate::avatar::{Filter, LowPass};
use std::{fmt, str::FromStr};

/// Longest side that an avatar's box is drawn with, px, as far as factors allow: the less of the image
/// it takes up, the larger it is drawn, without steps that could be seen (docs/experiments/051).
pub const DRAWN_SIDE: f64 = 720.0;
/// The most times that an avatar is drawn as large as it is shown.
const LARGEST: f64 = 4.0;
/// From this factor on the mean over a pixel filters, and [`Filter::SUPERSAMPLED`] is all that is
/// needed beside it.
const FILTERED: f64 = 2.0;

/// How many times its size an avatar is drawn: `--supersample auto|1|2|4`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Supersampling {
    /// More times the smaller it is in the image.
    BySize,
    /// So many times each way, whatever the avatar's size: 1, 2 or 4.
    Times(u32),
}

impl Supersampling {
    /// Everything is drawn as large as it is shown.
    pub const OFF: Self = Self::Times(1);

    /// Whether any avatar may be drawn larger than it is shown.
    pub fn is_on(self) -> bool {
        self != Self::OFF
    }

    /// How many times its size an avatar is drawn whose box in the image has this longest side, px:
    /// 1 to 4. It has no steps, so that none are seen while an avatar grows.
    pub fn factor(self, side: f64) -> f64 {
        match self {
            Self::Times(factor) => factor.into(),
            Self::BySize if side.is_nan() => 1.0,
            Self::BySize => (DRAWN_SIDE / side).clamp(1.0, LARGEST),
        }
    }
}

/// The low-pass of what is drawn so many times, at least once, as large as it is shown. `own`: the
/// avatar's; `asked`: the one that all is to be drawn with, if any.
pub fn low_pass(own: Filter, asked: Option<Filter>, factor: f64) -> LowPass {
    let share = (factor - 1.0) / (FILTERED - 1.0);
    let larger = asked.unwrap_or(Filter::SUPERSAMPLED);
    asked.unwrap_or(own).towards(larger, share.min(1.0))
}

impl FromStr for Supersampling {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "auto" => Ok(Self::BySize),
            "1" => Ok(Self::Times(1)),
            "2" => Ok(Self::Times(2)),
            "4" => Ok(Self::Times(4)),
            _ => Err(format!(
                "`{text}` is no factor of supersampling: write auto, 1, 2 or 4"
            )),
        }
    }
}

impl fmt::Display for Supersampling {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::BySize => f.write_str("auto"),
            Self::Times(factor) => write!(f, "{factor}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smaller_the_more_samples() {
        let factors = [10.0, 180.0, 288.0, 450.0, 720.0, 4000.0, f64::INFINITY]
            .map(|side| Supersampling::BySize.factor(side));
        assert_eq!(factors, [4.0, 4.0, 2.5, 1.6, 1.0, 1.0, 1.0]);
        assert_eq!(Supersampling::BySize.factor(f64::NAN), 1.0);
        assert_eq!(Supersampling::BySize.factor(0.0), 4.0);
        assert_eq!(Supersampling::Times(2).factor(10.0), 2.0);
    }

    /// Neither the factor nor the low-pass changes by steps.
    #[test]
    fn a_growing_avatar_is_drawn_without_steps() {
        let own = Filter::DEFAULT;
        let drawn = |side: f64| {
            let factor = Supersampling::BySize.factor(side);
            let low_pass = low_pass(own, None, factor);
            [factor, low_pass.variance, low_pass.compensation]
        };
        let mut before = drawn(20.0);
        assert_eq!(before, [4.0, 0.1, 1.0]);
        for step in 1..=1000 {
            let own = drawn(20.0 * 50f64.powf(f64::from(step) / 1000.0));
            for (own, before) in own.into_iter().zip(before) {
                assert!((own - before).abs() < 0.02, "{own} after {before}");
            }
            before = own;
        }
        assert_eq!(before, [1.0, own.variance, 0.0]);
    }

    #[test]
    fn factors_read_back_as_they_are_written() {
        for text in ["auto", "1", "2", "4"] {
            let read = text.parse::<Supersampling>();
            assert_eq!(read.map(|read| read.to_string()).as_deref(), Ok(text));
        }
        let error = "3".parse::<Supersampling>().unwrap_err();
        assert!(error.contains("`3`") && error.contains("auto"));
    }
}
