//! The low-pass filter that every projected Gaussian goes through.

use crate::constants::LOW_PASS;
use serde::{Deserialize, Serialize};
use std::{fmt, ops::RangeInclusive, str::FromStr};

/// The low-pass of docs/model.md, step 8: a projected covariance Σ is drawn as Σ + `variance` · I,
/// so that no Gaussian falls between the centres of pixels.
///
/// An avatar is learned with one filter, and looks right with that one alone: a larger variance
/// thickens what is fine, and compensation on an avatar that was learned without it thins it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Filter {
    /// What is added to both diagonal entries of a projected covariance, px², within
    /// [`Filter::VARIANCES`].
    pub variance: f64,
    /// Whether the opacity is multiplied by √(det Σ / det(Σ + `variance` · I)), so that a Gaussian
    /// covers as much as without the filter, however small it is in the image: the 2D filter of
    /// Mip-Splatting (Yu et al., CVPR 2024).
    pub compensated: bool,
}

impl Filter {
    /// That of 3DGS as it was published, and of every avatar whose file names none.
    pub const DEFAULT: Self = Self {
        variance: LOW_PASS,
        compensated: false,
    };
    /// That of what is drawn larger than it is shown, unless another is asked for: the mean over
    /// each pixel filters, and this only keeps Gaussians from falling between samples.
    pub const SUPERSAMPLED: Self = Self {
        variance: 0.1,
        compensated: true,
    };
    /// That of programs which know one flag, "antialiased": compensated, with the variance of 3DGS.
    pub const ANTIALIASED: Self = Self {
        variance: LOW_PASS,
        compensated: true,
    };
    /// Variances that may be drawn with, px². With less, a Gaussian would fall by more than f32
    /// holds over the four pixels that the tile rasterizer steps along (shaders/raster/tiles.glsl).
    pub const VARIANCES: RangeInclusive<f64> = 0.1..=10.0;

    /// Whether the variance may be drawn with.
    pub fn is_valid(&self) -> bool {
        Self::VARIANCES.contains(&self.variance)
    }

    /// What lies between this filter and another. `share`: of the other, 0 to 1.
    pub fn towards(self, other: Self, share: f64) -> LowPass {
        let [from, to] = [self, other].map(LowPass::from);
        LowPass {
            variance: (1.0 - share) * from.variance + share * to.variance,
            compensation: (1.0 - share) * from.compensation + share * to.compensation,
        }
    }
}

/// What an image is drawn with: a filter, or what lies between two of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LowPass {
    /// As [`Filter::variance`], px².
    pub variance: f64,
    /// How much of [`Filter::compensated`] there is, 0 to 1.
    pub compensation: f64,
}

impl LowPass {
    /// Factor on the opacity of a Gaussian. `unfiltered` and `filtered`: the determinants of its
    /// projected covariance without and with the filter, px⁴.
    pub fn opacity_factor(&self, unfiltered: f64, filtered: f64) -> f64 {
        1.0 - self.compensation + self.compensation * (unfiltered / filtered).sqrt()
    }
}

impl From<Filter> for LowPass {
    fn from(filter: Filter) -> Self {
        Self {
            variance: filter.variance,
            compensation: if filter.compensated { 1.0 } else { 0.0 },
        }
    }
}

impl Default for Filter {
    fn default() -> Self {
        Self::DEFAULT
    }
}

impl FromStr for Filter {
    type Err = String;

    /// Reads the variance in px², with `+compensated` after it if opacities are compensated.
    fn from_str(text: &str) -> Result<Self, String> {
        let (variance, compensated) = match text.strip_suffix("+compensated") {
            Some(variance) => (variance, true),
            None => (text, false),
        };
        variance
            .parse()
            .map(|variance| Self {
                variance,
                compensated,
            })
            .ok()
            .filter(Self::is_valid)
            .ok_or_else(|| {
                format!(
                    "`{text}` is no filter: write a variance from {} to {} px², with or without \
                     +compensated, for instance 0.1+compensated",
                    Self::VARIANCES.start(),
                    Self::VARIANCES.end()
                )
            })
    }
}

impl fmt::Display for Filter {
    /// Writes text that [`FromStr`] reads as this filter.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let compensated = if self.compensated { "+compensated" } else { "" };
        write!(f, "{}{compensated}", self.variance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn filters_read_back_as_they_are_written() {
        for text in ["0.3", "0.1+compensated", "10", "0.25+compensated"] {
            let filter: Filter = text.parse().expect(text);
            assert_eq!(filter.to_string(), text);
        }
        assert_eq!("0.3".parse(), Ok(Filter::DEFAULT));
    }

    #[test]
    fn what_is_no_filter_is_refused_with_what_one_is() {
        for text in [
            "",
            "own",
            "0",
            "-0.3",
            "0.09",
            "10.1",
            "NaN",
            "inf",
            "compensated",
            "0.1 + compensated",
        ] {
            let refused = text.parse::<Filter>().expect_err(text);
            assert!(refused.contains("0.1 to 10 px²"), "{refused}");
        }
    }
}
