//! The knobs: a setting goes in; for every other value of a knob, the setting that it makes of it comes out.

use super::{Setting, key_bits, scene::RATE};
use crate::{
    frame::{Detail, Skip, detail::COARSEST},
    vulkan::{
        preset::Preset,
        raster::{ColorFormat, Method},
        sort::KeyBits,
    },
};
use std::{fmt, str::FromStr};

/// Name of the presets' knob.
pub const PRESET: &str = "preset";

const COLORS: [ColorFormat; 2] = [ColorFormat::Rgba8, ColorFormat::Rgba16F];
const KEYS: [KeyBits; 3] = [KeyBits::Sixteen, KeyBits::TwentyFour, KeyBits::ThirtyTwo];

/// Something that trades time for error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Knob {
    Preset,
    Storage,
    Keys,
    Color,
    Raster,
    Cutoff,
    Rows,
    Margin,
    Detail,
    PoseRate,
    Skip,
    /// Everything skipped but one kind of work.
    SkipBut,
}

impl Knob {
    /// Every knob; the last is for looking into the skips and not part of a sweep of all.
    pub const ALL: [Self; 12] = [
        Self::Preset,
        Self::Storage,
        Self::Keys,
        Self::Color,
        Self::Raster,
        Self::Cutoff,
        Self::Rows,
        Self::Margin,
        Self::Detail,
        Self::PoseRate,
        Self::Skip,
        Self::SkipBut,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Self::Preset => PRESET,
            Self::Storage => "storage",
            Self::Keys => "keys",
            Self::Color => "color",
            Self::Raster => "raster",
            Self::Cutoff => "cutoff",
            Self::Rows => "rows",
            Self::Margin => "margin",
            Self::Detail => "detail",
            Self::PoseRate => "pose-rate",
            Self::Skip => "skip",
            Self::SkipBut => "skip-but",
        }
    }

    /// Every value but those that the setting has already, each with the setting that it makes of `base`.
    pub fn values(self, base: &Setting) -> Vec<(String, Setting)> {
        let of = |set: &dyn Fn(&mut Setting)| {
            let mut setting = *base;
            set(&mut setting);
            setting
        };
        let options = base.options;
        match self {
            Self::Preset => Preset::ALL.map(|preset| (preset.to_string(), of(&|s| s.options = preset.apply(options)))).into(),
            Self::Storage => vec![("words".to_owned(), of(&|s| s.packed_words = true))],
            Self::Keys => {
                let keys = KEYS.into_iter();
                let other = keys.filter(|&keys| keys != options.key_bits);
                other.map(|keys| (key_bits(keys).to_string(), of(&|s| s.options.key_bits = keys))).collect()
            }
            Self::Color => {
                let other = COLORS.into_iter().filter(|&color| Some(color) != options.color);
                other.map(|color| (format!("{color:?}").to_lowercase(), of(&|s| s.options.color = Some(color)))).collect()
            }
            Self::Raster => {
                let other = Method::ALL.into_iter().filter(|&method| Some(method) != options.method);
                // A format that the method before brought with it goes with it.
                let brought = options.color.is_some() && options.color == options.method.map(Method::color);
                let with = |method: Method| {
                    of(&|s| {
                        s.options.method = Some(method);
                        s.options.color = if brought { Some(method.color()) } else { options.color };
                    })
                };
                other.map(|method| (method.name().to_owned(), with(method))).collect()
            }
            Self::Cutoff => numbers(&[1.0, 2.0, 4.0, 8.0], 255.0 * options.cutoff, "/255", |v| of(&|s| s.options.cutoff = v / 255.0)),
            Self::Rows => numbers(&[1.0, 0.75, 0.5, 0.25, 0.0], base.rows, "", |v| of(&|s| s.rows = v)),
            Self::Margin => {
                numbers(&[1.0, 2.0, 5.0, 10.0, 20.0, 50.0], 1e3 * options.margin, " mm", |v| of(&|s| s.options.margin = v / 1e3))
            }
            Self::Detail => {
                let levels = (1..=COARSEST).map(|level| Detail::FULL.at_least(level));
                let other = [Detail::FULL, Detail::AUTO].into_iter().chain(levels).filter(|&detail| detail != options.detail);
                other.map(|detail| (detail.to_string(), of(&|s| s.options.detail = detail))).collect()
            }
            Self::PoseRate => numbers(&[1.0, 2.0, 3.0, 4.0, 6.0], base.hold as f64, "", |v| of(&|s| s.hold = v as usize))
                .into_iter()
                .map(in_hertz)
                .collect(),
            Self::Skip => [Skip::all(), Skip::empty()]
                .into_iter()
                .filter(|&skip| skip != options.skip)
                .map(|skip| (if skip.is_empty() { "none" } else { "all" }.to_owned(), of(&|s| s.options.skip = skip)))
                .collect(),
            Self::SkipBut => {
                options.skip.iter_names().map(|(name, one)| (name.to_ascii_lowercase(), of(&|s| s.options.skip -= one))).collect()
            }
        }
    }
}

fn in_hertz((_, setting): (String, Setting)) -> (String, Setting) {
    (format!("{} Hz", RATE / setting.hold as f64), setting)
}

/// The settings of all numbers but the one that the base has.
fn numbers(all: &[f64], base: f64, unit: &str, set: impl Fn(f64) -> Setting) -> Vec<(String, Setting)> {
    all.iter().filter(|&&v| (v - base).abs() > 1e-9).map(|&v| (format!("{v}{unit}"), set(v))).collect()
}

impl fmt::Display for Knob {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Knob {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let names = || Self::ALL.map(Self::name).join(", ");
        Self::ALL
            .into_iter()
            .find(|knob| knob.name() == text)
            .ok_or_else(|| format!("`{text}` is no knob: write all, or some of {}", names()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vulkan::RendererOptions;

    fn base() -> Setting {
        Setting { options: RendererOptions::new([64, 64]), packed_words: false, rows: 1.0, hold: 1 }
    }

    #[test]
    fn a_knob_has_every_value_but_the_settings_own() {
        let names = |knob: Knob| knob.values(&base()).into_iter().map(|(name, _)| name).collect::<Vec<_>>();
        assert_eq!(names(Knob::Rows), ["0.75", "0.5", "0.25", "0"]);
        assert_eq!(names(Knob::PoseRate), ["30 Hz", "20 Hz", "15 Hz", "10 Hz"]);
        assert_eq!(names(Knob::Cutoff), ["2/255", "4/255", "8/255"]);
        assert_eq!(names(Knob::Keys).len(), 2);
        assert_eq!(names(Knob::Detail), ["auto", "1/2", "1/4", "1/8"]);
        assert_eq!(names(Knob::Skip), ["all", "none"]);
        assert_eq!(names(Knob::SkipBut).len(), base().options.skip.iter_names().count());
        for knob in Knob::ALL {
            assert_eq!(knob.to_string().parse(), Ok(knob));
            let names = names(knob);
            assert!(!names.is_empty() && names.iter().collect::<std::collections::BTreeSet<_>>().len() == names.len(), "{knob}: {names:?}");
        }
        assert!("speed".parse::<Knob>().is_err_and(|error| error.contains("margin")));
    }

    #[test]
    fn a_value_changes_its_own_knob_alone() {
        let text = |setting: &Setting| format!("{setting:?}");
        for knob in Knob::ALL.into_iter().filter(|&knob| knob != Knob::Preset) {
            for (value, setting) in knob.values(&base()) {
                assert!(text(&setting) != text(&base()), "{knob} {value} changes nothing");
                let back = match knob {
                    Knob::Storage => Setting { packed_words: false, ..setting },
                    Knob::Rows => Setting { rows: 1.0, ..setting },
                    Knob::PoseRate => Setting { hold: 1, ..setting },
                    _ => {
                        let mut options = setting.options;
                        match knob {
                            Knob::Keys => options.key_bits = base().options.key_bits,
                            Knob::Color => options.color = base().options.color,
                            Knob::Raster => options.method = base().options.method,
                            Knob::Cutoff => options.cutoff = base().options.cutoff,
                            Knob::Margin => options.margin = base().options.margin,
                            Knob::Detail => options.detail = base().options.detail,
                            _ => options.skip = base().options.skip,
                        }
                        Setting { options, ..setting }
                    }
                };
                assert_eq!(text(&back), text(&base()), "{knob} {value}");
            }
        }
    }
}
