//! `effigy bench`: time, error, memory, counters and bytes of an avatar, case by case, and what
//! each parameter trades.

mod report;

use crate::{
    backend::BackendArg,
    interrupt::Interrupts,
    options::{self, QualityArgs},
    output::{CHART, CSV, JSON, Output, TRACE},
    progress,
    source::{self, Source},
};
use anyhow::{Context, ensure};
use effigy_core::{io::cameras, scene::Camera};
use effigy_measure::{
    bench::{
        BenchCase, BenchDevice, BenchReport, BenchTask, Parameter, Sweep, measure_case,
        measure_spread, run_sweep,
    },
    report::chart_title,
    setting::RenderSetting,
    table,
};
use effigy_runtime::trace::TraceRecorder;
use std::{path::PathBuf, str::FromStr};

#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// Width and height of the image, pixels [default: 2048x2048, or the first camera's of
    /// --cameras]
    #[arg(long, value_name = "WxH", value_parser = options::size)]
    size: Option<[u32; 2]>,
    /// Scenes to draw: all, or names out of full, camera, orbit, expression, static, close, four,
    /// crowd, flicker, zoom and far, which may name the avatar's height, px, such as far480;
    /// separated by commas
    /// [default: full]
    #[arg(long, value_name = "NAME,NAME", value_parser = cases)]
    case: Vec<NamedList<BenchCase>>,
    /// Vary one parameter at a time, and measure the time and error of each value: all, or names
    /// out of exact, raster, cutoff, rows, detail, supersample, pose-rate, skip and skip-but,
    /// separated by commas
    #[arg(long, value_name = "NAME,NAME", value_parser = parameters)]
    sweep: Option<NamedList<Parameter>>,
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
    /// Also write the result as JSON; without FILE, print JSON and nothing else
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-", value_parser = JSON.parser())]
    json: Option<Output>,
    /// Also write the result as comma-separated values
    #[arg(long, value_name = "FILE", value_parser = CSV.parser())]
    csv: Option<Output>,
    /// Also write a timeline of host and device, a .json for ui.perfetto.dev
    #[arg(long, value_name = "FILE", value_parser = TRACE.parser())]
    trace: Option<Output>,
    /// Graphics API to draw with
    #[arg(long, value_enum, default_value_t = BackendArg::Vulkan)]
    backend: BackendArg,
    #[command(flatten, next_help_heading = "Quality")]
    quality: QualityArgs,
}

/// What one `--case` or `--sweep` names.
#[derive(Clone, Debug)]
struct NamedList<T>(Vec<T>);

fn cases(text: &str) -> Result<NamedList<BenchCase>, String> {
    names(text, BenchCase::ALL.to_vec())
}

fn parameters(text: &str) -> Result<NamedList<Parameter>, String> {
    names(text, Parameter::all())
}

/// Reads names separated by commas, or `all`.
fn names<T: FromStr>(text: &str, all: Vec<T>) -> Result<NamedList<T>, T::Err> {
    if text == "all" {
        return Ok(NamedList(all));
    }
    let names = text.split(',').map(|name| name.trim().parse());
    names.collect::<Result<_, _>>().map(NamedList)
}

impl Args {
    /// The cases to measure, what to sweep, and the case that is swept.
    fn plan(&self) -> anyhow::Result<(Vec<BenchCase>, Vec<Parameter>, BenchCase)> {
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
            None if !self.pareto.is_empty() => Parameter::all(),
            None => Vec::new(),
        };
        let named = self.case.iter().flat_map(|cases| cases.0.iter().copied());
        let mut cases: Vec<BenchCase> = named.collect();
        let swept = cases.first().copied().unwrap_or(BenchCase::Orbit);
        if cases.is_empty() && parameters.is_empty() {
            cases.push(BenchCase::Full);
        }
        ensure!(
            swept.in_real_time() || !parameters.contains(&Parameter::PoseRate),
            "the frames of the case `{swept}` do not follow each other in time, so it has no pose rate: use `orbit`"
        );
        ensure!(
            self.trace.is_none() || !cases.is_empty(),
            "--trace needs a case, and a sweep alone has none: name one with --case"
        );
        ensure!(
            parameters.is_empty() || self.check > 0,
            "a sweep needs errors to compare with times: give --check of at least 1"
        );
        Ok((cases, parameters, swept))
    }
}

pub fn run(args: Args) -> anyhow::Result<()> {
    let (mut avatar, clips) = args.source.load_players()?;
    args.quality.filter.apply(&mut avatar);
    ensure!(!clips.is_empty(), "there is no clip");
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
    let (cases, parameters, swept) = args.plan()?;
    let task = BenchTask {
        avatar: &avatar,
        clips: &clips,
        cameras: &cameras,
        frames: args.frames,
        views: args.views,
        checked: args.check,
        flip: args.flip,
        spread: args.spread,
    };
    // The sorts may be tested.
    Interrupts::excuse_trials()?;
    let gpu = BenchDevice::open(args.backend.try_into()?, &args.quality.gpu())?;
    let setting = RenderSetting::new(gpu.resolve(args.quality.renderer(size)));
    let command = std::env::args().collect();
    let mut report = BenchReport::new(gpu.describe(), &task, &setting, command);
    let bar = progress::items(0, "frames");
    let mut show = |what: &str, done: usize, all: usize| {
        bar.set_length(all as u64);
        bar.set_position(done as u64);
        bar.set_message(what.to_owned());
    };
    let quiet = args.json.as_ref().is_some_and(Output::is_stdout);
    let say = |print: &dyn Fn()| {
        if !quiet {
            bar.suspend(print);
        }
    };
    say(&|| report::print_heading(&report));
    let traced = match &args.trace {
        Some(path) => {
            let gpu = gpu.vulkan().context(
                "only Vulkan reports when stages ran: leave out --trace or --backend webgpu",
            )?;
            Some((path, gpu))
        }
        None => None,
    };
    let mut trace = traced.map(|(_, gpu)| TraceRecorder::new(gpu));
    let keep = |report: &BenchReport| match &args.json {
        Some(out) => out.keep_json(report),
        None => Ok(()),
    };
    for &case in &cases {
        let measured = measure_case(&gpu, &task, &setting, case, trace.as_mut(), &mut show)?;
        say(&|| report::print_case(case, &measured));
        report.cases.push(measured);
        keep(&report)?;
    }
    if args.spread > 0 && !cases.is_empty() {
        report.spread = measure_spread(&gpu, &task, &setting, &mut show)?;
        if let Some(spread) = &report.spread {
            say(&|| report::print_spread(spread));
        }
        keep(&report)?;
    }
    if !parameters.is_empty() {
        let sweep = Sweep {
            case: swept,
            parameters: &parameters,
            rounds: args.rounds,
            base: setting,
        };
        let mut kept = Ok(());
        run_sweep(&gpu, &task, &sweep, &mut show, &mut |sweep| {
            report.sweep = Some(sweep);
            if kept.is_ok() {
                kept = keep(&report);
            }
        })?;
        kept?;
    }
    bar.finish_and_clear();
    if let (Some((path, gpu)), Some(trace)) = (traced, &trace) {
        options::write_trace(path, trace, gpu)?;
    }
    if let Some(sweep) = &report.sweep {
        say(&|| report::print_sweep(sweep));
        for out in &args.pareto {
            let title = chart_title(&report.avatar, report.size, &report.device);
            save(out, &sweep.chart(title)?.encoded(out.ending())?)?;
        }
    }
    if let Some(out) = &args.csv {
        save(out, &table::csv(&report.rows())?)?;
    }
    if let Some(out) = &args.json {
        save(
            out,
            (serde_json::to_string_pretty(&report)? + "\n").as_bytes(),
        )?;
    }
    Ok(())
}

/// Writes a file, and prints its name.
fn save(out: &Output, bytes: &[u8]) -> anyhow::Result<()> {
    out.write(bytes)?;
    if !out.is_stdout() {
        println!("wrote {}", out.display());
    }
    Ok(())
}
