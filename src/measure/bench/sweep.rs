//! Sweeps: one knob after the other is turned away from a setting, and every value's time and error is measured.
//!
//! A knob's values and the setting itself take turns, frame for frame the same scenes, for some rounds, every other one backwards:
//! A B C, C B A, A B C. What a busy machine does to one it does to its neighbours, and none is always the first, so ratios inside a
//! group hold where milliseconds do not.

use super::{
    Case, Devices, Setting, Task,
    backend::Result,
    check::{self, Oracle},
    knob::Knob,
    measured,
    pareto::front,
    report::{ErrorReport, Point, SweepReport},
    run::{self, Drawer, Progress},
    scene::{self, Scene},
};

/// Name of the point that is the setting itself.
pub const BASE: &str = "default";

/// What a sweep is besides its task.
#[derive(Clone, Copy, Debug)]
pub struct Sweep<'a> {
    pub case: Case,
    pub knobs: &'a [Knob],
    /// Turns of every value, at least 1.
    pub rounds: usize,
    /// What the knobs are turned away from.
    pub base: Setting,
}

/// A value while it is measured.
struct Runner {
    knob: String,
    value: String,
    drawer: Drawer,
    scenes: Vec<Scene>,
    /// Time of each frame in each round, ms, and the GPU's.
    times: Vec<Vec<f64>>,
    gpu_times: Vec<Vec<f64>>,
    setting: Setting,
    timestamps: bool,
}

/// Measures every value of every knob.
pub fn sweep(devices: &mut Devices, task: &Task, sweep: &Sweep, progress: Progress) -> Result<SweepReport> {
    let mut oracle = Oracle::new(task.avatar);
    let mut failed = Vec::new();
    let mut groups = Vec::new();
    for &knob in sweep.knobs {
        let mut runners = Vec::new();
        let base = [(BASE.to_owned(), String::new(), sweep.base)].into_iter();
        for (name, value, setting) in base.chain(knob.values(&sweep.base).into_iter().map(|(value, s)| (knob.to_string(), value, s))) {
            match runner(devices, task, sweep.case, (&name, &value), &setting) {
                Ok(runner) => runners.push(runner),
                Err(error) if name != BASE && error.is_refusal() => failed.push(format!("{name} {value}: {error}")),
                Err(error) => return Err(error),
            }
        }
        for round in 0..sweep.rounds {
            let forwards = round % 2 == 0;
            for at in 0..runners.len() {
                let last = runners.len() - 1;
                let runner = &mut runners[if forwards { at } else { last - at }];
                let what = format!("{} {}, round {}", runner.knob, runner.value, round + 1);
                let all = runner.scenes.len();
                let samples = run::time(&mut runner.drawer, &runner.scenes, task.warm_up, |done| progress(&what, done, all))?;
                runner.gpu_times.push(samples.reports.iter().map(measured::gpu_ms).collect());
                runner.times.push(samples.intervals);
            }
        }
        groups.push(group(runners, (devices, task), sweep.case, &mut oracle, progress)?);
    }
    let mut points = gather(groups);
    mark_front(&mut points);
    Ok(SweepReport { case: sweep.case.to_string(), frames: task.frames, rounds: sweep.rounds, points, failed })
}

fn runner(devices: &mut Devices, task: &Task, case: Case, (knob, value): (&str, &str), setting: &Setting) -> Result<Runner> {
    let setting = &setting.of(case);
    let gpu = devices.get(setting)?;
    Ok(Runner {
        knob: knob.to_owned(),
        value: value.to_owned(),
        drawer: Drawer::new(&gpu, &setting.fit(task.avatar), setting, case, false)?,
        scenes: scene::scenes(case, &task.set(setting)),
        times: Vec::new(),
        gpu_times: Vec::new(),
        setting: *setting,
        timestamps: gpu.is_timed(),
    })
}

/// The points of one knob, the setting itself first.
fn group(
    runners: Vec<Runner>,
    (devices, task): (&mut Devices, &Task),
    case: Case,
    oracle: &mut Oracle,
    progress: Progress,
) -> Result<Vec<Point>> {
    let mut points: Vec<Point> = Vec::new();
    let mut base_rounds: Option<Vec<f64>> = None;
    for mut runner in runners {
        let numbers = scene::checks(case, runner.scenes.len(), task.checked);
        let mut show = |what: &str, done, all| progress(&format!("{} {}: {what}", runner.knob, runner.value), done, all);
        let checked = check::check(&mut runner.drawer, &runner.scenes, &numbers, oracle, task.flip, &mut show)?;
        // Counting takes time, so it has a turn of its own.
        drop(runner.drawer);
        let gpu = devices.get(&runner.setting)?;
        let mut counter = Drawer::new(&gpu, &runner.setting.fit(task.avatar), &runner.setting, case, true)?;
        let counted = run::count(&mut counter, &runner.scenes, |done| show("counting", done, runner.scenes.len()))?;
        let measured_ms = mean_of_medians(&runner.times);
        let time_ratio = measured_ms / points.first().map_or(measured_ms, |base| base.measured_ms);
        let rounds: Vec<f64> = runner.times.iter().map(|round| round.iter().sum::<f64>() / round.len().max(1) as f64).collect();
        let base = base_rounds.get_or_insert_with(|| rounds.clone());
        let ratios: Vec<f64> = rounds.iter().zip(base).map(|(ms, base)| ms / *base).collect();
        points.push(Point {
            knob: runner.knob,
            value: runner.value,
            measured_ms,
            time_ratio,
            time_ratio_range: ratios.iter().fold([time_ratio; 2], |[low, high], &ratio| [low.min(ratio), high.max(ratio)]),
            frame_ms: measured_ms,
            gpu_ms: runner.timestamps.then(|| mean_of_medians(&runner.gpu_times)),
            counters: measured::counters(&counted),
            error: checked.error.unwrap_or(ErrorReport::NONE),
            on_front: false,
        });
    }
    Ok(points)
}

/// The mean over the frames of each frame's median over the rounds: a disturbance in one round does not show, and a frame that needs
/// less than its neighbours counts as one.
fn mean_of_medians(rounds: &[Vec<f64>]) -> f64 {
    let frames = rounds.iter().map(Vec::len).min().unwrap_or(0);
    let median = |frame: usize| {
        let mut times: Vec<f64> = rounds.iter().map(|round| round[frame]).collect();
        times.sort_by(f64::total_cmp);
        (times[(times.len() - 1) / 2] + times[times.len() / 2]) / 2.0
    };
    (0..frames).map(median).sum::<f64>() / frames.max(1) as f64
}

/// One list of all groups: the setting itself once, with its median time, and the others' times as if measured beside that.
fn gather(groups: Vec<Vec<Point>>) -> Vec<Point> {
    let mut base_ms: Vec<f64> = groups.iter().filter_map(|group| group.first()).map(|base| base.measured_ms).collect();
    base_ms.sort_by(f64::total_cmp);
    let Some(&middle) = base_ms.get(base_ms.len() / 2) else { return Vec::new() };
    let base = groups.iter().filter_map(|group| group.first()).find(|base| base.measured_ms == middle).cloned();
    let others = groups.into_iter().flat_map(|group| group.into_iter().skip(1));
    let mut points: Vec<Point> = base.into_iter().chain(others).collect();
    points.iter_mut().for_each(|point| point.frame_ms = point.time_ratio * middle);
    points
}

fn mark_front(points: &mut [Point]) {
    let values: Vec<_> = points.iter().map(|point| (point.frame_ms, point.error.psnr_db.unwrap_or(f64::INFINITY))).collect();
    front(&values).into_iter().for_each(|at| points[at].on_front = true);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(knob: &str, measured_ms: f64, time_ratio: f64, psnr_db: f64) -> Point {
        Point {
            knob: knob.to_owned(),
            value: String::new(),
            measured_ms,
            time_ratio,
            time_ratio_range: [time_ratio; 2],
            frame_ms: measured_ms,
            gpu_ms: None,
            counters: Default::default(),
            error: ErrorReport { psnr_db: Some(psnr_db), ..ErrorReport::NONE },
            on_front: false,
        }
    }

    #[test]
    fn one_disturbed_round_does_not_show_and_quick_frames_count() {
        let rounds = [vec![10.0, 2.0], vec![99.0, 2.0], vec![10.0, 77.0]];
        assert_eq!(mean_of_medians(&rounds), 6.0);
        assert_eq!(mean_of_medians(&[vec![1.0], vec![3.0]]), 2.0);
        assert_eq!(mean_of_medians(&[]), 0.0);
    }

    #[test]
    fn groups_measured_at_different_speeds_are_compared_by_their_ratios() {
        // The machine was half as fast during the second group.
        let first = vec![point(BASE, 10.0, 1.0, 50.0), point("color", 8.0, 0.8, 48.0)];
        let second = vec![point(BASE, 20.0, 1.0, 50.0), point("keys", 18.0, 0.9, 49.0), point("rows", 22.0, 1.1, 49.5)];
        let third = vec![point(BASE, 10.5, 1.0, 50.0)];
        let mut points = gather(vec![first, second, third]);
        mark_front(&mut points);
        let found: Vec<_> =
            points.iter().map(|point| (point.knob.as_str(), (point.frame_ms * 1e6).round() / 1e6, point.on_front)).collect();
        assert_eq!(found, [(BASE, 10.5, true), ("color", 8.4, true), ("keys", 9.45, true), ("rows", 11.55, false)]);
    }
}
