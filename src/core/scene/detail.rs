//! Level of detail: how many of an avatar's Gaussians are drawn, by its size in the image. Each
//! level draws half of the Gaussians of the level before: every second in the file's order, which
//! follows the body's surface.
//!
//! A Gaussian of level l represents n = 2^l Gaussians of its own opacity o: it is drawn with
//! opacity 1 − (1 − o)^n, and its covariance in the image is enlarged by n^[`GROWTH`].
//! `docs/experiments/015` has the measurements: if the avatar has few pixels a Gaussian, the
//! low-pass makes an image of all Gaussians that is further from the average over each pixel than
//! one of an eighth of them.

pub use crate::constants::DETAIL_COARSEST as COARSEST;

use std::{fmt, str::FromStr};

/// Exponent by which a Gaussian's area grows with the number that it represents, chosen so that the
/// image is nearest to that of all Gaussians.
pub const GROWTH: f64 = 0.18;
/// Minimum number of Gaussians for a pixel of the box around an avatar, where the level follows the
/// avatar's size.
const DENSITY: f64 = 9.0;
/// Hysteresis: a level gives way to a finer one only below this fraction of [`DENSITY`], so that a
/// walking avatar does not switch back and forth.
const HYSTERESIS: f64 = 0.8;

/// How the level of detail is chosen: `--detail full|auto|1/2|1/4|1/8`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Detail {
    /// The finest level that may be drawn, at most [`COARSEST`]; 0 draws every Gaussian.
    pub finest: u32,
    /// Whether small avatars are drawn at coarser levels.
    pub auto: bool,
    /// By how many levels avatars that are drawn larger than they are shown are coarser than is
    /// near enough: of the file's own ([`levels`](super::levels)), else of these.
    pub coarser: usize,
}

impl Detail {
    /// Every Gaussian is drawn.
    pub const FULL: Self = Self {
        finest: 0,
        auto: false,
        coarser: 0,
    };
    /// The level follows the avatar's size.
    pub const AUTO: Self = Self {
        finest: 0,
        auto: true,
        coarser: 0,
    };

    /// Restricts the choice to this level or coarser ones.
    pub fn at_least(self, level: u32) -> Self {
        Self {
            finest: self.finest.max(level),
            ..self
        }
    }

    /// The level for an avatar with `gaussians`, drawn at level `before` in the last frame.
    /// `pixels` gives the area of the avatar's box, px², including what lies outside the image; it
    /// is called only where it matters, and returns None if the avatar crosses the near plane.
    pub fn level(self, gaussians: usize, before: u32, pixels: impl FnOnce() -> Option<f64>) -> u32 {
        let pixels = if self.auto { pixels() } else { None };
        let dense = pixels.map_or(1.0, |pixels| gaussians as f64 / (DENSITY * pixels.max(1.0)));
        let halvings = |dense: f64| if dense > 1.0 { dense.log2() as u32 } else { 0 };
        let level = halvings(dense).max(before.min(halvings(dense / HYSTERESIS)));
        level.max(self.finest).min(COARSEST)
    }
}

/// How many Gaussians of an avatar a level draws.
pub fn gaussian_count(gaussians: u32, level: u32) -> u32 {
    gaussians.div_ceil(1 << level)
}

/// Factor by which a level enlarges covariances in the image.
pub fn covariance_scale(level: u32) -> f64 {
    (GROWTH * f64::from(level)).exp2()
}

/// The opacity of a Gaussian that represents 2^`level` Gaussians of this opacity; 255 is opaque.
pub fn opacity(opacity: u8, level: u32) -> u8 {
    let through = (1.0 - f64::from(opacity) / 255.0).powi(1 << level);
    (255.0 * (1.0 - through)).round() as u8
}

impl FromStr for Detail {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let level = |level| {
            Ok(Self {
                finest: level,
                ..Self::FULL
            })
        };
        match text {
            "full" => level(0),
            "1/2" => level(1),
            "1/4" => level(2),
            "1/8" => level(3),
            "auto" => Ok(Self::AUTO),
            _ => Err(format!(
                "`{text}` is no level of detail: write full, auto, 1/2, 1/4 or 1/8"
            )),
        }
    }
}

impl fmt::Display for Detail {
    /// Writes text that [`FromStr`] parses, except for what the governor sets: automatic levels
    /// from a finest one on are written as `auto from 1/2`, coarser ones of the file as `+1 level`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = 1u32 << self.finest.min(COARSEST);
        match (self.auto, self.finest) {
            (false, 0) => write!(f, "full"),
            (true, 0) => write!(f, "auto"),
            (false, _) => write!(f, "1/{of}"),
            (true, _) => write!(f, "auto from 1/{of}"),
        }?;
        match self.coarser {
            0 => Ok(()),
            1 => write!(f, " +1 level"),
            levels => write!(f, " +{levels} levels"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smaller_avatars_are_drawn_with_fewer_gaussians() {
        let level = |pixels| Detail::AUTO.level(200_000, 0, || Some(pixels));
        assert_eq!(
            [1e6, 2e4, 1e4, 5e3, 2e3, 10.0, 0.0].map(level),
            [0, 0, 1, 2, 3, 3, 3]
        );
        assert_eq!(
            [Some(10.0), None].map(|pixels| Detail::FULL.level(200_000, 3, || pixels)),
            [0, 0]
        );
        assert_eq!(Detail::AUTO.level(200_000, 3, || None), 0);
        assert_eq!(Detail::AUTO.level(0, 0, || Some(10.0)), 0);
        let governed = Detail::AUTO.at_least(1);
        assert_eq!(
            [Some(1e6), Some(10.0), None].map(|pixels| governed.level(200_000, 0, || pixels)),
            [1, 3, 1]
        );
        assert_eq!(Detail::AUTO.level(200_000, 0, || Some(f64::NAN)), 3);
    }

    #[test]
    fn a_level_stays_until_it_is_left_far_behind() {
        // Level 1 from 11,111 px down.
        let mut level = 0;
        let walk = [11_000.0, 11_500.0, 13_000.0, 11_500.0, 14_000.0, 11_500.0].map(|pixels| {
            level = Detail::AUTO.level(200_000, level, || Some(pixels));
            level
        });
        assert_eq!(walk, [1, 1, 1, 1, 0, 0]);
        assert_eq!(Detail::AUTO.level(200_000, 3, || Some(1e4)), 1);
    }

    #[test]
    fn drawn_gaussians_represent_the_skipped_ones() {
        assert_eq!(
            (
                gaussian_count(9, 0),
                gaussian_count(9, 1),
                gaussian_count(9, 3),
                gaussian_count(0, 3)
            ),
            (9, 5, 2, 0)
        );
        assert!((0..=255).all(|o| opacity(o, 0) == o) && covariance_scale(0) == 1.0);
        assert_eq!(
            (
                opacity(255, 3),
                opacity(0, 2),
                opacity(51, 1),
                opacity(51, 3)
            ),
            (255, 0, 92, 212)
        );
        assert!(covariance_scale(1) > 1.0 && covariance_scale(3) < 2.0);
    }

    #[test]
    fn levels_read_back_as_they_are_written() {
        for text in ["full", "auto", "1/2", "1/4", "1/8"] {
            assert_eq!(
                text.parse::<Detail>()
                    .map(|detail| detail.to_string())
                    .as_deref(),
                Ok(text)
            );
        }
        assert_eq!(Detail::AUTO.at_least(1).to_string(), "auto from 1/2");
        assert!(
            "1/3"
                .parse::<Detail>()
                .is_err_and(|error| error.contains("1/4"))
        );
    }
}
