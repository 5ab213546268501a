//! The parameters that trade time for error: a setting goes in; for every other value of a
//! parameter, the setting with that value comes out.

use super::scene::RATE;
use crate::setting::RenderSetting;
use effigy_core::{
    frame::{RasterMethod, Skip},
    scene::{Detail, Supersampling, detail::COARSEST},
};
use std::{fmt, str::FromStr};

/// Opacity cutoffs, of 255.
const CUTOFFS: [f64; 4] = [1.0, 2.0, 4.0, 8.0];
/// Shares of the basis rows.
const ROWS: [f64; 5] = [1.0, 0.75, 0.5, 0.25, 0.0];
/// Frames that each pose is held for.
const HOLDS: [usize; 5] = [1, 2, 3, 4, 6];

/// Something that trades time for error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// Whether the image is exact ([`effigy_core::frame::RendererOptions::exactly`]).
    Exact,
    /// Rasterization method.
    Raster,
    /// Opacity cutoff.
    Cutoff,
    /// Share of the basis rows.
    Rows,
    /// Level of detail.
    Detail,
    /// How many times its size a small avatar is drawn.
    Supersample,
    /// Poses a second.
    PoseRate,
    /// Work that may be skipped: all or none.
    Skip,
    /// Skips everything but one kind of work.
    SkipBut,
}

/// A value of a parameter.
#[derive(Clone, Debug)]
pub struct ParameterValue {
    /// The value in words.
    pub name: String,
    /// The base setting with this value.
    pub setting: RenderSetting,
}

impl Parameter {
    /// Every parameter. The last is for a closer look at [`Parameter::Skip`] and not part of a
    /// sweep of all.
    pub const ALL: [Self; 9] = [
        Self::Exact,
        Self::Raster,
        Self::Cutoff,
        Self::Rows,
        Self::Detail,
        Self::Supersample,
        Self::PoseRate,
        Self::Skip,
        Self::SkipBut,
    ];

    /// Name on the command line and in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Raster => "raster",
            Self::Cutoff => "cutoff",
            Self::Rows => "rows",
            Self::Detail => "detail",
            Self::Supersample => "supersample",
            Self::PoseRate => "pose-rate",
            Self::Skip => "skip",
            Self::SkipBut => "skip-but",
        }
    }

    /// Every value but that of the base setting.
    pub fn values(self, base: &RenderSetting) -> Vec<ParameterValue> {
        let mut values = ParameterValues::new(base);
        let options = &base.options;
        match self {
            Self::Exact => {
                if !options.exact {
                    values.add("yes", |s| s.options = s.options.exactly());
                }
            }
            Self::Raster => {
                for method in RasterMethod::ALL {
                    if Some(method) != options.method {
                        values.add(method.name(), |s| s.options.method = Some(method));
                    }
                }
            }
            Self::Cutoff => {
                for cutoff in CUTOFFS {
                    if differs(cutoff, 255.0 * options.cutoff) {
                        let name = format!("{cutoff}/255");
                        values.add(name, |s| s.options.cutoff = cutoff / 255.0);
                    }
                }
            }
            Self::Rows => {
                for rows in ROWS {
                    if differs(rows, base.rows) {
                        values.add(rows, |s| s.rows = rows);
                    }
                }
            }
            Self::Detail => {
                let levels = (1..=COARSEST).map(|level| Detail::FULL.at_least(level));
                for detail in [Detail::FULL, Detail::AUTO].into_iter().chain(levels) {
                    if detail != options.detail {
                        values.add(detail, |s| s.options.detail = detail);
                    }
                }
            }
            Self::Supersample => {
                let factors = [1, 2, 4].map(Supersampling::Times);
                for factor in [Supersampling::BySize].into_iter().chain(factors) {
                    if factor != options.supersampling {
                        values.add(factor, |s| s.options.supersampling = factor);
                    }
                }
            }
            Self::PoseRate => {
                for hold in HOLDS.into_iter().filter(|&hold| hold != base.hold) {
                    let name = format!("{} Hz", RATE / hold as f64);
                    values.add(name, |s| s.hold = hold);
                }
            }
            Self::Skip => {
                for (name, skip) in [("all", Skip::all()), ("none", Skip::empty())] {
                    if skip != options.skip {
                        values.add(name, |s| s.options.skip = skip);
                    }
                }
            }
            Self::SkipBut => {
                for (name, work) in options.skip.iter_names() {
                    values.add(name.to_ascii_lowercase(), |s| s.options.skip -= work);
                }
            }
        }
        values.values
    }
}

/// The values of a parameter as they are listed.
struct ParameterValues<'a> {
    base: &'a RenderSetting,
    values: Vec<ParameterValue>,
}

impl<'a> ParameterValues<'a> {
    fn new(base: &'a RenderSetting) -> Self {
        Self {
            base,
            values: Vec::new(),
        }
    }

    /// Adds a value; `set` sets it in a copy of the base setting.
    fn add(&mut self, name: impl fmt::Display, set: impl FnOnce(&mut RenderSetting)) {
        let mut setting = *self.base;
        set(&mut setting);
        self.values.push(ParameterValue {
            name: name.to_string(),
            setting,
        });
    }
}

fn differs(value: f64, base: f64) -> bool {
    (value - base).abs() > 1e-9
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Parameter {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let names = || Self::ALL.map(Self::name).join(", ");
        Self::ALL
            .into_iter()
            .find(|parameter| parameter.name() == text)
            .ok_or_else(|| {
                format!(
                    "`{text}` is not a parameter: write all, or some of {}",
                    names()
                )
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy::vulkan::RendererOptions;

    fn base() -> RenderSetting {
        RenderSetting {
            options: RendererOptions::new([64, 64]),
            rows: 1.0,
            hold: 1,
        }
    }

    #[test]
    fn a_parameter_has_every_value_but_the_settings_own() {
        let names = |parameter: Parameter| {
            parameter
                .values(&base())
                .into_iter()
                .map(|value| value.name)
                .collect::<Vec<_>>()
        };
        assert_eq!(names(Parameter::Rows), ["0.75", "0.5", "0.25", "0"]);
        assert_eq!(
            names(Parameter::PoseRate),
            ["30 Hz", "20 Hz", "15 Hz", "10 Hz"]
        );
        assert_eq!(names(Parameter::Cutoff), ["2/255", "4/255", "8/255"]);
        assert_eq!(names(Parameter::Exact), ["yes"]);
        assert_eq!(names(Parameter::Detail), ["auto", "1/2", "1/4", "1/8"]);
        assert_eq!(names(Parameter::Supersample), ["1", "2", "4"]);
        assert_eq!(names(Parameter::Skip), ["none"]);
        assert_eq!(
            names(Parameter::SkipBut).len(),
            base().options.skip.iter_names().count()
        );
        for parameter in Parameter::ALL {
            assert_eq!(parameter.to_string().parse(), Ok(parameter));
            let names = names(parameter);
            assert!(
                !names.is_empty()
                    && names
                        .iter()
                        .collect::<std::collections::BTreeSet<_>>()
                        .len()
                        == names.len(),
                "{parameter}: {names:?}"
            );
        }
        assert!(
            "speed"
                .parse::<Parameter>()
                .is_err_and(|error| error.contains("cutoff"))
        );
    }

    #[test]
    fn a_value_changes_its_own_parameter_alone() {
        let text = |setting: &RenderSetting| format!("{setting:?}");
        for parameter in Parameter::ALL
            .into_iter()
            .filter(|&parameter| parameter != Parameter::Exact)
        {
            for ParameterValue { name, setting } in parameter.values(&base()) {
                assert!(
                    text(&setting) != text(&base()),
                    "{parameter} {name} changes nothing"
                );
                let back = match parameter {
                    Parameter::Rows => RenderSetting {
                        rows: 1.0,
                        ..setting
                    },
                    Parameter::PoseRate => RenderSetting { hold: 1, ..setting },
                    _ => {
                        let mut options = setting.options;
                        match parameter {
                            Parameter::Raster => options.method = base().options.method,
                            Parameter::Cutoff => options.cutoff = base().options.cutoff,
                            Parameter::Detail => options.detail = base().options.detail,
                            Parameter::Supersample => {
                                options.supersampling = base().options.supersampling;
                            }
                            _ => options.skip = base().options.skip,
                        }
                        RenderSetting { options, ..setting }
                    }
                };
                assert_eq!(text(&back), text(&base()), "{parameter} {name}");
            }
        }
    }
}
