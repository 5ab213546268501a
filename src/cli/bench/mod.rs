//! `effigy bench`: time, error, memory, counters and bytes of an avatar, case by case, and what
//! each parameter trades.

mod files;
mod report;

use crate::{
    backend::BackendArg,
    interrupt::Interrupts,
    options::{self, QualityArgs},
    output::{CHART, CSV, JSON, Output, PNG, TRACE},
    picture, progress,
    source::{self, Source},
};
use anyhow::{Context, ensure};
use effigy_core::{io::cameras, scene::Camera};
use effigy_measure::bench::{
    BenchCase, BenchTask, Parameter, RenderSetting, measured, open,
    report::{BenchReport, SweepReport},
    scene::{RATE, default_frames},
    spread::{self, SpreadInputs},
    strip,
    sweep::{Sweep, run_sweep},
};
use effigy_runtime::trace::Trace;
use image::buffer::ConvertBuffer;
use std::{path::PathBuf, str::FromStr};

#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// Width and height of the image, pixels [default: 2048x2048, or the first camera's of
    /// --cameras]
    #[arg(long, value_name = "WxH", value_parser = options::size)]
    size: Option<[u32; 2]>,
    /// Scenes to draw: all, or names out of full, camera, orbit, expression, static, close, far30,
    /// far, far120, far240, far480, four, crowd, flicker and zoom, separated by commas
    /// [default: full]
    #[arg(long, value_name = "NAME,NAME", value_parser = cases)]
    case: Vec<Cases>,
    /// Vary one parameter at a time, and measure the time and error of each value: all, or names
    /// out of exact, raster, cutoff, rows, detail, supersample, pose-rate, skip and skip-but,
    /// separated by commas
    #[arg(long, value_name = "NAME,NAME", value_parser = parameters)]
    sweep: Option<Parameters>,
    /// Times that each value of a sweep is measured, in turn with the others, 1 or more
    #[arg(long, value_name = "N", default_value_t = 3)]
    rounds: usize,
    /// Plot a sweep's times against its errors, to an .svg or a .png; sweeps all parameters unless
    /// --sweep names some
    #[arg(long, value_name = "FILE", value_parser = CHART.parser())]
    pareto: Vec<Output>,
    /// Frames to time, spread over the clip, 1 or more [default: 48; 24 in each round of a sweep
    /// and for flicker; 200 for zoom]
    #[arg(long, value_name = "N")]
    frames: Option<usize>,
    /// Frames to draw first, so that what follows is typical
    #[arg(long, value_name = "N", default_value_t = 3)]
    warm_up: usize,
    /// Views around the avatar, 1 or more
    #[arg(long, value_name = "N", default_value_t = 4)]
    views: usize,
    /// Draw from each camera of this file, as `render` reads it
    ///
    /// The cases close, far, four, crowd and zoom keep their own cameras.
    #[arg(long, value_name = "FILE", conflicts_with = "views")]
    cameras: Option<PathBuf>,
    /// Frames to compare with the f64 reference, which takes seconds each; flicker and zoom choose
    /// which, unless it is 0
    #[arg(long, value_name = "N", default_value_t = 4)]
    check: usize,
    /// Poses of each clip to compare with nothing skipped, from --views sides and at three
    /// distances; 0: none
    #[arg(long, value_name = "N", default_value_t = 8)]
    spread: usize,
    /// Also compute how visible the error is (FLIP), which takes more seconds per compared frame
    #[arg(long)]
    flip: bool,
    /// New poses per second: 30, 20, 15, 12, 10, 6 or 5 [default: 60, one per frame]
    #[arg(long, value_name = "HZ", value_parser = frames_per_pose)]
    pose_rate: Option<usize>,
    /// Share of the avatar's basis rows to use, 0 to 1
    #[arg(long, alias = "rows", value_name = "SHARE", default_value_t = 1.0, value_parser = options::share)]
    row_share: f64,
    /// Also write the result as JSON; without FILE, print JSON and nothing else
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-", value_parser = JSON.parser())]
    json: Option<Output>,
    /// Also write the result as comma-separated values
    #[arg(long, value_name = "FILE", value_parser = CSV.parser())]
    csv: Option<Output>,
    /// Also write a timeline of host and device, a .json for ui.perfetto.dev
    #[arg(long, value_name = "FILE", value_parser = TRACE.parser())]
    trace: Option<Output>,
    /// Also draw the avatar of each case that has a height as large as it is shown, as these options
    /// draw it, and as it should look, enlarged one above the other, into a .png
    #[arg(long, value_name = "FILE", value_parser = PNG.parser())]
    strip: Option<Output>,
    /// Graphics API to draw with
    #[arg(long, value_enum, default_value_t = BackendArg::Vulkan)]
    backend: BackendArg,
    #[command(flatten, next_help_heading = "Quality")]
    quality: QualityArgs,
}

/// The scenes that one `--case` names.
#[derive(Clone, Debug)]
struct Cases(Vec<BenchCase>);

/// The parameters that `--sweep` names.
#[derive(Clone, Debug)]
struct Parameters(Vec<Parameter>);

impl Parameters {
    /// All but the one that looks into another.
    fn all() -> Self {
        let all = Parameter::ALL
            .into_iter()
            .filter(|&parameter| parameter != Parameter::SkipBut);
        Self(all.collect())
    }
}

fn cases(text: &str) -> Result<Cases, String> {
    if text == "all" {
        return Ok(Cases(BenchCase::ALL.into()));
    }
    names(text).map(Cases)
}

fn parameters(text: &str) -> Result<Parameters, String> {
    if text == "all" {
        return Ok(Parameters::all());
    }
    names(text).map(Parameters)
}

/// Reads names separated by commas.
fn names<T: FromStr>(text: &str) -> Result<Vec<T>, T::Err> {
    text.split(',').map(|name| name.trim().parse()).collect()
}

/// Reads a pose rate, as the number of frames that a pose lasts.
fn frames_per_pose(text: &str) -> Result<usize, String> {
    let error = || {
        format!("`{text}` is not a pose rate: write a whole fraction of {RATE}, for instance 30")
    };
    let hz: f64 = text.parse().map_err(|_| error())?;
    let frames = RATE / hz;
    if hz > 0.0 && frames.fract() == 0.0 && frames >= 1.0 {
        Ok(frames as usize)
    } else {
        Err(error())
    }
}

/// The arguments in the benchmark's own terms.
struct Job {
    cases: Vec<BenchCase>,
    /// The parameters of a sweep; empty without one.
    parameters: Vec<Parameter>,
    sweep_case: BenchCase,
    setting: RenderSetting,
}

impl Args {
    /// Checks the arguments. `size`: of the image, pixels.
    fn job(&self, size: [u32; 2]) -> anyhow::Result<Job> {
        ensure!(
            self.frames != Some(0) && self.views > 0,
            "nothing to measure: give --frames and --views of at least 1"
        );
        ensure!(
            self.rounds > 0,
            "nothing to measure: give --rounds of at least 1"
        );
        let parameters = match &self.sweep {
            Some(parameters) => parameters.0.clone(),
            None if !self.pareto.is_empty() => Parameters::all().0,
            None => Vec::new(),
        };
        let mut cases: Vec<BenchCase> = self
            .case
            .iter()
            .flat_map(|cases| cases.0.iter().copied())
            .collect();
        let sweep_case = cases.first().copied().unwrap_or(BenchCase::Orbit);
        if cases.is_empty() && parameters.is_empty() {
            cases.push(BenchCase::Full);
        }
        let hold = self.pose_rate.unwrap_or(1);
        if hold > 1 || parameters.contains(&Parameter::PoseRate) {
            let swept = (!parameters.is_empty()).then_some(&sweep_case);
            let jumping = cases.iter().chain(swept).find(|case| !case.in_real_time());
            if let Some(case) = jumping {
                anyhow::bail!(
                    "the frames of the case `{case}` do not follow each other in time, so it has no pose rate: use `orbit`"
                );
            }
        }
        ensure!(
            self.trace.is_none() || !cases.is_empty(),
            "--trace needs a case, and a sweep alone has none: name one with --case"
        );
        ensure!(
            parameters.is_empty() || self.check > 0,
            "a sweep needs errors to compare with times: give --check of at least 1"
        );
        let setting = RenderSetting {
            options: self.quality.renderer(size),
            rows: self.row_share,
            hold,
        };
        Ok(Job {
            cases,
            parameters,
            sweep_case,
            setting,
        })
    }
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let (mut avatar, players) = args.source.load_players()?;
    args.quality.filter.apply(&mut avatar);
    let player = players.first().context("there is no clip")?;
    let mut cameras = match &args.cameras {
        Some(path) => source::cameras(path, &avatar)?,
        None => Vec::new(),
    };
    let size = args
        .size
        .or(cameras.first().map(|camera: &Camera| camera.size))
        .unwrap_or([2048, 2048]);
    for camera in &mut cameras {
        *camera = cameras::scaled(camera, size);
    }
    let mut job = args.job(size)?;
    let task_of = |case: BenchCase, sweep: bool| BenchTask {
        avatar: &avatar,
        player,
        cameras: &cameras,
        frames: args.frames.unwrap_or(default_frames(case, sweep)),
        views: args.views,
        checked: args.check,
        flip: args.flip,
        warm_up: args.warm_up,
    };
    // The sorts may be tested.
    Interrupts::excuse_trials()?;
    let gpu = open(args.backend.try_into()?, &args.quality.gpu())?;
    let bar = progress::items(0, "frames");
    job.setting.options = gpu.resolve(job.setting.options);
    let any = task_of(job.sweep_case, false);
    let mut report = any.report(&gpu, &job.setting, std::env::args().collect());
    let mut show = |what: &str, done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
        bar.set_message(what.to_owned());
    };
    let quiet = args.json.as_ref().is_some_and(Output::is_stdout);
    if !quiet {
        report::print_heading(&report);
    }
    let traced = match &args.trace {
        Some(path) => {
            let gpu = gpu.vulkan().context(
                "only Vulkan reports when stages ran: leave out --trace or --backend webgpu",
            )?;
            Some((path, gpu))
        }
        None => None,
    };
    let mut trace = traced.map(|(_, gpu)| Trace::new(gpu));
    let keep = |report: &BenchReport| match &args.json {
        Some(out) => out.keep_json(report),
        None => Ok(()),
    };
    for &case in &job.cases {
        let task = task_of(case, false);
        let measured =
            measured::measure_case(&gpu, &task, &job.setting, case, trace.as_mut(), &mut show)?;
        if !quiet {
            bar.suspend(|| report::print_case(case, &measured));
        }
        report.cases.push(measured);
        keep(&report)?;
    }
    if args.spread > 0 && !job.cases.is_empty() {
        let inputs = SpreadInputs {
            avatar: &avatar,
            clips: &players,
            cameras: &cameras,
            poses: args.spread,
            views: args.views,
        };
        report.spread = spread::measure_spread(&gpu, &inputs, &job.setting, &mut show)?;
        if let (Some(spread), false) = (&report.spread, quiet) {
            bar.suspend(|| report::print_spread(spread));
        }
        keep(&report)?;
    }
    if !job.parameters.is_empty() {
        let task = task_of(job.sweep_case, true);
        let plan = Sweep {
            case: job.sweep_case,
            parameters: &job.parameters,
            rounds: args.rounds,
            base: job.setting,
        };
        let mut kept = Ok(());
        let mut keep = |sweep: SweepReport| {
            report.sweep = Some(sweep);
            if kept.is_ok() {
                kept = keep(&report);
            }
        };
        run_sweep(&gpu, &task, &plan, &mut show, &mut keep)?;
        kept?;
    }
    if let Some(out) = &args.strip {
        let task = task_of(job.sweep_case, false);
        let strip = strip::strip(&gpu, &task, &job.setting, &job.cases, &mut show)?;
        picture::write(&strip.convert(), out)?;
    }
    bar.finish_and_clear();
    if let (Some((path, gpu)), Some(trace)) = (traced, &trace) {
        options::write_trace(path, trace, gpu)?;
    }
    if let (Some(sweep), false) = (&report.sweep, quiet) {
        report::print_sweep(sweep);
    }
    files::write(&report, args.json.as_ref(), args.csv.as_ref(), &args.pareto)
}
