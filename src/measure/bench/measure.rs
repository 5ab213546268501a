//! Measures one case: a device and a task go in, the case's report comes out.

use super::{
    case::{BenchCase, BenchScene, BenchTask, checks, scenes},
    flicker::{FlickerTruth, measure_flicker},
    frames::{BenchDevice, BenchRenderer, Checked, Progress, Result},
    report::{CaseReport, FlickerReport, StageReport, TimingSummary},
};
use crate::{
    bytes::{self, ResolveCounts, StageWork, WorkCounts},
    setting::RenderSetting,
};
use effigy_core::{
    avatar::Avatar,
    frame::{Counters, FrameReport, RendererOptions, passes::Stage, report::stage_ms},
    layout::TILING,
    reference,
    scene::{AvatarBounds, FrameImage, Supersampling},
};
use effigy_runtime::trace::TraceRecorder;
use std::collections::{BTreeMap, HashMap};

/// Measures a case. The frames that are timed are added to `trace`.
///
/// # Errors
/// When the device fails.
pub fn measure_case(
    gpu: &BenchDevice,
    task: &BenchTask,
    setting: &RenderSetting,
    case: BenchCase,
    trace: Option<&mut TraceRecorder>,
    progress: Progress,
) -> Result<CaseReport> {
    let setting = &setting.for_case(case);
    let scenes = scenes(case, task, setting, false);
    let mut told =
        |what: &str, done: usize, all: usize| progress(&format!("{case}: {what}"), done, all);
    let mut renderer = BenchRenderer::of_case(gpu, task, setting, case, false)?;
    let (intervals, reports) = renderer.time(&scenes, |done| told("timing", done, scenes.len()))?;
    if let Some(trace) = trace {
        for report in &reports {
            trace.add_frame(report);
        }
    }
    let (memory_used, memory_allocated) = gpu.memory();
    let mut truth = CaseReference::new(case, task, setting, case == BenchCase::Flicker);
    let (checked, flicker) = truth.compare(&mut renderer, &scenes, &mut told)?;
    drop(renderer);
    let counters = count(gpu, task, setting, case, &scenes, &mut told)?;
    let counts = Counts {
        named: &counters,
        reports: &reports,
        checked: &checked,
    };
    let work = counts.work(&setting.reduce(task.avatar), &setting.options);
    let stages = stages(&reports, &work);
    let mean = |count: fn(&StageReport) -> Option<u64>| {
        let of_stage = |stage: &StageReport| stage.ran * count(stage).unwrap_or_default() as f64;
        Some(stages.iter().map(of_stage).sum::<f64>().round() as u64)
    };
    let covered_pixels = counters.get("covered").copied().or(checked.covered());
    let fragments = counters.get("fragments");
    let fragments_a_pixel = fragments.zip(covered_pixels.filter(|&covered| covered > 0.0));
    let frame_ms = TimingSummary::from_samples(intervals).unwrap_or_default();
    let gpu_times = gpu.is_timed().then(|| reports.iter().map(gpu_ms).collect());
    Ok(CaseReport {
        name: case.to_string(),
        frames: reports.len(),
        frame_ms,
        fps: if frame_ms.mean > 0.0 {
            1e3 / frame_ms.mean
        } else {
            0.0
        },
        gpu_ms: gpu_times.and_then(TimingSummary::from_samples),
        bytes: mean(|stage| stage.bytes),
        bytes_floor: mean(|stage| stage.bytes_floor),
        covered_pixels,
        fragments_a_pixel: fragments_a_pixel.map(|(fragments, covered)| fragments / covered),
        stages,
        counters,
        gpu_memory_bytes: Some(memory_allocated),
        gpu_memory_used_bytes: Some(memory_used),
        error: checked.error,
        flicker,
    })
}

/// What the reference says of a case's scenes, each thing computed once for all settings.
pub struct CaseReference<'a> {
    case: BenchCase,
    task: &'a BenchTask<'a>,
    bounds: AvatarBounds,
    /// By scene, and by how what is small is drawn.
    images: HashMap<(usize, Supersampling), FrameImage>,
    flicker: FlickerTruth<'a>,
}

impl<'a> CaseReference<'a> {
    /// Of a task's avatar with all its rows. `per_pixel`: see [`FlickerTruth::new`].
    pub fn new(
        case: BenchCase,
        task: &'a BenchTask,
        setting: &RenderSetting,
        per_pixel: bool,
    ) -> Self {
        let filter = setting.options.filter;
        Self {
            case,
            task,
            bounds: AvatarBounds::new(task.avatar),
            images: HashMap::new(),
            flicker: FlickerTruth::new(case, task.avatar, filter, per_pixel),
        }
    }

    /// Draws as many of a case's scenes again as the task says, and compares each; where the case
    /// says so, measures what flickers in all.
    ///
    /// # Errors
    /// When the device fails.
    pub fn compare(
        &mut self,
        renderer: &mut BenchRenderer,
        scenes: &[BenchScene],
        progress: Progress,
    ) -> Result<(Checked, Option<FlickerReport>)> {
        if self.case.has_flicker() && self.task.checked > 0 {
            let truth = &mut self.flicker;
            let (checked, flicker) =
                measure_flicker(renderer, scenes, truth, self.task.flip, progress)?;
            return Ok((checked, Some(flicker)));
        }
        let mut checked = Checked::default();
        let options = *renderer.options();
        let indices = checks(self.case, scenes.len(), self.task.checked);
        for (done, &index) in indices.iter().enumerate() {
            progress("comparing with the reference", done, indices.len());
            let index = self.last_in_view(scenes, index);
            // The frame before is drawn too: what a frame reuses from it is part of the comparison.
            renderer.draw(&scenes[(index + scenes.len() - 1) % scenes.len()])?;
            renderer.draw(&scenes[index])?;
            let image = renderer.image()?;
            let flip = self.task.flip;
            checked.add(&image, self.image(index, &scenes[index], &options), flip);
        }
        Ok((checked, None))
    }

    /// The frame, or the last before it that may show an avatar: to compare empty images says
    /// nothing. The frame itself where none does.
    fn last_in_view(&self, scenes: &[BenchScene], frame: usize) -> usize {
        let count = scenes.len();
        let is_shown = |&at: &usize| {
            let scene = &scenes[at];
            let mut joints = scene.instances.iter().map(|own| &own.reference.joints);
            joints.any(|joints| !self.bounds.is_outside(joints, &scene.camera))
        };
        let mut backwards = (0..count).map(|back| (frame + count - back) % count);
        backwards.find(is_shown).unwrap_or(frame)
    }

    /// The image of a scene, with the clip's pose even while another is held: what the area of each
    /// pixel shows where the case says so ([`BenchCase::truth_factor`]), else what a renderer with
    /// these options should draw.
    fn image(
        &mut self,
        index: usize,
        scene: &BenchScene,
        options: &RendererOptions,
    ) -> &FrameImage {
        let factor = self.case.truth_factor();
        let supersampling = if factor > 1 {
            Supersampling::OFF
        } else {
            options.supersampling
        };
        let key = (index, supersampling);
        self.images.entry(key).or_insert_with(|| {
            let poses: Vec<_> = scene.instances.iter().map(|own| &own.reference).collect();
            let (avatar, camera) = (self.task.avatar, &scene.camera);
            if factor > 1 {
                reference::render_supersampled(avatar, &poses, camera, factor, avatar.filter)
            } else {
                let people = reference::people(avatar, &poses);
                reference::render_shown(&people, camera, supersampling, options.filter)
            }
        })
    }
}

/// Each counter's mean over a case's frames. Counting takes time, so a renderer of its own does it.
///
/// # Errors
/// When the device fails.
pub fn count(
    gpu: &BenchDevice,
    task: &BenchTask,
    setting: &RenderSetting,
    case: BenchCase,
    scenes: &[BenchScene],
    progress: Progress,
) -> Result<BTreeMap<String, f64>> {
    let mut renderer = BenchRenderer::of_case(gpu, task, setting, case, true)?;
    let counted = renderer.count(scenes, |done| progress("counting", done, scenes.len()))?;
    Ok(means(&counted))
}

/// Each counter's mean over the frames. A counter that a frame lacks is missing.
fn means(reports: &[FrameReport]) -> BTreeMap<String, f64> {
    let mut counts: BTreeMap<&str, Vec<u64>> = BTreeMap::new();
    for (name, count) in reports.iter().flat_map(|report| report.counters.named()) {
        counts.entry(name).or_default().push(count);
    }
    counts.retain(|_, counts| counts.len() == reports.len());
    let mean = |counts: &[u64]| counts.iter().sum::<u64>() as f64 / counts.len() as f64;
    let named = counts.iter();
    named
        .map(|(name, counts)| ((*name).to_owned(), mean(counts)))
        .collect()
}

/// GPU time of a frame, ms. Adding 0 turns the −0 that a sum over no stages gives into 0.
pub fn gpu_ms(report: &FrameReport) -> f64 {
    report.gpu_ms() + 0.0
}

/// The counts of a case that its work depends on.
struct Counts<'a> {
    /// Means over the frames, by name.
    named: &'a BTreeMap<String, f64>,
    reports: &'a [FrameReport],
    checked: &'a Checked,
}

impl Counts<'_> {
    /// A count's mean over the frames in which it is not 0. None if it is in all.
    fn mean_of(&self, count: impl Fn(&Counters) -> u64) -> Option<u64> {
        let counts = self.reports.iter().map(|report| count(&report.counters));
        let counts: Vec<u64> = counts.filter(|&count| count > 0).collect();
        (!counts.is_empty()).then(|| counts.iter().sum::<u64>() / counts.len() as u64)
    }

    /// Those of all avatars together.
    fn of_all(&self) -> WorkCounts {
        let count = |name: &str| self.named.get(name).map(|count| count.round() as u64);
        let covered = self.checked.covered().map(|covered| covered.round() as u64);
        let resolved = self.mean_of(|counters| counters.resolved);
        WorkCounts {
            gaussians: count("gaussians").unwrap_or_default(),
            drawn: count("drawn").unwrap_or_default(),
            networks: self.mean_of(|counters| counters.networks),
            pose_cached: count("cached") > Some(0),
            tile_head_bytes: TILING.head_bytes(),
            covered: count("covered").or(covered),
            damaged: count("damaged").filter(|&damaged| damaged > 0),
            rastered: self.mean_of(rastered),
            resolve: resolved.map(|resolved| ResolveCounts {
                averaged: self
                    .mean_of(|counters| counters.averaged)
                    .unwrap_or_default(),
                resolved,
            }),
            fragments: count("fragments"),
        }
    }

    /// The work of a frame: of stages that run for each avatar, that of all in view.
    fn work(&self, avatar: &Avatar, options: &RendererOptions) -> Vec<StageWork> {
        let count = |name: &str| self.named.get(name).copied().unwrap_or_default();
        let avatars = count("avatars");
        let in_view = (avatars - count("avatars_culled")).max(0.0);
        let mut all = self.of_all();
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
        let mut work = bytes::work_per_stage(avatar, options, all);
        let work_of_one = bytes::work_per_stage(avatar, options, one);
        for (stage, stage_of_one) in work.iter_mut().zip(work_of_one) {
            if stage.stage.is_per_avatar() {
                *stage = stage_of_one.times(in_view);
            }
        }
        work
    }
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
    let of_stage = |stage: Stage| {
        let name = stage.name();
        let times = reports
            .iter()
            .filter_map(|report| stage_ms(&report.stages, name));
        let ms = TimingSummary::from_samples(times.collect());
        let work = work.iter().find(|work| work.stage == stage).copied();
        if work.is_none() && ms.is_none() {
            return None;
        }
        let work = work.unwrap_or(StageWork::none(stage));
        let ran = |report: &&FrameReport| {
            report.counters.submitted > 0 && !report.skipped.contains(&name)
        };
        Some(StageReport {
            name: name.to_owned(),
            ms,
            ran: reports.iter().filter(ran).count() as f64 / reports.len().max(1) as f64,
            bytes: Some(work.bytes),
            bytes_floor: Some(work.bytes_floor),
            operations: work.operations,
            operations_floor: work.operations_floor,
        })
    };
    Stage::ALL.into_iter().filter_map(of_stage).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

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
        let some = means(&[frame(10, Some(5), &[]), frame(20, None, &[])]);
        assert_eq!((some["drawn"], some.get("fragments")), (15.0, None));
        let all = means(&[frame(1, Some(4), &[]), frame(1, Some(8), &[])]);
        assert_eq!(all["fragments"], 6.0);
    }

    #[test]
    fn stage_times_count_only_the_frames_in_which_it_ran() {
        let work = [Stage::Project, Stage::Raster].map(StageWork::none);
        let frames = [
            frame(1, None, &[]),
            frame(3, None, &["project"]),
            frame(5, None, &["project"]),
            frame(7, None, &[]),
        ];
        let stages: Vec<_> = stages(&frames, &work)
            .into_iter()
            .map(|stage| (stage.name, stage.ran, stage.ms.map(|ms| ms.mean)))
            .collect();
        let expected = [("project", 0.5), ("raster", 1.0)];
        assert_eq!(
            stages,
            expected.map(|(name, ran)| (name.to_owned(), ran, Some(4.0)))
        );
    }
}
