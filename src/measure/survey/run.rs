//! Measures a device without a window: rates, sorts and frames.

use super::{STEPS, SurveyReport, unname};
use crate::{
    bench::{BenchCase, BenchDevice, BenchReport, BenchTask, measure_case},
    rates::{RatesReport, RatesSettings, measure_rates},
    setting::RenderSetting,
    steps::StepOutcome,
};
use effigy_core::{
    avatar::{Avatar, motion::Player},
    frame::{RasterMethod, RendererOptions},
};
use effigy_render::vulkan::{
    Error, Gpu, Probe,
    raster::choice::MethodChoice,
    sort,
    trial::{TrialOutcome, Tried},
};
use std::{
    slice,
    sync::Arc,
    time::{Duration, Instant},
};

/// Least time of a measurement of a rate.
const LEAST: Duration = Duration::from_millis(20);
/// Largest copy, bytes: a phone has little memory to spare.
const LARGEST_COPY: u64 = 64 << 20;
/// Frames to time of each case, and the fewest.
const FRAMES: f64 = 24.0;
const FEWEST_FRAMES: usize = 4;
/// The cases: all of a frame's work, and what is left while a pose stays.
const CASES: [BenchCase; 2] = [BenchCase::Full, BenchCase::Camera];

/// Hears of the report so far and of what is measured next. Returns whether to go on.
type Tell<'a> = &'a mut dyn FnMut(&SurveyReport, &str) -> bool;

/// What a survey draws.
pub struct SurveyTask<'a> {
    /// The avatar.
    pub avatar: &'a Avatar,
    /// The clip that moves it.
    pub player: &'a Player,
    /// Width and height of the images, px.
    pub size: [u32; 2],
    /// How long measurements take, of those of a whole survey: 1 or less.
    pub share: f64,
}

/// Measures every step but the soak. Where `tell` returns false it stops, at most a case of frames
/// later, and what it has told by then is all there is.
pub fn measure(gpu: &Arc<Gpu>, task: &SurveyTask, report: &mut SurveyReport, tell: Tell) {
    let mut run = Run {
        gpu,
        task,
        report,
        tell,
    };
    let steps = [Run::rates, Run::sorts, Run::frames];
    for ((name, limit), work) in STEPS.into_iter().zip(steps) {
        let began = Instant::now();
        let until = began + Duration::from_secs_f64(limit);
        let worked = run.tell(name, until).and_then(|()| work(&mut run, until));
        let (outcome, note) = match worked {
            Ok(()) => (StepOutcome::Passed, String::new()),
            Err(Halt::Failed(why)) => (StepOutcome::Failed, why),
            Err(Halt::TimedOut) => (StepOutcome::TimedOut, "the rest was left out".into()),
            Err(Halt::Unheard) => return,
        };
        let seconds = began.elapsed().as_secs_f64();
        run.report.end_step(name, outcome, seconds, note);
    }
    (run.tell)(run.report, "all but the soak is measured");
}

/// Why a step ends early.
enum Halt {
    /// Nobody hears what it finds.
    Unheard,
    TimedOut,
    Failed(String),
}

impl From<Error> for Halt {
    fn from(error: Error) -> Self {
        Self::Failed(match error {
            // The rest names a folder.
            Error::NoSort { reasons, .. } => reasons,
            other => other.to_string(),
        })
    }
}

struct Run<'a> {
    gpu: &'a Arc<Gpu>,
    task: &'a SurveyTask<'a>,
    report: &'a mut SurveyReport,
    tell: Tell<'a>,
}

impl Run<'_> {
    /// Tells what is measured next, if there is time for it.
    fn tell(&mut self, what: &str, until: Instant) -> Result<(), Halt> {
        if !(self.tell)(self.report, what) {
            Err(Halt::Unheard)
        } else if Instant::now() > until {
            Err(Halt::TimedOut)
        } else {
            Ok(())
        }
    }

    fn rates(&mut self, until: Instant) -> Result<(), Halt> {
        let settings = RatesSettings {
            size: self.task.size,
            least: LEAST.mul_f64(self.task.share),
            largest: LARGEST_COPY,
        };
        let gpu = self.gpu;
        let mut told = Ok(());
        let mut keep = |rates: &RatesReport| {
            let done = rates.copies.len() + rates.fills.len();
            let program = self.report.program.clone();
            self.report.rates = Some(RatesReport {
                program,
                ..rates.clone()
            });
            told = self.tell(&format!("rates: {done} measured"), until);
            told.is_ok()
        };
        let rates = measure_rates(gpu, &settings, Vec::new(), &mut |_, _, _| (), &mut keep)?;
        told?;
        if rates.copies.iter().any(|copy| !copy.right) {
            return Err(Halt::Failed("a copy is not its original".into()));
        }
        Ok(())
    }

    fn sorts(&mut self, _: Instant) -> Result<(), Halt> {
        self.report.sorts = sort::choice::choose(self.gpu)?.tried;
        Ok(())
    }

    fn frames(&mut self, until: Instant) -> Result<(), Halt> {
        let known = MethodChoice::of(self.gpu).tried;
        let mut failed = Vec::new();
        for method in methods(&self.gpu.probe) {
            let refusal = match Tried::outcome_of(&known, method) {
                None | Some(TrialOutcome::Right(_)) => self.frames_of(method, until)?,
                Some(outcome) => Some(outcome.to_string()),
            };
            failed.extend(refusal.map(|why| format!("{}: {why}", method.name())));
        }
        if failed.is_empty() {
            Ok(())
        } else {
            Err(Halt::Failed(failed.join("; ")))
        }
    }

    /// The frames of one way to draw. Returns why the device refuses it, if it does.
    fn frames_of(&mut self, method: RasterMethod, until: Instant) -> Result<Option<String>, Halt> {
        let device = BenchDevice::Vulkan(self.gpu.clone());
        let options = RendererOptions {
            method: Some(method),
            ..RendererOptions::new(self.task.size)
        };
        let setting = RenderSetting::new(device.resolve(options));
        let task = BenchTask {
            avatar: self.task.avatar,
            clips: slice::from_ref(self.task.player),
            cameras: &[],
            frames: Some(((FRAMES * self.task.share) as usize).max(FEWEST_FRAMES)),
            views: 4,
            checked: 1,
            flip: false,
            spread: 0,
        };
        let mut bench = BenchReport::new(device.describe(), &task, &setting, Vec::new());
        bench.program = self.report.program.clone();
        unname(&mut bench.avatar);
        let at = self.report.frames.len();
        self.report.frames.push(bench);
        for case in CASES {
            self.tell(&format!("frames: {}, {case}", method.name()), until)?;
            match measure_case(&device, &task, &setting, case, None, &mut |_, _, _| ()) {
                Ok(measured) => self.report.frames[at].cases.push(measured),
                Err(error) if error.is_refusal() => return Ok(Some(error.to_string())),
                Err(error) => return Err(Halt::Failed(error.to_string())),
            }
        }
        Ok(None)
    }
}

/// The ways to draw that a device can and might: each class has tiles of its own.
fn methods(probe: &Probe) -> impl Iterator<Item = RasterMethod> {
    let foreign = if probe.is_cpu() {
        RasterMethod::SharedTiles
    } else {
        RasterMethod::CooperativeTiles
    };
    let can = move |method: &RasterMethod| *method != foreign && probe.lacks_for(*method).is_none();
    RasterMethod::ALL.into_iter().filter(can)
}
