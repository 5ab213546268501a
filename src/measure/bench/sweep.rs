//! Sweeps: each parameter in turn is varied from a base setting, and the time and error of every
//! value are measured.
//!
//! The values of a parameter and the base setting are measured in turn, frame for frame on equal
//! scenes, for some rounds, every other one backwards: A B C, C B A, A B C. A slowdown of the
//! machine hits neighbours alike, and no value is always the first. So ratios inside a group hold
//! even where milliseconds do not.

use super::{
    backend::{BenchDevice, Result},
    case::BenchCase,
    check::{self, ReferenceImages},
    flicker::{self, FlickerTruth},
    measured,
    parameter::{Parameter, ParameterValue},
    pareto::{Candidate, front},
    report::{ErrorReport, SweepPoint, SweepReport},
    run::{self, CaseRenderer, Progress},
    scene::{self, BenchScene},
    task::BenchTask,
};
use crate::setting::RenderSetting;

/// Name of the base setting's point.
pub const BASE: &str = "default";

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
    let mut run = SweepRun {
        gpu,
        task,
        sweep,
        reference_images: ReferenceImages::new(task.avatar),
        flicker_truth: FlickerTruth::new(sweep.case, task.avatar, sweep.base.options.filter, false),
        failed: Vec::new(),
    };
    let mut groups = Vec::new();
    for &parameter in sweep.parameters {
        let mut entries = run.open(parameter)?;
        run.time(&mut entries, progress)?;
        groups.push(Vec::new());
        let mut base: Option<EntryTimes> = None;
        for entry in entries {
            let times = EntryTimes::new(&entry.rounds);
            let base = base.get_or_insert_with(|| times.clone());
            let point = run.point(entry, &times, base, progress)?;
            groups.last_mut().expect("its own").push(point);
            keep(run.report(groups.clone()));
        }
    }
    Ok(())
}

/// A setting while it is measured.
struct SweepEntry {
    parameter: String,
    value: String,
    setting: RenderSetting,
    renderer: CaseRenderer,
    scenes: Vec<BenchScene>,
    /// Whether the device has timestamps.
    is_timed: bool,
    rounds: Vec<Round>,
}

/// Times of all frames in one round, ms.
struct Round {
    frame_ms: Vec<f64>,
    gpu_ms: Vec<f64>,
}

/// A sweep in progress.
struct SweepRun<'a> {
    gpu: &'a BenchDevice,
    task: &'a BenchTask<'a>,
    sweep: &'a Sweep<'a>,
    reference_images: ReferenceImages<'a>,
    flicker_truth: FlickerTruth<'a>,
    /// Settings that the device can't draw with, and why.
    failed: Vec<String>,
}

impl SweepRun<'_> {
    /// Renderers for a parameter's values, the base setting first.
    fn open(&mut self, parameter: Parameter) -> Result<Vec<SweepEntry>> {
        let base = ParameterValue {
            name: String::new(),
            setting: self.sweep.base,
        };
        let mut entries = vec![self.open_entry(BASE, base)?];
        for value in parameter.values(&self.sweep.base) {
            let title = format!("{parameter} {}", value.name);
            match self.open_entry(parameter.name(), value) {
                Ok(entry) => entries.push(entry),
                Err(error) if error.is_refusal() => self.failed.push(format!("{title}: {error}")),
                Err(error) => return Err(error),
            }
        }
        Ok(entries)
    }

    fn open_entry(&mut self, parameter: &str, value: ParameterValue) -> Result<SweepEntry> {
        let case = self.sweep.case;
        let setting = value.setting.for_case(case);
        let avatar = setting.reduce(self.task.avatar);
        Ok(SweepEntry {
            parameter: parameter.to_owned(),
            value: value.name,
            renderer: CaseRenderer::new(self.gpu, &avatar, &setting, case, false)?,
            scenes: scene::scenes(case, &self.task.scene_inputs(&setting)),
            is_timed: self.gpu.is_timed(),
            rounds: Vec::new(),
            setting,
        })
    }

    /// Times all entries in turn, every other round backwards.
    fn time(&self, entries: &mut [SweepEntry], progress: Progress) -> Result<()> {
        for round in 0..self.sweep.rounds {
            let mut order: Vec<usize> = (0..entries.len()).collect();
            if round % 2 == 1 {
                order.reverse();
            }
            for index in order {
                let entry = &mut entries[index];
                let title = format!("{} {}, round {}", entry.parameter, entry.value, round + 1);
                let all = entry.scenes.len();
                let warm_up = self.task.warm_up;
                let samples = run::time(&mut entry.renderer, &entry.scenes, warm_up, |done| {
                    progress(&title, done, all)
                })?;
                entry.rounds.push(Round {
                    gpu_ms: samples.reports.iter().map(measured::gpu_ms).collect(),
                    frame_ms: samples.intervals,
                });
            }
        }
        Ok(())
    }

    /// What is measured so far, by groups of points, the base setting first in each.
    fn report(&self, groups: Vec<Vec<SweepPoint>>) -> SweepReport {
        let mut points = gather(groups);
        mark_front(&mut points);
        SweepReport {
            case: self.sweep.case.to_string(),
            frames: self.task.frames,
            rounds: self.sweep.rounds,
            points,
            failed: self.failed.clone(),
        }
    }

    fn point(
        &mut self,
        mut entry: SweepEntry,
        times: &EntryTimes,
        base: &EntryTimes,
        progress: Progress,
    ) -> Result<SweepPoint> {
        let case = self.sweep.case;
        let title = format!("{} {}", entry.parameter, entry.value);
        let mut told =
            |what: &str, done: usize, all: usize| progress(&format!("{title}: {what}"), done, all);
        let (checked, flicker) = if case.has_flicker() {
            let measured = flicker::measure_flicker(
                &mut entry.renderer,
                &entry.scenes,
                &mut self.flicker_truth,
                self.task.flip,
                &mut told,
            )?;
            (measured.checked, Some(measured.report))
        } else {
            let checked = check::check(
                &mut entry.renderer,
                case,
                &entry.scenes,
                &scene::checks(case, entry.scenes.len(), self.task.checked),
                &mut self.reference_images,
                self.task.flip,
                &mut told,
            )?;
            (checked, None)
        };
        // Counting takes time, so it is done by a renderer of its own.
        drop(entry.renderer);
        let avatar = entry.setting.reduce(self.task.avatar);
        let mut counting_renderer =
            CaseRenderer::new(self.gpu, &avatar, &entry.setting, case, true)?;
        let counted = run::count(&mut counting_renderer, &entry.scenes, |done| {
            progress(&format!("{title}: counting"), done, entry.scenes.len())
        })?;
        let time_ratio = times.measured_ms / base.measured_ms;
        let mut time_ratio_range = [time_ratio; 2];
        for (round_ms, base_round_ms) in times.round_ms.iter().zip(&base.round_ms) {
            let ratio = round_ms / base_round_ms;
            time_ratio_range[0] = time_ratio_range[0].min(ratio);
            time_ratio_range[1] = time_ratio_range[1].max(ratio);
        }
        let gpu_rounds = entry.rounds.iter().map(|round| round.gpu_ms.as_slice());
        let gpu_ms = mean_of_medians(&gpu_rounds.collect::<Vec<_>>());
        Ok(SweepPoint {
            parameter: entry.parameter,
            value: entry.value,
            measured_ms: times.measured_ms,
            time_ratio,
            time_ratio_range,
            frame_ms: times.measured_ms,
            gpu_ms: entry.is_timed.then_some(gpu_ms),
            counters: measured::counters(&counted),
            error: checked.error.unwrap_or(ErrorReport::NONE),
            flicker,
            on_front: false,
        })
    }
}

/// Frame times of a setting, ms.
#[derive(Clone)]
struct EntryTimes {
    /// Mean over the frames of each frame's median over the rounds.
    measured_ms: f64,
    /// Mean of each round.
    round_ms: Vec<f64>,
}

impl EntryTimes {
    fn new(rounds: &[Round]) -> Self {
        let times: Vec<_> = rounds
            .iter()
            .map(|round| round.frame_ms.as_slice())
            .collect();
        let mean = |times: &&[f64]| times.iter().sum::<f64>() / times.len().max(1) as f64;
        Self {
            measured_ms: mean_of_medians(&times),
            round_ms: times.iter().map(mean).collect(),
        }
    }
}

/// The mean over the frames of each frame's median over the rounds: a disturbance in one round does
/// not show, and a frame that needs less than its neighbours still counts.
fn mean_of_medians(rounds: &[&[f64]]) -> f64 {
    let frames = rounds.iter().map(|round| round.len()).min().unwrap_or(0);
    let median = |frame: usize| {
        let mut times: Vec<f64> = rounds.iter().map(|round| round[frame]).collect();
        times.sort_by(f64::total_cmp);
        (times[(times.len() - 1) / 2] + times[times.len() / 2]) / 2.0
    };
    (0..frames).map(median).sum::<f64>() / frames.max(1) as f64
}

/// One list of all groups: the base setting once, with its median time, and all others with the
/// times that they would have beside that.
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
    points
}

fn mark_front(points: &mut [SweepPoint]) {
    let candidate = |point: &SweepPoint| Candidate {
        cost: point.frame_ms,
        value: point.error.psnr_db.unwrap_or(f64::INFINITY),
    };
    let candidates: Vec<_> = points.iter().map(candidate).collect();
    for index in front(&candidates) {
        points[index].on_front = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(parameter: &str, measured_ms: f64, time_ratio: f64, psnr_db: f64) -> SweepPoint {
        SweepPoint {
            parameter: parameter.to_owned(),
            value: String::new(),
            measured_ms,
            time_ratio,
            time_ratio_range: [time_ratio; 2],
            frame_ms: measured_ms,
            gpu_ms: None,
            counters: Default::default(),
            error: ErrorReport {
                psnr_db: Some(psnr_db),
                ..ErrorReport::NONE
            },
            flicker: None,
            on_front: false,
        }
    }

    #[test]
    fn one_disturbed_round_does_not_show() {
        let rounds: [&[f64]; 3] = [&[10.0, 2.0], &[99.0, 2.0], &[10.0, 77.0]];
        assert_eq!(mean_of_medians(&rounds), 6.0);
        assert_eq!(mean_of_medians(&[&[1.0], &[3.0]]), 2.0);
        assert_eq!(mean_of_medians(&[]), 0.0);
    }

    #[test]
    fn groups_are_compared_by_their_ratios() {
        // The machine was half as fast during the second group.
        let first = vec![point(BASE, 10.0, 1.0, 50.0), point("color", 8.0, 0.8, 48.0)];
        let second = vec![
            point(BASE, 20.0, 1.0, 50.0),
            point("keys", 18.0, 0.9, 49.0),
            point("rows", 22.0, 1.1, 49.5),
        ];
        let third = vec![point(BASE, 10.5, 1.0, 50.0)];
        let mut points = gather(vec![first, second, third]);
        mark_front(&mut points);
        let found: Vec<_> = points
            .iter()
            .map(|point| {
                (
                    point.parameter.as_str(),
                    (point.frame_ms * 1e6).round() / 1e6,
                    point.on_front,
                )
            })
            .collect();
        assert_eq!(
            found,
            [
                (BASE, 10.5, true),
                ("color", 8.4, true),
                ("keys", 9.45, true),
                ("rows", 11.55, false)
            ]
        );
    }
}
