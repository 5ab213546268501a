//! Measures one case: a device and a task go in, the case's report comes out.

use super::{
    backend::{BenchDevice, DeviceMemory, Result},
    case::BenchCase,
    check::{self, CheckResult, ReferenceImages},
    flicker::{self, FlickerTruth},
    report::{CaseReport, FlickerReport, StageReport, TimingSummary},
    run::{self, CaseRenderer, Progress, Samples},
    scene,
    task::BenchTask,
};
use crate::{
    bytes::{self, ResolveCounts, StageWork, WorkCounts},
    setting::RenderSetting,
};
use effigy_core::{
    avatar::Avatar,
    frame::{Counters, FrameReport, passes::Stage, report::stage_ms},
    layout::TILING,
};
use effigy_runtime::trace::Trace;
use std::collections::BTreeMap;

/// Measures a case. The frames that are timed are added to `trace`.
///
/// # Errors
/// When the device fails.
pub fn measure_case(
    gpu: &BenchDevice,
    task: &BenchTask,
    setting: &RenderSetting,
    case: BenchCase,
    trace: Option<&mut Trace>,
    progress: Progress,
) -> Result<CaseReport> {
    let setting = &setting.for_case(case);
    let scenes = scene::scenes(case, &task.scene_inputs(setting));
    let avatar = setting.reduce(task.avatar);
    let mut renderer = CaseRenderer::new(gpu, &avatar, setting, case, false)?;
    let samples = run::time(&mut renderer, &scenes, task.warm_up, |done| {
        progress(&format!("{case}: timing"), done, scenes.len())
    })?;
    if let Some(trace) = trace {
        for report in &samples.reports {
            trace.add_frame(report);
        }
    }
    let memory = gpu.memory();
    let mut told =
        |what: &str, done: usize, all: usize| progress(&format!("{case}: {what}"), done, all);
    let (checked, flicker) = if case.has_flicker() && task.checked > 0 {
        let filter = setting.options.filter;
        let mut truth = FlickerTruth::new(case, task.avatar, filter, case == BenchCase::Flicker);
        let measured =
            flicker::measure_flicker(&mut renderer, &scenes, &mut truth, task.flip, &mut told)?;
        (measured.checked, Some(measured.report))
    } else {
        let indices = scene::checks(case, scenes.len(), task.checked);
        let mut images = ReferenceImages::new(task.avatar);
        let checked = check::check(
            &mut renderer,
            case,
            &scenes,
            &indices,
            &mut images,
            task.flip,
            &mut told,
        )?;
        (checked, None)
    };
    // Counting takes time, so it is done by a renderer of its own.
    drop(renderer);
    let mut counting_renderer = CaseRenderer::new(gpu, &avatar, setting, case, true)?;
    let counted = run::count(&mut counting_renderer, &scenes, |done| {
        progress(&format!("{case}: counting"), done, scenes.len())
    })?;
    let measured = MeasuredCase {
        case,
        avatar: &avatar,
        setting,
        samples,
        counters: counters(&counted),
        checked,
        flicker,
        memory,
        is_timed: gpu.is_timed(),
        tile_head_bytes: TILING.head_bytes(),
    };
    Ok(measured.report())
}

/// Everything that is known of a case once it is measured.
struct MeasuredCase<'a> {
    case: BenchCase,
    avatar: &'a Avatar,
    setting: &'a RenderSetting,
    samples: Samples,
    counters: BTreeMap<String, f64>,
    checked: CheckResult,
    flicker: Option<FlickerReport>,
    memory: DeviceMemory,
    /// Whether the device has timestamps.
    is_timed: bool,
    /// Bytes of the heads of all tiles' lists.
    tile_head_bytes: u64,
}

impl MeasuredCase<'_> {
    fn report(self) -> CaseReport {
        let Samples { intervals, reports } = &self.samples;
        let stages = stages(reports, &self.work());
        let mean = |count: fn(&StageReport) -> Option<u64>| {
            let of_stage =
                |stage: &StageReport| stage.ran * count(stage).unwrap_or_default() as f64;
            stages.iter().map(of_stage).sum::<f64>().round() as u64
        };
        let frame_ms = TimingSummary::from_samples(intervals.clone()).unwrap_or_default();
        let fps = if frame_ms.mean > 0.0 {
            1e3 / frame_ms.mean
        } else {
            0.0
        };
        let gpu_ms = if self.is_timed {
            TimingSummary::from_samples(reports.iter().map(gpu_ms).collect())
        } else {
            None
        };
        CaseReport {
            name: self.case.to_string(),
            frames: intervals.len(),
            frame_ms,
            fps,
            gpu_ms,
            bytes: Some(mean(|stage| stage.bytes)),
            bytes_floor: Some(mean(|stage| stage.bytes_floor)),
            covered_pixels: self.covered_pixels(),
            fragments_a_pixel: self.fragments_a_pixel(),
            stages,
            counters: self.counters,
            gpu_memory_bytes: Some(self.memory.allocated),
            gpu_memory_used_bytes: Some(self.memory.used),
            error: self.checked.error,
            flicker: self.flicker,
        }
    }

    fn covered_pixels(&self) -> Option<f64> {
        let counted = self.counters.get("covered").copied();
        counted.or(self.checked.covered)
    }

    fn fragments_a_pixel(&self) -> Option<f64> {
        let fragments = self.counters.get("fragments")?;
        let covered = self.covered_pixels().filter(|&covered| covered > 0.0)?;
        Some(fragments / covered)
    }

    /// A counter's mean over the frames.
    fn counter(&self, name: &str) -> Option<f64> {
        self.counters.get(name).copied()
    }

    /// The counts that the work depends on, of all avatars together.
    fn work_counts(&self) -> WorkCounts {
        let reports = &self.samples.reports;
        let count = |name: &str| self.counter(name).map(|count| count.round() as u64);
        let covered = self.checked.covered.map(|covered| covered.round() as u64);
        WorkCounts {
            gaussians: count("gaussians").unwrap_or_default(),
            drawn: count("drawn").unwrap_or_default(),
            networks: mean_of(reports, |counters| counters.networks),
            pose_cached: count("cached") > Some(0),
            tile_head_bytes: self.tile_head_bytes,
            covered: count("covered").or(covered),
            damaged: count("damaged").filter(|&damaged| damaged > 0),
            rastered: mean_of(reports, rastered),
            resolve: mean_of(reports, |counters| counters.resolved).map(|resolved| ResolveCounts {
                averaged: mean_of(reports, |counters| counters.averaged).unwrap_or_default(),
                resolved,
            }),
            fragments: count("fragments"),
        }
    }

    /// The work of a frame: of stages that run for each avatar, that of all in view.
    fn work(&self) -> Vec<StageWork> {
        let count = |name: &str| self.counter(name).unwrap_or_default();
        let avatars = count("avatars");
        let in_view = (avatars - count("avatars_culled")).max(0.0);
        let mut all = self.work_counts();
        if avatars > 0.0 {
            let gaussians = count("gaussians") * in_view / avatars - count("skipped_by_detail");
            all.gaussians = gaussians.max(0.0).round() as u64;
        }
        let per_avatar = |count: u64| {
            if in_view > 0.0 {
                (count as f64 / in_view).round() as u64
            } else {
                0
            }
        };
        let one = WorkCounts {
            gaussians: per_avatar(all.gaussians),
            drawn: per_avatar(all.drawn),
            networks: all.networks.map(per_avatar),
            ..all
        };
        let options = &self.setting.options;
        let mut work = bytes::work_per_stage(self.avatar, options, all);
        let work_of_one = bytes::work_per_stage(self.avatar, options, one);
        for (stage, stage_of_one) in work.iter_mut().zip(work_of_one) {
            if stage.stage.is_per_avatar() {
                *stage = stage_of_one.times(in_view);
            }
        }
        work
    }
}

/// GPU time of a frame, ms. Adding 0 turns the −0 that a sum over no stages gives into 0.
pub fn gpu_ms(report: &FrameReport) -> f64 {
    report.gpu_ms() + 0.0
}

/// Each counter's mean over the frames. A counter that a frame lacks is missing.
pub fn counters(reports: &[FrameReport]) -> BTreeMap<String, f64> {
    #[derive(Default)]
    struct Sum {
        frames: usize,
        count: u64,
    }
    let mut sums: BTreeMap<String, Sum> = BTreeMap::new();
    for (name, count) in reports.iter().flat_map(|report| report.counters.named()) {
        let sum = sums.entry(name.to_owned()).or_default();
        sum.frames += 1;
        sum.count += count;
    }
    sums.retain(|_, sum| sum.frames == reports.len());
    sums.into_iter()
        .map(|(name, sum)| (name, sum.count as f64 / sum.frames as f64))
        .collect()
}

/// A count's mean over the frames in which it is not 0. None if it is in all.
fn mean_of(reports: &[FrameReport], count: impl Fn(&Counters) -> u64) -> Option<u64> {
    let counts = reports.iter().map(|report| count(&report.counters));
    let counts: Vec<u64> = counts.filter(|&count| count > 0).collect();
    (!counts.is_empty()).then(|| counts.iter().sum::<u64>() / counts.len() as u64)
}

/// Pixels that a frame blended splats into: the atlas, and the image if it has avatars of its own.
fn rastered(counters: &Counters) -> u64 {
    let in_view = counters.avatars - counters.avatars_culled;
    if counters.supersampled > 0 && counters.supersampled == in_view {
        counters.atlas
    } else {
        counters.atlas + counters.damaged
    }
}

/// The stages that ran in some frame or have work, in the order of a frame.
fn stages(reports: &[FrameReport], work: &[StageWork]) -> Vec<StageReport> {
    Stage::ALL
        .into_iter()
        .filter_map(|stage| stage_report(stage, reports, work))
        .collect()
}

fn stage_report(stage: Stage, reports: &[FrameReport], work: &[StageWork]) -> Option<StageReport> {
    let name = stage.name();
    let times: Vec<f64> = reports
        .iter()
        .filter_map(|report| stage_ms(&report.stages, name))
        .collect();
    let work = work.iter().find(|work| work.stage == stage).copied();
    if work.is_none() && times.is_empty() {
        return None;
    }
    let work = work.unwrap_or(StageWork::none(stage));
    let ran =
        |report: &&FrameReport| report.counters.submitted > 0 && !report.skipped.contains(&name);
    let ran = reports.iter().filter(ran).count();
    Some(StageReport {
        name: name.to_owned(),
        ms: TimingSummary::from_samples(times),
        ran: ran as f64 / reports.len().max(1) as f64,
        bytes: Some(work.bytes),
        bytes_floor: Some(work.bytes_floor),
        operations: work.operations,
        operations_floor: work.operations_floor,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use effigy_core::frame::Counters;

    fn frame(drawn: u64, fragments: Option<u64>, skipped: &[&'static str]) -> FrameReport {
        let ran = ["project", "raster"]
            .into_iter()
            .filter(|stage| !skipped.contains(stage));
        FrameReport {
            stages: ran.map(|stage| (stage, drawn as f64)).collect(),
            counters: Counters {
                drawn,
                fragments,
                submitted: 1,
                ..Counters::default()
            },
            skipped: skipped.to_vec(),
            ..FrameReport::default()
        }
    }

    #[test]
    fn counters_are_means_and_unknown_ones_are_missing() {
        let means = counters(&[frame(10, Some(5), &[]), frame(20, None, &[])]);
        assert_eq!(means["drawn"], 15.0);
        assert!(!means.contains_key("fragments"));
        assert_eq!(
            counters(&[frame(1, Some(4), &[]), frame(1, Some(8), &[])])["fragments"],
            6.0
        );
    }

    #[test]
    fn stage_times_count_only_the_frames_in_which_it_ran() {
        let work = [Stage::Project, Stage::Raster].map(StageWork::none);
        let stages = stages(
            &[
                frame(1, None, &[]),
                frame(3, None, &["project"]),
                frame(5, None, &["project"]),
                frame(7, None, &[]),
            ],
            &work,
        );
        assert_eq!(
            stages
                .iter()
                .map(|stage| (stage.name.as_str(), stage.ran))
                .collect::<Vec<_>>(),
            [("project", 0.5), ("raster", 1.0)]
        );
        assert_eq!(stages[0].ms.map(|ms| ms.mean), Some(4.0));
        assert_eq!(stages[1].ms.map(|ms| ms.mean), Some(4.0));
    }
}
