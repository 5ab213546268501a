//! `effigy bench`: time, error, memory, counters and bytes of an avatar, case by case, and what each knob trades.

mod output;
mod print;

use super::{
    options::{self, Quality},
    render::progress,
    source::{self, Source},
    through::Through,
};
use crate::{
    avatar::{import::cameras, motion::Player},
    measure::{
        bench::{
            Case, Devices, Knob, Setting, Task, measured,
            scene::RATE,
            sweep::{Sweep, sweep},
        },
        trace::Trace,
    },
};
use anyhow::{Context, ensure};
use output::{Json, Pareto};
use std::path::PathBuf;

#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// Width and height, px [default: 2048x2048, or the first camera's of --cameras]
    #[arg(long, value_parser = options::size)]
    size: Option<[u32; 2]>,
    /// What to draw: all, or some of full, camera, orbit, expression, static, close, far and four [default: full]
    #[arg(long, value_name = "NAME,NAME", value_parser = cases)]
    case: Vec<Cases>,
    /// Turn knobs one at a time and measure what each value gains and loses: all, or some of preset, storage, keys, color, raster,
    /// cutoff, rows, margin, detail, pose-rate, skip and skip-but
    #[arg(long, value_name = "NAME,NAME", value_parser = knobs)]
    sweep: Option<Knobs>,
    /// Turns that each value of a sweep has
    #[arg(long, value_name = "N", default_value_t = 3)]
    rounds: usize,
    /// Draw a sweep's times against its errors, to an .svg or a .png; sweeps all knobs unless --sweep says which
    #[arg(long, value_name = "FILE", value_parser = output::pareto)]
    pareto: Vec<Pareto>,
    /// Frames to time, spread over the clip [default: 48, in each round of a sweep 24]
    #[arg(long)]
    frames: Option<usize>,
    /// Frames to draw before the clock starts
    #[arg(long, default_value_t = 3)]
    warm_up: usize,
    /// Views around the avatar, used in turn
    #[arg(long, default_value_t = 4)]
    views: usize,
    /// Use these cameras in turn, a cameras.json as 3DGS writes it, from top to bottom as it says; the cases close, far and four keep
    /// their own
    #[arg(long, value_name = "FILE", conflicts_with = "views")]
    cameras: Option<PathBuf>,
    /// Frames to compare with the f64 reference, each of which takes seconds
    #[arg(long, default_value_t = 4)]
    check: usize,
    /// Say how visible the error is too (FLIP), which takes seconds more a picture
    #[arg(long)]
    flip: bool,
    /// Take a new pose only so many times a second, of 60: 30, 20, 15, 12, 10, 6 or 5
    #[arg(long, value_name = "HZ", value_parser = hold)]
    pose_rate: Option<usize>,
    /// Share of the basis rows to keep, 0 to 1
    #[arg(long, value_name = "SHARE", default_value_t = 1.0)]
    rows: f64,
    /// Read f16 as 32-bit words even where the device has 16-bit storage
    #[arg(long)]
    words: bool,
    /// Write the result as JSON too; without a file, to the standard output and nothing else
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-", value_parser = output::json)]
    json: Option<Json>,
    /// Write the result as a table of comma-separated values too
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Write a timeline of host and device too, for Perfetto: a .json
    #[arg(long, value_name = "FILE", value_parser = options::trace)]
    trace: Option<PathBuf>,
    /// What to draw through
    #[arg(long, value_enum, default_value_t = Through::Vulkan)]
    backend: Through,
    #[command(flatten)]
    quality: Quality,
}

/// What `--case` once names.
#[derive(Clone)]
struct Cases(Vec<Case>);

/// What `--sweep` names.
#[derive(Clone)]
struct Knobs(Vec<Knob>);

/// Reads `all` or some names.
fn cases(text: &str) -> Result<Cases, String> {
    if text == "all" {
        return Ok(Cases(Case::ALL.into()));
    }
    text.split(',').map(|name| name.trim().parse()).collect::<Result<_, _>>().map(Cases)
}

/// Reads `all` or some names; `all` is without the knob that looks into another.
fn knobs(text: &str) -> Result<Knobs, String> {
    if text == "all" {
        return Ok(all_knobs());
    }
    text.split(',').map(|name| name.trim().parse()).collect::<Result<_, _>>().map(Knobs)
}

fn all_knobs() -> Knobs {
    Knobs(Knob::ALL.into_iter().filter(|&knob| knob != Knob::SkipBut).collect())
}

/// Reads a pose rate as the frames that a pose is held.
fn hold(text: &str) -> Result<usize, String> {
    let hold = text.parse().ok().filter(|hz: &f64| *hz > 0.0).map(|hz| RATE / hz).filter(|hold| hold.fract() == 0.0 && *hold >= 1.0);
    hold.map(|hold| hold as usize).ok_or_else(|| format!("`{text}` is no pose rate: write a whole fraction of {RATE}, for instance 30"))
}

/// What is to be done, free of how it was written.
struct Job {
    cases: Vec<Case>,
    knobs: Vec<Knob>,
    sweep_case: Case,
    setting: Setting,
}

impl Args {
    fn job(&self, size: [u32; 2]) -> anyhow::Result<Job> {
        ensure!(self.frames != Some(0) && self.views > 0, "nothing to measure: give --frames and --views of at least 1");
        ensure!(self.rounds > 0, "nothing to measure: give --rounds of at least 1");
        ensure!((0.0..=1.0).contains(&self.rows), "--rows {} is no share: give 0 to 1", self.rows);
        let knobs = self.sweep.clone().or((!self.pareto.is_empty()).then(all_knobs)).map_or(Vec::new(), |knobs| knobs.0);
        let mut cases: Vec<Case> = self.case.iter().flat_map(|cases| cases.0.iter().copied()).collect();
        let sweep_case = cases.first().copied().unwrap_or(Case::Orbit);
        if cases.is_empty() && knobs.is_empty() {
            cases.push(Case::Full);
        }
        let held = self.pose_rate.is_some_and(|hold| hold > 1) || knobs.contains(&Knob::PoseRate);
        if let Some(case) = cases.iter().chain(Some(&sweep_case).filter(|_| !knobs.is_empty())).find(|case| held && !case.in_real_time()) {
            anyhow::bail!("the frames of the case `{case}` do not follow each other in time, so it has no pose rate: use `orbit`");
        }
        ensure!(self.trace.is_none() || !cases.is_empty(), "a trace is of cases, and a sweep alone has none: name some with --case");
        ensure!(knobs.is_empty() || self.check > 0, "a sweep sets time against error: give --check of at least 1");
        let hold = self.pose_rate.unwrap_or(1);
        let setting = Setting { options: self.quality.renderer(size), packed_words: self.words, rows: self.rows, hold };
        Ok(Job { cases, knobs, sweep_case, setting })
    }
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let (avatar, clips) = args.source.load()?;
    let player = Player::new(clips.into_iter().next().context("there is no clip")?, &avatar.skeleton);
    let cameras = args.cameras.as_ref().map_or(Ok(vec![]), |path| source::cameras(path, &avatar))?;
    let size = args.size.or(cameras.first().map(|camera| camera.size)).unwrap_or([2048, 2048]);
    let cameras: Vec<_> = cameras.iter().map(|camera| cameras::scaled(camera, size)).collect();
    let mut job = args.job(size)?;
    let (frames, views) = (args.frames.unwrap_or(48), args.views);
    let (checked, flip, warm_up) = (args.check, args.flip, args.warm_up);
    let task = Task { avatar: &avatar, player: &player, cameras: &cameras, frames, views, checked, flip, warm_up };
    let mut devices = Devices::new(args.backend.try_into()?, args.quality.gpu());
    let gpu = devices.get(&job.setting)?;
    job.setting.options = gpu.settled(job.setting.options);
    let mut report = task.report(&gpu, &job.setting, std::env::args().collect());
    let bar = progress(0, "frames");
    let mut show = |what: &str, done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
        bar.set_message(what.to_owned());
    };
    let quiet = args.json.as_ref().is_some_and(Json::is_stdout);
    if !quiet {
        print::heading(&report);
    }
    let traced = args.trace.as_ref().map(|_| gpu.vulkan().context("only Vulkan tells when stages ran: leave out --trace or --backend"));
    let traced = traced.transpose()?;
    let mut trace = traced.map(|gpu| Trace::new(gpu));
    for &case in &job.cases {
        let measured = measured::case(&gpu, &task, (&job.setting, case), trace.as_mut(), &mut show)?;
        if !quiet {
            bar.suspend(|| print::case(case, &measured));
        }
        report.cases.push(measured);
    }
    if !job.knobs.is_empty() {
        let what = Sweep { case: job.sweep_case, knobs: &job.knobs, rounds: args.rounds, base: job.setting };
        report.sweep = Some(sweep(&mut devices, &Task { frames: args.frames.unwrap_or(24), ..task }, &what, &mut show)?);
    }
    bar.finish_and_clear();
    args.trace.iter().zip(&trace).zip(traced).try_for_each(|((path, trace), gpu)| options::write_trace(path, trace, gpu))?;
    if let Some(sweep) = report.sweep.as_ref().filter(|_| !quiet) {
        print::sweep(sweep);
    }
    output::write(&report, args.json.as_ref(), args.csv.as_deref(), &args.pareto)
}
