//! Supersampling of what is small: an avatar under some size is drawn larger than it is shown, and
//! averaged. The errors of small images are at silhouettes and in coverage, which no filter of
//! single Gaussians repairs (docs/experiments/046).

use std::{fmt, str::FromStr};

/// Factors that avatars may be drawn at, largest first, and the longest side of an avatar's box
/// that each is for, px.
const FACTORS: [SizeLimit; 2] = [
    SizeLimit {
        factor: 4,
        side: 160.0,
    },
    SizeLimit {
        factor: 2,
        side: 400.0,
    },
];
/// Hysteresis: an avatar that grows keeps its factor up to this many times the limit, so that one
/// who walks back and forth doesn't switch.
const HYSTERESIS: f64 = 1.1;

/// A factor, and up to which size it is for.
struct SizeLimit {
    factor: u32,
    /// Longest side of an avatar's box, px.
    side: f64,
}

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

    /// How many times its size an avatar is drawn whose box in the image has this longest side, px.
    /// `before`: as the last frame drew it, 1 before the first.
    pub fn factor(self, side: f64, before: u32) -> u32 {
        match self {
            Self::Times(factor) => factor,
            Self::BySize => FACTORS
                .iter()
                .find(|limit| {
                    let keeps = if limit.factor <= before {
                        HYSTERESIS
                    } else {
                        1.0
                    };
                    side <= keeps * limit.side
                })
                .map_or(1, |limit| limit.factor),
        }
    }
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
        let factors = [10.0, 160.0, 161.0, 400.0, 401.0, 4000.0, f64::INFINITY]
            .map(|side| Supersampling::BySize.factor(side, 1));
        assert_eq!(factors, [4, 4, 2, 2, 1, 1, 1]);
        assert_eq!(Supersampling::BySize.factor(f64::NAN, 1), 1);
        assert_eq!(Supersampling::Times(2).factor(10.0, 4), 2);
    }

    #[test]
    fn a_factor_stays_until_it_is_left_behind() {
        let mut before = 1;
        let walk = [150.0, 165.0, 180.0, 165.0, 430.0, 450.0, 430.0].map(|side| {
            before = Supersampling::BySize.factor(side, before);
            before
        });
        assert_eq!(walk, [4, 4, 2, 2, 2, 1, 1]);
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
