//! Named points on the Pareto front of frame time and error. `effigy bench --sweep preset` measures
//! them.

use super::{ColorFormat, KeyBits, RendererOptions, Skip};
use crate::{
    constants::ALPHA_MIN,
    scene::{Detail, Supersampling},
};
use std::{fmt, str::FromStr};

/// How much error an image may have for the sake of time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Preset {
    /// The fastest that still looks right, with fewer Gaussians from a distance.
    Low,
    /// Faster, at errors that are hard to see.
    Balanced,
    /// At least 50 dB over covered pixels on bodies; 49.5 on clouds of balls.
    #[default]
    High,
    /// Skips only work that changes the image by no more than rounding.
    Exact,
}

/// The options that a preset decides.
struct Values {
    color: Option<ColorFormat>,
    key_bits: Option<KeyBits>,
    skip: Skip,
    cutoff: f64,
    detail: Detail,
    supersampling: Supersampling,
}

impl Preset {
    /// Every preset, from the fastest to the most exact.
    pub const ALL: [Self; 4] = [Self::Low, Self::Balanced, Self::High, Self::Exact];

    const fn values(self) -> Values {
        match self {
            Self::Low => Values {
                color: Some(ColorFormat::Rgba8),
                key_bits: Some(KeyBits::Sixteen),
                skip: Skip::all(),
                cutoff: 4.0 * ALPHA_MIN,
                detail: Detail::AUTO,
                supersampling: Supersampling::BySize,
            },
            Self::Balanced => Values {
                color: None,
                key_bits: Some(KeyBits::Sixteen),
                skip: Skip::all(),
                cutoff: 2.0 * ALPHA_MIN,
                detail: Detail::FULL,
                supersampling: Supersampling::BySize,
            },
            Self::High => Values {
                color: None,
                key_bits: None,
                skip: Skip::all(),
                cutoff: ALPHA_MIN,
                detail: Detail::FULL,
                supersampling: Supersampling::BySize,
            },
            // Without the saturation depth, whose culling shows a little; and what is small as the
            // model says, not as the area of each pixel shows it.
            Self::Exact => Values {
                color: Some(ColorFormat::Rgba16F),
                key_bits: Some(KeyBits::ThirtyTwo),
                skip: Skip::all().difference(Skip::DEPTH),
                cutoff: ALPHA_MIN,
                detail: Detail::FULL,
                supersampling: Supersampling::OFF,
            },
        }
    }

    /// Replaces the options that this preset decides.
    pub fn apply(self, options: RendererOptions) -> RendererOptions {
        let Values {
            color,
            key_bits,
            skip,
            cutoff,
            detail,
            supersampling,
        } = self.values();
        RendererOptions {
            color,
            key_bits,
            skip,
            cutoff,
            detail,
            supersampling,
            // All of a crowd, whatever memory that takes.
            gaussians: match self {
                Self::Exact => Some(u32::MAX),
                _ => options.gaussians,
            },
            ..options
        }
    }
}

impl fmt::Display for Preset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Low => "low",
            Self::Balanced => "balanced",
            Self::High => "high",
            Self::Exact => "exact",
        })
    }
}

impl FromStr for Preset {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let known = Self::ALL
            .into_iter()
            .find(|preset| preset.to_string() == text);
        known.ok_or_else(|| format!("`{text}` is no preset: write low, balanced, high or exact"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_preset_equals_the_default_options() {
        let defaults = RendererOptions::new([9, 7]);
        let preset = Preset::default().apply(defaults);
        assert_eq!(format!("{preset:?}"), format!("{defaults:?}"));
    }

    #[test]
    fn each_preset_skips_no_more_than_the_one_before() {
        let all = Preset::ALL.map(|preset| preset.apply(RendererOptions::new([1, 1])));
        for pair in all.windows(2) {
            assert!(pair[0].cutoff >= pair[1].cutoff, "{pair:?}");
            assert!(
                pair[0].detail.auto >= pair[1].detail.auto
                    && pair[0].detail.finest >= pair[1].detail.finest,
                "{pair:?}"
            );
            assert!(
                pair[0].keys().passes() <= pair[1].keys().passes()
                    && pair[0].skip.contains(pair[1].skip),
                "{pair:?}"
            );
        }
        assert!(
            Preset::ALL
                .into_iter()
                .all(|preset| preset.to_string().parse() == Ok(preset))
        );
    }
}
