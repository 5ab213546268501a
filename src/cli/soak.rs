//! `effigy soak`: draws for minutes at a promised rate, without a window.

use crate::{
    advice::Advised,
    compare, files,
    interrupt::Interrupts,
    options::{self, QualityArgs},
    output::{self, Output},
    source::Source,
};
use anyhow::{Context, anyhow};
use clap::ValueEnum;
use effigy_measure::{
    report::ErrorReport,
    setting::RenderSetting,
    soak::{
        self, Session, SoakReport, SoakSettings, SoakTask,
        faults::{SoakLimits, held_rate},
    },
};
use effigy_render::vulkan::{Gpu, raster, sort};
use effigy_runtime::{
    thermals::{Phone, Recorded, Simulated, Thermals},
    trace::TraceRecorder,
};
use std::{
    path::{Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

const RATE_ADVICE: &str =
    "promise fewer frames with --fps, draw fewer pixels with --size, or leave the governor on";

#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(flatten)]
    source: Source,
    /// How long to draw, minutes, 0.01 to 10000
    #[arg(long, value_name = "MINUTES", default_value_t = 20.0, value_parser = options::minutes)]
    minutes: f64,
    /// Rate to hold, frames per second, 0.5 to 1000 [default: the highest common rate that a short
    /// test holds with time to spare]
    #[arg(long, value_name = "N", value_parser = options::rate)]
    fps: Option<f64>,
    /// Width and height of the image, pixels
    #[arg(long, value_name = "WxH", value_parser = options::size, default_value = "1024x1024")]
    size: [u32; 2],
    /// Keep the full quality, even if the rate is not held
    #[arg(long)]
    no_governor: bool,
    /// The old spelling of `--no-governor`
    #[arg(long, value_enum, hide = true, conflicts_with = "no_governor")]
    governor: Option<Switch>,
    /// Slow this device down like a phone that gets hot and throttles halfway through
    #[arg(long)]
    simulate_heat: bool,
    /// Replay the thermal headroom of another soak, from its .csv
    #[arg(long, value_name = "FILE", conflicts_with = "simulate_heat")]
    replay_heat: Option<PathBuf>,
    /// Fail if more than this share of the refreshes shows nothing new, per cent, 0 or more
    #[arg(long, value_name = "PERCENT", default_value_t = 1.0, value_parser = amount)]
    late: f64,
    /// Fail if memory grows by more than this, MiB, 0 or more
    #[arg(long, value_name = "MIB", default_value_t = 1.0, value_parser = amount)]
    growth: f64,
    /// Skip the comparison with the f64 reference at the end, which takes seconds
    #[arg(long)]
    no_check: bool,
    /// Also write a timeline of host and device, a .json for ui.perfetto.dev
    ///
    /// A long soak's timeline has its last frames only.
    #[arg(long, value_name = "FILE", value_parser = output::TRACE.parser())]
    trace: Option<Output>,
    /// Start of the names of the files to write; .json, .csv, .svg and .png are appended
    #[arg(short, long, value_name = "NAME", default_value = "effigy-soak")]
    out: PathBuf,
    /// The old spelling of `effigy compare A B`
    #[arg(long, value_names = ["A", "B"], num_args = 2, hide = true)]
    compare: Option<Vec<PathBuf>>,
    #[command(flatten, next_help_heading = "Quality")]
    quality: QualityArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Switch {
    On,
    Off,
}

fn amount(text: &str) -> Result<f64, String> {
    options::number(text, 0.0, 1e6, "amount")
}

impl Args {
    fn is_governed(&self) -> bool {
        !self.no_governor && self.governor != Some(Switch::Off)
    }
}

pub fn run(args: Args) -> anyhow::Result<()> {
    if let Some([a, b]) = args.compare.as_deref() {
        return compare::soaks(a, b);
    }
    check_files(&args.out)?;
    let stop = Interrupts::listen()?;
    let running = Arc::new(AtomicBool::new(false));
    // Nothing is measured yet.
    stop.leave_unless(&running, 130, || "stopped before the soak".into());
    let (mut avatar, player) = args.source.load_player()?;
    args.quality.filter.apply(&mut avatar);
    let gpu = Gpu::new(&args.quality.gpu())?;
    let options = args.quality.renderer(args.size);
    // A soak is of the fastest sort: it is worth the wait.
    sort::choice::choose(&gpu)?;
    let setting = RenderSetting::new(raster::resolved(&gpu, options));
    let rate = match args.fps {
        Some(rate) => rate,
        None => soak::run::recommended_rate(&gpu, &avatar, &player, &setting)?,
    };
    let mut thermals = thermals(&args, rate)?;
    let task = SoakTask {
        avatar: &avatar,
        player: &player,
        setting,
        settings: SoakSettings {
            rate,
            governed: args.is_governed(),
            seconds: 60.0 * args.minutes,
        },
        bounds: SoakLimits {
            dropped: args.late / 100.0,
            growth: (args.growth * f64::from(1 << 20)) as u64,
        },
        check: !args.no_check,
        command: std::env::args().collect(),
    };
    let [width, height] = args.size;
    println!(
        "soaking {} at {rate} frames per second, {width} × {height}, for {} min with {}",
        avatar.name, args.minutes, gpu.probe.name
    );
    let mut status = Status::default();
    let mut tick = |session: &Session| status.print(session);
    let mut trace = args.trace.as_ref().map(|_| TraceRecorder::new(&gpu));
    running.store(true, Ordering::Relaxed);
    let report = soak::run(
        &gpu,
        &task,
        &mut thermals,
        trace.as_mut(),
        stop.flag(),
        &mut tick,
    )?;
    if let (Some(path), Some(trace)) = (&args.trace, &trace) {
        options::write_trace(path, trace, &gpu)?;
    }
    for path in soak::files::write_report(&report, &args.out)? {
        println!("wrote {}", path.display());
    }
    conclude(&report, &task.bounds)
}

/// Checks the files of a soak before the work. `out`: begins their names.
pub fn check_files(out: &Path) -> anyhow::Result<()> {
    let file = |ending| Output::new(soak::files::path(out, ending), ending);
    let files: Vec<Output> = soak::files::ENDINGS.iter().copied().map(file).collect();
    output::check(&files)
}

/// Where thermal readings come from, at a rate in frames per second.
fn thermals(args: &Args, rate: f64) -> anyhow::Result<Thermals> {
    /// Seconds that the real phone takes for what a simulated run shows: ten minutes cool, ten hot.
    const CURVE: f64 = 1200.0;
    if args.simulate_heat {
        let speed = (CURVE / (60.0 * args.minutes)).max(1.0);
        let phone = Simulated::new(Phone::default(), speed, rate);
        return Ok(Thermals::Simulated(phone));
    }
    let Some(path) = &args.replay_heat else {
        return Ok(Thermals::System(Box::default()));
    };
    let recorded = Recorded::read(&files::read_text(path)?).map_err(anyhow::Error::msg);
    Ok(Thermals::Recorded(recorded.with_context(|| {
        format!("{} can't be replayed", path.display())
    })?))
}

/// Prints a line every ten seconds, and where the governor steps.
#[derive(Default)]
struct Status {
    /// When the last line was printed, seconds since the start.
    printed: f64,
    /// The governor's step in that line.
    step: usize,
}

impl Status {
    fn print(&mut self, session: &Session) {
        let Some(second) = session.seconds().last() else {
            return;
        };
        let (ladder, step) = session.ladder();
        if step == self.step && second.seconds - self.printed < 9.99 {
            return;
        }
        self.printed = second.seconds;
        self.step = step;
        let heat = second.headroom.map_or(String::new(), |headroom| {
            format!(", headroom used {headroom:.2}")
        });
        let memory = second.device_bytes as f64 / 1e6;
        println!(
            "{:5.0} s  {:6.1} fps, p50 {:.1} p95 {:.1} p99 {:.1} ms, {} late, {} dropped, step {step} ({}){heat}, {memory:.0} MB",
            second.seconds,
            second.fps,
            second.frame_ms_p50,
            second.frame_ms_p95,
            second.frame_ms_p99,
            session.totals().late,
            session.totals().dropped,
            ladder[step].name,
        );
    }
}

/// Prints the result. An error if the soak has failed.
fn conclude(report: &SoakReport, limits: &SoakLimits) -> anyhow::Result<()> {
    if report.lasted_seconds < report.planned_seconds {
        println!(
            "interrupted after {:.0} s of {:.0} s",
            report.lasted_seconds, report.planned_seconds
        );
    }
    println!(
        "{:.1} frames per second of {} promised, {:.2} % of the refreshes without a new one, {} steps of the governor",
        report.fps,
        report.rate,
        100.0 * report.dropped_share,
        report.changes
    );
    if let Some(growth) = &report.growth {
        let resident = growth.resident_bytes.map_or("unknown".into(), |bytes| {
            format!("{:+.2} MiB", bytes as f64 / f64::from(1 << 20))
        });
        println!(
            "memory growth in {:.0} s from second {:.0} on, without the first minute of each new step: process {resident}, device {:+} bytes",
            growth.judged_seconds, growth.from_seconds, growth.device_bytes
        );
    }
    if let Some(drift) = &report.drift {
        let decibels = |error: &ErrorReport| {
            error
                .psnr_db
                .map_or("no error".into(), |db| format!("{db:.2} dB"))
        };
        let same = if drift.same {
            "identical images"
        } else {
            "images differ"
        };
        println!(
            "against the reference: {} before, {} after, {same}",
            decibels(&drift.before),
            decibels(&drift.after)
        );
    }
    if report.faults.is_empty() {
        return Ok(());
    }
    let faults = report.faults.join("; ");
    if held_rate(report, limits) {
        Err(anyhow!(faults))
    } else {
        Err(Advised::new(faults, RATE_ADVICE).into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[test]
    fn amounts_out_of_range_are_refused_with_the_range() {
        assert_eq!(options::minutes("0.5"), Ok(0.5));
        assert_eq!(options::rate("120"), Ok(120.0));
        for refused in [
            options::minutes("0"),
            options::minutes("NaN"),
            options::rate("0"),
            options::rate("fast"),
            amount("-1"),
        ] {
            assert!(refused.is_err_and(|error| error.contains("write a number from")));
        }
    }

    #[derive(clap::Parser)]
    struct SoakCommand {
        #[command(flatten)]
        args: Args,
    }

    #[test]
    fn the_governor_is_on_unless_either_spelling_turns_it_off() {
        let is_governed = |arguments: &[&str]| {
            let words = ["soak"].iter().chain(arguments);
            SoakCommand::parse_from(words).args.is_governed()
        };
        assert!(is_governed(&[]) && is_governed(&["--governor", "on"]));
        assert!(!is_governed(&["--no-governor"]) && !is_governed(&["--governor", "off"]));
    }
}
