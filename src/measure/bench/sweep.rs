//! Sweeps: each parameter that trades time for error is varied in turn from a base setting, and the
//! time and error of every value are measured.
//!
//! The values of a parameter and the base setting are measured in turn, frame for frame on equal
//! scenes, for some rounds, every other one backwards: A B C, C B A, A B C. A slowdown of the
//! machine hits neighbours alike, and no value is always the first. So ratios inside a group hold
//! even where milliseconds do not.

use super::{
    case::{BenchCase, BenchScene, BenchTask, RATE, scenes},
    frames::{BenchDevice, BenchRenderer, Progress, Result},
    measure::{self, CaseReference},
    report::{ErrorReport, SweepPoint, SweepReport},
};
use crate::{
    chart::{
        Axis, BLUE, Chart, ChartError, GREEN, INK, Line, LineStyle, NamedPoint, ORANGE, Panel, RED,
        Rgb,
    },
    setting::RenderSetting,
};
use effigy_core::{
    frame::{RasterMethod, Skip},
    scene::{Detail, Supersampling, detail::COARSEST},
};
use std::{fmt, str::FromStr};

/// Name of the base setting's point.
const BASE: &str = "default";

/// Opacity cutoffs, of 255.
const CUTOFFS: [f64; 4] = [1.0, 2.0, 4.0, 8.0];
/// Shares of the basis rows.
const ROWS: [f64; 5] = [1.0, 0.75, 0.5, 0.25, 0.0];
/// Frames that each pose is held for.
const HOLDS: [usize; 5] = [1, 2, 3, 4, 6];

/// Range of the PSNR below the best finite one in the chart, dB. Points further down are drawn at
/// the lower edge, with their PSNR in their name.
const DEPTH: f64 = 20.0;
/// Height of points without any error above the best finite PSNR, dB.
const PERFECT: f64 = 3.0;

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
    /// Skips everything but one kind of work: a closer look at [`Self::Skip`].
    SkipBut,
}

/// Every parameter, its name on the command line and in reports, and its colour in charts. The last
/// is not part of a sweep of all.
const PARAMETERS: [(Parameter, &str, Rgb); 9] = [
    (Parameter::Exact, "exact", Rgb(20, 20, 20)),
    (Parameter::Raster, "raster", BLUE),
    (Parameter::Cutoff, "cutoff", ORANGE),
    (Parameter::Rows, "rows", GREEN),
    (Parameter::Detail, "detail", Rgb(148, 103, 189)),
    (Parameter::Supersample, "supersample", Rgb(227, 119, 194)),
    (Parameter::PoseRate, "pose-rate", Rgb(23, 163, 184)),
    (Parameter::Skip, "skip", Rgb(150, 150, 20)),
    (Parameter::SkipBut, "skip-but", Rgb(0, 120, 120)),
];

impl Parameter {
    /// Those of a sweep of all.
    pub fn all() -> Vec<Self> {
        let all = PARAMETERS.iter().map(|known| known.0);
        all.filter(|&parameter| parameter != Self::SkipBut)
            .collect()
    }

    /// Every value but that of the base setting, by its name.
    fn values(self, base: &RenderSetting) -> Vec<(String, RenderSetting)> {
        let mut values = Vec::new();
        // Adds a value that differs from the base setting's; `set` sets it in a copy of that.
        let mut add = |differs: bool, name: String, set: &dyn Fn(&mut RenderSetting)| {
            let mut setting = *base;
            set(&mut setting);
            if differs {
                values.push((name, setting));
            }
        };
        let options = &base.options;
        let is_other = |value: f64, own: f64| (value - own).abs() > 1e-9;
        match self {
            Self::Exact => add(!options.exact, "yes".into(), &|s| {
                s.options = s.options.exactly();
            }),
            Self::Raster => {
                for method in RasterMethod::ALL {
                    let differs = Some(method) != options.method;
                    let set = |s: &mut RenderSetting| s.options.method = Some(method);
                    add(differs, method.name().into(), &set);
                }
            }
            Self::Cutoff => {
                for cutoff in CUTOFFS {
                    let differs = is_other(cutoff, 255.0 * options.cutoff);
                    let set = |s: &mut RenderSetting| s.options.cutoff = cutoff / 255.0;
                    add(differs, format!("{cutoff}/255"), &set);
                }
            }
            Self::Rows => {
                for rows in ROWS {
                    let differs = is_other(rows, base.rows);
                    add(differs, rows.to_string(), &|s| s.rows = rows);
                }
            }
            Self::Detail => {
                let levels = (1..=COARSEST).map(|level| Detail::FULL.at_least(level));
                for detail in [Detail::FULL, Detail::AUTO].into_iter().chain(levels) {
                    let set = |s: &mut RenderSetting| s.options.detail = detail;
                    add(detail != options.detail, detail.to_string(), &set);
                }
            }
            Self::Supersample => {
                let factors = [1, 2, 4].map(Supersampling::Times);
                for factor in [Supersampling::BySize].into_iter().chain(factors) {
                    let set = |s: &mut RenderSetting| s.options.supersampling = factor;
                    add(factor != options.supersampling, factor.to_string(), &set);
                }
            }
            Self::PoseRate => {
                for hold in HOLDS {
                    let name = format!("{} Hz", RATE / hold as f64);
                    add(hold != base.hold, name, &|s| s.hold = hold);
                }
            }
            Self::Skip => {
                for (name, skip) in [("all", Skip::all()), ("none", Skip::empty())] {
                    let set = |s: &mut RenderSetting| s.options.skip = skip;
                    add(skip != options.skip, name.into(), &set);
                }
            }
            Self::SkipBut => {
                for (name, work) in options.skip.iter_names() {
                    let set = |s: &mut RenderSetting| s.options.skip -= work;
                    add(true, name.to_ascii_lowercase(), &set);
                }
            }
        }
        values
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(PARAMETERS[*self as usize].1)
    }
}

impl FromStr for Parameter {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let known = PARAMETERS.iter().find(|known| known.1 == text);
        known.map(|known| known.0).ok_or_else(|| {
            let names = PARAMETERS.map(|known| known.1).join(", ");
            format!("`{text}` is not a parameter: write all, or some of {names}")
        })
    }
}

/// Options of a sweep besides its task.
#[derive(Clone, Copy, Debug)]
pub struct Sweep<'a> {
    /// The case that is drawn.
    pub case: BenchCase,
    /// The parameters to vary.
    pub parameters: &'a [Parameter],
    /// Times that every value is measured, at least 1.
    pub rounds: usize,
    /// The setting from which the parameters are varied.
    pub base: RenderSetting,
}

/// Measures every value of every parameter. `keep` gets what is measured so far with each point, and
/// the whole at last.
///
/// # Errors
/// When the device fails, or refuses the base setting.
pub fn run_sweep(
    gpu: &BenchDevice,
    task: &BenchTask,
    sweep: &Sweep,
    progress: Progress,
    keep: &mut dyn FnMut(SweepReport),
) -> Result<()> {
    let mut truth = CaseReference::new(sweep.case, task, &sweep.base, false);
    // Settings that the device can't draw with, and why.
    let mut failed = Vec::new();
    // Points, the base setting's first in each group.
    let mut groups: Vec<Vec<SweepPoint>> = Vec::new();
    for &parameter in sweep.parameters {
        let base = Entry::open(gpu, task, sweep, BASE, (String::new(), sweep.base))?;
        let mut entries = vec![base];
        for value in parameter.values(&sweep.base) {
            let title = format!("{parameter} {}", value.0);
            match Entry::open(gpu, task, sweep, &parameter.to_string(), value) {
                Ok(entry) => entries.push(entry),
                Err(error) if error.is_refusal() => failed.push(format!("{title}: {error}")),
                Err(error) => return Err(error),
            }
        }
        for round in 0..sweep.rounds {
            let mut order: Vec<&mut Entry> = entries.iter_mut().collect();
            if round % 2 == 1 {
                order.reverse();
            }
            for entry in order {
                entry.time(round, progress)?;
            }
        }
        groups.push(Vec::new());
        let base_rounds = entries[0].frame_ms.clone();
        for entry in entries {
            let point = entry.point(gpu, task, sweep, &base_rounds, &mut truth, progress)?;
            groups.last_mut().expect("its own").push(point);
            keep(SweepReport {
                case: sweep.case.to_string(),
                frames: task.frames.unwrap_or(sweep.case.default_frames(true)),
                rounds: sweep.rounds,
                points: gather(groups.clone()),
                failed: failed.clone(),
            });
        }
    }
    Ok(())
}

/// A setting while it is measured.
struct Entry {
    parameter: String,
    value: String,
    setting: RenderSetting,
    renderer: BenchRenderer,
    scenes: Vec<BenchScene>,
    /// Times of each round's frames, ms.
    frame_ms: Vec<Vec<f64>>,
    gpu_ms: Vec<Vec<f64>>,
}

impl Entry {
    fn open(
        gpu: &BenchDevice,
        task: &BenchTask,
        sweep: &Sweep,
        parameter: &str,
        (value, setting): (String, RenderSetting),
    ) -> Result<Self> {
        let setting = setting.for_case(sweep.case);
        Ok(Self {
            parameter: parameter.to_owned(),
            value,
            setting,
            renderer: BenchRenderer::of_case(gpu, task, &setting, sweep.case, false)?,
            scenes: scenes(sweep.case, task, &setting, true),
            frame_ms: Vec::new(),
            gpu_ms: Vec::new(),
        })
    }

    fn time(&mut self, round: usize, progress: Progress) -> Result<()> {
        let title = format!("{} {}, round {}", self.parameter, self.value, round + 1);
        let all = self.scenes.len();
        let tick = |done| progress(&title, done, all);
        let (intervals, reports) = self.renderer.time(&self.scenes, tick)?;
        self.frame_ms.push(intervals);
        self.gpu_ms
            .push(reports.iter().map(measure::gpu_ms).collect());
        Ok(())
    }

    /// `base`: times of the base setting's rounds.
    fn point(
        mut self,
        gpu: &BenchDevice,
        task: &BenchTask,
        sweep: &Sweep,
        base: &[Vec<f64>],
        truth: &mut CaseReference,
        progress: Progress,
    ) -> Result<SweepPoint> {
        let title = format!("{} {}", self.parameter, self.value);
        let mut told =
            |what: &str, done: usize, all: usize| progress(&format!("{title}: {what}"), done, all);
        let (checked, flicker) = truth.compare(&mut self.renderer, &self.scenes, &mut told)?;
        drop(self.renderer);
        let setting = &self.setting;
        let counters = measure::count(gpu, task, setting, sweep.case, &self.scenes, &mut told)?;
        let measured_ms = mean_of_medians(&self.frame_ms);
        let time_ratio = measured_ms / mean_of_medians(base);
        let mean = |times: &[f64]| times.iter().sum::<f64>() / times.len().max(1) as f64;
        let mut time_ratio_range = [time_ratio; 2];
        for (own, base) in self.frame_ms.iter().zip(base) {
            let ratio = mean(own) / mean(base);
            time_ratio_range[0] = time_ratio_range[0].min(ratio);
            time_ratio_range[1] = time_ratio_range[1].max(ratio);
        }
        Ok(SweepPoint {
            parameter: self.parameter,
            value: self.value,
            measured_ms,
            time_ratio,
            time_ratio_range,
            frame_ms: measured_ms,
            gpu_ms: gpu.is_timed().then(|| mean_of_medians(&self.gpu_ms)),
            counters,
            error: checked.error.unwrap_or(ErrorReport::NONE),
            flicker,
            on_front: false,
        })
    }
}

/// The mean over the frames of each frame's median over the rounds: a disturbance in one round does
/// not show, and a frame that needs less than its neighbours still counts.
fn mean_of_medians(rounds: &[Vec<f64>]) -> f64 {
    let frames = rounds.iter().map(Vec::len).min().unwrap_or(0);
    let median = |frame: usize| {
        let mut times: Vec<f64> = rounds.iter().map(|round| round[frame]).collect();
        times.sort_by(f64::total_cmp);
        (times[(times.len() - 1) / 2] + times[times.len() / 2]) / 2.0
    };
    (0..frames).map(median).sum::<f64>() / frames.max(1) as f64
}

/// One list of all groups: the base setting once, with its median time, and all others with the
/// times that they would have beside that; the Pareto front is marked.
fn gather(groups: Vec<Vec<SweepPoint>>) -> Vec<SweepPoint> {
    let bases = groups.iter().filter_map(|group| group.first());
    let mut base_times: Vec<f64> = bases.clone().map(|base| base.measured_ms).collect();
    base_times.sort_by(f64::total_cmp);
    let Some(&median) = base_times.get(base_times.len() / 2) else {
        return Vec::new();
    };
    let base = bases.clone().find(|base| base.measured_ms == median);
    let mut points: Vec<SweepPoint> = base.cloned().into_iter().collect();
    for group in groups {
        points.extend(group.into_iter().skip(1));
    }
    for point in &mut points {
        point.frame_ms = point.time_ratio * median;
    }
    let candidate =
        |point: &SweepPoint| (point.frame_ms, point.error.psnr_db.unwrap_or(f64::INFINITY));
    let candidates: Vec<_> = points.iter().map(candidate).collect();
    for (point, &own) in points.iter_mut().zip(&candidates) {
        point.on_front = is_on_front(own, &candidates);
    }
    points
}

/// Whether no other candidate is at least as good in both and better in one. Of each, first the
/// cost, of which less is better, then the value, of which more is. One with a NaN never is.
fn is_on_front((cost, value): (f64, f64), all: &[(f64, f64)]) -> bool {
    let dominates =
        |other: &(f64, f64)| other.0 <= cost && other.1 >= value && *other != (cost, value);
    !cost.is_nan() && !value.is_nan() && !all.iter().any(dominates)
}

impl SweepReport {
    /// The chart: frame time to the right, PSNR upwards, so that the best settings are at the upper
    /// left. Each point is named by its parameter and value; the line is the Pareto front. `title`
    /// says what was measured, and on what.
    ///
    /// # Errors
    /// [`ChartError::Nothing`] if no setting was measured to the end.
    pub fn chart(&self, title: String) -> std::result::Result<Chart, ChartError> {
        let is_known = |point: &&SweepPoint| point.error.frames > 0 && point.frame_ms.is_finite();
        let mut points: Vec<&SweepPoint> = self.points.iter().filter(is_known).collect();
        // In the order in which their names choose their places.
        let is_exact = |point: &SweepPoint| point.parameter == Parameter::Exact.to_string();
        points.sort_by_key(|point| (point.parameter != BASE, !is_exact(point), !point.on_front));
        let psnr = points.iter().filter_map(|point| point.error.psnr_db);
        let best = psnr.reduce(f64::max).unwrap_or(0.0);
        let lowest = best - DEPTH;
        let at = |point: &&SweepPoint| {
            let psnr_db = point.error.psnr_db.unwrap_or(best + PERFECT);
            (point.frame_ms, psnr_db.max(lowest))
        };
        let named = |point: &&SweepPoint| {
            let title = format!("{} {}", point.parameter, point.value);
            let title = title.trim();
            let known = PARAMETERS.iter().find(|known| known.1 == point.parameter);
            NamedPoint {
                at: at(point),
                name: match point.error.psnr_db {
                    None => format!("{title}: no error"),
                    Some(psnr) if psnr < lowest => format!("{title}: {psnr:.1} dB"),
                    Some(_) => title.to_owned(),
                },
                color: known.map_or(INK, |known| known.2),
                is_large: point.parameter == BASE || is_exact(point),
                is_ringed: point.on_front,
            }
        };
        let mut front: Vec<_> = points.iter().filter(|own| own.on_front).map(at).collect();
        front.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let times = points.iter().map(|point| at(point).0);
        let heights = points.iter().map(|point| at(point).1);
        let x = format!(
            "frame time, ms (case `{}`, {} frames, {} rounds in turn)",
            self.case, self.frames, self.rounds
        );
        let y = "PSNR of the worst frame over covered pixels, dB";
        let x = Axis::around(x, times, 1.0 / 12.0, 0.02)?;
        let y = Axis::around(y, heights, 1.0 / 12.0, 0.5)?;
        let mut panel = Panel::new(x, y);
        panel.lines = vec![Line::new("", RED, LineStyle::Steps, front)];
        panel.points = points.iter().map(named).collect();
        Ok(Chart {
            title,
            size: [1400, 900],
            panels: vec![panel],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::tests::pixels_of_color;
    use effigy_core::frame::RendererOptions;
    use proptest::{collection::vec, prelude::*};

    fn values(parameter: Parameter) -> Vec<(String, RenderSetting)> {
        parameter.values(&RenderSetting::new(RendererOptions::new([64, 64])))
    }

    #[test]
    fn a_parameter_has_every_value_but_the_settings_own() {
        let names = |parameter: Parameter| -> Vec<String> {
            values(parameter).into_iter().map(|own| own.0).collect()
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
        let kinds = Skip::all().iter_names().count();
        assert_eq!(names(Parameter::SkipBut).len(), kinds);
        for (at, (parameter, ..)) in PARAMETERS.into_iter().enumerate() {
            assert_eq!(parameter as usize, at);
            assert_eq!(parameter.to_string().parse(), Ok(parameter));
        }
        let wrong = "speed".parse::<Parameter>();
        assert!(wrong.is_err_and(|error| error.contains("cutoff")));
    }

    #[test]
    fn a_value_changes_its_own_parameter_alone() {
        let base = RenderSetting::new(RendererOptions::new([64, 64]));
        let text = |setting: &RenderSetting| format!("{setting:?}");
        for (parameter, ..) in PARAMETERS {
            for (name, mut setting) in values(parameter) {
                assert_ne!(text(&setting), text(&base), "{parameter} {name}");
                let options = &mut setting.options;
                match parameter {
                    Parameter::Exact => continue,
                    Parameter::Rows => setting.rows = base.rows,
                    Parameter::PoseRate => setting.hold = base.hold,
                    Parameter::Raster => options.method = base.options.method,
                    Parameter::Cutoff => options.cutoff = base.options.cutoff,
                    Parameter::Detail => options.detail = base.options.detail,
                    Parameter::Supersample => options.supersampling = base.options.supersampling,
                    Parameter::Skip | Parameter::SkipBut => options.skip = base.options.skip,
                }
                assert_eq!(text(&setting), text(&base), "{parameter} {name}");
            }
        }
    }

    fn point(parameter: &str, value: &str, frame_ms: f64, psnr_db: Option<f64>) -> SweepPoint {
        SweepPoint {
            parameter: parameter.to_owned(),
            value: value.to_owned(),
            measured_ms: frame_ms,
            time_ratio: 1.0,
            time_ratio_range: [1.0; 2],
            frame_ms,
            gpu_ms: None,
            counters: Default::default(),
            error: ErrorReport {
                frames: 4,
                psnr_db,
                ..ErrorReport::NONE
            },
            flicker: None,
            on_front: false,
        }
    }

    #[test]
    fn one_disturbed_round_does_not_show() {
        let rounds = [vec![10.0, 2.0], vec![99.0, 2.0], vec![10.0, 77.0]];
        assert_eq!(mean_of_medians(&rounds), 6.0);
        assert_eq!(mean_of_medians(&[vec![1.0], vec![3.0]]), 2.0);
        assert_eq!(mean_of_medians(&[]), 0.0);
    }

    #[test]
    fn groups_are_compared_by_their_ratios() {
        let measured = |name: &str, measured_ms: f64, time_ratio: f64, psnr_db: f64| SweepPoint {
            time_ratio,
            ..point(name, "", measured_ms, Some(psnr_db))
        };
        let base = |ms: f64| measured(BASE, ms, 1.0, 50.0);
        // The machine was half as fast during the second group.
        let points = gather(vec![
            vec![base(10.0), measured("color", 8.0, 0.8, 48.0)],
            vec![
                base(20.0),
                measured("keys", 18.0, 0.9, 49.0),
                measured("rows", 22.0, 1.1, 49.5),
            ],
            vec![base(10.5)],
        ]);
        let found: Vec<_> = points
            .iter()
            .map(|own| (own.parameter.as_str(), own.frame_ms, own.on_front))
            .collect();
        let expected = [
            (BASE, 10.5, true),
            ("color", 0.8 * 10.5, true),
            ("keys", 0.9 * 10.5, true),
            ("rows", 1.1 * 10.5, false),
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn what_is_slower_and_worse_is_off_the_front() {
        let all = [
            (10.0, 50.0),
            (5.0, 40.0),
            (7.0, 39.0),
            (12.0, f64::INFINITY),
            (10.0, 50.0),
            (f64::NAN, 99.0),
            (5.0, 30.0),
        ];
        let front = all.map(|own| is_on_front(own, &all));
        assert_eq!(front, [true, true, false, true, true, false, false]);
        // 0 and −0 are one cost.
        assert!(!is_on_front((0.0, 1.0), &[(0.0, 1.0), (-0.0, 2.0)]));
    }

    proptest! {
        /// By rising cost, the front's values rise, and each that is off it is dominated by one of it.
        #[test]
        fn the_front_rises_and_dominates_the_rest(all in vec((0u8..12, 0u8..12), 0..40)) {
            let all: Vec<(f64, f64)> = all.into_iter().map(|(a, b)| (a.into(), b.into())).collect();
            let (mut front, rest): (Vec<(f64, f64)>, Vec<_>) =
                all.iter().partition(|&&own| is_on_front(own, &all));
            front.sort_by(|a, b| a.0.total_cmp(&b.0));
            prop_assert!(front.is_sorted_by(|a, b| a == b || a.0 < b.0 && a.1 < b.1), "{front:?}");
            for own in rest {
                prop_assert!(front.iter().any(|other| other.0 <= own.0 && other.1 >= own.1));
            }
        }
    }

    #[test]
    fn the_chart_names_every_point_and_draws_the_front() -> std::result::Result<(), ChartError> {
        let mut report = SweepReport {
            case: "orbit".to_owned(),
            frames: 8,
            rounds: 3,
            points: vec![
                point(BASE, "", 10.0, Some(55.0)),
                point("raster", "quads", 6.0, Some(48.0)),
                point("exact", "yes", 20.0, None),
                point("cutoff", "8/255", 9.0, Some(45.0)),
                point("pose-rate", "5 Hz", 7.0, Some(17.24)),
            ],
            failed: vec![],
        };
        for point in &mut report.points[..3] {
            point.on_front = true;
        }
        let chart = report.chart("a title".into())?;
        let text = String::from_utf8_lossy(&chart.encoded("svg")?).into_owned();
        for name in [
            BASE,
            "raster quads",
            "exact yes: no error",
            "cutoff 8/255",
            "pose-rate 5 Hz: 17.2 dB",
            "a title",
        ] {
            assert!(text.contains(name), "{name} is missing");
        }
        let red = pixels_of_color(&chart.encoded("png")?, RED);
        assert!(red > 500, "{red} pixels of the front's line");
        report.points.clear();
        let empty = report.chart(String::new());
        assert!(matches!(empty, Err(ChartError::Nothing)));
        Ok(())
    }
}
