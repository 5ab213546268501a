//! Named points on the front of time against error. In: a name. Out: the options that a renderer is made with.
//!
//! `effigy bench --sweep preset` measures them; the README has the numbers.

use super::{ALPHA_MIN, ColorFormat, Detail, KeyBits, RendererOptions, Skip};
use std::{fmt, str::FromStr};

/// How much error a picture may have for the sake of time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Preset {
    /// The fastest that still looks right from a distance, where it draws fewer Gaussians.
    Low,
    /// Faster, at errors that are hard to see.
    Balanced,
    /// 50 dB over covered pixels and more, on bodies; clouds of balls come to 49.5.
    #[default]
    High,
    /// Nothing left out that shows by more than a rounding.
    Exact,
}

/// Everything that a preset decides.
struct Values {
    color: Option<ColorFormat>,
    key_bits: KeyBits,
    skip: Skip,
    cutoff: f64,
    margin: f64,
    detail: Detail,
}

impl Preset {
    pub const ALL: [Self; 4] = [Self::Low, Self::Balanced, Self::High, Self::Exact];

    /// The table.
    const fn values(self) -> Values {
        let (color, skip) = (None, Skip::all());
        // What leaves out something that shows, if only a little.
        let lossy = Skip::HIDDEN.union(Skip::DEPTH);
        let (sixteen, most, detail) = (KeyBits::Sixteen, KeyBits::ThirtyTwo, Detail::FULL);
        match self {
            Self::Low => Values {
                color: Some(ColorFormat::Rgba8),
                key_bits: sixteen,
                skip,
                cutoff: 4.0 * ALPHA_MIN,
                margin: 0.003,
                detail: Detail::AUTO,
            },
            Self::Balanced => Values { color, key_bits: sixteen, skip, cutoff: 2.0 * ALPHA_MIN, margin: 0.004, detail },
            // Where a coarse surface comes out of a crease, the depth test shows; culling whole Gaussians by it does not.
            Self::High => Values { color, key_bits: sixteen, skip: skip.difference(Skip::DEPTH), cutoff: ALPHA_MIN, margin: 0.005, detail },
            Self::Exact => {
                let (color, skip) = (Some(ColorFormat::Rgba16F), skip.difference(lossy));
                Values { color, key_bits: most, skip, cutoff: ALPHA_MIN, margin: 0.005, detail }
            }
        }
    }

    /// Other options with what this preset decides put into them.
    pub fn apply(self, options: RendererOptions) -> RendererOptions {
        let Values { color, key_bits, skip, cutoff, margin, detail } = self.values();
        RendererOptions { color, key_bits, skip, cutoff, margin, detail, ..options }
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
        let known = Self::ALL.into_iter().find(|preset| preset.to_string() == text);
        known.ok_or_else(|| format!("`{text}` is no preset: write low, balanced, high or exact"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_preset_is_what_a_renderer_does_unasked() {
        let [preset, unasked] = [Preset::default().apply(RendererOptions::new([9, 7])), RendererOptions::new([9, 7])];
        let [preset, unasked] = [preset, unasked].map(|options| format!("{options:?}"));
        assert_eq!(preset, unasked);
    }

    #[test]
    fn each_preset_leaves_out_no_more_than_the_one_before() {
        let all = Preset::ALL.map(|preset| preset.apply(RendererOptions::new([1, 1])));
        for pair in all.windows(2) {
            assert!(pair[0].cutoff >= pair[1].cutoff && pair[0].margin <= pair[1].margin, "{pair:?}");
            assert!(pair[0].detail.auto >= pair[1].detail.auto && pair[0].detail.least >= pair[1].detail.least, "{pair:?}");
            assert!(pair[0].key_bits.passes() <= pair[1].key_bits.passes() && pair[0].skip.contains(pair[1].skip), "{pair:?}");
        }
        assert!(Preset::ALL.into_iter().all(|preset| preset.to_string().parse() == Ok(preset)));
    }
}
