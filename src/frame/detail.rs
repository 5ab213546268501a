//! Level of detail: how many of an avatar's Gaussians are drawn. In: how large it is in the picture. Out: a level, each of which draws half
//! of the Gaussians that the one before draws, every second in the file's order, which follows the surface.
//!
//! What is drawn stands for what is not: a Gaussian of level l for n = 2^l of its own opacity, 1 − (1 − o)^n, its covariance in the picture
//! enlarged by n^[`GROWTH`]. `src/measure/NOTES.md` has the experiments: under some pixels a Gaussian, the low-pass makes a picture of all of
//! them that is further from the average over each pixel than one of an eighth of them.

use std::{fmt, str::FromStr};

/// The coarsest level: one Gaussian in eight.
pub const COARSEST: u32 = 3;
/// By which power of the Gaussians that one stands for its area in the picture grows: what keeps the picture nearest to that of all.
pub const GROWTH: f64 = 0.18;
/// Gaussians that are left for a pixel of the box around an avatar, at least, where the level follows its size.
const DENSITY: f64 = 9.0;
/// How many of those have to be left at a level for it to give way to a finer one, so that an avatar that walks does not change back and forth.
const CALM: f64 = 0.8;

/// Which level is drawn: `--detail full|auto|1/2|1/4|1/8`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Detail {
    /// The level that is drawn where an avatar is large, at most [`COARSEST`]; 0 draws every Gaussian.
    pub least: u32,
    /// Whether small avatars are drawn at a coarser one.
    pub auto: bool,
}

impl Detail {
    pub const FULL: Self = Self { least: 0, auto: false };
    pub const AUTO: Self = Self { least: 0, auto: true };

    /// The same at `least` or coarser.
    pub fn at_least(self, least: u32) -> Self {
        Self { least: self.least.max(least), ..self }
    }

    /// The level for an avatar of so many Gaussians whose box in the picture, of which some may be outside it, has so many pixels, drawn at
    /// `before` in the last frame. `pixels`: asked for where it matters; None where it reaches through the near plane.
    pub fn level(self, gaussians: usize, before: u32, pixels: impl FnOnce() -> Option<f64>) -> u32 {
        let pixels = if self.auto { pixels() } else { None };
        let dense = pixels.map_or(1.0, |pixels| gaussians as f64 / (DENSITY * pixels.max(1.0)));
        let halvings = |dense: f64| if dense > 1.0 { dense.log2() as u32 } else { 0 };
        let level = halvings(dense).max(before.min(halvings(dense / CALM)));
        level.max(self.least).min(COARSEST)
    }
}

/// How many of so many Gaussians a level draws.
pub fn drawn(gaussians: u32, level: u32) -> u32 {
    gaussians.div_ceil(1 << level)
}

/// What a level multiplies covariances in the picture by.
pub fn spread(level: u32) -> f64 {
    (GROWTH * f64::from(level)).exp2()
}

/// The opacity of a Gaussian that stands for 2^`level` of this one; 255 is opaque.
pub fn opacity(opacity: u8, level: u32) -> u8 {
    let through = (1.0 - f64::from(opacity) / 255.0).powi(1 << level);
    (255.0 * (1.0 - through)).round() as u8
}

impl FromStr for Detail {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let level = |level| Ok(Self { least: level, auto: false });
        match text {
            "full" => level(0),
            "1/2" => level(1),
            "1/4" => level(2),
            "1/8" => level(3),
            "auto" => Ok(Self::AUTO),
            _ => Err(format!("`{text}` is no level of detail: write full, auto, 1/2, 1/4 or 1/8")),
        }
    }
}

impl fmt::Display for Detail {
    /// As [`FromStr`] reads it where it can: a least level that grows, as a governor makes it, has `auto from` before it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = 1u32 << self.least.min(COARSEST);
        match (self.auto, self.least) {
            (false, 0) => write!(f, "full"),
            (true, 0) => write!(f, "auto"),
            (false, _) => write!(f, "1/{of}"),
            (true, _) => write!(f, "auto from 1/{of}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smaller_avatars_are_drawn_with_fewer_gaussians() {
        let level = |pixels| Detail::AUTO.level(200_000, 0, || Some(pixels));
        assert_eq!([1e6, 2e4, 1e4, 5e3, 2e3, 10.0, 0.0].map(level), [0, 0, 1, 2, 3, 3, 3]);
        assert_eq!([Some(10.0), None].map(|pixels| Detail::FULL.level(200_000, 3, || pixels)), [0, 0]);
        assert_eq!(Detail::AUTO.level(200_000, 3, || None), 0);
        assert_eq!(Detail::AUTO.level(0, 0, || Some(10.0)), 0);
        let governed = Detail::AUTO.at_least(1);
        assert_eq!([Some(1e6), Some(10.0), None].map(|pixels| governed.level(200_000, 0, || pixels)), [1, 3, 1]);
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
    fn what_is_drawn_stands_for_what_is_not() {
        assert_eq!((drawn(9, 0), drawn(9, 1), drawn(9, 3), drawn(0, 3)), (9, 5, 2, 0));
        assert!((0..=255).all(|o| opacity(o, 0) == o) && spread(0) == 1.0);
        assert_eq!((opacity(255, 3), opacity(0, 2), opacity(51, 1), opacity(51, 3)), (255, 0, 92, 212));
        assert!(spread(1) > 1.0 && spread(3) < 2.0);
    }

    #[test]
    fn levels_read_back_as_they_are_written() {
        for text in ["full", "auto", "1/2", "1/4", "1/8"] {
            assert_eq!(text.parse::<Detail>().map(|detail| detail.to_string()).as_deref(), Ok(text));
        }
        assert_eq!(Detail::AUTO.at_least(1).to_string(), "auto from 1/2");
        assert!("1/3".parse::<Detail>().is_err_and(|error| error.contains("1/4")));
    }
}
