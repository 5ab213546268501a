//! Trials of candidates by real frames of an avatar: see [`tuning`](super::tuning).

use super::{
    device::{
        error::{Error, Result},
        gpu::Gpu,
        options::GpuOptions,
    },
    raster::resolved,
    renderer::Renderer,
    sort::choice,
    tuning::{
        Candidate, Choices, FramePair, Progress, Record, Tournament, TrialImage, Trials, Tuning,
        Workload,
    },
};
use effigy_core::{
    avatar::{Avatar, motion::Player},
    frame::RendererOptions,
    scene::{AvatarBounds, Camera, Posed},
};
use std::{f64::consts::TAU, sync::Arc, time::Instant};

/// Time of frames that a start spends on candidates while a window is drawn to, ms.
pub const START_BUDGET_MS: f64 = 300.0;

/// Field of view of the frames around an avatar, radians.
const FOV: f64 = 0.6;
/// Sides that an avatar is seen from.
const SIDES: usize = 7;

/// What one frame shows.
#[derive(Clone, Debug)]
pub struct TrialScene {
    /// The avatars, at most [`RendererOptions::instances`].
    pub poses: Vec<Posed>,
    /// The view, for images of the renderer's size.
    pub camera: Camera,
}

impl TrialScene {
    /// Moments of a clip: see [`Self::around`].
    pub fn of_clip(avatar: &Avatar, player: &Player, size: [u32; 2]) -> Vec<Self> {
        let duration = player.clip().duration();
        let poses: Vec<Posed> = (0..SIDES)
            .map(|side| {
                let seconds = duration * side as f64 / SIDES as f64;
                Posed::new(avatar, &player.pose(seconds))
            })
            .collect();
        Self::around(avatar, &poses, size)
    }

    /// Poses of an avatar in turn, the whole of it seen from another side in each frame: even of an
    /// avatar that has one pose no two frames are the same. `size`: of the image, px.
    pub fn around(avatar: &Avatar, poses: &[Posed], size: [u32; 2]) -> Vec<Self> {
        let bounds = AvatarBounds::new(avatar);
        let poses = poses.iter().cycle();
        (0..SIDES)
            .zip(poses)
            .map(|(side, posed)| {
                let framing = bounds.framing(&posed.joints);
                let yaw = TAU * side as f64 / SIDES as f64;
                Self {
                    poses: vec![posed.clone()],
                    camera: Camera::around(framing, yaw, 0.1, FOV, size),
                }
            })
            .collect()
    }
}

/// What to measure, on a device.
#[derive(Clone, Copy)]
pub struct TuningTask<'a> {
    /// The avatar to draw.
    pub avatar: &'a Avatar,
    /// How to draw it; what is None is measured.
    pub options: RendererOptions,
    /// The frames, at least three that differ.
    pub scenes: &'a [TrialScene],
    /// Time of frames after which it ends, ms.
    pub budget_ms: f64,
}

impl TuningTask<'_> {
    /// Times candidates for as long as the budget lasts, from where the record ends. Returns at
    /// once where all were tried.
    ///
    /// # Errors
    /// When nothing can be drawn, or a candidate brings the device down, which later starts do not
    /// try again.
    pub fn run(&self, gpu: &Arc<Gpu>, record: &Record, progress: Progress) -> Result<Tuning> {
        let mut trials = RendererTrials::new(gpu, *self);
        self.tournament(gpu, record)?.run(&mut trials, progress)
    }

    /// The tournament of [`Self::run`].
    ///
    /// # Errors
    /// When no sort is right on the device.
    pub fn tournament<'a>(&self, gpu: &Arc<Gpu>, record: &'a Record) -> Result<Tournament<'a>> {
        // The safest sort depends on the test: it would be another at the next start.
        if self.options.sort.is_none() {
            choice::choose(gpu)?;
        }
        let safest = Candidate::safest(gpu, &self.options)?;
        Ok(Tournament {
            workload: Workload::new(self.avatar, &self.options),
            safest,
            choices: Choices::new(gpu, &self.options, &safest)?,
            budget_ms: self.budget_ms,
            record,
        })
    }
}

/// Draws a task's scenes with candidates on a device.
pub struct RendererTrials<'a> {
    /// The device.
    pub gpu: &'a Arc<Gpu>,
    /// What to draw.
    pub task: TuningTask<'a>,
    /// Pairs that were drawn.
    pairs: usize,
}

impl<'a> RendererTrials<'a> {
    /// Draws a task's scenes on a device.
    pub fn new(gpu: &'a Arc<Gpu>, task: TuningTask<'a>) -> Self {
        Self {
            gpu,
            task,
            pairs: 0,
        }
    }

    fn draw(&self, renderer: &mut Renderer, number: usize) -> Result<()> {
        let scene = &self.task.scenes[number % self.task.scenes.len()];
        let poses: Vec<&Posed> = scene.poses.iter().collect();
        renderer.draw_scene(&poses, &scene.camera, None)
    }

    /// Draws a frame and waits for it. Returns how long it took, ms.
    fn time(&self, renderer: &mut Renderer, number: usize) -> Result<f64> {
        let began = Instant::now();
        self.draw(renderer, number)?;
        renderer.finish()?;
        Ok(if self.gpu.probe.timestamp_bits > 0 {
            renderer.report().gpu_ms()
        } else {
            began.elapsed().as_secs_f64() * 1e3
        })
    }
}

impl Trials for RendererTrials<'_> {
    type Renderer = Renderer;

    fn open(&mut self, candidate: &Candidate) -> Result<Renderer> {
        Renderer::new(
            self.gpu,
            self.task.avatar,
            candidate.apply(self.task.options),
        )
    }

    fn image(&mut self, renderer: &mut Renderer) -> Result<TrialImage> {
        let ms = self.time(renderer, 0)?;
        Ok(TrialImage {
            image: renderer.read_image()?,
            ms,
        })
    }

    fn pair(
        &mut self,
        best: &mut Renderer,
        candidate: &mut Renderer,
        number: usize,
    ) -> Result<FramePair> {
        // No scene follows itself, also where another candidate begins: a frame in which nothing
        // changes takes no time. The first is the image's.
        let scene = 1 + self.pairs % (self.task.scenes.len() - 1).max(1);
        self.pairs += 1;
        if self.gpu.probe.timestamp_bits == 0 {
            return Ok(FramePair {
                best: self.time(best, scene)?,
                candidate: self.time(candidate, scene)?,
            });
        }
        // Neither waits for the other, so that the device's clocks have no time to change; each
        // comes first in every second pair.
        let mut pair = [best, candidate];
        if number % 2 == 1 {
            pair.reverse();
        }
        for renderer in &mut pair {
            self.draw(renderer, scene)?;
        }
        let mut ms = [0.0; 2];
        for (renderer, ms) in pair.iter_mut().zip(&mut ms) {
            renderer.finish()?;
            *ms = renderer.report().gpu_ms();
        }
        if number % 2 == 1 {
            ms.reverse();
        }
        let [best, candidate] = ms;
        Ok(FramePair { best, candidate })
    }

    fn is_cpu(&self) -> bool {
        self.gpu.probe.is_cpu()
    }
}

/// Times every candidate that nobody tried yet, by a clip of an avatar. `record`: of the device.
/// Call [`Record::withdraw`] if the program is ended meanwhile.
///
/// # Errors
/// Those of [`TuningTask::run`].
pub fn measure(
    gpu: &Arc<Gpu>,
    record: &Record,
    avatar: &Avatar,
    player: &Player,
    options: RendererOptions,
    progress: Progress,
) -> Result<Tuning> {
    let task = TuningTask {
        avatar,
        options,
        scenes: &TrialScene::of_clip(avatar, player, options.size),
        budget_ms: f64::INFINITY,
    };
    task.run(gpu, record, progress)
}

/// Options with everything that was left open set as [`measure`] finds it fastest.
///
/// # Errors
/// Those of [`TuningTask::run`].
pub fn tune(
    gpu: &Arc<Gpu>,
    record: &Record,
    avatar: &Avatar,
    player: &Player,
    options: RendererOptions,
    progress: Progress,
) -> Result<RendererOptions> {
    if !Workload::is_open(&options) {
        return Ok(resolved(gpu, options));
    }
    let tuning = measure(gpu, record, avatar, player, options, progress)?;
    Ok(resolved(gpu, tuning.best.apply(options)))
}

/// Times candidates for the next start while a window is drawn to: on a device of its own, so that
/// a driver that hangs or is lost in a trial takes nothing from the window. `device`: how the
/// window's was opened; `record`: of that device. Meant for a thread of its own.
///
/// # Errors
/// Those of [`TuningTask::run`], and when the device can't be opened or is another than the
/// record's.
pub fn tune_aside(device: &GpuOptions, record: &Record, task: &TuningTask) -> Result<Tuning> {
    let gpu = Gpu::new(&GpuOptions {
        surface_extensions: Vec::new(),
        ..device.clone()
    })?;
    if !record.is_of(&gpu) {
        return Err(Error::NoSuchDevice {
            wanted: device.device.clone().unwrap_or_default(),
            found: format!("another one, or another driver: `{}`", gpu.probe.name),
        });
    }
    task.run(&gpu, record, &mut |candidate| {
        tracing::debug!("trying {candidate}");
    })
}
