//! One case from the scenes to the report.

use super::{
    Case, Setting, Task,
    backend::{Opened, Result},
    check::{self, Checked, Oracle},
    report::{CaseReport, Spread, StageReport},
    run::{self, Drawer, Progress, Samples},
    scene,
};
use crate::{
    avatar::Avatar,
    frame::{FrameReport, report::STAGES},
    measure::{
        bytes::{self, Seen, Work},
        trace::Trace,
    },
};
use std::collections::BTreeMap;

/// Measures a case. `trace` takes in the frames that are timed.
pub fn case(
    gpu: &Opened,
    task: &Task,
    (setting, case): (&Setting, Case),
    trace: Option<&mut Trace>,
    progress: Progress,
) -> Result<CaseReport> {
    let setting = &setting.of(case);
    let scenes = scene::scenes(case, &task.set(setting));
    let avatar = setting.fit(task.avatar);
    let mut drawer = Drawer::new(gpu, &avatar, setting, case, false)?;
    let samples = run::time(&mut drawer, &scenes, task.warm_up, |done| progress(&format!("{case}: timing"), done, scenes.len()))?;
    trace.into_iter().for_each(|trace| samples.reports.iter().for_each(|report| trace.frame(report)));
    let (used, reserved) = gpu.memory();
    let cost = Cost { used, reserved, timed: gpu.is_timed(), surface: drawer.surface(), heads: gpu.tiling().bytes(0)[0] };
    let numbers = scene::checks(case, scenes.len(), task.checked);
    let mut oracle = Oracle::new(task.avatar);
    let mut show = |what: &str, done, all| progress(&format!("{case}: {what}"), done, all);
    let checked = check::check(&mut drawer, &scenes, &numbers, &mut oracle, task.flip, &mut show)?;
    // Counting takes time, so it has a turn of its own.
    drop(drawer);
    let mut drawer = Drawer::new(gpu, &avatar, setting, case, true)?;
    let counted = run::count(&mut drawer, &scenes, |done| progress(&format!("{case}: counting"), done, scenes.len()))?;
    Ok(report(case, (&avatar, setting), samples, (counters(&counted), checked), cost))
}

/// What the device says besides the frames.
struct Cost {
    /// Bytes of its memory in use, and in blocks that the program took.
    used: u64,
    reserved: u64,
    /// Whether it has timestamps.
    timed: bool,
    /// Corners and triangles of the depth surface.
    surface: [u64; 2],
    /// Bytes of the bins' heads.
    heads: u64,
}

fn report(
    case: Case,
    (avatar, setting): (&Avatar, &Setting),
    samples: Samples,
    (counters, checked): (BTreeMap<String, f64>, Checked),
    Cost { used, reserved, timed, surface, heads }: Cost,
) -> CaseReport {
    let Samples { intervals, reports } = samples;
    let seen = Seen { surface, heads, networks: networks(&reports), ..seen(&counters, checked.covered) };
    let work = work(avatar, setting, &counters, seen);
    let stages = stages(&reports, &work);
    let part = |stage: &StageReport, of: fn(&StageReport) -> Option<u64>| stage.ran * of(stage).unwrap_or_default() as f64;
    let mean = |of| Some(stages.iter().map(|stage| part(stage, of)).sum::<f64>().round() as u64);
    let frames = intervals.len();
    let none = Spread { mean: 0.0, median: 0.0, p5: 0.0, p95: 0.0, p99: 0.0 };
    let frame_ms = Spread::of(intervals).unwrap_or(none);
    let covered = counters.get("covered").copied().or(checked.covered);
    CaseReport {
        name: case.to_string(),
        frames,
        frame_ms,
        fps: if frame_ms.mean > 0.0 { 1e3 / frame_ms.mean } else { 0.0 },
        gpu_ms: Spread::of(reports.iter().map(gpu_ms).collect()).filter(|_| timed),
        bytes: mean(|stage| stage.bytes),
        bytes_floor: mean(|stage| stage.bytes_floor),
        covered_pixels: covered,
        fragments_a_pixel: counters.get("fragments").zip(covered).filter(|(_, covered)| *covered > 0.0).map(|(&f, covered)| f / covered),
        stages,
        counters,
        gpu_memory_bytes: Some(reserved),
        gpu_memory_used_bytes: Some(used),
        error: checked.error,
    }
}

/// GPU time of a frame, ms. The sum over no stages is −0, which reads badly.
pub fn gpu_ms(report: &FrameReport) -> f64 {
    report.gpu_ms() + 0.0
}

/// Each count's mean over the frames. A count that some frame lacks is left out.
pub fn counters(reports: &[FrameReport]) -> BTreeMap<String, f64> {
    let mut sums: BTreeMap<String, (usize, u64)> = BTreeMap::new();
    for (name, count) in reports.iter().flat_map(|report| report.counters.named()) {
        let sum = sums.entry(name.to_owned()).or_default();
        *sum = (sum.0 + 1, sum.1 + count);
    }
    let all = sums.into_iter().filter(|(_, (frames, _))| *frames == reports.len());
    all.map(|(name, (frames, sum))| (name, sum as f64 / frames as f64)).collect()
}

/// The work of a frame: what each avatar in view costs, and what all cost together.
fn work(avatar: &Avatar, setting: &Setting, counters: &BTreeMap<String, f64>, seen: Seen) -> Vec<Work> {
    let count = |name: &str| counters.get(name).copied().unwrap_or_default();
    let (all, culled) = (count("avatars"), count("avatars_culled"));
    let in_view = (all - culled).max(0.0);
    let mut together = seen;
    if all > 0.0 {
        together.gaussians = (count("gaussians") * in_view / all - count("thinned")).max(0.0).round() as u64;
    }
    let share = |of: u64| if in_view > 0.0 { (of as f64 / in_view).round() as u64 } else { 0 };
    let networks = together.networks.map(share);
    let each = Seen { gaussians: share(together.gaussians), drawn: share(together.drawn), networks, ..together };
    let times = |of: u64| (of as f64 * in_view).round() as u64;
    let scaled = |work: &Work| Work {
        bytes: times(work.bytes),
        bytes_floor: times(work.bytes_floor),
        operations: work.operations.map(times),
        operations_floor: work.operations_floor.map(times),
        ..*work
    };
    let [each, mut together] = [each, together].map(|seen| bytes::per_stage(avatar, &setting.options, seen));
    for (one, all) in each.iter().zip(&mut together).filter(|(one, _)| !matches!(one.stage, "sort" | "bins" | "raster")) {
        *all = scaled(one);
    }
    together
}

/// What the counted work depends on.
fn seen(counters: &BTreeMap<String, f64>, covered: Option<f64>) -> Seen {
    let count = |name: &str| counters.get(name).map(|count| count.round() as u64);
    Seen {
        gaussians: count("gaussians").unwrap_or_default(),
        drawn: count("drawn").unwrap_or_default(),
        kept: count("kept") > Some(0),
        covered: count("covered").or(covered.map(|covered| covered.round() as u64)),
        area: count("area").filter(|&area| area > 0),
        fragments: count("fragments"),
        ..Seen::default()
    }
}

/// The mean number of networks, of frames in which some ran.
fn networks(reports: &[FrameReport]) -> Option<u64> {
    let ran: Vec<u64> = reports.iter().map(|report| report.counters.networks).filter(|&networks| networks > 0).collect();
    (!ran.is_empty()).then(|| ran.iter().sum::<u64>() / ran.len() as u64)
}

/// The stages that ran in some frame or have work counted, in the order of a frame.
fn stages(reports: &[FrameReport], work: &[Work]) -> Vec<StageReport> {
    let stage = |&name: &&'static str| {
        let times: Vec<f64> =
            reports.iter().flat_map(|report| &report.stages).filter(|stage| stage.0 == name).map(|stage| stage.1).collect();
        let ran = reports.iter().filter(|report| report.counters.submitted > 0 && !report.skipped.contains(&name)).count();
        let counted = work.iter().find(|work| work.stage == name).copied();
        let nothing = Work { stage: name, bytes: 0, bytes_floor: 0, operations: None, operations_floor: None };
        let work = counted.or((!times.is_empty()).then_some(nothing))?;
        Some(StageReport {
            name: name.to_owned(),
            ms: Spread::of(times),
            ran: ran as f64 / reports.len().max(1) as f64,
            bytes: Some(work.bytes),
            bytes_floor: Some(work.bytes_floor),
            operations: work.operations,
            operations_floor: work.operations_floor,
        })
    };
    STAGES.iter().filter_map(stage).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frame::Counters;

    fn frame(drawn: u64, fragments: Option<u64>, skipped: &[&'static str]) -> FrameReport {
        let ran = ["splats", "raster"].into_iter().filter(|stage| !skipped.contains(stage));
        FrameReport {
            stages: ran.map(|stage| (stage, drawn as f64)).collect(),
            counters: Counters { drawn, fragments, submitted: 1, ..Counters::default() },
            skipped: skipped.to_vec(),
            ..FrameReport::default()
        }
    }

    #[test]
    fn counters_are_means_and_unknown_ones_are_left_out() {
        let means = counters(&[frame(10, Some(5), &[]), frame(20, None, &[])]);
        assert_eq!(means["drawn"], 15.0);
        assert!(!means.contains_key("fragments"));
        assert_eq!(counters(&[frame(1, Some(4), &[]), frame(1, Some(8), &[])])["fragments"], 6.0);
    }

    #[test]
    fn a_stage_says_in_how_many_frames_it_ran_and_how_long_it_took_in_those() {
        let work = ["splats", "raster"].map(|stage| Work { stage, bytes: 8, bytes_floor: 4, operations: None, operations_floor: None });
        let stages = stages(&[frame(1, None, &[]), frame(3, None, &["splats"]), frame(5, None, &["splats"]), frame(7, None, &[])], &work);
        assert_eq!(stages.iter().map(|stage| (stage.name.as_str(), stage.ran)).collect::<Vec<_>>(), [("splats", 0.5), ("raster", 1.0)]);
        assert_eq!(stages[0].ms.map(|ms| ms.mean), Some(4.0));
        assert_eq!(stages[1].ms.map(|ms| ms.mean), Some(4.0));
    }
}
